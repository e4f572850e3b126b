#include "glass/growth/printed_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "glass/breaking.h"
#include "glass/network_oracle.h"
#include "glass/random_panes.h"

namespace shatterpave::glass {
namespace {

// A pane by the printed law, hit once, with radials but no rings.
Pane printed_pane(int radial_count, vec2 at_mm = {150.0, 150.0}) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}};
  pane.growth.law = GrowthLaw::printed;
  Impact impact;
  impact.at_mm = at_mm;
  impact.radial_count = radial_count;
  pane.impacts = {impact};
  return pane;
}

std::ptrdiff_t ended(const CrackNetwork& network, CrackKind kind, CrackEnd::At at) {
  return std::ranges::count_if(network.cracks, [&](const Crack& c) { return c.kind == kind && c.end.at == at; });
}

TEST(PrintedLaw, GivesSoundNetworksInEveryRegion) {
  for (const LocalRegion region : {LocalRegion::sector, LocalRegion::rectangle, LocalRegion::circle}) {
    Pane hook = printed_pane(90);
    hook.outline_mm = {{0.0, 0.0}, {400.0, 0.0}, {400.0, 120.0}, {130.0, 120.0}, {130.0, 300.0}, {0.0, 300.0}};
    hook.impacts.push_back(hook.impacts[0]);
    hook.impacts[0].at_mm = {60.0, 60.0};
    hook.impacts[1].at_mm = {300.0, 60.0};
    Pane corner = printed_pane(113, {3.0, 2.0});
    for (Pane pane : {printed_pane(113), printed_pane(1), hook, corner, printed_pane(500)}) {
      pane.growth.region = region;
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const CrackNetwork network = broken(pane, seed);
        EXPECT_EQ(faults(network, pane.outline_mm), std::vector<std::string>{});
        EXPECT_EQ(network, broken(pane, seed));
      }
    }
  }
}

TEST(PrintedLaw, GivesSoundNetworksOfOddPanes) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Pane pane = random_pane(seed, {});
    pane.growth.law = GrowthLaw::printed;
    pane.growth.region = static_cast<LocalRegion>(seed % 3);
    // No more steps from side to side than the test has time for.
    const geometry::Box box = geometry::bounding_box(pane.outline_mm);
    const double most_steps = 200.0;
    pane.growth.time_step =
        std::max(1.0, glm::length(box.high - box.low) / (most_steps * px_mm * least_printed_step_px(pane.growth)));
    EXPECT_EQ(faults(broken(pane, seed), pane.outline_mm), std::vector<std::string>{}) << seed;
  }
}

// Without forces every tip goes straight on by V dt a step (eq. 17), all at one beat.
TEST(PrintedLaw, StepsAreOfOneTime) {
  Pane pane = printed_pane(24);
  Growth& growth = pane.growth;
  growth.spread_limit = 0.0;
  growth.tip_gain = growth.crack_gain = growth.edge_gain = 0.0;
  growth.wander = Angle();
  growth.time_step = 0.5;
  for (const Crack& crack : broken(pane, 3).cracks) {
    const double step_mm = 0.5 * px_mm * (crack.kind == CrackKind::large ? 40.0 : 10.0);
    for (std::size_t i = 1; i + 1 < crack.points_mm.size(); ++i) {
      EXPECT_NEAR(glm::length(crack.points_mm[i] - crack.points_mm[i - 1]), step_mm, 0.002);
    }
  }
}

// --- The equations, written down a second time: every pair of tips, and places along every crack ----------------------------

struct Walker {
  std::vector<vec2> points;
  vec2 v;  // of a step
};

bool sees(LocalRegion region, vec2 apex, vec2 heading, vec2 p) {
  const vec2 offset = (p - apex) / px_mm;
  const double ahead = glm::dot(heading, offset);
  const double left = cross(heading, offset);
  switch (region) {
    case LocalRegion::rectangle:
      return ahead >= 0.0 && ahead <= 50.0 && std::abs(left) <= 38.5;
    case LocalRegion::circle:
      return glm::length(offset) <= 50.0;
    case LocalRegion::sector:
      break;
  }
  return glm::length(offset) <= 50.0 && std::abs(std::atan2(left, ahead)) <= 50.0 * pi / 180.0;
}

// F2 of one polyline: at right angles to it where it is nearest, found among places along it.
vec2 pull_of_line(const std::vector<vec2>& line, bool closed, LocalRegion region, vec2 apex, vec2 heading, double gain) {
  double least_px = HUGE_VAL;
  vec2 towards{0.0, 0.0};
  for (std::size_t i = closed ? 0 : 1; i < line.size(); ++i) {
    const vec2 a = line[i == 0 ? line.size() - 1 : i - 1];
    const vec2 b = line[i];
    constexpr double fineness_mm = 0.03;
    const int parts = static_cast<int>(glm::length(b - a) / fineness_mm) + 1;
    for (int k = 0; k <= parts; ++k) {
      const vec2 p = glm::mix(a, b, static_cast<double>(k) / parts);
      const double distance_px = glm::length(p - apex) / px_mm;
      if (distance_px >= least_px || !sees(region, apex, heading, p)) continue;
      least_px = distance_px;
      const vec2 across = glm::normalize(left_of(b - a));
      towards = glm::dot(across, p - apex) < 0.0 ? -across : across;
    }
  }
  return least_px < HUGE_VAL ? gain / (least_px * least_px) * towards : vec2{0.0, 0.0};
}

vec2 force_on(std::size_t number, const std::vector<Walker>& walkers, const Pane& pane) {
  const Growth& growth = pane.growth;
  const vec2 apex = walkers[number].points.back();
  const vec2 heading = glm::normalize(walkers[number].v);
  vec2 force = heading;  // F3, where nothing wanders
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    if (i == number) continue;
    const vec2 offset = (walkers[i].points.back() - apex) / px_mm;
    const double distance = glm::length(offset);
    if (sees(growth.region, apex, heading, walkers[i].points.back())) {
      force -= growth.tip_gain / (distance * distance) * (offset / distance);
    }
    force += pull_of_line(walkers[i].points, false, growth.region, apex, heading, growth.crack_gain);
  }
  return force + pull_of_line(pane.outline_mm, true, growth.region, apex, heading, growth.edge_gain);
}

// Where tips come to be in `steps` steps, from their directions; `at_once`: all turn before any goes on.
std::vector<Walker> walked(const Pane& pane, std::vector<Walker> walkers, int steps, bool at_once) {
  for (int step = 0; step < steps; ++step) {
    std::vector<vec2> turned(walkers.size());
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      vec2 v = walkers[i].v;
      if (step > 0) {
        const vec2 force = force_on(i, walkers, pane);
        const double turn = std::atan2(cross(v, force), glm::dot(v, force));
        const double limit = pane.growth.turn_limit.radians();
        const double angle = std::clamp(turn, -limit, limit) * (1.0 - std::exp(-step / pane.growth.weight_time));
        v = rotated(v, Angle::radians(angle));
      }
      turned[i] = v;
      if (at_once) continue;
      walkers[i].v = v;
      walkers[i].points.push_back(walkers[i].points.back() + v);
    }
    for (std::size_t i = 0; at_once && i < walkers.size(); ++i) {
      walkers[i].v = turned[i];
      walkers[i].points.push_back(walkers[i].points.back() + turned[i]);
    }
  }
  return walkers;
}

// The greatest distance, mm, of a place of the walk from the vertices of its crack. Others that end on that crack add vertices.
double greatest_difference(const CrackNetwork& network, const std::vector<Walker>& walkers) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    for (const vec2 place : walkers[i].points) {
      double least = HUGE_VAL;
      for (const vec2 vertex : network.cracks[i].points_mm) least = std::min(least, glm::length(vertex - place));
      greatest = std::max(greatest, least);
    }
  }
  return greatest;
}

TEST(PrintedLaw, IsThatOfTheEquations) {
  constexpr int steps = 3;  // until the first of them meet
  for (const LocalRegion region : {LocalRegion::sector, LocalRegion::rectangle, LocalRegion::circle}) {
    Pane pane = printed_pane(21, {130.0, 38.0});
    pane.growth.region = region;
    pane.growth.spread_limit = 0.0;
    pane.growth.wander = Angle();
    pane.growth.weight_time = 3.0;
    pane.growth.large_speed = 25.0;
    // So weak that neither of the others is drowned.
    pane.growth.crack_gain = 4.0;
    pane.impacts[0].large_count = 3;
    const CrackNetwork network = broken(pane, 11);
    ASSERT_EQ(network.cracks.size(), 21U);
    std::vector<Walker> walkers;
    for (const Crack& crack : network.cracks) {
      // From the direction in which it started.
      const vec2 start = crack.points_mm[0];
      const double step_mm = px_mm * (crack.kind == CrackKind::large ? 25.0 : 10.0);
      walkers.push_back({{start}, step_mm * glm::normalize(crack.points_mm[1] - start)});
    }
    // The lattice turns the start of a crack by up to 0.2 mrad.
    EXPECT_LT(greatest_difference(network, walked(pane, walkers, steps, true)), 0.05) << static_cast<int>(region);
    // Twins: tips that go on one after the other; another region; F1 of the other sign; eq. 19 left out.
    EXPECT_GT(greatest_difference(network, walked(pane, walkers, steps, false)), 0.1) << static_cast<int>(region);
    const auto twin = [&](auto change) {
      Pane other = pane;
      change(other.growth);
      return greatest_difference(network, walked(other, walkers, steps, true));
    };
    EXPECT_GT(twin([](Growth& g) { g.region = g.region == LocalRegion::circle ? LocalRegion::sector : LocalRegion::circle; }),
              0.1);
    EXPECT_GT(twin([](Growth& g) { g.tip_gain = -g.tip_gain; }), 0.1);
    EXPECT_GT(twin([](Growth& g) { g.crack_gain = 0.0; }), 0.1);
    EXPECT_GT(twin([](Growth& g) { g.edge_gain = 0.0; }), 0.1);
    EXPECT_GT(twin([](Growth& g) { g.weight_time = 0.01; }), 0.1);
  }
}

// By the letter the second stop rule holds for ring cracks, too; ours spares them.
TEST(PrintedLaw, StopsRingCracksInClosedRegionsToo) {
  std::ptrdiff_t rings = 0;
  std::ptrdiff_t tips = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Pane pane = printed_pane(160);
    const CrackNetwork printed = broken(pane, seed);
    rings += ended(printed, CrackKind::circular, CrackEnd::At::enclosed);
    tips += ended(printed, CrackKind::radial, CrackEnd::At::enclosed);
    pane.growth.enclosed_tips_stop = false;
    EXPECT_EQ(ended(broken(pane, seed), CrackKind::radial, CrackEnd::At::enclosed), 0);
    pane.growth = Growth{};
    EXPECT_EQ(ended(broken(pane, seed), CrackKind::circular, CrackEnd::At::enclosed), 0);
  }
  EXPECT_GT(rings, 0);
  EXPECT_GT(tips, 30);
}

TEST(PrintedLaw, RefusesStepsThatAreTooShort) {
  Pane pane = printed_pane(10);
  pane.growth.time_step = 1e-5;
  EXPECT_THROW(broken(pane, 1), InputError);
  // Which is nothing to our law, nor to pattern "real".
  pane.growth.law = GrowthLaw::fitted;
  EXPECT_NO_THROW(broken(pane, 1));
  pane.pattern = Pattern::real;
  const CrackNetwork fitted = broken(pane, 1);
  pane.growth.law = GrowthLaw::printed;
  EXPECT_EQ(broken(pane, 1), fitted);
}

}  // namespace
}  // namespace shatterpave::glass
