// Shards while cracks grow: held against those at the end.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "geometry/clip.h"
#include "glass/breaking.h"
#include "glass/map/growth_clock.h"
#include "glass/network_oracle.h"
#include "glass/shards/shard_faces.h"
#include "glass/shards/shard_oracle.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {
namespace {

Pane shard_window(Glass glass, Pattern pattern) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {220, 0}, {220, 150}, {0, 150}};
  pane.thickness_mm = 3.0;
  pane.glass = glass;
  pane.pattern = pattern;
  Impact impact;
  impact.at_mm = {110, 80};
  impact.radial_count = 30;
  pane.impacts = {impact};
  pane.shards = ShardRules{};
  pane.shards->fallen = 0.0;
  pane.shards->missing_mm = 40.0;
  return pane;
}

Glass large_dice() {
  Tempered glass;
  glass.count_per_square = 6.0;
  return glass;
}

std::vector<Pane> shard_windows() {
  Pane joined = shard_window(Annealed{}, Pattern::real);
  joined.shards->joined = true;
  return {shard_window(Annealed{}, Pattern::agui1992), shard_window(Annealed{}, Pattern::real),
          shard_window(large_dice(), Pattern::agui1992), joined};
}

double end_us(Pane pane, std::uint64_t seed) {
  pane.time_us = 0.0;
  double last = 0.0;
  for (const Crack& crack : broken(pane, seed).cracks) last = std::max(last, crack.times_us.back());
  return last;
}

std::vector<Shard> shards_at(Pane pane, double time_us, std::uint64_t seed) {
  pane.time_us = time_us;
  return shards(pane, broken(pane, seed), seed);
}

double area_of(const std::vector<Shard>& all) {
  double sum = 0.0;
  for (const Shard& shard : all) sum += geometry::area(shard.face);
  return sum;
}

TEST(GrowingShards, EndAsTheStillHasThem) {
  for (const Pane& pane : shard_windows()) {
    EXPECT_TRUE(shards_at(pane, 1.01 * end_us(pane, 3), 3) == shards(pane, broken(pane, 3), 3));
  }
}

TEST(GrowingShards, AreOneBeforeTheImpact) {
  for (const Pane& pane : shard_windows()) {
    const std::vector<Shard> all = shards_at(pane, 0.0, 3);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all.front().state, ShardState::standing);
    EXPECT_NEAR(geometry::area(all.front().face), 220.0 * 150.0, 0.01);
  }
}

// Sound at any time, with ids of their own; what left the pane is what leaves it at the end, and never comes back.
TEST(GrowingShards, LeaveThePaneOnceAndStaySound) {
  for (const Pane& pane : shard_windows()) {
    const double last_us = end_us(pane, 3);
    std::map<std::string, ShardState> at_end;
    std::map<std::string, geometry::Region> faces;
    const std::vector<Shard> still = shards(pane, broken(pane, 3), 3);
    for (const Shard& shard : still) {
      at_end[shard.id] = shard.state;
      faces[shard.id] = shard.face;
    }
    std::map<std::string, int> left;  // when
    for (int frame = 1; frame <= 6; ++frame) {
      const std::vector<Shard> all = shards_at(pane, last_us * frame / 6.0, 3);
      EXPECT_EQ(findings(pane, all).faults, nothing) << frame;
      EXPECT_LE(area_of(all), 220.0 * 150.0 + 0.01);
      // What is missing of the area are gaps and dust; at the end they are most.
      EXPECT_GE(area_of(all), area_of(still) - 1.0) << frame;
      std::map<std::string, ShardState> now;
      for (const Shard& shard : all) EXPECT_TRUE(now.emplace(shard.id, shard.state).second) << shard.id << " twice";
      for (const auto& [id, when] : left) EXPECT_TRUE(now.contains(id) && now[id] != ShardState::standing) << id << " is back";
      for (const Shard& shard : all) {
        if (shard.state == ShardState::standing) continue;
        left.emplace(shard.id, frame);
        ASSERT_TRUE(at_end.contains(shard.id)) << shard.id;
        EXPECT_EQ(at_end[shard.id], shard.state) << shard.id;
        EXPECT_TRUE(faces[shard.id] == shard.face) << shard.id;
      }
    }
    EXPECT_FALSE(left.empty());
  }
}

// Each face is one of those at the end, or several between which a crack is missing: by area, and by their number.
TEST(GrowingShards, FacesAreWholeOrTogether) {
  for (Pane pane : shard_windows()) {
    pane.time_us = 0.0;
    const CrackNetwork network = broken(pane, 5);
    const FacedPane end = faced_pane(pane, network);
    std::size_t whole_before = 0;
    for (int frame = 0; frame <= 24; ++frame) {
      const CrackNetwork now = network_at(pane, network, end_us(pane, 5) * frame / 24.0 * 1.01);
      const GrownFaces grown = grown_faces(end, network, now);
      double area = 0.0;
      for (const ShardFace& face : grown.pane.faces) area += geometry::area(region(face.face));
      EXPECT_NEAR(area, 220.0 * 150.0, 0.01);
      const auto whole = static_cast<std::size_t>(std::ranges::count(grown.is_whole, true));
      EXPECT_GE(whole, whole_before);
      whole_before = whole;
      for (std::size_t i = 0; i < grown.is_whole.size(); ++i) {
        const double here = geometry::area(region(grown.pane.faces[i].face));
        const double there = geometry::area(region(end.faces[grown.becomes[i]].face));
        if (grown.is_whole[i]) {
          EXPECT_NEAR(here, there, 1e-9);
          EXPECT_EQ(grown.pane.faces[i].id, end.faces[grown.becomes[i]].id);
        } else {
          EXPECT_GT(here, there);
        }
      }
    }
    EXPECT_EQ(whole_before, end.faces.size());
  }
}

}  // namespace
}  // namespace shatterpave::glass
