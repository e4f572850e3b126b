// Parts start as the triangles of the region. The two neighbours that leave the least of their common hull empty become one,
// until every hull would leave too much.
#include "glass/shards/convex_parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "geometry/hull.h"
#include "geometry/triangulation.h"

namespace shatterpave::glass {

namespace {

using geometry::Polygon;

struct Part {
  Polygon hull;
  double filled_mm2 = 0.0;
  std::set<std::size_t> neighbours;
  bool is_there = true;
};

struct Union {
  Polygon hull;
  double empty_mm2 = 0.0;
  double hull_mm2 = 0.0;
};

Union united(const Part& a, const Part& b) {
  Polygon points = a.hull;
  points.insert(points.end(), b.hull.begin(), b.hull.end());
  Union result{geometry::convex_hull(points), 0.0, 0.0};
  result.hull_mm2 = geometry::area(result.hull);
  result.empty_mm2 = result.hull_mm2 - a.filled_mm2 - b.filled_mm2;
  return result;
}

std::vector<Part> triangles(const geometry::Region& region) {
  const auto rings = geometry::lattice_rings(region);
  std::vector<vec2> vertices;
  for (const auto& ring : rings)
    std::ranges::transform(ring, std::back_inserter(vertices), [](auto p) { return geometry::to_mm(p); });
  std::vector<Part> parts;
  std::map<std::array<std::size_t, 2>, std::size_t> part_at;  // by directed edge
  for (const auto& [a, b, c] : geometry::triangulation(rings)) {
    const std::size_t number = parts.size();
    Part part{{vertices[a], vertices[b], vertices[c]}, 0.0, {}, true};
    part.filled_mm2 = geometry::area(part.hull);
    parts.push_back(std::move(part));
    for (const auto& edge : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      part_at[edge] = number;
      const auto other = part_at.find({edge[1], edge[0]});
      if (other == part_at.end()) continue;
      parts[number].neighbours.insert(other->second);
      parts[other->second].neighbours.insert(number);
    }
  }
  return parts;
}

// Makes `a` the union of both.
void merge(std::vector<Part>& parts, std::size_t a, std::size_t b, Union whole) {
  Part& kept = parts[a];
  Part& gone = parts[b];
  kept.hull = std::move(whole.hull);
  kept.filled_mm2 += gone.filled_mm2;
  gone.is_there = false;
  for (const std::size_t neighbour : gone.neighbours) {
    parts[neighbour].neighbours.erase(b);
    if (neighbour == a) continue;
    parts[neighbour].neighbours.insert(a);
    kept.neighbours.insert(neighbour);
  }
}

// Of neighbours, the lesser index first.
using Unions = std::map<std::array<std::size_t, 2>, Union>;

void consider(const std::vector<Part>& parts, std::size_t a, std::size_t b, Unions& unions) {
  unions[{std::min(a, b), std::max(a, b)}] = united(parts[a], parts[b]);
}

// The one that leaves least empty, of those that leave little enough.
Unions::iterator best_of(Unions& unions, double excess, double excess_mm2) {
  auto best = unions.end();
  for (auto candidate = unions.begin(); candidate != unions.end(); ++candidate) {
    const Union& whole = candidate->second;
    if (whole.empty_mm2 > excess * whole.hull_mm2 + excess_mm2) continue;
    if (best == unions.end() || whole.empty_mm2 < best->second.empty_mm2) best = candidate;
  }
  return best;
}

}  // namespace

std::vector<Polygon> convex_parts(const geometry::Region& region, double excess, double excess_mm2) {
  std::vector<Part> parts = triangles(region);
  Unions unions;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const std::size_t neighbour : parts[i].neighbours) {
      if (i < neighbour) consider(parts, i, neighbour, unions);
    }
  }
  for (auto best = best_of(unions, excess, excess_mm2); best != unions.end(); best = best_of(unions, excess, excess_mm2)) {
    const std::array<std::size_t, 2> pair = best->first;
    merge(parts, pair[0], pair[1], std::move(best->second));
    std::erase_if(unions, [&pair](const auto& entry) {
      return std::ranges::any_of(entry.first, [&pair](std::size_t part) { return part == pair[0] || part == pair[1]; });
    });
    for (const std::size_t neighbour : parts[pair[0]].neighbours) consider(parts, pair[0], neighbour, unions);
  }
  std::vector<Polygon> hulls;
  for (Part& part : parts) {
    if (part.is_there) hulls.push_back(std::move(part.hull));
  }
  return hulls;
}

}  // namespace shatterpave::glass
