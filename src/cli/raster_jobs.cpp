// In `shatterpave-rasters`: does the job.
#include "cli/raster_jobs.h"

#include <vector>

#include "cli/export_job.h"
#include "cli/farm_job.h"
#include "cli/frames_job.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/notes.h"
#include "core/parallel.h"
#include "export/raster_targets.h"
#include "pipeline/environment.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "pipeline/render.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

namespace {

// As large as the command asks for, or else the scene's camera.
pipeline::RenderOptions sized(pipeline::RenderOptions options, const scene::Scene& scene) {
  if (options.width > 0 || !scene.camera || !scene.camera->size_px) return options;
  options.width = (*scene.camera->size_px)[0];
  options.height = (*scene.camera->size_px)[1];
  return options;
}

}  // namespace

void run_with_rasters(const Export& job, char** /*argv*/) {
  export_scene(job, exporting::append_files, pipeline::require_environment);
}

void run_with_rasters(const Check& job, char** /*argv*/) { check_scene(job, pipeline::require_environment); }

void run_with_rasters(const Farm& job, char** /*argv*/) { write_farm_job(job); }

void run_with_rasters(const Render& job, char** /*argv*/) {
  if (job.frames) {
    render_frames(job);
    return;
  }
  const ThreadLimit limit(job.options.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  tell(scene.notes);
  pipeline::require_environment(scene);
  pipeline::require_output_folder(job.output);
  const pipeline::Edition edition = edition_of(scene, "picture");
  pipeline::Picture picture;
  std::vector<Note> empty;
  {
    FrameProgress bar(job.progress);
    const exporting::Model model = pipeline::generated(scene, bar.progress());
    empty = pipeline::emptiness(scene, model);
    const pipeline::PovrayStill still = pipeline::povray_still(model);
    const SignalNotes notes;
    picture = pipeline::rendered(still, sized(job.options, scene), edition, job.output, bar.progress(), SignalNotes::received);
  }
  tell(empty);
  tell(picture.messages);
  report(picture.files, edition, job.output);
}

}  // namespace shatterpave::cli
