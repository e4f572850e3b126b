// Bullet, an engine of rigid bodies, moves the shards: prisms over the convex parts of their outlines. They are let go one
// after another, nearest to an impact first, a little in front of the pane, with some of the push that broke it.
#include "glass/shards/fall.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/error.h"
#include "core/functions.h"
#include "core/random.h"
#include "geometry/bend.h"
#include "geometry/segment_distance.h"
#include "glass/shards/convex_parts.h"
#include "glass/shards/hole_outline.h"
#include "glass/shards/rigid_scene.h"

namespace shatterpave::glass {

namespace {

constexpr double density_kg_mm3 = 2.5e-6;  // soda-lime glass

// 3 mm a step at the 2.4 m/s of a fall from the middle of a window to its sill: the thickness of a pane.
constexpr double step_s = 1.0 / 800.0;
// From the first shard that is let go to the last one, and from one to the next at most: few follow one another, and a pane of
// a thousand pieces does not empty like an hourglass. By eye.
constexpr double all_let_go_s = 0.5;
constexpr double longest_interval_s = 0.02;
// 950 took 31 s and 1,980 took 62 s on a busy machine, so these some two minutes.
constexpr std::ptrdiff_t most_falling = 4000;
// A step is done in parts in which no point of a piece that may meet another moves farther than this, so that what it hits is
// met before it has entered it: over a fall of 70 pieces none reached into anything by more than 0.22 mm with 0.8, and 4 mm
// with whole steps. In no more parts than so many: 15 m/s.
constexpr double longest_part_mm = 0.8;
constexpr double most_parts = 24.0;
// Parts make a fall some four times as dear: where only the end is asked for, more pieces than these go by whole steps.
constexpr std::ptrdiff_t most_fine = 300;
// What still moves so long after the last one was let go is given up.
constexpr double longest_s = 5.0;
// A piece is at rest if none of its points moved farther than this between two checks. Splinters tremble in place by less.
constexpr double rest_mm = 0.15;
constexpr int steps_between_looks = 200;
// A piece that was at rest at so many checks in succession stays where it is, as sills do: else all of a heap would be solved
// anew for each piece that falls on it. By eye: three quarters of a second, in which what is about to topple has begun to.
constexpr int looks_at_rest = 3;
// Let go so far in front of the pane, beyond both skins.
constexpr double clear_mm = 0.6;

// Damping per second while all flies; grows after that, so that nothing trembles for ever.
constexpr double damping_per_s = 0.3;
constexpr double settling_per_s = 6.0;

// Turns are kept to this many parts, shifts to the lattice.
constexpr double turn_parts = 1e9;

// The parts of outlines that collide may be so much larger than they are: on a dent 5 mm long 0.25 mm² are 0.1 mm, as thick as
// the skin. With 0.02 and 1 mm² one of the 248 pieces of a heap lay 0.6 mm above the next.
constexpr double excess = 0.01;
constexpr double excess_mm2 = 0.25;
// And those of bent ones so much thicker: as the skin, too.
constexpr double bent_excess_mm = 0.1;

// Corners nearer than this to the side that is left without them are left out of what collides: a third of the skin. Along a
// crack a part has up to seventy, and each is looked at wherever it may touch.
constexpr double slight_mm = 0.03;

geometry::Polygon without_slight_corners(const geometry::Polygon& convex) {
  geometry::Polygon kept = {convex.front()};
  std::size_t last = 0;
  for (std::size_t i = 1; i < convex.size(); ++i) {
    const vec2 next = convex[(i + 1) % convex.size()];
    const auto is_slight = [&](const vec2 p) { return geometry::distance_to_segment(p, convex[last], next) <= slight_mm; };
    const auto begin = convex.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    if (std::all_of(begin, convex.begin() + static_cast<std::ptrdiff_t>(i) + 1, is_slight)) continue;
    kept.push_back(convex[i]);
    last = i;
  }
  return kept.size() >= 3 ? kept : convex;
}

// What of a convex polygon lies within the box: cut side by side (Sutherland and Hodgman, 1974).
geometry::Polygon convex_within(geometry::Polygon polygon, const geometry::Box& box) {
  const auto cut = [&](std::size_t axis, double at, double sign) {
    geometry::Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const vec2 a = polygon[i];
      const vec2 b = polygon[(i + 1) % polygon.size()];
      const double in_a = sign * (a[axis] - at);
      const double in_b = sign * (b[axis] - at);
      if (in_a >= 0.0) kept.push_back(a);
      if ((in_a > 0.0 && in_b < 0.0) || (in_a < 0.0 && in_b > 0.0)) kept.push_back(a + in_a / (in_a - in_b) * (b - a));
    }
    polygon = std::move(kept);
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    cut(axis, box.low[axis], 1.0);
    cut(axis, box.high[axis], -1.0);
  }
  return polygon;
}

// ---- what shards fall from, and onto

// The frame's lower part, sill, floor, wall and reveal; and a screen in the plane of the pane, so that all fall to one side.
void add_surroundings(RigidScene& scene, const Pane& pane) {
  const ShardRules& rules = *pane.shards;
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  constexpr double thick_mm = 200.0;
  constexpr double far_mm = 5000.0;
  const double left = box.low.x - rules.reveal_mm;
  const double right = box.high.x + rules.reveal_mm;
  const double sill = box.low.y - rules.sill_drop_mm;
  const double floor = box.low.y - rules.floor_drop_mm;
  const double top = box.high.y + far_mm;
  scene.add_block({left - far_mm, floor - thick_mm, -far_mm}, {right + far_mm, floor, far_mm});
  scene.add_block({left, sill - 0.25 * thick_mm, -thick_mm}, {right, sill, rules.sill_depth_mm});
  scene.add_block({left, sill - thick_mm, -thick_mm}, {right, box.low.y, rules.frame_mm});
  scene.add_block({left - far_mm, floor - thick_mm, -thick_mm}, {right + far_mm, sill, rules.frame_mm});
  scene.add_block({left - thick_mm, sill - thick_mm, -thick_mm}, {left, top, rules.sill_depth_mm});
  scene.add_block({right, sill - thick_mm, -thick_mm}, {right + thick_mm, top, rules.sill_depth_mm});
  const double deepest_mm = std::min(pane.bow_mm.x, 0.0) + std::min(pane.bow_mm.y, 0.0);
  scene.add_block({left, sill, -thick_mm}, {right, top, deepest_mm - 0.5 * pane.thickness_mm});
}

struct Falling {
  std::size_t shard = 0;                          // number among all
  Id id;                                          // for draws
  vec3 centre_mm{0.0, 0.0, 0.0};                  // where it was in the pane
  double away_mm = 0.0;                           // from the nearest impact
  double reach_mm = 0.0;                          // from its centre to its farthest point
  btRigidBody* body = nullptr;                    // its user index: that of the falling one in its list
  btTransform seen = btTransform::getIdentity();  // when it was last looked at
  int looks_at_rest = 0;                          // up to then, one after another

  bool is_at_rest() const { return looks_at_rest > 0; }
  bool is_fixed() const { return body->isStaticObject(); }
};

void throw_out(const Pane& pane, const Falling& falling, vec2 from_impact, std::uint64_t seed) {
  const ShardRules& rules = *pane.shards;
  Address address{Stream::shard_throw, falling.id};
  const auto draw = [&] {
    const double value = 2.0 * uniform(seed, address) - 1.0;
    ++address.draw;
    return value;
  };
  const double x = falling.away_mm / rules.missing_mm.value_or(usual_missing_mm(pane, pane.impacts.front()));
  const double push_mm_s = 1000.0 * rules.throw_m_s * (0.25 + 0.75 * exponential(-x * x)) * (1.0 + 0.4 * draw());
  const vec2 aside = falling.away_mm > 0.0 ? from_impact / falling.away_mm : vec2{0.0, 0.0};
  vec3 velocity{0.25 * push_mm_s * (aside + vec2{0.5 * draw(), 0.5 * draw()}), push_mm_s};
  falling.body->setLinearVelocity(to_units(velocity));
  falling.body->setAngularVelocity(btVector3(3.0 * draw(), 2.0 * draw(), 2.0 * draw()));
}

// What collides for a shard that is bent or leans: its convex parts, cut into cells over which either is nearly even.
std::vector<geometry::Polygon> even_parts(const std::vector<geometry::Polygon>& parts, const geometry::Bend& bend,
                                          const Lean& lean) {
  if (bend.is_flat() && lean.is_upright()) return parts;
  // So that a cell's diagonal is off by the bound at the most: half of it for either way.
  const auto cell = [](double half, double bow) {
    return bow == 0.0 ? 2.0 * half : half * std::sqrt(2.0 * bent_excess_mm / bow);
  };
  vec2 cell_mm{cell(bend.half_mm.x, std::abs(bend.bow_mm.x)), cell(bend.half_mm.y, std::abs(bend.bow_mm.y))};
  if (!lean.is_upright()) cell_mm = bend.is_flat() ? vec2(lean.even_mm()) : glm::min(cell_mm, vec2(lean.even_mm()));
  std::vector<geometry::Polygon> cells;
  for (const geometry::Polygon& part : parts) {
    const geometry::Box box = geometry::bounding_box(part);
    const vec2 first = glm::floor(box.low / cell_mm);
    const vec2 last = glm::floor(box.high / cell_mm);
    for (double i = first.x; i <= last.x; ++i) {
      for (double j = first.y; j <= last.y; ++j) {
        const vec2 low{i * cell_mm.x, j * cell_mm.y};
        geometry::Polygon within = convex_within(part, {low, low + cell_mm});
        if (within.size() >= 3) cells.push_back(std::move(within));
      }
    }
  }
  return cells;
}

// The shards that fall as bodies, in the order in which they are let go.
std::vector<Falling> fallings(const Pane& pane, const std::vector<Shard>& shards, RigidScene& scene, const Lean& lean,
                              std::uint64_t seed) {
  const double half_mm = 0.5 * pane.thickness_mm;
  const geometry::Bend bend = bend_of(pane);
  const Warp place = [&](vec3 p) { return bend.point(p + vec3{lean.aside_mm({p.x, p.y}, p.z), 0.0}); };
  // Along z bent glass is thicker by its slope.
  const double clear_of_pane_mm = pane.thickness_mm * glm::length(vec3{2.0 * bend.bow_mm / bend.half_mm, 1.0}) + clear_mm;
  std::vector<Falling> result;
  for (std::size_t number = 0; number < shards.size(); ++number) {
    const Shard& shard = shards[number];
    if (shard.state == ShardState::missing) continue;
    const vec2 centre = geometry::centroid(shard.face.outline);
    const vec3 pivot = bend.point({centre, 0.0});
    std::vector<geometry::Polygon> parts = even_parts(convex_parts(shard.face, excess, excess_mm2), bend, lean);
    for (geometry::Polygon& part : parts) part = without_slight_corners(part);
    btCollisionShape* shape = scene.prisms(parts, place, pivot, half_mm);
    if (shard.state == ShardState::standing) {
      scene.add_fixed(shape, pivot);
      continue;
    }
    Falling falling;
    falling.shard = number;
    falling.id = Id(pane.name).child("shard").child(shard.id);
    falling.centre_mm = pivot;
    for (const vec2 p : shard.face.outline) falling.reach_mm = std::max(falling.reach_mm, glm::length(p - centre));
    vec2 from_impact{0.0, 0.0};
    for (std::size_t i = 0; i < pane.impacts.size(); ++i) {
      const vec2 way = centre - pane.impacts[i].at_mm;
      if (i == 0 || glm::length(way) < falling.away_mm) from_impact = way;
      falling.away_mm = glm::length(from_impact);
    }
    const double kg = density_kg_mm3 * geometry::area(shard.face) * pane.thickness_mm;
    falling.body = scene.add_shard(shape, kg, pivot + vec3{0.0, 0.0, clear_of_pane_mm});
    throw_out(pane, falling, from_impact, seed);
    result.push_back(falling);
  }
  std::ranges::stable_sort(result, {}, &Falling::away_mm);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].body->setUserIndex(static_cast<int>(i));
  return result;
}

// The farthest that a point of it has moved since it was last looked at: at most by its shift and by twice the half turn.
void look_at(Falling& falling, RigidScene& scene) {
  if (falling.is_fixed()) return;
  const btTransform& now = falling.body->getWorldTransform();
  const double shift_mm = (now.getOrigin() - falling.seen.getOrigin()).length() / unit_per_mm;
  const btQuaternion turn = now.getRotation() * falling.seen.getRotation().inverse();
  const double half_turn = btVector3(turn.x(), turn.y(), turn.z()).length();
  const bool is_at_rest = falling.body->isInWorld() && shift_mm + 2.0 * half_turn * falling.reach_mm < rest_mm;
  falling.looks_at_rest = is_at_rest ? falling.looks_at_rest + 1 : 0;
  falling.seen = now;
  if (falling.looks_at_rest == looks_at_rest) scene.fix(falling.body);
}

// In so many parts that in each no point of a body that may meet another goes farther than it may.
int parts_of_step(RigidScene& scene, std::span<const Falling> fallings) {
  double fastest_mm_s = 0.0;
  scene.each_that_may_meet(step_s, [&](const btRigidBody& body) {
    const double speed_mm_s = body.getLinearVelocity().length() / unit_per_mm;
    const double reach_mm = fallings[static_cast<std::size_t>(body.getUserIndex())].reach_mm;
    fastest_mm_s = std::max(fastest_mm_s, speed_mm_s + body.getAngularVelocity().length() * reach_mm);
  });
  const double parts = std::ceil(fastest_mm_s * step_s / longest_part_mm);
  return static_cast<int>(std::clamp(parts, 1.0, most_parts));
}

// Lets all go and follows them until they have come to rest, or for the longest time. Before each step calls see(number of
// steps done, how many have been let go), and stops where that says so.
template <typename See>
void follow(RigidScene& scene, std::vector<Falling>& fallings, bool finely, const See& see) {
  const auto count = static_cast<double>(fallings.size());
  const double interval_s = std::min(longest_interval_s, all_let_go_s / count);
  const double last_s = interval_s * count;
  const int most_steps = static_cast<int>((last_s + longest_s) / step_s);
  std::size_t gone = 0;
  for (int step = 0; step < most_steps; ++step) {
    if (!see(step, gone)) return;
    const double now_s = step_s * step;
    while (gone < fallings.size() && now_s >= interval_s * static_cast<double>(gone)) scene.let_go(fallings[gone++].body);
    scene.step(step_s, damping_per_s + settling_per_s * std::max(0.0, now_s - last_s),
               finely ? parts_of_step(scene, fallings) : 1);
    if (step % steps_between_looks != 0) continue;
    for (Falling& falling : fallings) look_at(falling, scene);
    if (std::ranges::all_of(fallings, &Falling::is_at_rest)) return;
  }
}

Motion motion_of(const Falling& falling) {
  const btTransform& now = falling.body->getWorldTransform();
  const btMatrix3x3 turn(now.getRotation());
  Motion motion;
  for (int row = 0; row < 3; ++row) {
    const auto rounded = [&](int column) { return std::round(turn[row][column] * turn_parts) / turn_parts; };
    motion.rows[static_cast<std::size_t>(row)] = {rounded(0), rounded(1), rounded(2)};
  }
  const vec3 shift = to_mm(now.getOrigin()) - moved(motion, falling.centre_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) motion.shift_mm[axis] = geometry::to_mm(geometry::to_lattice(shift[axis]));
  return motion;
}

// The number of steps that are done by then: as of the time of the step, whatever rounding made of it.
double steps_by(double time_s) { return std::floor(time_s / step_s * (1.0 + 1e-12)); }

// Of shards that are all in the pane, or gone.
std::vector<ShardPlace> places_at_first(const std::vector<Shard>& shards, bool all_in_pane) {
  std::vector<ShardPlace> places(shards.size());
  for (std::size_t i = 0; i < shards.size(); ++i) {
    const bool gone = shards[i].state == ShardState::missing && !all_in_pane;
    places[i].state = gone ? ShardState::missing : ShardState::standing;
  }
  return places;
}

}  // namespace

std::vector<std::vector<ShardPlace>> places_of_fall(const Pane& pane, const std::vector<Shard>& shards, std::uint64_t seed,
                                                    std::span<const double> times_s, const Lean& lean) {
  const auto count = std::ranges::count(shards, ShardState::fallen, &Shard::state);
  if (count > most_falling) {
    throw InputError(Place{"", 0, 0, pane.name + ".shards"},
                     fmt::format("expected at most {} pieces that fall to sill and floor, got {}", most_falling, count));
  }
  std::vector<std::vector<ShardPlace>> result;
  while (result.size() < times_s.size() && times_s[result.size()] == 0.0) result.push_back(places_at_first(shards, true));
  if (result.size() == times_s.size()) return result;
  RigidScene scene;
  add_surroundings(scene, pane);
  std::vector<Falling> fallings = glass::fallings(pane, shards, scene, lean, seed);
  const auto add = [&](std::size_t gone, bool at_end) {
    std::vector<ShardPlace> places = places_at_first(shards, false);
    for (std::size_t i = 0; i < gone; ++i) {
      const bool is_there = !at_end || fallings[i].is_at_rest();
      places[fallings[i].shard] =
          is_there ? ShardPlace{ShardState::fallen, motion_of(fallings[i])} : ShardPlace{ShardState::missing, {}};
    }
    result.push_back(std::move(places));
  };
  const auto see = [&](int steps, std::size_t gone) {
    while (result.size() < times_s.size() && steps_by(times_s[result.size()]) <= steps) add(gone, false);
    return result.size() < times_s.size();
  };
  if (!fallings.empty()) follow(scene, fallings, count <= most_fine || std::isfinite(times_s.front()), see);
  while (result.size() < times_s.size()) add(fallings.size(), true);
  return result;
}

void let_fall(const Pane& pane, std::vector<Shard>& shards, std::uint64_t seed, const Lean& lean) {
  const std::optional<double> time_s = pane.shards->time_s;
  if (!time_s && std::ranges::count(shards, ShardState::fallen, &Shard::state) == 0) return;
  const std::array times{time_s.value_or(std::numeric_limits<double>::infinity())};
  const std::vector<ShardPlace> places = places_of_fall(pane, shards, seed, times, lean).front();
  for (std::size_t i = 0; i < shards.size(); ++i) {
    shards[i].state = places[i].state;
    shards[i].motion = places[i].motion;
  }
}

}  // namespace shatterpave::glass
