#include "core/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace shatterpave {
namespace {

TEST(Random, DrawDependsOnItsAddressOnly) {
  std::vector<double> forwards;
  for (std::uint32_t i = 0; i < 100; ++i) forwards.push_back(uniform(7, {Stream::turn, Id("pane"), i}));
  for (std::uint32_t i = 100; i-- > 0;) {
    static_cast<void>(uniform(7, {Stream::large_speed, Id("elsewhere"), i}));
    EXPECT_EQ(forwards[i], uniform(7, {Stream::turn, Id("pane"), i}));
  }
}

}  // namespace
}  // namespace shatterpave
