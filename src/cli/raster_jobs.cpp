// In `shatterpave-rasters`: does the job.
#include "cli/raster_jobs.h"

#include <vector>

#include "cli/export_job.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/notes.h"
#include "core/parallel.h"
#include "export/raster_targets.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "pipeline/render.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

void run_with_rasters(const Export& job, char** /*argv*/) { export_scene(job, exporting::append_files); }

void run_with_rasters(const Render& job, char** /*argv*/) {
  const ThreadLimit limit(job.options.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  tell(scene.notes);
  pipeline::require_output_folder(job.output);
  const pipeline::Edition edition = edition_of(scene, "picture");
  pipeline::Picture picture;
  std::vector<Note> empty;
  {
    ProgressBar bar;
    const exporting::Model model = pipeline::generated(scene, bar.progress());
    empty = pipeline::emptiness(scene, model);
    const pipeline::PovrayStill still = pipeline::povray_still(model);
    const SignalNotes notes;
    picture = pipeline::rendered(still, job.options, edition, job.output, bar.progress(), SignalNotes::received);
  }
  tell(empty);
  tell(picture.messages);
  report(picture.files, edition, job.output);
}

}  // namespace shatterpave::cli
