#include "paving/bonds/bond.h"

#include "core/error.h"
#include "paving/bonds/table.h"
#include "paving/tiles/cells.h"
#include "paving/tiles/hand_setting.h"

namespace shatterpave::paving {

namespace {

vec2 longest_side(const geometry::Polygon& outline) {
  vec2 longest{1.0, 0.0};
  double most = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 d = outline[(i + 1) % outline.size()] - outline[i];
    if (glm::dot(d, d) <= most) continue;
    most = glm::dot(d, d);
    longest = d;
  }
  return longest;
}

vec2 longest_chord(const std::vector<std::vector<vec2>>& guides) {
  vec2 longest{1.0, 0.0};
  double most = 0.0;
  for (const auto& guide : guides) {
    const vec2 d = guide.back() - guide.front();
    if (glm::dot(d, d) <= most) continue;
    most = glm::dot(d, d);
    longest = d;
  }
  return longest;
}

// The axis along which vectors lie that may be turned over: of the sum of their squares as complex numbers.
vec2 mean_axis(const std::vector<vec2>& vectors) {
  vec2 twice{0.0, 0.0};
  for (const vec2& v : vectors) {
    const double square = glm::dot(v, v);
    if (square > 0.0) twice += vec2{v.x * v.x - v.y * v.y, 2.0 * v.x * v.y} / square;
  }
  const double length = glm::length(twice);
  return length > 0.0 ? Angle::radians(0.5 * Angle::of(twice).radians()).direction() : vec2{1.0, 0.0};
}

// Of a direction without sign, in (−90°, 90°].
vec2 rightwards(vec2 d) { return d.x < 0.0 || (d.x == 0.0 && d.y < 0.0) ? -d : d; }

bool runs_one_way(const Pavement& pavement) { return std::holds_alternative<ConstantDirection>(pavement.direction); }

}  // namespace

Angle axis_angle(vec2 axis) { return Angle::of(rightwards(axis)); }

Angle main_direction(const Pavement& pavement) {
  if (const auto* constant = std::get_if<ConstantDirection>(&pavement.direction)) return constant->angle;
  if (std::holds_alternative<BoundaryDirection>(pavement.direction)) return axis_angle(longest_side(pavement.area.outline));
  if (const auto* guides = std::get_if<GuidesDirection>(&pavement.direction)) {
    return axis_angle(longest_chord(guides->guides_mm));
  }
  if (const auto* grid = std::get_if<GridDirection>(&pavement.direction)) return axis_angle(mean_axis(grid->vectors));
  return {};
}

// Rows that keep their distance from a line have none to keep it from in a field of vectors.
bool is_bent(const Pavement& pavement) {
  if (has_sizes(pavement)) return true;
  const Bending bending = type_of(pavement).bending;
  if (std::holds_alternative<GridDirection>(pavement.direction)) return bending == Bending::packed;
  return bending != Bending::straight && !runs_one_way(pavement);
}

bool is_drawn(const Pavement& pavement) {
  if (pavement.hand.amount > 0.0) return true;
  const Drawing drawing = type_of(pavement).drawing;
  return drawing == Drawing::always || (drawing == Drawing::where_bent && (!runs_one_way(pavement) || has_sizes(pavement)));
}

double side_bulge(const Pavement& pavement) {
  if (pavement.hand.amount > 0.0) return 0.0;  // its sides are those of its cell (paving/tiles/hand_setting.h)
  return type_of(pavement).bending == Bending::packed && is_bent(pavement) ? largest_bulge : 0.0;
}

std::optional<Pattern> periodic_pattern(const Pavement& pavement) {
  const BondType& type = type_of(pavement);
  if (type.pattern == nullptr || is_bent(pavement)) return std::nullopt;
  return type.pattern(pavement);
}

Angle pattern_direction(const Pavement& pavement) {
  // Scales stand on their corners.
  const Angle on_corners = Angle::degrees(pavement.cell.form == CellForm::scale ? 45.0 : 0.0);
  return main_direction(pavement) + pavement.bonding.turn + type_of(pavement).pattern_turn + on_corners;
}

std::vector<Tile> bond_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t seed) {
  const BondType& type = type_of(pavement);
  ENSURE(type.tiles != nullptr);
  return type.tiles(pavement, area, seed);
}

Stock stock(const Pavement& pavement) {
  return hand_stock(type_of(pavement).stock(pavement), pavement.joint_mm, pavement.hand.amount);
}

double whole_face_mm2(const Pavement& pavement) { return type_of(pavement).whole_face_mm2(pavement); }

}  // namespace shatterpave::paving
