#include "cli/frames_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "cli/export_job.h"
#include "core/error.h"
#include "core/parallel.h"
#include "pipeline/environment.h"

namespace shatterpave::cli {

namespace {

constexpr std::chrono::milliseconds openjd_interval{1000};  // between two lines of progress

std::string in_one_line(std::string_view text) {
  std::string line(text);
  std::ranges::replace(line, '\n', ' ');
  return line;
}

}  // namespace

FrameProgress::FrameProgress(ProgressForm form) : form_(form) {
  if (form != ProgressForm::openjd) bar_.emplace(form);
}

Progress FrameProgress::progress() {
  if (bar_) return bar_->progress();
  return [this](std::string_view /*what*/, double part) { tell_part(part); };
}

void FrameProgress::tell_part(double part) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + openjd_interval;
  tell(fmt::format("openjd_progress: {:.1f}\n", 100.0 * std::clamp(part, 0.0, 1.0)));
}

void FrameProgress::tell_frame(const pipeline::FrameOutcome& outcome) {
  constexpr double kib = 1024.0;
  const std::string count = fmt::format("{} of {}", outcome.done, outcome.count);
  const std::string what = outcome.is_skipped
                               ? fmt::format("frame {}: there already ({})", outcome.frame, count)
                               : fmt::format("frame {}: {:.1f} s, {:.1f} s of them the renderer's, {:.0f} MiB ({})",
                                             outcome.frame, outcome.cost.seconds, outcome.cost.renderer_seconds,
                                             static_cast<double>(outcome.cost.most_memory_kib) / kib, count);
  if (form_ == ProgressForm::openjd) {
    const double part = static_cast<double>(outcome.done) / static_cast<double>(outcome.count);
    tell(fmt::format("openjd_status: {}\nopenjd_progress: {:.1f}\n", what, 100.0 * part));
  } else if (form_ != ProgressForm::none && !draws_bar(form_)) {
    tell(what + "\n");
  }
}

void FrameProgress::tell_failure(std::string_view message) {
  if (form_ == ProgressForm::openjd) tell(fmt::format("openjd_fail: {}\n", in_one_line(message)));
}

void render_frames(const Render& job) {
  const ThreadLimit limit(job.options.threads);
  const auto shot = scene::shot_of_file(job.scene, job.overrides);
  tell(shot->still().notes);
  const std::vector<int> frames = frames_asked(*shot, job.frames, "--frames");
  pipeline::require_environment(shot->still());
  FrameProgress told(job.progress);
  const SignalNotes notes;
  const auto done = [&](const pipeline::FrameOutcome& outcome) {
    told.tell_frame(outcome);
    tell(outcome.messages);
    print_paths(outcome.paths);
  };
  try {
    pipeline::render_frames(*shot, frames, {job.options, job.skip_existing}, job.output, done, told.progress(),
                            SignalNotes::received);
  } catch (const std::exception& error) {
    told.tell_failure(error.what());
    throw;
  }
}

}  // namespace shatterpave::cli
