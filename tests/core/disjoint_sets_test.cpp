#include "core/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "core/smooth_step.h"

namespace shatterpave {
namespace {

TEST(DisjointSets, AreKnownByTheirLeastMemberWhateverTheOrder) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    constexpr std::size_t count = 60;
    DisjointSets sets(count);
    // By brute force: each number with the least of its set.
    std::vector<std::size_t> least(count);
    for (std::size_t i = 0; i < count; ++i) least[i] = i;
    for (std::uint32_t step = 0; step < 45; ++step) {
      const auto draw = [&](std::uint32_t which) {
        return static_cast<std::size_t>(count * uniform(seed, {Stream::packing, Id("sets"), 2 * step + which}));
      };
      const std::size_t a = draw(0);
      const std::size_t b = draw(1);
      sets.join(a, b);
      const auto [low, high] = std::minmax({least[a], least[b]});
      std::ranges::replace(least, high, low);
      const DisjointSets& seen = sets;
      for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(seen.of(i), least[i]) << seed << ", step " << step;
    }
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(sets.of(i), least[i]);
  }
}

TEST(SmoothStep, IsLevelAtItsEnds) {
  EXPECT_EQ(smooth_step(-3.0), 0.0);
  EXPECT_EQ(smooth_step(0.0), 0.0);
  EXPECT_EQ(smooth_step(0.5), 0.5);
  EXPECT_EQ(smooth_step(1.0), 1.0);
  EXPECT_EQ(smooth_step(7.0), 1.0);
  EXPECT_LT(smooth_step(1e-4), 1e-7);
  EXPECT_GT(smooth_step(1.0 - 1e-4), 1.0 - 1e-7);
}

}  // namespace
}  // namespace shatterpave
