// The camera of a scene: a thin lens, its picture upright.
#pragma once

#include <array>
#include <optional>

#include "core/angle.h"
#include "core/vec.h"

namespace shatterpave::studio {

// As wide as a photograph on film of 36 × 24 mm: from the field of view follows the focal length, and from that and the
// f-number the lens's opening.
inline constexpr double film_width_mm = 36.0;

struct Camera {
  vec3 at_mm{0.0, -3000.0, 1600.0};            // in the world (studio/world.h)
  vec3 look_at_mm{0.0, 0.0, 0.0};              // not `at_mm`
  Angle field_of_view = Angle::degrees(40.0);  // across the picture, 0.1 … 170°
  std::optional<double> focus_mm;              // from the camera to what is sharp, along the view; with f_number
  std::optional<double> f_number;              // not given: all is sharp
  std::optional<std::array<int, 2>> size_px;   // of the picture, each 1 … 16384; not given: as the command says

  bool operator==(const Camera&) const = default;
};

// The axes of a camera in the world: unit vectors, at right angles to one another.
struct View {
  vec3 right{1.0, 0.0, 0.0};
  vec3 up{0.0, 0.0, 1.0};
  vec3 forward{0.0, 1.0, 0.0};
};
// The upright of the world is upright in the picture; where the camera looks along it, up or down, right is +x.
//   REQUIRES  at_mm is not look_at_mm
View view_of(const Camera& camera);

// Width over height of the picture: where no size is given, that of 4 : 3.
double aspect_of(const Camera& camera);
// The field of view up the picture, where that is so much wider than high.
Angle upright_field_of_view(Angle across, double aspect);

// On film of `film_width_mm`.
double focal_length_mm(const Camera& camera);
// Of the lens's opening; 0 where all is sharp.
double lens_radius_mm(const Camera& camera);

}  // namespace shatterpave::studio
