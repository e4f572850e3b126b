#include "paving/seamless.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/lattice.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/table.h"

namespace shatterpave::paving {
namespace {

Pavement pavement_of(Bond bond, vec2 stone_mm, double angle_deg) {
  Pavement pavement;
  pavement.name = "tile";
  pavement.area.outline = {{0.0, 0.0}, {9000.0, 0.0}, {9000.0, 9000.0}, {0.0, 9000.0}};
  pavement.stone_mm = stone_mm;
  pavement.bonding.bond = bond;
  pavement.direction = ConstantDirection{Angle::degrees(angle_deg)};
  return pavement;
}

struct Case {
  Bond bond;
  vec2 stone_mm;
  double angle_deg;
};
const std::vector<Case> cases = {{Bond::packed, {100, 100}, 0},
                                 {Bond::packed, {100, 100}, 45},
                                 {Bond::packed, {120, 90}, 90},
                                 {Bond::running, {210, 100}, 0},
                                 {Bond::stack, {200, 100}, 0},
                                 {Bond::herringbone, {208, 100}, 0},
                                 {Bond::herringbone, {208, 100}, 45},
                                 {Bond::basket_weave, {208, 100}, 0},
                                 {Bond::hexagon, {150, 150}, 0},
                                 {Bond::segmental_arc, {90, 90}, 0},
                                 {Bond::fan, {90, 90}, 0},
                                 {Bond::chevron, {300, 90}, 0},
                                 {Bond::chevron, {300, 90}, 90},
                                 {Bond::drawn_module, {150, 90}, 0}};

std::string message_of(const Pavement& pavement) {
  try {
    seamless_tile(pavement, 7);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// The stones again at all whole multiples up to `times` to every side.
std::vector<Stone> repeated_stones(const SeamlessTile& tile, vec2 size_mm, int times) {
  std::vector<Stone> all;
  for (int j = -times; j <= times; ++j) {
    for (int i = -times; i <= times; ++i) {
      for (Stone stone : tile.layout.stones) {
        for (vec2& p : stone.outline_mm) p += size_mm * vec2{static_cast<double>(i), static_cast<double>(j)};
        all.push_back(stone);
      }
    }
  }
  return all;
}

// How many of many points of the tile, which are spread evenly but in no rows, lie in no stone, in one, and in more.
constexpr int points = 3600;
struct Cover {
  int none = 0;
  int one = 0;
  int more = 0;
};
Cover cover(const std::vector<Stone>& stones, vec2 size_mm) {
  Cover result;
  std::vector<geometry::Box> boxes;
  boxes.reserve(stones.size());
  for (const Stone& stone : stones) boxes.push_back(geometry::bounding_box(stone.outline_mm));
  for (int k = 0; k < points; ++k) {
    const vec2 at =
        geometry::on_lattice(size_mm * glm::fract(static_cast<double>(k) * vec2{0.75487766624669276, 0.56984029099805327}));
    int times = 0;
    for (std::size_t s = 0; s < stones.size(); ++s) {
      if (geometry::boxes_meet(boxes[s], {at, at}) && geometry::contains(stones[s].outline_mm, at)) ++times;
    }
    ++(times == 0 ? result.none : times == 1 ? result.one : result.more);
  }
  return result;
}

TEST(SeamlessTile, IsTriedOfEveryBondThatRepeats) {
  for (const BondType* type : bond_types()) {
    EXPECT_EQ(std::ranges::find(cases, Bond(type->id), &Case::bond) != cases.end(), type->pattern != nullptr)
        << std::string_view(type->name);
  }
}

TEST(SeamlessTile, PavesThePlane) {
  for (const auto& [bond, stone_mm, angle_deg] : cases) {
    const Pavement pavement = pavement_of(bond, stone_mm, angle_deg);
    const SeamlessTile tile = seamless_tile(pavement, 7);
    double area = 0.0;
    for (const Stone& stone : tile.layout.stones) area += geometry::area(stone.outline_mm);
    const auto label = testing::Message() << static_cast<int>(bond) << " at " << angle_deg;
    const Cover found = cover(repeated_stones(tile, tile.size_mm, 1), tile.size_mm);
    EXPECT_EQ(found.more, 0) << label;
    // Joints and nothing else between: what the stones leave of the tile is what points find free.
    const double free = 1.0 - area / (tile.size_mm.x * tile.size_mm.y);
    EXPECT_NEAR(static_cast<double>(found.none) / points, free, 0.02) << label;
    EXPECT_LT(free, 0.25) << label;

    // The twin: repeated after half a stone more or less, stones overlap or leave gaps.
    const Cover twin = cover(repeated_stones(tile, tile.size_mm - vec2{40.0, 0.0}, 1), tile.size_mm);
    EXPECT_GT(twin.more, 0) << label;
  }
}

TEST(SeamlessTile, HasTheAskedSizeWithStonesStretchedALittle) {
  Pavement pavement = pavement_of(Bond::running, {210, 100}, 0);
  pavement.textures.tile_mm = vec2{1760.0, 1300.0};  // 8 × 218 = 1744, 12 × 108 = 1296
  const SeamlessTile tile = seamless_tile(pavement, 7);
  EXPECT_EQ(tile.size_mm, (vec2{1760.0, 1300.0}));
  ASSERT_EQ(tile.layout.stones.size(), 96U);
  for (const Stone& stone : tile.layout.stones) {
    const geometry::Box box = geometry::bounding_box(stone.outline_mm);
    EXPECT_NEAR(box.high.x - box.low.x, 220.0 - 8.0, 0.003);
    EXPECT_NEAR(box.high.y - box.low.y, 1300.0 / 12.0 - 8.0, 0.003);
  }
}

TEST(SeamlessTile, WhatDoesNotRepeatIsRefused) {
  EXPECT_NE(message_of(pavement_of(Bond::crazy, {200, 200}, 0)).find("expected a bond that repeats"), std::string::npos);
  EXPECT_NE(message_of(pavement_of(Bond::ashlar, {200, 200}, 0)).find("expected a bond that repeats"), std::string::npos);
  Pavement radial = pavement_of(Bond::packed, {100, 100}, 0);
  radial.direction = RadialDirection{};
  EXPECT_NE(message_of(radial).find("rows in one direction"), std::string::npos);
  Pavement bordered = pavement_of(Bond::running, {200, 100}, 0);
  bordered.border.course = BorderCourse::soldier;
  EXPECT_NE(message_of(bordered).find("border_course"), std::string::npos);
}

TEST(SeamlessTile, AMessageNamesATileThatDoes) {
  Pavement pavement = pavement_of(Bond::running, {210, 100}, 0);
  pavement.textures.tile_mm = vec2{330.0, 300.0};
  const std::string message = message_of(pavement);
  EXPECT_NE(message.find("such as [436.000, 216.000]"), std::string::npos) << message;
  pavement.textures.tile_mm = vec2{436.0, 216.0};
  EXPECT_EQ(seamless_tile(pavement, 7).layout.stones.size(), 4U);
}

TEST(SeamlessTile, VariesAndMissesStonesAsThePavementDoes) {
  Pavement pavement = pavement_of(Bond::packed, {100, 100}, 0);
  const std::size_t all = seamless_tile(pavement, 7).layout.stones.size();
  pavement.variation.missing = 0.3;
  const std::size_t left = seamless_tile(pavement, 7).layout.stones.size();
  EXPECT_LT(left, all);
  EXPECT_GT(left, all / 2);
}

}  // namespace
}  // namespace shatterpave::paving
