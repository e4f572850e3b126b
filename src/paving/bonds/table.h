// The table of bonds, the rules by which stones are laid. All that the program asks of a bond stands in its row, and each row
// in a file of its own, beside the code that lays the bond and the comment that says what `stone_mm` means to it. So nothing
// else compares one bond with another: it asks for what it needs to know.
//
// A new bond takes its value in `Bond` (paving/pavement.h), a file here with its row, its line in table.cpp, and what the
// measures hold its stones against (measure/stone_stock.cpp), which is told by itself. The key `bond`, the notes about keys
// without effect and docs/bonds.md follow from the row, and so do the tests and the random layouts of all bonds.
//
//    extern constinit const BondType stack_bond{.id = Bond::stack, .name = "stack", …};
//
// A row that leaves a member out does not compile (`Given`).
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "core/angle.h"
#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/tiles/pattern.h"
#include "paving/tiles/stock.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// A member without a default: whoever leaves it out of an initializer is stopped by the compiler.
template <typename T>
class Given {
 public:
  template <typename U>
  requires std::convertible_to<const U&, T>
  constexpr Given(const U& value) : value_(value) {}
  constexpr operator T() const { return value_; }

 private:
  T value_;
};

// How a bond follows rows that bend.
enum class Bending {
  straight,  // not at all: it lies straight, in the main direction (bond.h), and is cut at the border
  rows,      // row by row: rings with a whole number of stones each, or rows that keep their distance to a line
  packed     // stone by stone: square packing along the direction field (paving/packing)
};

// Where the seed decides how stones are laid, besides their variation.
enum class Drawing {
  never,
  where_bent,  // where the direction is not one and the same everywhere
  always
};

// What a bond asks of stone_mm.x / stone_mm.y.
struct ShapeLimits {
  double least = 0.0;
  double greatest = std::numeric_limits<double>::infinity();
  std::string_view expected;  // what is said to others: "expected stones … for this bond"
};
inline constexpr ShapeLimits any_shape{};
inline constexpr ShapeLimits not_wider_than_long{1.0, std::numeric_limits<double>::infinity(), "at least as long as wide"};

struct BondType {
  Given<Bond> id;

  // Words: of the key `bond`, and in English for pages.
  Given<std::string_view> name;         // as the scene file has it; of a bond that no scene may ask for, too
  Given<std::string_view> sentence;     // what it is
  Given<std::string_view> stone_words;  // what stone_mm = [a, b] means
  Given<std::string_view> stock_words;  // the largest stone, as `stock` has it

  // Traits.
  Given<bool> is_for_scenes;      // whether a scene may ask for it
  Given<Bending> bending;         //
  Given<Drawing> drawing;         //
  Given<ShapeLimits> shapes;      // others are refused
  Given<bool> takes_offset;       // whether rows move on by `Bonding::offset`
  Given<bool> takes_span;         // whether `Bonding::span_mm` is its width
  Given<bool> takes_module;       // whether its stones are those of `Bonding::module_drawn`, whatever their size
  Given<bool> has_square_stones;  // whether whole stones have four sides, along the axis that the bond asks for and across it
  Given<bool> has_stones_of_a_size;  // whether whole stones are alike in size
  Given<Angle> pattern_turn;         // from the rows to u of its pattern

  // The area that a stone takes with its joints, in the mean, mm².
  Given<double (*)(const Pavement&)> mean_area_mm2;
  // The face of a usual whole stone, mm²: what a small piece is measured by.
  Given<double (*)(const Pavement&)> whole_face_mm2;
  // The stock that its stones are cut from, along their axis and across it: none that is laid is larger, whole or cut.
  Given<Stock (*)(const Pavement&)> stock;
  // One period in one direction, u along the rows but for `pattern_turn`. nullptr where it never repeats.
  Given<Pattern (*)(const Pavement&)> pattern;
  // Its tiles over all of the area; they may reach beyond its border. nullptr where the packing lays it.
  Given<std::vector<Tile> (*)(const Pavement&, const geometry::RegionIndex& area, std::uint64_t seed)> tiles;
};

// In the order of `Bond`, one of each.
std::span<const BondType* const> bond_types();

const BondType& type_of(Bond bond);
inline const BondType& type_of(const Pavement& pavement) { return type_of(pavement.bonding.bond); }

// Of those that a scene may ask for and for which `is_so` holds.
std::vector<std::string_view> names_of_bonds(bool (*is_so)(const BondType&));

}  // namespace shatterpave::paving
