#include "glass/dicing/dice_shape.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "core/smooth_step.h"

namespace shatterpave::glass {

namespace {

constexpr double square_mm2 = 50.0 * 50.0;

// The map is told at these steps of ln r, from this distance on; nearer it only scales.
constexpr double log_step = 0.02;
constexpr double least_distance_mm = 0.01;

// Where splinters begin and end, in units of their reach, and how fine fragments are at the impact. By eye, beside photographs
// of panels of 150 × 100 × 3 mm that a steel ball broke.
constexpr double rise = 0.06;
constexpr double full_to = 0.6;
constexpr double gone_at = 1.4;

// Splinters branch on their way out, so that the cracks between them stay as far apart as they are near the impact: 1.75 mm in
// those photographs, from 5 to 40 mm from it, where a fragment far out is as large as a square of 10.5 mm. So much of the side
// of that square, for splinters 7 times as long as wide.
constexpr double splinter_spacing = 1.75 / 10.5;
constexpr double usual_ratio = 7.0;
// A circle about the impact meets more splinters than stand side by side on it, since the ends of those before and behind
// overlap: by this part of their length. By the counts of cracks.
constexpr double splinter_overlap = 0.55;
constexpr double narrow_to = 0.5;

// Far out fragments are still longer than wide along the way that the cracks came, 1.5 to 2 times in the photograph of a crazed
// pane of elimcfadden.github.io (shattered-glass-hero). By eye.
constexpr double usual_far_ratio = 1.7;

double between(double low, double high, double share) { return low + (high - low) * std::clamp(share, 0.0, 1.0); }

// Thin panes have long splinters, thick ones none to speak of. By eye: 7 at 3 mm, as in those photographs.
double default_ratio(double thickness_mm) { return std::clamp(1.0 + 18.0 / thickness_mm, 1.0, 10.0); }

}  // namespace

double least_fragment_count(double thickness_mm) {
  if (thickness_mm < 12.0) return between(15.0, 40.0, thickness_mm - 3.0);
  return between(40.0, 30.0, (thickness_mm - 12.0) / 3.0);
}

double fragment_count(const Pane& pane, const Tempered& glass) {
  if (glass.count_per_square) return *glass.count_per_square;
  const double stress = glass.surface_stress_mpa / 100.0;
  return std::clamp(1.5 * least_fragment_count(pane.thickness_mm) * stress * stress * stress * stress, 1.0, square_mm2);
}

DiceShape::DiceShape(const Pane& pane, const Tempered& glass, vec2 impact_mm, double reach_mm)
    : impact_mm_(impact_mm),
      side_mm_(std::sqrt(square_mm2 / fragment_count(pane, glass))),
      greatest_ratio_(glass.splinter_ratio.value_or(default_ratio(pane.thickness_mm))),
      far_ratio_(std::min(greatest_ratio_, usual_far_ratio)),
      splinter_reach_mm_(glass.splinter_reach_mm) {
  const double log_reach = logarithm(std::max(reach_mm, 2.0 * least_distance_mm));
  const double log_least = logarithm(least_distance_mm);
  const auto count = static_cast<std::size_t>((log_reach - log_least) / log_step) + 2;
  log_images_.resize(count);
  // From the outside in, so that the map keeps lengths there.
  double log_r = log_least + log_step * static_cast<double>(count - 1);
  log_images_.back() = log_r;
  for (std::size_t i = count - 1; i > 0; --i) {
    const double middle = exponential(log_r - 0.5 * log_step);
    log_images_[i - 1] = log_images_[i] - log_step / ratio(middle);
    log_r -= log_step;
  }
}

// Length to width.
double DiceShape::ratio(double r_mm) const {
  const double x = r_mm / splinter_reach_mm_;
  const double gone = smooth_step((x - full_to) / (gone_at - full_to));
  return (1.0 + (greatest_ratio_ - 1.0) * smooth_step(x / rise)) * (1.0 - gone) + far_ratio_ * gone;
}

double DiceShape::splinter_spacing_mm() const { return splinter_spacing * std::sqrt(usual_ratio / greatest_ratio_) * side_mm_; }

double DiceShape::far_share(double r_mm) const {
  return smooth_step((r_mm / splinter_reach_mm_ - narrow_to) / (gone_at - narrow_to));
}

// Narrow as far as splinters reach; far out a fragment has its area.
double DiceShape::width_mm(double r_mm) const {
  const double spacing = splinter_spacing_mm() / side_mm_;
  const double overlap_mm = splinter_overlap * spacing * side_mm_ * greatest_ratio_;
  const double near = std::min(spacing * (1.0 + overlap_mm / std::max(r_mm, spacing * side_mm_)), 1.0);
  return side_mm_ * (near + (1.0 / std::sqrt(far_ratio_) - near) * far_share(r_mm));
}

double DiceShape::length_mm(double r_mm) const { return width_mm(r_mm) * ratio(r_mm); }

double DiceShape::log_image(double log_r) const {
  const double at = std::max((log_r - logarithm(least_distance_mm)) / log_step, 0.0);
  const std::size_t i = std::min(static_cast<std::size_t>(at), log_images_.size() - 2);
  return log_images_[i] + (at - static_cast<double>(i)) * (log_images_[i + 1] - log_images_[i]);
}

double DiceShape::unfolded_width(double r_mm) const {
  const double r = std::max(r_mm, least_distance_mm);
  const double log_r = logarithm(r);
  return width_mm(r) * exponential(log_image(log_r) - log_r);
}

vec2 DiceShape::unfolded(vec2 p_mm) const {
  const vec2 way = p_mm - impact_mm_;
  const double log_r = logarithm(std::max(glm::length(way), least_distance_mm));
  return way * exponential(log_image(log_r) - log_r);
}

vec2 DiceShape::folded(vec2 q) const {
  const double length = glm::length(q);
  const double log_least = logarithm(least_distance_mm);
  const double log_q = std::max(length > 0.0 ? logarithm(length) : log_images_.front(), log_images_.front());
  const auto above = std::upper_bound(log_images_.begin() + 1, log_images_.end() - 1, log_q);
  const std::size_t i = static_cast<std::size_t>(above - log_images_.begin()) - 1;
  const double part = (log_q - log_images_[i]) / (log_images_[i + 1] - log_images_[i]);
  const double log_r = log_least + log_step * (static_cast<double>(i) + part);
  return impact_mm_ + q * exponential(log_r - log_q);
}

}  // namespace shatterpave::glass
