#include "glass/network_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/lattice.h"
#include "geometry/predicates.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;

struct Piece {
  LatticePoint a;
  LatticePoint b;
};

std::vector<Piece> pieces(const CrackNetwork& network) {
  std::vector<Piece> all;
  for (const Crack& crack : network.cracks) {
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      all.push_back({geometry::to_lattice(crack.points_mm[i - 1]), geometry::to_lattice(crack.points_mm[i])});
    }
  }
  return all;
}

// Whether the boxes about two pieces have a point in common; pieces whose boxes have none cannot touch.
bool boxes_meet(const Piece& p, const Piece& q) {
  const auto apart = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  return !apart(p.a.x, p.b.x, q.a.x, q.b.x) && !apart(p.a.y, p.b.y, q.a.y, q.b.y);
}

double distance_to_outline(vec2 p, const geometry::Polygon& outline) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 a = outline[i];
    const vec2 along = outline[(i + 1) % outline.size()] - a;
    const double foot = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
    least = std::min(least, glm::length(p - a - foot * along));
  }
  return least;
}

bool has_vertex(const Crack& crack, vec2 p) { return std::ranges::find(crack.points_mm, p) != crack.points_mm.end(); }

void check_crack(const Crack& crack, const CrackNetwork& network, const geometry::Polygon& outline,
                 std::vector<std::string>& faults) {
  const auto fault = [&](const char* what) { faults.push_back(fmt::format("crack {}: {}", crack.id, what)); };
  if (crack.points_mm.size() < 2) return fault("fewer than two points");
  for (const vec2& p : crack.points_mm) {
    if (p != geometry::on_lattice(p)) fault("a vertex off the lattice");
    if (!geometry::contains(outline, p)) fault("a vertex outside the pane");
  }
  if (std::ranges::adjacent_find(crack.points_mm) != crack.points_mm.end()) fault("a vertex twice running");
  if (crack.kind != CrackKind::circular &&
      crack.points_mm.front() != network.impacts.at(static_cast<std::size_t>(crack.impact)).at_mm) {
    fault("does not start at its impact");
  }
  const vec2 tip = crack.points_mm.back();
  if (crack.end.at == CrackEnd::At::edge && distance_to_outline(tip, outline) > 0.001 + 1e-9) fault("ends off the edge");
  if (crack.end.at == CrackEnd::At::crack) {
    if (!crack.end.crack || *crack.end.crack < 0 || *crack.end.crack >= static_cast<int>(network.cracks.size())) {
      fault("ends on no crack");
    } else if (!has_vertex(network.cracks[static_cast<std::size_t>(*crack.end.crack)], tip)) {
      fault("ends beside a vertex of the other crack");
    }
  } else if (crack.end.crack) {
    fault("names a crack that it does not end on");
  }
}

}  // namespace

int crossings(const CrackNetwork& network) {
  const std::vector<Piece> all = pieces(network);
  int count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes_meet(all[i], all[j]) && geometry::segments_cross(all[i].a, all[i].b, all[j].a, all[j].b)) ++count;
    }
  }
  return count;
}

std::vector<std::string> faults(const CrackNetwork& network, const geometry::Polygon& outline) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < network.cracks.size(); ++i) {
    if (network.cracks[i].id != static_cast<int>(i))
      found.push_back(fmt::format("crack {}: not its place", network.cracks[i].id));
    check_crack(network.cracks[i], network, outline, found);
  }
  // A piece may touch another only in a common vertex: never in the middle of one.
  const std::vector<Piece> all = pieces(network);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i == j || !boxes_meet(all[i], all[j])) continue;
      const auto middle = [&](LatticePoint p) {
        return p != all[j].a && p != all[j].b && geometry::on_segment(all[j].a, all[j].b, p);
      };
      if (middle(all[i].a) || middle(all[i].b)) found.push_back(fmt::format("piece {} touches the middle of {}", i, j));
    }
  }
  if (const int count = crossings(network); count > 0) found.push_back(fmt::format("{} crossings", count));
  return found;
}

}  // namespace shatterpave::glass
