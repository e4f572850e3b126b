// POV-Ray as the golden-image tests run it: repeatable to the bit.
#pragma once

#include <filesystem>
#include <string>

#include "relief/raster.h"

namespace shatterpave::render_tests {

// tests/out: what tests leave for a person to see.
std::filesystem::path output_folder();

// Renders the scene file `scene`, a name in `folder`, and returns the linear picture of three channels. One thread, without
// anti-aliasing and jitter, so that it repeats exactly. Leaves picture.exr and povray.log in `folder`.
// Throws std::runtime_error, with the end of what POV-Ray said, where it fails or warns.
relief::Raster rendered(const std::filesystem::path& folder, const std::string& scene, std::size_t width, std::size_t height);

}  // namespace shatterpave::render_tests
