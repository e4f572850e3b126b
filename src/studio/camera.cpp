#include "studio/camera.h"

#include <cmath>

#include "core/error.h"

namespace shatterpave::studio {

namespace {

// Below this sine of the angle between view and upright, a camera looks straight up or down: far above what rounding of
// places to whole µm on a path of metres makes of it.
constexpr double straight = 1e-6;

double tangent_of_half(Angle angle) {
  const vec2 d = (angle * 0.5).direction();
  return d.y / d.x;
}

}  // namespace

View view_of(const Camera& camera) {
  const vec3 along = camera.look_at_mm - camera.at_mm;
  const double distance = glm::length(along);
  ENSURE(distance > 0.0);
  const vec3 forward = along / distance;
  const vec3 across = glm::cross(forward, vec3{0.0, 0.0, 1.0});
  const double sine = glm::length(across);
  const vec3 sideways = sine > straight ? across / sine : vec3{1.0, 0.0, 0.0};
  const vec3 up = glm::normalize(glm::cross(sideways, forward));
  return {glm::cross(forward, up), up, forward};
}

double aspect_of(const Camera& camera) {
  if (!camera.size_px) return 4.0 / 3.0;
  return static_cast<double>((*camera.size_px)[0]) / static_cast<double>((*camera.size_px)[1]);
}

Angle upright_field_of_view(Angle across, double aspect) { return 2.0 * Angle::of({aspect, tangent_of_half(across)}); }

double focal_length_mm(const Camera& camera) { return 0.5 * film_width_mm / tangent_of_half(camera.field_of_view); }

double lens_radius_mm(const Camera& camera) { return camera.f_number ? 0.5 * focal_length_mm(camera) / *camera.f_number : 0.0; }

}  // namespace shatterpave::studio
