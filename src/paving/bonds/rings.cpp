// As rings grow they need more stones. If each had the number that fits it best, perpends would drift past each other, and meet
// somewhere on each ring. So a number is kept for as many rings as stones differ little from the asked length; within those the
// bond is as regular as in straight rows.
#include "paving/bonds/rings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.h"
#include "geometry/corners.h"
#include "geometry/lattice.h"
#include "paving/bonds/course_line.h"
#include "paving/tiles/pattern.h"

namespace shatterpave::paving {

namespace {

// Stones are shorter than asked by up to this part along their outer side, where none is longer; by eye: it does not show
// beside joints.
constexpr double most_off = 0.1;
constexpr double same_stop_mm = 0.01;

struct Ring {
  double count = 3.0;  // whole
  double start = 0.0;  // of the first stone, turns
};

// Angles in turns.
struct Sector {
  double from = 0.0;
  double to = 1.0;
};

// As seen from `centre`; all round if it lies in the box about the area, or near it.
Sector sector_of(const geometry::RegionIndex& area, vec2 centre, double margin_mm) {
  const geometry::Box box = area.box();
  const vec2 margin{margin_mm, margin_mm};
  const geometry::Box about{box.low - margin, box.high + margin};
  const auto& [low, high] = about;
  if (centre.x >= low.x && centre.x <= high.x && centre.y >= low.y && centre.y <= high.y) return {};
  const vec2 middle = 0.5 * (low + high) - centre;
  double least = 0.0;
  double most = 0.0;
  for (const vec2 corner : geometry::corners(about)) {
    const double turns = Angle::of({glm::dot(middle, corner - centre), cross(middle, corner - centre)}).degrees() / 360.0;
    least = std::min(least, turns);
    most = std::max(most, turns);
  }
  const double at = Angle::of(middle).degrees() / 360.0;
  return {at + least, at + most};
}

class Rings {
 public:
  Rings(vec2 pitch, const RadialDirection& direction, double start, double offset, const geometry::RegionIndex& area)
      : pitch_(pitch), centre_(direction.centre_mm), first_mm_(direction.first_mm), area_(area) {
    const vec2 centre = centre_;
    const double nearest = (area.contains(centre) ? 0.0 : area.nearest(centre).distance_mm) - first_mm_;
    double farthest = 0.0;
    for (const auto& s : area.segments()) farthest = std::max(farthest, glm::length(s.from - centre));
    // One more on either side, so that a ring always knows the next ones.
    const double first = std::max(0.0, std::floor(nearest / pitch.y) - 1.0);
    first_ = static_cast<std::size_t>(first);
    const auto last = std::max(static_cast<std::size_t>(std::max(0.0, farthest - first_mm_) / pitch.y), first_) + 2;
    double moved = start;
    for (std::size_t k = 0; k < last - first_; ++k) {
      const double circumference = 2.0 * pi * (first_mm_ + static_cast<double>(first_ + k + 1) * pitch.y);
      Ring ring{rings_.empty() ? 0.0 : rings_.back().count, 0.0};
      if (ring.count == 0.0 || circumference > ring.count * pitch.x) {
        ring.count = std::max(3.0, std::floor(circumference / ((1.0 - most_off) * pitch.x)));
      }
      moved += offset;
      ring.start = (moved - std::floor(moved)) / ring.count;
      rings_.push_back(ring);
    }
  }

  std::vector<Tile> tiles() const {
    const Sector sector = sector_of(area_, centre_, pitch_.x);
    std::vector<Tile> result;
    for (std::size_t k = 0; k + 1 < rings_.size(); ++k) {
      const double count = rings_[k].count;
      const double first = std::floor((sector.from - rings_[k].start) * count);
      const double last = std::min(first + count, std::ceil((sector.to - rings_[k].start) * count));
      const Lines lines{line_below(k, sector), line_below(k + 1, sector)};
      for (double i = first; i < last; i += 1.0) {
        Tile one = tile(k, rings_[k].start + i / count, rings_[k].start + (i + 1.0) / count, lines);
        if (is_needed(one.outline_mm, area_)) result.push_back(std::move(one));
      }
    }
    return result;
  }

 private:
  struct Lines {
    CourseLine low;
    CourseLine high;
  };

  double radius(std::size_t k) const { return first_mm_ + static_cast<double>(first_ + k) * pitch_.y; }

  vec2 point(double turns, double radius) const {
    const double rest = turns - std::floor(turns);
    return geometry::on_lattice(centre_ + radius * Angle::degrees(360.0 * rest).direction());
  }

  // With all stops that stones of the sector may need.
  CourseLine line_below(std::size_t k, const Sector& sector) const {
    std::vector<double> stops;
    for (const std::size_t ring : {k, k - 1}) {
      if (ring >= rings_.size()) continue;
      const double count = rings_[ring].count;
      const double last = std::ceil((sector.to - rings_[ring].start) * count) + 1.0;
      for (double i = std::floor((sector.from - rings_[ring].start) * count) - 1.0; i <= last; i += 1.0) {
        stops.push_back(rings_[ring].start + i / count);
      }
    }
    return {std::move(stops), same_stop_mm / (2.0 * pi * std::max(radius(k), pitch_.y))};
  }

  Tile tile(std::size_t k, double from, double to, const Lines& lines) const {
    Tile tile;
    const auto at = [&](std::size_t line) { return [this, line](double turns) { return point(turns, radius(line)); }; };
    tile.outline_mm.push_back(point(from, radius(k + 1)));
    lines.high.append_between(from, to, at(k + 1), tile.outline_mm);
    tile.outline_mm.push_back(point(to, radius(k + 1)));
    if (radius(k) > 0.0) {
      tile.outline_mm.push_back(point(to, radius(k)));
      lines.low.append_between(to, from, at(k), tile.outline_mm);
      tile.outline_mm.push_back(point(from, radius(k)));
    } else {
      tile.outline_mm.push_back(geometry::on_lattice(centre_));
    }
    tile.axis = left_of(Angle::degrees(180.0 * (from + to)).direction());
    return tile;
  }

  vec2 pitch_;
  vec2 centre_;
  double first_mm_;
  const geometry::RegionIndex& area_;
  std::size_t first_ = 0;  // number of the first ring
  std::vector<Ring> rings_;
};

}  // namespace

std::vector<Tile> ring_tiles(vec2 pitch, const RadialDirection& direction, double start, double offset,
                             const geometry::RegionIndex& area) {
  return Rings(pitch, direction, start, offset, area).tiles();
}

}  // namespace shatterpave::paving
