#include "paving/gaps.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/near_points.h"
#include "paving/pattern.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;

// What remains is looked for square by square; in pitches, by trial: with larger ones clipping takes longer than linear time.
constexpr double square_pitches = 8.0;
// Of a stone: smaller gaps are slivers between bends.
constexpr double least_gap = 0.004;
// Slivers that come of rounding are narrower than this.
constexpr double sliver_mm = 0.02;

// The pieces of a gap, none much longer than a stone.
void append_gap(const Region& gap, vec2 pitch, vec2 axis, std::vector<Tile>& tiles) {
  if (geometry::area(gap) < least_gap * pitch.x * pitch.y) return;
  const Box box = geometry::bounding_box(gap.outline);
  const vec2 size = box.high - box.low;
  const double most = 1.5 * std::max(pitch.x, pitch.y);
  if (gap.holes.empty() && std::max(size.x, size.y) <= most) {
    tiles.push_back({gap.outline, axis});
    return;
  }
  const bool upright = size.x >= size.y;
  const vec2 middle = geometry::on_lattice(0.5 * (box.low + box.high));
  const vec2 split_high = upright ? vec2{middle.x, box.high.y} : vec2{box.high.x, middle.y};
  const vec2 split_low = upright ? vec2{middle.x, box.low.y} : vec2{box.low.x, middle.y};
  for (const auto& [low, high] : {std::pair{box.low, split_high}, std::pair{split_low, box.high}}) {
    const Polygon half{low, {high.x, low.y}, high, {low.x, high.y}};
    for (const Region& part : geometry::intersection(half, gap)) append_gap(part, pitch, axis, tiles);
  }
}

// About its middle, so that it covers slivers beside it.
Polygon grown(const Polygon& polygon) {
  const Box box = geometry::bounding_box(polygon);
  const vec2 middle = geometry::centroid(polygon);
  const double factor = 1.0 + 4.0 * sliver_mm / std::min(box.high.x - box.low.x, box.high.y - box.low.y);
  Polygon result = polygon;
  for (vec2& p : result) p = geometry::on_lattice(middle + factor * (p - middle));
  return result;
}

// One by one: where many polygons touch all but exactly, clipping them off at once can go wrong.
std::vector<Region> rest_of(const Region& region, const std::vector<Polygon>& taken) {
  std::vector<Region> rest{region};
  for (const Polygon& tile : taken) {
    std::vector<Region> next;
    for (Region& part : rest) {
      if (geometry::boxes_meet(geometry::bounding_box(tile), geometry::bounding_box(part.outline))) {
        for (Region& left : geometry::difference(part, {tile})) next.push_back(std::move(left));
      } else {
        next.push_back(std::move(part));
      }
    }
    rest = std::move(next);
  }
  return rest;
}

// What tiles leave of the region. Slivers, of which there are many, would make clipping slow: so it is first sought beside
// tiles that are somewhat too large, and made exact where something is found.
std::vector<Region> gaps_of(const Region& region, const std::vector<Polygon>& taken, double least_mm2) {
  std::vector<Polygon> larger(taken.size());
  std::ranges::transform(taken, larger.begin(), grown);
  std::vector<Region> gaps;
  for (const Region& rough : geometry::difference(region, larger)) {
    if (geometry::area(rough) < 0.5 * least_mm2) continue;
    for (const Region& room : geometry::offset(rough, 8.0 * sliver_mm)) {
      for (const Region& inside : geometry::intersection(room.outline, region)) {
        for (Region& gap : rest_of(inside, taken)) {
          if (geometry::area(gap) >= least_mm2) gaps.push_back(std::move(gap));
        }
      }
    }
  }
  return gaps;
}

// The region in squares, with the tiles that have a part in each.
class Squares {
 public:
  Squares(const std::vector<Tile>& tiles, const geometry::RegionIndex& index, double step)
      : grid_{index.box().low, {step, 0.0}, {0.0, step}},
        squares_(near_points(grid_, index, 1.5 * step)),
        inside_(squares_.size()) {
    for (std::size_t t = 0; t < tiles.size(); ++t) add(tiles[t].outline_mm, static_cast<std::uint32_t>(t));
  }

  std::size_t count() const { return squares_.size(); }
  const std::vector<std::uint32_t>& inside(std::size_t square) const { return inside_[square]; }
  Polygon outline(std::size_t square) const {
    const vec2 low = geometry::on_lattice(grid_.at(squares_[square].i, squares_[square].j));
    const vec2 high = geometry::on_lattice(grid_.at(squares_[square].i + 1, squares_[square].j + 1));
    return {low, {high.x, low.y}, high, {low.x, high.y}};
  }

 private:
  void add(const Polygon& tile, std::uint32_t number) {
    const auto index = [&](double mm, double low) { return static_cast<std::int64_t>(std::floor((mm - low) / grid_.along.x)); };
    const Box box = geometry::bounding_box(tile);
    for (std::int64_t j = index(box.low.y, grid_.origin.y); j <= index(box.high.y, grid_.origin.y); ++j) {
      for (std::int64_t i = index(box.low.x, grid_.origin.x); i <= index(box.high.x, grid_.origin.x); ++i) {
        const auto at = std::ranges::lower_bound(squares_, GridPoint{j, i});
        if (at != squares_.end() && *at == GridPoint{j, i}) {
          inside_[static_cast<std::size_t>(at - squares_.begin())].push_back(number);
        }
      }
    }
  }

  Grid grid_;
  std::vector<GridPoint> squares_;
  std::vector<std::vector<std::uint32_t>> inside_;
};

}  // namespace

std::vector<Tile> gap_tiles(const std::vector<Tile>& tiles, const Region& region, const geometry::RegionIndex& index,
                            vec2 pitch) {
  const Squares squares(tiles, index, square_pitches * std::max(pitch.x, pitch.y));
  std::vector<Tile> gaps;
  for (std::size_t s = 0; s < squares.count(); ++s) {
    const Polygon square = squares.outline(s);
    if (!is_needed(square, index)) continue;
    std::vector<Polygon> taken;
    for (const std::uint32_t t : squares.inside(s)) taken.push_back(tiles[t].outline_mm);
    const vec2 axis = taken.empty() ? vec2{1.0, 0.0} : tiles[squares.inside(s).front()].axis;
    for (const Region& part : geometry::intersection(square, region)) {
      for (const Region& gap : gaps_of(part, taken, least_gap * pitch.x * pitch.y)) append_gap(gap, pitch, axis, gaps);
    }
  }
  return gaps;
}

}  // namespace shatterpave::paving
