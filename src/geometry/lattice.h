// The lattice on which every vertex that decides something, and every vertex that reaches a file, lies: multiples of 1 µm.
//
// On it, side and order are decided exactly in integers; neighbours that share a vertex share it to the bit; the last bits
// in which processors differ are rounded away; and a file's "150.123" is exact. 1 µm is a hundredth of the thinnest crack or
// joint that a picture can show.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

#include "core/vec.h"

namespace shatterpave::geometry {

inline constexpr double lattice_per_mm = 1000.0;

// Coordinates of scenes are limited to ±1 km, so that differences fit 31 bits and their products 62.
inline constexpr double largest_coordinate_mm = 1e6;

struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  auto operator<=>(const LatticePoint&) const = default;
};

inline std::int64_t to_lattice(double mm) { return std::llround(mm * lattice_per_mm); }
inline LatticePoint to_lattice(vec2 mm) { return {to_lattice(mm.x), to_lattice(mm.y)}; }
inline double to_mm(std::int64_t coordinate) { return static_cast<double>(coordinate) / lattice_per_mm; }
inline vec2 to_mm(LatticePoint p) { return {to_mm(p.x), to_mm(p.y)}; }

// The nearest point of the lattice, in mm.
inline vec2 on_lattice(vec2 mm) { return to_mm(to_lattice(mm)); }

}  // namespace shatterpave::geometry
