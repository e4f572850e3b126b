// Frames of a shot, rendered by POV-Ray.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/cancel.h"
#include "core/progress.h"
#include "pipeline/frame_sidecar.h"
#include "pipeline/render.h"
#include "scene/shot.h"

namespace shatterpave::pipeline {

struct FramesOptions {
  RenderOptions render;
  bool skip_existing = false;  // frames that are there, whole and of the same origin, are not rendered again
};

struct FrameOutcome {
  int frame = 0;
  bool is_skipped = false;
  FrameCost cost;                            // nothing where it was skipped
  std::vector<std::filesystem::path> paths;  // of its files, the sidecar last; none where it was skipped
  std::string messages;                      // the renderer's warnings, lines ended by '\n'
  std::size_t done = 0;                      // frames of this run, with this one
  std::size_t count = 0;
};
using FrameDone = std::function<void(const FrameOutcome& outcome)>;

// Renders the frames, in order, and leaves of each NAME.####.exr, NAME.####.png and NAME.####.frame.json in `output`: all three
// or none, one frame after the other, so that frames that are done stay where a later one fails. Other runs may render frames
// of the same shot in the same folder at the same time, also the same ones; one of another state of it is refused
// (pipeline/frame_folder.h). `progress` is told the share of all frames.
void render_frames(scene::Shot& shot, std::span<const int> frames, const FramesOptions& options,
                   const std::filesystem::path& output, const FrameDone& done, const Progress& progress = {},
                   const Cancelled& cancelled = {});

}  // namespace shatterpave::pipeline
