#include "cli/export_job.h"

#include "cli/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "export/json/geometry_json.h"
#include "export/svg/drawing_svg.h"
#include "pipeline/generate.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

std::vector<exporting::OutputFile> files_without_rasters(const exporting::Model& model, Target target) {
  ENSURE(target != Target::povray);
  if (target == Target::json) return {exporting::json_file(model)};
  return exporting::svg_files(model);
}

void export_scene(const Export& job, const FilesOfTarget& files_of_target) {
  const ThreadLimit limit(job.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  pipeline::require_output_folder(job.output);
  std::vector<exporting::OutputFile> files;
  {
    ProgressBar bar;
    const exporting::Model model = pipeline::generated(scene, bar.progress());
    for (const Target target : job.targets) {
      for (exporting::OutputFile& file : files_of_target(model, target)) files.push_back(std::move(file));
    }
  }
  const SignalNotes notes;
  print_paths(pipeline::written(files, job.output, SignalNotes::received));
}

}  // namespace shatterpave::cli
