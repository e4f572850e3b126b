#include "scene/plan_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"

namespace shatterpave::scene {

namespace {

// WGS 84 (EPSG dataset, ellipsoid 7030).
constexpr double semi_major_axis_m = 6378137.0;
constexpr double flattening = 1.0 / 298.257223563;

// What is called metres for want of degrees and is smaller than a hand is something else, such as degrees with a longitude
// beyond 180 or with latitude first.
constexpr double smallest_guessed_m = 0.1;

geometry::Box grown(geometry::Box box, vec2 p) { return {glm::min(box.low, p), glm::max(box.high, p)}; }

bool could_be_degrees(vec2 p) { return p.x >= -180.0 && p.x <= 180.0 && p.y >= -90.0 && p.y <= 90.0; }

double short_way_round(double degrees) {
  if (degrees > 180.0) return degrees - 360.0;
  return degrees < -180.0 ? degrees + 360.0 : degrees;
}

// Millimetres for one degree of longitude and of latitude.
vec2 mm_per_degree(double latitude_deg) {
  constexpr double squared_eccentricity = flattening * (2.0 - flattening);
  const double latitude = latitude_deg * (pi / 180.0);
  const double s = sine(latitude);
  const double w = 1.0 - squared_eccentricity * s * s;
  const double prime_vertical_m = semi_major_axis_m / std::sqrt(w);
  const double meridian_m = semi_major_axis_m * (1.0 - squared_eccentricity) / (w * std::sqrt(w));
  return vec2{prime_vertical_m * cosine(latitude), meridian_m} * (1000.0 * pi / 180.0);
}

// All positions of the shapes, longitudes next to that of the first one.
geometry::Box box_of(const Plan& plan, const std::vector<std::size_t>& shapes, bool degrees) {
  const vec2 first = plan.shapes[shapes.front()].rings.front().points_mm.front();
  geometry::Box box{first, first};
  for (const std::size_t shape : shapes) {
    for (const Ring& ring : plan.shapes[shape].rings) {
      for (const vec2& p : ring.points_mm) {
        box = grown(box, degrees ? vec2{first.x + short_way_round(p.x - first.x), p.y} : p);
      }
    }
  }
  return box;
}

PlanFrame frame_of_degrees(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<vec2> origin) {
  for (const std::size_t shape : shapes) {
    for (const Ring& ring : plan.shapes[shape].rings) {
      for (const vec2& p : ring.points_mm) {
        if (could_be_degrees(p)) continue;
        throw InputError(ring.place, fmt::format("expected longitudes from -180 to 180 and latitudes from -90 to 90, got "
                                                 "({}, {})",
                                                 p.x, p.y));
      }
    }
  }
  const geometry::Box box = box_of(plan, shapes, true);
  const vec2 middle = 0.5 * (box.low + box.high);
  const vec2 at = origin.value_or(vec2{short_way_round(middle.x), middle.y});
  const vec2 scale = mm_per_degree(at.y);
  const vec2 size = (box.high - box.low) * scale;
  if (std::max(size.x, size.y) > 2.0 * geometry::largest_coordinate_mm) {
    throw InputError(plan.shapes[shapes.front()].rings.front().place,
                     fmt::format("expected an area of at most 2 km, got {:.0f} km × {:.0f} km; if these are no degrees, "
                                 "set outline_units",
                                 size.x * 1e-6, size.y * 1e-6));
  }
  return {at, scale, true};
}

PlanFrame frame_of_lengths(const Plan& plan, const std::vector<std::size_t>& shapes, double mm, bool guessed,
                           std::optional<vec2> origin) {
  const geometry::Box box = box_of(plan, shapes, false);
  const vec2 size = box.high - box.low;
  if (guessed && std::max(size.x, size.y) * mm < smallest_guessed_m * 1000.0) {
    throw InputError(plan.shapes[shapes.front()].rings.front().place,
                     fmt::format("expected longitude and latitude or metres, got {} × {}, too far out for degrees and too "
                                 "small for metres; set outline_units",
                                 size.x, size.y));
  }
  if (origin) return {*origin, vec2{mm, mm}, false};
  const double limit = geometry::largest_coordinate_mm / mm;
  const double metre = 1000.0 / mm;
  const bool near = box.low.x >= -limit && box.low.y >= -limit && box.high.x <= limit && box.high.y <= limit;
  if (near) return {vec2{0.0, 0.0}, vec2{mm, mm}, false};
  const vec2 middle = 0.5 * (box.low + box.high);
  return {vec2{std::round(middle.x / metre) * metre, std::round(middle.y / metre) * metre}, vec2{mm, mm}, false};
}

}  // namespace

vec2 PlanFrame::operator()(vec2 p) const {
  vec2 from_origin = p - origin;
  if (degrees) from_origin.x = short_way_round(from_origin.x);
  return from_origin * mm_per_unit;
}

Ring PlanFrame::operator()(const Ring& ring) const {
  Ring result = ring;
  for (vec2& p : result.points_mm) p = (*this)(p);
  return result;
}

PlanUnits units_of(const Plan& plan) {
  if (plan.svg) return PlanUnits::millimetres;
  if (plan.units) return *plan.units;
  const bool degrees = std::ranges::all_of(plan.shapes, [](const PlanShape& shape) {
    return std::ranges::all_of(shape.rings,
                               [](const Ring& ring) { return std::ranges::all_of(ring.points_mm, could_be_degrees); });
  });
  return degrees ? PlanUnits::degrees : PlanUnits::metres;
}

PlanFrame frame_of(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units,
                   std::optional<vec2> origin) {
  if (plan.svg) return {};
  switch (units.value_or(units_of(plan))) {
    case PlanUnits::degrees:
      return frame_of_degrees(plan, shapes, origin);
    case PlanUnits::metres:
      return frame_of_lengths(plan, shapes, 1000.0, !units && !plan.units, origin);
    case PlanUnits::millimetres:
      break;
  }
  return frame_of_lengths(plan, shapes, 1.0, false, origin);
}

}  // namespace shatterpave::scene
