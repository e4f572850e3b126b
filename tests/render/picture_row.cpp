#include "render/picture_row.h"

#include <cstddef>

namespace shatterpave::render_tests {

relief::Raster row_of(const std::vector<relief::Raster>& pictures) {
  const relief::Raster& first = pictures.front();
  relief::Raster row{first.width * pictures.size(), first.height, first.channels, {}};
  const auto stride = static_cast<std::ptrdiff_t>(first.width * first.channels);
  for (std::ptrdiff_t y = 0; y < static_cast<std::ptrdiff_t>(first.height); ++y) {
    for (const relief::Raster& part : pictures) {
      row.values.insert(row.values.end(), part.values.begin() + y * stride, part.values.begin() + (y + 1) * stride);
    }
  }
  return row;
}

std::vector<relief::Raster> parts_of(const relief::Raster& row, std::size_t width) {
  std::vector<relief::Raster> parts(row.width / width, relief::Raster{width, row.height, row.channels, {}});
  const auto stride = static_cast<std::ptrdiff_t>(width * row.channels);
  auto next = row.values.begin();
  for (std::size_t y = 0; y < row.height; ++y) {
    for (relief::Raster& part : parts) {
      part.values.insert(part.values.end(), next, next + stride);
      next += stride;
    }
  }
  return parts;
}

}  // namespace shatterpave::render_tests
