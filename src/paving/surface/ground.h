// Ground that has sunk here and there: a smooth field of hollows.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

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

// Fall of the ground, as rise per mm along x and y.
vec2 fall(const Ground& ground);

// The side of squares that are small enough to draw sunken ground with: twelve to a hollow, but no more than 400 along a side
// of the pavement. By eye: on hollows of 20 mm no edge shows.
double ground_square_mm(const Pavement& pavement);

// How high water stands in the low spots: over a part of the stones, of which these are the heights of the middles of their
// faces, fall and level of the ground left out. Above a wetness of one half; over a third of them where it is 1.
std::optional<double> water_level_mm(const Look& look, std::vector<double> faces_mm);

}  // namespace shatterpave::paving
