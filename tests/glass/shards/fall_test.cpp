// Where fallen shards come to rest: told by their solids alone, without the engine that moved them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/triangulation.h"
#include "glass/breaking.h"
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
    double nearest = 1e300;  // to the wall
    for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
      const vec3 p = moved(shard.motion, in_pane_mm(vertex, pane.thickness_mm));
      lowest = std::min(lowest, p.y);
      nearest = std::min(nearest, p.z);
      // Within the reveal: not beyond its walls, nor in the frame below the pane.
      if (p.z < rules.sill_depth_mm && p.y > -rules.sill_drop_mm) {
        EXPECT_GE(p.x, -rules.reveal_mm - tolerance_mm) << shard.id;
        EXPECT_LE(p.x, 300.0 + rules.reveal_mm + tolerance_mm) << shard.id;
      }
      if (p.y < -tolerance_mm) {
        EXPECT_GE(p.z, rules.frame_mm - tolerance_mm) << shard.id;
      }
    }
    // What lies over the sill lies on it, what does not on the floor; a few lean over the edge.
    EXPECT_GE(lowest, (nearest < rules.sill_depth_mm - 30.0 ? -rules.sill_drop_mm : -rules.floor_drop_mm) - tolerance_mm)
        << shard.id;
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
  heap.shards->missing_mm = 120.0;
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

TEST(FallenShards, KeepTheirShape) {
  const Pane pane = window();
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
