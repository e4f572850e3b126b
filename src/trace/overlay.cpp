#include "trace/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shatterpave::trace {

namespace {

using Colour = std::array<std::uint8_t, 3>;

Colour colour_of(const glass::Crack& crack) {
  switch (crack.kind) {
    case glass::CrackKind::large:
      return {224, 48, 48};
    case glass::CrackKind::radial:
      return crack.end.at == glass::CrackEnd::At::edge ? Colour{224, 48, 48} : Colour{255, 176, 0};
    case glass::CrackKind::branch:
      return {255, 48, 255};
    default:
      return {0, 176, 255};
  }
}

void put_disc(relief::Photograph& picture, vec2 at, double radius, const Colour& colour) {
  const int reach = static_cast<int>(std::ceil(radius));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const int x = static_cast<int>(std::floor(at.x)) + dx;
      const int y = static_cast<int>(std::floor(at.y)) + dy;
      if (dx * dx + dy * dy > radius * radius || x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
      const auto pixel =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
      std::ranges::copy(colour, &picture.rgb[pixel]);
    }
  }
}

}  // namespace

relief::Photograph overlay(const relief::Photograph& photograph, const Trace& trace) {
  relief::Photograph picture = photograph;
  // Half as strong, half-way to mid grey, so that lines show on black and on white.
  for (std::uint8_t& level : picture.rgb) level = static_cast<std::uint8_t>(level / 2 + 64);
  const double radius = std::max(photograph.width, photograph.height) / 1600.0;
  for (const glass::Crack& crack : trace.network.cracks) {
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const vec2 from = trace.in_photograph(crack.points_mm[i - 1]);
      const vec2 way = trace.in_photograph(crack.points_mm[i]) - from;
      const int steps = static_cast<int>(2.0 * glm::length(way)) + 1;
      for (int k = 0; k <= steps; ++k)
        put_disc(picture, from + (static_cast<double>(k) / steps) * way, radius, colour_of(crack));
    }
  }
  return picture;
}

}  // namespace shatterpave::trace
