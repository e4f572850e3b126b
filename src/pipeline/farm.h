// Job files with which render farms render the frames of a shot: each task runs this program on a chunk of frames. There is no
// queue of our own.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "export/model.h"
#include "pipeline/frame_sidecar.h"
#include "pipeline/render_options.h"
#include "scene/override.h"

namespace shatterpave::pipeline {

// In the order of FarmSystem.
inline constexpr std::array<std::string_view, 3> farm_systems = {"slurm", "openjd", "parallel"};
enum class FarmSystem { slurm, openjd, parallel };

inline constexpr int most_chunk = 150;  // that Open Job Description takes

struct FarmJob {
  std::string scene;       // its name
  std::string scene_file;  // as it was given, which is how tasks are given it
  std::string output;      // the same
  std::vector<scene::Override> overrides;
  std::vector<int> frames;  // ascending, at least one
  RenderOptions options;    // of the frames; threads: of a task, 0: `usual_threads`
};

inline constexpr int usual_threads = 4;

// A frame that was rendered to learn what frames cost.
struct MeasuredFrame {
  int frame = 0;
  PictureSize size;
  FrameCost cost;
};

// What a task is booked for.
struct FarmNeeds {
  int threads = usual_threads;
  int chunk = 1;               // frames
  double frame_seconds = 0.0;  // what one takes, as is estimated
  double start_seconds = 0.0;  // what a task takes beside its frames
  std::int64_t task_seconds = 0;
  std::int64_t memory_mib = 0;
};

// How a draft of a frame is made to be measured: small, of the shape of the frames.
RenderOptions measured_options(const RenderOptions& options);

// From a frame in draft quality. `chunk`: 0 for as many frames as take some minutes.
FarmNeeds farm_needs(const FarmJob& job, const MeasuredFrame& measured, int chunk);

// The frames of each task, as ranges without gaps.
std::vector<std::string> farm_chunks(const std::vector<int>& frames, int chunk);

// The job file: NAME.slurm.sh, NAME.openjd.yaml or NAME.parallel.sh. It holds no path but those of the job. Throws InputError
// where the system cannot be told of what the job says.
exporting::OutputFile farm_file(FarmSystem system, const FarmJob& job, const FarmNeeds& needs);

}  // namespace shatterpave::pipeline
