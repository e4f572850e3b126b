// POV-Ray, run on a still in a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/cancel.h"
#include "core/progress.h"
#include "pipeline/publish.h"
#include "pipeline/render.h"

namespace shatterpave::pipeline {

// In its folder a still has this name whatever the scene's is, which may be one that POV-Ray's options cannot hold.
inline constexpr std::string_view still_file = "still.pov";

struct PovrayRun {
  std::string messages;  // warnings, lines ended by '\n'
  double seconds = 0.0;
  double processor_seconds = 0.0;
  std::int64_t most_memory_kib = 0;
};

// Renders the still in the folder, which `staged_picture` then finds there. POV-Ray gets every option that shows in the
// picture, so that no user's settings do. What the still includes is sought in the folder, then in `library`, a path from the
// folder, if it is not empty. Throws RendererError.
PovrayRun run_povray(const std::filesystem::path& folder, const RenderOptions& options, const std::string& library,
                     const Progress& progress, const Cancelled& cancelled);

// The files of a picture: STEM.exr, linear half float, and STEM.png, sRGB of 8 bits. Neither holds a time.
std::vector<StagedFile> picture_files(const std::string& stem);
// The same, made in the folder of what POV-Ray has left there.
std::vector<StagedFile> staged_picture(const std::filesystem::path& folder, const std::string& stem);

}  // namespace shatterpave::pipeline
