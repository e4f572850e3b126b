#include "geometry/predicates.h"

#include <algorithm>

namespace shatterpave::geometry {

namespace {

bool within_box(LatticePoint a, LatticePoint b, LatticePoint c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y);
}

}  // namespace

Side side(LatticePoint a, LatticePoint b, LatticePoint c) {
  __extension__ using Wide = __int128;
  const Wide left = static_cast<Wide>(b.x - a.x) * (c.y - a.y);
  const Wide right = static_cast<Wide>(b.y - a.y) * (c.x - a.x);
  if (left == right) return Side::on;
  return left > right ? Side::left : Side::right;
}

bool on_segment(LatticePoint a, LatticePoint b, LatticePoint c) { return side(a, b, c) == Side::on && within_box(a, b, c); }

bool segments_cross(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const int c_side = static_cast<int>(side(a, b, c));
  const int d_side = static_cast<int>(side(a, b, d));
  const int a_side = static_cast<int>(side(c, d, a));
  const int b_side = static_cast<int>(side(c, d, b));
  return c_side * d_side < 0 && a_side * b_side < 0;
}

bool segments_meet(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const int c_side = static_cast<int>(side(a, b, c));
  const int d_side = static_cast<int>(side(a, b, d));
  if (c_side * d_side > 0) return false;  // by far the most
  const int a_side = static_cast<int>(side(c, d, a));
  const int b_side = static_cast<int>(side(c, d, b));
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) || (a_side == 0 && within_box(c, d, a)) ||
         (b_side == 0 && within_box(c, d, b));
}

}  // namespace shatterpave::geometry
