// Errors of rooms that know no file, put to their places in the scene file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/toml/key_places.h"

namespace shatterpave::pipeline {

// The places of the `i`-th thing; none if the scene was read from no file.
const scene::KeyPlaces& places_at(const std::vector<scene::KeyPlaces>& places, std::size_t i);

// Where the key of a member of the thing `name` stands, "" for the thing itself. Without a file the place is NAME.MEMBER alone.
Place known_place(const scene::KeyPlaces& places, const std::string& name, std::string_view member);

// Does `work` on the thing `name`. An InputError whose place is `NAME.MEMBER` and no file leaves as one at the place of that
// member.
void with_places(const std::string& name, const scene::KeyPlaces& places, const std::function<void()>& work);

}  // namespace shatterpave::pipeline
