// Heights of Bézier patches over a raster.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/bezier_patch.h"

namespace shatterpave::exporting::textures {

// Heights over samples at whole coordinates (0 … width − 1, 0 … height − 1), row by row.
class HeightBlock {
 public:
  static constexpr float nothing = -std::numeric_limits<float>::infinity();

  // All samples without a height. Memory is kept from one use to the next.
  void reset(std::size_t width, std::size_t height) {
    width_ = width;
    height_ = height;
    heights_.assign(width * height, nothing);
  }

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  float* row(std::size_t y) { return heights_.data() + y * width_; }
  const float* row(std::size_t y) const { return heights_.data() + y * width_; }

 private:
  std::size_t width_ = 0;
  std::size_t height_ = 0;
  std::vector<float> heights_;
};

// Raises the samples under the patch to its height, where they are lower. `patch` has the coordinates of the block in x and y,
// and heights in z. Samples on the border of two patches get a height, whichever way the last bits fall.
void fill_patch(const geometry::BezierPatch& patch, HeightBlock& block);

}  // namespace shatterpave::exporting::textures
