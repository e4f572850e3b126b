// Cells lie on the lattice and share their sides, so they do not overlap; that is exact. Three things then round to the
// lattice: cutting at the outline, joining (which makes the border between two pieces the same for both), and taking off the
// joint; the joint that meets the straight side of a stone (a T) does so but for rounding. Together these move a side by less
// than `hairline_mm`, by which every stone draws back at the least. So stones stay apart and within the area whatever the
// joint.
//
// Straight sides depart from the cell by less than `largest_bulge` of the joint, where a stone draws back by half of it: so
// every stone still lies in its cell. Only whole pieces get them; those that are cut or joined stay as
// the cells are, which share their sides.
#include "paving/tiles/cutting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/contacts.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "paving/tiles/filling.h"
#include "paving/tiles/joining.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;
using geometry::RegionIndex;

// Half a diagonal of the lattice, 0.71 µm, each for the T, for cutting and for taking off the joint; twice that
// for joining: 3.6 µm.
// Pieces that are cut anew are rounded up to twice more, and once more when they are trimmed: 5.7 µm.
constexpr double hairline_mm = 0.01;
// A piece with as many corners as its cell that lost less than 1% is whole to the eye; by eye.
constexpr double whole_share = 0.99;
// What is left of a cell that ends at the border but for rounding and the bend of a curved border is no piece: less than this
// part of it, or a strip thinner than this part of a stone's longer side. By eye: the joint along the border is wider by as
// much.
constexpr double least_scrap = 0.001;
constexpr double thinnest_scrap = 0.015;
// A stone that reaches beyond its stock by no more than this part of its longer side is trimmed, more is cut: bends of rows are
// less. By eye: two such stones side by side leave a joint that is wider by as much.
constexpr double most_trimmed = 0.06;
// Of a stone: smaller faces are scraps that no one lays. The widest disc in one is a tenth of a square stone's side at the
// most.
constexpr double least_face = 0.004;

// What is left of a cell without what is thinner than `thinnest_scrap`: nothing of a strip. What would be a bare spot stays,
// however long a needle it ends in; that is taken off, so that the other sides stay as those of the neighbours are.
std::vector<Region> without_strips(const Region& region, double longer_mm) {
  const double thinnest_mm = thinnest_scrap * longer_mm;
  if (stoutness_mm(region.outline) >= 2.0 * thinnest_mm) return {region};
  if (geometry::offset(region, -0.25 * widest_bare * longer_mm).empty()) return {};
  std::vector<Region> broad;
  for (const Region& core : geometry::offset(region, -0.5 * thinnest_mm)) {
    std::ranges::move(geometry::offset(core, 0.5 * thinnest_mm + hairline_mm), std::back_inserter(broad));
  }
  return geometry::difference(region, geometry::difference(region, broad));
}

std::vector<Piece> pieces_of_cell(const Cells& cells, std::uint32_t cell, const Region& region, const RegionIndex& index,
                                  const StoneSize& unscaled) {
  Polygon whole = geometry::cleaned(cells.outline(cell));
  if (whole.empty()) return {};
  const bool part = !cells.part.empty() && cells.part[cell];
  const vec2 axis = cells.axis[cell];
  const double factor = cells.size_of(cell);
  const StoneSize size = unscaled.times(factor);
  if (!index.border_meets(geometry::bounding_box(whole))) {
    if (!index.contains(whole.front())) return {};
    return {{std::move(whole), cell, part, axis, factor}};
  }
  std::vector<Piece> pieces;
  const double full = geometry::area(whole);
  for (const Region& inside : geometry::intersection(whole, region)) {
    for (const Region& broad : without_strips(inside, size.longer_mm)) {
      if (geometry::area(broad) < least_scrap * full) continue;
      for (Polygon& outline : without_holes(broad)) {
        const double left = geometry::area(outline);
        const bool cut = full - left > size.rounding_mm2 && (outline.size() != whole.size() || left < whole_share * full);
        pieces.push_back({std::move(outline), cell, part || cut, axis, factor});
      }
    }
  }
  return pieces;
}

// Takes a whole piece to the straight sides that its stone is laid by.
void straighten(Piece& piece, const Cells& cells, const Region& region, const RegionIndex& index) {
  if (piece.cut || piece.outline_mm.size() < 5) return;
  Polygon straight;
  for (std::size_t side = cells.first[piece.cell]; side < cells.first[piece.cell + 1]; ++side) {
    const bool left_out = !cells.left_out.empty() && cells.left_out[side];
    if (!left_out && !cells.bulging[side]) straight.push_back(cells.corners[cells.corner[side]]);
  }
  straight = geometry::cleaned(straight);
  if (straight.size() < 3 || geometry::area(straight) <= 0.0 || !geometry::is_simple(straight)) return;
  if (index.border_meets(geometry::bounding_box(straight))) {
    auto parts = geometry::intersection(straight, region);
    if (parts.size() != 1 || !parts.front().holes.empty()) return;
    straight = std::move(parts.front().outline);
  }
  piece.outline_mm = std::move(straight);
}

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

// How far the faces of a piece reach, along its axis and across it.
geometry::Box reach_of_faces(const Piece& piece, double joint_mm) {
  std::optional<geometry::Box> reach;
  for (const Polygon& face : faces_of(piece.outline_mm, joint_mm)) {
    const geometry::Box box = extent(face, piece.axis);
    reach = reach ? geometry::Box{glm::min(reach->low, box.low), glm::max(reach->high, box.high)} : box;
  }
  return reach.value_or(geometry::Box{});
}

// The piece in parts that fit the stock, but for what is trimmed.
void append_fitting(Piece piece, const StoneSize& unscaled, std::vector<Piece>& fitting) {
  const StoneSize size = unscaled.times(piece.size);
  const vec2 joint{size.joint_mm, size.joint_mm};
  const double allowed = most_trimmed * size.longer_mm;
  const vec2 stock = size.stock.size_for(piece.axis);
  const vec2 most = stock + vec2{allowed, allowed};
  const auto is_within = [&](vec2 reach) { return reach.x <= most.x && reach.y <= most.y; };
  // Faces end half a joint before their piece on either side, before sharp corners more.
  if (is_within(size_of(extent(piece.outline_mm, piece.axis)) - joint)) {
    fitting.push_back(std::move(piece));
    return;
  }
  const geometry::Box reach = reach_of_faces(piece, size.joint_mm);
  if (is_within(size_of(reach))) {
    fitting.push_back(std::move(piece));
    return;
  }
  const vec2 counts = (size_of(reach) + joint) / (stock + joint);
  const bool by_length = counts.x >= counts.y;
  const double count = std::max(2.0, std::ceil(std::max(counts.x, counts.y) - 1e-6));
  const double low = (by_length ? reach.low.x : reach.low.y) - 0.5 * size.joint_mm;
  const double step = ((by_length ? size_of(reach).x : size_of(reach).y) + size.joint_mm) / count;
  std::vector<double> places;
  for (double i = 1.0; i < count; i += 1.0) places.push_back(low + i * step);
  for (Polygon& part : cut_across(piece.outline_mm, piece.axis, by_length, places)) {
    append_fitting({std::move(part), piece.cell, true, piece.axis, piece.size}, unscaled, fitting);
  }
}

std::vector<Piece> fitting_pieces(std::vector<Piece> pieces, const StoneSize& size) {
  std::vector<Piece> fitting;
  fitting.reserve(pieces.size());
  for (Piece& piece : pieces) append_fitting(std::move(piece), size, fitting);
  return fitting;
}

// Cuts off what no stone of its piece can cover, for a neighbour to take.
std::vector<Piece> without_bare_ends(std::vector<Piece> pieces, const StoneSize& size) {
  std::vector<std::vector<Region>> ends(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t p) {
    if (pieces[p].cut) ends[p] = bare_ends(pieces[p].outline_mm, size.times(pieces[p].size));
  });
  const std::size_t count = pieces.size();
  for (std::size_t p = 0; p < count; ++p) {
    if (ends[p].empty()) continue;
    const std::vector<Region> left = geometry::difference(Region{pieces[p].outline_mm, {}}, ends[p]);
    // An end that is cut off lies at the border of its piece, or it stays.
    if (left.empty() || std::ranges::any_of(left, [](const Region& part) { return !part.holes.empty(); })) continue;
    const Piece piece = pieces[p];
    pieces[p].outline_mm = left.front().outline;
    for (std::size_t i = 1; i < left.size(); ++i) pieces.push_back({left[i].outline, piece.cell, true, piece.axis, piece.size});
    for (const Region& end : ends[p]) pieces.push_back({end.outline, piece.cell, true, piece.axis, piece.size});
  }
  return pieces;
}

}  // namespace

std::vector<Polygon> faces_of(const Polygon& piece, double joint_mm) {
  const double inset = std::max(0.5 * joint_mm, hairline_mm);
  if (is_convex(piece)) {
    if (auto face = convex_face(piece, inset)) return {std::move(*face)};
  }
  std::vector<Region> regions = geometry::offset({piece, {}}, -inset);
  // Where a neck is as wide as the joint, what it joins still meets in a point.
  if (regions.size() > 1 || !std::ranges::all_of(regions, [](const Region& r) { return geometry::is_simple(r.outline); })) {
    regions = geometry::parted(std::move(regions));
  }
  std::vector<Polygon> faces;
  for (Region& region : regions) {
    if (geometry::is_simple(region.outline)) faces.push_back(std::move(region.outline));
  }
  return faces;
}

std::vector<Region> bare_ends(const Polygon& piece, const StoneSize& size) {
  const double least_mm = 0.5 * widest_bare * size.longer_mm;
  if (size.joint_mm <= least_mm) return {};
  constexpr double miter_limit = 5.0;
  std::vector<Polygon> covered;
  for (const Polygon& face : faces_of(piece, size.joint_mm)) {
    for (const Region& grown : geometry::offset({face, {}}, 0.5 * size.joint_mm + hairline_mm, miter_limit)) {
      covered.push_back(grown.outline);
    }
  }
  std::vector<Region> ends;
  for (Region& left : geometry::difference({piece, {}}, covered)) {
    if (left.holes.empty() && !geometry::offset(left, -0.5 * least_mm).empty()) ends.push_back(std::move(left));
  }
  return ends;
}

std::vector<Polygon> laid_faces(const Piece& piece, const StoneSize& size_asked) {
  const StoneSize size = size_asked.times(piece.size);
  std::vector<Polygon> laid;
  for (const Polygon& face : faces_of(piece.outline_mm, size.joint_mm)) {
    for (Polygon& part : trimmed(face, piece.axis, size.stock)) laid.push_back(std::move(part));
  }
  std::ranges::stable_sort(laid, [](const auto& a, const auto& b) { return geometry::area(a) > geometry::area(b); });
  const double least = least_face * size.whole_face_mm2;
  while (laid.size() > 1 && geometry::area(laid.back()) < least) laid.pop_back();
  return laid;
}

std::vector<Piece> pieces_within(const Cells& cells, const Region& region, const RegionIndex& index, const StoneSize& size) {
  std::vector<std::vector<Piece>> of_cell(cells.count());
  parallel_for(cells.count(), [&](std::size_t cell) {
    of_cell[cell] = pieces_of_cell(cells, static_cast<std::uint32_t>(cell), region, index, size);
  });
  std::vector<Piece> pieces;
  for (auto& some : of_cell) std::ranges::move(some, std::back_inserter(pieces));
  of_cell.clear();
  pieces = without_small(fitting_pieces(std::move(pieces), size), size);
  const double smallest = cells.size.empty() ? 1.0 : std::ranges::min(cells.size);
  if (size.joint_mm > 0.5 * widest_bare * smallest * size.longer_mm) {
    // What one takes may leave an end of its own; a few rounds leave nothing but what has no neighbour.
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) pieces = without_small(without_bare_ends(std::move(pieces), size), size);
  }
  if (!cells.bulging.empty()) {
    parallel_for(pieces.size(), [&](std::size_t p) { straighten(pieces[p], cells, region, index); });
  }
  return pieces;
}

}  // namespace shatterpave::paving
