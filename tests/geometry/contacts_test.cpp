#include "geometry/contacts.h"

#include <gtest/gtest.h>

namespace shatterpave::geometry {
namespace {

const Polygon frame = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(Contacts, RingsApartHaveNone) {
  EXPECT_TRUE(contacts({frame, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{5, 5}, {5, 6}, {6, 6}}}).empty());
}

TEST(Contacts, OfVerticesSidesAndCrossings) {
  EXPECT_EQ(contacts({frame, {{10, 5}, {8, 4}, {8, 6}}}).front(), vec2(10, 5));                 // a vertex on a side
  EXPECT_EQ(contacts({frame, {{0, 0}, {1, 2}, {2, 1}}}).front(), vec2(0, 0));                   // two vertices
  EXPECT_EQ(contacts({frame, {{9, 5}, {11, 5}, {10, 12}}}).front(), vec2(10, 5));               // sides that cross
  EXPECT_EQ(contacts({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}).front(), vec2(2, 2));  // a ring with itself
  EXPECT_EQ(contacts({{{0, 0}, {4, 0}, {4, 4}, {4, 2}}}).front(), vec2(4, 2));                  // a ring that doubles back
}

TEST(Contacts, PartedRegionsHaveNone) {
  const Region touching{frame, {{{10, 5}, {8, 4}, {8, 6}}, {{8, 6}, {5, 6}, {5, 8}}}};
  ASSERT_GE(contacts(rings_of({touching})).size(), 2U);
  const std::vector<Region> apart = parted({touching});
  EXPECT_TRUE(contacts(rings_of(apart)).empty());
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_NEAR(area(apart.front()), area(touching), 0.005);  // sides of 5 mm turned by 1 µm
  EXPECT_EQ(parted({{frame, {}}}).front(), (Region{frame, {}}));
}

}  // namespace
}  // namespace shatterpave::geometry
