// A row of a wall is a polyline in the plane. Each row is followed to where it ends, a place in columns and parts of columns;
// then the columns of the zone are shared out anew along each row, up to its own place, so that rows stay where they were.

#include "glass/gaps/crack_walls.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/segment_distance.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

namespace {

// Rows that keep less than this, in columns, of the zone lose it.
constexpr double least_rest = 0.2;
// Steps back until a row is clear: enough for barriers that it meets at one in forty.
constexpr int most_steps_back = 80;

vec2 plan(vec3 point) { return {point.x, point.y}; }

// The point of row `row` at `place` columns.
vec3 at(const Walls& walls, const std::vector<vec3>& wall, std::size_t row, double place) {
  const std::size_t last = walls.columns() - 1;
  const std::size_t column = std::min(static_cast<std::size_t>(std::max(0.0, place)), last == 0 ? 0 : last - 1);
  const vec3 a = wall[column * walls.rows + row];
  const vec3 b = wall[std::min(column + 1, last) * walls.rows + row];
  return a + (place - static_cast<double>(column)) * (b - a);
}

// Where z is between the rows of a column: the point there, of the border above and below.
vec2 point_at_height(const Walls& walls, const std::vector<vec3>& wall, std::size_t column, double z) {
  const auto* rows = &wall[column * walls.rows];
  for (std::size_t r = 0; r + 1 < walls.rows; ++r) {
    const double a = rows[r].z;
    const double b = rows[r + 1].z;
    if ((z - a) * (z - b) > 0.0 || a == b) continue;
    return plan(rows[r]) + (z - a) / (b - a) * (plan(rows[r + 1]) - plan(rows[r]));
  }
  const double first = std::abs(z - rows[0].z);
  return plan(first < std::abs(z - rows[walls.rows - 1].z) ? rows[0] : rows[walls.rows - 1]);
}

// The least u in [0, 1] at which a + u (b - a) lies on one of the pieces; above 1 if at none.
double first_meeting(vec2 a, vec2 b, const Pieces& pieces) {
  double first = 2.0;
  for (const auto& [p, q] : pieces) {
    const double across = cross(b - a, q - p);
    if (across == 0.0) continue;
    const double u = cross(p - a, q - p) / across;
    const double v = cross(p - a, b - a) / across;
    if (u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0) first = std::min(first, u);
  }
  return first;
}

double distance(vec2 point, const Pieces& pieces) {
  double nearest = 1e300;
  for (const auto& [p, q] : pieces) nearest = std::min(nearest, geometry::distance_to_segment(point, p, q));
  return nearest;
}

struct RowEnd {
  double first = 0.0;  // columns: where the search starts
  double last = 0.0;   // where the row ends if it meets nothing
  double clearance_mm = 0.0;
};

double end_of_row(const Walls& walls, const std::vector<vec3>& wall, std::size_t row, const RowEnd& end, const Pieces& pieces) {
  double place = end.last;
  for (auto column = static_cast<std::size_t>(end.first); column + 1 < walls.columns(); ++column) {
    const double u = first_meeting(plan(wall[column * walls.rows + row]), plan(wall[(column + 1) * walls.rows + row]), pieces);
    if (u > 1.0) continue;
    place = static_cast<double>(column) + u;
    break;
  }
  for (int step = 0; step < most_steps_back && place > end.first; ++step) {
    if (distance(plan(at(walls, wall, row, place)), pieces) >= end.clearance_mm) break;
    const auto column = static_cast<std::size_t>(std::ceil(place) - 1.0);
    const double length = glm::length(at(walls, wall, row, static_cast<double>(column) + 1.0) -
                                      at(walls, wall, row, static_cast<double>(column)));
    place = std::max(end.first, place - 0.5 * end.clearance_mm / std::max(length, end.clearance_mm));
  }
  return place;
}

// The walls with the places, in columns, at which their rows end, the two walls alike: so they lie side by side as they did.
// Columns up to `first` stay.
void end_rows(Walls& walls, std::size_t first, const std::vector<double>& places) {
  const auto start = static_cast<double>(first);
  ENSURE(!places.empty());
  const double least = *std::ranges::min_element(places);
  const auto count = static_cast<std::size_t>(std::ceil(*std::ranges::max_element(places) - start));
  Walls zone{walls.rows, {}, {}, {}};
  for (std::size_t k = 1; k <= count && least > start + least_rest; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(count);
    double along = 0.0;
    for (std::size_t r = 0; r < walls.rows; ++r) {
      const double place = start + part * (places[r] - start);
      zone.left.push_back(at(walls, walls.left, r, place));
      zone.right.push_back(at(walls, walls.right, r, place));
      const auto column = std::min(static_cast<std::size_t>(place), walls.columns() - 2);
      const double step = walls.along_mm[column + 1] - walls.along_mm[column];
      along = std::max(along, walls.along_mm[column] + (place - static_cast<double>(column)) * step);
    }
    zone.along_mm.push_back(along);
  }
  const auto kept = static_cast<std::ptrdiff_t>(first + 1);
  const std::ptrdiff_t points = kept * static_cast<std::ptrdiff_t>(walls.rows);
  walls.left.erase(walls.left.begin() + points, walls.left.end());
  walls.right.erase(walls.right.begin() + points, walls.right.end());
  walls.along_mm.erase(walls.along_mm.begin() + kept, walls.along_mm.end());
  walls.left.insert(walls.left.end(), zone.left.begin(), zone.left.end());
  walls.right.insert(walls.right.end(), zone.right.begin(), zone.right.end());
  walls.along_mm.insert(walls.along_mm.end(), zone.along_mm.begin(), zone.along_mm.end());
}

// One more column, straight on.
void lead_on(Walls& walls, double length_mm) {
  const std::size_t last = walls.columns() - 1;
  const auto middle = [&](std::size_t column) {
    const std::size_t row = column * walls.rows + walls.rows / 2;
    return 0.5 * (plan(walls.left[row]) + plan(walls.right[row]));
  };
  const vec2 on = length_mm * glm::normalize(middle(last) - middle(last - 1));
  for (std::size_t r = 0; r < walls.rows; ++r) {
    walls.left.push_back(walls.left[last * walls.rows + r] + vec3{on, 0.0});
    walls.right.push_back(walls.right[last * walls.rows + r] + vec3{on, 0.0});
  }
  walls.along_mm.push_back(walls.along_mm[last] + length_mm);
}

std::size_t first_column_of_zone(const Walls& walls, double zone_mm) {
  std::size_t column = walls.columns() - 1;
  while (column > 0 && walls.along_mm.back() - walls.along_mm[column] < zone_mm) --column;
  return column;
}

// Heights at which a row's end is tried: its own, those on the way to its neighbours, and theirs if the barrier is uneven.
std::vector<double> heights(const Walls& walls, std::size_t row, bool uneven) {
  const std::size_t column = (walls.columns() - 1) * walls.rows;
  const double z = walls.left[column + row].z;
  std::vector<double> result{z};
  for (const std::size_t other : {row == 0 ? row : row - 1, std::min(row + 1, walls.rows - 1)}) {
    if (other == row) continue;
    result.push_back(0.5 * (z + walls.left[column + other].z));
    if (uneven) result.push_back(walls.left[column + other].z);
  }
  return result;
}

}  // namespace

void append_slice(const Walls& walls, double z_mm, double from_mm, double to_mm, Pieces& pieces) {
  const auto near = [&](std::size_t column) { return walls.along_mm[column] >= from_mm && walls.along_mm[column] <= to_mm; };
  for (std::size_t column = 0; column < walls.columns(); ++column) {
    if (!near(column)) continue;
    const vec2 left = point_at_height(walls, walls.left, column, z_mm);
    const vec2 right = point_at_height(walls, walls.right, column, z_mm);
    if (column == 0 || column + 1 == walls.columns()) pieces.emplace_back(left, right);
    if (column + 1 == walls.columns() || !near(column + 1)) continue;
    pieces.emplace_back(left, point_at_height(walls, walls.left, column + 1, z_mm));
    pieces.emplace_back(right, point_at_height(walls, walls.right, column + 1, z_mm));
  }
}

void cut_end(Walls& walls, const Barrier& barrier, double zone_mm, double clearance_mm, bool reach) {
  const std::size_t first = first_column_of_zone(walls, zone_mm);
  const RowEnd end{static_cast<double>(first), static_cast<double>(walls.columns() - 1), clearance_mm};
  if (reach) lead_on(walls, zone_mm);
  std::vector<double> places(walls.rows, static_cast<double>(walls.columns()));
  for (std::size_t r = 0; r < walls.rows; ++r) {
    for (const double z : heights(walls, r, barrier.uneven)) {
      const Pieces pieces = barrier.pieces(z);
      for (const std::vector<vec3>* wall : {&walls.left, &walls.right}) {
        places[r] = std::min(places[r], end_of_row(walls, *wall, r, end, pieces));
      }
    }
  }
  // Columns stay as far as all rows go on, so that the walls bend where they did.
  ENSURE(!places.empty());
  const double least = *std::ranges::min_element(places);
  const bool early = least > static_cast<double>(first) + 1.0 + least_rest;
  end_rows(walls, early ? static_cast<std::size_t>(least - least_rest) : first, places);
}

void cut_back(Walls& walls, const std::vector<double>& lags_mm) {
  std::vector<double> places(walls.rows);
  for (std::size_t r = 0; r < walls.rows; ++r) {
    const double along = std::max(walls.along_mm.front(), walls.along_mm.back() - lags_mm[r]);
    const auto next = std::ranges::lower_bound(walls.along_mm, along) - walls.along_mm.begin();
    const auto column = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, next)) - 1;
    const double part = (along - walls.along_mm[column]) / (walls.along_mm[column + 1] - walls.along_mm[column]);
    places[r] = static_cast<double>(column) + part;
  }
  const double longest = *std::ranges::max_element(lags_mm);
  end_rows(walls, first_column_of_zone(walls, 2.0 * longest), places);
}

void reverse(Walls& walls, double length_mm) {
  const auto reversed = [&](const std::vector<vec3>& wall) {
    std::vector<vec3> result;
    for (std::size_t column = walls.columns(); column-- > 0;) {
      const auto begin = wall.begin() + static_cast<std::ptrdiff_t>(column * walls.rows);
      result.insert(result.end(), begin, begin + static_cast<std::ptrdiff_t>(walls.rows));
    }
    return result;
  };
  walls.left = reversed(walls.left);
  walls.right = reversed(walls.right);
  for (double& along : walls.along_mm) along = length_mm - along;
  std::ranges::reverse(walls.along_mm);
}

}  // namespace shatterpave::glass
