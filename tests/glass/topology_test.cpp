// Topology is exact, whatever the pane, its impacts and its growth.
#include <gtest/gtest.h>

#include <map>

#include "glass/breaking.h"
#include "glass/network_oracle.h"
#include "glass/random_panes.h"

namespace shatterpave::glass {
namespace {

// Ends of cracks in the odd panes, by how they ended: each kind is to be there in numbers.
TEST(Topology, HoldsInOddPanes) {
  std::map<CrackEnd::At, int> ends;
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    const Pane pane = random_pane(seed, {});
    const CrackNetwork network = broken(pane, seed);
    EXPECT_EQ(faults(network, pane.outline_mm), nothing) << "pane " << seed;
    EXPECT_EQ(enclosure_faults(network), nothing) << "pane " << seed;
    for (const Crack& crack : network.cracks) ++ends[crack.end.at];
  }
  EXPECT_GT(ends[CrackEnd::At::edge], 3000);
  EXPECT_GT(ends[CrackEnd::At::crack], 3000);
  EXPECT_GT(ends[CrackEnd::At::enclosed], 500);
  EXPECT_GT(ends[CrackEnd::At::open], 500);
}

}  // namespace
}  // namespace shatterpave::glass
