// The extents of a stone along a direction and across it are, between directions in which one of them is that of another pair
// of corners, both of the form |d| cos: the greater of two such is least at an end of that range or where they are alike. So
// there are few directions to try: those of the hull's sides, and one between any two that follow each other.
#include "measure/stone_stock.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/clip.h"
#include "geometry/hull.h"
#include "paving/bonds/border.h"

namespace shatterpave::measure {

namespace {

using geometry::Polygon;
using paving::Bond;
using paving::Pavement;

// The corners that are farthest along a direction, one to each end: the vector between them.
vec2 reach(const Polygon& hull, vec2 direction) {
  const auto along = [&](vec2 p) { return glm::dot(p, direction); };
  const auto [low, high] = std::ranges::minmax_element(hull, {}, along);
  return *high - *low;
}

// A direction, without length, turned by quarters until it lies in [0°, 90°).
vec2 in_first_quarter(vec2 d) {
  while (d.x <= 0.0 || d.y < 0.0) d = left_of(d);
  return d / glm::length(d);
}

// Of the hull's sides, by their angle.
std::vector<vec2> side_directions(const Polygon& hull) {
  std::vector<vec2> directions;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    directions.push_back(in_first_quarter(hull[(i + 1) % hull.size()] - hull[i]));
  }
  std::ranges::sort(directions, {}, [](vec2 d) { return d.y / d.x; });
  return directions;
}

class Fitting {
 public:
  Fitting(const Polygon& hull, vec2 face_mm) : hull_(hull), face_(face_mm) {}

  void try_all() {
    const std::vector<vec2> directions = side_directions(hull_);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const bool last = i + 1 == directions.size();
      const vec2 next = last ? left_of(directions.front()) : directions[i + 1];
      attempt(directions[i]);
      attempt(left_of(directions[i]));
      between(directions[i], next);
      between(left_of(directions[i]), left_of(next));
    }
  }
  StockShare best() const { return best_; }
  double worse_side() const { return std::max(best_.length, best_.width); }

 private:
  void attempt(vec2 direction) {
    const double length = glm::dot(reach(hull_, direction), direction) / face_.x;
    const vec2 across = left_of(direction);
    const double width = glm::dot(reach(hull_, across), across) / face_.y;
    if (tried_ && std::max(length, width) >= worse_side()) return;
    best_ = {length, width, 0.0};
    tried_ = true;
  }

  // Where length and width over the face are alike, if that is between the two directions.
  void between(vec2 from, vec2 to) {
    const vec2 middle = from + to;
    // d · p / a = d · q' / b, with q' the reach across turned back by a quarter: at right angles to p / a − q' / b.
    const vec2 p = reach(hull_, middle) / face_.x;
    const vec2 q = -left_of(reach(hull_, left_of(middle))) / face_.y;
    vec2 direction = left_of(p - q);
    if (glm::dot(direction, middle) < 0.0) direction = -direction;
    if (cross(from, direction) <= 0.0 || cross(direction, to) <= 0.0) return;
    attempt(direction / glm::length(direction));
  }

  const Polygon& hull_;
  vec2 face_;
  StockShare best_;
  bool tried_ = false;
};

StockLimit of_faces(std::vector<vec2> faces, std::optional<double> most) {
  StockLimit limit{std::move(faces), 0.0, most};
  for (const vec2& face : limit.faces_mm) limit.area_mm2 = std::max(limit.area_mm2, face.x * face.y);
  return limit;
}

// A block of `count` stones and joints is as long as one stone and its joint.
vec2 woven_face(const Pavement& pavement) {
  const vec2 pitch = paving::pitch_mm(pavement);
  const double count = std::max(1.0, std::round(pitch.x / pitch.y));
  return {pavement.stone_mm.x, pitch.x / count - pavement.joint_mm};
}

// Half a joint off all sides of the tile, which is `pitch.x` wide and twice `side` high.
StockLimit of_hexagon(const Pavement& pavement) {
  const vec2 pitch = paving::pitch_mm(pavement);
  const double side = pitch.y / std::sqrt(3.0);
  const double half = 0.5 * pitch.x;
  const double roof = glm::length(vec2{half, 0.5 * side});  // length of a side that leans
  const double height = 2.0 * side - pavement.joint_mm * roof / half;
  const double width = pavement.stone_mm.x;
  // The upright sides: a leaning one falls by side / 2 over half the tile.
  const double upright = height - 0.5 * side * width / half;
  StockLimit limit = of_faces({{width, height}}, 1.0);
  limit.area_mm2 = 0.5 * width * (height + upright);
  return limit;
}

// A parallelogram with angles of 45°, whose long sides are `stone_mm.x`.
StockLimit of_chevron(const Pavement& pavement) {
  const double slant = pavement.stone_mm.y;  // how far one end is before the other, along the plank
  StockLimit limit = of_faces({{pavement.stone_mm.x + slant, pavement.stone_mm.y}}, 1.0);
  limit.area_mm2 = pavement.stone_mm.x * pavement.stone_mm.y;
  return limit;
}

// The smallest rectangle about a hull, its length and its width: one of its sides runs along one of the hull's.
vec2 box_of(const Polygon& hull) {
  vec2 best{0.0, 0.0};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const vec2 side = hull[(i + 1) % hull.size()] - hull[i];
    const vec2 d = side / glm::length(side);
    const vec2 size{glm::dot(reach(hull, d), d), glm::dot(reach(hull, left_of(d)), left_of(d))};
    if (i == 0 || size.x * size.y < best.x * best.y) best = size;
  }
  return {std::max(best.x, best.y), std::min(best.x, best.y)};
}

// The longest, the widest and the largest of the stones, which are the cells less half a joint.
StockLimit of_module(const Pavement& pavement) {
  const paving::Module& drawn = pavement.bonding.module_drawn;
  if (drawn.stones.empty()) return of_faces({pavement.stone_mm}, 1.0);
  StockLimit limit{{vec2{0.0, 0.0}}, 0.0, 1.0};
  for (const paving::Module::Stone& stone : drawn.stones) {
    constexpr double sharp = 100.0;  // no corner is cut off
    for (const geometry::Region& face : geometry::offset({stone.cell_mm, {}}, -0.5 * pavement.joint_mm, sharp)) {
      limit.faces_mm.front() = glm::max(limit.faces_mm.front(), box_of(geometry::convex_hull(face.outline)));
      limit.area_mm2 = std::max(limit.area_mm2, geometry::area(face.outline));
    }
  }
  return limit;
}

}  // namespace

StockLimit stock_limit(const Pavement& pavement) {
  const vec2 pitch = paving::pitch_mm(pavement);
  const bool straight = std::holds_alternative<paving::ConstantDirection>(pavement.direction) && !paving::has_sizes(pavement);
  const auto modules = [&](double columns, double rows) {
    return vec2{columns, rows} * pitch - vec2{pavement.joint_mm, pavement.joint_mm};
  };
  const auto where = [](bool limited) { return limited ? std::optional(1.0) : std::nullopt; };
  switch (pavement.bonding.bond) {
    case Bond::packed:
      return of_faces({pavement.stone_mm}, where(straight));
    case Bond::running:
    case Bond::stack:
    case Bond::herringbone:
      return of_faces({pavement.stone_mm}, 1.0);
    case Bond::basket_weave:
      return of_faces({woven_face(pavement)}, 1.0);
    case Bond::hexagon:
      return of_hexagon(pavement);
    case Bond::ashlar:
      return of_faces({modules(3.0, 2.0), modules(2.0, 3.0)}, 1.0);
    case Bond::chevron:
      return of_chevron(pavement);
    case Bond::drawn_module:
      return of_module(pavement);
    case Bond::segmental_arc:
    case Bond::fan:
    case Bond::crazy:
    case Bond::course:
      return of_faces({pavement.stone_mm}, std::nullopt);
  }
  ENSURE(false);  // a bond without a case, which the compiler warns of
  return {};
}

StockLimit border_stock_limit(const Pavement& pavement) { return of_faces({paving::border_stone_mm(pavement)}, 1.0); }

StockShare stock_share(const Polygon& stone, const StockLimit& stock) {
  const Polygon hull = geometry::convex_hull(stone);
  StockShare best;
  bool first = true;
  for (const vec2& face : stock.faces_mm) {
    Fitting fitting(hull, face);
    fitting.try_all();
    if (!first && fitting.worse_side() >= std::max(best.length, best.width)) continue;
    best = fitting.best();
    first = false;
  }
  best.area = geometry::area(stone) / stock.area_mm2;
  return best;
}

}  // namespace shatterpave::measure
