#include "paving/field/border_zones.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/angle.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

BorderZones zones_of(const geometry::Region& region, double least_run_mm = 400.0) {
  return border_zones(region, geometry::RegionIndex(region), least_run_mm);
}

double area_of(const std::vector<geometry::Region>& regions) {
  double sum = 0.0;
  for (const geometry::Region& region : regions) sum += geometry::area(region);
  return sum;
}

TEST(BorderZones, OfASquareAreItsFourQuarters) {
  const BorderZones zones = zones_of({{{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}}, {}});
  ASSERT_EQ(zones.areas.size(), 4U);
  for (const auto& areas : zones.areas) {
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_EQ(areas.front().outline.size(), 3U);
    EXPECT_EQ(geometry::area(areas.front()), 4e6);
    EXPECT_TRUE(std::ranges::find(areas.front().outline, vec2{2000, 2000}) != areas.front().outline.end());
  }
}

TEST(BorderZones, OfALongRectangleAreItsEndsAndTheRest) {
  const geometry::Region path{{{0, 0}, {4000, 0}, {4000, 1200}, {0, 1200}}, {}};
  const BorderZones zones = zones_of(path);
  ASSERT_EQ(zones.areas.size(), 3U);
  std::vector<double> sizes;
  for (const auto& areas : zones.areas) sizes.push_back(area_of(areas));
  std::ranges::sort(sizes);
  EXPECT_NEAR(sizes[0], 600.0 * 600.0, 1.0);
  EXPECT_NEAR(sizes[1], 600.0 * 600.0, 1.0);
  EXPECT_NEAR(sizes[2], 4000.0 * 1200.0 - 2.0 * 600.0 * 600.0, 1.0);
  // Short sides go with a neighbour.
  EXPECT_LT(zones_of(path, 1500.0).areas.size(), 3U);
}

TEST(BorderZones, GentleBendsAreOneZone) {
  EXPECT_EQ(zones_of({circle({0, 0}, 3000, 60), {}}).areas.size(), 1U);
  EXPECT_EQ(zones_of({circle({0, 0}, 3000, 8), {}}).areas.size(), 1U);
  EXPECT_EQ(zones_of({circle({0, 0}, 3000, 5), {}}).areas.size(), 5U);
}

// Each zone is what lies nearest to its sides, and together they are the region.
TEST(BorderZones, AreNearestToTheirSidesAndFillTheRegion) {
  const geometry::Region notched{
      {{0, 0}, {3000, 0}, {3000, 1000}, {2000, 1000}, {2000, 2000}, {3000, 2000}, {3000, 4000}, {0, 4000}}, {}};
  for (const geometry::Region& region : {path_area(), concave_area(), quarter_annulus(), notched}) {
    const geometry::RegionIndex border(region);
    const BorderZones zones = border_zones(region, border, 400.0);
    ASSERT_EQ(zones.of_segment.size(), border.segments().size());
    EXPECT_GT(zones.areas.size(), 1U);
    double sum = 0.0;
    for (const auto& areas : zones.areas) sum += area_of(areas);
    EXPECT_NEAR(sum, geometry::area(region), 1e-6 * geometry::area(region));
    int inside = 0;
    const geometry::Box box = border.box();
    for (int i = 0; i < 400; ++i) {
      const int column = i % 20;
      const int row = i / 20;
      const vec2 at = box.low + vec2{(column + 0.37) / 20.0, (row + 0.61) / 20.0} * (box.high - box.low);
      if (!border.contains(at)) continue;
      const std::uint32_t nearest = zones.of_segment[border.nearest(at).segment];
      for (std::uint32_t z = 0; z < zones.areas.size(); ++z) {
        const bool within = std::ranges::any_of(zones.areas[z], [&](const auto& part) { return geometry::contains(part, at); });
        if (within != (z == nearest)) {
          // Only where two zones are as near: within a millimetre of the mitre, or nearest to a corner inwards.
          const vec2 corner = border.nearest(at).point;
          const bool at_corner = std::ranges::any_of(border.segments(), [&](const auto& s) { return s.from == corner; });
          EXPECT_TRUE(at_corner) << at.x << ", " << at.y << " in zone " << z << ", nearest to " << nearest;
        }
      }
      ++inside;
    }
    EXPECT_GT(inside, 150);
  }
}

TEST(BorderZones, SidesThatTouchOutsideTheirEndsAreLeftInOneZone) {
  const geometry::Region touching{{{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}}, {{{2000, 0}, {1500, 1000}, {2500, 1000}}}};
  EXPECT_EQ(zones_of(touching).areas.size(), 1U);
}

}  // namespace
}  // namespace shatterpave::paving
