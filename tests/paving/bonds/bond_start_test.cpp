// Where the pattern of a bond begins: `Bonding::start_mm`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/notes.h"
#include "geometry/polygon.h"
#include "paving/laying.h"
#include "paving/paved_areas.h"
#include "scene/read_scene.h"

namespace shatterpave::paving {
namespace {

const std::vector<Bond> repeating = {Bond::running, Bond::stack,         Bond::herringbone, Bond::basket_weave,
                                     Bond::hexagon, Bond::segmental_arc, Bond::fan};

Pavement begun(Bond bond, double degrees, std::optional<vec2> start_mm) {
  Pavement result = pavement({{{0, 0}, {3000, 0}, {3000, 2000}, {0, 2000}}, {}}, 100, 0.0, straight(degrees));
  result.stone_mm = bond == Bond::herringbone || bond == Bond::basket_weave ? vec2{200, 100} : vec2{100, 100};
  result.bonding.bond = bond;
  result.bonding.start_mm = start_mm;
  return result;
}

double nearest_corner(const StoneLayout& layout, vec2 point) {
  double nearest = 1e9;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    for (const vec2& corner : stone.outline_mm) nearest = std::min(nearest, glm::length(corner - point));
  }
  return nearest;
}

// Without joints stones meet in the point.
TEST(BondStart, IsTheCornerOfAWholeStone) {
  for (const Bond bond : repeating) {
    for (const double degrees : {0.0, 20.0, 90.0}) {
      for (const vec2 start : {vec2{1337, 951}, vec2{1600.25, 1203.5}}) {
        const StoneLayout layout = laid_stones(begun(bond, degrees, start), 1);
        // Stones that are laid without joints keep some 10 µm apart.
        EXPECT_LT(nearest_corner(layout, start), 0.02) << static_cast<int>(bond) << " at " << degrees;
      }
    }
  }
}

// By default it is elsewhere: the two points above are no corners by chance.
TEST(BondStart, MovesThePattern) {
  for (const Bond bond : repeating) {
    EXPECT_GT(nearest_corner(laid_stones(begun(bond, 20.0, std::nullopt), 1), {1337, 951}), 1.0) << static_cast<int>(bond);
  }
}

// Half a joint lies about it.
TEST(BondStart, IsTheMiddleOfTheJoint) {
  Pavement paved = begun(Bond::stack, 0.0, vec2{1337, 951});
  paved.joint_mm = 8.0;
  EXPECT_NEAR(nearest_corner(laid_stones(paved, 1), {1337, 951}), std::sqrt(32.0), 0.003);
  EXPECT_NEAR(nearest_corner(laid_stones(paved, 1), {1341, 955}), 0.0, 0.003);
}

// Rows begin in the corner of the area's box where nothing is said, so to say that changes nothing.
TEST(BondStart, IsTheLowerLeftCornerByDefault) {
  for (const Bond bond : {Bond::running, Bond::stack, Bond::basket_weave}) {
    EXPECT_EQ(laid_stones(begun(bond, 0.0, vec2{0, 0}), 1).stones, laid_stones(begun(bond, 0.0, std::nullopt), 1).stones);
  }
}

// A start that is a whole period farther, or far outside, is the same pattern. Ids follow the rows from the start, so that only
// the outlines are compared.
TEST(BondStart, MayLieAnywhere) {
  const auto outlines = [](vec2 start) {
    std::vector<std::pair<double, double>> middles;
    for (const Stone& stone : laid_stones(begun(Bond::stack, 0.0, start), 1).stones) {
      const vec2 middle = geometry::centroid(stone.outline_mm);
      middles.emplace_back(std::round(middle.x * 100), std::round(middle.y * 100));
    }
    std::ranges::sort(middles);
    return middles;
  };
  EXPECT_EQ(outlines({30, 40}), outlines({130, 240}));
  EXPECT_EQ(outlines({30, 40}), outlines({-9970, 50040}));
  EXPECT_NE(outlines({30, 40}), outlines({50, 40}));
}

std::vector<std::string> told(const std::string& lines) {
  const scene::Scene read =
      scene::scene_of_text("[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\nbond_start_mm = [450, 450]\n" + lines, "s.toml");
  std::vector<std::string> notes;
  for (const Note& note : read.notes) notes.push_back(note.place.key + ": " + note.what);
  return notes;
}

TEST(BondStart, IsReadAndToldWhereItHasNoEffect) {
  using Notes = std::vector<std::string>;
  EXPECT_EQ(told("bond = \"herringbone\"\nstone_mm = [200, 100]\n"), Notes());
  EXPECT_EQ(told("bond = \"running\"\n"), Notes());
  EXPECT_EQ(told("bond = \"fan\"\ndirection.kind = \"boundary\"\n"), Notes());
  const std::string none = "pavement[0].bond_start_mm: has no effect ";
  EXPECT_EQ(told(""), Notes({none + "beside bond = \"packed\""}));
  EXPECT_EQ(told("bond = \"crazy\"\n"), Notes({none + "on a bond that does not repeat"}));
  EXPECT_EQ(told("bond = \"running\"\ndirection.kind = \"radial\"\n"), Notes({none + "on rows that follow the direction"}));
  EXPECT_EQ(told("bond = \"stack\"\ndirection.kind = \"boundary\"\n"), Notes({none + "on rows that follow the direction"}));
  try {
    told("steps.tread_mm = 300\n");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "s.toml:4:17: pavement[0].bond_start_mm: expected no bond_start_mm beside steps, got one");
  }
}

// What is told to have no effect has none.
TEST(BondStart, HasNoEffectWhereThatIsTold) {
  const auto stones = [](Bond bond, Direction direction, std::optional<vec2> start) {
    Pavement paved = begun(bond, 0.0, start);
    paved.joint_mm = 8.0;
    paved.direction = std::move(direction);
    return laid_stones(paved, 1).stones;
  };
  const vec2 start{1337, 951};
  for (const Bond bond : {Bond::packed, Bond::ashlar, Bond::crazy}) {
    EXPECT_EQ(stones(bond, straight(0.0), start), stones(bond, straight(0.0), std::nullopt)) << static_cast<int>(bond);
  }
  EXPECT_EQ(stones(Bond::running, BoundaryDirection{}, start), stones(Bond::running, BoundaryDirection{}, std::nullopt));
  EXPECT_EQ(stones(Bond::stack, RadialDirection{}, start), stones(Bond::stack, RadialDirection{}, std::nullopt));
  // Other bonds cannot bend: they lie straight on a bent direction, and begin where they are told to.
  EXPECT_NE(stones(Bond::hexagon, BoundaryDirection{}, start), stones(Bond::hexagon, BoundaryDirection{}, std::nullopt));
}

}  // namespace
}  // namespace shatterpave::paving
