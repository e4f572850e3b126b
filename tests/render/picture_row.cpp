#include "render/picture_row.h"

#include <cstddef>

#include "core/error.h"

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

relief::Raster shrunk(const relief::Raster& picture, std::size_t factor) {
  ENSURE(factor > 0 && picture.width % factor == 0 && picture.height % factor == 0);
  relief::Raster result{picture.width / factor, picture.height / factor, picture.channels, {}};
  const auto share = 1.0F / static_cast<float>(factor * factor);
  result.values.assign(result.width * result.height * result.channels, 0.0F);
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = 0; x < picture.width; ++x) {
      for (std::size_t channel = 0; channel < picture.channels; ++channel) {
        result.values[((y / factor) * result.width + x / factor) * result.channels + channel] +=
            share * picture.values[(y * picture.width + x) * picture.channels + channel];
      }
    }
  }
  return result;
}

}  // namespace shatterpave::render_tests
