#include "paving/tiles/overlapping.h"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <limits>

#include "core/parallel.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "geometry/segment_distance.h"

namespace shatterpave::paving {

namespace {

namespace index = boost::geometry::index;
using geometry::Polygon;
using IndexCorner = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using IndexBox = boost::geometry::model::box<IndexCorner>;
using IndexEntry = std::pair<IndexBox, std::size_t>;

IndexBox index_box_of(const Polygon& tile) {
  const geometry::Box box = geometry::bounding_box(tile);
  return {{box.low.x, box.low.y}, {box.high.x, box.high.y}};
}

double distance_to_border(vec2 point, const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least, geometry::distance_to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}

bool has_corner_in(const Polygon& a, const Polygon& b, double seam_mm) {
  return std::ranges::any_of(a,
                             [&](vec2 p) { return geometry::contains_strictly(b, p) && distance_to_border(p, b) > seam_mm; });
}

bool cross_deeply(vec2 a, vec2 b, vec2 c, vec2 d, double seam_mm) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  return geometry::segments_cross(geometry::to_lattice(a), geometry::to_lattice(b), geometry::to_lattice(c),
                                  geometry::to_lattice(d)) &&
         geometry::distance_to_segment(a, c, d) > seam_mm && geometry::distance_to_segment(b, c, d) > seam_mm &&
         geometry::distance_to_segment(c, a, b) > seam_mm && geometry::distance_to_segment(d, a, b) > seam_mm;
}

}  // namespace

bool lie_over_one_another(const Polygon& a, const Polygon& b, double seam_mm) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (cross_deeply(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()], seam_mm)) return true;
    }
  }
  if (has_corner_in(a, b, seam_mm) || has_corner_in(b, a, seam_mm)) return true;
  // Of those with all corners in common the middle tells.
  const Polygon middle = {geometry::centroid(a)};
  return has_corner_in(middle, a, seam_mm) && has_corner_in(middle, b, seam_mm);
}

std::vector<std::pair<std::size_t, std::size_t>> overlapping_pairs(const std::vector<Polygon>& tiles, double seam_mm) {
  std::vector<IndexEntry> entries(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) entries[t] = {index_box_of(tiles[t]), t};
  const index::rtree<IndexEntry, index::rstar<16>> tree(entries);
  std::vector<std::vector<std::size_t>> over(tiles.size());
  parallel_for(tiles.size(), [&](std::size_t t) {
    for (auto entry = tree.qbegin(index::intersects(entries[t].first)); entry != tree.qend(); ++entry) {
      if (entry->second > t && lie_over_one_another(tiles[t], tiles[entry->second], seam_mm)) over[t].push_back(entry->second);
    }
    std::ranges::sort(over[t]);
  });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    std::ranges::transform(over[t], std::back_inserter(pairs), [&](std::size_t other) { return std::pair(t, other); });
  }
  return pairs;
}

}  // namespace shatterpave::paving
