#include "pipeline/export_frames.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/sha256.h"
#include "pipeline/edition.h"
#include "pipeline/frame_models.h"
#include "pipeline/frame_sidecar.h"
#include "pipeline/shot_frames.h"
#include "pipeline/write.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

// Files as they are staged: one that is made again, for another frame, must be the same.
class StagedFrames {
 public:
  explicit StagedFrames(const fs::path& folder) : folder_(folder) {}

  void add(const exporting::Outputs& outputs) {
    for (const exporting::OutputFile& file : outputs.files) {
      if (is_new(file.name, sha256(file.content))) write_file(folder_ / file.name, file.content);
    }
    for (const exporting::FileSet& set : outputs.sets) {
      // Of what does not change there is one set for all.
      if (sums_.contains(set.names.front())) continue;
      set.write(folder_.string());
      for (const std::string& name : set.names) is_new(name, sum_of(folder_ / name));
    }
  }

  const std::vector<StagedFile>& files() const { return files_; }

 private:
  bool is_new(const std::string& name, const std::string& sum) {
    ENSURE(name == fs::path(name).filename() && name.find('\n') == std::string::npos);
    const auto [at, added] = sums_.emplace(name, sum);
    if (added) files_.push_back({name, sum});
    if (at->second != sum) {
      throw InputError(fmt::format(
          "names: expected other ones of the scene and of what is in it, got such that two files are called '{}'", name));
    }
    return added;
  }

  const fs::path& folder_;
  std::map<std::string, std::string> sums_;
  std::vector<StagedFile> files_;
};

// Gives the files of a frame their names.
void name_files(exporting::Model& model, const std::string& stem, int frame, const Wanted& is_fixed) {
  model.shared_stem = std::exchange(model.name, stem);
  const std::size_t panes = model.panes.size();
  const auto stem_of_thing = [&](std::size_t thing, const std::string& name) {
    return is_fixed(thing) ? std::string() : frame_stem(name, frame);
  };
  for (std::size_t i = 0; i < panes; ++i) model.panes[i].stem = stem_of_thing(i, model.panes[i].pane.name);
  for (std::size_t i = 0; i < model.pavements.size(); ++i) {
    model.pavements[i].stem = stem_of_thing(panes + i, model.pavements[i].pavement.name);
  }
}

}  // namespace

Edition frames_edition(const scene::Scene& still) { return {still.name, "export of frames", shot_state(still)}; }

Published exported_frames(scene::Shot& shot, std::span<const int> frames, const MakeOutputs& make, const fs::path& output,
                          const Progress& progress, const Cancelled& cancelled) {
  require_output_folder(output);
  Workplace workplace(output, cancelled);
  StagedFrames staged(workplace.folder());
  {
    const CancelScope scope([&] {
      workplace.touch();
      return cancelled && cancelled();
    });
    require_frames(shot, frames);
    const ChangingThings changing(shot);
    FrameModels models;
    std::size_t done = 0;
    const Progress share = [&](std::string_view what, double part) {
      if (!progress) return;
      progress(fmt::format("frame {}: {}", frames[done], what),
               (static_cast<double>(done) + part) / static_cast<double>(frames.size()));
    };
    for (; done < frames.size(); ++done) {
      stop_if_cancelled();
      const int frame = frames[done];
      const scene::Scene scene = shot.at(frame);
      const std::vector<std::string> sums = thing_sums(scene, pavement_parts(scene));
      exporting::Model& model = models.model(
          scene, [](std::size_t /*thing*/) { return true; }, share);
      const auto is_fixed = [&](std::size_t thing) { return changing.is_fixed(sums, thing); };
      name_files(model, frame_stem(scene.name, frame), frame, is_fixed);
      share("writing", 1.0);
      staged.add(make(model));
    }
  }
  return published(workplace, staged.files(), frames_edition(shot.still()), output, cancelled);
}

}  // namespace shatterpave::pipeline
