#include "measure/crossings.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "geometry/predicates.h"

namespace shatterpave::measure {
namespace {

glass::CrackNetwork network_of(const std::vector<std::vector<vec2>>& lines) {
  glass::CrackNetwork network;
  network.impacts.resize(1);
  for (const std::vector<vec2>& line : lines) {
    glass::Crack crack;
    crack.id = static_cast<int>(network.cracks.size());
    crack.points_mm = line;
    network.cracks.push_back(crack);
  }
  return network;
}

TEST(Crossings, AreXAndNotT) {
  // A cross; a T in a vertex; a T beside one; two that start together.
  EXPECT_EQ(crossings(network_of({{{0, 0}, {10, 10}}, {{0, 10}, {10, 0}}})), (std::vector<Crossing>{{0, 1}}));
  EXPECT_TRUE(crossings(network_of({{{0, 0}, {5, 0}, {10, 0}}, {{5, 8}, {5, 4}, {5, 0}}})).empty());
  EXPECT_TRUE(crossings(network_of({{{0, 0}, {10, 0}}, {{5, 8}, {5, 0}}})).empty());
  EXPECT_TRUE(crossings(network_of({{{0, 0}, {10, 0}}, {{0, 0}, {0, 10}}, {{0, 0}, {7, 7}}})).empty());
  EXPECT_TRUE(crossings(network_of({})).empty());
}

TEST(Crossings, ThroughVerticesCountOnce) {
  // Through a vertex of one, of both, and a touch of two corners.
  EXPECT_EQ(crossings(network_of({{{0, 0}, {5, 5}, {10, 10}}, {{0, 10}, {10, 0}}})).size(), 1U);
  EXPECT_EQ(crossings(network_of({{{0, 0}, {5, 5}, {10, 10}}, {{0, 10}, {5, 5}, {10, 0}}})).size(), 1U);
  EXPECT_EQ(crossings(network_of({{{0, 0}, {5, 5}, {10, 0}}, {{0, 10}, {5, 5}, {10, 10}}})).size(), 1U);
}

TEST(Crossings, OfACrackWithItselfCount) {
  EXPECT_EQ(crossings(network_of({{{0, 0}, {10, 0}, {10, 5}, {5, 5}, {5, -5}}})), (std::vector<Crossing>{{0, 0}}));
}

// The twins of one another: the bands, and all pairs of pieces.
TEST(Crossings, AreThoseOfAllPairs) {
  std::size_t all = 0;
  for (std::uint32_t round = 0; round < 40; ++round) {
    std::vector<std::vector<vec2>> lines(25);
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      const auto draw = [&](std::uint32_t k) { return uniform(round, {Stream::turn, Id("line").child(i), k}) - 0.5; };
      vec2 at{100.0 * draw(0), 100.0 * draw(1)};
      lines[i].push_back(geometry::on_lattice(at));
      // Some long pieces among many short ones, some level, some upright.
      for (std::uint32_t k = 1; k < 12; ++k) {
        const double length = k % 5 == 0 ? 60.0 : 6.0;
        at += vec2{i % 7 == 0 ? 0.0 : length * draw(2 * k), i % 7 == 1 ? 0.0 : length * draw(2 * k + 1)};
        lines[i].push_back(geometry::on_lattice(at));
      }
    }
    std::vector<Crossing> expected;
    for (std::size_t a = 0; a < lines.size(); ++a) {
      for (std::size_t b = a; b < lines.size(); ++b) {
        for (std::size_t i = 1; i < lines[a].size(); ++i) {
          for (std::size_t j = a == b ? i + 1 : 1; j < lines[b].size(); ++j) {
            if (geometry::segments_cross(geometry::to_lattice(lines[a][i - 1]), geometry::to_lattice(lines[a][i]),
                                         geometry::to_lattice(lines[b][j - 1]), geometry::to_lattice(lines[b][j]))) {
              expected.push_back({static_cast<int>(a), static_cast<int>(b)});
            }
          }
        }
      }
    }
    EXPECT_EQ(crossings(network_of(lines)), expected) << round;
    all += expected.size();
  }
  EXPECT_GT(all, 1000U);
}

}  // namespace
}  // namespace shatterpave::measure
