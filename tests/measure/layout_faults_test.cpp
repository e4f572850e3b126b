#include "measure/layout_faults.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "paving/layout_quality.h"
#include "paving/paved_areas.h"

namespace shatterpave::measure {
namespace {

using paving::Pavement;
using paving::StoneLayout;

paving::Stone stone(int id, geometry::Polygon outline) { return {id, paving::StoneKind::whole, std::move(outline), {}}; }

geometry::Polygon square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

LayoutFaults faults_of(const Pavement& pavement, const StoneLayout& layout) {
  return layout_faults(layout, StoneIndex(layout, 100.0), geometry::RegionIndex(pavement.area));
}

TEST(LayoutFaults, AreToldOneByOne) {
  const Pavement paved = paving::pavement(paving::path_area(), 100, 8, paving::ConstantDirection{});
  const auto of = [&](std::vector<paving::Stone> stones) { return faults_of(paved, {std::move(stones), {}}); };
  const paving::Stone one = stone(0, square(10, 10, 100));
  EXPECT_EQ(of({}), LayoutFaults{});
  EXPECT_EQ(of({one, stone(1, square(110.001, 10, 100))}), LayoutFaults{});
  EXPECT_EQ(of({one, stone(1, square(110, 10, 100))}), (LayoutFaults{0, 1, 0})) << "a side in common";
  EXPECT_EQ(of({one, stone(1, square(110, 110, 100))}), (LayoutFaults{0, 1, 0})) << "a corner in common";
  EXPECT_EQ(of({one, stone(1, square(40, 40, 10))}), (LayoutFaults{0, 1, 0})) << "one inside the other";
  EXPECT_EQ(of({one, one, one}), (LayoutFaults{0, 3, 0})) << "pairs are counted";
  EXPECT_EQ(of({stone(0, square(-0.001, 10, 100))}), (LayoutFaults{0, 0, 1})) << "beyond the outline";
  EXPECT_EQ(of({stone(0, square(510, 480, 30))}), (LayoutFaults{0, 0, 1})) << "a corner of the hole within";
  EXPECT_EQ(of({stone(0, square(600, 520, 20))}), (LayoutFaults{0, 0, 1})) << "within the hole";
  EXPECT_EQ(of({stone(0, {{10, 10}, {100, 10}, {10, 100}, {100, 100}})}), (LayoutFaults{1, 0, 0})) << "crosses itself";
  EXPECT_EQ(of({stone(0, {{10, 10}, {50, 10}, {100, 10}, {100, 100}})}), (LayoutFaults{1, 0, 0})) << "a corner too many";
  EXPECT_EQ(of({stone(0, {{10, 10}, {10, 100}, {100, 100}, {100, 10}})}), (LayoutFaults{1, 0, 0})) << "the wrong way round";
}

// Triangles and arrows, thrown at random: with few and small ones none meet, with many most do.
RC_GTEST_PROP(LayoutFaults, AreThoseOfBruteForce, ()) {
  const Pavement paved = paving::pavement(paving::concave_area(), 100, 8, paving::ConstantDirection{});
  const auto count = *rc::gen::inRange<std::size_t>(0, 40);
  const auto size = *rc::gen::inRange(20, 900);
  StoneLayout layout;
  for (std::size_t s = 0; s < count; ++s) {
    const auto at = [&](int low, int high) { return static_cast<double>(*rc::gen::inRange(low, high)); };
    const vec2 corner{at(-600, 5500), at(-100, 5400)};
    const vec2 a = corner + vec2{at(1, size), at(-size, size)};
    const vec2 b = corner + vec2{at(-size, size), at(1, size)};
    geometry::Polygon outline{corner, a, b};
    if (*rc::gen::arbitrary<bool>()) outline.push_back(corner + 0.125 * (a - corner) + 0.25 * (b - corner));
    layout.stones.push_back(stone(static_cast<int>(s), std::move(outline)));
  }
  const paving::LayoutFaults expected = paving::faults(paved, layout);
  RC_CLASSIFY(expected.overlaps > 0, "overlap");
  RC_CLASSIFY(expected.overlaps == 0 && expected.outside == 0 && count > 1, "plain");
  RC_ASSERT(faults_of(paved, layout) == (LayoutFaults{expected.invalid, expected.overlaps, expected.outside}));
}

}  // namespace
}  // namespace shatterpave::measure
