#include "relief/field_spectrum.h"

#include <cmath>
#include <complex>
#include <vector>

#include "core/functions.h"
#include "relief/fourier.h"

namespace shatterpave::relief {

double spectral_slope(const HeightField& field, double first, double last) {
  std::vector<std::complex<double>> values(field.heights_mm.begin(), field.heights_mm.end());
  transform_back(values, field.width);
  const auto side = static_cast<double>(field.width);
  double n = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (double ring = first; ring * 1.25 <= last; ring *= 1.25) {
    double power_sum = 0.0;
    double count = 0.0;
    double log_k_sum = 0.0;
    for (std::size_t row = 0; row < field.height; ++row) {
      for (std::size_t column = 0; column < field.width; ++column) {
        const double k = static_cast<double>(column) - (column > field.width / 2 ? side : 0.0);
        const double l = static_cast<double>(row) - (row > field.height / 2 ? side : 0.0);
        const double waves = std::sqrt(k * k + l * l);
        if (waves < ring || waves >= ring * 1.25) continue;
        power_sum += std::norm(values[row * field.width + column]);
        log_k_sum += logarithm(waves);
        count += 1.0;
      }
    }
    const double x = log_k_sum / count;
    const double y = logarithm(power_sum / count);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace shatterpave::relief
