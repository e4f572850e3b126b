#include "geometry/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {
namespace {

double draw(std::uint64_t seed, std::uint32_t index) { return uniform(seed, {Stream::stone_place, Id("overlay"), index}); }

// Rings of three to eight points anywhere in a square: they may cross themselves.
std::vector<Layer> random_layers(std::uint64_t seed, double size_mm) {
  std::vector<Layer> layers;
  std::uint32_t index = 0;
  const int count = 2 + static_cast<int>(5.0 * draw(seed, index++));
  for (int layer = 0; layer < count; ++layer) {
    Polygon ring;
    const int points = 3 + static_cast<int>(6.0 * draw(seed, index++));
    for (int i = 0; i < points; ++i) {
      const double x = draw(seed, index++);
      const double y = draw(seed, index++);
      ring.push_back(on_lattice(size_mm * vec2{x, y}));
    }
    layers.push_back({ring});
  }
  return layers;
}

// Whether two sides have more in common than an end of both.
bool meet_badly(const Segment& s, const Segment& t) {
  if (!segments_meet(s.a, s.b, t.a, t.b)) return false;
  const bool share = s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
  if (!share) return true;
  const LatticePoint other = s.a == t.a || s.a == t.b ? s.b : s.a;
  const LatticePoint rest = t.a == s.a || t.a == s.b ? t.b : t.a;
  return on_segment(t.a, t.b, other) || on_segment(s.a, s.b, rest);
}

// By brute force over all pairs. Squares of a few micrometres hold nothing but coincidences; in one of a metre there are few.
TEST(Overlay, SidesMeetInTheirEndsOnly) {
  std::size_t crossings = 0;
  for (const double size_mm : {0.006, 0.02, 0.3, 1000.0}) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      const auto layers = random_layers(seed, size_mm);
      const Overlay map = overlay(layers);
      std::size_t given = 0;
      for (const Layer& layer : layers) given += layer.front().size();
      crossings += map.sides.size() > given ? 1U : 0U;
      for (std::size_t i = 0; i < map.sides.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          ASSERT_FALSE(meet_badly(map.sides[i], map.sides[j])) << size_mm << ", seed " << seed;
        }
      }
    }
  }
  EXPECT_GT(crossings, 400U);
}

double length(const Polygon& ring) {
  double total = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) total += glm::length(ring[(i + 1) % ring.size()] - ring[i]);
  return total;
}

double covered_mm2(const Overlay& map, std::uint32_t layer) {
  double total = 0.0;
  for (std::size_t f = 0; f < map.faces.size(); ++f) {
    if (std::ranges::binary_search(map.covered_by[f], layer)) total += 0.5e-6 * static_cast<double>(doubled_area(map.faces[f]));
  }
  return total;
}

// Against Clipper, which counts windings in its own way. A side strays by 0.71 µm at the most.
TEST(Overlay, LayersCoverWhatTheyWindAbout) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto layers = random_layers(seed, 1000.0);
    const Overlay map = overlay(layers);
    for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
      const Polygon& ring = layers[layer].front();
      double area_mm2 = 0.0;
      for (const Region& region : united(std::vector<Polygon>{ring})) area_mm2 += area(region);
      EXPECT_NEAR(covered_mm2(map, layer), area_mm2, 0.002 * length(ring)) << "seed " << seed << ", layer " << layer;
    }
  }
}

TEST(Overlay, TellsWhichLayersCoverWhat) {
  const Layer square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const Layer frame{{{2, 2}, {8, 2}, {8, 8}, {2, 8}}, {{3, 3}, {3, 7}, {7, 7}, {7, 3}}};  // its hole winds the other way
  const Overlay map = overlay(std::vector<Layer>{square, frame});
  std::map<std::vector<std::uint32_t>, double> areas;
  for (std::size_t f = 0; f < map.faces.size(); ++f) {
    areas[map.covered_by[f]] += 0.5e-6 * static_cast<double>(doubled_area(map.faces[f]));
  }
  EXPECT_DOUBLE_EQ((areas[{0}]), 16.0 - 3.0);
  EXPECT_DOUBLE_EQ((areas[{0, 1}]), 3.0);
  EXPECT_DOUBLE_EQ((areas[{1}]), 36.0 - 16.0 - 3.0);
  EXPECT_DOUBLE_EQ(areas[{}], 16.0 - 1.0);  // in the hole, beside the square
}

TEST(Overlay, GivesRegionsOfLabelsThatHangTogether) {
  const std::vector<Layer> layers{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, {{{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
  const Overlay map = overlay(layers);
  std::vector<std::uint32_t> label;
  for (const auto& covered : map.covered_by) label.push_back(covered.size() == 2 ? 1U : 0U);
  const auto regions = labelled_regions(map, label);
  ASSERT_EQ(regions.size(), 2U);
  for (const LabelledRegion& region : regions) {
    EXPECT_DOUBLE_EQ(area(region.region), region.label == 1 ? 9.0 : 72.0);
    EXPECT_EQ(region.region.holes.size(), region.label == 1 ? 0U : 1U);
  }
}

TEST(Overlay, GivesSliversToTheNeighbourBesideThem) {
  // Two squares that overlap by 5 µm, a third that leaves 5 µm.
  const std::vector<Layer> layers{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}},
                                  {{{9.995, 0}, {20, 0}, {20, 10}, {9.995, 10}}},
                                  {{{20.005, 0}, {30, 0}, {30, 10}, {20.005, 10}}},
                                  {{{0, 0}, {30, 0}, {30, 10}, {0, 10}}}};
  const Overlay map = overlay(layers);
  std::vector<std::uint32_t> label;
  for (const auto& covered : map.covered_by)
    label.push_back(covered.size() == 1 ? 7U : covered.size() == 3 ? 8U : covered.front());
  const auto regions = labelled_regions(map, without_slivers(map, label, 0.02, 9));
  EXPECT_EQ(labelled_regions(map, label).size(), 5U);
  ASSERT_EQ(regions.size(), 3U);
  double total = 0.0;
  for (const LabelledRegion& region : regions) total += area(region.region);
  EXPECT_NEAR(total, 300.0, 1e-9);
}

}  // namespace
}  // namespace shatterpave::geometry
