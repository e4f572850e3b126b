// The output folder of a shot's frames, into which many runs, on many hosts, write at the same time.
//
// Beside the frames it holds, while the shot is not complete, a hidden folder (pipeline/workplace.h) with the workplaces of the
// runs and with what all frames share, such as the includes of panes that do not change. Runs of one state of the shot share
// these; a run of another state is refused while one lives. No lock is held but for moments.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/cancel.h"
#include "export/model.h"
#include "pipeline/publish.h"
#include "pipeline/workplace.h"
#include "scene/frame_range.h"

namespace shatterpave::pipeline {

class FrameFolder {
 public:
  struct Shot {
    std::string scene;       // its name
    scene::FrameSpan range;  // of the whole shot
    std::string state;       // equal for runs that may write into one folder at once
  };

  // Throws InputError where a run of another state is writing there, or where it is no folder to write to.
  FrameFolder(const std::filesystem::path& output, const Shot& shot, const Cancelled& cancelled);
  // Once the shot is complete, or if nothing came of this run, what was shared goes, unless another run lives.
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  // Where this run makes its files.
  Workplace& workplace() { return *workplace_; }

  // The path, from the workplace, of the folder with the shared files of that key (letters and digits): those that `make`
  // returns, unless they are there and whole. Files of other keys go, unless another run lives.
  std::string shared(const std::string& key, const std::function<std::vector<exporting::OutputFile>()>& make);

  // Moves files of the workplace to the output folder, all or none.
  void publish(const std::vector<StagedFile>& files, const Cancelled& cancelled);

 private:
  void clear_shared(const FolderLock& lock, const std::string& but) const;
  bool is_complete() const;
  void end();

  std::filesystem::path output_;
  Shot shot_;
  std::unique_ptr<Workplace> workplace_;
  std::string whole_;  // the key of shared files that were found whole, or made
  bool has_made_shared_ = false;
  bool has_published_ = false;
};

}  // namespace shatterpave::pipeline
