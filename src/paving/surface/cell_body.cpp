#include "paving/surface/cell_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/functions.h"

namespace shatterpave::paving {

namespace {

using geometry::BezierPatch;
using geometry::Polygon;

// Patches along a side of the square; by eye: of a cobble the rim is round.
constexpr std::size_t patches_aside = 4;
// For derivatives at the nodes, as differences; the square's side is 2.
constexpr double difference = 1e-3;

// Exponents of the roundest outline, an ellipse, and of the one with the sharpest corners.
constexpr double least_exponent = 2.0;
constexpr double most_exponent = 9.0;

// The part of the height of a cell that the filling hides. By eye: cobbles are rounder below than the sand is deep, the skin
// between scales is a fold.
constexpr double hidden_of_cobble = 0.3;
constexpr double hidden_of_scale = 0.15;
// Of a scale, where its root is, over its tip; how much lower it is at its flanks; how steep its rim. By eye.
constexpr double root_height = 0.22;
constexpr double flank_fall = 0.45;
// A cobble is tilted by up to 4°, a scale hardly.
constexpr double cobble_slope = 0.07;
constexpr double scale_slope = 0.015;

// Patches depart from the superellipse by less than the rest of this.
constexpr double part_of_outline = 0.985;

// How much larger a scale is all round than its cell. By eye: a sixth where the tip reaches into half of the next.
double swelling(double overlap) { return 0.35 * overlap; }

double hidden_part(CellForm form) { return form == CellForm::cobble ? hidden_of_cobble : hidden_of_scale; }

// Of the height above the filling: how much the seed makes of it, at the most.
double whole_height_mm(const Pavement& pavement) {
  return pavement.surface.height_mm / (1.0 - hidden_part(pavement.cell.form));
}

class CellShaper {
 public:
  CellShaper(const Polygon& outline, const CellDraws& draws) : draws_(draws), middle_(geometry::centroid(outline)) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const vec2 side = outline[(i + 1) % outline.size()] - outline[i];
      const double length = glm::length(side);
      if (length == 0.0) continue;
      const vec2 outwards = -left_of(side / length);
      const double away = glm::dot(outwards, outline[i] - middle_);
      if (away > 0.0) sides_.push_back(outwards / away);
    }
    constexpr std::size_t rays = 16;
    for (std::size_t k = 0; k < rays; ++k) {
      mean_mm_ += extent_mm(Angle::degrees(360.0 * static_cast<double>(k) / static_cast<double>(rays)).direction()) / rays;
    }
    ahead_mm_ = extent_mm(draws.heading);
    behind_mm_ = extent_mm(-draws.heading);
    aside_mm_ = 0.5 * (extent_mm(left_of(draws.heading)) + extent_mm(-left_of(draws.heading)));
  }

  // Of (s, t) in [-1, 1]².
  vec3 at(double s, double t) const {
    const vec2 disc{s * std::sqrt(1.0 - 0.5 * t * t), t * std::sqrt(1.0 - 0.5 * s * s)};
    return draws_.form == CellForm::cobble ? cobble_at(disc) : scale_at(disc);
  }

 private:
  // From the middle to the superellipse along a unit vector.
  double extent_mm(vec2 along) const {
    double sum = 0.0;
    for (const vec2& side : sides_) {
      const double part = glm::dot(side, along);
      if (part > 0.0) sum += power(part, draws_.exponent);
    }
    return part_of_outline * power(sum, -1.0 / draws_.exponent);
  }

  // The same of a cobble, with its dents: by the second harmonic of the direction.
  double own_mm(vec2 along) const {
    const double twice = along.x * along.x - along.y * along.y;
    const double cross_twice = 2.0 * along.x * along.y;
    return extent_mm(along) * (1.0 - draws_.dent.x * 0.5 * (1.0 + twice) - draws_.dent.y * 0.5 * (1.0 + cross_twice));
  }

  // The place in the superellipse of a point of the disc; about the middle a circle, so that directions there do not matter.
  vec2 in_outline(vec2 disc) const {
    const double square = std::min(1.0, glm::dot(disc, disc));
    if (square == 0.0) return {0.0, 0.0};
    // Flat at the rim, so that what is narrow does not fold over there.
    const double outer = square * (2.0 - square);
    return (mean_mm_ + outer * (own_mm(disc / glm::length(disc)) - mean_mm_)) * disc;
  }

  // A pebble: seen from the side, an ellipse, upright at its rim.
  vec3 cobble_at(vec2 disc) const {
    const double square = glm::dot(disc, disc);
    const vec2 outwards = 0.5 * (3.0 - square) * disc;
    const double inner = 1.0 - square;
    const vec2 place = in_outline(outwards) + inner * inner * mean_mm_ * draws_.apex;
    const double height = draws_.height_mm * inner;
    return {middle_.x + place.x, middle_.y + place.y, inner * glm::dot(draws_.slope, place) + height};
  }

  // A plate that rises from its root to its tip, which is drawn out, and falls off at its rim.
  vec3 scale_at(vec2 disc) const {
    const double square = glm::dot(disc, disc);
    // Its flanks lie over one another, too, so that little of the skin below is seen.
    const vec2 place = (1.0 + swelling(draws_.overlap)) * in_outline(disc);
    const double along_mm = glm::dot(place, draws_.heading);
    const double across_mm = cross(draws_.heading, place);
    const double along = along_mm / ((1.0 + swelling(draws_.overlap)) * (along_mm > 0.0 ? ahead_mm_ : behind_mm_));
    const double across = across_mm / ((1.0 + swelling(draws_.overlap)) * aside_mm_);
    // The length of a scale is ahead and behind.
    const double reach_mm = draws_.overlap * (ahead_mm_ + behind_mm_);
    const vec2 drawn_out = along > 0.0 ? along * along * reach_mm * draws_.heading : vec2{0.0, 0.0};
    const double rise = root_height + (1.0 - root_height) * 0.5 * (1.0 + along);
    const double rim = 1.0 - square * square * square * square;
    const double height = draws_.height_mm * rim * rise * (1.0 - flank_fall * across * across);
    const vec2 at = middle_ + place + drawn_out;
    return {at.x, at.y, rim * glm::dot(draws_.slope, place) + height};
  }

  CellDraws draws_;
  vec2 middle_;
  std::vector<vec2> sides_;  // outwards, over their distance from the middle
  double mean_mm_ = 0.0;
  double ahead_mm_ = 1.0;
  double behind_mm_ = 1.0;
  double aside_mm_ = 1.0;
};

// The surface at a node, and what a step along s and along t adds, a third of a patch each.
struct Node {
  vec3 at{0.0, 0.0, 0.0};
  vec3 by_s{0.0, 0.0, 0.0};
  vec3 by_t{0.0, 0.0, 0.0};
  vec3 by_both{0.0, 0.0, 0.0};
};

Node node_at(const CellShaper& shape, double s, double t) {
  constexpr double third = 2.0 / (3.0 * static_cast<double>(patches_aside));
  const auto at = [&](double i, double j) { return shape.at(s + i * difference, t + j * difference); };
  Node node{at(0.0, 0.0), at(1.0, 0.0) - at(-1.0, 0.0), at(0.0, 1.0) - at(0.0, -1.0),
            at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)};
  node.by_s *= third / (2.0 * difference);
  node.by_t *= third / (2.0 * difference);
  node.by_both *= third * third / (4.0 * difference * difference);
  return node;
}

// The bicubic patch between four nodes, by (s, t).
BezierPatch patch_between(const std::array<std::array<const Node*, 2>, 2>& nodes) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const Node& node = *nodes[row / 2][column / 2];
      const double s = row == 1 ? 1.0 : (row == 2 ? -1.0 : 0.0);
      const double t = column == 1 ? 1.0 : (column == 2 ? -1.0 : 0.0);
      patch.at(row, column) = node.at + s * node.by_s + t * node.by_t + s * t * node.by_both;
    }
  }
  return patch;
}

}  // namespace

CellDraws cell_draws(const Pavement& pavement, std::uint64_t seed, Id stone) {
  const auto around_zero = [&](Stream stream, std::uint32_t index) {
    return 2.0 * uniform(seed, {stream, stone, index}) - 1.0;
  };
  const CellShape& cell = pavement.cell;
  const bool is_cobble = cell.form == CellForm::cobble;
  CellDraws draws;
  draws.form = cell.form;
  // What the filling hides is the same of all.
  draws.height_mm = cell_bed_mm(pavement) +
                    pavement.surface.height_mm * (1.0 + pavement.surface.height_spread * around_zero(Stream::stone_height, 0));
  // By eye: no two pebbles are equally round.
  const double roundness =
      std::clamp(cell.roundness + (is_cobble ? 0.25 * around_zero(Stream::stone_inset, 0) : 0.0), 0.0, 1.0);
  draws.exponent = least_exponent * power(most_exponent / least_exponent, 1.0 - roundness);
  draws.overlap = is_cobble ? 0.0 : cell.overlap;
  if (is_cobble) {
    draws.apex = 0.12 * vec2{around_zero(Stream::stone_inset, 1), around_zero(Stream::stone_inset, 2)};
    draws.dent = 0.06 * (vec2{1.0, 1.0} + vec2{around_zero(Stream::stone_arris, 2), around_zero(Stream::stone_arris, 3)});
  }
  const double usual = is_cobble ? cobble_slope : scale_slope;
  const double slope =
      pavement.variation.tilt ? sine(pavement.variation.tilt->radians()) / cosine(pavement.variation.tilt->radians()) : usual;
  draws.slope = slope * vec2{around_zero(Stream::stone_tilt, 0), around_zero(Stream::stone_tilt, 1)};
  return draws;
}

std::vector<BezierPatch> cell_patches(const Polygon& outline, const CellDraws& draws) {
  const CellShaper shape(outline, draws);
  constexpr std::size_t nodes_aside = patches_aside + 1;
  std::array<Node, nodes_aside * nodes_aside> nodes;
  const auto place = [](std::size_t i) { return -1.0 + 2.0 * static_cast<double>(i) / static_cast<double>(patches_aside); };
  for (std::size_t i = 0; i < nodes_aside; ++i) {
    for (std::size_t j = 0; j < nodes_aside; ++j) nodes.at(i * nodes_aside + j) = node_at(shape, place(i), place(j));
  }
  std::vector<BezierPatch> patches;
  patches.reserve(patches_aside * patches_aside);
  for (std::size_t i = 0; i < patches_aside; ++i) {
    for (std::size_t j = 0; j < patches_aside; ++j) {
      const auto node = [&](std::size_t di, std::size_t dj) { return &nodes.at((i + di) * nodes_aside + j + dj); };
      patches.push_back(patch_between({{{node(0, 0), node(0, 1)}, {node(1, 0), node(1, 1)}}}));
    }
  }
  return patches;
}

double reach_of_cell_mm(const Polygon& outline, const CellShape& cell) {
  if (cell.form != CellForm::scale) return 0.0;
  const geometry::Box box = geometry::bounding_box(outline);
  return (cell.overlap + 0.5 * swelling(cell.overlap)) * (1.0 + swelling(cell.overlap)) * glm::length(box.high - box.low);
}

double cell_bed_mm(const Pavement& pavement) { return hidden_part(pavement.cell.form) * whole_height_mm(pavement); }

double cell_top_mm(const Pavement& pavement) {
  const double size = std::max(pavement.stone_mm.x, pavement.stone_mm.y) * size_range(pavement).largest;
  const Angle most = pavement.variation.tilt.value_or(Angle());
  const double slope = pavement.variation.tilt ? sine(most.radians()) / cosine(most.radians()) : cobble_slope;
  // Half of a stone of one and a half times the size, along both axes.
  return cell_bed_mm(pavement) + pavement.surface.height_mm * (1.0 + pavement.surface.height_spread) + 1.5 * slope * size;
}

}  // namespace shatterpave::paving
