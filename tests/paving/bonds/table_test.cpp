// What holds for every row of the table of bonds; and docs/bonds.md, which is made from it.
#include "paving/bonds/table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <type_traits>

#include "core/error.h"
#include "measure/stone_stock.h"
#include "paving/bonds/bond.h"
#include "paving/laying.h"
#include "paving/paved_areas.h"
#include "support/places.h"

namespace shatterpave::paving {
namespace {

// A member that is left out would need one.
static_assert(!std::is_default_constructible_v<Given<bool>> && !std::is_default_constructible_v<Given<Bending>>);
static_assert(!std::is_default_constructible_v<BondType>);

Pavement paved_with(Bond bond, geometry::Region area, Direction direction) {
  Pavement result = pavement(std::move(area), 100, 8, std::move(direction));
  result.stone_mm = {160, 90};  // which every bond takes
  result.bonding.bond = bond;
  return result;
}

TEST(BondTable, HasARowForEachBondInOrder) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < bond_types().size(); ++i) {
    const BondType& type = *bond_types()[i];
    EXPECT_EQ(type.id, static_cast<Bond>(i));
    EXPECT_EQ(&type_of(static_cast<Bond>(i)), &type);
    EXPECT_TRUE(names.insert(type.name).second) << std::string_view(type.name);
    for (const std::string_view words : {type.name, type.sentence, type.stone_words, type.stock_words})
      EXPECT_FALSE(words.empty());
    EXPECT_EQ(type.tiles == nullptr, type.bending == Bending::packed) << std::string_view(type.name);
  }
  EXPECT_THROW(type_of(static_cast<Bond>(bond_types().size())), BrokenInvariant);
  EXPECT_THROW(type_of(static_cast<Bond>(-1)), BrokenInvariant);
}

// The largest stone that each bond states: none is larger, whole or cut.
TEST(BondTable, NoStoneIsLargerThanItsBondStates) {
  const GuidesDirection guides{{{{0, 0}, {2000, 900}, {4000, 200}}}};
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes) continue;
    for (const Direction& direction : {straight(0), straight(27), Direction(RadialDirection{{900, -700}}), Direction(guides)}) {
      const Pavement paved = paved_with(type->id, concave_area(), direction);
      const Stock most = stock(paved);
      measure::StockLimit limit{{most.size_mm}, most.area_mm2, 1.0};
      if (most.turned_size_mm != vec2{0.0, 0.0}) limit.faces_mm.push_back(most.turned_size_mm);
      std::size_t larger = 0;
      for (const Stone& stone : laid_stones(paved, 5).stones) {
        // At its best rotation: packed stones that were cut anew lie at any angle to their rows.
        const measure::StockShare share = measure::stock_share(stone.outline_mm, limit);
        if (std::max({share.length, share.width, share.area}) > 1.0005) ++larger;
      }
      EXPECT_EQ(larger, 0U) << std::string_view(type->name) << ", direction " << direction.index();
    }
  }
}

// And it is no larger than it has to be: of bonds that repeat, some whole stone is as long, some as wide and some as large.
TEST(BondTable, SomeStoneIsAsLargeAsItsBondStates) {
  for (const BondType* type : bond_types()) {
    if (type->pattern == nullptr) continue;
    const Pavement paved = paved_with(type->id, {{{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}}, {}}, straight(10));
    const Stock most = stock(paved);
    vec2 longest{0.0, 0.0};
    double largest = 0.0;
    for (const Stone& stone : laid_stones(paved, 5).stones) {
      if (stone.kind != StoneKind::whole) continue;
      longest = glm::max(longest, size_of(extent(stone.outline_mm, stone.angle.direction())));
      largest = std::max(largest, geometry::area(stone.outline_mm));
    }
    EXPECT_NEAR(longest.x, most.size_mm.x, 0.02) << std::string_view(type->name);
    EXPECT_NEAR(longest.y, most.size_mm.y, 0.02) << std::string_view(type->name);
    EXPECT_NEAR(largest / most.area_mm2, 1.0, 2e-4) << std::string_view(type->name);
  }
}

// The mean of a stone with its joints is about that by counting what fills a large square, cut stones and all.
TEST(BondTable, MeanAreasAreThoseThatAreLaid) {
  const double side = 6000.0;
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes) continue;
    const Pavement paved = paved_with(type->id, {{{0, 0}, {side, 0}, {side, side}, {0, side}}, {}}, straight(0));
    const double mean = side * side / static_cast<double>(laid_stones(paved, 5).stones.size());
    EXPECT_NEAR(mean / type->mean_area_mm2(paved), 1.0, 0.16) << std::string_view(type->name);
  }
}

// By the seed stones are laid elsewhere where the row says so, and nowhere else.
TEST(BondTable, SeedsShowWhereTheRowSaysSo) {
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes) continue;
    for (const Direction& direction : {straight(0), Direction(RadialDirection{{900, -700}})}) {
      const Pavement paved = paved_with(type->id, concave_area(), direction);
      EXPECT_EQ(laid_stones(paved, 5) != laid_stones(paved, 6), is_drawn(paved))
          << std::string_view(type->name) << ", direction " << direction.index();
    }
  }
}

TEST(BondTable, ShapesBeyondTheirLimitsAreRefused) {
  std::size_t limited = 0;
  for (const BondType* type : bond_types()) {
    const ShapeLimits shapes = type->shapes;
    for (const double ratio : {0.999 * shapes.least, 1.001 * shapes.greatest}) {
      if (!(ratio > 0.0 && ratio < 1e6)) continue;
      ++limited;
      Pavement paved = paved_with(type->id, path_area(), straight(0));
      paved.stone_mm = {100.0 * ratio, 100.0};
      try {
        require_layable(paved);
        ADD_FAILURE() << std::string_view(type->name) << " of ratio " << ratio;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(fmt::format("expected stones {} for this bond", shapes.expected)),
                  std::string::npos)
            << error.what();
      }
    }
  }
  EXPECT_GE(limited, 6U);
}

// ---- the page

std::string_view bending_words(Bending bending) {
  switch (bending) {
    case Bending::straight:
      return "lies straight";
    case Bending::rows:
      return "row by row";
    case Bending::packed:
      return "stone by stone";
  }
  return "";
}

std::string_view drawing_words(Drawing drawing) {
  switch (drawing) {
    case Drawing::never:
      return "–";
    case Drawing::where_bent:
      return "where rows bend";
    case Drawing::always:
      return "yes";
  }
  return "";
}

std::string_view shape_words(const ShapeLimits& shapes) { return shapes.expected.empty() ? "any" : shapes.expected; }

std::string keys_words(const BondType& type) {
  std::string keys;
  if (type.takes_offset) keys += "`bond_offset`";
  if (type.takes_span) keys += "`bond_span_mm`";
  if (type.takes_module) keys += "`module_file`, `module_mm` and [others](scene-file.md#modules)";
  return keys.empty() ? "–" : keys;
}

std::string page() {
  std::string text =
      "# Bonds\n"
      "The rules by which stones are laid: the choices of `bond` in a [scene file](scene-file.md#bonds). This page is made\n"
      "from the program's own table (`src/paving/bonds`); a test compares the two.\n\n"
      "| `bond` | what it is | `stone_mm = [a, b]` | shapes it takes | keys of its own |\n| --- | --- | --- | --- | --- |\n";
  std::string traits =
      "\nWhere the direction bends, patterns lie straight along the main direction. A bond that repeats makes\n"
      "[seamless textures](textures.md#seamless-tiles), where its rows do not bend. No stone, whole or cut, is longer, wider "
      "or\n"
      "larger than the largest that its bond states.\n\n"
      "| `bond` | where rows bend | repeats | drawn by the seed | largest stone |\n| --- | --- | --- | --- | --- |\n";
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes) continue;
    const std::string_view name = type->name;
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, std::string_view(type->sentence),
                        std::string_view(type->stone_words), shape_words(type->shapes), keys_words(*type));
    traits +=
        fmt::format("| `{}` | {} | {} | {} | {} |\n", name, bending_words(type->bending),
                    type->pattern == nullptr ? "–" : "yes", drawing_words(type->drawing), std::string_view(type->stock_words));
  }
  return text + traits;
}

TEST(BondTable, IsWhatItsPageSays) {
  const std::filesystem::path file = support::source_folder() / "docs/bonds.md";
  std::ostringstream found;
  found << std::ifstream(file).rdbuf();
  if (found.str() == page()) return;
  const std::string made = testing::TempDir() + "bonds.md";
  std::ofstream(made) << page();
  ADD_FAILURE() << "docs/bonds.md is not what the table says; cp " << made << " " << file.string();
}

}  // namespace
}  // namespace shatterpave::paving
