// From the coordinates of plans to the millimetres of a scene.
#pragma once

#include <optional>

#include "scene/plan.h"

namespace shatterpave::scene {

// (x, y) → ((x, y) − origin) · mm_per_unit, with longitudes taken the short way round.
struct PlanFrame {
  vec2 origin{0.0, 0.0};
  vec2 mm_per_unit{1.0, 1.0};
  bool degrees = false;

  vec2 operator()(vec2 p) const;
  Ring operator()(const Ring& ring) const;
};

// The units that the file states, or else degrees if all its positions could be degrees, else metres.
PlanUnits units_of(const Plan& plan);

// The frame for shapes of a plan.
//   Degrees become local millimetres, x east and y north, by an equirectangular projection about the origin, with the radii of
//   curvature of WGS 84 there; at 1 km from it, it is 0.1 m off at latitude 50°. The origin is the middle of the shapes'
//   bounding box, or `origin`.
//   Metres and millimetres stay where they are, unless a coordinate is beyond ±1 km: then the middle of the bounding box, to
//   whole metres, becomes the origin.
// Throws InputError, at the place of the first shape, where the shapes span more than 2 km or units are likely to be others.
PlanFrame frame_of(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units,
                   std::optional<vec2> origin);

}  // namespace shatterpave::scene
