// In `shatterpave-rasters`: does the job.
#include "cli/raster_jobs.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "cli/export_job.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/notes.h"
#include "core/parallel.h"
#include "export/povray/povray.h"
#include "export/textures/textures.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "pipeline/render.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

void run_with_rasters(const Export& job, char** /*argv*/) {
  export_scene(job, [](const exporting::Model& model, Target target, exporting::Outputs& outputs) {
    if (target == Target::povray) {
      std::ranges::move(exporting::povray::povray_files(model), std::back_inserter(outputs.files));
    } else if (target == Target::textures) {
      std::ranges::move(exporting::textures::texture_files(model), std::back_inserter(outputs.sets));
    } else {
      append_without_rasters(model, target, outputs);
    }
  });
}

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
