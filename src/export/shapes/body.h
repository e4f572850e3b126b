// What mesh targets are made of: bodies of triangles, each of one or more materials. None knows a format.
//
// All lie in one frame: millimetres, right-handed, x to the right, y up, z towards the viewer. It is that of the world
// (studio/world.h) with y up: world's (x, y, z) is (x, z, −y) here. So a pane that is placed nowhere else stands in it as it is
// drawn, and a pavement lies in it, its y away from the viewer (−z), its heights up.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.h"
#include "export/shapes/palette.h"
#include "export/shapes/swatch.h"
#include "studio/world.h"

namespace shatterpave::exporting::shapes {

// What something is made of, as far as renderers need to know.
enum class Substance {
  glass,          // faces and edge of a pane
  broken_glass,   // walls of cracks, bevels, chips
  crushed_glass,  // ground to powder about an impact
  stone,
  joint,  // what fills joints
  water
};

struct Material {
  std::string name;  // unique in the model: letters, digits and '_'
  Substance substance = Substance::stone;
  Colour colour;  // linear, of the primaries of sRGB; of glass and water white
  float roughness = 0.5F;
  std::optional<SwatchUse> swatch{};  // in place of colour and roughness, for targets with textures; none: colours alone
};

// Triangles are counter-clockwise as seen from outside. Normals and places in textures are one for each point.
struct Mesh {
  std::vector<vec3> points_mm;
  std::vector<vec3> normals;             // unit
  std::vector<vec2> uv_m;                // metres on the surface
  std::vector<std::uint32_t> triangles;  // three indices each
};

// The part of a body that is of one material.
struct Piece {
  std::size_t material = 0;  // its number among those of the model
  Mesh mesh;
};

// A rigid motion: the point p of a body goes to turn · p + at_mm. Rows of the matrix.
struct Placing {
  std::array<vec3, 3> turn{vec3{1.0, 0.0, 0.0}, vec3{0.0, 1.0, 0.0}, vec3{0.0, 0.0, 1.0}};
  vec3 at_mm{0.0, 0.0, 0.0};

  vec3 turned(vec3 v) const { return {glm::dot(turn[0], v), glm::dot(turn[1], v), glm::dot(turn[2], v)}; }
  vec3 operator()(vec3 p_mm) const { return turned(p_mm) + at_mm; }
  bool operator==(const Placing&) const = default;
};
// First `inner`, then `outer`.
Placing combined(const Placing& outer, const Placing& inner);
// Of a thing that stands somewhere in the world.
Placing placing_of(const studio::Placement& placement);

// An element of a pane or a pavement: a shard, the slab of a pane, a crack in it, a stone, the filling of the joints.
struct Body {
  std::string name;  // THING.ID, unique in the model
  std::string kind;  // "pane", "crack large", "shard standing", "stone whole" …
  std::vector<Piece> pieces;
  Placing placing{};  // meshes are about their own pivot, such as the middle of a shard
  // Its placing at each frame of the model's shot, or nothing where it is not to be seen; empty of what does not move.
  std::vector<std::optional<Placing>> path{};
  bool is_seen = true;  // where no frame is asked for
  // The same for bodies of a thing that are alike but for their placing; only the first of them has its pieces here.
  std::optional<std::size_t> shared{};
};

}  // namespace shatterpave::exporting::shapes
