// Shards that stand side by side as one body.
#include "glass/shards/joined_shards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/parallel.h"
#include "geometry/polygon.h"
#include "geometry/segment_distance.h"
#include "glass/breaking.h"
#include "glass/map/crack_paths.h"
#include "glass/random_panes.h"
#include "glass/shards/hole_outline.h"

namespace shatterpave::glass {
namespace {

using geometry::WideVolume;

Pane cracked_window(bool joined, int radial_count = 60) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {400, 0}, {400, 300}, {0, 300}};
  pane.thickness_mm = 3.0;
  Impact impact;
  impact.at_mm = {168, 165};
  impact.radial_count = radial_count;
  pane.impacts = {impact};
  pane.shards = ShardRules{};
  pane.shards->fallen = 0.1;
  pane.shards->joined = joined;
  return pane;
}

std::int64_t doubled_area_with_holes(const geometry::Region& region) {
  std::int64_t sum = 0;
  const auto add = [&](const geometry::Polygon& ring) {
    std::vector<geometry::LatticePoint> points;
    for (const vec2 p : ring) points.push_back(geometry::to_lattice(p));
    sum += geometry::doubled_area(points);
  };
  add(region.outline);
  std::ranges::for_each(region.holes, add);
  return sum;
}

// The ids of the pieces in each shard.
std::vector<std::string> pieces_in(const Shard& shard) {
  return shard.joined.empty() ? std::vector<std::string>{shard.id} : shard.joined;
}

// Which faces of the pane stand.
std::vector<bool> standing(const FacedPane& faced, const std::vector<Shard>& shards) {
  std::set<std::string> ids;
  for (const Shard& shard : shards) {
    if (shard.state != ShardState::standing) continue;
    for (const std::string& id : pieces_in(shard)) ids.insert(id);
  }
  std::vector<bool> stands(faced.faces.size());
  for (std::size_t i = 0; i < stands.size(); ++i) stands[i] = ids.contains(faced.faces[i].id);
  return stands;
}

TEST(JoinedFaces, HaveTheAreaOfTheFacesThatTheyAreMadeOf) {
  std::size_t with_holes = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Pane pane = cracked_window(false, seed % 2 == 0 ? 60 : 113);
    const CrackNetwork network = broken(pane, seed);
    const FacedPane faced = faced_pane(pane, network);
    const std::vector<bool> stands = standing(faced, shards(pane, network, seed));
    std::vector<bool> is_joined(faced.faces.size(), false);
    std::int64_t all = 0;
    for (const JoinedFace& joined : joined_faces(faced, stands)) {
      std::int64_t sum = 0;
      for (const std::size_t face : joined.faces) {
        EXPECT_TRUE(stands[face]);
        EXPECT_FALSE(is_joined[face]);
        is_joined[face] = true;
        sum += geometry::doubled_area(faced.faces[face].face);
      }
      EXPECT_EQ(geometry::doubled_area(joined.face), sum);
      EXPECT_GE(joined.faces.size(), 2U);
      all += sum;
      if (!joined.face.holes.empty()) ++with_holes;
    }
    for (std::size_t i = 0; i < is_joined.size(); ++i) {
      if (!is_joined[i]) all += geometry::doubled_area(faced.faces[i].face);
    }
    EXPECT_EQ(all, 2 * 400'000LL * 300'000LL);
  }
  EXPECT_GT(with_holes, 5U);
}

// Nobody moves: the same pieces stand, lie and are gone, those that lie in the same place, and what stands alone is the same.
TEST(JoinedShards, ChangeNoDecision) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const CrackNetwork network = broken(cracked_window(false), seed);
    const std::vector<Shard> apart = shards(cracked_window(false), network, seed);
    std::map<std::string, const Shard*> by_id;
    for (const Shard& shard : apart) by_id[shard.id] = &shard;
    std::size_t count = 0;
    std::size_t bodies = 0;
    for (const Shard& shard : shards(cracked_window(true), network, seed)) {
      EXPECT_EQ(pieces_in(shard).front(), shard.id);
      for (const std::string& id : pieces_in(shard)) {
        ++count;
        ASSERT_TRUE(by_id.contains(id)) << id;
        EXPECT_EQ(by_id[id]->state, shard.state) << id;
      }
      if (!shard.joined.empty()) ++bodies;
      if (shard.state != ShardState::standing) {
        EXPECT_EQ(shard, *by_id[shard.id]);
      }
    }
    EXPECT_EQ(count, apart.size());
    EXPECT_GE(bodies, 1U);
    EXPECT_TRUE(std::ranges::all_of(apart, [](const Shard& shard) { return shard.joined.empty(); }));
  }
}

TEST(JoinedShards, AreClosedAndWithinTheirFaces) {
  for (const int radials : {3, 60, 113, 195}) {
    Pane pane = cracked_window(true, radials);
    if (radials == 3) pane.shards->missing = 0.0;  // of three nothing leaves
    const CrackNetwork network = broken(pane, 7);
    const WideVolume thickness = geometry::to_lattice(pane.thickness_mm);
    for (const double bevel_mm : {0.12, 0.0}) {
      pane.shards->bevel_mm = bevel_mm;
      WideVolume sum = 0;
      WideVolume prisms = 0;
      for (const Shard& shard : shards(pane, network, 7)) {
        EXPECT_TRUE(is_closed(shard.solid)) << shard.id;
        const WideVolume volume = sextuple_volume(shard.solid);
        const WideVolume prism = 3 * static_cast<WideVolume>(doubled_area_with_holes(shard.face)) * thickness;
        EXPECT_TRUE(volume > 0 && volume <= prism) << shard.id;
        // Sharp ones are prisms, to the last cubic micrometre.
        EXPECT_EQ(volume == prism, bevel_mm == 0.0) << shard.id;
        sum += volume;
        prisms += prism;
      }
      const WideVolume whole = 3 * static_cast<WideVolume>(2 * 400'000LL * 300'000LL) * thickness;
      EXPECT_TRUE(radials == 3 ? prisms == whole : prisms < whole);
      EXPECT_TRUE(sum <= prisms);
    }
  }
}

// Nothing gives up glass but along cracks that are left: bodies and pieces that stand alone, and between them the gaps.
TEST(JoinedShards, FillThePaneWhereNothingHasLeft) {
  Pane pane = cracked_window(true);
  pane.shards->missing = 0.0;
  pane.shards->held = 0.0;
  pane.shards->splinter_mm2 = 0.01;
  pane.shards->bevel_mm = 0.0;
  const CrackNetwork network = broken(pane, 3);
  const FacedPane faced = faced_pane(pane, network);
  const std::vector<Shard> all = shards(pane, network, 3);
  const std::vector<bool> stands = standing(faced, all);
  ASSERT_TRUE(std::ranges::all_of(stands, [](bool one) { return one; }));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(sextuple_volume(all.front().solid) ==
              3 * static_cast<WideVolume>(2 * 400'000LL * 300'000LL) * geometry::to_lattice(pane.thickness_mm));
}

// How many faces that stand each segment of the map has beside it.
std::vector<int> standing_beside(const FacedPane& faced, const std::vector<bool>& stands) {
  std::vector<int> beside(faced.segments.size(), 0);
  for (std::size_t i = 0; i < faced.faces.size(); ++i) {
    const auto note = [&](const geometry::FaceRing& ring) {
      for (const geometry::FaceSide& side : ring) beside[side.segment] += stands[i] ? 1 : 0;
    };
    note(faced.faces[i].face.outline);
    std::ranges::for_each(faced.faces[i].face.holes, note);
  }
  return beside;
}

double nearest_mm(vec2 point, const std::vector<geometry::Segment>& segments) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const geometry::Segment& segment : segments) {
    nearest = std::min(nearest, geometry::distance_to_segment(point, geometry::to_mm(segment.a), geometry::to_mm(segment.b)));
  }
  return nearest;
}

// Cracks between faces that stand, the borders along which glass has left, and the edge of the pane. Borders are cracks that
// a standing face has on one side only, and the hole, along which faces are broken.
struct Kinds {
  std::vector<geometry::Region> hole;
  std::vector<geometry::Segment> inner;
  std::vector<geometry::Segment> left;
  std::vector<geometry::Segment> edge;
};

void append_border(const geometry::Polygon& ring, std::vector<geometry::Segment>& segments) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    segments.push_back({geometry::to_lattice(ring[i]), geometry::to_lattice(ring[(i + 1) % ring.size()]), -2});
}

Kinds kinds_of(const FacedPane& faced, const std::vector<bool>& stands, std::vector<geometry::Region> hole) {
  const std::vector<int> beside = standing_beside(faced, stands);
  Kinds kinds;
  kinds.hole = std::move(hole);
  for (const geometry::Region& one : kinds.hole) {
    append_border(one.outline, kinds.left);
    for (const geometry::Polygon& ring : one.holes) append_border(ring, kinds.left);
  }
  for (std::size_t i = 0; i < beside.size(); ++i) {
    if (faced.segments[i].owner == pane_edge) {
      kinds.edge.push_back(faced.segments[i]);
    } else if (beside[i] > 0) {
      (beside[i] == 2 ? kinds.inner : kinds.left).push_back(faced.segments[i]);
    }
  }
  return kinds;
}

// The middles of inner cracks, away from all else that has walls.
std::vector<vec2> inner_middles(const Kinds& kinds, double clear_mm) {
  std::vector<vec2> middles;
  for (const geometry::Segment& segment : kinds.inner) {
    const vec2 middle = 0.5 * (geometry::to_mm(segment.a) + geometry::to_mm(segment.b));
    const auto holds = [&](const geometry::Region& hole) { return geometry::contains(hole, middle); };
    if (std::ranges::any_of(kinds.hole, holds)) continue;
    if (std::min(nearest_mm(middle, kinds.left), nearest_mm(middle, kinds.edge)) > clear_mm) middles.push_back(middle);
  }
  return middles;
}

// How many of the points have a wall or a bevel of something that stands within `reach_mm`.
std::size_t walled(const std::vector<vec2>& points, const std::vector<Shard>& shards, double reach_mm) {
  std::vector<bool> has_wall(points.size(), false);
  for (const Shard& shard : shards) {
    if (shard.state != ShardState::standing) continue;
    for (const geometry::SolidTriangle& triangle : shard.solid.triangles) {
      if (triangle.slot != static_cast<int>(ShardSurface::broken)) continue;
      std::array<vec2, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        const geometry::LatticePoint3& vertex = shard.solid.vertices[triangle.corners[i]];
        p[i] = geometry::to_mm({vertex.x, vertex.y});
      }
      for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (geometry::distance_to_segment(points[i], p[k], p[(k + 1) % 3]) <= reach_mm) has_wall[i] = true;
        }
      }
    }
  }
  return static_cast<std::size_t>(std::ranges::count(has_wall, true));
}

// The wrong twin: without joining, all these places have walls.
TEST(JoinedShards, HaveNoWallsAlongCracksWithin) {
  constexpr double clear_mm = 2.5;  // chips reach less far
  const CrackNetwork network = broken(cracked_window(true), 7);
  const FacedPane faced = faced_pane(cracked_window(true), network);
  const std::vector<Shard> joined = shards(cracked_window(true), network, 7);
  const std::vector<geometry::Region> hole = hole_outlines(cracked_window(true), network, 7);
  ASSERT_FALSE(hole.empty());
  const std::vector<vec2> middles = inner_middles(kinds_of(faced, standing(faced, joined), hole), clear_mm);
  ASSERT_GT(middles.size(), 200U);
  EXPECT_EQ(walled(middles, joined, 0.1), 0U);
  EXPECT_EQ(walled(middles, shards(cracked_window(false), network, 7), 0.1), middles.size());
}

// Along the hole and cracks from which a neighbour has left, bevel and chips are those of the pieces: their corners are there,
// but for rounding.
TEST(JoinedShards, KeepTheEdgesOfTheirPieces) {
  const CrackNetwork network = broken(cracked_window(true), 7);
  const FacedPane faced = faced_pane(cracked_window(true), network);
  const std::vector<Shard> joined = shards(cracked_window(true), network, 7);
  const Kinds kinds = kinds_of(faced, standing(faced, joined), hole_outlines(cracked_window(true), network, 7));
  std::vector<geometry::LatticePoint3> corners;
  for (const Shard& shard : joined) std::ranges::copy(shard.solid.vertices, std::back_inserter(corners));
  const auto is_there = [&](const geometry::LatticePoint3& p) {
    return std::ranges::any_of(corners, [&](const geometry::LatticePoint3& q) {
      return p.z == q.z && std::abs(p.x - q.x) <= 3 && std::abs(p.y - q.y) <= 3;
    });
  };
  std::size_t count = 0;
  std::size_t missing = 0;
  for (const Shard& shard : shards(cracked_window(false), network, 7)) {
    if (shard.state != ShardState::standing) continue;
    for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
      const vec2 at = geometry::to_mm({vertex.x, vertex.y});
      if (nearest_mm(at, kinds.left) > 1.3 || nearest_mm(at, kinds.inner) < 2.5 || nearest_mm(at, kinds.edge) < 2.5) continue;
      ++count;
      if (!is_there(vertex)) ++missing;
    }
  }
  EXPECT_GT(count, 300U);
  EXPECT_LE(missing, count / 100);
}

// Where glass ends at a hole, it is bevelled and chipped on both sides of the pane, as it is along its outline.
TEST(JoinedShards, AreBevelledAboutHoles) {
  const Pane pane = cracked_window(true);
  std::size_t corners = 0;
  std::size_t chipped = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const Shard& shard : shards(pane, broken(pane, seed), seed)) {
      if (shard.joined.empty()) continue;
      std::map<geometry::LatticePoint, std::set<std::int64_t>> levels;
      for (const geometry::LatticePoint3& vertex : shard.solid.vertices) levels[{vertex.x, vertex.y}].insert(vertex.z);
      for (const geometry::Polygon& hole : shard.face.holes) {
        for (const vec2 corner : hole) {
          EXPECT_EQ(levels[geometry::to_lattice(corner)], (std::set<std::int64_t>{120, 2880}));
          ++corners;
        }
        for (const auto& [at, heights] : levels) {
          double away = std::numeric_limits<double>::infinity();
          for (std::size_t i = 0; i < hole.size(); ++i) {
            away = std::min(away, geometry::distance_to_segment(geometry::to_mm(at), hole[i], hole[(i + 1) % hole.size()]));
          }
          if (away > 0.3 && away < 1.3 && !heights.contains(120)) ++chipped;
        }
      }
    }
  }
  EXPECT_GT(corners, 100U);
  EXPECT_GT(chipped, 50U);
}

// Dust between them, cracks that end at slanting edges, holes that touch: whatever the pane, bodies are sound.
TEST(JoinedShards, OfOddPanesAreClosed) {
  std::size_t bodies = 0;
  std::size_t holes = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Pane pane = random_pane(seed, {2, 20});
    pane.thickness_mm = 0.5 + static_cast<double>(seed % 7);
    pane.shards = ShardRules{};
    pane.shards->fallen = 0.0;
    pane.shards->missing_mm = 20.0;
    pane.shards->splinter_mm2 = seed % 2 == 0 ? 0.01 : 4.0;
    pane.shards->joined = true;
    for (const Shard& shard : shards(pane, broken(pane, seed), seed)) {
      EXPECT_TRUE(is_closed(shard.solid)) << "pane " << seed << ' ' << shard.id;
      EXPECT_TRUE(sextuple_volume(shard.solid) > 0) << "pane " << seed << ' ' << shard.id;
      if (shard.joined.empty()) continue;
      ++bodies;
      holes += shard.face.holes.size();
    }
  }
  EXPECT_GT(bodies, 30U);
  EXPECT_GT(holes, 15U);
}

TEST(JoinedShards, AreTheSameForAnyNumberOfThreads) {
  const Pane pane = cracked_window(true);
  const CrackNetwork network = broken(pane, 9);
  std::vector<Shard> once;
  {
    const ThreadLimit limit(1);
    once = shards(pane, network, 9);
  }
  const ThreadLimit limit(7);
  EXPECT_TRUE(shards(pane, network, 9) == once);
}

}  // namespace
}  // namespace shatterpave::glass
