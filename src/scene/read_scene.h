// Scene files: TOML into a Scene. Every key is described in docs/scene-file.md.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/override.h"
#include "scene/scene.h"

namespace shatterpave::scene {

// The scene of a file. Throws InputError with the place of the first thing that is wrong.
Scene scene_of_file(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

// The same for a text already read; `file` names it in messages, its stem names the scene, and outline files are sought from
// its folder.
Scene scene_of_text(std::string_view text, const std::filesystem::path& file, const std::vector<Override>& overrides = {});

}  // namespace shatterpave::scene
