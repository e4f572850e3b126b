// Random pavements as scenes: every bond, field, course and size.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::layouts {

// A scene of one pavement, and what it was drawn as.
struct DrawnScene {
  std::string shape;  // of the area
  std::string toml;   // a scene file, whole
};

enum class Kind {
  usual,
  rare,  // stones larger than their area, joints wider than stones, corners that are hardly any, far from the origin, tiny and
         // huge
  sized  // packed stones whose sizes follow a field, as stones, cobbles or scales
};

// The scene of `number`; every attempt is another one. `places` are real outlines among which it may choose.
DrawnScene random_scene(std::uint64_t number, std::uint64_t attempt, Kind kind, const std::vector<geometry::Region>& places);

}  // namespace shatterpave::layouts
