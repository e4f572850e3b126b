/// \file
/// What becomes of a pavement: its stones. Plain values.
///
/// A pavement lies in the plane of its plan: x to the right (east), y up on the plan (north), mm. In space z points up, and
/// without fall and level the outlines of the stones lie at z = 0.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <shatterpave/geometry.h>

namespace shatterpave {

/// Whether a stone is whole or cut.
enum class StoneKind {
  whole,  ///< As it was bought.
  cut,    ///< The outline or a hole took part of it.
};

/// The word that files use for it, "whole" or "cut".
std::string_view name_of(StoneKind kind);

/// The part of a pavement that a stone belongs to. More may come with a minor version.
enum class StonePart {
  field,   ///< The bond.
  border,  ///< The course along the border.
  kerb,    ///< A kerb along the outline, outside: a pavement of its own in the model.
  step,    ///< A step of a flight: each is a pavement of its own in the model.
};

/// The word that files use for it, such as "border".
std::string_view name_of(StonePart part);

/// A stone in its place. Stones of a pavement do not overlap and lie within its area, to the µm.
struct Stone {
  int id = 0;                         ///< Unique in its pavement, rising; those of stones that are missing are left out.
  StoneKind kind = StoneKind::whole;  ///< Whether it was cut.
  StonePart part = StonePart::field;  ///< The part that it belongs to.
  Polygon outline_mm;                 ///< Its face before edges are rounded: counter-clockwise, in whole µm.
  double angle_deg = 0.0;             ///< Of the row it lies in, counter-clockwise from +x.

  /// Member by member.
  bool operator==(const Stone&) const = default;
};

/// How finely a stone's surface is made.
struct StoneMeshOptions {
  double step_mm = 5.0;  ///< Sides of triangles, about; 0.1 … 1000. 1 to 2 shows the relief.
  bool relief = true;    ///< With the relief that the scene asks for.

  /// Member by member.
  bool operator==(const StoneMeshOptions&) const = default;
};

/// The upper surface of a stone, as it lies: worn, sunk and leaning with the ground. Open below, where the filling of the
/// joints hides it. Seen from above no point is outside the stone's outline by more than 1.5 % of the root of its area.
struct StoneMesh {
  std::vector<Point3> vertices_mm;  ///< z up.
  std::vector<Point3> normals;      ///< One a vertex, of unit length, up.
  std::vector<Triangle> triangles;  ///< Counter-clockwise from above.

  /// Member by member.
  bool operator==(const StoneMesh&) const = default;
};

/// A laid pavement.
struct Pavement {
  std::string name;           ///< Unique in its model. The kerb of NAME is NAME_kerb.
  Region area_mm;             ///< The paved area.
  std::vector<Stone> stones;  ///< By id.

  /// Member by member.
  bool operator==(const Pavement&) const = default;
};

}  // namespace shatterpave
