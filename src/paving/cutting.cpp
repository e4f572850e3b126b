// Cells lie on the lattice and share their sides, so they do not overlap; that is exact. Three things then round to the
// lattice: cutting at the outline, joining (which makes the border between two pieces the same for both), and taking off the
// joint; the joint that meets the straight side of a stone (a T) does so but for rounding. Together these move a side by less
// than `hairline_mm`, by which every stone draws back at the least. So stones stay apart and within the area whatever the
// joint.
#include "paving/cutting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;
using geometry::RegionIndex;

// Half a diagonal of the lattice, 0.71 µm, each for the T, for cutting and for taking off the joint; twice that
// for joining: 3.6 µm.
constexpr double hairline_mm = 0.005;
// A border between two pieces that was rounded for each lies twice, so far apart at the most: 1.42 µm, and some room.
constexpr double same_line_mm = 0.002;
// A piece with as many corners as its cell that lost less than 1% is whole to the eye; by eye.
constexpr double whole_share = 0.99;
// What is left of a cell that ends at the border but for rounding and the bend of a curved border is no piece.
constexpr double least_scrap = 0.005;
// Joined stones grow to this many whole ones at most, if there is another neighbour; by eye.
constexpr double largest_joined = 1.5;

// Two halves of a region with holes, cut through the middle of its first hole along the shorter way across.
std::vector<Polygon> without_holes(const Region& region) {
  if (region.holes.empty()) return {region.outline};
  const Box box = geometry::bounding_box(region.outline);
  const Box hole = geometry::bounding_box(region.holes.front());
  const vec2 middle = geometry::on_lattice(0.5 * (hole.low + hole.high));
  const bool upright = box.high.x - box.low.x >= box.high.y - box.low.y;
  const vec2 split_high = upright ? vec2{middle.x, box.high.y} : vec2{box.high.x, middle.y};
  const vec2 split_low = upright ? vec2{middle.x, box.low.y} : vec2{box.low.x, middle.y};
  const auto rectangle = [](vec2 low, vec2 high) { return Polygon{low, {high.x, low.y}, high, {low.x, high.y}}; };
  std::vector<Polygon> parts;
  for (const Polygon& half : {rectangle(box.low, split_high), rectangle(split_low, box.high)}) {
    for (const Region& part : geometry::intersection(half, region)) {
      for (Polygon& polygon : without_holes(part)) parts.push_back(std::move(polygon));
    }
  }
  return parts;
}

std::vector<Piece> pieces_of_cell(const Cells& cells, std::uint32_t cell, const Region& region, const RegionIndex& index,
                                  double rounding_mm2) {
  Polygon whole = geometry::cleaned(cells.outline(cell));
  if (whole.empty()) return {};
  if (!index.border_meets(geometry::bounding_box(whole))) {
    if (!index.contains(whole.front())) return {};
    return {{std::move(whole), cell, false}};
  }
  std::vector<Piece> pieces;
  const double full = geometry::area(whole);
  for (const Region& part : geometry::intersection(whole, region)) {
    if (geometry::area(part) < least_scrap * full) continue;
    for (Polygon& outline : without_holes(part)) {
      const double left = geometry::area(outline);
      const bool cut = full - left > rounding_mm2 && (outline.size() != whole.size() || left < whole_share * full);
      pieces.push_back({std::move(outline), cell, cut});
    }
  }
  return pieces;
}

// How much of the segments a and b, which run against each other, lies together.
double shared_length(vec2 a0, vec2 a1, vec2 b0, vec2 b1) {
  const vec2 d = a1 - a0;
  const double along = glm::length(d);
  const vec2 unit = d / along;
  const double s0 = glm::dot(b0 - a0, unit);
  const double s1 = glm::dot(b1 - a0, unit);
  const double low = std::max(0.0, std::min(s0, s1));
  const double high = std::min(along, std::max(s0, s1));
  if (high <= low || s0 == s1) return 0.0;
  const double h0 = cross(unit, b0 - a0);
  const double slope = (cross(unit, b1 - a0) - h0) / (s1 - s0);
  const bool together = std::abs(h0 + slope * (low - s0)) <= same_line_mm && std::abs(h0 + slope * (high - s0)) <= same_line_mm;
  return together ? high - low : 0.0;
}

double shared_length(const Polygon& a, const Polygon& b) {
  double total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      total += shared_length(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]);
    }
  }
  return total;
}

// `a` with its corners that lie beside corners of `b` taken there.
Polygon snapped(Polygon a, const Polygon& b) {
  for (vec2& p : a) {
    const auto near = std::ranges::find_if(b, [&](vec2 q) { return glm::length(q - p) <= same_line_mm; });
    if (near != b.end()) p = *near;
  }
  return a;
}

// `a` with the corners of `b` that lie on its sides as corners of its own.
Polygon refined(const Polygon& a, const Polygon& b) {
  Polygon result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const vec2 d = a[(i + 1) % a.size()] - a[i];
    const double along = glm::length(d);
    result.push_back(a[i]);
    if (along == 0.0) continue;
    std::vector<std::pair<double, vec2>> on_side;
    for (const vec2& q : b) {
      const double t = glm::dot(q - a[i], d) / along;
      const bool on = t > same_line_mm && t < along - same_line_mm && std::abs(cross(d, q - a[i])) <= same_line_mm * along;
      if (on) on_side.emplace_back(t, q);
    }
    std::ranges::sort(on_side, {}, &std::pair<double, vec2>::first);
    for (const auto& corner : on_side) result.push_back(corner.second);
  }
  return result;
}

// The sides of two polygons without those that both have, which run against each other.
std::vector<std::pair<vec2, vec2>> outer_sides(const Polygon& a, const Polygon& b) {
  std::vector<std::pair<vec2, vec2>> sides;
  for (const Polygon* polygon : {&a, &b}) {
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const std::pair side{(*polygon)[i], (*polygon)[(i + 1) % polygon->size()]};
      const auto opposite = std::ranges::find(sides, std::pair{side.second, side.first});
      if (opposite == sides.end()) {
        sides.push_back(side);
      } else {
        sides.erase(opposite);
      }
    }
  }
  return sides;
}

// The two pieces as one. Where they were cut, the border between them was rounded for each of them; it is made the same for
// both, and taken out. Nothing if they do not make one simple polygon.
std::optional<Polygon> joined(const Polygon& a, const Polygon& b) {
  const Polygon moved = snapped(a, b);
  const Polygon other = refined(b, moved);
  auto sides = outer_sides(refined(moved, other), other);
  if (sides.empty()) return std::nullopt;
  Polygon together;
  vec2 at = sides.front().first;
  while (!sides.empty()) {
    const auto next = std::ranges::find(sides, at, &std::pair<vec2, vec2>::first);
    if (next == sides.end()) return std::nullopt;
    together.push_back(at);
    at = next->second;
    sides.erase(next);
  }
  together = geometry::cleaned(together);
  if (!geometry::is_simple(together) || geometry::area(together) <= 0.0) return std::nullopt;
  return together;
}

// Joins small pieces to neighbours, smallest first.
class Joiner {
 public:
  Joiner(std::vector<Piece>& pieces, const Cells& cells, const StoneSize& size)
      : pieces_(pieces), cells_(cells), stone_area_(size.whole_face_mm2), joint_mm_(size.joint_mm) {
    of_cell_.resize(cells.count());
    cells_of_.resize(pieces.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      of_cell_[pieces[p].cell].push_back(p);
      cells_of_[p] = {pieces[p].cell};
    }
  }

  void join_small() {
    std::vector<double> face(pieces_.size(), stone_area_);
    parallel_for(pieces_.size(), [&](std::size_t p) {
      // Of the others only the odd ones at irregular spots can be small; to look at all would take as long as laying them.
      if (pieces_[p].cut || geometry::area(pieces_[p].outline_mm) < stone_area_) face[p] = face_area(pieces_[p]);
    });
    std::vector<std::size_t> small;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (is_small(face[p])) small.push_back(p);
    }
    std::ranges::stable_sort(small, [&](std::size_t a, std::size_t b) { return face[a] < face[b]; });
    for (const std::size_t p : small) {
      // It may have grown by another that joined it.
      if (!pieces_[p].outline_mm.empty() && is_small(face_area(pieces_[p]))) join(p);
    }
    std::erase_if(pieces_, [](const Piece& piece) { return piece.outline_mm.empty(); });
  }

 private:
  bool is_small(double face_area) const { return face_area < least_piece * stone_area_; }

  double face_area(const Piece& piece) const {
    double largest = 0.0;
    for (const Polygon& face : faces_of(piece.outline_mm, joint_mm_)) largest = std::max(largest, geometry::area(face));
    return largest;
  }

  struct Host {
    std::size_t piece = 0;
    double shared_mm = 0.0;
    bool too_large = false;  // with the small piece
  };

  std::vector<Host> hosts(std::size_t small) const {
    std::vector<std::size_t> near;
    for (const std::uint32_t cell : cells_of_[small]) {
      near.insert(near.end(), of_cell_[cell].begin(), of_cell_[cell].end());
      for (const std::uint32_t next : cells_.neighbours(cell)) {
        near.insert(near.end(), of_cell_[next].begin(), of_cell_[next].end());
      }
    }
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<Host> found;
    const double own = geometry::area(pieces_[small].outline_mm);
    for (const std::size_t p : near) {
      if (p == small || pieces_[p].outline_mm.empty()) continue;
      const double shared = shared_length(pieces_[small].outline_mm, pieces_[p].outline_mm);
      if (shared <= 0.0) continue;
      found.push_back({p, shared, own + geometry::area(pieces_[p].outline_mm) > largest_joined * stone_area_});
    }
    std::ranges::stable_sort(found, [](const Host& a, const Host& b) {
      return a.too_large != b.too_large ? b.too_large : a.shared_mm > b.shared_mm;
    });
    return found;
  }

  void join(std::size_t small) {
    for (const Host& host : hosts(small)) {
      auto together = joined(pieces_[small].outline_mm, pieces_[host.piece].outline_mm);
      if (!together) continue;
      Piece& into = pieces_[host.piece];
      if (geometry::area(pieces_[small].outline_mm) > geometry::area(into.outline_mm)) into.cell = pieces_[small].cell;
      into.outline_mm = std::move(*together);
      into.cut = true;
      for (const std::uint32_t cell : cells_of_[small]) {
        std::ranges::replace(of_cell_[cell], small, host.piece);
        cells_of_[host.piece].push_back(cell);
      }
      pieces_[small].outline_mm.clear();
      return;
    }
  }

  std::vector<Piece>& pieces_;
  const Cells& cells_;
  double stone_area_;
  double joint_mm_;
  std::vector<std::vector<std::size_t>> of_cell_;     // pieces of a cell
  std::vector<std::vector<std::uint32_t>> cells_of_;  // cells of a piece
};

bool is_convex(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = geometry::to_lattice(polygon[i]);
    const auto b = geometry::to_lattice(polygon[(i + 1) % n]);
    const auto c = geometry::to_lattice(polygon[(i + 2) % n]);
    if (geometry::side(a, b, c) != geometry::Side::left) return false;
  }
  return true;
}

// The face of a convex piece, if all its sides are left: each corner moves along its bisector.
std::optional<Polygon> convex_face(const Polygon& piece, double inset) {
  const std::size_t n = piece.size();
  std::vector<vec2> direction(n);
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 d = piece[(i + 1) % n] - piece[i];
    direction[i] = d / glm::length(d);
  }
  Polygon face(n);
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 before = left_of(direction[(i + n - 1) % n]);
    const vec2 after = left_of(direction[i]);
    face[i] = geometry::on_lattice(piece[i] + inset / (1.0 + glm::dot(before, after)) * (before + after));
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (glm::dot(face[(i + 1) % n] - face[i], direction[i]) <= 0.0) return std::nullopt;
  }
  if (!is_convex(face)) return std::nullopt;
  return face;
}

}  // namespace

std::vector<Polygon> faces_of(const Polygon& piece, double joint_mm) {
  const double inset = std::max(0.5 * joint_mm, hairline_mm);
  if (is_convex(piece)) {
    if (auto face = convex_face(piece, inset)) return {std::move(*face)};
  }
  std::vector<Polygon> faces;
  for (Region& region : geometry::offset({piece, {}}, -inset)) {
    if (geometry::is_simple(region.outline)) faces.push_back(std::move(region.outline));
  }
  return faces;
}

std::vector<Piece> pieces_within(const Cells& cells, const Region& region, const RegionIndex& index, const StoneSize& size) {
  std::vector<std::vector<Piece>> of_cell(cells.count());
  parallel_for(cells.count(), [&](std::size_t cell) {
    of_cell[cell] = pieces_of_cell(cells, static_cast<std::uint32_t>(cell), region, index, size.rounding_mm2);
  });
  std::vector<Piece> pieces;
  for (auto& some : of_cell) std::ranges::move(some, std::back_inserter(pieces));
  of_cell.clear();
  Joiner(pieces, cells, size).join_small();
  return pieces;
}

}  // namespace shatterpave::paving
