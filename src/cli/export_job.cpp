#include "cli/export_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/report.h"
#include "cli/terminal.h"
#include "core/error.h"
#include "core/notes.h"
#include "core/parallel.h"
#include "export/svg/sheet_svg.h"
#include "pipeline/export_frames.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "pipeline/shot_frames.h"
#include "pipeline/shot_paths.h"
#include "pipeline/write.h"
#include "scene/frame_range.h"
#include "scene/input_file.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

namespace {

void require(RequirePictures require_pictures, const scene::Scene& scene) {
  ENSURE(require_pictures != nullptr || !scene.environment);
  if (require_pictures != nullptr) require_pictures(scene);
}

}  // namespace

bool may_have_environment(const std::filesystem::path& scene, const std::vector<scene::Override>& overrides) {
  std::error_code error;
  const auto status = std::filesystem::status(scene, error);
  if (scene::is_nameless(scene) || std::filesystem::is_fifo(status)) return true;
  // A backslash may begin an escape for a letter of the key.
  const auto may = [](std::string_view text) {
    return text.find("environment") != std::string_view::npos || text.find('\\') != std::string_view::npos;
  };
  const auto sets = [&](const scene::Override& change) { return may(change.key) || may(change.value); };
  return std::ranges::any_of(overrides, sets) ||
         may(scene::input_text(scene, scene::largest_scene_bytes, Place{scene.string(), 0, 0, ""}));
}

void require_for_targets(const scene::Scene& scene, const Targets& targets) {
  for (const exporting::Target* target : targets) pipeline::require_possible_for(*target, scene);
}

std::vector<int> frames_asked(const scene::Shot& shot, const std::optional<std::vector<int>>& frames, std::string_view option) {
  const Place place{fmt::format("shatterpave: {}", option), 0, 0, ""};
  const scene::Scene& still = shot.still();
  if (!frames) {
    if (!still.frames) pipeline::frames_within(still, {}, place);  // says that there are none
    std::vector<int> all;
    for (int frame = still.frames->range.first; frame <= still.frames->range.last; ++frame) all.push_back(frame);
    return all;
  }
  std::vector<int> within = pipeline::frames_within(still, *frames, place);
  std::vector<int> outside;
  std::ranges::set_difference(*frames, within, std::back_inserter(outside));
  if (!outside.empty()) {
    tell(fmt::format("shatterpave: {}: left out what is not of the scene's range {}-{}: {}\n", option,
                     still.frames->range.first, still.frames->range.last, scene::range_text(outside)));
  }
  return within;
}

namespace {

void export_frames(const Export& job, const AppendTarget& append, RequirePictures require_pictures) {
  const auto shot = scene::shot_of_file(job.scene, job.overrides);
  const scene::Scene& still = shot->still();
  tell(still.notes);
  tell(pipeline::unseen(still, job.targets));
  const std::vector<int> frames = frames_asked(*shot, job.frames, "--frames");
  require_for_targets(still, job.targets);
  require(require_pictures, still);
  pipeline::Published published;
  {
    ProgressBar bar;
    const SignalNotes notes;
    const auto make = [&](const exporting::Model& model) {
      exporting::Outputs outputs;
      for (const exporting::Target* target : job.targets) append(*target, model, outputs);
      if (job.sheet_scale) outputs.files.push_back(exporting::svg::sheet(model, *job.sheet_scale));
      return outputs;
    };
    published = pipeline::exported_frames(*shot, frames, make, job.output, bar.progress(), SignalNotes::received);
  }
  report(published, pipeline::frames_edition(still), job.output);
}

}  // namespace

void export_scene(const Export& job, const AppendTarget& append, RequirePictures require_pictures) {
  const ThreadLimit limit(job.threads);
  if (job.frames) {
    export_frames(job, append, require_pictures);
    return;
  }
  const auto shot = scene::shot_of_file(job.scene, job.overrides);
  const scene::Scene& scene = shot->still();
  tell(scene.notes);
  tell(pipeline::unseen(scene, job.targets));
  require_for_targets(scene, job.targets);
  require(require_pictures, scene);
  pipeline::require_output_folder(job.output);
  const pipeline::Edition edition = edition_of(scene, "export");
  pipeline::Published published;
  std::vector<Note> empty;
  {
    ProgressBar bar;
    const Progress progress = bar.progress();
    exporting::Model model = pipeline::generated(scene, progress);
    if (std::ranges::any_of(job.targets, &exporting::Target::holds_motion)) pipeline::add_paths(model, *shot);
    exporting::Outputs outputs;
    for (const exporting::Target* target : job.targets) append(*target, model, outputs);
    if (job.sheet_scale) outputs.files.push_back(exporting::svg::sheet(model, *job.sheet_scale));
    pipeline::report_sets(outputs, progress);
    const SignalNotes notes;
    published = pipeline::written_outputs(outputs, edition, job.output, SignalNotes::received);
    empty = pipeline::emptiness(scene, model);
  }
  tell(empty);
  report(published, edition, job.output);
}

void check_scene(const Check& job, RequirePictures require_pictures) {
  const auto shot = scene::shot_of_file(job.scene, job.overrides);
  const scene::Scene& scene = shot->still();
  pipeline::require_possible(scene);
  if (scene.frames) pipeline::require_frames(*shot, frames_asked(*shot, {}, ""));
  require_for_targets(scene, job.targets);
  require(require_pictures, scene);
  tell(scene.notes);
  tell(pipeline::unseen(scene, job.targets));
  tell(pipeline::emptiness(scene));
  print(fmt::format("{}: {}\n", job.scene.string(), pipeline::summary(scene)));
}

}  // namespace shatterpave::cli
