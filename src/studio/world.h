// The one world of a scene, in which its things, its camera and its light stand: millimetres, right-handed, x to the right
// (east), y away from the viewer (north), z up. A pavement lies in it as it is drawn, heights up. A pane stands upright on
// y = 0 as it is drawn: its x is x, its y is z, and the side that is hit, its +z, looks to −y.
#pragma once

#include "core/angle.h"
#include "core/vec.h"

namespace shatterpave::studio {

// Where the origin of a thing stands in the world, and how it is turned about the upright through it.
struct Placement {
  vec3 at_mm{0.0, 0.0, 0.0};
  Angle turn;  // counter-clockwise from above

  bool operator==(const Placement&) const = default;
};

// A point of the frame in which a pane is drawn (x right, y up, z towards the viewer), as one of the world, and back. Exact.
constexpr vec3 world_of_upright(vec3 p) { return {p.x, -p.z, p.y}; }
constexpr vec3 upright_of_world(vec3 p) { return {p.x, p.z, -p.y}; }

// The point `p_mm` of a thing as it would be without its placement, in the world.
inline vec3 placed(vec3 p_mm, const Placement& placement) {
  const vec2 turned = rotated({p_mm.x, p_mm.y}, placement.turn);
  return vec3{turned.x, turned.y, p_mm.z} + placement.at_mm;
}

// The same back.
inline vec3 without(vec3 p_mm, const Placement& placement) {
  const vec3 from = p_mm - placement.at_mm;
  return {rotated({from.x, from.y}, -placement.turn), from.z};
}

}  // namespace shatterpave::studio
