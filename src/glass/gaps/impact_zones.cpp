#include "glass/gaps/impact_zones.h"

#include <algorithm>
#include <span>
#include <vector>

#include "core/functions.h"
#include "core/random.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

namespace {

// The zone about an impact: in thicknesses, and room on its ring for each radial (mm).
constexpr double zone_thicknesses = 1.5;
constexpr double ring_room_mm = 0.12;
// How much wider a hole is on the far side, in thicknesses, where a scene does not say; and what is left about it.
constexpr double spall_thicknesses = 4.5;
constexpr double shot_hole_clearance_mm = 0.05;
// A hole for which there is less room is none: its wall would be made of points that fall together on the lattice.
constexpr double least_hole_radius_mm = 0.05;

// A polygon about a circle.
Pieces ring(vec2 centre, double radius_mm) {
  constexpr int sides = 64;
  Pieces pieces;
  const auto corner = [&](int k) {
    const SineAndCosine turn = sine_and_cosine(2.0 * pi * k / sides);
    return centre + radius_mm / cosine(pi / sides) * vec2{turn.cosine, turn.sine};
  };
  for (int k = 0; k < sides; ++k) pieces.emplace_back(corner(k), corner(k + 1));
  return pieces;
}

ShotHoleShape shot_hole_shape(const Pane& pane, const Impact& impact, double limit_mm) {
  const double spall = impact.spall_mm.value_or(impact.hole_mm + spall_thicknesses * pane.thickness_mm);
  ShotHoleShape shape{impact.at_mm, pane.thickness_mm, 0.5 * impact.hole_mm, 0.5 * std::max(spall, impact.hole_mm)};
  const double widest = widest_mm(shape, -0.5 * pane.thickness_mm) + shot_hole_clearance_mm;
  const double scale = std::min(1.0, limit_mm / widest);
  shape.hole_radius_mm *= scale;
  shape.spall_radius_mm *= scale;
  return shape;
}

}  // namespace

void add_zones(const Pane& pane, const CrackNetwork& network, std::uint64_t seed, CrackSurfaces& result) {
  std::vector<int> radials(network.impacts.size(), 0);
  for (const Crack& crack : network.cracks) {
    if (crack.start.at == CrackEnd::At::impact) ++radials[static_cast<std::size_t>(crack.impact)];
  }
  const std::vector<double> limits = zone_limits_mm(pane, network);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double wanted = std::max(zone_thicknesses * pane.thickness_mm, ring_room_mm * radials[i] / (2.0 * pi));
    const double radius = std::min(wanted, limits[i]);
    result.zones.push_back({network.impacts[i].at_mm, radius, radius});
    if (i >= pane.impacts.size() || pane.impacts[i].hole_mm == 0.0) continue;
    const ShotHoleShape shape = shot_hole_shape(pane, pane.impacts[i], limits[i]);
    if (shape.hole_radius_mm < least_hole_radius_mm) continue;
    result.shot_holes.push_back(shot_hole(shape, seed, Id(pane.name).child("shot_hole").child(i)));
    result.zones.back().radius_mm = widest_mm(shape, -0.5 * pane.thickness_mm) + shot_hole_clearance_mm;
    result.zones.back().start_mm = widest_mm(shape, 0.5 * pane.thickness_mm) + shot_hole_clearance_mm;
  }
}

void leave_out_later(std::size_t impacts, CrackSurfaces& surfaces) {
  const auto zones_left = std::span(surfaces.zones).first(impacts);
  std::erase_if(surfaces.shot_holes, [&](const ShotHole& hole) {
    return std::ranges::none_of(zones_left, [&](const ImpactZone& zone) { return zone.centre_mm == hole.shape.centre_mm; });
  });
  surfaces.zones.resize(impacts);
}

Barrier rim_of(const CrackSurfaces& impacts, const ImpactZone& zone) {
  const auto has_its_centre = [&](const ShotHole& shot_hole) { return shot_hole.shape.centre_mm == zone.centre_mm; };
  const auto found = std::ranges::find_if(impacts.shot_holes, has_its_centre);
  if (found == impacts.shot_holes.end()) {
    return {[rim = ring(zone.centre_mm, zone.radius_mm)](double) { return rim; }};
  }
  return {[shape = found->shape](double z) { return ring(shape.centre_mm, widest_mm(shape, z) + shot_hole_clearance_mm); },
          true};
}

}  // namespace shatterpave::glass
