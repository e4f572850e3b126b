#include "glass/shards/shards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include "core/parallel.h"
#include "geometry/planar_map.h"
#include "geometry/predicates.h"
#include "geometry/segment_distance.h"
#include "geometry/triangulation.h"
#include "glass/breaking.h"
#include "glass/random_panes.h"
#include "glass/shards/shard_faces.h"

namespace shatterpave::glass {
namespace {

using geometry::LatticePoint;
using geometry::Solid;
using geometry::WideVolume;

Pane broken_window(int radial_count, double thickness_mm = 3.0) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {400, 0}, {400, 300}, {0, 300}};
  pane.thickness_mm = thickness_mm;
  Impact impact;
  impact.at_mm = {168, 165};
  impact.radial_count = radial_count;
  pane.impacts = {impact};
  pane.shards = ShardRules{};
  pane.shards->fallen = 0.0;
  return pane;
}

std::int64_t doubled_area_of(const geometry::Polygon& polygon) {
  std::vector<LatticePoint> points;
  for (const vec2 p : polygon) points.push_back(geometry::to_lattice(p));
  return geometry::doubled_area(points);
}

std::int64_t doubled_area_of(const geometry::Region& region) {
  std::int64_t sum = doubled_area_of(region.outline);
  for (const geometry::Polygon& hole : region.holes) sum += doubled_area_of(hole);
  return sum;
}

TEST(ShardFaces, TileARectangleExactly) {
  for (const int radials : {1, 24, 113, 195}) {
    const Pane pane = broken_window(radials);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const FacedPane faced = faced_pane(pane, broken(pane, seed));
      std::int64_t sum = 0;
      for (const ShardFace& face : faced.faces) {
        sum += geometry::doubled_area(face.face);
        EXPECT_GT(geometry::doubled_area(face.face), 0);
      }
      EXPECT_EQ(sum, 2 * 400'000LL * 300'000LL);
    }
  }
}

// Sides of segments that no face has, but for the outer side of the edge and for spurs, be it of a face or of a sliver that is
// none.
std::vector<geometry::FaceSide> sides_of_no_face(const FacedPane& faced) {
  std::vector<std::array<bool, 2>> has_face(faced.segments.size(), {false, false});  // on its left and right
  for (const ShardFace& face : faced.faces) {
    const auto note = [&](const geometry::FaceRing& ring) {
      for (const geometry::FaceSide& side : ring) has_face[side.segment][side.forward ? 0 : 1] = true;
    };
    note(face.face.outline);
    std::ranges::for_each(face.face.holes, note);
    for (const std::size_t spur : face.face.spurs) has_face[spur] = {true, true};
  }
  std::vector<geometry::FaceSide> sides;
  for (std::size_t i = 0; i < faced.segments.size(); ++i) {
    const geometry::Segment& segment = faced.segments[i];
    if (segment.owner != pane_edge && has_face[i][0] == has_face[i][1]) continue;
    if (!has_face[i][0]) sides.push_back({i, true, segment.a});
    if (!has_face[i][1] && segment.owner != pane_edge) sides.push_back({i, false, segment.b});
  }
  return sides;
}

double from_outline_mm(const Pane& pane, vec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
    const vec2 next = pane.outline_mm[(i + 1) % pane.outline_mm.size()];
    nearest = std::min(nearest, geometry::distance_to_segment(p, pane.outline_mm[i], next));
  }
  return nearest;
}

// Twice what the sides enclose, in µm², as seen from a point. Those of no face lie within 1 µm of the outline.
std::int64_t doubled_area_of_slivers(const Pane& pane, const FacedPane& faced, LatticePoint from) {
  std::int64_t sum = 0;
  for (const geometry::FaceSide& side : sides_of_no_face(faced)) {
    const geometry::Segment& segment = faced.segments[side.segment];
    const LatticePoint& to = side.forward ? segment.b : segment.a;
    sum += (side.from.x - from.x) * (to.y - from.y) - (side.from.y - from.y) * (to.x - from.x);
    EXPECT_LE(from_outline_mm(pane, geometry::to_mm(side.from)), 0.001 + 1e-9);
    EXPECT_LE(from_outline_mm(pane, geometry::to_mm(to)), 0.001 + 1e-9);
  }
  return sum;
}

// On slanting edges cracks end beside them: what faces leave out is what the bent edge leaves out, exactly, and at most 1 µm
// wide. Slivers between the bent edge and cracks that run along it are no faces where they are turned over.
TEST(ShardFaces, TileOddPanesButForTheEndsOfCracksOnSlantingEdges) {
  int slanting = 0;
  int turned_over = 0;
  std::size_t spurs = 0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const Pane pane = random_pane(seed, {});
    const FacedPane faced = faced_pane(pane, broken(pane, seed));
    std::int64_t sum = 0;
    for (const ShardFace& face : faced.faces) {
      sum += geometry::doubled_area(face.face);
      spurs += face.face.spurs.size();
    }
    std::vector<LatticePoint> edge;
    double length_um = 0.0;
    for (const geometry::Segment& segment : faced.segments) {
      if (segment.owner != pane_edge) continue;
      edge.push_back(segment.a);
      length_um += 1000.0 * glm::length(geometry::to_mm(segment.b) - geometry::to_mm(segment.a));
    }
    const std::int64_t slivers = doubled_area_of_slivers(pane, faced, edge.front());
    EXPECT_LE(slivers, 0) << "pane " << seed;
    EXPECT_EQ(sum + slivers, geometry::doubled_area(edge)) << "pane " << seed;
    if (slivers != 0) ++turned_over;
    const std::int64_t lost = doubled_area_of(pane.outline_mm) - sum;
    EXPECT_LE(std::abs(static_cast<double>(lost)), 2.0 * length_um) << "pane " << seed;
    if (lost != 0) ++slanting;
    count += faced.faces.size();
  }
  EXPECT_GT(slanting, 30);
  EXPECT_GT(turned_over, 0);
  EXPECT_GT(spurs, 1000U);
  EXPECT_GT(count, 1500U);
}

TEST(ShardFaces, NamesAreUniqueAndTellCrackAndSide) {
  const Pane pane = broken_window(113);
  const CrackNetwork network = broken(pane, 7);
  const FacedPane faced = faced_pane(pane, network);
  std::set<std::string> names;
  for (const ShardFace& face : faced.faces) {
    names.insert(face.id);
    int least = static_cast<int>(network.cracks.size());
    std::set<std::pair<int, bool>> sides;
    geometry::FaceRing border = face.face.outline;
    for (const geometry::FaceRing& hole : face.face.holes) border.insert(border.end(), hole.begin(), hole.end());
    for (const geometry::FaceSide& side : border) {
      const int crack = faced.segments[side.segment].owner;
      if (crack == pane_edge) continue;
      sides.insert({crack, side.forward});
      least = std::min(least, crack);
    }
    const std::string left = "c" + std::to_string(least) + "l";
    const std::string right = "c" + std::to_string(least) + "r";
    EXPECT_TRUE((sides.contains({least, true}) && face.id.starts_with(left)) ||
                (sides.contains({least, false}) && face.id.starts_with(right)))
        << face.id;
  }
  EXPECT_EQ(names.size(), faced.faces.size());
  Pane whole = pane;
  whole.impacts.clear();
  EXPECT_EQ(faced_pane(whole, {}).faces.front().id, "whole");
}

// Twelve times the volume by columns that stand on z = 0, one below each triangle: another way than by pyramids over one point.
WideVolume twelvefold_volume_by_columns(const Solid& solid) {
  WideVolume sum = 0;
  for (const geometry::SolidTriangle& triangle : solid.triangles) {
    const geometry::LatticePoint3& a = solid.vertices[triangle.corners[0]];
    const geometry::LatticePoint3& b = solid.vertices[triangle.corners[1]];
    const geometry::LatticePoint3& c = solid.vertices[triangle.corners[2]];
    const WideVolume doubled =
        static_cast<WideVolume>(b.x - a.x) * (c.y - a.y) - static_cast<WideVolume>(b.y - a.y) * (c.x - a.x);
    sum += 2 * doubled * (a.z + b.z + c.z);
  }
  return sum;
}

// What 3. of shards.h promises, in whole numbers: prisms over the faces are the pane, and each holds its shards and its gaps.
void expect_exact_volumes(const Pane& pane, std::uint64_t seed) {
  const CrackNetwork network = broken(pane, seed);
  const FacedPane faced = faced_pane(pane, network);
  const std::vector<Shard> all = shards(pane, network, seed);
  const std::int64_t thickness = geometry::to_lattice(pane.thickness_mm);
  std::map<std::string, WideVolume> left;  // six times what the prism over each face has beside its shards
  WideVolume prisms = 0;
  for (const ShardFace& face : faced.faces) {
    const WideVolume prism = 3 * static_cast<WideVolume>(geometry::doubled_area(face.face)) * thickness;
    left[face.id] = prism;
    prisms += prism;
  }
  EXPECT_TRUE(prisms == 3 * static_cast<WideVolume>(doubled_area_of(pane.outline_mm)) * thickness);
  WideVolume of_shards = 0;
  for (const Shard& shard : all) {
    EXPECT_TRUE(is_closed(shard.solid)) << shard.id;
    const WideVolume volume = sextuple_volume(shard.solid);
    EXPECT_TRUE(volume > 0) << shard.id;
    EXPECT_TRUE(2 * volume == twelvefold_volume_by_columns(shard.solid)) << shard.id;
    EXPECT_TRUE(volume <= 3 * static_cast<WideVolume>(doubled_area_of(shard.face)) * thickness) << shard.id;
    left[shard.id.substr(0, shard.id.find('p'))] -= volume;
    of_shards += volume;
  }
  WideVolume gaps = 0;
  for (const auto& [face, volume] : left) {
    EXPECT_TRUE(volume > 0) << face;
    gaps += volume;
  }
  EXPECT_TRUE(of_shards + gaps == prisms);
}

TEST(Shards, AndGapsFillThePaneExactly) {
  for (const int radials : {3, 60, 113}) expect_exact_volumes(broken_window(radials), 7);
  Pane sharp = broken_window(40, 2.001);
  sharp.shards->bevel_mm = 0.0;
  expect_exact_volumes(sharp, 3);
}

// Whatever the pane, its shards are sound.
TEST(Shards, OfOddPanesAreClosed) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Pane pane = random_pane(seed, {2, 20});
    pane.thickness_mm = 0.5 + static_cast<double>(seed % 7);
    pane.shards = ShardRules{};
    pane.shards->fallen = 0.0;
    pane.shards->splinter_mm2 = 0.01;
    for (const Shard& shard : shards(pane, broken(pane, seed), seed)) {
      ++count;
      EXPECT_TRUE(is_closed(shard.solid)) << "pane " << seed << ' ' << shard.id;
      EXPECT_TRUE(sextuple_volume(shard.solid) > 0) << "pane " << seed << ' ' << shard.id;
      EXPECT_TRUE(2 * sextuple_volume(shard.solid) == twelvefold_volume_by_columns(shard.solid))
          << "pane " << seed << ' ' << shard.id;
    }
  }
  EXPECT_GT(count, 300U);
}

// Chips are as large as these dice: what rounding to the lattice leaves of a bitten face crosses itself on one of some hundred.
TEST(Shards, OfFineDiceAreClosed) {
  Pane pane = random_pane(1, {1, 1});
  pane.outline_mm = {{0.0, 0.0}, {150.0, 0.0}, {150.0, 150.0}, {0.0, 150.0}};
  pane.impacts.front().at_mm = {75.0, 75.0};
  pane.glass = Tempered{};
  std::get<Tempered>(pane.glass).count_per_square = 150.0;
  pane.shards = ShardRules{};
  pane.shards->missing = 0.0;
  for (const std::uint64_t seed : {1U, 3U}) {
    const std::vector<Shard> all = shards(pane, broken(pane, seed), seed);
    EXPECT_GT(all.size(), 800U);
    for (const Shard& shard : all) {
      EXPECT_TRUE(is_closed(shard.solid)) << seed << ' ' << shard.id;
      EXPECT_TRUE(sextuple_volume(shard.solid) > 0) << seed << ' ' << shard.id;
    }
  }
}

// The check by columns is not blind: a vertex moved inwards by 1 µm changes one volume as the other, but a face turned over or
// left out does not.
TEST(Shards, CheckOfVolumesSeesFaults) {
  const Pane pane = broken_window(20);
  const std::vector<Shard> all = shards(pane, broken(pane, 2), 2);
  Solid solid = all.front().solid;
  const auto agree = [&] { return 2 * sextuple_volume(solid) == twelvefold_volume_by_columns(solid); };
  EXPECT_TRUE(agree());
  solid.triangles.pop_back();
  EXPECT_FALSE(agree());
  EXPECT_FALSE(is_closed(solid));
}

bool borders_meet(const geometry::Polygon& a, const geometry::Polygon& b) {
  if (!geometry::boxes_meet(geometry::bounding_box(a), geometry::bounding_box(b))) return false;
  const auto at = [](const geometry::Polygon& ring, std::size_t i) { return geometry::to_lattice(ring[i % ring.size()]); };
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (geometry::segments_meet(at(a, i), at(a, i + 1), at(b, j), at(b, j + 1))) return true;
    }
  }
  return false;
}

TEST(Shards, DoNotTouchOneAnother) {
  for (const double gap_mm : {0.02, 1.0}) {
    Pane pane = broken_window(80);
    pane.shards->gap_mm = gap_mm;
    const std::vector<Shard> all = shards(pane, broken(pane, 7), 7);
    ASSERT_GT(all.size(), 20U);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        EXPECT_FALSE(borders_meet(all[i].face.outline, all[j].face.outline)) << all[i].id << ' ' << all[j].id;
        EXPECT_FALSE(geometry::contains(all[i].face, all[j].face.outline.front()));
        EXPECT_FALSE(geometry::contains(all[j].face, all[i].face.outline.front()));
      }
    }
  }
}

// Slots: all that lies in the faces of the pane or on its edge is old, and of the walls only that.
TEST(Shards, WallsOfCracksAreBrokenFacesAndEdgesOfThePaneOld) {
  const Pane pane = broken_window(30);
  double old_wall_mm2 = 0.0;
  for (const Shard& shard : shards(pane, broken(pane, 5), 5)) {
    for (const geometry::SolidTriangle& triangle : shard.solid.triangles) {
      std::array<vec3, 3> p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = in_pane_mm(shard.solid.vertices[triangle.corners[i]], pane.thickness_mm);
      const vec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
      const bool level = across.x == 0.0 && across.y == 0.0;
      if (level && std::abs(p[0].z) == 0.5 * pane.thickness_mm) {
        EXPECT_EQ(triangle.slot, static_cast<int>(ShardSurface::old));
      }
      if (across.z == 0.0 && triangle.slot == static_cast<int>(ShardSurface::old)) old_wall_mm2 += 0.5 * glm::length(across);
    }
  }
  // Gaps take a little of the edge, bevels the height.
  const double edge_mm2 = 1400.0 * (pane.thickness_mm - 2.0 * pane.shards->bevel_mm);
  EXPECT_LT(old_wall_mm2, edge_mm2);
  EXPECT_GT(old_wall_mm2, edge_mm2 - 15.0);
}

TEST(Shards, LeaveNearTheImpactAndStayInTheFrame) {
  Pane pane = broken_window(113);
  double near = 0.0;
  double far = 0.0;
  int gone = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const Shard& shard : shards(pane, broken(pane, seed), seed)) {
      const double away = glm::length(geometry::centroid(shard.face.outline) - pane.impacts.front().at_mm);
      const bool left = shard.state != ShardState::standing;
      if (left) ++gone;
      if (away < 25.0) near += left ? 1.0 : -1.0;
      if (away > 110.0) far += left ? 1.0 : -1.0;
    }
  }
  EXPECT_GT(gone, 100);
  EXPECT_GT(near, 0.0);
  EXPECT_LT(far, 0.0);
  pane.shards->missing = 0.0;
  pane.shards->held = 0.0;
  for (const Shard& shard : shards(pane, broken(pane, 1), 1)) EXPECT_EQ(shard.state, ShardState::standing);
}

// A second pane is another name: nothing of the first shows in it, and its own shards are those it has alone.
TEST(Shards, AreTheSameForAnyNumberOfThreads) {
  const Pane pane = broken_window(60);
  const CrackNetwork network = broken(pane, 9);
  std::vector<Shard> once;
  {
    const ThreadLimit limit(1);
    once = shards(pane, network, 9);
  }
  for (const int threads : {2, 7}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(shards(pane, network, 9) == once) << threads;
  }
  Pane other = pane;
  other.name = "door";
  EXPECT_FALSE(shards(other, network, 9) == once);
}

}  // namespace
}  // namespace shatterpave::glass
