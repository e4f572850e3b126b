// What renderers are told of a surface, row by row from its heights: where it faces, and how open it lies.
#pragma once

#include <cstddef>
#include <span>

#include "core/vec.h"

namespace shatterpave::relief {

// Heights on a raster, row by row from the top, of which a window matters; about it there are at least as many pixels more as a
// function below reaches.
struct HeightRows {
  const float* window_mm = nullptr;  // the height of the window's first pixel
  std::size_t row_length = 0;        // from a row to the next
  vec2 pixel_mm{1.0, 1.0};

  const float* row(std::size_t row) const { return window_mm + row * row_length; }
};

// Normals of a row of the window as (n + 1) / 2, channels together: x to the right, y up in the picture (OpenGL), z up. By
// central differences: reaches one pixel.
void normal_row(const HeightRows& heights, std::size_t row, std::span<float> values);

// How far the horizon is looked for, in pixels: the largest of its steps within that distance. 1 … 89.
std::size_t horizon_reach(double pixels);

// Ambient occlusion of a row, 0 (dark) … 1 (open); as many as the window has columns.
//
// From each pixel the horizon is looked for in eight directions, at distances that grow as the Fibonacci numbers up to `reach`.
// A horizon of slope s >= 0 leaves 1 / (1 + s²), the square of the cosine of its angle, of what a level place would get from an
// even sky in that direction; the mean over the directions is what the pixel gets. The cost goes with the pixels, and as the
// logarithm of the reach.
void occlusion_row(const HeightRows& heights, std::size_t reach, std::size_t row, std::span<float> open);

}  // namespace shatterpave::relief
