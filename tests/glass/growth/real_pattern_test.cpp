// Rings of pieces, branches, late radials, craters, and laminated glass.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glass/breaking.h"
#include "glass/network_oracle.h"
#include "glass/random_panes.h"
#include "support/laws.h"

namespace shatterpave::glass {
namespace {

Pane real_pane(int radial_count = 60) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {400.0, 0.0}, {400.0, 400.0}, {0.0, 400.0}};
  pane.pattern = Pattern::real;
  Impact& impact = pane.impacts.emplace_back();
  impact.at_mm = {200.0, 200.0};
  impact.radial_count = radial_count;
  return pane;
}

Pane branching_pane() {
  Pane pane = real_pane(40);
  pane.growth.branch_rate_per_m = 6.0;
  return pane;
}

bool is_ring(const Crack& crack) { return crack.kind == CrackKind::circular; }

double distance(vec2 p, vec2 a, vec2 b) {
  const double share = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::length(p - glm::mix(a, b, share));
}

// Whether a radial or a branch comes within 3 µm of the point.
bool on_radial(const CrackNetwork& network, vec2 p) {
  return std::ranges::any_of(network.cracks, [&](const Crack& crack) {
    if (is_ring(crack)) return false;
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      if (distance(p, crack.points_mm[i - 1], crack.points_mm[i]) < 0.003) return true;
    }
    return false;
  });
}

// The share of ring cracks that end on a radial, by where they are; all of them turned by `turn` about their impact.
double share_on_radials(const Pane& pane, int seeds, Angle turn) {
  int held = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
    const CrackNetwork network = broken(pane, seed);
    for (const Crack& crack : network.cracks) {
      if (!is_ring(crack)) continue;
      const vec2 impact = network.impacts[static_cast<std::size_t>(crack.impact)].at_mm;
      ++all;
      if (on_radial(network, impact + rotated(crack.points_mm.back() - impact, turn))) ++held;
    }
  }
  EXPECT_GT(all, 20 * seeds);
  return static_cast<double>(held) / all;
}

TEST(RealPattern, PiecesEndOnRadials) {
  EXPECT_GE(share_on_radials(real_pane(), 20, {}), 0.95);
  EXPECT_LT(share_on_radials(real_pane(), 2, Angle::degrees(0.2)), 0.95);
}

// The share of ends of pieces that lie within 0.2 mm of the end of another one.
double share_in_line(const Pane& pane) {
  int in_line = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::vector<vec2> ends;
    for (const Crack& crack : broken(pane, seed).cracks) {
      if (is_ring(crack)) ends.push_back(crack.points_mm.back());
    }
    for (const vec2& end : ends) {
      ++all;
      if (std::ranges::count_if(ends, [end](vec2 other) { return glm::length(other - end) < 0.2; }) > 1) ++in_line;
    }
  }
  return static_cast<double>(in_line) / all;
}

TEST(RealPattern, PiecesAreStaggeredAtAboutHalfOfTheRadials) {
  Pane pane = real_pane();
  pane.rings.first_radius_mm = 20.0;
  pane.rings.interruption = 0.0;
  EXPECT_LT(share_in_line(pane), 0.6);
  EXPECT_GT(share_in_line(pane), 0.4);
  pane.rings.spread = 0.0;
  EXPECT_GT(share_in_line(pane), 0.8);
}

TEST(RealPattern, PiecesLieAboutTheirRings) {
  // How far starting points are from the ring they are nearest to, in units of the way from ring to ring, at the most.
  const auto farthest_off = [](const Pane& pane, const Rings& rings) {
    double farthest = 0.0;
    for (const Crack& crack : broken(pane, 3).cracks) {
      if (!is_ring(crack)) continue;
      const double r = glm::length(crack.points_mm.front() - vec2{200.0, 200.0});
      double nearest = 1e9;
      double ring = *rings.first_radius_mm;
      for (int k = 0; k < rings.count; ++k, ring *= rings.ratio) {
        nearest = std::min(nearest, std::abs(r / ring - 1.0) / (rings.ratio - 1.0));
      }
      farthest = std::max(farthest, nearest);
    }
    return farthest;
  };
  Pane pane = real_pane();
  pane.rings.spread = 0.1;
  pane.rings.first_radius_mm = 12.0;
  EXPECT_LT(farthest_off(pane, pane.rings), 0.2);  // the spread, and what wide sectors are set back
  Rings wrong = pane.rings;
  wrong.ratio = 1.3;
  EXPECT_GT(farthest_off(pane, wrong), 0.2);
}

double pieces(Pane pane, double interruption, int seeds = 30) {
  pane.rings.interruption = interruption;
  double count = 0.0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
    const CrackNetwork network = broken(pane, seed);
    count += static_cast<double>(std::ranges::count_if(network.cracks, is_ring)) / 2.0;
    EXPECT_LE(std::abs(network.impacts[0].circular_count - std::ranges::count_if(network.cracks, is_ring) / 2), 2);
  }
  return count;
}

TEST(RealPattern, RingsLeaveOutTheirShareOfSectors) {
  const double all = pieces(real_pane(), 0.0);
  const auto likely = [&](double drawn, double share) {
    return support::chi_square_p({drawn, all - drawn}, {share * all, (1.0 - share) * all}) > support::significance();
  };
  const double some = pieces(real_pane(), 0.35);
  EXPECT_TRUE(likely(some, 0.65));
  EXPECT_FALSE(likely(some, 0.55));
}

// The angles between branches and what they left, after where they part.
std::vector<double> branch_angles(const Pane& pane, int seeds) {
  std::vector<double> angles;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
    const CrackNetwork network = broken(pane, seed);
    for (const Crack& crack : network.cracks) {
      if (crack.kind != CrackKind::branch) continue;
      const std::vector<vec2>& left = network.cracks[static_cast<std::size_t>(*crack.start.crack)].points_mm;
      const auto at = std::ranges::find(left, crack.points_mm.front());
      if (at + 1 >= left.end()) continue;  // it stopped there
      const Angle between = Angle::of(crack.points_mm[1] - crack.points_mm[0]) - Angle::of(*(at + 1) - *at);
      angles.push_back(std::abs(between.wrapped().degrees()));
    }
  }
  return angles;
}

TEST(Branches, PartAtThirtyToFortyFiveDegrees) {
  const auto is_law = [](const Pane& pane) {
    return support::kolmogorov_p(branch_angles(pane, 40), [](double x) { return std::clamp((x - 30.0) / 15.0, 0.0, 1.0); }) >
           support::significance();
  };
  Pane pane = branching_pane();
  const std::vector<double> angles = branch_angles(pane, 40);
  EXPECT_GT(angles.size(), 150U);
  // To what the lattice rounds.
  EXPECT_GT(std::ranges::min(angles), 29.9);
  EXPECT_LT(std::ranges::max(angles), 45.1);
  EXPECT_TRUE(is_law(pane));
  pane.growth.greatest_branch_angle = Angle::degrees(60.0);
  EXPECT_FALSE(is_law(pane));
}

TEST(Branches, AreNoneUnlessAskedFor) {
  for (const Pattern pattern : {Pattern::agui1992, Pattern::real}) {
    Pane pane = real_pane(113);
    pane.pattern = pattern;
    const CrackNetwork network = broken(pane, 1);
    EXPECT_EQ(std::ranges::count(network.cracks, CrackKind::branch, &Crack::kind), 0);
    pane.growth.branch_rate_per_m = 6.0;
    EXPECT_GT(std::ranges::count(broken(pane, 1).cracks, CrackKind::branch, &Crack::kind), 0);
  }
}

TEST(Branches, AreAsManyToTheMetreAsAskedFor) {
  // Of large cracks, and of branches: what is more than 12 mm from their start.
  const auto count_and_length = [](const Pane& pane) {
    std::pair<double, double> result;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      for (const Crack& crack : broken(pane, seed).cracks) {
        if (crack.kind == CrackKind::branch) result.first += 1.0;
        if (crack.kind != CrackKind::branch && crack.kind != CrackKind::large) continue;
        double length = -12.0;
        for (std::size_t i = 1; i < crack.points_mm.size(); ++i)
          length += glm::length(crack.points_mm[i] - crack.points_mm[i - 1]);
        result.second += std::max(length, 0.0) / 1000.0;
      }
    }
    return result;
  };
  const auto [count, metres] = count_and_length(branching_pane());
  // The last step of a crack, half of which is gone in the mean, makes no branch: some 3 %.
  EXPECT_NEAR(count / metres, 6.0, 4.0 * std::sqrt(6.0 / metres) + 0.2);
  EXPECT_GT(std::abs(count / metres - 8.0), 4.0 * std::sqrt(8.0 / metres) + 0.2);  // twin
}

TEST(RealPattern, NetworksOfOddPanesAreSound) {
  int rings = 0;
  int branches = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Pane pane = random_pane(seed, {});
    pane.pattern = Pattern::real;
    if (seed % 2 == 0) pane.growth.branch_rate_per_m = 1000.0 / (px_mm * 40.0 * pane.growth.step_length);
    if (seed % 3 == 0) pane.growth.radial_onset = 10.0;
    pane.rings.first_radius_mm = 0.2 * pane.growth.ring_radius_offset_mm + 0.1;
    const CrackNetwork network = broken(pane, seed);
    EXPECT_EQ(faults(network, pane.outline_mm), nothing) << "pane " << seed;
    rings += static_cast<int>(std::ranges::count_if(network.cracks, is_ring));
    branches += static_cast<int>(std::ranges::count(network.cracks, CrackKind::branch, &Crack::kind));
  }
  EXPECT_GT(rings, 1000);
  EXPECT_GT(branches, 100);
}

TEST(RealPattern, ImpactsNearEdgesAndCornersAndInOrder) {
  Pane pane = real_pane(50);
  pane.impacts[0].at_mm = {2.0, 3.0};
  pane.impacts.push_back(pane.impacts[0]);
  pane.impacts[1].at_mm = {399.5, 210.0};
  const CrackNetwork network = broken(pane, 2);
  EXPECT_EQ(faults(network, pane.outline_mm), nothing);
  // The first one's cracks know nothing of the second.
  for (const Crack& crack : network.cracks) {
    if (crack.impact != 0 || !crack.end.crack) continue;
    EXPECT_EQ(network.cracks[static_cast<std::size_t>(*crack.end.crack)].impact, 0);
  }
}

TEST(RadialOnset, MakesLengthsOfRadialsVary) {
  // Standard deviation over mean, of radials that ended open.
  const auto variation = [](const Pane& pane) {
    std::vector<double> lengths;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      for (const Crack& crack : broken(pane, seed).cracks) {
        if (crack.kind != CrackKind::radial || crack.end.at != CrackEnd::At::open) continue;
        lengths.push_back(glm::length(crack.points_mm.back() - crack.points_mm.front()));
      }
    }
    double mean = 0.0;
    double square = 0.0;
    for (const double length : lengths) mean += length / static_cast<double>(lengths.size());
    for (const double length : lengths) square += (length - mean) * (length - mean) / static_cast<double>(lengths.size());
    return std::sqrt(square) / mean;
  };
  // Of the paper's pattern: in real panes radials die where they are told to.
  Pane pane = real_pane();
  pane.pattern = Pattern::agui1992;
  const double at_once = variation(pane);
  pane.growth.radial_onset = 8.0;
  EXPECT_GT(variation(pane), 1.5 * at_once);
}

TEST(Craters, FollowHertzAndTheCone) {
  Pane pane = real_pane();
  pane.thickness_mm = 6.0;
  const Crater crater = *broken(pane, 1).impacts[0].crater;
  EXPECT_NEAR(crater.crushed_radius_mm, 1.457, 0.001);  // 12.5 mm (5 π 7800 6.26² / (4 · 55.8e9))^(1/5)
  EXPECT_GT(crater.near_radius_mm, crater.crushed_radius_mm);
  EXPECT_NEAR(crater.far_radius_mm - crater.near_radius_mm, 6.0 * 2.4751, 0.001);  // tan 68°
  EXPECT_EQ(crater.milky_radius_mm, 0.0);
  pane.pattern = Pattern::agui1992;
  EXPECT_FALSE(broken(pane, 1).impacts[0].crater);
  pane.glass = Laminated{};
  const Crater held = *broken(pane, 1).impacts[0].crater;
  EXPECT_EQ(held.far_radius_mm, held.near_radius_mm);
  EXPECT_GT(held.milky_radius_mm, held.near_radius_mm);
}

Pane laminated_pane() {
  Pane pane = real_pane(96);
  pane.glass = Laminated{};
  pane.rings = laminated_rings;
  return pane;
}

// Length of cracks to the square between two distances from the impact, mm / mm².
double density(const Pane& pane, double from, double to) {
  double length = 0.0;
  constexpr int seeds = 10;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (const Crack& crack : broken(pane, seed).cracks) {
      for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
        const double r = glm::length(0.5 * (crack.points_mm[i] + crack.points_mm[i - 1]) - vec2{200.0, 200.0});
        if (r >= from && r < to) length += glm::length(crack.points_mm[i] - crack.points_mm[i - 1]);
      }
    }
  }
  return length / (seeds * pi * (to * to - from * from));
}

TEST(Laminated, WebIsDenseAndThinsOutFromTheImpact) {
  const Pane pane = laminated_pane();
  const double near = density(pane, 8.0, 30.0);
  const double middle = density(pane, 30.0, 70.0);
  const double far = density(pane, 70.0, 150.0);
  EXPECT_GT(near, 1.5 * middle);
  EXPECT_GT(middle, 1.5 * far);
  // What annealed glass shows is no such web.
  EXPECT_LT(1.5 * density(real_pane(60), 8.0, 30.0), near);
}

TEST(Laminated, FewCracksRunThrough) {
  const auto through = [](const Pane& pane) {
    std::vector<double> counts(2, 0.0);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      for (const Crack& crack : broken(pane, seed).cracks) {
        if (crack.kind != CrackKind::chip) ++counts[crack.through ? 0 : 1];
      }
    }
    return counts;
  };
  Pane in_pieces = laminated_pane();
  in_pieces.shards = ShardRules{};
  const std::vector<double> counts = through(in_pieces);
  const auto likely = [&](double share) {
    const double all = counts[0] + counts[1];
    return support::chi_square_p(counts, {share * all, (1.0 - share) * all}) > support::significance();
  };
  EXPECT_TRUE(likely(0.35));
  EXPECT_FALSE(likely(0.4));
  EXPECT_EQ(through(real_pane())[1], 0.0);
  // Without shards the far sheet has cracks of its own.
  EXPECT_EQ(through(laminated_pane())[0], 0.0);
}

}  // namespace
}  // namespace shatterpave::glass
