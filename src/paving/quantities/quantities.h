// What is to be ordered for a pavement that is laid, and what there is to do.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

struct Tally {
  std::size_t count = 0;
  double area_mm2 = 0.0;  // of faces
};

// The stones of one part.
struct PartQuantities {
  StonePart part = StonePart::field;
  Tally whole{};
  Tally cut{};
  vec2 stock_mm{0.0, 0.0};        // face of the stock stone that they are cut from; it is a rectangle, or what one holds
  double stock_area_mm2 = 0.0;    // of its face
  std::size_t order = 0;          // stock stones, where each cut stone takes one of its own
  std::size_t order_reusing = 0;  // where what is left of one serves again (cutting_plan.h)
};

struct Quantities {
  double paved_mm2 = 0.0;             // of the area, joints and all
  std::vector<PartQuantities> parts;  // those that have stones, ordered as StonePart
  double joint_mm2 = 0.0;             // of the area what no stone covers
  double joint_mm = 0.0;              // length of the joints between stones: not of those along outline and holes
  // For each stone of the layout: the number of its stock stone in its part, from 0 on, where offcuts serve again.
  std::vector<std::size_t> stock_of_stone;
};

// Offcuts serve again where whole stones are rectangles of one size, which may be turned by a quarter; elsewhere
// `order_reusing` is `order`.
Quantities quantities(const Pavement& pavement, const StoneLayout& layout);

// How far a stone reaches along its rows and across them.
vec2 stone_size_mm(const Stone& stone);

}  // namespace shatterpave::paving
