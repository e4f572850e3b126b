// Lines between tiles (tile_map.h) are moved aside as wholes, each by its own draw at either end: a line that ends on another
// slides along it, so rows stay rows and stones between straight lines keep straight sides, which lean a little. Points where
// no line goes on through move by themselves. All tiles about a point take the same new place, to the bit. Where a tile comes
// out too small, its outline meets itself, or it lies over another, its points are taken back halfway, as often as it takes.
// (Tiles that a hair parts where they taper have points of their own there, which may move by themselves.)
#include "paving/tiles/hand_setting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/tiles/overlapping.h"
#include "paving/tiles/tile_map.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;

// Parts of the narrowest tile beside a line, or about a point. Two lines of ± 0.22, evenly drawn, are 0.18 (standard deviation
// over mean) nearer or farther: with corners that move by themselves some 20 %, of the 12 to 22 % that photographs have.
constexpr double most_aside = 0.18;  // of a line
constexpr double most_lean = 0.04;   // of one end of it besides
constexpr double most_free = 0.2;    // of a free point along x and along y: photographs again
// Of the shortest side that ends there: what is drawn small stays small.
constexpr double free_of_side = 0.3;
// Of what it was.
constexpr double least_area = 1.0 / 3.0;
// Chains of points that stray from a straight side by no more are left out of it: twice the rounding, as in tile_map.h.
constexpr double straight_chain_mm = 0.003;
// As thick may be what two tiles have in common: both sides of a seam may be off by as much as a chain. Joints take more.
constexpr double widest_seam_mm = 0.008;
constexpr int most_rounds = 30;
constexpr int rounds_by_halves = 6;

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

class HandSetting {
 public:
  HandSetting(const std::vector<Tile>& tiles, double amount, std::uint64_t seed, Id pavement)
      : tiles_(tiles), map_(tile_map(tiles)), amount_(amount), seed_(seed), pavement_(pavement) {
    factors_.assign(map_.points.size(), 1.0);
    measure_lines();
    move_free_points();
    shift_lines();
    move_line_points();
    for (const vec2& step : steps_) farthest_ = std::max(farthest_, glm::length(step));
  }

  // Nothing where there is no way, which leaves the tiles as they were.
  std::optional<std::vector<Tile>> result() {
    for (int round = 0; round < most_rounds; ++round) {
      place();
      std::vector<std::optional<Polygon>> outlines(tiles_.size());
      parallel_for(tiles_.size(), [&](std::size_t t) { outlines[t] = lies_as_it_was(t) ? tiles_[t].outline_mm : outline(t); });
      std::vector<std::size_t> unsound;
      for (std::size_t t = 0; t < tiles_.size(); ++t) {
        if (!outlines[t]) unsound.push_back(t);
      }
      if (unsound.empty()) unsound = lying_over_another(outlines);
      if (unsound.empty()) return taken(std::move(outlines));
      for (const std::size_t t : unsound) take_back(t, round < rounds_by_halves ? 0.5 : 0.0);
    }
    return std::nullopt;
  }

 private:
  // What is left of the steps of the points near the tile.
  void take_back(std::size_t tile, double share) {
    for (const std::uint32_t point : points_near(tile)) factors_[point] *= share;
  }

  // Those of pairs of which one has moved.
  std::vector<std::size_t> lying_over_another(const std::vector<std::optional<Polygon>>& outlines) const {
    std::vector<Polygon> placed;
    placed.reserve(outlines.size());
    for (const auto& outline : outlines) placed.push_back(*outline);
    std::vector<std::size_t> found;
    for (const auto& [a, b] : overlapping_pairs(placed, widest_seam_mm)) {
      if (lies_as_it_was(a) && lies_as_it_was(b)) continue;
      found.push_back(a);
      found.push_back(b);
    }
    return found;
  }

  // Of a line at one of its points: where along it, and its direction there.
  struct Mark {
    double along = 0.0;
    vec2 direction{1.0, 0.0};
  };

  Id at_point(std::uint32_t point) const {
    const auto place = geometry::to_lattice(map_.points[point]);
    return pavement_.child(static_cast<std::uint64_t>(place.x)).child(static_cast<std::uint64_t>(place.y));
  }
  double draw(Id id, std::uint32_t index) const {
    return amount_ * (2.0 * uniform(seed_, {Stream::hand_line, id, index}) - 1.0);
  }

  void measure_lines() {
    mark_lines();
    number_points();
    measure_sides();
  }

  void mark_lines() {
    marks_.resize(map_.lines.size());
    for (std::size_t l = 0; l < map_.lines.size(); ++l) {
      const auto& line = map_.lines[l];
      const std::size_t n = line.points.size();
      double along = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        // Of a closed line the last point is the first again.
        const std::size_t before = i > 0 ? i - 1 : (line.closed ? n - 2 : 0);
        const std::size_t after = i + 1 < n ? i + 1 : (line.closed ? 1 : n - 1);
        const vec2 d = at(line.points[after]) - at(line.points[before]);
        if (i > 0) along += glm::length(at(line.points[i]) - at(line.points[i - 1]));
        marks_[l].push_back({along, d / glm::length(d)});
      }
    }
  }

  void number_points() {
    numbers_.resize(map_.lines.size());
    for (std::size_t l = 0; l < map_.lines.size(); ++l) {
      const auto& points = map_.lines[l].points;
      for (std::size_t i = 0; i < points.size(); ++i) numbers_[l].emplace_back(points[i], i);
      std::ranges::sort(numbers_[l]);
    }
  }

  void measure_sides() {
    shortest_.assign(map_.points.size(), std::numeric_limits<double>::infinity());
    for (const auto& line : map_.lines) {
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const double length = glm::length(at(line.points[i + 1]) - at(line.points[i]));
        for (const std::uint32_t p : {line.points[i], line.points[i + 1]}) shortest_[p] = std::min(shortest_[p], length);
      }
    }
  }

  vec2 at(std::uint32_t point) const { return map_.points[point]; }

  void move_free_points() {
    steps_.assign(map_.points.size(), vec2{0.0, 0.0});
    for (std::uint32_t p = 0; p < map_.points.size(); ++p) {
      if (map_.junctions[p] != Junction::free) continue;
      const double room = std::min(most_free * map_.room_mm[p], free_of_side * shortest_[p]);
      steps_[p] = room * vec2{draw(at_point(p), 0), draw(at_point(p), 1)};
    }
  }

  // How far each line is moved to its left at either end.
  void shift_lines() {
    shifts_.resize(map_.lines.size());
    for (std::size_t l = 0; l < map_.lines.size(); ++l) {
      const auto& line = map_.lines[l];
      if (line.rim) continue;
      const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return geometry::to_lattice(at(a)) < geometry::to_lattice(at(b));
      };
      const Id id = at_point(*std::ranges::min_element(line.points, before))
                        .child(at_point(*std::ranges::max_element(line.points, before)).value());
      const double aside = most_aside * line.room_mm * draw(id, 0);
      shifts_[l] = {aside, aside};
      if (line.closed) continue;
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const std::uint32_t point = end == 0 ? line.points.front() : line.points.back();
        const Mark& mark = end == 0 ? marks_[l].front() : marks_[l].back();
        if (map_.junctions[point] == Junction::on_line) {
          shifts_[l][end] += most_lean * line.room_mm * draw(id, static_cast<std::uint32_t>(end) + 1);
        } else if (map_.junctions[point] == Junction::free) {
          shifts_[l][end] = glm::dot(steps_[point], left_of(mark.direction));
        }
      }
    }
  }

  // A side of a tile on its line: the place there of the point where it begins, and whether the tile goes along the line.
  struct Start {
    std::size_t index = 0;
    bool forwards = true;
  };

  // Of the side from `from` to `next`, its neighbour on the line. A line may come back to a point where another goes on, or end
  // on itself, so the point alone does not tell the place.
  std::optional<Start> start_on(std::uint32_t line, std::uint32_t from, std::uint32_t next) const {
    const auto& points = map_.lines[line].points;
    auto place = std::ranges::lower_bound(numbers_[line], from, {}, &std::pair<std::uint32_t, std::size_t>::first);
    for (; place != numbers_[line].end() && place->first == from; ++place) {
      const std::size_t index = place->second;
      if (index + 1 < points.size() && points[index + 1] == next) return Start{index, true};
      if (index > 0 && points[index - 1] == next) return Start{index, false};
    }
    return std::nullopt;
  }

  void move_line_points() {
    std::vector<std::size_t> place(map_.points.size(), nowhere);
    for (std::uint32_t l = 0; l < map_.lines.size(); ++l) {
      for (std::size_t i = 0; i < map_.lines[l].points.size(); ++i) {
        const std::uint32_t p = map_.lines[l].points[i];
        if (map_.through[p] == l && place[p] == nowhere) place[p] = i;
      }
    }
    for (std::uint32_t p = 0; p < map_.points.size(); ++p) {
      if (map_.junctions[p] == Junction::on_line) steps_[p] = step_on_line(p, place[p]);
    }
  }

  // Aside with the line, and along it with what ends on it.
  vec2 step_on_line(std::uint32_t point, std::size_t index) const {
    const std::uint32_t l = map_.through[point];
    const Mark& mark = marks_[l][index];
    const double share = marks_[l].back().along > 0.0 ? mark.along / marks_[l].back().along : 0.0;
    const double aside = (1.0 - share) * shifts_[l][0] + share * shifts_[l][1];
    const vec2 normal = left_of(mark.direction);
    double along = 0.0;
    const auto& stems = map_.stems[point];
    if (stems.size() == 1) {
      const bool first = map_.lines[stems[0]].points.front() == point;
      const vec2 across = left_of(first ? marks_[stems[0]].front().direction : marks_[stems[0]].back().direction);
      const double slant = glm::dot(mark.direction, across);
      // Of a stem that nearly runs along the line, the end stays.
      constexpr double least_slant = 0.3;
      if (std::abs(slant) >= least_slant) {
        along = (shifts_[stems[0]][first ? 0 : 1] - aside * glm::dot(normal, across)) / slant;
      }
    } else if (stems.size() > 1) {
      along = std::min(most_free * map_.room_mm[point], free_of_side * shortest_[point]) * draw(at_point(point), 0);
    }
    return aside * normal + along * mark.direction;
  }

  // The new places, and the order of points along each line by them.
  void place() {
    placed_.resize(map_.points.size());
    for (std::size_t p = 0; p < map_.points.size(); ++p) {
      placed_[p] = geometry::on_lattice(map_.points[p] + factors_[p] * steps_[p]);
    }
    orders_.resize(map_.lines.size());
    ranks_.resize(map_.lines.size());
    parallel_for(map_.lines.size(), [&](std::size_t l) {
      const auto& points = map_.lines[l].points;
      std::vector<std::pair<double, std::size_t>> keyed(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        keyed[i] = {marks_[l][i].along + factors_[points[i]] * glm::dot(steps_[points[i]], marks_[l][i].direction), i};
      }
      std::ranges::sort(keyed);
      orders_[l].resize(points.size());
      ranks_[l].resize(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        orders_[l][i] = points[keyed[i].second];
        ranks_[l][keyed[i].second] = i;
      }
    });
  }

  // Appends what lies on a line between the corners `from` and `to` of a tile, numbers of its visits; false where these have
  // come to lie the other way round.
  bool append_between(const std::vector<TileMap::Visit>& visits, std::size_t from, std::size_t to, Polygon& outline) const {
    const std::uint32_t l = visits[from].line;
    const std::size_t sides = (to + visits.size() - from) % visits.size();
    const auto start = start_on(l, visits[from].point, visits[(from + 1) % visits.size()].point);
    if (!start) return false;
    const auto& [index_a, forwards] = *start;
    const auto& points = map_.lines[l].points;
    if (forwards ? index_a + sides >= points.size() : index_a < sides) return false;
    const std::size_t index_b = forwards ? index_a + sides : index_a - sides;
    if (points[index_b] != visits[to].point) return false;
    const auto& order = orders_[l];
    const std::size_t a = ranks_[l][index_a];
    const std::size_t b = ranks_[l][index_b];
    if (forwards != (a < b)) return false;
    const std::size_t first = outline.size();
    for (std::size_t i = std::min(a, b) + 1; i < std::max(a, b); ++i) outline.push_back(placed_[order[i]]);
    if (!forwards) std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(first), outline.end());
    const vec2 start_mm = placed_[visits[from].point];
    const vec2 d = placed_[visits[to].point] - start_mm;
    const bool straight = std::all_of(outline.begin() + static_cast<std::ptrdiff_t>(first), outline.end(), [&](vec2 p) {
      return std::abs(cross(d, p - start_mm)) <= straight_chain_mm * glm::length(d);
    });
    if (straight) outline.resize(first);
    return true;
  }

  // The points of a tile, and those along its sides that may come to lie between them.
  std::vector<std::uint32_t> points_near(std::size_t tile) const {
    std::vector<std::uint32_t> found;
    const auto& visits = map_.tiles[tile];
    for (std::size_t i = 0; i < visits.size(); ++i) {
      found.push_back(visits[i].point);
      const std::uint32_t l = visits[i].line;
      if (map_.lines[l].closed) continue;
      const auto start = start_on(l, visits[i].point, visits[(i + 1) % visits.size()].point);
      if (!start) continue;
      const auto& marks = marks_[l];
      std::size_t first = start->forwards ? start->index : start->index - 1;
      std::size_t last = first + 1;
      const double low = marks[first].along - farthest_;
      const double high = marks[last].along + farthest_;
      while (first > 0 && marks[first - 1].along >= low) --first;
      while (last + 1 < marks.size() && marks[last + 1].along <= high) ++last;
      for (std::size_t k = first; k <= last; ++k) found.push_back(map_.lines[l].points[k]);
    }
    return found;
  }

  // Whether nothing moves that could change the outline of the tile.
  bool lies_as_it_was(std::size_t tile) const {
    if (std::ranges::any_of(map_.tiles[tile], [&](const TileMap::Visit& visit) { return factors_[visit.point] > 0.0; })) {
      return false;
    }
    return std::ranges::all_of(points_near(tile), [&](std::uint32_t point) { return factors_[point] == 0.0; });
  }

  std::optional<Polygon> outline(std::size_t tile) const {
    const auto& visits = map_.tiles[tile];
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < visits.size(); ++i) {
      if (visits[i].corner) corners.push_back(i);
    }
    if (corners.size() < 3) return std::nullopt;
    Polygon result;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::size_t from = corners[c];
      const std::size_t to = corners[(c + 1) % corners.size()];
      result.push_back(placed_[visits[from].point]);
      if (map_.lines[visits[from].line].closed) {
        // Round a closed line points keep their order.
        for (std::size_t i = from + 1; i % visits.size() != to; ++i) result.push_back(placed_[visits[i % visits.size()].point]);
      } else if (!append_between(visits, from, to, result)) {
        return std::nullopt;
      }
    }
    result = geometry::cleaned(result);
    if (result.size() < 3 || !geometry::is_simple(result)) return std::nullopt;
    if (geometry::area(result) < least_area * geometry::area(tiles_[tile].outline_mm)) return std::nullopt;
    return result;
  }

  std::vector<Tile> taken(std::vector<std::optional<Polygon>> outlines) const {
    std::vector<Tile> result;
    result.reserve(tiles_.size());
    for (std::size_t t = 0; t < tiles_.size(); ++t) result.push_back({std::move(*outlines[t]), tiles_[t].axis, tiles_[t].cut});
    return result;
  }

  const std::vector<Tile>& tiles_;
  TileMap map_;
  double amount_;
  std::uint64_t seed_;
  Id pavement_;
  std::vector<std::vector<Mark>> marks_;  // of each line, of each of its points
  std::vector<double> shortest_;          // side at each point
  std::vector<std::array<double, 2>> shifts_;
  std::vector<vec2> steps_;
  double farthest_ = 0.0;  // of all steps
  std::vector<double> factors_;
  std::vector<vec2> placed_;
  std::vector<std::vector<std::pair<std::uint32_t, std::size_t>>>
      numbers_;                                     // points of each line by number, and where they stand
  std::vector<std::vector<std::uint32_t>> orders_;  // points of each line as they now lie
  std::vector<std::vector<std::size_t>> ranks_;     // of each, its place in that order
};

}  // namespace

std::vector<Tile> hand_set(std::vector<Tile> tiles, double amount, std::uint64_t seed, Id pavement) {
  if (amount == 0.0 || tiles.empty()) return tiles;
  std::optional<std::vector<Tile>> moved = HandSetting(tiles, amount, seed, pavement).result();
  return moved ? std::move(*moved) : tiles;
}

Cells hand_set(const Cells& cells, double amount, std::uint64_t seed, Id pavement) {
  std::vector<Tile> tiles;
  std::vector<double> sizes;
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    Tile tile{{}, cells.axis[cell], !cells.part.empty() && cells.part[cell]};
    for (std::size_t side = cells.first[cell]; side < cells.first[cell + 1]; ++side) {
      tile.outline_mm.push_back(cells.corners[cells.corner[side]]);
    }
    tile.outline_mm = geometry::cleaned(tile.outline_mm);
    if (tile.outline_mm.size() < 3) continue;
    tiles.push_back(std::move(tile));
    sizes.push_back(cells.size_of(cell));
  }
  Cells set = cells_of(hand_set(std::move(tiles), amount, seed, pavement));
  if (!cells.size.empty()) set.size = std::move(sizes);
  return set;
}

Stock hand_stock(Stock stock, double joint_mm, double amount) {
  if (amount == 0.0) return stock;
  // Both sides of a tile may be moved out, and a corner of its stone into the joint.
  const double longer = 1.0 + 2.0 * amount * (most_aside + most_lean);
  const vec2 joint{joint_mm, joint_mm};
  stock.size_mm = longer * (stock.size_mm + joint);
  if (stock.turned_size_mm != vec2{0.0, 0.0}) stock.turned_size_mm = longer * (stock.turned_size_mm + joint);
  stock.area_mm2 = stock.size_mm.x * stock.size_mm.y;
  return stock;
}

}  // namespace shatterpave::paving
