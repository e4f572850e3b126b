// Cells lie on the lattice and share their sides, so they do not overlap; that is exact. Three things then round to the
// lattice: cutting at the outline, joining (which makes the border between two pieces the same for both), and taking off the
// joint; the joint that meets the straight side of a stone (a T) does so but for rounding. Together these move a side by less
// than `hairline_mm`, by which every stone draws back at the least. So stones stay apart and within the area whatever the
// joint.
//
// Straight sides depart from the cell by less than `largest_bulge` of the joint, where a stone draws back by half of it: so
// every stone still lies in its cell. Only whole pieces get them; those that are cut or joined stay as
// the cells are, which share their sides.
#include "paving/cutting.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "paving/joining.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;
using geometry::RegionIndex;

// Half a diagonal of the lattice, 0.71 µm, each for the T, for cutting and for taking off the joint; twice that
// for joining: 3.6 µm.
constexpr double hairline_mm = 0.005;
// A piece with as many corners as its cell that lost less than 1% is whole to the eye; by eye.
constexpr double whole_share = 0.99;
// What is left of a cell that ends at the border but for rounding and the bend of a curved border is no piece.
constexpr double least_scrap = 0.005;

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

// Takes a whole piece to the straight sides that its stone is laid by.
void straighten(Piece& piece, const Cells& cells) {
  if (piece.cut || piece.outline_mm.size() < 5) return;
  Polygon straight = piece.outline_mm;
  for (std::size_t side = cells.first[piece.cell]; side < cells.first[piece.cell + 1]; ++side) {
    if (cells.bulging[side]) std::erase(straight, cells.corners[cells.corner[side]]);
  }
  straight = geometry::cleaned(straight);
  if (geometry::area(straight) > 0.0 && geometry::is_simple(straight)) piece.outline_mm = std::move(straight);
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
  pieces = without_small(std::move(pieces), cells, size);
  if (!cells.bulging.empty()) {
    parallel_for(pieces.size(), [&](std::size_t p) { straighten(pieces[p], cells); });
  }
  return pieces;
}

}  // namespace shatterpave::paving
