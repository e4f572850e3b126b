// Laminated glass as two sheets with networks of their own.
#include "glass/sheets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "geometry/predicates.h"
#include "glass/breaking.h"
#include "glass/gaps/crack_surface.h"
#include "glass/map/growth_clock.h"
#include "glass/network_oracle.h"
#include "support/triangles.h"

namespace shatterpave::glass {
namespace {

Pane windscreen(double far_cracks = 0.6) {
  Pane pane;
  pane.name = "windscreen";
  pane.outline_mm = {{0, 0}, {300, 0}, {300, 240}, {0, 240}};
  pane.thickness_mm = 5.0;
  Laminated glass;
  glass.far_cracks = far_cracks;
  pane.glass = glass;
  pane.pattern = Pattern::real;
  pane.rings = laminated_rings;
  Impact impact;
  impact.at_mm = {140, 110};
  impact.radial_count = 40;
  impact.large_count = 10;
  pane.impacts = {impact};
  return pane;
}

// How often cracks of one sheet cross those of the other.
int crossings_between(const CrackNetwork& near, const CrackNetwork& far) {
  CrackNetwork both = near;
  both.cracks.insert(both.cracks.end(), far.cracks.begin(), far.cracks.end());
  return crossings(both) - crossings(near) - crossings(far);
}

// With numbers from 0 on, as a network by itself.
CrackNetwork renumbered(CrackNetwork network) {
  if (network.cracks.empty()) return network;
  const int first = network.cracks.front().id;
  for (Crack& crack : network.cracks) {
    crack.id -= first;
    for (CrackEnd* end : {&crack.start, &crack.end}) {
      if (end->crack) *end->crack -= first;
    }
  }
  return network;
}

TEST(Sheets, ShareTheThicknessWithTheFilm) {
  Pane pane = windscreen();
  EXPECT_EQ(film_mm(pane), 0.76);
  EXPECT_EQ(sheet_of(pane, Ply::near), (Sheet{2.12, 1.44}));
  EXPECT_EQ(sheet_of(pane, Ply::far), (Sheet{2.12, -1.44}));
  pane.thickness_mm = 2.0;
  EXPECT_EQ(film_mm(pane), 0.5);
  std::get<Laminated>(pane.glass).film_mm = 1.0;
  EXPECT_EQ(sheet_of(pane, Ply::near), (Sheet{0.5, 0.75}));
  std::get<Laminated>(pane.glass).film_mm = 1.01;
  EXPECT_THROW(require_breakable(pane), InputError);
  pane.glass = Annealed{};
  EXPECT_EQ(sheet_of(pane, Ply::far), (Sheet{2.0, 0.0}));
}

TEST(Sheets, HaveNetworksOfTheirOwnThatCross) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Pane pane = windscreen();
    const CrackNetwork near = broken(pane, seed);
    const CrackNetwork far = broken_far_sheet(pane, near, seed);
    EXPECT_EQ(faults(near, pane.outline_mm), nothing) << seed;
    EXPECT_EQ(faults(renumbered(far), pane.outline_mm), nothing) << seed;
    EXPECT_EQ(far.impacts[0].radial_count, 24);
    EXPECT_EQ(far.impacts[0].large_count, 6);
    ASSERT_FALSE(far.cracks.empty());
    EXPECT_EQ(far.cracks.front().id, static_cast<int>(near.cracks.size()));
    EXPECT_GT(crossings_between(near, far), 40) << seed;
    for (const CrackNetwork* network : {&near, &far}) {
      for (const Crack& crack : network->cracks) EXPECT_FALSE(crack.through) << crack.id;
    }
    // Its share of cracks alone tells how many there are.
    EXPECT_EQ(broken_far_sheet(windscreen(0.25), near, seed).impacts[0].radial_count, 10);
  }
}

TEST(Sheets, AreOneOfOtherGlassAndOfPanesWithShards) {
  Pane whole_far = windscreen(0.0);
  Pane annealed = windscreen();
  annealed.glass = Annealed{};
  Pane with_shards = windscreen();
  with_shards.shards = ShardRules{};
  for (const Pane& pane : {whole_far, annealed, with_shards}) {
    EXPECT_TRUE(broken_far_sheet(pane, broken(pane, 3), 3).cracks.empty());
  }
}

TEST(Sheets, BreakAlikeAtAnyTime) {
  Pane pane = windscreen();
  const CrackNetwork whole = broken_far_sheet(pane, broken(pane, 5), 5);
  pane.time_us = 40.0;
  const CrackNetwork timed = broken_far_sheet(pane, broken(pane, 5), 5);
  const CrackNetwork now = network_at(pane, timed, 40.0);
  EXPECT_LT(now.cracks.size(), whole.cracks.size());
  for (const Crack& crack : now.cracks) {
    const std::vector<vec2>& points = whole.crack(crack.id).points_mm;
    ASSERT_LE(crack.points_mm.size(), points.size());
    const std::size_t kept = crack.points_mm.size() - (crack.rest ? 1 : 0);
    for (std::size_t i = 0; i < kept; ++i) EXPECT_EQ(crack.points_mm[i], points[i]);
  }
}

std::vector<support::Triangle> triangles_of(const std::vector<CrackSurface>& surfaces) {
  std::vector<support::Triangle> result;
  for (std::size_t body = 0; body < surfaces.size(); ++body) {
    const CrackSurface& surface = surfaces[body];
    const std::size_t half = surface.left_mm.size();
    const auto vertex = [&](std::size_t number) {
      return number < half ? surface.left_mm[number] : surface.right_mm[number - half];
    };
    const std::vector<std::size_t> corners = closed_triangles(surface);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      result.push_back({{vertex(corners[i]), vertex(corners[i + 1]), vertex(corners[i + 2])}, body});
    }
  }
  return result;
}

// No two gaps of the pane meet: not of one sheet, nor of two, between which the film lies.
TEST(Sheets, GapsStayWithinTheirSheetAndMeetNoOther) {
  const Pane pane = windscreen();
  for (const std::uint64_t seed : {2ULL, 9ULL}) {
    const CrackNetwork near = broken(pane, seed);
    const CrackNetwork far = broken_far_sheet(pane, near, seed);
    CrackSurfaces gaps = crack_surfaces(pane, near, seed);
    const std::vector<CrackSurface> of_far = far_surfaces(pane, near, far, seed);
    ASSERT_GT(of_far.size(), 20U);
    const auto expect_in = [&](const std::vector<CrackSurface>& surfaces, Ply ply) {
      const Sheet sheet = sheet_of(pane, ply);
      double highest = -1e300;
      double lowest = 1e300;
      for (const CrackSurface& surface : surfaces) {
        for (const std::vector<vec3>* wall : {&surface.left_mm, &surface.right_mm}) {
          for (const vec3& p : *wall) {
            highest = std::max(highest, p.z);
            lowest = std::min(lowest, p.z);
            EXPECT_TRUE(geometry::contains(pane.outline_mm, {p.x, p.y}));
          }
        }
      }
      EXPECT_NEAR(highest, sheet.middle_mm + 0.5 * sheet.thickness_mm - 0.01, 0.001);
      EXPECT_NEAR(lowest, sheet.middle_mm - 0.5 * sheet.thickness_mm + 0.01, 0.001);
    };
    expect_in(gaps.surfaces, Ply::near);
    expect_in(of_far, Ply::far);
    for (const CrackSurface& surface : of_far) {
      for (const vec3& p : surface.left_mm) {
        EXPECT_GT(glm::length(vec2{p.x, p.y} - gaps.zones[0].centre_mm), gaps.zones[0].radius_mm - 0.0015);
      }
    }
    gaps.surfaces.insert(gaps.surfaces.end(), of_far.begin(), of_far.end());
    EXPECT_EQ(support::meeting_pairs(triangles_of(gaps.surfaces)), 0U) << seed;
    // The twin: the far sheet's gaps in the near one.
    std::vector<CrackSurface> moved = gaps.surfaces;
    for (CrackSurface& surface : moved) {
      if (surface.crack < far.cracks.front().id) continue;
      for (std::vector<vec3>* wall : {&surface.left_mm, &surface.right_mm}) {
        for (vec3& p : *wall) p.z += 2.88;
      }
    }
    EXPECT_GT(support::meeting_pairs(triangles_of(moved)), 100U);
  }
}

}  // namespace
}  // namespace shatterpave::glass
