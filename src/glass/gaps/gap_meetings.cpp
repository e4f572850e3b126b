#include "glass/gaps/gap_meetings.h"

#include <algorithm>
#include <array>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <utility>

#include "core/parallel.h"
#include "geometry/lattice.h"

namespace shatterpave::glass {

namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Triangle = std::array<vec3, 3>;  // in steps of the lattice: whole numbers
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Corner>;

vec3 in_steps(vec3 mm) { return glm::round(geometry::lattice_per_mm * mm); }

// Six times the volume of a tetrahedron. Exact for corners less than 10⁵ steps apart, 100 mm.
double volume(vec3 a, vec3 b, vec3 c, vec3 d) { return glm::dot(glm::cross(b - a, c - a), d - a); }

bool on_two_sides(double a, double b) { return (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0); }

bool passes_through(vec3 p, vec3 q, const Triangle& t) {
  if (!on_two_sides(volume(t[0], t[1], t[2], p), volume(t[0], t[1], t[2], q))) return false;
  const double first = volume(t[0], t[1], p, q);
  const double second = volume(t[1], t[2], p, q);
  const double third = volume(t[2], t[0], p, q);
  return !on_two_sides(first, second) && !on_two_sides(second, third) && !on_two_sides(third, first);
}

bool boxes_part(const Triangle& a, const Triangle& b) {
  const vec3 low_a = glm::min(a[0], glm::min(a[1], a[2]));
  const vec3 high_a = glm::max(a[0], glm::max(a[1], a[2]));
  const vec3 low_b = glm::min(b[0], glm::min(b[1], b[2]));
  const vec3 high_b = glm::max(b[0], glm::max(b[1], b[2]));
  return glm::any(glm::lessThan(high_a, low_b)) || glm::any(glm::lessThan(high_b, low_a));
}

bool meet(const Triangle& a, const Triangle& b) {
  if (boxes_part(a, b)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (passes_through(a.at(i), a.at((i + 1) % 3), b) || passes_through(b.at(i), b.at((i + 1) % 3), a)) return true;
  }
  return false;
}

// Columns of a wall of so many rows, from the first to before the end.
std::vector<vec3> columns_of(const std::vector<vec3>& wall, std::size_t rows, std::size_t first, std::size_t end) {
  return {wall.begin() + static_cast<std::ptrdiff_t>(first * rows), wall.begin() + static_cast<std::ptrdiff_t>(end * rows)};
}

// The stretch as a surface of two columns.
CrackSurface stretch_of(const CrackSurface& surface, std::size_t column) {
  const auto cut = [&](const std::vector<vec3>& wall) { return columns_of(wall, surface.rows, column, column + 2); };
  return {surface.crack, surface.impact, surface.rows, cut(surface.left_mm), cut(surface.right_mm), {}};
}

std::vector<Triangle> triangles_of(const CrackSurface& stretch) {
  const std::size_t half = stretch.left_mm.size();
  const auto point = [&](std::size_t i) { return in_steps(i < half ? stretch.left_mm[i] : stretch.right_mm[i - half]); };
  const std::vector<std::size_t> corners = closed_triangles(stretch);
  std::vector<Triangle> triangles;
  triangles.reserve(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    triangles.push_back({point(corners[i]), point(corners[i + 1]), point(corners[i + 2])});
  }
  return triangles;
}

Box box_of(const CrackSurface& stretch) {
  vec3 low = in_steps(stretch.left_mm.front());
  vec3 high = low;
  for (const std::vector<vec3>* wall : {&stretch.left_mm, &stretch.right_mm}) {
    for (const vec3& mm : *wall) {
      low = glm::min(low, in_steps(mm));
      high = glm::max(high, in_steps(mm));
    }
  }
  return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

bool meet(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  return std::ranges::any_of(
      a, [&](const Triangle& s) { return std::ranges::any_of(b, [&](const Triangle& t) { return meet(s, t); }); });
}

Walls columns_of(const Walls& walls, std::size_t first, std::size_t end) {
  const auto cut = [&](const std::vector<vec3>& wall) { return columns_of(wall, walls.rows, first, end); };
  const auto along = walls.along_mm.begin();
  return {walls.rows,
          cut(walls.left),
          cut(walls.right),
          {along + static_cast<std::ptrdiff_t>(first), along + static_cast<std::ptrdiff_t>(end)}};
}

// What is left of walls without the stretches that are `out`.
void append_rest(const Walls& walls, const std::vector<bool>& out, std::vector<Walls>& rest) {
  for (std::size_t c = 0; c < out.size();) {
    std::size_t end = c;
    while (end < out.size() && !out[end]) ++end;
    if (end > c) rest.push_back(columns_of(walls, c, end + 1));
    c = end + 1;
  }
}

}  // namespace

std::vector<GapStretch> meeting_stretches(const std::vector<CrackSurface>& surfaces) {
  std::vector<GapStretch> all;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    for (std::size_t c = 0; c + 1 < surfaces[s].columns(); ++c) all.push_back({s, c});
  }
  const auto stretch = [&](std::size_t i) { return stretch_of(surfaces[all[i].surface], all[i].column); };
  using Entry = std::pair<Box, std::size_t>;
  std::vector<Entry> entries(all.size());
  parallel_for(all.size(), [&](std::size_t i) { entries[i] = {box_of(stretch(i)), i}; });
  const bgi::rtree<Entry, bgi::linear<16>> tree(entries);
  std::vector<char> meets(all.size(), 0);
  parallel_for(all.size(), [&](std::size_t i) {
    const std::size_t own = all[i].surface;
    std::vector<Triangle> triangles;
    for (auto entry = tree.qbegin(bgi::intersects(entries[i].first)); entry != tree.qend() && meets[i] == 0; ++entry) {
      const std::size_t other = all[entry->second].surface;
      if (other >= own || surfaces[other].crack == surfaces[own].crack) continue;
      if (triangles.empty()) triangles = triangles_of(stretch(i));
      if (meet(triangles, triangles_of(stretch(entry->second)))) meets[i] = 1;
    }
  });
  std::vector<GapStretch> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (meets[i] != 0) result.push_back(all[i]);
  }
  return result;
}

std::vector<std::vector<Walls>> without_meetings(std::vector<std::vector<Walls>> of_paths, const SurfaceOf& surface_of) {
  while (true) {
    std::vector<CrackSurface> surfaces;
    for (std::size_t path = 0; path < of_paths.size(); ++path) {
      for (const Walls& walls : of_paths[path]) surfaces.push_back(surface_of(path, walls));
    }
    const std::vector<GapStretch> meeting = meeting_stretches(surfaces);
    if (meeting.empty()) return of_paths;
    std::size_t surface = 0;
    std::size_t next = 0;
    for (std::vector<Walls>& own : of_paths) {
      std::vector<Walls> rest;
      for (const Walls& walls : own) {
        std::vector<bool> out(walls.columns() - 1, false);
        for (; next < meeting.size() && meeting[next].surface == surface; ++next) {
          const std::size_t column = meeting[next].column;
          out[column - std::min<std::size_t>(column, 1)] = out[column] = out[std::min(column + 1, out.size() - 1)] = true;
        }
        append_rest(walls, out, rest);
        ++surface;
      }
      own = std::move(rest);
    }
  }
}

}  // namespace shatterpave::glass
