// The job of `render --frames`, and how it is told of its progress.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments.h"
#include "cli/terminal.h"
#include "core/progress.h"
#include "pipeline/render_frames.h"
#include "scene/shot.h"

namespace shatterpave::cli {

// Progress in the form that was asked for.
class FrameProgress {
 public:
  explicit FrameProgress(ProgressForm form);
  // Valid while this lives.
  Progress progress();
  // A frame is there.
  void tell_frame(const pipeline::FrameOutcome& outcome);
  // The work has failed: for who asked for it.
  void tell_failure(std::string_view message);

 private:
  void tell_part(double part);

  ProgressForm form_;
  std::optional<ProgressBar> bar_;
  std::chrono::steady_clock::time_point next_{};
};

void render_frames(const Render& job);

}  // namespace shatterpave::cli
