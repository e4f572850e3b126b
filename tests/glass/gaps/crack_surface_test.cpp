#include "glass/gaps/crack_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "core/parallel.h"
#include "geometry/polygon.h"
#include "geometry/segment_distance.h"
#include "glass/breaking.h"
#include "glass/gaps/gap_meetings.h"
#include "glass/map/growth_clock.h"
#include "glass/random_panes.h"
#include "support/triangles.h"

namespace shatterpave::glass {
namespace {

using support::Triangle;

Pane pane_with(int radial_count) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {300, 0}, {300, 300}, {0, 300}};
  pane.thickness_mm = 4.0;
  Impact impact;
  impact.at_mm = {150, 150};
  impact.radial_count = radial_count;
  pane.impacts = {impact};
  pane.crack_body = CrackBody::sheet;
  return pane;
}

vec3 vertex(const CrackSurface& surface, std::size_t number) {
  const std::size_t half = surface.left_mm.size();
  return number < half ? surface.left_mm[number] : surface.right_mm[number - half];
}

std::vector<Triangle> triangles_of(const CrackSurfaces& cracks) {
  std::vector<Triangle> result;
  for (std::size_t body = 0; body < cracks.surfaces.size(); ++body) {
    const CrackSurface& surface = cracks.surfaces[body];
    const std::vector<std::size_t> corners = closed_triangles(surface);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      result.push_back({{vertex(surface, corners[i]), vertex(surface, corners[i + 1]), vertex(surface, corners[i + 2])}, body});
    }
  }
  return result;
}

void expect_in_place(const Pane& pane, const CrackSurfaces& cracks) {
  const double face = 0.5 * pane.thickness_mm - crack_skin_mm + 0.0006;
  std::size_t outside = 0;
  for (const CrackSurface& surface : cracks.surfaces) {
    for (std::size_t i = 0; i < 2 * surface.left_mm.size(); ++i) {
      const vec3 point = vertex(surface, i);
      const vec2 plan{point.x, point.y};
      const bool in_zone = std::ranges::any_of(
          cracks.zones, [&](const ImpactZone& zone) { return glm::length(plan - zone.centre_mm) < zone.radius_mm - 0.0015; });
      if (in_zone || std::abs(point.z) > face || !geometry::contains(pane.outline_mm, plan)) ++outside;
    }
  }
  EXPECT_EQ(outside, 0U);
}

class CrackSurfacesOf : public testing::TestWithParam<int> {};

TEST_P(CrackSurfacesOf, NoTwoTrianglesMeetAndAllLieWithin) {
  const Pane pane = pane_with(GetParam());
  const CrackSurfaces cracks = crack_surfaces(pane, broken(pane, 7), 7);
  EXPECT_EQ(support::meeting_pairs(triangles_of(cracks)), 0U);
  // Those that end in the zone are not there.
  EXPECT_GE(cracks.surfaces.size(), static_cast<std::size_t>(0.8 * GetParam()));
  expect_in_place(pane, cracks);
}

INSTANTIATE_TEST_SUITE_P(Radials, CrackSurfacesOf, testing::Values(1, 2, 24, 113, 200));

// Leans and gaps far beyond what looks like glass: everything is at its limit.
TEST(CrackSurfacesExtreme, DoNotMeetAtTheLimitsOfTheKeys) {
  for (const double twist : {1.0, 8.0, 1000.0}) {
    Pane pane = pane_with(40);
    pane.outline_mm = {{100, 100}, {200, 100}, {200, 200}, {100, 200}};
    pane.crack_sheet = {Angle::degrees(70.0), Angle::degrees(70.0), twist, 10.0, 1.0, 0.05, 1.0, 1.0};
    const CrackSurfaces cracks = crack_surfaces(pane, broken(pane, 3), 3);
    EXPECT_EQ(support::meeting_pairs(triangles_of(cracks)), 0U) << twist;
    expect_in_place(pane, cracks);
  }
}

TEST(CrackSurfacesRandom, DoNotMeetInOddPanes) {
  int with_joints = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    Pane pane = random_pane(seed, {3, 20});
    pane.crack_body = CrackBody::sheet;
    const CrackNetwork network = broken(pane, seed);
    const CrackSurfaces cracks = crack_surfaces(pane, network, seed);
    EXPECT_EQ(support::meeting_pairs(triangles_of(cracks)), 0U) << seed;
    expect_in_place(pane, cracks);
    const auto joins = [](const Crack& crack) { return crack.end.at == CrackEnd::At::crack; };
    with_joints += std::ranges::any_of(network.cracks, joins) ? 1 : 0;
  }
  EXPECT_GE(with_joints, 12);
}

// Rings that end on radials which lean on others, where each is cut off before what another is cut off before: of 24 webs as
// these 12 and 19 had gaps that met.
TEST(CrackSurfacesReal, DoNotMeetInDenseWebs) {
  for (const std::uint64_t seed : {1ULL, 6ULL, 19ULL}) {
    for (const bool laminated : {false, true}) {
      Pane pane = pane_with(0);
      pane.outline_mm = {{0, 0}, {300, 0}, {300, 240}, {0, 240}};
      pane.pattern = Pattern::real;
      pane.impacts[0].at_mm = {140, 110};
      pane.impacts[0].radial_count.reset();
      pane.impacts[0].mean_radial_count = laminated ? 50 : 110;
      if (laminated) {
        pane.thickness_mm = 5.0;
        pane.glass = Laminated{};
        pane.rings = laminated_rings;
      }
      const CrackNetwork network = broken(pane, seed);
      const CrackSurfaces cracks = crack_surfaces(pane, network, seed);
      EXPECT_EQ(support::meeting_pairs(triangles_of(cracks)), 0U) << seed << laminated;
      EXPECT_GT(cracks.surfaces.size(), 30U);
    }
  }
}

// Of two that meet, it is the later that does.
TEST(CrackSurface, MeetsWhereItIsLaidAcrossOthers) {
  const Pane pane = pane_with(24);
  CrackSurfaces cracks = crack_surfaces(pane, broken(pane, 7), 7);
  EXPECT_TRUE(meeting_stretches(cracks.surfaces).empty());
  CrackSurface moved = cracks.surfaces.front();
  const vec3 middle = moved.left_mm[moved.columns() / 2 * moved.rows];
  for (std::vector<vec3>* wall : {&moved.left_mm, &moved.right_mm}) {
    // Turned by a right angle about its middle, across what it was.
    for (vec3& p : *wall) p = {middle.x - (p.y - middle.y), middle.y + (p.x - middle.x), p.z};
  }
  moved.crack = 1000;
  cracks.surfaces.push_back(moved);
  EXPECT_GT(support::meeting_pairs(triangles_of(cracks)), 0U);
  const std::vector<GapStretch> meeting = meeting_stretches(cracks.surfaces);
  EXPECT_FALSE(meeting.empty());
  EXPECT_LT(meeting.size(), moved.columns() / 2);
  for (const GapStretch& stretch : meeting) EXPECT_EQ(stretch.surface, cracks.surfaces.size() - 1);
}

// Of the real pattern, long after the impact.
Pane grown_pane(double mean_radial_count) {
  Pane pane = pane_with(0);
  pane.pattern = Pattern::real;
  pane.impacts[0].radial_count.reset();
  pane.impacts[0].mean_radial_count = mean_radial_count;
  pane.time_us = 1e6;
  return pane;
}

// What is left out is so at all times: a crack that has come to its end is what it will be.
TEST(CrackSurfacesReal, StayAsTheyAreOnceTheyHaveGrown) {
  Pane pane = grown_pane(110);
  const CrackNetwork network = broken(pane, 1);
  const CrackSurfaces whole = crack_surfaces(pane, network, 1);
  int seen = 0;
  for (const double time_us : {80.0, 130.0, 200.0}) {
    pane.time_us = time_us;
    const CrackNetwork now = network_at(pane, network, time_us);
    const CrackSurfaces cracks = crack_surfaces(pane, network, 1);
    for (const Crack& crack : now.cracks) {
      // Arms of rings are one gap, which is whole once both are.
      if (crack.rest || crack.start.at == CrackEnd::At::ring) continue;
      const auto of_crack = [&](const CrackSurfaces& all) {
        std::vector<CrackSurface> own;
        std::ranges::copy_if(all.surfaces, std::back_inserter(own), [&](const CrackSurface& s) { return s.crack == crack.id; });
        return own;
      };
      EXPECT_EQ(of_crack(cracks), of_crack(whole)) << crack.id;
      ++seen;
    }
  }
  EXPECT_GT(seen, 30);
}

// Nothing is open that has not broken yet: walls, which lean by less than the pane is thick, lie beside what has grown of their
// crack.
TEST(CrackSurfacesReal, EndAtTheTips) {
  Pane pane = grown_pane(40);
  const CrackNetwork network = broken(pane, 1);
  int growing = 0;
  for (const double time_us : {40.0, 80.0, 130.0}) {
    pane.time_us = time_us;
    const CrackNetwork now = network_at(pane, network, time_us);
    for (const CrackSurface& surface : crack_surfaces(pane, network, 1).surfaces) {
      // Arms of rings are one gap.
      if (network.crack(surface.crack).start.at == CrackEnd::At::ring) continue;
      const auto grown = std::ranges::find(now.cracks, surface.crack, &Crack::id);
      ASSERT_NE(grown, now.cracks.end()) << surface.crack << " has not begun";
      growing += grown->rest ? 1 : 0;
      double farthest = 0.0;
      for (std::size_t i = 0; i < 2 * surface.left_mm.size(); ++i) {
        const vec3 point = vertex(surface, i);
        double away = 1e9;
        for (std::size_t k = 0; k + 1 < grown->points_mm.size(); ++k) {
          away =
              std::min(away, geometry::distance_to_segment({point.x, point.y}, grown->points_mm[k], grown->points_mm[k + 1]));
        }
        farthest = std::max(farthest, away);
      }
      EXPECT_LT(farthest, pane.thickness_mm) << surface.crack << " at " << time_us;
    }
  }
  EXPECT_GT(growing, 20);
}

// Cracks that pass each other's tips and end on each other; one that runs close by a corner of the outline; and one that ends
// on another where that one bends just before its own end.
TEST(CrackSurfacesRandom, DoNotMeetWhereCracksHookOrEndAtBends) {
  for (const std::uint64_t seed : {20ULL, 126ULL, 232ULL}) {
    Pane pane = random_pane(seed, {3, 20});
    pane.crack_body = CrackBody::sheet;
    const CrackSurfaces cracks = crack_surfaces(pane, broken(pane, seed), seed);
    EXPECT_EQ(support::meeting_pairs(triangles_of(cracks)), 0U) << seed;
    EXPECT_FALSE(cracks.surfaces.empty());
  }
}

// The oracle finds what it looks for: a crack that is moved aside meets its neighbours; and it misses no pair of boxes.
TEST(CrackSurfacesTwin, AMovedCrackMeetsOthers) {
  const Pane pane = pane_with(24);
  CrackSurfaces cracks = crack_surfaces(pane, broken(pane, 7), 7);
  std::vector<Triangle> some = triangles_of(cracks);
  some.resize(std::min<std::size_t>(some.size(), 6000));
  const support::BoxPairs pairs = support::box_pairs(some);
  EXPECT_EQ(pairs.found, pairs.all);
  for (std::vector<vec3>* wall : {&cracks.surfaces[0].left_mm, &cracks.surfaces[0].right_mm}) {
    for (vec3& point : *wall) point += vec3{6.0, 6.0, 0.0};
  }
  EXPECT_GT(support::meeting_pairs(triangles_of(cracks)), 0U);
}

TEST(CrackSurface, IsClosedAndFacesOutward) {
  const Pane pane = pane_with(24);
  const CrackSurfaces cracks = crack_surfaces(pane, broken(pane, 7), 7);
  for (const CrackSurface& surface : cracks.surfaces) {
    const std::vector<std::size_t> corners = closed_triangles(surface);
    std::map<std::pair<std::size_t, std::size_t>, int> sides;
    double volume = 0.0;
    const vec3 origin = surface.left_mm.front();
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) ++sides[{corners[i + k], corners[i + (k + 1) % 3]}];
      volume += glm::dot(vertex(surface, corners[i]) - origin,
                         glm::cross(vertex(surface, corners[i + 1]) - origin, vertex(surface, corners[i + 2]) - origin));
    }
    for (const auto& [side, count] : sides) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(sides.contains({side.second, side.first}));
    }
    EXPECT_GT(volume, 0.0) << surface.crack;
  }
}

double gap_at(const CrackSurface& surface, std::size_t point) {
  return glm::length(surface.left_mm[point] - surface.right_mm[point]);
}

// The 3R rule: radial cracks open on the side away from the impact, ring cracks on the impact's.
TEST(CrackSurface, OpensOnTheSideOfItsKind) {
  const Pane pane = pane_with(113);
  const CrackNetwork network = broken(pane, 7);
  int rings = 0;
  for (const CrackSurface& surface : crack_surfaces(pane, network, 7).surfaces) {
    const bool ring = network.cracks[static_cast<std::size_t>(surface.crack)].kind == CrackKind::circular;
    rings += ring ? 1 : 0;
    const std::size_t middle = surface.columns() / 2 * surface.rows;
    EXPECT_EQ(surface.left_mm[middle].z > 0.0, ring);
    EXPECT_GE(gap_at(surface, middle), gap_at(surface, middle + surface.rows - 1) - 0.003);
  }
  EXPECT_GT(rings, 3);
}

// Cracks that stop within the glass are as deep as they are told to be; all others run through.
TEST(CrackSurface, StopsWithinTheThicknessWhereTheCrackStopsWithinTheGlass) {
  Pane pane = pane_with(24);
  pane.crack_sheet.least_depth = 0.3;
  pane.crack_sheet.greatest_depth = 0.5;
  const CrackNetwork network = broken(pane, 7);
  int within = 0;
  for (const CrackSurface& surface : crack_surfaces(pane, network, 7).surfaces) {
    const CrackEnd::At end = network.cracks[static_cast<std::size_t>(surface.crack)].end.at;
    const bool stops = end == CrackEnd::At::open || end == CrackEnd::At::enclosed;
    double deepest = 0.0;
    for (std::size_t c = 0; c < surface.columns(); ++c) {
      const double depth = surface.left_mm[c * surface.rows + surface.rows - 1].z - surface.left_mm[c * surface.rows].z;
      deepest = std::max(deepest, std::abs(depth) / (pane.thickness_mm - 2.0 * crack_skin_mm));
    }
    within += stops ? 1 : 0;
    EXPECT_LE(deepest, stops ? 0.501 : 1.001);
    EXPECT_GE(deepest, stops ? 0.1 : 0.999);
  }
  EXPECT_GE(within, 5);
}

// Hand-made: a crack across the pane, and one that ends on it. In every row the second comes as near to the first's wall as the
// clearance, and no farther off than a few of them.
TEST(CrackSurface, ClosesOntoTheCrackItEndsOn) {
  Pane pane = pane_with(1);
  CrackNetwork network;
  network.impacts = {{{250, 250}, 0, 0, 0}};
  network.cracks = {
      {0, 0, CrackKind::large, {{0, 100}, {150, 100}, {300, 100}}, {CrackEnd::At::edge, {}}, {CrackEnd::At::edge, {}}},
      {1, 0, CrackKind::large, {{140, 0}, {150, 100}}, {CrackEnd::At::edge, {}}, {CrackEnd::At::crack, 0}}};
  const CrackSurfaces cracks = crack_surfaces(pane, network, 5);
  ASSERT_EQ(cracks.surfaces.size(), 2U);
  const CrackSurface& through = cracks.surfaces[0];
  const CrackSurface& ending = cracks.surfaces[1];
  ASSERT_EQ(ending.crack, 1);
  for (std::size_t r = 0; r < ending.rows; ++r) {
    const vec3 tip = ending.left_mm[(ending.columns() - 1) * ending.rows + r];
    double wall = 0.0;  // y of the near wall of the other in the same row, at the tip
    for (std::size_t c = 0; c + 1 < through.columns(); ++c) {
      const vec3 a = through.right_mm[c * through.rows + r];
      const vec3 b = through.right_mm[(c + 1) * through.rows + r];
      if (a.x <= tip.x && tip.x <= b.x) wall = a.y + (tip.x - a.x) / (b.x - a.x) * (b.y - a.y);
    }
    EXPECT_GT(wall - tip.y, 0.02);
    EXPECT_LT(wall - tip.y, 0.4);
  }
  // And both run to the edge.
  EXPECT_LT(ending.left_mm.front().y, 0.4);
  EXPECT_LT(through.left_mm.front().x, 0.4);
  EXPECT_GT(through.left_mm.back().x, 299.6);
}

double length_along(const std::vector<vec2>& points) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += glm::length(points[i + 1] - points[i]);
  return length;
}

// Chips beside a crack must not cost it its room.
TEST(CrackSurface, KeepsTheLengthOfTheCracks) {
  for (const Pattern pattern : {Pattern::agui1992, Pattern::real}) {
    for (const std::uint64_t seed : {7U, 8U, 9U}) {
      Pane pane = pane_with(24);
      pane.pattern = pattern;
      const CrackNetwork network = broken(pane, seed);
      double of_cracks = 0.0;
      for (const Crack& crack : network.cracks) {
        if (crack.kind != CrackKind::chip) of_cracks += length_along(crack.points_mm);
      }
      double of_gaps = 0.0;
      for (const CrackSurface& surface : crack_surfaces(pane, network, seed).surfaces) {
        std::vector<vec2> points;
        for (std::size_t c = 0; c < surface.columns(); ++c) {
          const vec3 point = surface.left_mm[c * surface.rows + surface.rows / 2];
          points.emplace_back(point.x, point.y);
        }
        of_gaps += length_along(points);
      }
      EXPECT_GT(of_gaps, 0.9 * of_cracks) << seed;
      EXPECT_LT(of_gaps, 1.03 * of_cracks) << seed;
    }
  }
}

// Walls lean to both sides, as far as they may and no farther, and from column to column by little.
TEST(CrackSurface, LeansWithinItsLimitAndSmoothly) {
  const Pane pane = pane_with(4);
  const double limit = std::tan(pane.crack_sheet.tilt.radians());
  double least = 0.0;
  double most = 0.0;
  for (const CrackSurface& surface : crack_surfaces(pane, broken(pane, 7), 7).surfaces) {
    double before = 0.0;
    for (std::size_t c = 1; c + 1 < surface.columns(); ++c) {
      const vec3 top = surface.left_mm[c * surface.rows];
      const vec3 bottom = surface.left_mm[c * surface.rows + surface.rows - 1];
      const vec3 on = surface.left_mm[(c + 1) * surface.rows] - surface.left_mm[(c - 1) * surface.rows];
      const vec2 across = left_of(glm::normalize(vec2{on.x, on.y}));
      const double lean = glm::dot(vec2{top.x - bottom.x, top.y - bottom.y}, across) / (top.z - bottom.z);
      least = std::min(least, lean);
      most = std::max(most, lean);
      if (c > 1) {
        EXPECT_LT(std::abs(lean - before), 0.5 * limit);
      }
      before = lean;
    }
  }
  EXPECT_LT(most, limit * 1.05);
  EXPECT_GT(least, -limit * 1.05);
  EXPECT_GT(most, 0.4 * limit);
  EXPECT_LT(least, -0.4 * limit);
}

std::vector<Triangle> triangles_of(const ShotHole& shot_hole, std::size_t body) {
  std::vector<vec3> points = shot_hole.wall_mm;
  for (const vec3 middle : middles_mm(shot_hole)) points.push_back(middle);
  const std::vector<std::size_t> corners = closed_triangles(shot_hole);
  std::vector<Triangle> result;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    result.push_back({{points[corners[i]], points[corners[i + 1]], points[corners[i + 2]]}, body});
  }
  return result;
}

// A shot: cracks start at the wall of its hole at any depth, and the hole is closed, faces outward and is wider on the far
// side.
TEST(CrackSurface, AHoleWithoutRoomIsNone) {
  Pane pane = pane_with(24);
  pane.impacts[0].hole_mm = 0.01;
  EXPECT_TRUE(crack_surfaces(pane, broken(pane, 7), 7).shot_holes.empty());
  pane.impacts[0].hole_mm = 5.0;
  EXPECT_EQ(crack_surfaces(pane, broken(pane, 7), 7).shot_holes.size(), 1U);
  pane.impacts[0].at_mm = pane.outline_mm.front() + vec2{0.001, 0.001};
  EXPECT_TRUE(crack_surfaces(pane, broken(pane, 7), 7).shot_holes.empty());
}

TEST(CrackSurface, KeepClearOfTheShotHole) {
  Pane pane = pane_with(24);
  pane.impacts[0].hole_mm = 5.0;
  pane.impacts[0].spall_mm = 14.0;
  CrackSurfaces cracks = crack_surfaces(pane, broken(pane, 7), 7);
  ASSERT_EQ(cracks.shot_holes.size(), 1U);
  const ShotHole& shot_hole = cracks.shot_holes[0];
  std::vector<Triangle> all = triangles_of(cracks);
  const std::vector<Triangle> hole = triangles_of(shot_hole, cracks.surfaces.size());
  all.insert(all.end(), hole.begin(), hole.end());
  EXPECT_EQ(support::meeting_pairs(all), 0U);

  double volume = 0.0;
  const vec3 origin{shot_hole.shape.centre_mm, 0.0};
  for (const Triangle& triangle : hole) {
    const auto& [a, b, c] = triangle.corners;
    volume += glm::dot(a - origin, glm::cross(b - origin, c - origin)) / 6.0;
  }
  EXPECT_GT(volume, pane.thickness_mm * 3.14 * 2.5 * 2.5);
  EXPECT_LT(volume, pane.thickness_mm * 3.15 * 10.0 * 10.0);
  const auto radius = [&](std::size_t i) { return glm::length(vec2{shot_hole.wall_mm[i]} - shot_hole.shape.centre_mm); };
  for (std::size_t k = 0; k < shot_hole.points; ++k) {
    EXPECT_NEAR(radius(k), 2.5, 0.2);
    EXPECT_GT(radius((shot_hole.rings - 1) * shot_hole.points + k), 6.5);
  }
  double nearest = 1e9;
  for (const CrackSurface& surface : cracks.surfaces) {
    for (const vec3 point : surface.left_mm) nearest = std::min(nearest, glm::length(vec2{point} - shot_hole.shape.centre_mm));
  }
  EXPECT_LT(nearest, 3.6);
}

TEST(CrackSurfaceThreads, DoNotShow) {
  const Pane pane = pane_with(40);
  const CrackNetwork network = broken(pane, 7);
  const CrackSurfaces one = [&] {
    const ThreadLimit limit(1);
    return crack_surfaces(pane, network, 7);
  }();
  for (const int threads : {2, 7}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(crack_surfaces(pane, network, 7), one);
  }
  EXPECT_NE(crack_surfaces(pane, network, 8), one);
}

}  // namespace
}  // namespace shatterpave::glass
