#include "cli/farm_job.h"

#include <fmt/format.h>

#include <vector>

#include "cli/export_job.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/parallel.h"
#include "pipeline/environment.h"
#include "pipeline/farm.h"
#include "pipeline/render_frames.h"
#include "pipeline/shot_frames.h"
#include "pipeline/workplace.h"
#include "pipeline/write.h"

namespace shatterpave::cli {

namespace {

// The middle one of those that are asked for, small and in draft quality, in a folder that goes afterwards.
pipeline::MeasuredFrame measured(scene::Shot& shot, const pipeline::FarmJob& job) {
  const pipeline::RenderOptions options = pipeline::measured_options(job.options);
  const int frame = job.frames[job.frames.size() / 2];
  pipeline::MeasuredFrame result{frame, pipeline::size_of(options), {}};
  const SignalNotes notes;
  ProgressBar bar;
  const pipeline::Workplace workplace(job.output, SignalNotes::received);
  pipeline::render_frames(
      shot, std::vector{frame}, {options, false}, workplace.folder() / "measured",
      [&](const pipeline::FrameOutcome& outcome) { result.cost = outcome.cost; }, bar.progress(), SignalNotes::received);
  return result;
}

void tell_needs(const pipeline::FarmJob& job, const pipeline::MeasuredFrame& frame, const pipeline::FarmNeeds& needs) {
  const pipeline::PictureSize size = pipeline::size_of(job.options);
  tell(
      fmt::format("shatterpave: farm: measured frame {} as a draft of {}x{}: {:.1f} s, of these {:.1f} s of processor time of "
                  "the renderer, {} "
                  "MiB\n"
                  "shatterpave: farm: so a frame of {}x{}, {}, should take {:.0f} s on {} threads; booked for each task of {} "
                  "frames: {} s, {} MiB\n",
                  frame.frame, frame.size.width, frame.size.height, frame.cost.seconds, frame.cost.renderer_cpu_seconds,
                  frame.cost.most_memory_kib / 1024, size.width, size.height, pipeline::name_of(job.options.quality),
                  needs.frame_seconds, needs.threads, needs.chunk, needs.task_seconds, needs.memory_mib));
}

}  // namespace

void write_farm_job(const Farm& job) {
  const ThreadLimit limit(job.options.threads);
  const auto shot = scene::shot_of_file(job.scene, job.overrides);
  const scene::Scene& still = shot->still();
  tell(still.notes);
  const std::vector<int> frames = frames_asked(*shot, job.frames, job.frames ? "--frames" : "farm");
  pipeline::require_environment(still);
  pipeline::require_output_folder(job.output);
  pipeline::require_frames(*shot, frames);
  pipeline::RenderOptions options = job.options;
  if (options.width == 0 && still.camera && still.camera->size_px) {
    options.width = (*still.camera->size_px)[0];
    options.height = (*still.camera->size_px)[1];
  }
  pipeline::FarmJob asked{still.name, job.scene.string(), job.output.string(), job.overrides, frames, options};
  const auto system = static_cast<pipeline::FarmSystem>(job.system);
  static_cast<void>(pipeline::farm_file(system, asked, {}));  // before anything is measured
  const pipeline::MeasuredFrame frame = measured(*shot, asked);
  const pipeline::FarmNeeds needs = pipeline::farm_needs(asked, frame, job.chunk.value_or(0));
  tell_needs(asked, frame, needs);
  const SignalNotes notes;
  const pipeline::Edition edition = edition_of(still, "farm");
  report(pipeline::written({pipeline::farm_file(system, asked, needs)}, edition, job.output, SignalNotes::received), edition,
         job.output);
}

}  // namespace shatterpave::cli
