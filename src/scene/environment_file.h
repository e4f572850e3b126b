// The picture that `[light] environment` names, found and read.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "studio/environment.h"

namespace shatterpave::scene {

// As large as a picture of 8192 × 4096 in half floats, uncompressed, with an alpha channel.
inline constexpr std::size_t largest_environment_bytes = std::size_t{256} << 20;

// Of a name without point and slash, the environment of that name among those installed with Blender's data; else of a file,
// whose relative name starts at the scene file's folder. Throws InputError, at `place`, where there is none of that name, or
// its first bytes are not those of an EXR, HDR or PNG picture; nothing else of it is looked at.
studio::Environment environment_named(const std::string& asked, const std::filesystem::path& scene_file, const Place& place);

}  // namespace shatterpave::scene
