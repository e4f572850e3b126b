#include "geometry/convex_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/random.h"
#include "geometry/sector.h"

namespace shatterpave::geometry {
namespace {

double number(std::uint32_t draw, double low, double high) {
  return low + (high - low) * uniform(7, {Stream::turn, Id("region"), draw});
}

struct Case {
  std::string name;
  ConvexShape shape;
  // Whether a place, told by how far ahead and how far to the left it is, belongs to the shape.
  bool (*holds)(double ahead, double left);
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"sector", ConvexShape::sector(Angle::degrees(100.0), 20.0),
       [](double x, double y) { return std::hypot(x, y) <= 20.0 && std::abs(std::atan2(y, x)) <= 50.0 * pi / 180.0; }},
      {"half disc", ConvexShape::sector(Angle::radians(pi), 9.0),
       [](double x, double y) { return std::hypot(x, y) <= 9.0 && x >= 0.0; }},
      {"rectangle", ConvexShape::rectangle(20.0, 12.0),
       [](double x, double y) { return x >= 0.0 && x <= 20.0 && std::abs(y) <= 6.0; }},
      {"circle", ConvexShape::circle(15.0), [](double x, double y) { return std::hypot(x, y) <= 15.0; }},
  };
  return all;
}

// Everything of a region is asked of many places along many segments, in any direction.
TEST(ConvexRegion, SeesWhatLiesInItsShape) {
  for (const Case& of : cases()) {
    int seen = 0;
    for (std::uint32_t i = 0; i < 400; ++i) {
      const vec2 origin{number(6 * i, -50.0, 50.0), number(6 * i + 1, -50.0, 50.0)};
      const vec2 axis = Angle::radians(number(6 * i + 2, 0.0, 2.0 * pi)).direction();
      const ConvexRegion region(origin, axis, of.shape);
      const vec2 a = origin + number(6 * i + 3, 0.0, 40.0) * Angle::radians(number(6 * i + 4, 0.0, 2.0 * pi)).direction();
      const vec2 b = a + number(6 * i + 5, 0.0, 40.0) * Angle::radians(number(6 * i + 2, 0.0, 7.0)).direction();
      constexpr int parts = 4000;
      double least = HUGE_VAL;
      for (int k = 0; k <= parts; ++k) {
        const vec2 p = glm::mix(a, b, static_cast<double>(k) / parts);
        const bool holds = of.holds(glm::dot(axis, p - origin), cross(axis, p - origin));
        if (holds) least = std::min(least, glm::length(p - origin));
        if (k % 100 != 0) continue;
        EXPECT_EQ(region.contains(p), holds) << of.name << " " << i;
        if (holds) {
          EXPECT_TRUE(glm::all(glm::lessThanEqual(region.box().low, p + 1e-9)) &&
                      glm::all(glm::lessThanEqual(p - 1e-9, region.box().high)));
        }
      }
      const auto nearest = region.nearest_point(a, b);
      const double resolution = glm::length(b - a) / parts;
      if (least < HUGE_VAL) {
        ASSERT_TRUE(nearest.has_value()) << of.name << " " << i;
        EXPECT_NEAR(glm::length(*nearest - origin), least, 2.0 * resolution + 1e-9) << of.name << " " << i;
        ++seen;
      } else if (nearest) {
        // A corner that lies between two of the places.
        const vec2 p = *nearest - 1e-6 * (*nearest - origin);
        EXPECT_NEAR(cross(b - a, p - a), 0.0, 1e-3) << of.name << " " << i;
      }
    }
    EXPECT_GT(seen, 100) << of.name;
  }
}

// The fan is that of Sector, which our law looks into.
TEST(ConvexRegion, OfAFanIsASector) {
  const ConvexShape shape = ConvexShape::sector(Angle::degrees(100.0), 20.0);
  const SectorShape sector_shape(Angle::degrees(100.0), 20.0);
  int seen = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const vec2 axis = Angle::radians(number(5 * i, 0.0, 2.0 * pi)).direction();
    const vec2 a{number(5 * i + 1, -30.0, 30.0), number(5 * i + 2, -30.0, 30.0)};
    const vec2 b{number(5 * i + 3, -30.0, 30.0), number(5 * i + 4, -30.0, 30.0)};
    const auto expected = Sector({0.0, 0.0}, axis, sector_shape).nearest_point(a, b);
    const auto nearest = ConvexRegion({0.0, 0.0}, axis, shape).nearest_point(a, b);
    ASSERT_EQ(nearest.has_value(), expected.has_value()) << i;
    if (!nearest) continue;
    EXPECT_LT(glm::length(*nearest - *expected), 1e-9) << i;
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

}  // namespace
}  // namespace shatterpave::geometry
