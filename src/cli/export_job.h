// The jobs of `export`, whichever targets it is for, and of `check`.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/arguments.h"
#include "export/target.h"
#include "scene/scene.h"
#include "scene/shot.h"

namespace shatterpave::cli {

// Whether a scene may name an environment, which is a picture: told from the texts alone, and never denied where it does. What
// can be read only once is not read; it may.
bool may_have_environment(const std::filesystem::path& scene, const std::vector<scene::Override>& overrides);

// Throws InputError where pictures that a scene names are not as they should be. Null where the scene names none.
using RequirePictures = void (*)(const scene::Scene&);

// Throws InputError where a target would be refused for what the scene says, which is known before anything is made.
void require_for_targets(const scene::Scene& scene, const Targets& targets);

// Adds the files of a target to those of others.
using AppendTarget = std::function<void(const exporting::Target&, const exporting::Model&, exporting::Outputs&)>;

// The frames that were asked for, or all of the shot; those that lie outside are told. `option` names what asked.
std::vector<int> frames_asked(const scene::Shot& shot, const std::optional<std::vector<int>>& frames, std::string_view option);

// Generates the scene and writes the files of all its targets.
void export_scene(const Export& job, const AppendTarget& append, RequirePictures require_pictures);

// Tells what the scene holds, or throws InputError for what `export` would.
void check_scene(const Check& job, RequirePictures require_pictures);

}  // namespace shatterpave::cli
