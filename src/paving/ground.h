// Ground that has sunk here and there: a smooth field of hollows.
#pragma once

#include <cstdint>
#include <optional>

#include "paving/pavement.h"

namespace shatterpave::paving {

struct GroundPoint {
  double height_mm = 0.0;  // from −settlement_mm to 0
  vec2 slope{0.0, 0.0};    // rise per mm along x and y
};

// The settlement of the ground at `place`, without fall and level: value noise (lattice values drawn evenly, joined by quintic
// ease curves), so that heights and slopes are continuous. A function of the seed, the place and the ground alone. With a
// period in x and y it repeats: hollows are as much nearer or farther apart as a whole number of them needs.
GroundPoint settlement(const Ground& ground, std::uint64_t seed, vec2 place, std::optional<vec2> period_mm = {});

}  // namespace shatterpave::paving
