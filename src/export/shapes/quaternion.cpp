#include "export/shapes/quaternion.h"

#include <cmath>

namespace shatterpave::exporting::shapes {

// By the largest of the four, so that nothing small is divided by.
std::array<double, 4> quaternion(const Placing& placing) {
  const std::array<vec3, 3>& m = placing.turn;
  const double trace = m[0].x + m[1].y + m[2].z;
  std::array<double, 4> q{};
  if (trace > 0.0) {
    const double s = 2.0 * std::sqrt(1.0 + trace);
    q = {(m[2].y - m[1].z) / s, (m[0].z - m[2].x) / s, (m[1].x - m[0].y) / s, 0.25 * s};
  } else if (m[0].x > m[1].y && m[0].x > m[2].z) {
    const double s = 2.0 * std::sqrt(1.0 + m[0].x - m[1].y - m[2].z);
    q = {0.25 * s, (m[0].y + m[1].x) / s, (m[0].z + m[2].x) / s, (m[2].y - m[1].z) / s};
  } else if (m[1].y > m[2].z) {
    const double s = 2.0 * std::sqrt(1.0 + m[1].y - m[0].x - m[2].z);
    q = {(m[0].y + m[1].x) / s, 0.25 * s, (m[1].z + m[2].y) / s, (m[0].z - m[2].x) / s};
  } else {
    const double s = 2.0 * std::sqrt(1.0 + m[2].z - m[0].x - m[1].y);
    q = {(m[0].z + m[2].x) / s, (m[1].z + m[2].y) / s, 0.25 * s, (m[1].x - m[0].y) / s};
  }
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

}  // namespace shatterpave::exporting::shapes
