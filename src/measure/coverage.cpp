// The area is looked at in square tiles, so that a polygon clipper never sees more than some hundred stones. What a tile and
// the band about it, as wide as the disc's radius, leave uncovered is shrunk by that radius: what remains are the places within
// the tile where the middle of a disc may be. Those of neighbouring tiles that touch are one hole.
#include "measure/coverage.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/packing.h"

namespace shatterpave::measure {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;

// Pitches to a side of a tile: Clipper takes more than linear time, many tiles cost more at their borders; by trial.
constexpr double tile_pitches = 8.0;
// Of a stone's shorter side: half of a quarter.
constexpr double disc_radius = 0.125;
// Stones are grown by so much more, so that neighbours overlap for certain. Rounding to the lattice else leaves slits a few µm
// wide along half of the joints, which take Clipper long, and now and then lead it to lose a whole stone.
constexpr double hairline_mm = 0.01;
// Corners are mitred where the tip lies within as many half joints, as where joints are taken off.
constexpr double miter_limit = 2.0;

Polygon rectangle(const Box& box) { return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}; }

// A convex stone with its sides moved out; empty if it is not convex, or too sharp a corner would run far out.
Polygon grown_convex(const Polygon& stone, double distance_mm) {
  const std::size_t n = stone.size();
  std::vector<vec2> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 d = stone[(i + 1) % n] - stone[i];
    out[i] = -left_of(d) / glm::length(d);
  }
  Polygon grown(n);
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 before = out[(i + n - 1) % n];
    // The tip is at distance √(2 / (1 + cos)) from the corner, cos of the turn.
    const double cosine = glm::dot(before, out[i]);
    if (cross(before, out[i]) <= 0.0 || 2.0 > miter_limit * miter_limit * (1.0 + cosine)) return {};
    grown[i] = stone[i] + distance_mm / (1.0 + cosine) * (before + out[i]);
  }
  return grown;
}

void append_grown(const Polygon& stone, double distance_mm, std::vector<Polygon>& all) {
  if (Polygon grown = grown_convex(stone, distance_mm); !grown.empty()) {
    all.push_back(std::move(grown));
    return;
  }
  for (Region& region : geometry::offset({stone, {}}, distance_mm, miter_limit)) all.push_back(std::move(region.outline));
}

double area_within(const Box& box, const Region& region) {
  const Box about = geometry::bounding_box(region.outline);
  if (glm::min(about.low, box.low) == box.low && glm::max(about.high, box.high) == box.high) return geometry::area(region);
  double sum = 0.0;
  for (const Region& part : geometry::intersection(rectangle(box), region)) sum += geometry::area(part);
  return sum;
}

struct TileCoverage {
  double uncovered_mm2 = 0.0;
  std::vector<Polygon> disc_middles;
};

class Tiles {
 public:
  Tiles(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
        const geometry::RegionIndex& area)
      : pavement_(pavement), layout_(layout), index_(index), area_(area) {
    const vec2 pitch = paving::pitch_mm(pavement);
    const vec2 size = area.box().high - area.box().low;
    // A pavement that is all outline has no more tiles than one that is full.
    const double most = static_cast<double>(layout.stones.size()) + 64.0;
    side_mm_ = std::max(tile_pitches * std::max(pitch.x, pitch.y), std::sqrt(size.x * size.y / most));
    side_mm_ = std::max(side_mm_, std::max(size.x, size.y) / most);
    columns_ = static_cast<std::size_t>(size.x / side_mm_) + 1;
    rows_ = static_cast<std::size_t>(size.y / side_mm_) + 1;
    radius_mm_ = disc_radius * std::min(pavement.stone_mm.x, pavement.stone_mm.y);
  }

  std::size_t count() const { return columns_ * rows_; }

  TileCoverage covered(std::size_t tile) const {
    const Box core = box(tile);
    TileCoverage result;
    for (const Region& open : uncovered({core.low - vec2{radius_mm_, radius_mm_}, core.high + vec2{radius_mm_, radius_mm_}})) {
      result.uncovered_mm2 += area_within(core, open);
      if (geometry::area(open) < pi * radius_mm_ * radius_mm_) continue;
      for (Region& middles : geometry::offset(open, -radius_mm_)) result.disc_middles.push_back(std::move(middles.outline));
    }
    return result;
  }

 private:
  Box box(std::size_t tile) const {
    const auto corner = [&](std::size_t column, std::size_t row) {
      return geometry::on_lattice(area_.box().low + side_mm_ * vec2{static_cast<double>(column), static_cast<double>(row)});
    };
    const std::size_t column = tile % columns_;
    const std::size_t row = tile / columns_;
    return {corner(column, row), corner(column + 1, row + 1)};
  }

  // What the grown stones leave of the area within `wide`.
  std::vector<Region> uncovered(const Box& wide) const {
    std::vector<Region> parts;
    if (area_.border_meets(wide)) {
      parts = geometry::intersection(rectangle(wide), pavement_.area);
    } else if (area_.contains(wide.low)) {
      parts.push_back({rectangle(wide), {}});
    }
    if (parts.empty()) return parts;
    const double half_joint = 0.5 * pavement_.joint_mm + hairline_mm;
    const vec2 reach = vec2{miter_limit * half_joint, miter_limit * half_joint};
    std::vector<std::size_t> near;
    index_.near({wide.low - reach, wide.high + reach}, near);
    std::vector<Polygon> grown;
    for (const std::size_t s : near) append_grown(layout_.stones[s].outline_mm, half_joint, grown);
    std::vector<Region> left;
    for (const Region& part : parts) {
      for (Region& open : geometry::difference(part, grown)) left.push_back(std::move(open));
    }
    return left;
  }

  const paving::Pavement& pavement_;
  const paving::StoneLayout& layout_;
  const StoneIndex& index_;
  const geometry::RegionIndex& area_;
  double side_mm_ = 1.0;
  double radius_mm_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
};

}  // namespace

Coverage coverage_of(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
                     const geometry::RegionIndex& area) {
  const Tiles tiles(pavement, layout, index, area);
  std::vector<TileCoverage> parts(tiles.count());
  parallel_for(tiles.count(), [&](std::size_t tile) { parts[tile] = tiles.covered(tile); });
  double uncovered = 0.0;
  std::vector<Polygon> middles;
  for (TileCoverage& part : parts) {
    uncovered += part.uncovered_mm2;
    for (Polygon& polygon : part.disc_middles) middles.push_back(std::move(polygon));
  }
  Coverage result;
  result.share = 1.0 - uncovered / geometry::area(pavement.area);
  for (const Region& hole : geometry::united(middles)) result.holes.push_back(geometry::centroid(hole.outline));
  return result;
}

}  // namespace shatterpave::measure
