#include "measure/cell_figures.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "measure/distribution.h"

namespace shatterpave::measure {

namespace {

// Cosine of four times the angle between two directions, the second a unit vector.
double cosine_of_four(vec2 side, vec2 axis) {
  const double along = glm::dot(side, axis);
  const double across = cross(axis, side);
  const double square = along * along + across * across;
  const double twice = (along * along - across * across) / square;
  return 2.0 * twice * twice - 1.0;
}

}  // namespace

CellFigures cell_figures(std::span<const InnerCell> cells, const paving::DirectionField& field) {
  CellFigures figures;
  figures.counted = cells.size();
  std::vector<double> areas;
  areas.reserve(cells.size());
  Distribution logarithms;
  Distribution neighbours;
  std::size_t four = 0;
  std::size_t five = 0;
  std::size_t six = 0;
  double length_mm = 0.0;
  for (const InnerCell& cell : cells) {
    const geometry::Polygon& outline = *cell.outline_mm;
    neighbours.add(static_cast<double>(cell.neighbours));
    four += cell.neighbours == 4 ? 1U : 0U;
    five += cell.neighbours == 5 ? 1U : 0U;
    six += cell.neighbours == 6 ? 1U : 0U;
    areas.push_back(geometry::area(outline));
    logarithms.add(logarithm(areas.back()));
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const vec2 from = outline[i];
      const vec2 side = outline[(i + 1) % outline.size()] - from;
      const double length = glm::length(side);
      if (length == 0.0) continue;
      figures.order += length * cosine_of_four(side, field.axis(from + 0.5 * side));
      length_mm += length;
    }
  }
  if (cells.empty()) return figures;
  figures.neighbours_mean = neighbours.mean();
  figures.four_percent = percentage(four, cells.size());
  figures.five_percent = percentage(five, cells.size());
  figures.six_percent = percentage(six, cells.size());
  figures.area_median_mm2 = percentile(areas, 0.5);
  figures.area_ln_spread = logarithms.deviation();
  figures.order = length_mm > 0.0 ? figures.order / length_mm : 0.0;
  return figures;
}

}  // namespace shatterpave::measure
