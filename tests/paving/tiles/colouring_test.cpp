#include "paving/tiles/colouring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "paving/laying.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

Pavement coloured() {
  Pavement paved = pavement(path_area(), 100, 8, straight(0));
  paved.look.colours.colours = {{0.8, 0.7, 0.6}, {0.3, 0.3, 0.3}, {0.6, 0.2, 0.1}};
  paved.look.colours.shares = {0.55, 0.383, 0.067};
  return paved;
}

std::vector<double> counts(const StoneLayout& layout) {
  std::vector<double> result(3);
  for (const Stone& stone : layout.stones) ++result.at(static_cast<std::size_t>(stone.colour));
  return result;
}

void expect_shares(const StoneLayout& layout, const Pavement& paved) {
  const std::vector<double> found = counts(layout);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k], paved.look.colours.shares[k] * static_cast<double>(layout.stones.size()), 2.0) << k;
  }
}

TEST(Colouring, SharesAreKept) {
  Pavement paved = coloured();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_shares(laid_stones(paved, seed), paved);
  paved.look.colours.gradient_mm = {{0, 0}, {4000, 0}};
  for (const double blur : {0.0, 0.3, 1.0}) {
    paved.look.colours.blur = blur;
    expect_shares(laid_stones(paved, 1), paved);
  }
  paved.look.colours.gradient_mm.reset();
  paved.look.colours.attractors_mm = {{1000, 600}, {3000, 200}};
  expect_shares(laid_stones(paved, 1), paved);
}

// In the left and the right half alike; a draw for each stone by itself, the twin, is off by more.
TEST(Colouring, MixesEvenly) {
  const Pavement paved = coloured();
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const StoneLayout layout = laid_stones(paved, seed);
    double half = 0.0;
    double dark = 0.0;
    for (const Stone& stone : layout.stones) {
      if (geometry::centroid(stone.outline_mm).x > 1000.0) continue;
      ++half;
      dark += stone.colour == 1 ? 1.0 : 0.0;
    }
    worst = std::max(worst, std::abs(dark - 0.383 * half) / std::sqrt(0.383 * 0.617 * half));
  }
  EXPECT_LT(worst, 1.5);  // of twenty free draws the worst is beyond that but once in 50 times
}

TEST(Colouring, FollowsAGradient) {
  Pavement paved = coloured();
  paved.look.colours.gradient_mm = {{0, 0}, {4000, 0}};
  paved.look.colours.blur = 0.0;
  double last_of_first = 0.0;
  double first_of_last = 1e9;
  for (const Stone& stone : laid_stones(paved, 1).stones) {
    const double x = geometry::centroid(stone.outline_mm).x;
    if (stone.colour == 0) last_of_first = std::max(last_of_first, x);
    if (stone.colour == 2) first_of_last = std::min(first_of_last, x);
  }
  EXPECT_LT(last_of_first, first_of_last);
}

TEST(Colouring, LeavesOthersAlone) {
  const Pavement plain = pavement(path_area(), 100, 8, straight(0));
  for (const Stone& stone : laid_stones(plain, 1).stones) EXPECT_EQ(stone.colour, -1);
}

}  // namespace
}  // namespace shatterpave::paving
