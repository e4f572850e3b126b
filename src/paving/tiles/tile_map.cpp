#include "paving/tiles/tile_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/lattice.h"
#include "geometry/point_index.h"
#include "paving/tiles/stock.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;

// Twice the rounding of a corner to the lattice, and some room; between two steps of it, so that no rounding decides.
constexpr double same_point_mm = 0.0035;
// Cosine of 10°: by eye, less is a bend of a line. Corners of stones turn by more.
constexpr double straight_cosine = 0.985;

Box about(vec2 a, vec2 b) {
  const vec2 room{same_point_mm, same_point_mm};
  return {glm::min(a, b) - room, glm::max(a, b) + room};
}

// Numbers for the corners of tiles, one for those in one place.
class SharedPoints {
 public:
  explicit SharedPoints(double cell_mm) : index_(cell_mm) {}

  std::uint32_t number(vec2 place) {
    std::uint32_t nearest = TileMap::none;
    double least = same_point_mm;
    index_.visit_in(about(place, place), [&](int number) {
      const double distance = glm::length(points_[static_cast<std::size_t>(number)] - place);
      if (distance > least) return;
      least = distance;
      nearest = static_cast<std::uint32_t>(number);
    });
    if (nearest != TileMap::none) return nearest;
    points_.push_back(place);
    index_.put(static_cast<int>(points_.size()) - 1, place);
    return static_cast<std::uint32_t>(points_.size()) - 1;
  }

  // The points on the side from `a` to `b`, between them, in order.
  std::vector<std::uint32_t> between(std::uint32_t a, std::uint32_t b) const {
    const vec2 from = points_[a];
    const vec2 d = points_[b] - from;
    const double length = glm::length(d);
    std::vector<std::pair<double, std::uint32_t>> on_side;
    index_.visit_in(about(from, points_[b]), [&](int number) {
      const vec2 p = points_[static_cast<std::size_t>(number)] - from;
      const double along = glm::dot(p, d) / length;
      if (along <= same_point_mm || along >= length - same_point_mm) return;
      if (std::abs(cross(d, p)) <= same_point_mm * length) on_side.emplace_back(along, static_cast<std::uint32_t>(number));
    });
    std::ranges::sort(on_side);
    std::vector<std::uint32_t> result;
    result.reserve(on_side.size());
    for (const auto& point : on_side) result.push_back(point.second);
    return result;
  }

  std::vector<vec2> points() && { return std::move(points_); }

 private:
  std::vector<vec2> points_;
  geometry::PointIndex index_;
};

double typical_size(const std::vector<Tile>& tiles) {
  double area = 0.0;
  for (const Tile& tile : tiles) area += geometry::area(tile.outline_mm);
  return std::max(1.0, std::sqrt(area / static_cast<double>(std::max<std::size_t>(tiles.size(), 1))));
}

using PointRing = std::vector<std::uint32_t>;

// The outlines of the tiles by numbers of points, with all points on their sides.
std::vector<PointRing> rings_of(const std::vector<Tile>& tiles, SharedPoints& shared) {
  std::vector<PointRing> corners(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const vec2& p : tiles[t].outline_mm) {
      const std::uint32_t number = shared.number(geometry::on_lattice(p));
      if (corners[t].empty() || corners[t].back() != number) corners[t].push_back(number);
    }
    if (corners[t].size() > 1 && corners[t].front() == corners[t].back()) corners[t].pop_back();
  }
  std::vector<PointRing> rings(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (std::size_t i = 0; i < corners[t].size(); ++i) {
      const std::uint32_t from = corners[t][i];
      rings[t].push_back(from);
      for (const std::uint32_t point : shared.between(from, corners[t][(i + 1) % corners[t].size()])) {
        if (point != from) rings[t].push_back(point);
      }
    }
  }
  return rings;
}

struct SharedSide {
  std::uint32_t low = 0;
  std::uint32_t high = 0;

  auto operator<=>(const SharedSide&) const = default;
};

SharedSide edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The sides of tiles, and which of them belong to one line.
class SharedSides {
 public:
  SharedSides(const std::vector<PointRing>& rings, const std::vector<vec2>& points) : points_(points), at_(points.size()) {
    std::vector<SharedSide> all;
    for (const PointRing& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) all.push_back(edge_of(ring[i], ring[(i + 1) % ring.size()]));
    }
    std::ranges::sort(all);
    for (std::size_t i = 0; i < all.size();) {
      std::size_t end = i;
      while (end < all.size() && all[end] == all[i]) ++end;
      at_[all[i].low].push_back(edges_.size());
      at_[all[i].high].push_back(edges_.size());
      edges_.push_back(all[i]);
      rim_.push_back(end - i == 1);
      i = end;
    }
    parent_.resize(edges_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t count() const { return edges_.size(); }
  const SharedSide& edge(std::size_t i) const { return edges_[i]; }
  const std::vector<std::size_t>& at(std::uint32_t point) const { return at_[point]; }
  std::size_t number(std::uint32_t a, std::uint32_t b) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(edges_, edge_of(a, b)) - edges_.begin());
  }
  std::uint32_t other(std::size_t edge, std::uint32_t point) const {
    return edges_[edge].low == point ? edges_[edge].high : edges_[edge].low;
  }

  bool is_rim(std::size_t edge) const { return rim_[edge]; }

  bool is_straight(std::uint32_t before, std::uint32_t at, std::uint32_t after) const {
    const vec2 a = points_[at] - points_[before];
    const vec2 b = points_[after] - points_[at];
    return glm::dot(a, b) >= straight_cosine * glm::length(a) * glm::length(b);
  }

  // The two sides at a point on the rim of all tiles; nothing where it is not there, or the rim meets itself.
  std::vector<std::size_t> rim_at(std::uint32_t point) const {
    std::vector<std::size_t> result;
    for (const std::size_t e : at_[point]) {
      if (rim_[e]) result.push_back(e);
    }
    return result;
  }

  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  std::size_t root(std::size_t e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }

 private:
  const std::vector<vec2>& points_;
  std::vector<std::vector<std::size_t>> at_;
  std::vector<SharedSide> edges_;
  std::vector<bool> rim_;
  std::vector<std::size_t> parent_;
};

// The two sides of the line that goes on through each point, or nothing.
using Passage = std::pair<std::size_t, std::size_t>;
constexpr std::size_t no_side = std::numeric_limits<std::size_t>::max();

std::vector<Passage> passages(const std::vector<PointRing>& rings, const SharedSides& sides, std::size_t points) {
  std::vector<Passage> result(points, {no_side, no_side});
  for (const PointRing& ring : rings) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t before = ring[(i + n - 1) % n];
      const std::uint32_t after = ring[(i + 1) % n];
      if (result[ring[i]].first != no_side || !sides.is_straight(before, ring[i], after)) continue;
      result[ring[i]] = {sides.number(before, ring[i]), sides.number(ring[i], after)};
    }
  }
  for (std::uint32_t p = 0; p < points; ++p) {
    const auto rim = sides.rim_at(p);
    if (rim.empty()) continue;
    // What the tiles cover together keeps its outline, whatever goes on through a point of it.
    const bool straight = rim.size() == 2 && sides.is_straight(sides.other(rim[0], p), p, sides.other(rim[1], p));
    result[p] = straight ? Passage{rim[0], rim[1]} : Passage{no_side, no_side};
  }
  return result;
}

// Walks from one side of a line in both directions.
TileMap::Line walked(std::size_t start, const SharedSides& sides, const std::vector<Passage>& passes) {
  const auto onward = [&](std::size_t edge, std::uint32_t point) {
    const Passage& pass = passes[point];
    if (pass.first == edge) return pass.second;
    return pass.second == edge ? pass.first : no_side;
  };
  TileMap::Line line;
  line.points = {sides.edge(start).high, sides.edge(start).low};
  for (std::size_t edge = onward(start, line.points.back()); edge != no_side;) {
    if (edge == start) {
      line.closed = true;
      return line;
    }
    line.points.push_back(sides.other(edge, line.points.back()));
    edge = onward(edge, line.points.back());
  }
  std::ranges::reverse(line.points);
  for (std::size_t edge = onward(start, line.points.back()); edge != no_side;) {
    line.points.push_back(sides.other(edge, line.points.back()));
    edge = onward(edge, line.points.back());
  }
  return line;
}

// The number of the line of each side.
std::vector<std::uint32_t> lay_lines(TileMap& map, SharedSides& sides, const std::vector<Passage>& passes) {
  for (const Passage& pass : passes) {
    if (pass.first != no_side) sides.join(pass.first, pass.second);
  }
  std::vector<std::uint32_t> of_root(sides.count(), TileMap::none);
  std::vector<std::uint32_t> of_side(sides.count());
  for (std::size_t e = 0; e < sides.count(); ++e) {
    std::uint32_t& line = of_root[sides.root(e)];
    if (line == TileMap::none) {
      line = static_cast<std::uint32_t>(map.lines.size());
      map.lines.push_back(walked(e, sides, passes));
      map.lines.back().rim = sides.is_rim(e);
    }
    of_side[e] = line;
  }
  return of_side;
}

void judge_points(TileMap& map, const SharedSides& sides, const std::vector<Passage>& passes,
                  const std::vector<std::uint32_t>& line_of_side) {
  const std::size_t count = map.points.size();
  map.junctions.assign(count, Junction::free);
  map.through.assign(count, TileMap::none);
  map.stems.assign(count, {});
  for (std::uint32_t p = 0; p < count; ++p) {
    if (passes[p].first != no_side) {
      map.junctions[p] = Junction::on_line;
      map.through[p] = line_of_side[passes[p].first];
    } else if (!sides.rim_at(p).empty()) {
      map.junctions[p] = Junction::fixed;
    }
    for (const std::size_t e : sides.at(p)) {
      if (e != passes[p].first && e != passes[p].second) map.stems[p].push_back(line_of_side[e]);
    }
  }
}

void append_tiles(TileMap& map, const std::vector<Tile>& tiles, const std::vector<PointRing>& rings, const SharedSides& sides,
                  const std::vector<Passage>& passes, const std::vector<std::uint32_t>& line_of_side) {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  std::vector<double> room(map.lines.size(), no_limit);
  std::vector<double> room_of_cut(map.lines.size(), no_limit);
  map.room_mm.assign(map.points.size(), no_limit);
  map.tiles.resize(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const PointRing& ring = rings[t];
    const std::size_t n = ring.size();
    const vec2 size = size_of(extent(tiles[t].outline_mm, tiles[t].axis));
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t before = ring[(i + n - 1) % n];
      const std::uint32_t after = ring[(i + 1) % n];
      const std::size_t onward = sides.number(ring[i], after);
      const std::uint32_t line = line_of_side[onward];
      // Both sides may be of one line, and yet meet in a corner: where a line ends on itself, or comes back to where it began.
      const Passage way{sides.number(before, ring[i]), onward};
      const bool corner = passes[ring[i]] != way && passes[ring[i]] != Passage{way.second, way.first};
      map.tiles[t].push_back({ring[i], line, corner});
      map.room_mm[ring[i]] = std::min({map.room_mm[ring[i]], size.x, size.y});
      const vec2 d = map.points[after] - map.points[ring[i]];
      const double across = size_of(extent(tiles[t].outline_mm, d / glm::length(d))).y;
      double& least = tiles[t].cut ? room_of_cut[line] : room[line];
      least = std::min(least, across);
    }
  }
  for (std::size_t l = 0; l < map.lines.size(); ++l) map.lines[l].room_mm = room[l] < no_limit ? room[l] : room_of_cut[l];
}

}  // namespace

TileMap tile_map(const std::vector<Tile>& tiles) {
  SharedPoints shared(typical_size(tiles));
  const std::vector<PointRing> rings = rings_of(tiles, shared);
  TileMap map;
  map.points = std::move(shared).points();
  SharedSides sides(rings, map.points);
  const std::vector<Passage> passes = passages(rings, sides, map.points.size());
  const std::vector<std::uint32_t> line_of_side = lay_lines(map, sides, passes);
  judge_points(map, sides, passes, line_of_side);
  append_tiles(map, tiles, rings, sides, passes, line_of_side);
  return map;
}

}  // namespace shatterpave::paving
