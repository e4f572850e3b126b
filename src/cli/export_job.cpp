#include "cli/export_job.h"

#include <algorithm>
#include <iterator>

#include "cli/report.h"
#include "cli/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "export/svg/drawing_svg.h"
#include "pipeline/generate.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

void require_for_targets(const scene::Scene& scene, const std::vector<Target>& targets) {
  if (std::ranges::find(targets, Target::obj) != targets.end()) exporting::require_shards(scene.panes);
}

void append_without_rasters(const exporting::Model& model, Target target, exporting::Outputs& outputs) {
  ENSURE(target == Target::json || target == Target::svg || target == Target::obj);
  if (target == Target::json) {
    outputs.files.push_back(exporting::json_file(model));
  } else {
    std::ranges::move(target == Target::obj ? exporting::obj_files(model) : exporting::svg_files(model),
                      std::back_inserter(outputs.files));
  }
}

void export_scene(const Export& job, const AppendTarget& append_target) {
  const ThreadLimit limit(job.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  tell(scene.notes);
  require_for_targets(scene, job.targets);
  pipeline::require_output_folder(job.output);
  exporting::Model model;
  exporting::Outputs outputs;
  {
    ProgressBar bar;
    model = pipeline::generated(scene, bar.progress());
    for (const Target target : job.targets) append_target(model, target, outputs);
  }
  const SignalNotes notes;
  const pipeline::Edition edition = edition_of(scene, "export");
  report(pipeline::written_outputs(outputs, edition, job.output, SignalNotes::received), edition, job.output);
}

}  // namespace shatterpave::cli
