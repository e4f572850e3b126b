// A row keeps its distance to the line that it follows, as if set out from a string with a gauge: its middle is the line of all
// points that far away. That line has corners where rows that follow different parts meet; there they are mitred. Where a row
// closes in on itself (the middle of an area along its outline) stones are cut to what is left, as closers, and what is too
// narrow for any row is filled with pieces.
#include "paving/bonds/courses.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/segment_distance.h"
#include "paving/bonds/course_tiles.h"
#include "paving/tiles/filling.h"
#include "paving/tiles/pattern.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;

double farthest(const geometry::RegionIndex& area, const std::vector<std::vector<vec2>>& lines) {
  // From any line point to any corner of the area: too far, but rows without stones end the search anyway.
  double most = 0.0;
  for (const auto& s : area.segments()) {
    double nearest = 1e300;
    for (const auto& line : lines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        nearest = std::min(nearest, geometry::distance_to_segment(s.from, line[i], line[i + 1]));
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

std::vector<std::vector<vec2>> extended_guides(const GuidesDirection& direction, const Box& box) {
  Box all = box;
  for (const auto& guide : direction.guides_mm) {
    for (const vec2& p : guide) all = {glm::min(all.low, p), glm::max(all.high, p)};
  }
  const double far = 2.0 * glm::length(all.high - all.low);
  const auto beyond = [&](vec2 from, vec2 end) {
    return geometry::on_lattice(end + far / glm::length(end - from) * (end - from));
  };
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

std::vector<Tile> parallel_tiles(const Pavement& pavement, vec2 pitch, double offset, const geometry::RegionIndex& area) {
  const Middles middles(pavement, pitch.y, area);
  std::vector<Tile> tiles;
  double moved = pavement.bonding.start;
  for (int k = 0;; ++k) {
    const std::vector<Polygon> rings = middles.row(k);
    if (rings.empty()) break;
    for (const Polygon& ring : rings) {
      for (Tile& tile : course_tiles(ring, pitch, pavement.joint_mm, moved - std::floor(moved))) {
        if (is_needed(tile.outline_mm, area)) tiles.push_back(std::move(tile));
      }
    }
    moved += offset;
  }
  return filling_tiles(tiles, pavement.area);
}

}  // namespace shatterpave::paving
