// Inside the room: the scene of a parsed file.
#pragma once

#include <toml++/toml.h>

#include <filesystem>

#include "scene/draft.h"
#include "scene/scene.h"

namespace shatterpave::scene {

struct Draft::Table {
  toml::table root;
};

// Throws InputError with the place of the first thing that is wrong. Where `kept` is given, panes, pavements and the picture of
// the environment are taken from it, and not read: the table must say of them what it said when that scene was read.
Scene scene_of_table(const toml::table& table, const std::filesystem::path& file, const Scene* kept = nullptr);

}  // namespace shatterpave::scene
