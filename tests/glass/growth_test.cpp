#include "glass/growth.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    const CrackNetwork network = grown_cracks(pane, 7);
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
      EXPECT_EQ(faults(grown_cracks(pane, seed), pane.outline_mm), std::vector<std::string>{});
    }
  }
}

}  // namespace
}  // namespace shatterpave::glass
