// Where fallen shards come to rest: told by their solids alone, without the engine that moved them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/triangulation.h"
#include "glass/breaking.h"
#include "glass/shards/fall.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {
namespace {

// What lies on something is at most this far above it, mm: the skin of both (fall.cpp).
constexpr double touch_mm = 0.25;
// How far one thing may reach into another, mm.
constexpr double tolerance_mm = 0.05;

Pane window() {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {300, 0}, {300, 240}, {0, 240}};
  pane.thickness_mm = 3.0;
  Impact impact;
  impact.at_mm = {150, 130};
  impact.radial_count = 60;
  impact.large_count = 18;
  impact.circular_count = 12;
  pane.impacts = {impact};
  pane.shards = ShardRules{};
  pane.shards->bevel_mm = 0.0;  // so that a solid is a prism
  pane.shards->fallen = 1.0;
  pane.shards->missing_mm = 80.0;
  pane.shards->throw_m_s = 0.5;
  return pane;
}

// A triangle of a shard's face through the thickness, as six points where the shard is now.
using Prism = std::array<vec3, 6>;

std::vector<Prism> prisms(const Shard& shard, double thickness_mm) {
  const auto rings = geometry::lattice_rings(shard.face);
  std::vector<vec2> points;
  for (const auto& ring : rings) {
    for (const auto p : ring) points.push_back(geometry::to_mm(p));
  }
  std::vector<Prism> result;
  for (const auto& corners : geometry::triangulation(rings)) {
    Prism prism;
    for (std::size_t i = 0; i < 6; ++i) {
      prism[i] = moved(shard.motion, {points[corners[i % 3]], (i < 3 ? -0.5 : 0.5) * thickness_mm});
    }
    result.push_back(prism);
  }
  return result;
}

struct Span {
  double low = 1e300;
  double high = -1e300;
};

Span along(const Prism& prism, vec3 axis) {
  Span span;
  for (const vec3& p : prism) {
    span.low = std::min(span.low, glm::dot(p, axis));
    span.high = std::max(span.high, glm::dot(p, axis));
  }
  return span;
}

// How deep two prisms reach into one another: the least overlap over the normals of their faces and the products of their
// edges; 0 where some plane parts them.
double depth(const Prism& a, const Prism& b) {
  std::vector<vec3> axes;
  std::array<std::vector<vec3>, 2> edges;
  for (const auto& [prism, own] : {std::pair(&a, &edges[0]), std::pair(&b, &edges[1])}) {
    const Prism& p = *prism;
    *own = {p[1] - p[0], p[2] - p[1], p[0] - p[2], p[3] - p[0]};
    axes.push_back(glm::cross((*own)[0], (*own)[1]));
    for (std::size_t i = 0; i < 3; ++i) axes.push_back(glm::cross((*own)[i], (*own)[3]));
  }
  for (const vec3& e : edges[0]) {
    for (const vec3& f : edges[1]) axes.push_back(glm::cross(e, f));
  }
  double least = 1e300;
  for (const vec3& axis : axes) {
    const double length = glm::length(axis);
    if (length < 1e-9) continue;
    const Span p = along(a, axis / length);
    const Span q = along(b, axis / length);
    least = std::min(least, std::min(p.high, q.high) - std::max(p.low, q.low));
    if (least <= 0.0) return 0.0;
  }
  return least;
}

double depth(const std::vector<Prism>& a, const std::vector<Prism>& b) {
  double deepest = 0.0;
  for (const Prism& p : a) {
    for (const Prism& q : b) {
      if (glm::length(p[0] - q[0]) >
          glm::length(p[0] - p[1]) + glm::length(p[0] - p[2]) + glm::length(q[0] - q[1]) + glm::length(q[0] - q[2]) + 20.0) {
        continue;
      }
      deepest = std::max(deepest, depth(p, q));
    }
  }
  return deepest;
}

TEST(FallenShards, CheckOfDepthSeesOverlaps) {
  const Prism prism = {vec3{0, 0, 0}, vec3{10, 0, 0}, vec3{0, 10, 0}, vec3{0, 0, 3}, vec3{10, 0, 3}, vec3{0, 10, 3}};
  const auto shifted = [&](vec3 by) {
    Prism other = prism;
    for (vec3& p : other) p += by;
    return other;
  };
  EXPECT_NEAR(depth(prism, shifted({0, 0, 2.7})), 0.3, 1e-12);
  EXPECT_NEAR(depth(prism, shifted({9.5, 0, 0})), 0.5 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(depth(prism, shifted({0, 0, 3.1})), 0.0);
  EXPECT_EQ(depth(prism, shifted({6, 6, 0})), 0.0);
}

TEST(FallenShards, LieOnSillAndFloorAndInNothing) {
  const Pane pane = window();
  const ShardRules& rules = *pane.shards;
  const std::vector<Shard> all = shards(pane, broken(pane, 4), 4);
  std::vector<std::vector<Prism>> bodies;
  int on_sill = 0;
  int on_floor = 0;
  for (const Shard& shard : all) {
    if (shard.state == ShardState::missing) continue;
    bodies.push_back(prisms(shard, pane.thickness_mm));
    if (shard.state != ShardState::fallen) continue;
    double lowest = 1e300;
    for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
      const vec3 p = moved(shard.motion, in_pane_mm(vertex, pane.thickness_mm));
      lowest = std::min(lowest, p.y);
      // Within the reveal: not beyond its walls, nor in the frame below the pane.
      if (p.z < rules.sill_depth_mm && p.y > -rules.sill_drop_mm) {
        EXPECT_GE(p.x, -rules.reveal_mm - tolerance_mm) << shard.id;
        EXPECT_LE(p.x, 300.0 + rules.reveal_mm + tolerance_mm) << shard.id;
      }
      if (p.y < -tolerance_mm) {
        EXPECT_GE(p.z, rules.frame_mm - tolerance_mm) << shard.id;
      }
      // Nor in the sill, over whose edge a few lean; and none has come to lie under it.
      if (p.y < -rules.sill_drop_mm - tolerance_mm) {
        const double least_mm = p.y > -rules.sill_drop_mm - 50.0 ? tolerance_mm : 30.0;
        EXPECT_GE(p.z, rules.sill_depth_mm - least_mm) << shard.id << " " << p.y;
      }
    }
    EXPECT_GE(lowest, -rules.floor_drop_mm - tolerance_mm) << shard.id;
    if (std::abs(lowest + rules.sill_drop_mm) <= touch_mm) ++on_sill;
    if (std::abs(lowest + rules.floor_drop_mm) <= touch_mm) ++on_floor;
  }
  EXPECT_GT(on_sill, 5);
  EXPECT_GT(on_floor, 0);
  double deepest = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) deepest = std::max(deepest, depth(bodies[i], bodies[j]));
  }
  EXPECT_LE(deepest, tolerance_mm);
  RecordProperty("deepest_um", static_cast<int>(1000.0 * deepest));
}

// How many of the fallen would go on to fall: lower by `by_mm` they reach into nothing that holds them, neither sill nor floor
// nor frame nor another piece.
int floating(const Pane& pane, const std::vector<Shard>& all, double by_mm) {
  const ShardRules& rules = *pane.shards;
  const auto lowered = [&](std::vector<Prism> body) {
    for (Prism& prism : body) {
      for (vec3& p : prism) p.y -= by_mm;
    }
    return body;
  };
  std::vector<std::vector<Prism>> bodies;
  for (const Shard& shard : all) {
    if (shard.state != ShardState::missing) bodies.push_back(prisms(shard, pane.thickness_mm));
  }
  int count = 0;
  std::size_t at = 0;
  for (const Shard& shard : all) {
    if (shard.state == ShardState::missing) continue;
    const std::size_t own = at++;
    if (shard.state != ShardState::fallen) continue;
    const std::vector<Prism> body = lowered(bodies[own]);
    bool held = false;
    for (const Prism& prism : body) {
      for (const vec3& p : prism) {
        held |= p.y < -rules.floor_drop_mm;
        held |= p.z < rules.sill_depth_mm && p.y < -rules.sill_drop_mm && p.y > -rules.sill_drop_mm - 50.0;
        held |= p.z < rules.frame_mm && p.y < 0.0;
      }
    }
    for (std::size_t other = 0; other < bodies.size() && !held; ++other) {
      held = other != own && depth(body, bodies[other]) > 0.0;
    }
    if (!held) ++count;
  }
  return count;
}

// Heaps too, in which pieces stay where they are as soon as they are at rest.
TEST(FallenShards, RestOnSomething) {
  Pane heap = window();
  heap.glass = Tempered{};
  std::get<Tempered>(heap.glass).count_per_square = 6.0;
  heap.shards->missing = 1.0;
  heap.shards->missing_mm = 75.0;
  for (const Pane& pane : {window(), heap}) {
    std::vector<Shard> all = shards(pane, broken(pane, 4), 4);
    EXPECT_GE(std::ranges::count(all, ShardState::fallen, &Shard::state), 10);
    EXPECT_EQ(floating(pane, all, 0.6), 0);
    // The twin: the same, 5 mm higher.
    for (Shard& shard : all) {
      if (shard.state == ShardState::fallen) shard.motion.shift_mm.y += 5.0;
    }
    EXPECT_GT(floating(pane, all, 0.6), 0);
  }
}

// Nothing in memory or of another run shows: the heap is left in disorder between two falls.
TEST(FallenShards, FallAlikeWithAnyNumberOfThreads) {
  const Pane pane = window();
  const CrackNetwork network = broken(pane, 4);
  std::vector<Shard> once;
  {
    const ThreadLimit limit(1);
    once = shards(pane, network, 4);
  }
  std::vector<std::vector<char>> disorder;
  for (std::size_t i = 1; i < 400; ++i) disorder.emplace_back(i * 37 % 1024 + 1);
  for (std::size_t i = 0; i < disorder.size(); i += 3) std::vector<char>().swap(disorder[i]);
  const ThreadLimit limit(7);
  EXPECT_TRUE(shards(pane, network, 4) == once);
}

// ---- on their way

constexpr double step_s = 1.0 / 800.0;  // of the engine

// Fewer pieces fall.
Pane small_hole() {
  Pane pane = window();
  pane.shards->missing_mm = 40.0;
  return pane;
}

TEST(FallenShards, KeepTheirShape) {
  const Pane pane = small_hole();
  for (const Shard& shard : shards(pane, broken(pane, 4), 4)) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_NEAR(glm::dot(shard.motion.rows[i], shard.motion.rows[j]), i == j ? 1.0 : 0.0, 1e-8);
      }
    }
    const vec3 across = glm::cross(shard.motion.rows[0], shard.motion.rows[1]);
    EXPECT_NEAR(glm::dot(across, shard.motion.rows[2]), 1.0, 1e-8);
  }
}

// The pieces of the window before any has fallen.
std::vector<Shard> pieces_in_pane(const Pane& pane, std::uint64_t seed) {
  std::vector<Shard> all = shards(pane, broken(pane, seed), seed);
  for (Shard& shard : all) {
    shard.motion = {};
    if (shard.state == ShardState::missing) shard.state = ShardState::fallen;  // given up
  }
  return all;
}

// All steps of the engine for so long.
std::vector<double> all_steps(double until_s) {
  std::vector<double> times;
  for (double step = 0.0; step * step_s <= until_s; ++step) times.push_back(step * step_s);
  return times;
}

// How deep a body reaches into sill, floor, frame and the walls beside the pane: blocks, each of which is told by the side on
// which its middle is nearer.
double depth_in_surroundings(const Pane& pane, const std::vector<Prism>& body) {
  const ShardRules& rules = *pane.shards;
  const double sill = -rules.sill_drop_mm;
  constexpr double sill_thick_mm = 50.0;
  double deepest = 0.0;
  for (const Prism& prism : body) {
    for (const vec3& p : prism) {
      const double beyond_wall = std::max(-rules.reveal_mm - p.x, p.x - 300.0 - rules.reveal_mm);
      std::vector<double> depths{-rules.floor_drop_mm - p.y};
      depths.push_back(std::min(beyond_wall <= 0.0 ? -p.y : sill - p.y, rules.frame_mm - p.z));
      if (beyond_wall <= 0.0 && p.y > sill - sill_thick_mm) depths.push_back(std::min(sill - p.y, rules.sill_depth_mm - p.z));
      if (p.y > sill) depths.push_back(std::min(beyond_wall, rules.sill_depth_mm - p.z));
      deepest = std::max(deepest, *std::ranges::max_element(depths));
    }
  }
  return deepest;
}

struct Energies {
  double moving = 0.0;    // of its motion, in kg mm²/s²
  double standing = 0.0;  // of its height
};

// Of a body that goes from one place to the next in a step, exact for rigid motions: the middles of the sides of each triangle,
// at the two heights of Gauss.
Energies energies(const Shard& shard, double thickness_mm, const Motion& before, const Motion& after) {
  constexpr double density = 2.5e-6;
  constexpr double gravity = 9810.0;
  Energies result;
  const auto rings = geometry::lattice_rings(shard.face);
  std::vector<vec2> points;
  for (const auto& ring : rings) {
    for (const auto p : ring) points.push_back(geometry::to_mm(p));
  }
  for (const auto& corners : geometry::triangulation(rings)) {
    const vec2 a = points[corners[0]];
    const vec2 b = points[corners[1]];
    const vec2 c = points[corners[2]];
    const double kg = density * thickness_mm * 0.5 * std::abs(cross(b - a, c - a)) / 6.0;
    for (const vec2 middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
      for (const double z : {-0.5 * thickness_mm / std::sqrt(3.0), 0.5 * thickness_mm / std::sqrt(3.0)}) {
        const vec3 now = moved(after, {middle, z});
        const vec3 velocity = (now - moved(before, {middle, z})) / step_s;
        result.moving += 0.5 * kg * glm::dot(velocity, velocity);
        result.standing += kg * gravity * now.y;
      }
    }
  }
  return result;
}

TEST(ShardsOnTheirWay, AreWhereTheEngineHadThemAndEndAtRest) {
  Pane pane = small_hole();
  const CrackNetwork network = broken(pane, 4);
  const std::vector<Shard> in_pane = pieces_in_pane(pane, 4);
  const std::vector<double> times = {0.0, 0.0004, 0.1, 0.3, 0.3001, 0.5, 1000.0, 1001.0};
  const auto places = places_of_fall(pane, in_pane, 4, times);
  ASSERT_EQ(places.size(), times.size());
  for (std::size_t i = 0; i < in_pane.size(); ++i) {
    EXPECT_EQ(places[0][i].state, ShardState::standing);
    EXPECT_EQ(places[6][i].state, places[7][i].state);
    EXPECT_TRUE(places[6][i].motion == places[7][i].motion) << "not at rest";
    EXPECT_TRUE(places[3][i].motion == places[4][i].motion) << "within a step";
  }
  // Asked for alone, each is the same; and so has the pane them.
  for (const std::size_t t : {0U, 1U, 4U, 6U}) {
    const auto alone = places_of_fall(pane, in_pane, 4, std::array{times[t]}).front();
    pane.shards->time_s = times[t];
    const std::vector<Shard> then = shards(pane, network, 4);
    ASSERT_EQ(then.size(), alone.size());
    for (std::size_t i = 0; i < then.size(); ++i) {
      EXPECT_TRUE(alone[i].motion == places[t][i].motion && alone[i].state == places[t][i].state);
      EXPECT_TRUE(then[i].motion == places[t][i].motion && then[i].state == places[t][i].state)
          << times[t] << " " << then[i].id;
    }
  }
  // A scene that names no time shows the end of the same fall.
  pane.shards->time_s.reset();
  const std::vector<Shard> still = shards(pane, network, 4);
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_TRUE(still[i].motion == places[6][i].motion && still[i].state == places[6][i].state) << still[i].id;
  }
  EXPECT_NE(std::ranges::count(places[5], ShardState::standing, &ShardPlace::state),
            std::ranges::count(places[0], ShardState::standing, &ShardPlace::state));
}

// What a frame shows: bodies, with a ball about each.
struct Shown {
  std::vector<std::vector<Prism>> bodies;
  std::vector<vec3> middles;
  std::vector<double> reaches;
};

Shown shown(const Pane& pane, std::vector<Shard> in_pane, const std::vector<ShardPlace>& places) {
  Shown result;
  for (std::size_t i = 0; i < in_pane.size(); ++i) {
    in_pane[i].motion = places[i].motion;
    result.bodies.push_back(prisms(in_pane[i], pane.thickness_mm));
    const vec2 centre = geometry::centroid(in_pane[i].face.outline);
    result.middles.push_back(moved(places[i].motion, {centre, 0.0}));
    double reach = 0.0;
    for (const vec2 p : in_pane[i].face.outline) reach = std::max(reach, glm::length(p - centre));
    result.reaches.push_back(reach + pane.thickness_mm);
  }
  return result;
}

// The deepest that one of those that fall reaches into another, standing or falling.
double deepest_of(const Shown& frame, const std::vector<ShardPlace>& places) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].state != ShardState::fallen) continue;
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (j == i || (j < i && places[j].state == ShardState::fallen)) continue;
      if (glm::length(frame.middles[i] - frame.middles[j]) > frame.reaches[i] + frame.reaches[j]) continue;
      deepest = std::max(deepest, depth(frame.bodies[i], frame.bodies[j]));
    }
  }
  return deepest;
}

constexpr double most_reach_mm = 0.5;

// At each fiftieth of a second.
TEST(ShardsOnTheirWay, ReachIntoNothing) {
  const Pane pane = small_hole();
  const std::vector<Shard> in_pane = pieces_in_pane(pane, 4);
  std::vector<double> times;
  for (int i = 1; i <= 60; ++i) times.push_back(0.02 * i);
  const auto places = places_of_fall(pane, in_pane, 4, times);
  double deepest = 0.0;
  double deepest_around = 0.0;
  for (const std::vector<ShardPlace>& now : places) {
    const Shown frame = shown(pane, in_pane, now);
    deepest = std::max(deepest, deepest_of(frame, now));
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i].state != ShardState::fallen) continue;
      deepest_around = std::max(deepest_around, depth_in_surroundings(pane, frame.bodies[i]));
    }
  }
  EXPECT_LE(deepest, most_reach_mm);
  EXPECT_LE(deepest_around, most_reach_mm);
  RecordProperty("deepest_um", static_cast<int>(1000.0 * std::max(deepest, deepest_around)));
  // The twin: a straight way from where each started to where it ended.
  double deepest_made_up = 0.0;
  for (int tenth = 1; tenth < 10; ++tenth) {
    std::vector<ShardPlace> made_up = places.back();
    for (ShardPlace& place : made_up) place.motion.shift_mm *= 0.1 * tenth;
    deepest_made_up = std::max(deepest_made_up, deepest_of(shown(pane, in_pane, made_up), made_up));
  }
  EXPECT_GT(deepest_made_up, most_reach_mm);
}

// Of all bodies that are out at three steps in succession. The engine presses apart what has come too near, which gives a
// little: less than a hundredth of what a mean piece has lost when it lies on the sill.
TEST(ShardsOnTheirWay, GainNoEnergy) {
  const Pane pane = small_hole();
  const std::vector<Shard> in_pane = pieces_in_pane(pane, 4);
  const std::vector<double> times = all_steps(1.2);
  const auto places = places_of_fall(pane, in_pane, 4, times);
  const auto energy = [&](std::size_t piece, std::size_t step) {
    const Energies parts =
        energies(in_pane[piece], pane.thickness_mm, places[step - 1][piece].motion, places[step][piece].motion);
    return parts.moving + parts.standing;
  };
  constexpr std::size_t frame = 8;  // steps
  double most_gained = -1e300;
  double lost = 0.0;
  double pieces = 0.0;
  for (const ShardPlace& place : places.back()) pieces += place.state == ShardState::fallen ? 1.0 : 0.0;
  for (std::size_t t = frame + 1; t < times.size(); t += frame) {
    double gained = 0.0;
    for (std::size_t i = 0; i < in_pane.size(); ++i) {
      if (places[t - frame - 1][i].state == ShardState::fallen) gained += energy(i, t) - energy(i, t - frame);
    }
    most_gained = std::max(most_gained, gained);
    lost -= gained;
  }
  ASSERT_GT(pieces, 10.0);
  EXPECT_LE(most_gained, 0.01 * lost / pieces);
  RecordProperty("most_gained_ppm_of_a_piece", static_cast<int>(1e6 * most_gained / (lost / pieces)));
}

TEST(FallenShards, AreRefusedWhereThereAreTooMany) {
  Pane pane = window();
  pane.glass = Tempered{};
  std::get<Tempered>(pane.glass).count_per_square = 200.0;  // 5760 pieces
  pane.shards->missing = 1.0;
  pane.shards->missing_mm = 100000.0;
  try {
    static_cast<void>(shards(pane, broken(pane, 7), 7));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("window.shards: expected at most 4000 pieces that fall to sill and floor, got "),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace shatterpave::glass
