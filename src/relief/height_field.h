// Heights over a square raster.
#pragma once

#include <cstddef>
#include <vector>

namespace shatterpave::relief {

// Heights in mm, row by row; the point (column, row) lies at (column, row) * spacing_mm. A field that `fractal_surface` made
// is periodic: column `width` is column 0 again.
struct HeightField {
  std::size_t width = 0;
  std::size_t height = 0;
  double spacing_mm = 1.0;
  std::vector<double> heights_mm;  // width * height

  double at(std::size_t column, std::size_t row) const { return heights_mm[row * width + column]; }

  bool operator==(const HeightField&) const = default;
};

// Root mean square of the heights about their mean, mm; 0 for an empty field.
double rms_mm(const HeightField& field);

}  // namespace shatterpave::relief
