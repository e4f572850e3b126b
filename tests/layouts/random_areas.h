// Random areas to be paved: triangles to 40-gons, thin, spiky and bent ones, real places.
#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "layouts/draws.h"

namespace shatterpave::layouts {

// An area, in no unit, that is yet to be scaled; its rings may run either way and be too close to be read as a scene.
struct DrawnArea {
  std::string shape;  // what it is called in tables
  geometry::Region region;
};

// `places` are real ones, which are drawn now and then.
DrawnArea random_area(const Draws& draws, const std::vector<geometry::Region>& places);

// The region turned, stretched, scaled to `area_mm2` without its holes, and moved, on the lattice.
geometry::Region placed(const geometry::Region& region, double area_mm2, const Draws& draws);

}  // namespace shatterpave::layouts
