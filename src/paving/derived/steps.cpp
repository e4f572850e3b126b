#include "paving/derived/steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/courses.h"
#include "paving/bonds/table.h"
#include "paving/catalogue/finishes.h"
#include "paving/catalogue/stone_sizes.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;
using geometry::Region;

constexpr double least_last = 0.05;  // of a tread
constexpr double least_rest = 1e-6;  // of the area: less is rounding
constexpr double sliver_mm2 = 1.0;   // smaller parts of a step are rounding
constexpr double chord_mm = 0.1;     // how far chords of round fronts stray from their circle

// Fronts of steps: parallel lines over the area. Distances are from the first front, mm.
class Fronts {
 public:
  // Both must outlive this.
  Fronts(const Region& area, const Direction& direction) : area_(area), direction_(direction) {
    const geometry::Box box = geometry::bounding_box(area.outline);
    far_mm_ = glm::length(box.high - box.low);
    if (const auto* constant = std::get_if<ConstantDirection>(&direction)) {
      along_ = constant->angle.direction();
      const auto across = [&](vec2 p) { return glm::dot(p, left_of(along_)); };
      first_ = *std::ranges::min_element(area.outline, {}, across);
    } else if (const auto* radial = std::get_if<RadialDirection>(&direction)) {
      const geometry::RegionIndex index(area);
      first_mm_ = index.contains(radial->centre_mm) ? 0.0 : index.nearest(radial->centre_mm).distance_mm;
    } else if (const auto* guides = std::get_if<GuidesDirection>(&direction)) {
      guides_ = extended_guides(*guides, box);
    }
  }

  // Of the first circle, where fronts are circles.
  double first_mm() const { return first_mm_; }

  // What lies before the front at that distance > 0.
  std::vector<Region> before(double distance) const {
    if (std::holds_alternative<ConstantDirection>(direction_)) return geometry::intersection(half_plane(distance), area_);
    if (const auto* radial = std::get_if<RadialDirection>(&direction_)) {
      return geometry::intersection(circle(radial->centre_mm, first_mm_ + distance), area_);
    }
    if (std::holds_alternative<BoundaryDirection>(direction_)) {
      return geometry::difference(area_, geometry::offset(area_, -distance));
    }
    std::vector<Region> result;
    for (const Region& region : geometry::thickened(guides_, distance)) {
      for (Region& part : geometry::intersection(area_, region)) result.push_back(std::move(part));
    }
    return result;
  }

 private:
  static Polygon circle(vec2 centre, double radius) {
    // 1 − cos(π / n) is nearly (π / n)² / 2.
    const int corners = static_cast<int>(std::clamp(pi * std::sqrt(radius / (2.0 * chord_mm)), 64.0, 20'000.0));
    Polygon result;
    for (int i = 0; i < corners; ++i) {
      const Angle angle = Angle::degrees(360.0 * i / corners);
      result.push_back(geometry::on_lattice(centre + radius * angle.direction()));
    }
    return result;
  }
  Polygon half_plane(double distance) const {
    const vec2 sideways = (far_mm_ + distance) * along_;
    const vec2 back = first_ - left_of(sideways);
    const vec2 front = first_ + distance * left_of(along_);
    return {geometry::on_lattice(back - sideways), geometry::on_lattice(back + sideways),
            geometry::on_lattice(front + sideways), geometry::on_lattice(front - sideways)};
  }

  const Region& area_;
  const Direction& direction_;
  double far_mm_ = 0.0;
  vec2 along_{1.0, 0.0};
  vec2 first_{0.0, 0.0};  // a point of the first front, where fronts are straight
  double first_mm_ = 0.0;
  std::vector<std::vector<vec2>> guides_;
};

double total(const std::vector<Region>& regions) {
  double result = 0.0;
  for (const Region& region : regions) result += geometry::area(region);
  return result;
}

std::vector<Region> between(const std::vector<Region>& before, const std::vector<Region>& next) {
  std::vector<Region> parts;
  for (const Region& region : next) {
    for (Region& part : geometry::difference(region, before)) {
      if (geometry::area(part) > sliver_mm2) parts.push_back(std::move(part));
    }
  }
  return parts;
}

// The parts of the area between one front and the next.
std::vector<std::vector<Region>> strips(const Fronts& fronts, const Region& area, double tread_mm) {
  std::vector<std::vector<Region>> before{{}};
  const double most = (1.0 - least_rest) * geometry::area(area);
  while (total(before.back()) < most) before.push_back(fronts.before(static_cast<double>(before.size()) * tread_mm));
  const std::size_t count = before.size() - 1;
  // A last one that is hardly a step is part of the one before it.
  if (count > 1 && total(fronts.before((static_cast<double>(count - 1) + least_last) * tread_mm)) >= most) before.pop_back();
  before.back() = {area};
  std::vector<std::vector<Region>> result;
  for (std::size_t k = 0; k + 1 < before.size(); ++k) result.push_back(between(before[k], before[k + 1]));
  return result;
}

// One row of blocks, but for its area, name and height.
Pavement blocks(const Pavement& pavement, const Flight& flight) {
  Pavement result = pavement;
  result.flight.reset();
  result.kerb = {};
  result.border = {};
  result.joint_mm = std::min({pavement.joint_mm, widest_block_joint_mm, 0.5 * flight.tread_mm});
  result.stone_mm.y = flight.tread_mm - result.joint_mm;
  if (type_of(result).bending != Bending::rows) result.bonding.bond = Bond::running;
  result.variation = {};
  result.hand = {};
  result.look.colours = {};
  result.variation.tilt = Angle();
  if (result.body.finish == Finish::none) {
    const FinishPreset& preset = preset_of(Finish::bush_hammered);
    result.body = preset.body;
    result.relief = preset.relief;
  }
  result.surface.height_spread = 0.0;
  result.surface.height_mm = std::abs(flight.riser_mm);
  result.ground.settlement_mm = 0.0;
  return result;
}

// Sets the row of `step` to its area, whose front is `front_mm` from where fronts begin.
void lay_row(Pavement& step, double front_mm, double tread_mm) {
  if (auto* radial = std::get_if<RadialDirection>(&step.direction)) {
    radial->first_mm = front_mm;
    // A ring of six stones or more. They are straight along their backs, the next front is round: they reach beyond it, and
    // are cut.
    step.stone_mm.x = std::min(step.stone_mm.x, front_mm + 0.5 * tread_mm);
    const double sag_mm = 0.125 * step.stone_mm.x * step.stone_mm.x / std::max(front_mm, step.stone_mm.x);
    step.stone_mm.y = tread_mm - step.joint_mm + 1.5 * sag_mm;
  }
  if (std::holds_alternative<BoundaryDirection>(step.direction)) {
    step.bonding.bond = Bond::course;
    if (step.area.holes.empty()) {
      // The last step, less than two treads wide.
      step.bonding.bond = Bond::running;
      step.direction = ConstantDirection{main_direction(step)};
    }
  }
  // What is left over in a corner is a stone of its own.
  const geometry::Box box = geometry::bounding_box(step.area.outline);
  step.stone_mm = glm::min(step.stone_mm, vec2(std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1.0})));
}

}  // namespace

std::vector<Pavement> steps(const Pavement& pavement) {
  ENSURE(pavement.flight);
  const Flight& flight = *pavement.flight;
  ENSURE(flight.tread_mm > 0.0 && flight.riser_mm != 0.0);
  const Fronts fronts(pavement.area, pavement.direction);
  const std::vector<std::vector<Region>> parts = strips(fronts, pavement.area, flight.tread_mm);
  const double foot_mm = std::min(0.0, static_cast<double>(parts.size()) * flight.riser_mm);
  std::vector<Pavement> result;
  Pavement step = blocks(pavement, flight);
  double rise_mm = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    rise_mm += flight.riser_mm;
    step.ground.level_mm = pavement.ground.level_mm + rise_mm + face_mm(pavement) - face_mm(step);
    step.ground.depth_mm = pavement.ground.depth_mm + std::max(0.0, rise_mm - foot_mm);
    const double moved = type_of(step).takes_offset ? static_cast<double>(k) * step.bonding.offset : 0.0;
    step.bonding.start = moved - std::floor(moved);
    for (const Region& part : parts[k]) {
      Pavement& one = result.emplace_back(step);
      one.area = part;
      lay_row(one, fronts.first_mm() + static_cast<double>(k) * flight.tread_mm, flight.tread_mm);
    }
  }
  return result;
}

}  // namespace shatterpave::paving
