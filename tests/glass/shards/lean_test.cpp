// Walls of shards that lean: closed solids, no two of which meet, at any height.
#include "glass/shards/lean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/random.h"
#include "geometry/solid.h"
#include "glass/breaking.h"
#include "glass/shards/shard_faces.h"
#include "glass/shards/shard_pieces.h"
#include "glass/shards/shard_solid.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {
namespace {

Pane leaning_window(bool is_real) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {160, 0}, {160, 120}, {0, 120}};
  pane.thickness_mm = 4.0;
  pane.pattern = is_real ? Pattern::real : Pattern::agui1992;
  Impact impact;
  impact.at_mm = {70, 65};
  impact.radial_count = 30;
  pane.impacts = {impact};
  pane.shards = ShardRules{};
  pane.shards->leaning = true;
  pane.shards->missing = 0.0;
  return pane;
}

TEST(Lean, ShrinksNoDistanceByMoreThanThreeQuarters) {
  const Pane pane = leaning_window(true);
  const Lean lean(pane, 3);
  Address address{Stream::crack_tilt, Id("pairs")};
  const auto draw = [&] {
    ++address.draw;
    return uniform(3, address);
  };
  double most = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const vec2 a{160.0 * draw(), 120.0 * draw()};
    const vec2 way{4.0 * draw() - 2.0, 4.0 * draw() - 2.0};
    const double z = 4.0 * draw() - 2.0;
    most = std::max(most, glm::length(lean.aside_mm(a + way, z) - lean.aside_mm(a, z)) / glm::length(way));
    farthest = std::max(farthest, glm::length(lean.aside_mm(a, z)));
  }
  EXPECT_LT(most, 0.75);
  EXPECT_GT(most, 0.1);
  EXPECT_GT(farthest, 0.5);
}

TEST(Lean, IsNoneAtTheEdgeAtImpactsAndWhereItIsNotAskedFor) {
  Pane pane = leaning_window(true);
  const Lean lean(pane, 3);
  for (const vec2 at : {vec2{0, 50}, vec2{80, 120}, vec2{160, 120}, vec2{70, 65}}) {
    EXPECT_EQ(lean.aside_mm(at, 2.0), (vec2{0.0, 0.0}));
  }
  EXPECT_NE(lean.aside_mm({120, 60}, 2.0), (vec2{0.0, 0.0}));
  pane.shards->leaning = false;
  EXPECT_TRUE(Lean(pane, 3).is_upright());
  EXPECT_TRUE(Lean().is_upright());
}

using Slice = std::vector<std::pair<vec2, vec2>>;

// What a plane at a height, in µm from the back, cuts out of the walls.
Slice slice_of(const geometry::Solid& solid, double z_um) {
  Slice slice;
  for (const geometry::SolidTriangle& triangle : solid.triangles) {
    std::vector<vec2> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const geometry::LatticePoint3& a = solid.vertices[triangle.corners.at(k)];
      const geometry::LatticePoint3& b = solid.vertices[triangle.corners.at((k + 1) % 3)];
      const double over_a = static_cast<double>(a.z) - z_um;
      const double over_b = static_cast<double>(b.z) - z_um;
      if ((over_a < 0.0) == (over_b < 0.0)) continue;
      const vec2 at_a{geometry::to_mm(a.x), geometry::to_mm(a.y)};
      const vec2 at_b{geometry::to_mm(b.x), geometry::to_mm(b.y)};
      ends.push_back(glm::mix(at_a, at_b, over_a / (over_a - over_b)));
    }
    if (ends.size() == 2) slice.emplace_back(ends[0], ends[1]);
  }
  return slice;
}

bool cross_properly(const std::pair<vec2, vec2>& s, const std::pair<vec2, vec2>& t) {
  const auto side = [](const std::pair<vec2, vec2>& of, vec2 p) { return cross(of.second - of.first, p - of.first); };
  return side(s, t.first) * side(s, t.second) < 0.0 && side(t, s.first) * side(t, s.second) < 0.0;
}

geometry::Box box_of(const Slice& slice) {
  geometry::Box box{slice.front().first, slice.front().first};
  for (const auto& [a, b] : slice) {
    box.low = glm::min(box.low, glm::min(a, b));
    box.high = glm::max(box.high, glm::max(a, b));
  }
  return box;
}

// How often walls of two shards cross at the height.
std::size_t slice_crossings(const std::vector<geometry::Solid>& solids, double z_um) {
  std::vector<Slice> slices;
  for (const geometry::Solid& solid : solids) {
    slices.push_back(slice_of(solid, z_um));
    if (slices.back().empty()) slices.pop_back();
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const geometry::Box own = box_of(slices[i]);
    for (std::size_t j = i + 1; j < slices.size(); ++j) {
      if (!geometry::boxes_meet(own, box_of(slices[j]))) continue;
      for (const auto& s : slices[i]) {
        const geometry::Box of_s = box_of({s});
        for (const auto& t : slices[j]) {
          if (geometry::boxes_meet(of_s, box_of({t})) && cross_properly(s, t)) ++count;
        }
      }
    }
  }
  return count;
}

std::vector<geometry::Solid> solids_of(const std::vector<Shard>& shards) {
  std::vector<geometry::Solid> solids;
  for (const Shard& shard : shards) solids.push_back(shard.solid);
  return solids;
}

// Area of walls, in mm², that lean by more than 10°; walls: broken, and between the bevels.
std::pair<double, double> walls_and_leaning(const Pane& pane, const Shard& shard) {
  const std::int64_t bevel = geometry::to_lattice(pane.shards->bevel_mm);
  const std::int64_t top = geometry::to_lattice(pane.thickness_mm) - bevel;
  double walls = 0.0;
  double leaning = 0.0;
  for (const geometry::SolidTriangle& triangle : shard.solid.triangles) {
    if (triangle.slot != static_cast<int>(ShardSurface::broken)) continue;
    std::array<vec3, 3> c{};
    bool is_wall = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const geometry::LatticePoint3& v = shard.solid.vertices[triangle.corners.at(k)];
      is_wall = is_wall && v.z >= bevel && v.z <= top;
      c.at(k) = in_pane_mm(v, pane.thickness_mm);
    }
    if (!is_wall) continue;
    const vec3 across = 0.5 * glm::cross(c[1] - c[0], c[2] - c[0]);
    walls += glm::length(across);
    if (std::abs(across.z) > 0.17 * glm::length(across)) leaning += glm::length(across);
  }
  return {walls, leaning};
}

TEST(LeaningShards, AreClosedAndDoNotMeetAtAnyHeight) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Pane pane = leaning_window(seed % 2 == 0);
    const std::vector<Shard> all = shards(pane, broken(pane, seed), seed);
    double walls = 0.0;
    double leaning = 0.0;
    for (const Shard& shard : all) {
      EXPECT_TRUE(geometry::is_closed(shard.solid)) << seed << " " << shard.id;
      EXPECT_GT(geometry::sextuple_volume(shard.solid), 0) << seed << " " << shard.id;
      const auto [more_walls, more_leaning] = walls_and_leaning(pane, shard);
      walls += more_walls;
      leaning += more_leaning;
      ++count;
    }
    EXPECT_GT(leaning, 0.05 * walls) << seed;
    for (const double share : {0.05, 0.21, 0.4, 0.63, 0.9}) {
      EXPECT_EQ(slice_crossings(solids_of(all), 1000.0 * pane.thickness_mm * share + 0.5), 0U) << seed << " " << share;
    }
  }
  EXPECT_GT(count, 100U);
}

TEST(LeaningShards, OfFieldsOfTheirOwnDoMeet) {
  const Pane pane = leaning_window(true);
  const CrackNetwork network = broken(pane, 2);
  const FacedPane faced = faced_pane(pane, network);
  const std::vector<ShardPiece> pieces = shard_pieces(pane, faced, {}, std::vector<bool>(faced.faces.size(), true));
  std::vector<geometry::Solid> solids;
  std::uint64_t field = 0;
  for (const ShardPiece& piece : pieces) solids.push_back(shard_solid(piece.blank, *pane.shards, {}, Lean(pane, ++field)));
  EXPECT_GT(slice_crossings(solids, 3600.5), 10U);
  Pane upright = pane;
  upright.shards->leaning = false;
  const std::vector<Shard> all = shards(upright, network, 2);
  double leaning = 0.0;
  for (const Shard& shard : all) leaning += walls_and_leaning(upright, shard).second;
  EXPECT_LT(leaning, 0.1);  // at most needles of it
}

}  // namespace
}  // namespace shatterpave::glass
