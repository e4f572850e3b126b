// From the coordinates of plans to the millimetres of a scene.
#pragma once

#include <optional>

#include "scene/plans/plan.h"

namespace shatterpave::scene {

// (x, y) → ((x, y) − origin) · mm_per_unit, with longitudes taken the short way round.
struct PlanFrame {
  vec2 origin{0.0, 0.0};
  vec2 mm_per_unit{1.0, 1.0};
  double full_turn = 0.0;  // of longitudes; 0 for lengths

  vec2 operator()(vec2 p) const;
  Ring operator()(const Ring& ring) const;
};

// The units that the file states; or else degrees if all its positions could be degrees, or could be but for longitudes beyond
// 180 and no shape would have the size of a hand in metres; else metres. Throws InputError where the file states what gives no
// lengths.
PlanUnits units_of(const Plan& plan);

// Millimetres for one degree of longitude and of latitude, from the radii of curvature of the units' ellipsoid.
vec2 mm_per_degree(double latitude_deg, const PlanUnits& units);

// Why a shape cannot be placed, before any frame: its own fault, or latitudes that there are none of; nothing for a sound one.
std::optional<InputError> fault_of(const PlanShape& shape, const PlanUnits& units);

// The frame for shapes of a plan.
//   Degrees become local millimetres, x east and y north, by an equirectangular projection about the origin, with the radii of
//   curvature of the ellipsoid there; at 1 km from it, it is 0.1 m off at latitude 50°. The origin is the middle of the shapes'
//   bounding box, or `origin`. Longitudes count modulo a full turn.
//   Lengths stay where they are, unless a coordinate is beyond ±1 km: then the middle of the bounding box, to whole metres (or
//   whole feet …), becomes the origin.
// Throws InputError, at the place of the first shape, where the shapes span more than 2 km or units are likely to be others.
PlanFrame frame_of(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units,
                   std::optional<vec2> origin);

}  // namespace shatterpave::scene
