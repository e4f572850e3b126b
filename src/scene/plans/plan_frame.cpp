#include "scene/plans/plan_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"

namespace shatterpave::scene {

namespace {

// What is called metres for want of degrees and is smaller than a hand is something else, such as degrees with latitude first.
constexpr double smallest_guessed_m = 0.1;

// Longitudes are counted on over 180, also several times round; beyond that they are something else.
constexpr double most_turns = 10.0;

geometry::Box grown(geometry::Box box, vec2 p) { return {glm::min(box.low, p), glm::max(box.high, p)}; }

bool could_be_degrees(vec2 p) { return p.x >= -180.0 && p.x <= 180.0 && p.y >= -90.0 && p.y <= 90.0; }
bool could_be_degrees_counted_on(vec2 p) { return p.x >= -360.0 && p.x <= 360.0 && p.y >= -90.0 && p.y <= 90.0; }

// Exact, as the remainder is.
double short_way_round(double longitude, double full_turn) {
  return full_turn > 0.0 ? std::remainder(longitude, full_turn) : longitude;
}

double full_turn(const PlanUnits& units) { return units.kind == PlanUnits::Kind::angle ? 360.0 / units.size : 0.0; }

// All positions of the shapes, longitudes next to that of the first one.
geometry::Box box_of(const Plan& plan, const std::vector<std::size_t>& shapes, double full_turn) {
  const vec2 first = plan.shapes[shapes.front()].rings.front().points_mm.front();
  geometry::Box box{first, first};
  for (const std::size_t shape : shapes) {
    for (const Ring& ring : plan.shapes[shape].rings) {
      for (const vec2& p : ring.points_mm) {
        box = grown(box, full_turn > 0.0 ? vec2{first.x + short_way_round(p.x - first.x, full_turn), p.y} : p);
      }
    }
  }
  return box;
}

PlanFrame frame_of_angles(const Plan& plan, const std::vector<std::size_t>& shapes, const PlanUnits& units,
                          std::optional<vec2> origin) {
  const double turn = full_turn(units);
  const geometry::Box box = box_of(plan, shapes, turn);
  const vec2 middle = 0.5 * (box.low + box.high);
  const vec2 at = origin.value_or(vec2{short_way_round(middle.x, turn), middle.y});
  const vec2 scale = units.size * mm_per_degree(at.y * units.size, units);
  const vec2 size = (box.high - box.low) * scale;
  if (std::max(size.x, size.y) > 2.0 * geometry::largest_coordinate_mm) {
    throw InputError(plan.shapes[shapes.front()].rings.front().place,
                     fmt::format("expected an area of at most 2 km, got {:.0f} km × {:.0f} km; if these are no degrees, "
                                 "set outline_units",
                                 size.x * 1e-6, size.y * 1e-6));
  }
  return {at, scale, turn};
}

// To what the origin is rounded: whole metres, or whole feet and the like.
double origin_step(double mm) {
  const double metre = 1000.0 / mm;
  return metre > 100.0 ? metre : std::min(1.0, metre);
}

PlanFrame frame_of_lengths(const Plan& plan, const std::vector<std::size_t>& shapes, double mm, bool guessed,
                           std::optional<vec2> origin) {
  const geometry::Box box = box_of(plan, shapes, 0.0);
  const vec2 size = box.high - box.low;
  if (guessed && std::max(size.x, size.y) * mm < smallest_guessed_m * 1000.0) {
    throw InputError(plan.shapes[shapes.front()].rings.front().place,
                     fmt::format("expected longitude and latitude or metres, got {} × {}, too far out for degrees and too "
                                 "small for metres; set outline_units",
                                 size.x, size.y));
  }
  if (origin) return {*origin, vec2{mm, mm}, 0.0};
  const double limit = geometry::largest_coordinate_mm / mm;
  const bool near = box.low.x >= -limit && box.low.y >= -limit && box.high.x <= limit && box.high.y <= limit;
  if (near) return {vec2{0.0, 0.0}, vec2{mm, mm}, 0.0};
  const vec2 middle = 0.5 * (box.low + box.high);
  const double step = origin_step(mm);
  return {vec2{std::round(middle.x / step) * step, std::round(middle.y / step) * step}, vec2{mm, mm}, 0.0};
}

// Of the plan's areas and lines.
bool all_smaller_than_a_hand(const Plan& plan) {
  bool any = false;
  for (std::size_t i = 0; i < plan.shapes.size(); ++i) {
    if (plan.shapes[i].kind == ShapeKind::point || plan.shapes[i].fault) continue;
    const geometry::Box box = box_of(plan, {i}, 360.0);
    if (std::max(box.high.x - box.low.x, box.high.y - box.low.y) >= smallest_guessed_m) return false;
    any = true;
  }
  return any;
}

template <typename Test>
bool all_positions(const Plan& plan, const Test& test) {
  return std::ranges::all_of(plan.shapes, [&](const PlanShape& shape) {
    return std::ranges::all_of(shape.rings, [&](const Ring& ring) { return std::ranges::all_of(ring.points_mm, test); });
  });
}

}  // namespace

vec2 PlanFrame::operator()(vec2 p) const {
  vec2 from_origin = p - origin;
  from_origin.x = short_way_round(from_origin.x, full_turn);
  return from_origin * mm_per_unit;
}

Ring PlanFrame::operator()(const Ring& ring) const {
  Ring result = ring;
  for (vec2& p : result.points_mm) p = (*this)(p);
  return result;
}

bool alike(const PlanUnits& a, const PlanUnits& b) {
  constexpr double rounding = 1e-9;
  return a.kind == b.kind && std::abs(a.size - b.size) <= rounding * b.size;
}

PlanUnits units_of(const Plan& plan) {
  if (plan.svg) return PlanUnits::millimetres;
  if (plan.no_units) throw InputError(*plan.no_units);
  if (plan.units) return *plan.units;
  if (all_positions(plan, could_be_degrees)) return PlanUnits::degrees;
  const bool counted_on = all_positions(plan, could_be_degrees_counted_on) && all_smaller_than_a_hand(plan);
  return counted_on ? PlanUnits::degrees : PlanUnits::metres;
}

vec2 mm_per_degree(double latitude_deg, const PlanUnits& units) {
  const double squared_eccentricity = units.flattening * (2.0 - units.flattening);
  const double latitude = latitude_deg * (pi / 180.0);
  const double s = sine(latitude);
  const double w = 1.0 - squared_eccentricity * s * s;
  const double prime_vertical_m = units.semi_major_axis_m / std::sqrt(w);
  const double meridian_m = units.semi_major_axis_m * (1.0 - squared_eccentricity) / (w * std::sqrt(w));
  return vec2{prime_vertical_m * cosine(latitude), meridian_m} * (1000.0 * pi / 180.0);
}

std::optional<InputError> fault_of(const PlanShape& shape, const PlanUnits& units) {
  if (shape.fault || units.kind == PlanUnits::Kind::length) return shape.fault;
  for (const Ring& ring : shape.rings) {
    for (const vec2& p : ring.points_mm) {
      const vec2 degrees = p * units.size;
      if (std::abs(degrees.y) <= 90.0 && std::abs(degrees.x) <= 360.0 * most_turns) continue;
      return InputError(ring.place,
                        fmt::format("expected longitudes, which count modulo {}, and latitudes from {} to {}, got ({}, {})",
                                    360.0 / units.size, -90.0 / units.size, 90.0 / units.size, p.x, p.y));
    }
  }
  return std::nullopt;
}

PlanFrame frame_of(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units,
                   std::optional<vec2> origin) {
  if (plan.svg) return {};
  const PlanUnits used = units ? *units : units_of(plan);
  for (const std::size_t shape : shapes) {
    if (const auto fault = fault_of(plan.shapes[shape], used)) throw InputError(*fault);
  }
  if (used.kind == PlanUnits::Kind::angle) return frame_of_angles(plan, shapes, used, origin);
  return frame_of_lengths(plan, shapes, used.size * 1000.0, !units && !plan.units, origin);
}

}  // namespace shatterpave::scene
