// Every triangle of a shard is of the surface that it lies in, has an area, and closes with its neighbours. SHARD_SEEDS in the
// environment asks for so many odd panes in place of a few: .ci/long/shards does.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>

#include "core/functions.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "glass/breaking.h"
#include "glass/random_panes.h"
#include "glass/shards/shard_oracle.h"
#include "glass/shards/shard_solid.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {
namespace {

std::uint64_t seeds_asked(std::uint64_t few) {
  const char* asked = std::getenv("SHARD_SEEDS");
  return asked == nullptr ? few : std::strtoull(asked, nullptr, 10);
}

void expect_sound(const ShardFindings& found) {
  EXPECT_TRUE(found.faults.empty()) << found.faults.size() << " faults, first " << found.faults.front() << "; "
                                    << found.faults.back();
  EXPECT_EQ(found.level_bevel_mm2, 0.0);
}

void print(const char* what, const ShardFindings& found) {
  std::cout << what << ": " << found.shards << " shards, " << found.triangles << " triangles: " << found.faces << " in faces, "
            << found.edges << " on edges, " << found.walls << " on walls, " << found.bevels << " of bevels (" << found.undecided
            << " more between sides of both kinds), " << found.narrow << " narrow; least height " << found.least_height_um
            << " um, " << found.thin << " below half a um; level below faces " << found.level_bevel_mm2 << " mm2; "
            << found.faults.size() << " faults\n";
}

// The window of scenes/broken_window.toml.
Pane broken_sash() {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {560, 0}, {560, 420}, {0, 420}};
  pane.thickness_mm = 4.0;
  Impact impact;
  impact.at_mm = {262, 245};
  impact.radial_count = 100;
  impact.large_count = 34;
  impact.circular_count = 40;
  pane.impacts = {impact};
  pane.growth.spread_limit = 0.6;
  pane.growth.ring_radius_offset_mm = 60.0;
  pane.growth.ring_onset = 1.0;
  pane.shards = ShardRules{};
  pane.shards->missing_mm = 100.0;
  return pane;
}

std::vector<Shard> shards_of(const Pane& pane, std::uint64_t seed) { return shards(pane, broken(pane, seed), seed); }

// A neck of this one is narrower than two bevels: beyond it, its faces were taken for bevel, 41 % of them.
TEST(ShardSurfaces, NecksPartNoFace) {
  Pane pane = broken_sash();
  pane.shards->fallen = 0.0;
  const std::vector<Shard> all = shards_of(pane, 7);
  const auto leaf = std::ranges::find(all, "c67l1", &Shard::id);
  ASSERT_NE(leaf, all.end());
  EXPECT_GT(flat_share(pane, *leaf), 0.8);
  for (const Shard& shard : all) {
    EXPECT_TRUE(geometry::area(shard.face) < 100.0 || flat_share(pane, shard) > 0.6) << shard.id;
  }
}

TEST(ShardSurfaces, OfTheBrokenWindowAreThoseOfTheirPlaces) {
  for (const bool joined : {false, true}) {
    Pane pane = broken_sash();
    pane.shards->joined = joined;
    pane.shards->fallen = 0.0;
    for (std::uint64_t seed = 7; seed < 7 + (seeds_asked(2) + 9) / 10; ++seed) {
      expect_sound(findings(pane, shards_of(pane, seed)));
    }
  }
}

// ---- by hand

// A shard of a pane of 100 × 100 × 2 mm, with bevels of 0.2 mm; sides on the pane's edge are old.
struct ByHand {
  Pane pane;
  Shard shard;
  ShardBlank blank;
};

ByHand by_hand(const geometry::Polygon& outline, const Chips& chips) {
  ByHand made;
  made.pane.outline_mm = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  ShardRules rules;
  rules.bevel_mm = 0.2;
  made.blank = {{outline, {}}, {}, made.pane.thickness_mm, Id("by hand")};
  std::vector<bool>& is_old = made.blank.is_old.emplace_back();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 a = outline[i];
    const vec2 b = outline[(i + 1) % outline.size()];
    is_old.push_back((a.x == b.x && (a.x == 0.0 || a.x == 100.0)) || (a.y == b.y && (a.y == 0.0 || a.y == 100.0)));
  }
  made.shard.face = made.blank.region;
  made.shard.solid = shard_solid(made.blank, rules, chips);
  return made;
}

// What of it is old between the faces, not upright: bevels of the pane's edge.
double old_bevel_mm2(const ByHand& made) {
  double sum = 0.0;
  for (const geometry::SolidTriangle& triangle : made.shard.solid.triangles) {
    std::array<vec3, 3> p;
    std::ranges::transform(triangle.corners, p.begin(),
                           [&](std::uint32_t v) { return in_pane_mm(made.shard.solid.vertices[v], made.pane.thickness_mm); });
    const vec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
    const bool slants = across.z != 0.0 && (across.x != 0.0 || across.y != 0.0);
    if (slants && triangle.slot == static_cast<int>(ShardSurface::old)) sum += 0.5 * glm::length(across);
  }
  return sum;
}

// A rectangle with one side on the edge: of that side's bevel, the half next to the face was taken for a crack's.
TEST(ShardSurfaces, BevelsOfThePanesEdgeAreOldToTheirCorners) {
  const ByHand made = by_hand({{10, 0}, {40, 0}, {40, 20}, {10, 20}}, {});
  expect_sound(findings(made.pane, made.shard));
  // Two of them, mitred: 30 mm at the wall, 29.6 mm at the face, 0.2 √2 wide.
  EXPECT_NEAR(old_bevel_mm2(made), 2.0 * 29.8 * 0.2 * 1.41421356, 1e-6);
  const ByHand corner = by_hand({{0, 0}, {30, 0}, {30, 20}, {0, 20}}, {});
  expect_sound(findings(corner.pane, corner.shard));
  EXPECT_NEAR(old_bevel_mm2(corner), 2.0 * (29.8 + 19.8) * 0.2 * 1.41421356, 1e-6);
  const ByHand inside = by_hand({{10, 10}, {40, 10}, {40, 20}, {10, 20}}, {});
  expect_sound(findings(inside.pane, inside.shard));
  EXPECT_EQ(old_bevel_mm2(inside), 0.0);
}

// Two squares and a neck between them, 0.3 mm wide where two bevels take 0.4.
TEST(ShardSurfaces, FacesGoOnBeyondANeckAndARidgeLeadsThere) {
  const geometry::Polygon dumb_bell = {{10, 10}, {20, 10}, {20, 14.8}, {23, 14.85}, {26, 14.8}, {26, 10}, {36, 10},
                                       {36, 20}, {26, 20}, {26, 15.2}, {23, 15.15}, {20, 15.2}, {20, 20}, {10, 20}};
  const ByHand made = by_hand(dumb_bell, {});
  const ShardFindings found = findings(made.pane, made.shard);
  expect_sound(found);
  EXPECT_EQ(found.narrow, 0U);
  // All of the two squares but their bevels: 9.6 mm long and wide.
  EXPECT_GT(flat_share(made.pane, made.shard) * geometry::area(made.shard.face), 2.0 * 9.6 * 9.6);
  // The ridge in the middle of the neck is half as high as that is wide.
  std::int64_t ridge = 0;
  for (const geometry::LatticePoint3& p : made.shard.solid.vertices) {
    if (std::abs(p.x - 23'000) < 500 && std::abs(p.y - 15'000) < 50) ridge = std::max(ridge, p.z);
  }
  EXPECT_NEAR(static_cast<double>(ridge), 2000.0 - 200.0 + 150.0, 10.0);
}

// The same with a neck that bevels leave, but through which a chip is bitten.
TEST(ShardSurfaces, FacesGoOnBeyondAChip) {
  const geometry::Polygon strip = {{10, 10}, {40, 10}, {40, 11}, {10, 11}};
  Chips chips;
  chips.front.push_back({{25, 10}, {{24, 9.5}, {26, 9.5}, {26.2, 11.5}, {23.8, 11.5}}});
  const ByHand made = by_hand(strip, chips);
  expect_sound(findings(made.pane, made.shard));
  // On the back 29.6 × 0.6 mm are flat, on the front that less at most 2.4 mm.
  EXPECT_GT(flat_share(made.pane, made.shard) * 2.0 * 30.0, 0.6 * (29.6 + 27.2));
}

// A long needle, as wide as two bevels only near its root.
TEST(ShardSurfaces, TipsOfNeedlesAreRidges) {
  const ByHand made = by_hand({{10, 10}, {40, 10.7}, {10, 11.4}}, {});
  const ShardFindings found = findings(made.pane, made.shard);
  expect_sound(found);
  EXPECT_EQ(found.narrow, 0U);
}

// The oracle is not blind.
TEST(ShardSurfaces, TheOracleSeesFaults) {
  const ByHand made = by_hand({{10, 0}, {40, 0}, {40, 20}, {10, 20}}, {});
  for (std::size_t i = 0; i < made.shard.solid.triangles.size(); ++i) {
    Shard shard = made.shard;
    shard.solid.triangles[i].slot = 1 - shard.solid.triangles[i].slot;
    EXPECT_EQ(findings(made.pane, shard).faults.size(), 1U) << i;
    shard = made.shard;
    std::swap(shard.solid.triangles[i].corners[0], shard.solid.triangles[i].corners[1]);
    EXPECT_FALSE(findings(made.pane, shard).faults.empty()) << i;
    shard = made.shard;
    shard.solid.triangles[i].corners[0] = shard.solid.triangles[i].corners[1];
    EXPECT_FALSE(findings(made.pane, shard).faults.empty()) << i;
  }
}

// Panes of any kind and shape, broken by any rules.
Pane odd_pane(std::uint64_t seed) {
  Pane pane = random_pane(seed, {2, seed % 5 == 0 ? 150 : 25});
  std::uint32_t next = 0;
  const auto draw = [&] { return uniform(seed, {Stream::turn, Id("odd shards"), next++}); };
  const auto between = [&](double low, double high) { return low * power(high / low, draw()); };
  pane.thickness_mm = geometry::to_mm(geometry::to_lattice(between(0.2, 40.0)));
  pane.pattern = draw() < 0.3 ? Pattern::real : Pattern::agui1992;
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const vec2 size = box.high - box.low;
  if (draw() < 0.25) {
    pane.glass = Laminated{};
  } else if (draw() < 0.4 && size.x * size.y < 1e6) {
    pane.glass = Tempered{};
    std::get<Tempered>(pane.glass).count_per_square = std::clamp(2500.0 * 500.0 / (size.x * size.y), 1.0, 2500.0);
  }
  ShardRules rules;
  rules.joined = draw() < 0.4;
  rules.gap_mm = between(0.02, 2.0);
  rules.bevel_mm = draw() < 0.1 ? 0.0 : between(0.001, 3.0);
  rules.splinter_mm2 = between(0.01, 4.0);
  rules.chips_per_m = between(1.0, 300.0);
  rules.chip_mm = between(0.1, 6.0);
  rules.fallen = 0.0;
  pane.shards = rules;
  return pane;
}

TEST(ShardSurfaces, OfOddPanesAreThoseOfTheirPlaces) {
  ShardFindings all;
  for (std::uint64_t seed = 1; seed <= seeds_asked(24); ++seed) {
    const Pane pane = odd_pane(seed);
    const ShardFindings found = findings(pane, shards_of(pane, seed));
    EXPECT_TRUE(found.faults.empty()) << "pane " << seed << ": " << found.faults.size() << " faults, first "
                                      << found.faults.front() << "; " << found.faults.back();
    EXPECT_EQ(found.level_bevel_mm2, 0.0) << "pane " << seed;
    all.add(found);
  }
  print("odd panes", all);
  EXPECT_GT(all.shards, 20 * seeds_asked(24));
  EXPECT_GT(all.edges, all.shards / 50);
  EXPECT_LT(all.undecided, all.bevels / 10);
}

}  // namespace
}  // namespace shatterpave::glass
