#include "paving/bonds/bond.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "paving/bonds/border.h"
#include "paving/bonds/courses.h"
#include "paving/bonds/patterns.h"
#include "paving/bonds/rings.h"
#include "paving/tiles/cutting.h"

namespace shatterpave::paving {

namespace {

// Stones to the width of an arc or a fan. Small setts of 8 to 10 cm are laid in segmental arcs 1 m to 1.5 m wide.
constexpr double stones_to_a_span = 12.0;

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

// Of a direction without sign, in (−90°, 90°].
vec2 rightwards(vec2 d) { return d.x < 0.0 || (d.x == 0.0 && d.y < 0.0) ? -d : d; }

bool is_rows(Bond bond) { return bond == Bond::running || bond == Bond::stack; }

double span_mm(const Pavement& pavement) {
  const double given = pavement.bonding.span_mm;
  return given > 0.0 ? given : stones_to_a_span * pitch_mm(pavement).x;
}

double row_offset(const Bonding& bonding) { return bonding.bond == Bond::running ? bonding.offset : 0.0; }

// Three by two modules, of which the three may run along the rows or across them.
Stock ashlar_stock(vec2 pitch, double joint_mm, vec2 along) {
  const vec2 joint{joint_mm, joint_mm};
  const vec2 size = vec2{3.0, 2.0} * pitch - joint;
  const vec2 turned = vec2{3.0, 2.0} * vec2{pitch.y, pitch.x} - joint;
  return {size, std::max(size.x * size.y, turned.x * turned.y), turned, along};
}

Pattern pattern_of(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  switch (pavement.bonding.bond) {
    case Bond::running:
    case Bond::stack:
      return rows_pattern(pitch, row_offset(pavement.bonding));
    case Bond::herringbone:
      return herringbone_pattern(pitch);
    case Bond::basket_weave:
      return basket_weave_pattern(pitch);
    case Bond::hexagon:
      return hexagon_pattern(pitch);
    case Bond::segmental_arc:
      return segmental_arc_pattern(pitch, span_mm(pavement));
    case Bond::fan:
      return fan_pattern(pitch, span_mm(pavement));
    case Bond::packed:
    case Bond::ashlar:
    case Bond::crazy:
    case Bond::course:
      break;
  }
  ENSURE(false);
  return {};
}

}  // namespace

Angle axis_angle(vec2 axis) { return Angle::of(rightwards(axis)); }

Angle main_direction(const Pavement& pavement) {
  if (const auto* constant = std::get_if<ConstantDirection>(&pavement.direction)) return constant->angle;
  if (std::holds_alternative<BoundaryDirection>(pavement.direction)) return axis_angle(longest_side(pavement.area.outline));
  if (const auto* guides = std::get_if<GuidesDirection>(&pavement.direction)) {
    return axis_angle(longest_chord(guides->guides_mm));
  }
  return {};
}

std::optional<Pattern> periodic_pattern(const Pavement& pavement) {
  const Bond bond = pavement.bonding.bond;
  if (bond == Bond::ashlar || bond == Bond::crazy || bond == Bond::course) return std::nullopt;
  const bool straight = std::holds_alternative<ConstantDirection>(pavement.direction);
  if (!straight && (is_rows(bond) || bond == Bond::packed)) return std::nullopt;
  return bond == Bond::packed ? rows_pattern(pitch_mm(pavement), 0.0) : pattern_of(pavement);
}

Angle pattern_direction(const Pavement& pavement) {
  const Angle along = main_direction(pavement) + pavement.bonding.turn;
  // Its pattern's own u runs along the steps.
  return pavement.bonding.bond == Bond::herringbone ? along + Angle::degrees(45.0) : along;
}

std::vector<Tile> bond_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t seed) {
  const Bonding& bonding = pavement.bonding;
  if (bonding.bond == Bond::course) {
    Pavement filled = pavement;
    filled.area.holes.clear();
    filled.border = {BorderCourse::stretcher, pavement.stone_mm};
    return border_tiles(filled, {pavement.area});
  }
  const auto* radial = std::get_if<RadialDirection>(&pavement.direction);
  if (radial != nullptr && is_rows(bonding.bond)) {
    return ring_tiles(pitch_mm(pavement), *radial, bonding.start, row_offset(bonding), area);
  }
  const bool straight = std::holds_alternative<ConstantDirection>(pavement.direction);
  if (!straight && is_rows(bonding.bond)) return parallel_tiles(pavement, pitch_mm(pavement), row_offset(bonding), area);
  Placement placement = anchored(area, pattern_direction(pavement).direction());
  if (is_rows(bonding.bond)) placement.origin += bonding.start * pitch_mm(pavement).x * placement.along;
  const Id id(pavement.name);
  if (bonding.bond == Bond::ashlar) return ashlar_tiles(pitch_mm(pavement), placement, area, seed, id);
  if (bonding.bond == Bond::crazy) return crazy_tiles(pitch_mm(pavement), placement, area, seed, id);
  const Pattern pattern = pattern_of(pavement);
  if (bonding.start_mm) {
    placement.origin = vec2{0.0, 0.0};
    placement.origin = *bonding.start_mm - placement.out_of(pattern.tiles.front().outline_mm.front());
  }
  return repeated(pattern, placement, area);
}

Stock stock(const Pavement& pavement) {
  const vec2 stone = pavement.stone_mm;
  const auto of = [](vec2 size_mm) { return Stock{size_mm, size_mm.x * size_mm.y, {}, {1.0, 0.0}}; };
  switch (pavement.bonding.bond) {
    case Bond::running:
    case Bond::stack:
    case Bond::herringbone:
    case Bond::course:
      return of(stone);
    case Bond::packed:
      return of(std::holds_alternative<ConstantDirection>(pavement.direction) ? stone : bent_stock * stone);
    case Bond::ashlar:
      return ashlar_stock(pitch_mm(pavement), pavement.joint_mm, pattern_direction(pavement).direction());
    case Bond::crazy:
      return {2.0 * stone, 2.0 * stone.x * stone.y, {}, {1.0, 0.0}};
    case Bond::basket_weave:
    case Bond::hexagon:
    case Bond::segmental_arc:
    case Bond::fan:
      break;
  }
  Stock largest;
  for (const Tile& tile : pattern_of(pavement).tiles) {
    for (const geometry::Polygon& face : faces_of(tile.outline_mm, pavement.joint_mm)) {
      largest.size_mm = glm::max(largest.size_mm, size_of(extent(face, tile.axis)));
      largest.area_mm2 = std::max(largest.area_mm2, geometry::area(face));
    }
  }
  return largest;
}

double whole_face_mm2(const Pavement& pavement) {
  const double rectangle = pavement.stone_mm.x * pavement.stone_mm.y;
  // A regular hexagon over the square on its width.
  return pavement.bonding.bond == Bond::hexagon ? 0.5 * std::sqrt(3.0) * rectangle : rectangle;
}

}  // namespace shatterpave::paving
