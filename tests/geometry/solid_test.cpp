#include "geometry/solid.h"

#include <gtest/gtest.h>

#include <utility>

namespace shatterpave::geometry {
namespace {

Solid tetrahedron() {
  return {{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}}, {{{0, 2, 1}, 0}, {{0, 1, 3}, 0}, {{1, 2, 3}, 0}, {{2, 0, 3}, 0}}};
}

TEST(Solid, VolumeIsExactAndPositiveRightSideOut) {
  EXPECT_EQ(static_cast<std::int64_t>(sextuple_volume(tetrahedron())), 1000);
  Solid moved = tetrahedron();
  for (LatticePoint3& p : moved.vertices) p = {p.x + 1'000'000'007, p.y - 999'999'937, p.z + 12345};
  EXPECT_EQ(static_cast<std::int64_t>(sextuple_volume(moved)), 1000);
  for (SolidTriangle& triangle : moved.triangles) std::swap(triangle.corners[0], triangle.corners[1]);
  EXPECT_EQ(static_cast<std::int64_t>(sextuple_volume(moved)), -1000);
}

TEST(Solid, IsClosedOnlyIfEveryEdgeMeetsItsLike) {
  EXPECT_TRUE(is_closed(tetrahedron()));
  Solid open = tetrahedron();
  open.triangles.pop_back();
  EXPECT_FALSE(is_closed(open));
  Solid turned = tetrahedron();
  std::swap(turned.triangles[2].corners[0], turned.triangles[2].corners[1]);
  EXPECT_FALSE(is_closed(turned));
  Solid doubled = tetrahedron();
  doubled.triangles.push_back(doubled.triangles.front());
  EXPECT_FALSE(is_closed(doubled));
}

}  // namespace
}  // namespace shatterpave::geometry
