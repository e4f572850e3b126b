// A row keeps its distance to the line that it follows, as if set out from a string with a gauge: its middle is the line of all
// points that far away. That line has corners where rows that follow different parts meet; there they are mitred. Where a row
// closes in on itself (the middle of an area along its outline) stones are cut to what is left, as closers, and what is too
// narrow for any row is filled with pieces.
#include "paving/bond_courses.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/course.h"
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

double length(vec2 v) { return std::sqrt(glm::dot(v, v)); }

// Guides, straight on beyond their ends until they are out of sight of the area.
std::vector<std::vector<vec2>> extended_guides(const GuidesDirection& direction, const Box& box) {
  Box all = box;
  for (const auto& guide : direction.guides_mm) {
    for (const vec2& p : guide) all = {glm::min(all.low, p), glm::max(all.high, p)};
  }
  const double far = 2.0 * length(all.high - all.low);
  const auto beyond = [&](vec2 from, vec2 end) { return geometry::on_lattice(end + far / length(end - from) * (end - from)); };
  std::vector<std::vector<vec2>> guides;
  for (const auto& guide : direction.guides_mm) {
    auto& extended = guides.emplace_back();
    extended.reserve(guide.size() + 2);
    extended.push_back(beyond(guide[1], guide[0]));
    for (const vec2& p : guide) extended.push_back(p);
    extended.push_back(beyond(guide[guide.size() - 2], guide.back()));
  }
  return guides;
}

double farthest(const geometry::RegionIndex& area, const std::vector<std::vector<vec2>>& lines) {
  // From any line point to any corner of the area: too far, but rows without stones end the search anyway.
  double most = 0.0;
  for (const auto& s : area.segments()) {
    double nearest = 1e300;
    for (const auto& line : lines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        nearest = std::min(nearest, length(geometry::nearest_point({line[i], line[i + 1]}, s.from) - s.from));
      }
    }
    most = std::max(most, nearest);
  }
  return most;
}

void append_rings(const std::vector<Region>& regions, std::vector<Polygon>& rings) {
  for (const Region& region : regions) {
    rings.push_back(region.outline);
    for (const Polygon& hole : region.holes) rings.push_back(hole);
  }
}

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
        for (Region& gap : geometry::difference(inside, taken)) {
          if (geometry::area(gap) >= least_mm2) gaps.push_back(std::move(gap));
        }
      }
    }
  }
  return gaps;
}

// Tiles for what `tiles` leave of the region.
std::vector<Tile> gap_tiles(const std::vector<Tile>& tiles, const Region& region, const geometry::RegionIndex& area,
                            vec2 pitch) {
  const double step = square_pitches * std::max(pitch.x, pitch.y);
  const Grid grid{area.box().low, {step, 0.0}, {0.0, step}};
  const auto squares = near_points(grid, area, 1.5 * step);
  std::vector<std::vector<std::uint32_t>> inside(squares.size());
  const auto index = [&](double mm, double low) { return static_cast<std::int64_t>(std::floor((mm - low) / step)); };
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const Box box = geometry::bounding_box(tiles[t].outline_mm);
    for (std::int64_t j = index(box.low.y, grid.origin.y); j <= index(box.high.y, grid.origin.y); ++j) {
      for (std::int64_t i = index(box.low.x, grid.origin.x); i <= index(box.high.x, grid.origin.x); ++i) {
        const auto at = std::ranges::lower_bound(squares, GridPoint{j, i});
        if (at == squares.end() || *at != GridPoint{j, i}) continue;
        inside[static_cast<std::size_t>(at - squares.begin())].push_back(static_cast<std::uint32_t>(t));
      }
    }
  }
  std::vector<Tile> gaps;
  for (std::size_t s = 0; s < squares.size(); ++s) {
    const vec2 low = geometry::on_lattice(grid.at(squares[s].i, squares[s].j));
    const vec2 high = geometry::on_lattice(grid.at(squares[s].i + 1, squares[s].j + 1));
    const Polygon square{low, {high.x, low.y}, high, {low.x, high.y}};
    if (!is_needed(square, area)) continue;
    std::vector<Polygon> taken;
    for (const std::uint32_t t : inside[s]) taken.push_back(tiles[t].outline_mm);
    const vec2 axis = inside[s].empty() ? vec2{1.0, 0.0} : tiles[inside[s].front()].axis;
    for (const Region& part : geometry::intersection(square, region)) {
      for (const Region& gap : gaps_of(part, taken, least_gap * pitch.x * pitch.y)) append_gap(gap, pitch, axis, gaps);
    }
  }
  return gaps;
}

// The middles of the k-th rows.
class Middles {
 public:
  Middles(const Pavement& pavement, double depth, const geometry::RegionIndex& area) : area_(pavement.area), depth_(depth) {
    if (const auto* direction = std::get_if<GuidesDirection>(&pavement.direction)) {
      guides_ = extended_guides(*direction, area.box());
      rows_ = static_cast<int>(farthest(area, guides_) / depth) + 2;
    }
  }

  // Nothing after the last row.
  std::vector<Polygon> row(int k) const {
    std::vector<Polygon> rings;
    const double distance = (k + 0.5) * depth_;
    if (guides_.empty()) {
      append_rings(geometry::offset(area_, -distance), rings);
    } else if (k < rows_) {
      append_rings(geometry::thickened(guides_, distance), rings);
    }
    return rings;
  }

 private:
  const Region& area_;
  double depth_;
  std::vector<std::vector<vec2>> guides_;
  int rows_ = 0;
};

}  // namespace

std::vector<Tile> parallel_tiles(const Pavement& pavement, vec2 pitch, double offset, const geometry::RegionIndex& area) {
  const Middles middles(pavement, pitch.y, area);
  std::vector<Tile> tiles;
  double moved = 0.0;
  for (int k = 0;; ++k) {
    const std::vector<Polygon> rings = middles.row(k);
    if (rings.empty()) break;
    for (const Polygon& ring : rings) {
      for (Tile& tile : course_tiles(ring, pitch, moved - std::floor(moved))) {
        if (is_needed(tile.outline_mm, area)) tiles.push_back(std::move(tile));
      }
    }
    moved += offset;
  }
  tiles = without_overlaps(std::move(tiles), std::max(pitch.x, pitch.y));
  for (Tile& gap : gap_tiles(tiles, pavement.area, area, pitch)) tiles.push_back(std::move(gap));
  return tiles;
}

}  // namespace shatterpave::paving
