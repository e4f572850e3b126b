#include "paving/tiles/filling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "geometry/clip.h"
#include "geometry/corners.h"
#include "geometry/lattice.h"
#include "geometry/overlay.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Overlay;
using geometry::Polygon;
using geometry::Region;

// Thinner parts come of rounding, or of lines that were to be one.
constexpr double sliver_mm = 0.02;
// A vertex where another tile ends on a side is rounded, and lies this near to the side at the most.
constexpr double straight_mm = 0.0015;
// A tile that keeps this much of its area is whole to the eye; by eye.
constexpr double whole_tile_share = 0.99;

double distance_to_chord(vec2 from, vec2 to, vec2 p) {
  const vec2 d = to - from;
  const double along = glm::length(d);
  return along == 0.0 ? glm::length(p - from) : std::abs(cross(d, p - from)) / along;
}

// The polygon without vertices at which it is straight but for rounding.
Polygon straightened(const Polygon& polygon) {
  Polygon kept;
  const std::size_t n = polygon.size();
  // From a true corner on.
  std::size_t first = 0;
  while (first < n &&
         distance_to_chord(polygon[(first + n - 1) % n], polygon[(first + 1) % n], polygon[first]) <= straight_mm) {
    ++first;
  }
  if (first == n) return geometry::cleaned(polygon);
  const auto at = [&](std::size_t i) { return polygon[(first + i) % n]; };
  kept.push_back(at(0));
  std::size_t last = 0;
  for (std::size_t i = 1; i < n; ++i) {
    bool straight = true;
    for (std::size_t k = last + 1; k <= i && straight; ++k) {
      straight =
          distance_to_chord(at(last), at(i + 1), at(k)) <= straight_mm && glm::dot(at(i + 1) - at(k), at(k) - at(last)) > 0.0;
    }
    if (straight) continue;
    kept.push_back(at(i));
    last = i;
  }
  return geometry::cleaned(kept);
}

// Straightened, or only cleaned where no simple polygon would be left.
Polygon straightened_if_simple(const Polygon& outline) {
  Polygon straight = straightened(outline);
  return straight.size() < 3 || !geometry::is_simple(straight) ? geometry::cleaned(outline) : straight;
}

// Labels of the faces: the tile that keeps a face, `gap`, or `beyond` the region.
struct Labels {
  std::uint32_t gap = 0;
  std::uint32_t beyond = 0;
  std::vector<std::uint32_t> of_face;
};

Labels labels_of(const Overlay& map, std::size_t tiles) {
  Labels labels{static_cast<std::uint32_t>(tiles), static_cast<std::uint32_t>(tiles) + 1, {}};
  labels.of_face.reserve(map.faces.size());
  for (const auto& layers : map.covered_by) {
    // The region is the last layer.
    const bool inside = !layers.empty() && layers.back() == labels.gap;
    labels.of_face.push_back(inside ? layers.front() : labels.beyond);
  }
  labels.of_face = geometry::without_slivers(map, std::move(labels.of_face), sliver_mm, labels.beyond);
  return labels;
}

// For sides, by their ends, the tile that lies beside them.
using TileBeside = std::map<std::pair<geometry::LatticePoint, geometry::LatticePoint>, std::uint32_t>;

TileBeside tiles_beside_gaps(const Overlay& map, const Labels& labels) {
  TileBeside beside;
  for (std::size_t s = 0; s < map.sides.size(); ++s) {
    const auto [left, right] = map.beside[s];
    if (left == Overlay::outside || right == Overlay::outside) continue;
    const auto [low, high] = std::minmax(labels.of_face[left], labels.of_face[right]);
    if (high == labels.gap && low < labels.gap) beside[std::minmax(map.sides[s].a, map.sides[s].b)] = low;
  }
  return beside;
}

// The axis of the tile that shares most of the region's border.
vec2 axis_beside(const Region& region, const TileBeside& tile_beside, const std::vector<Tile>& tiles) {
  std::map<std::uint32_t, double> shared;
  const auto count = [&](const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const vec2 to = ring[(i + 1) % ring.size()];
      const auto found = tile_beside.find(std::minmax(geometry::to_lattice(ring[i]), geometry::to_lattice(to)));
      if (found != tile_beside.end()) shared[found->second] += glm::length(to - ring[i]);
    }
  };
  count(region.outline);
  for (const Polygon& hole : region.holes) count(hole);
  const auto most = std::ranges::max_element(shared, {}, [](const auto& s) { return s.second; });
  return most == shared.end() ? vec2{1.0, 0.0} : tiles[most->first].axis;
}

enum class Wanted { all, gaps };

std::vector<Tile> parted(const std::vector<Tile>& tiles, const Region& region, Wanted wanted) {
  std::vector<geometry::Layer> layers;
  layers.reserve(tiles.size() + 1);
  for (const Tile& tile : tiles) layers.push_back({tile.outline_mm});
  layers.push_back({region.outline});
  layers.back().insert(layers.back().end(), region.holes.begin(), region.holes.end());
  const Overlay map = geometry::overlay(layers);
  const Labels labels = labels_of(map, tiles.size());

  const TileBeside tile_beside_gap = tiles_beside_gaps(map, labels);
  std::vector<geometry::LabelledRegion> parts = geometry::labelled_regions(map, labels.of_face);
  std::ranges::stable_sort(parts, {}, &geometry::LabelledRegion::label);
  std::vector<Tile> result;
  for (const auto& [part, label] : parts) {
    if (label == labels.beyond || (wanted == Wanted::gaps && label != labels.gap)) continue;
    const bool gap = label == labels.gap;
    const vec2 axis = gap ? axis_beside(part, tile_beside_gap, tiles) : tiles[label].axis;
    const bool whole = !gap && geometry::area(part) >= whole_tile_share * geometry::area(tiles[label].outline_mm);
    for (const Polygon& outline : without_holes(part)) {
      Polygon straight = straightened_if_simple(outline);
      if (!straight.empty()) result.push_back({std::move(straight), axis, !whole || !part.holes.empty()});
    }
  }
  return result;
}

}  // namespace

std::vector<Polygon> without_holes(Region region) {
  if (region.holes.empty()) return {std::move(region.outline)};
  std::vector<Polygon> parts;
  const auto append = [&](std::vector<Region> regions) {
    for (Region& part : regions) std::ranges::move(without_holes(std::move(part)), std::back_inserter(parts));
  };
  // No line of the lattice parts a slit of a single step, and cuts beside it would never end: a box about it is taken out.
  const vec2 step(geometry::to_mm(1));
  std::vector<Polygon> slits;
  std::erase_if(region.holes, [&](const Polygon& hole) {
    const Box box = geometry::bounding_box(hole);
    const bool slit = std::min(box.high.x - box.low.x, box.high.y - box.low.y) < 1.5 * step.x;
    if (slit)
      slits.push_back(geometry::rectangle({geometry::on_lattice(box.low - step), geometry::on_lattice(box.high + step)}));
    return slit;
  });
  if (!slits.empty()) {
    append(geometry::difference(region, slits));
    return parts;
  }
  const Box box = geometry::bounding_box(region.outline);
  const Box hole = geometry::bounding_box(region.holes.front());
  const vec2 middle = geometry::on_lattice(0.5 * (hole.low + hole.high));
  const bool upright = box.high.x - box.low.x >= box.high.y - box.low.y;
  const vec2 split_high = upright ? vec2{middle.x, box.high.y} : vec2{box.high.x, middle.y};
  const vec2 split_low = upright ? vec2{middle.x, box.low.y} : vec2{box.low.x, middle.y};
  for (const Polygon& half : {geometry::rectangle({box.low, split_high}), geometry::rectangle({split_low, box.high})}) {
    append(geometry::intersection(half, region));
  }
  return parts;
}

std::vector<Tile> filling_tiles(const std::vector<Tile>& tiles, const Region& region) {
  return parted(tiles, region, Wanted::all);
}

std::vector<Tile> gap_tiles(const std::vector<Tile>& tiles, const Region& region) {
  return parted(tiles, region, Wanted::gaps);
}

}  // namespace shatterpave::paving
