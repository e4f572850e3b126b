#include "relief/height_field.h"

#include <cmath>

namespace shatterpave::relief {

double rms_mm(const HeightField& field) {
  if (field.heights_mm.empty()) return 0.0;
  const auto count = static_cast<double>(field.heights_mm.size());
  double sum = 0.0;
  for (const double height : field.heights_mm) sum += height;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double height : field.heights_mm) squares += (height - mean) * (height - mean);
  return std::sqrt(squares / count);
}

}  // namespace shatterpave::relief
