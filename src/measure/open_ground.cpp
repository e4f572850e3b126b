#include "measure/open_ground.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/corners.h"
#include "geometry/lattice.h"
#include "paving/packing/packing.h"

namespace shatterpave::measure {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;

// Pitches to a side of a tile: Clipper takes more than linear time, many tiles cost more at their borders; by trial.
constexpr double tile_pitches = 8.0;
// Stones are grown by so much more, so that neighbours overlap for certain, also where they are laid without joints (10 µm
// apart from their border each, paving/tiles/cutting.cpp). Rounding to the lattice else leaves slits a few µm wide along half
// of the joints, which take Clipper long, and now and then lead it to lose a whole stone.
constexpr double hairline_mm = 0.02;

Box grown_box(const Box& box, double by_mm) { return {box.low - vec2{by_mm, by_mm}, box.high + vec2{by_mm, by_mm}}; }

// How a stone is grown.
struct Growth {
  double distance_mm = 0.0;
  OpenGround::Rules rules;
};

// A corner between sides in the directions d and e, and what lies straight out of them.
struct Corner {
  Corner(vec2 last, vec2 at, vec2 next)
      : place(at),
        d((at - last) / glm::length(at - last)),
        e((next - at) / glm::length(next - at)),
        before(-left_of(d)),
        after(-left_of(e)),
        cosine(glm::dot(before, after)) {}

  bool is_convex() const { return cross(before, after) > 0.0; }
  // The tip is at distance √(2 / (1 + cos)) from the corner, cos of the turn.
  bool is_sharp(const Growth& growth) const {
    return 2.0 > growth.rules.miter_limit * growth.rules.miter_limit * (1.0 + cosine);
  }

  // The tip of the grown corner, or the two corners where it is cut.
  void append_tip(const Growth& growth, Polygon& outline) const {
    if (!is_sharp(growth)) {
      outline.push_back(place + growth.distance_mm / (1.0 + cosine) * (before + after));
      return;
    }
    // Along the moved sides as far as the limit lies out, in the direction that halves the turn.
    const double half_cosine = std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine)));
    const double half_sine = std::sqrt(0.5 * (1.0 - cosine));
    const double along = growth.distance_mm * (growth.rules.miter_limit - half_cosine) / half_sine;
    outline.push_back(place + growth.distance_mm * before + along * d);
    outline.push_back(place + growth.distance_mm * after - along * e);
  }

  vec2 place;
  vec2 d;
  vec2 e;
  vec2 before;
  vec2 after;
  double cosine;  // of the turn
};

Corner corner_of(const Polygon& stone, std::size_t i) {
  const std::size_t n = stone.size();
  return {stone[(i + n - 1) % n], stone[i], stone[(i + 1) % n]};
}

// A convex stone with its sides moved out; empty if that is not so simple.
Polygon grown_convex(const Polygon& stone, const Growth& growth) {
  Polygon grown;
  grown.reserve(stone.size());
  for (std::size_t i = 0; i < stone.size(); ++i) {
    const Corner corner = corner_of(stone, i);
    if (!corner.is_convex() || (corner.is_sharp(growth) && !growth.rules.long_tips)) return {};
    corner.append_tip(growth, grown);
  }
  return grown;
}

void append_grown(const Polygon& stone, const Growth& growth, std::vector<Polygon>& all) {
  if (Polygon grown = grown_convex(stone, growth); !grown.empty()) {
    all.push_back(std::move(grown));
    return;
  }
  for (Region& region : geometry::offset({stone, {}}, growth.distance_mm, growth.rules.miter_limit)) {
    all.push_back(std::move(region.outline));
  }
  if (!growth.rules.long_tips) return;
  for (std::size_t i = 0; i < stone.size(); ++i) {
    const Corner corner = corner_of(stone, i);
    if (!corner.is_convex() || !corner.is_sharp(growth)) continue;
    Polygon tip{corner.place, corner.place + growth.distance_mm * corner.before};
    corner.append_tip(growth, tip);
    tip.push_back(corner.place + growth.distance_mm * corner.after);
    all.push_back(std::move(tip));
  }
}

}  // namespace

OpenGround::OpenGround(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
                       const geometry::RegionIndex& area, const Rules& rules)
    : pavement_(pavement), layout_(layout), index_(index), area_(area), rules_(rules), ground_{pavement.area} {
  if (rules.free_border && pavement.joint_mm > 0.0)
    ground_ = geometry::offset(pavement.area, -0.5 * pavement.joint_mm, rules.miter_limit);
  const vec2 pitch = paving::pitch_mm(pavement);
  const vec2 size = area.box().high - area.box().low;
  // A pavement that is all outline has no more tiles than one that is full.
  const double most = static_cast<double>(layout.stones.size()) + 64.0;
  side_mm_ = std::max(tile_pitches * std::max(pitch.x, pitch.y), std::sqrt(size.x * size.y / most));
  side_mm_ = std::max(side_mm_, std::max(size.x, size.y) / most);
  columns_ = static_cast<std::size_t>(size.x / side_mm_) + 1;
  rows_ = static_cast<std::size_t>(size.y / side_mm_) + 1;
}

Box OpenGround::tile(std::size_t number) const {
  const auto corner = [&](std::size_t column, std::size_t row) {
    return geometry::on_lattice(area_.box().low + side_mm_ * vec2{static_cast<double>(column), static_cast<double>(row)});
  };
  const std::size_t column = number % columns_;
  const std::size_t row = number / columns_;
  return {corner(column, row), corner(column + 1, row + 1)};
}

std::vector<Region> OpenGround::ground(const Box& box) const {
  const double border_mm = rules_.free_border ? rules_.miter_limit * pavement_.joint_mm : 0.0;
  if (!area_.border_meets(grown_box(box, border_mm))) {
    if (!area_.contains(box.low)) return {};
    return {{geometry::rectangle(box), {}}};
  }
  std::vector<Region> parts;
  for (const Region& region : ground_) {
    for (Region& part : geometry::intersection(geometry::rectangle(box), region)) parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<Region> OpenGround::open(const Box& box) const {
  std::vector<Region> parts = ground(box);
  if (parts.empty()) return {};
  const Growth growth{0.5 * pavement_.joint_mm + hairline_mm, rules_};
  std::vector<std::size_t> near;
  index_.near(grown_box(box, rules_.miter_limit * growth.distance_mm), near);
  std::vector<Polygon> grown;
  for (const std::size_t s : near) append_grown(layout_.stones[s].outline_mm, growth, grown);
  std::vector<Region> left;
  for (const Region& part : parts) {
    for (Region& open : geometry::difference(part, grown)) left.push_back(std::move(open));
  }
  return left;
}

}  // namespace shatterpave::measure
