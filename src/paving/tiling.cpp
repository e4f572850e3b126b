#include "paving/tiling.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/lattice.h"
#include "paving/near_index.h"

namespace shatterpave::paving {

namespace {

// A corner rounded to the lattice lies this near to the side that it stands on: 0.71 µm, the same for the ends of the side.
constexpr double on_side_mm = 0.002;

// The corners of all tiles on the lattice, each once.
std::vector<geometry::LatticePoint> distinct_corners(const std::vector<Tile>& tiles) {
  std::vector<geometry::LatticePoint> corners;
  for (const Tile& tile : tiles) {
    for (const vec2& p : tile.outline_mm) corners.push_back(geometry::to_lattice(p));
  }
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

double longest_side(const std::vector<Tile>& tiles) {
  double longest = 0.0;
  for (const Tile& tile : tiles) {
    for (std::size_t i = 0; i < tile.outline_mm.size(); ++i) {
      longest = std::max(longest, glm::length(tile.outline_mm[(i + 1) % tile.outline_mm.size()] - tile.outline_mm[i]));
    }
  }
  return longest;
}

// Finds the corners that stand on a side.
class Corners {
 public:
  explicit Corners(const std::vector<Tile>& tiles)
      : points_(distinct_corners(tiles)), near_(0.5 * longest_side(tiles) + 1.0, points_.size()) {
    for (const auto& p : points_) near_.add(geometry::to_mm(p));
  }

  std::uint32_t number(vec2 p) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points_, geometry::to_lattice(p)) - points_.begin());
  }
  vec2 at(std::uint32_t corner) const { return geometry::to_mm(points_[corner]); }
  std::size_t count() const { return points_.size(); }

  // Those strictly between two corners, in order from `a`.
  const std::vector<std::uint32_t>& between(std::uint32_t a, std::uint32_t b) {
    found_.clear();
    const vec2 from = at(a);
    const vec2 d = at(b) - from;
    const double along = glm::length(d);
    near_.for_each_near(from + 0.5 * d, [&](std::uint32_t c) {
      const vec2 q = at(c) - from;
      const double t = glm::dot(q, d) / along;
      if (c != a && c != b && t > 0.0 && t < along && std::abs(cross(d, q)) <= on_side_mm * along) found_.emplace_back(t, c);
    });
    std::ranges::sort(found_);
    order_.clear();
    for (const auto& [t, c] : found_) {
      if (order_.empty() || order_.back() != c) order_.push_back(c);
    }
    return order_;
  }

 private:
  std::vector<geometry::LatticePoint> points_;
  NearIndex near_;
  std::vector<std::pair<double, std::uint32_t>> found_;
  std::vector<std::uint32_t> order_;
};

// A side from one corner to the next, seen from one of its ends.
struct HalfSide {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t cell = 0;

  auto ends() const { return std::tuple(from, to); }
};

void find_neighbours(Cells& cells) {
  std::vector<HalfSide> halves;
  halves.reserve(cells.corner.size());
  for (std::size_t c = 0; c < cells.count(); ++c) {
    for (std::size_t s = cells.first[c]; s < cells.first[c + 1]; ++s) {
      const std::size_t next = s + 1 < cells.first[c + 1] ? s + 1 : cells.first[c];
      halves.push_back({cells.corner[s], cells.corner[next], static_cast<std::uint32_t>(c)});
    }
  }
  std::vector<HalfSide> sorted = halves;
  std::ranges::stable_sort(sorted, {}, &HalfSide::ends);
  cells.neighbour.resize(halves.size());
  for (std::size_t s = 0; s < halves.size(); ++s) {
    const auto beyond = std::ranges::lower_bound(sorted, std::tuple(halves[s].to, halves[s].from), {}, &HalfSide::ends);
    const bool found = beyond != sorted.end() && beyond->from == halves[s].to && beyond->to == halves[s].from;
    cells.neighbour[s] = found ? beyond->cell : halves[s].cell;
  }
}

}  // namespace

Cells cells_of(const std::vector<Tile>& tiles) {
  Corners corners(tiles);
  Cells cells;
  cells.first.push_back(0);
  for (const Tile& tile : tiles) {
    const std::size_t count = tile.outline_mm.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t from = corners.number(tile.outline_mm[i]);
      const std::uint32_t to = corners.number(tile.outline_mm[(i + 1) % count]);
      if (from == to) continue;
      cells.corner.push_back(from);
      cells.left_out.push_back(false);
      for (const std::uint32_t tee : corners.between(from, to)) {
        cells.corner.push_back(tee);
        cells.left_out.push_back(true);
      }
    }
    cells.first.push_back(cells.corner.size());
  }
  for (std::uint32_t c = 0; c < corners.count(); ++c) cells.corners.push_back(corners.at(c));
  find_neighbours(cells);
  return cells;
}

}  // namespace shatterpave::paving
