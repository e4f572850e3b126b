// Temporary folders inside output folders, in which runs make what they then publish.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/cancel.h"
#include "pipeline/folder_lock.h"

namespace shatterpave::pipeline {

// Throws InputError if `folder` cannot be an output folder: it, or something on the way to it, is a file.
void require_output_folder(const std::filesystem::path& folder);

// A folder for temporary files inside an output folder, which is made if it is missing. Both are taken away again at the
// end: the temporary one always, the output folder if it was made here and `keep` was not called. What runs that were killed
// have left in the output folder is cleared first: half of a publication is taken back, and their workplaces go.
class Workplace {
 public:
  // Called with the new folder while the output folder is locked, so that of two runs one sees the other; may throw.
  using Admission = std::function<void(const FolderLock& lock, const std::filesystem::path& folder)>;

  explicit Workplace(const std::filesystem::path& output, const Cancelled& cancelled = {}, const Admission& admission = {});
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  // Files in it must not begin with a point and have no ending.
  const std::filesystem::path& folder() const { return temporary_; }
  const std::filesystem::path& output() const { return output_; }
  void keep() { made_.clear(); }
  // Leaves the temporary folder to the next run, which tries again to take back what is half published.
  void leave() { temporary_.clear(); }
  // To be called often while work goes on; on any thread.
  void touch() { mark_->touch(); }

 private:
  void take_away();

  std::filesystem::path output_;
  std::vector<std::filesystem::path> made_;  // folders that did not exist, the outermost first
  std::filesystem::path temporary_;
  std::optional<LifeMark> mark_;
};

// The workplaces, but for `own`, of runs that live.
std::vector<std::filesystem::path> living_workplaces(const FolderLock& lock, const std::filesystem::path& own);

// Where the runs of a shot have their workplaces, and what they share: a hidden folder in the output folder, whose name begins
// so.
inline constexpr std::string_view shot_folder_prefix = ".shatterpave-frames-";

// Takes back what a killed run has half published, and clears the workplaces of those that do not live; also in
// the folders of shots.
void clear_killed(const FolderLock& lock);

}  // namespace shatterpave::pipeline
