#include "paving/steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "core/error.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "paving/bond_courses.h"
#include "paving/finishes.h"
#include "paving/stone_surface.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;
using geometry::Region;

constexpr double widest_joint_mm = 6.0;  // blocks are set close
constexpr double least_last = 0.05;      // of a tread
constexpr double least_rest = 1e-6;      // of the area: less is rounding
constexpr double sliver_mm2 = 1.0;       // smaller parts of a step are rounding
// Corners of a round front: its chords stay within 0.3 mm of a circle of 4 m.
constexpr int corners_of_circle = 256;

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
    Polygon result;
    for (int i = 0; i < corners_of_circle; ++i) {
      const Angle angle = Angle::degrees(360.0 * i / corners_of_circle);
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

// The parts of the area between one front and the next.
std::vector<std::vector<Region>> strips(const Fronts& fronts, const Region& area, double tread_mm) {
  std::vector<std::vector<Region>> result;
  std::vector<Region> before;
  const double all = geometry::area(area);
  for (int k = 0; total(before) < (1.0 - least_rest) * all; ++k) {
    std::vector<Region> next = fronts.before((k + 1) * tread_mm);
    if (total(fronts.before((k + 1 + least_last) * tread_mm)) >= (1.0 - least_rest) * all) next = {area};
    std::vector<Region>& strip = result.emplace_back();
    for (const Region& region : next) {
      for (Region& part : geometry::difference(region, before)) {
        if (geometry::area(part) > sliver_mm2) strip.push_back(std::move(part));
      }
    }
    before = std::move(next);
  }
  return result;
}

// One row of blocks, but for its area, name and height.
Pavement blocks(const Pavement& pavement, const Flight& flight) {
  Pavement result = pavement;
  result.kerb = {};
  result.border = {};
  result.joint_mm = std::min({pavement.joint_mm, widest_joint_mm, 0.5 * flight.tread_mm});
  result.stone_mm.y = flight.tread_mm - result.joint_mm;
  if (result.bonding.bond != Bond::stack) result.bonding.bond = Bond::running;
  result.variation = {};
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
  if (std::holds_alternative<BoundaryDirection>(step.direction)) {
    step.bonding.bond = step.area.holes.empty() ? Bond::running : Bond::course;
  }
  if (auto* radial = std::get_if<RadialDirection>(&step.direction)) {
    radial->first_mm = front_mm;
    // Stones are straight along their backs, the next front is round: they reach beyond it, and are cut.
    const double sag_mm = 0.125 * step.stone_mm.x * step.stone_mm.x / std::max(front_mm, step.stone_mm.x);
    step.stone_mm.y = tread_mm - step.joint_mm + 1.5 * sag_mm;
  }
}

}  // namespace

std::vector<Pavement> steps(const Pavement& pavement, const Flight& flight) {
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
    const double moved = static_cast<double>(k) * step.bonding.offset;
    step.bonding.start = step.bonding.bond == Bond::stack ? 0.0 : moved - std::floor(moved);
    for (const Region& part : parts[k]) {
      step.area = part;
      lay_row(step, fronts.first_mm() + static_cast<double>(k) * flight.tread_mm, flight.tread_mm);
      result.push_back(step);
    }
  }
  return result;
}

}  // namespace shatterpave::paving
