#include "glass/shards/lean.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "core/functions.h"
#include "core/smooth_step.h"
#include "geometry/segment_distance.h"

namespace shatterpave::glass {

namespace {

// The field takes at most this from the distance of two places, by the greatest slopes that it can have.
constexpr double most_shrinking = 0.75;
// From upright to leaning, in thicknesses. By eye.
constexpr double reach_thicknesses = 6.0;
// A smooth step is no steeper than this.
constexpr double steepest_step = 1.5;
// The longest side between two vertices, in lengths of twist: so that no wave lies between them.
constexpr double longest_twists = 0.12;

double slope_of(Angle angle) { return sine(angle.radians()) / cosine(angle.radians()); }

}  // namespace

Lean::Lean(const Pane& pane, std::uint64_t seed, double part)
    : tilt_slope_(slope_of(pane.crack_sheet.tilt)),
      curve_slope_(slope_of(pane.crack_sheet.curve)),
      half_mm_(0.5 * pane.thickness_mm),
      twist_mm_(pane.crack_sheet.twist_mm),
      reach_mm_(reach_thicknesses * pane.thickness_mm),
      outline_(pane.outline_mm),
      id_(Id(pane.name).child("lean")),
      seed_(seed) {
  if (!pane.shards || !pane.shards->leaning) return;
  for (const Impact& impact : pane.impacts) impacts_.push_back(impact.at_mm);
  // Two values of the noise, each in [-1, 1] with knots a twist apart, along two axes; and the way to edge and impact.
  const double farthest_mm = tilt_slope_ * half_mm_ + curve_slope_ * half_mm_ / 3.0;
  const double steepest = farthest_mm * steepest_step * (4.0 / twist_mm_ + 2.0 * std::sqrt(2.0) / reach_mm_);
  strength_ = farthest_mm == 0.0 ? 0.0 : part * std::min(1.0, most_shrinking / steepest);
}

vec2 Lean::noise(Stream stream, vec2 at_mm) const {
  const vec2 place = at_mm / twist_mm_;
  const vec2 whole = glm::floor(place);
  const vec2 step{smooth_step(place.x - whole.x), smooth_step(place.y - whole.y)};
  const auto knot = [&](double i, double j) {
    const auto number = [](double at) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(at)); };
    const Id knot_id = id_.child(number(whole.x + i)).child(number(whole.y + j));
    return vec2{2.0 * uniform(seed_, {stream, knot_id, 0}) - 1.0, 2.0 * uniform(seed_, {stream, knot_id, 1}) - 1.0};
  };
  return glm::mix(glm::mix(knot(0, 0), knot(1, 0), step.x), glm::mix(knot(0, 1), knot(1, 1), step.x), step.y);
}

double Lean::upright_share(vec2 at_mm) const {
  double edge_mm = reach_mm_;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    edge_mm = std::min(edge_mm, geometry::distance_to_segment(at_mm, outline_[i], outline_[(i + 1) % outline_.size()]));
  }
  double impact_mm = reach_mm_;
  for (const vec2 impact : impacts_) impact_mm = std::min(impact_mm, glm::length(at_mm - impact));
  return 1.0 - smooth_step(edge_mm / reach_mm_) * smooth_step(impact_mm / reach_mm_);
}

vec2 Lean::aside_mm(vec2 at_mm, double z_mm) const {
  if (is_upright()) return {0.0, 0.0};
  const double share = strength_ * (1.0 - upright_share(at_mm));
  if (share == 0.0) return {0.0, 0.0};
  const double bow = 0.5 * z_mm * z_mm / half_mm_ - half_mm_ / 6.0;
  return share *
         (tilt_slope_ * z_mm * noise(Stream::crack_tilt, at_mm) + curve_slope_ * bow * noise(Stream::crack_curve, at_mm));
}

bool Lean::is_straight(vec2 a, vec2 b, double bound_mm) const {
  if (glm::length(b - a) > longest_twists * twist_mm_) return false;
  for (const double z : {-half_mm_, half_mm_}) {
    const vec2 at_a = aside_mm(a, z);
    const vec2 at_b = aside_mm(b, z);
    for (const double t : {0.25, 0.5, 0.75}) {
      if (glm::length(aside_mm(glm::mix(a, b, t), z) - glm::mix(at_a, at_b, t)) > bound_mm) return false;
    }
  }
  return true;
}

geometry::Polygon Lean::followed(const geometry::Polygon& ring, std::vector<bool>& is_old, double bound_mm) const {
  geometry::Polygon result;
  std::vector<bool> result_is_old;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const vec2 a = ring[i];
    const vec2 b = ring[(i + 1) % ring.size()];
    // Halved alike from end to end until all parts are straight.
    int parts = 1;
    const auto all_straight = [&] {
      for (int k = 0; k < parts; ++k) {
        if (!is_straight(glm::mix(a, b, static_cast<double>(k) / parts), glm::mix(a, b, static_cast<double>(k + 1) / parts),
                         bound_mm)) {
          return false;
        }
      }
      return true;
    };
    constexpr double least_mm = 0.1;
    while (!is_old[i] && glm::length(b - a) > least_mm * parts && !all_straight()) parts *= 2;
    for (int k = 0; k < parts; ++k) {
      result.push_back(glm::mix(a, b, static_cast<double>(k) / parts));
      result_is_old.push_back(is_old[i]);
    }
  }
  is_old = std::move(result_is_old);
  return result;
}

}  // namespace shatterpave::glass
