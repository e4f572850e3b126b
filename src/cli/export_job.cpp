#include "cli/export_job.h"

#include <algorithm>
#include <iterator>

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
  pipeline::require_output_folder(job.output);
  exporting::Model model;
  exporting::Outputs outputs;
  {
    ProgressBar bar;
    model = pipeline::generated(scene, bar.progress());
    for (const Target target : job.targets) append_target(model, target, outputs);
  }
  const SignalNotes notes;
  print_paths(pipeline::written_outputs(outputs, job.output, SignalNotes::received));
}

}  // namespace shatterpave::cli
