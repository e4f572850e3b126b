#include "glass/breaking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/error.h"

#include "glass/network_oracle.h"
#include "glass/presets.h"

namespace shatterpave::glass {
namespace {

Pane square_pane(int radial_count, double side_mm = 300.0) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {side_mm, 0.0}, {side_mm, side_mm}, {0.0, side_mm}};
  Impact impact;
  impact.at_mm = {0.5 * side_mm, 0.5 * side_mm};
  impact.radial_count = radial_count;
  pane.impacts = {impact};
  return pane;
}

Impact impact_at(vec2 at_mm, int radial_count) {
  Impact impact;
  impact.at_mm = at_mm;
  impact.radial_count = radial_count;
  return impact;
}

std::ptrdiff_t count_of(const CrackNetwork& network, CrackKind kind) {
  return std::ranges::count(network.cracks, kind, &Crack::kind);
}

TEST(Growth, EveryPresetGivesASoundNetworkOfItsCounts) {
  for (const Preset& preset : presets()) {
    Pane pane = square_pane(preset.radial_count);
    pane.growth = preset.growth;
    pane.impacts[0].large_count = preset.large_count;
    pane.impacts[0].circular_count = preset.circular_count;
    const CrackNetwork network = broken(pane, 7);
    EXPECT_EQ(faults(network, pane.outline_mm), std::vector<std::string>{}) << preset.name;
    EXPECT_EQ(count_of(network, CrackKind::large), preset.large_count) << preset.name;
    EXPECT_EQ(count_of(network, CrackKind::radial), preset.radial_count - preset.large_count) << preset.name;
    EXPECT_EQ(count_of(network, CrackKind::circular), 2 * preset.circular_count) << preset.name;
  }
}

TEST(Growth, NetworksOfOddPanesAreSound) {
  Pane corner = square_pane(113);
  corner.impacts = {impact_at({3.0, 2.0}, 113), impact_at({299.99, 150.0}, 60)};
  Pane hook = square_pane(90);
  hook.outline_mm = {{0.0, 0.0}, {400.0, 0.0}, {400.0, 120.0}, {130.0, 120.0}, {130.0, 300.0}, {0.0, 300.0}};
  hook.impacts = {impact_at({60.0, 60.0}, 140), impact_at({300.0, 60.0}, 80), impact_at({60.0, 60.0}, 50)};
  for (const Pane& pane : {corner, hook, square_pane(113, 50.0), square_pane(80, 5000.0), square_pane(1)}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      EXPECT_EQ(faults(broken(pane, seed), pane.outline_mm), std::vector<std::string>{});
    }
  }
}

TEST(Growth, ThousandsOfRadialsStaySound) {
  const Pane pane = square_pane(3000);
  const CrackNetwork network = broken(pane, 5);
  EXPECT_EQ(network.cracks.size(), 3000U);
  EXPECT_EQ(faults(network, pane.outline_mm), std::vector<std::string>{});
}

TEST(Growth, IsAFunctionOfPaneAndSeed) {
  const Pane pane = square_pane(105);
  const CrackNetwork network = broken(pane, 7);
  EXPECT_EQ(network, broken(pane, 7));
  EXPECT_NE(network, broken(pane, 8));
  Pane renamed = pane;
  renamed.name = "door";
  EXPECT_NE(network, broken(renamed, 7));
  // A second impact leaves the first one's cracks where they were, but for the vertices in which its own end on them.
  Pane twice = pane;
  twice.impacts.push_back(impact_at({60.0, 70.0}, 40));
  const CrackNetwork both = broken(twice, 7);
  for (const Crack& crack : network.cracks) {
    const std::vector<vec2>& longer = both.cracks[static_cast<std::size_t>(crack.id)].points_mm;
    EXPECT_TRUE(std::ranges::all_of(crack.points_mm, [&](vec2 p) { return std::ranges::find(longer, p) != longer.end(); }));
  }
}

TEST(Growth, LaterCracksStopAtEarlierOnes) {
  Pane pane = square_pane(60);
  pane.impacts = {impact_at({100.0, 150.0}, 60), impact_at({200.0, 150.0}, 60)};
  const CrackNetwork network = broken(pane, 3);
  int later_on_earlier = 0;
  for (const Crack& crack : network.cracks) {
    if (!crack.end.crack) continue;
    const Crack& other = network.cracks[static_cast<std::size_t>(*crack.end.crack)];
    EXPECT_GE(crack.impact, other.impact);
    if (crack.impact > other.impact) ++later_on_earlier;
  }
  EXPECT_GE(later_on_earlier, 2);
}

TEST(Growth, RefusesWhatCannotBe) {
  Pane pane = square_pane(10);
  for (const vec2 at : {vec2{-1.0, 5.0}, vec2{0.0, 5.0}, vec2{300.0, 300.0}}) {
    pane.impacts[0].at_mm = at;
    EXPECT_THROW(broken(pane, 1), InputError);
  }
  pane.impacts[0].at_mm = {0.001, 5.0};
  EXPECT_EQ(faults(broken(pane, 1), pane.outline_mm), std::vector<std::string>{});
  pane.growth.step_length = 1e-6;
  EXPECT_THROW(broken(pane, 1), InputError);
}

// Which cells of a raster of the pane can be reached from its edge without crossing a crack.
class Reach {
 public:
  Reach(const CrackNetwork& network, double side_mm) : count_(static_cast<int>(side_mm / cell_mm)) {
    cells_.assign(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_), Cell::free);
    for (const Crack& crack : network.cracks) {
      for (std::size_t i = 1; i < crack.points_mm.size(); ++i) block(crack.points_mm[i - 1], crack.points_mm[i]);
    }
    std::vector<std::pair<int, int>> open;
    for (int k = 0; k < count_; ++k) {
      for (const auto& [x, y] : {std::pair{k, 0}, std::pair{k, count_ - 1}, std::pair{0, k}, std::pair{count_ - 1, k}})
        enter(x, y, open);
    }
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      enter(x + 1, y, open);
      enter(x - 1, y, open);
      enter(x, y + 1, open);
      enter(x, y - 1, open);
    }
  }
  bool reached(vec2 p) const {
    return cells_[place(static_cast<int>(p.x / cell_mm), static_cast<int>(p.y / cell_mm))] == Cell::reached;
  }

 private:
  static constexpr double cell_mm = 0.1;
  enum class Cell : char { free, blocked, reached };

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(x);
  }
  void enter(int x, int y, std::vector<std::pair<int, int>>& open) {
    if (x < 0 || y < 0 || x >= count_ || y >= count_ || cells_[place(x, y)] != Cell::free) return;
    cells_[place(x, y)] = Cell::reached;
    open.emplace_back(x, y);
  }
  // Steps much finer than a cell: no way of four neighbours leads through.
  void block(vec2 a, vec2 b) {
    const int steps = static_cast<int>(glm::length(b - a) / (0.05 * cell_mm)) + 1;
    for (int i = 0; i <= steps; ++i) {
      const vec2 p = glm::mix(a, b, static_cast<double>(i) / steps);
      const auto index = [this](double x) { return std::clamp(static_cast<int>(x / cell_mm), 0, count_ - 1); };
      cells_[place(index(p.x), index(p.y))] = Cell::blocked;
    }
  }

  int count_;
  std::vector<Cell> cells_;
};

// §4.2.3 (2), against a flood from the edge: in front of a tip that ended enclosed there is no way out, in front of one that
// could have grown on there is. (Some ways out are narrower than a cell, and
// some borders nearer than the place that is looked at.)
TEST(Growth, TipsStopWhereCracksCloseARegionAndNowhereElse) {
  int enclosed = 0;
  int open = 0;
  int open_without_way = 0;
  int enclosed_with_way = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const CrackNetwork network = broken(square_pane(113), seed);
    const Reach reach(network, 300.0);
    for (const Crack& crack : network.cracks) {
      const vec2 tip = crack.points_mm.back();
      const vec2 ahead = tip + 0.25 * glm::normalize(tip - crack.points_mm[crack.points_mm.size() - 2]);
      if (crack.end.at == CrackEnd::At::enclosed) {
        ++enclosed;
        if (reach.reached(ahead)) ++enclosed_with_way;
      } else if (crack.end.at == CrackEnd::At::open) {
        ++open;
        if (!reach.reached(ahead)) ++open_without_way;
      }
    }
  }
  EXPECT_GT(enclosed, 40);
  EXPECT_GT(open, 40);
  EXPECT_LE(open_without_way, open / 20);
  EXPECT_LE(enclosed_with_way, enclosed / 20);
}

}  // namespace
}  // namespace shatterpave::glass
