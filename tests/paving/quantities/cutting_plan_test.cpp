#include "paving/quantities/cutting_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace shatterpave::paving {
namespace {

struct Laid {
  vec2 low{0.0, 0.0};
  vec2 high{0.0, 0.0};
};

Laid laid(const Cut& cut, vec2 size) { return {cut.low, cut.low + (cut.turned ? vec2{size.y, size.x} : size)}; }

std::size_t stock_count(const std::vector<Cut>& cuts) {
  std::size_t count = 0;
  for (const Cut& cut : cuts) count = std::max(count, cut.stock + 1);
  return count;
}

// Within its stock stone, and a saw's width from every other one on it: the first fault in words.
std::string fault(const std::vector<Cut>& cuts, const std::vector<vec2>& sizes, vec2 stock) {
  constexpr double rounding = 0.02;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Laid a = laid(cuts[i], sizes[i]);
    if (a.low.x < 0.0 || a.low.y < 0.0 || a.high.x > stock.x + rounding || a.high.y > stock.y + rounding)
      return "beyond its stock";
    for (std::size_t k = 0; k < i; ++k) {
      if (cuts[k].stock != cuts[i].stock) continue;
      const Laid b = laid(cuts[k], sizes[k]);
      const double apart = std::max({b.low.x - a.high.x, a.low.x - b.high.x, b.low.y - a.high.y, a.low.y - b.high.y});
      if (apart < saw_mm - rounding) return "nearer than the saw is wide";
    }
  }
  return "";
}

TEST(CuttingPlan, HalvesShareAStoneWhereTheSawLeavesRoom) {
  const vec2 stock{200.0, 100.0};
  EXPECT_EQ(stock_count(cutting_plan({{98.0, 100.0}, {98.0, 100.0}}, stock)), 1U);
  EXPECT_EQ(stock_count(cutting_plan({{98.1, 100.0}, {98.0, 100.0}}, stock)), 2U);
  EXPECT_EQ(stock_count(cutting_plan({{200.0, 48.0}, {98.0, 48.0}, {98.0, 48.0}}, stock)), 1U);
  EXPECT_EQ(stock_count(cutting_plan({}, stock)), 0U);
}

TEST(CuttingPlan, AnOffcutServesTurned) {
  // Beside 150 × 100 there is a strip of 46 × 100, which holds 90 × 40 upright.
  const std::vector<vec2> sizes{{150.0, 100.0}, {90.0, 40.0}};
  const std::vector<Cut> cuts = cutting_plan(sizes, {200.0, 100.0});
  EXPECT_EQ(stock_count(cuts), 1U);
  EXPECT_TRUE(cuts[1].turned);
}

TEST(CuttingPlan, NoTwoLieWhereOneIs) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    const vec2 stock{60.0 + 300.0 * unit(), 60.0 + 200.0 * unit()};
    std::vector<vec2> sizes;
    double area = 0.0;
    for (int i = 0; i < 120; ++i) {
      sizes.push_back(stock * vec2{0.05 + 0.95 * unit(), 0.05 + 0.95 * unit()});
      area += sizes.back().x * sizes.back().y;
    }
    const std::vector<Cut> cuts = cutting_plan(sizes, stock);
    ASSERT_EQ(fault(cuts, sizes, stock), "") << seed;
    const std::size_t count = stock_count(cuts);
    EXPECT_GE(static_cast<double>(count), area / (stock.x * stock.y)) << seed;
    // Pieces of a quarter in the mean: half as many stock stones are far more than such plans take.
    EXPECT_LT(count, sizes.size() * 6 / 10) << seed;
    // The twin: one that is moved by half a saw is seen.
    std::vector<Cut> wrong = cuts;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      if (wrong[i].low.x > 0.0) {
        wrong[i].low.x -= 0.5 * saw_mm;
        break;
      }
    }
    EXPECT_NE(fault(wrong, sizes, stock), "") << seed;
  }
}

}  // namespace
}  // namespace shatterpave::paving
