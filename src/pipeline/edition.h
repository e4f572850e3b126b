// The edition of a scene that this version of the program makes.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/folder_notes.h"

namespace shatterpave::pipeline {

// The edition of the scene of that name whose sources have that fingerprint (scene/scene.h); `kind` is what is made of it.
Edition edition_of(const std::string& scene, std::string_view fingerprint, const std::string& kind);

}  // namespace shatterpave::pipeline
