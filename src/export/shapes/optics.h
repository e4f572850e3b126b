// Light in glass and water, as targets with true dielectrics have it.
#pragma once

namespace shatterpave::exporting::shapes {

inline constexpr double glass_ior = 1.52;
inline constexpr double water_ior = 1.333;

// How far white light goes in window glass until a share 1 / e of it is left, and what it is then: 4 mm of float glass let 89
// to 90 % through, of which the two faces take 8 % (EN 572-1); the green is that of its iron. By eye.
inline constexpr double attenuation_m = 0.25;
inline constexpr double attenuation_colour[] = {0.62, 0.83, 0.74};

// The share of light that a face of it throws back where it comes in squarely (Fresnel).
constexpr double reflectance(double ior) { return (ior - 1.0) / (ior + 1.0) * ((ior - 1.0) / (ior + 1.0)); }

}  // namespace shatterpave::exporting::shapes
