#include "studio/plain_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/smooth_step.h"
#include "studio/light.h"

namespace shatterpave::studio {

namespace {

// By eye: a horizon of haze, a zenith of half its brightness and blue, ground that is as light as concrete in the shade.
constexpr vec3 zenith{0.55, 0.80, 1.30};
constexpr vec3 horizon{1.25, 1.25, 1.20};
constexpr vec3 ground{0.26, 0.25, 0.23};
constexpr double haze_sine = 0.04;  // from ground to sky; a picture of 128 rows holds it in three

constexpr int width = 256;
constexpr int height = 128;

std::array<std::uint8_t, 4> rgbe(vec3 colour) {
  const double largest = std::max({colour.x, colour.y, colour.z});
  int exponent = 0;
  const double scale = std::frexp(largest, &exponent) * 256.0 / largest;
  const auto part = [&](double value) { return static_cast<std::uint8_t>(value * scale); };
  return {part(colour.x), part(colour.y), part(colour.z), static_cast<std::uint8_t>(exponent + 128)};
}

}  // namespace

vec3 plain_sky(vec3 direction) {
  const double height_sine = direction.z / glm::length(direction);
  const double part = std::sqrt(std::max(0.0, height_sine));
  const vec3 sky = horizon + part * (zenith - horizon);
  const double above = smooth_step(0.5 + 0.5 * height_sine / haze_sine);
  return ground + above * (sky - ground);
}

std::string plain_sky_hdr() {
  std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 128 +X 256\n";
  constexpr int longest_run = 128;
  for (int y = 0; y < height; ++y) {
    const auto colour =
        rgbe(plain_sky(direction_of({0.5, (static_cast<double>(y) + 0.5) / static_cast<double>(height)}, Angle())));
    // A row says how long it is, and then each of the four parts in runs of one value.
    text += {'\2', '\2', static_cast<char>(width / 256), static_cast<char>(width % 256)};
    for (const std::uint8_t part : colour) {
      for (int x = 0; x < width; x += longest_run - 1) {
        text += static_cast<char>(128 + std::min(longest_run - 1, width - x));
        text += static_cast<char>(part);
      }
    }
  }
  return text;
}

}  // namespace shatterpave::studio
