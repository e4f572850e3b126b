// The pixels of a texture, over the plane of the scene.
#pragma once

#include <cstddef>

#include "core/vec.h"

namespace shatterpave::exporting::textures {

// Rows run from the top, which has the largest y. Pixels are square but where a seamless tile asks for others.
struct PixelGrid {
  vec2 low_mm{0.0, 0.0};  // the lower left corner of the window
  vec2 pixel_mm{1.0, 1.0};
  std::size_t width = 0;
  std::size_t height = 0;

  vec2 size_mm() const { return pixel_mm * vec2{static_cast<double>(width), static_cast<double>(height)}; }
  // The middle of a pixel; columns and rows beyond the window are as good.
  vec2 centre(double column, double row) const {
    return {low_mm.x + (column + 0.5) * pixel_mm.x, low_mm.y + (static_cast<double>(height) - row - 0.5) * pixel_mm.y};
  }
};

}  // namespace shatterpave::exporting::textures
