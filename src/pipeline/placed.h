// Refusals of rooms that know no file, put to their places in the scene file.
#pragma once

#include <functional>
#include <string>

#include "scene/toml/key_places.h"

namespace shatterpave::pipeline {

// Does `work` on the thing `name`. An InputError whose place is `NAME.MEMBER` and no file leaves as one at the place of that
// member.
void with_places(const std::string& name, const scene::KeyPlaces& places, const std::function<void()>& work);

}  // namespace shatterpave::pipeline
