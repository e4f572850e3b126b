#include "measure/field_defects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/parallel.h"
#include "paving/packing/rows.h"

namespace shatterpave::measure {

namespace {

// Squares over the box about the area at most; the sum over the quarter annulus is then within 1 % of the integral.
constexpr double most_squares = 250'000.0;
// Or as fine as a part of a pitch, below which stones cannot follow the field.
constexpr double least_pitches = 0.5;

// Of the field at a place.
struct FieldAt {
  vec2 axis{1.0, 0.0};
  double size = 1.0;
};

// Round the square with these corners, counter-clockwise from the lower left.
FieldDefects around(const std::array<FieldAt, 4>& corners, bool is_cross, double side_mm, vec2 pitch) {
  constexpr std::array<vec2, 4> steps{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
  std::array<vec2, 5> t{corners[0].axis};
  for (std::size_t i = 0; i < 4; ++i) t[i + 1] = paving::turned_like(corners[(i + 1) % 4].axis, t[i], is_cross);
  FieldDefects here;
  // Back at the start the axis is what it was, or is turned about a singular point.
  if (glm::dot(t[4], t[0]) < 0.5) here.singularities = std::abs(cross(t[0], t[4])) > 0.5 ? 1 : 2;
  double columns = 0.0;
  double rows = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const vec2 along = 0.5 * (t[i] + t[i + 1]) / (0.5 * (corners[i].size + corners[(i + 1) % 4].size));
    columns += glm::dot(along, steps[i]);
    rows += glm::dot(left_of(along), steps[i]);
  }
  if (here.singularities > 0) return here;
  here.row_bends = std::abs(columns) * side_mm / pitch.x;
  here.column_bends = std::abs(rows) * side_mm / pitch.y;
  return here;
}

}  // namespace

FieldDefects field_defects(const paving::Pavement& pavement, const paving::DirectionField& field,
                           const paving::SizeField& sizes, const geometry::RegionIndex& area) {
  const vec2 pitch = paving::pitch_mm(pavement);
  const geometry::Box box = area.box();
  const vec2 size = box.high - box.low;
  const double side = std::max({least_pitches * std::min(pitch.x, pitch.y), std::sqrt(size.x * size.y / most_squares),
                                std::max(size.x, size.y) / most_squares});
  const auto columns = static_cast<std::size_t>(size.x / side) + 1;
  const auto rows = static_cast<std::size_t>(size.y / side) + 1;
  std::vector<FieldDefects> of_row(rows);
  parallel_for(rows, [&](std::size_t row) {
    const auto corner = [&](std::size_t c, std::size_t r) {
      return box.low + side * vec2{static_cast<double>(c), static_cast<double>(r)};
    };
    const auto field_at = [&](vec2 place) { return FieldAt{field.axis(place), sizes.at(place)}; };
    for (std::size_t c = 0; c < columns; ++c) {
      if (!area.contains(corner(c, row) + vec2{0.5 * side, 0.5 * side})) continue;
      const FieldDefects here = around({field_at(corner(c, row)), field_at(corner(c + 1, row)),
                                        field_at(corner(c + 1, row + 1)), field_at(corner(c, row + 1))},
                                       field.is_cross(), side, pitch);
      of_row[row].row_bends += here.row_bends;
      of_row[row].column_bends += here.column_bends;
      of_row[row].singularities += here.singularities;
    }
  });
  FieldDefects all;
  for (const FieldDefects& row : of_row) {
    all.row_bends += row.row_bends;
    all.column_bends += row.column_bends;
    all.singularities += row.singularities;
  }
  // About the centre of circles the field turns too fast for a square to tell: once all round. There is no other such place.
  if (const auto* radial = std::get_if<paving::RadialDirection>(&pavement.direction)) {
    all.singularities = area.contains(radial->centre_mm) ? 4 : 0;
  }
  return all;
}

}  // namespace shatterpave::measure
