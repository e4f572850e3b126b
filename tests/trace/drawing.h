// Pictures with known lines, for tests of tracing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle.h"
#include "core/random.h"
#include "trace/picture.h"

namespace shatterpave::test {

struct DrawnLine {
  std::vector<vec2> points;
  double width_px = 2.0;
  double level = 100.0;  // what it adds to its ground; below 0 it is darker
};

// Lines with soft borders over a ground that rises from left to right, with noise.
inline trace::Grey drawn(int width, int height, const std::vector<DrawnLine>& lines, double ground_left, double ground_right,
                         double noise = 0.0) {
  std::vector<double> levels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  trace::Grey picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double share = (x + 0.5) / width;
      levels[picture.index(x, y)] = ground_left + share * (ground_right - ground_left) +
                                    noise * normal(7, {Stream::ground, Id().child(picture.index(x, y))});
    }
  }
  std::vector<double> most(levels.size(), 0.0);  // the strongest line at a pixel, not their sum
  for (const DrawnLine& line : lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const vec2 a = line.points[i - 1];
      const vec2 ab = line.points[i] - a;
      const double reach = 0.5 * line.width_px + 1.0;
      const auto within = [](double v, int count) { return std::clamp(static_cast<int>(std::floor(v)), 0, count - 1); };
      for (int y = within(std::min(a.y, a.y + ab.y) - reach, height); y <= within(std::max(a.y, a.y + ab.y) + reach, height);
           ++y) {
        for (int x = within(std::min(a.x, a.x + ab.x) - reach, width); x <= within(std::max(a.x, a.x + ab.x) + reach, width);
             ++x) {
          const vec2 p{x + 0.5, y + 0.5};
          const double share = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
          const double cover = std::clamp(reach - 0.5 - glm::length(p - a - share * ab), 0.0, 1.0);
          double& there = most[picture.index(x, y)];
          if (std::abs(cover * line.level) > std::abs(there)) there = cover * line.level;
        }
      }
    }
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    picture.values[i] = static_cast<std::uint8_t>(std::clamp(std::lround(levels[i] + most[i]), 0L, 255L));
  }
  return picture;
}

// Lines from `centre`: the first `large` of them to the border of a square of `side` px, the others for `reach` px; spread
// evenly.
inline std::vector<DrawnLine> star(vec2 centre, int count, int large, double side, double reach, double level) {
  std::vector<DrawnLine> lines;
  for (int i = 0; i < count; ++i) {
    const vec2 way = Angle::degrees(7.0 + 360.0 * i / count).direction();
    const bool is_large = i * large / count != (i + count - 1) % count * large / count;
    vec2 end = centre + reach * way;
    if (is_large) {
      double far = 2.0 * side;
      for (vec2::length_type axis = 0; axis < 2; ++axis) {
        if (way[axis] > 0.0) far = std::min(far, (side - centre[axis]) / way[axis]);
        if (way[axis] < 0.0) far = std::min(far, -centre[axis] / way[axis]);
      }
      end = centre + far * way;
    }
    lines.push_back({{centre + 8.0 * way, end}, 2.0, level});
  }
  return lines;
}

}  // namespace shatterpave::test
