#include "glass/breaking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/overloaded.h"
#include "core/random.h"
#include "glass/dicing/dice.h"
#include "glass/growth/growth.h"
#include "glass/map/growth_clock.h"
#include "glass/sheets.h"

namespace shatterpave::glass {

namespace {

void require_impacts_inside(const Pane& pane) {
  for (std::size_t i = 0; i < pane.impacts.size(); ++i) {
    const vec2 at = pane.impacts[i].at_mm;
    if (geometry::contains_strictly(pane.outline_mm, at)) continue;
    throw InputError(Place{"", 0, 0, fmt::format("{}.impact[{}].at_mm", pane.name, i)},
                     fmt::format("expected a point inside the outline, got ({}, {})", at.x, at.y));
  }
}

// Before anything divides by its sides.
void require_bendable(const Pane& pane) {
  const geometry::Bend bend = bend_of(pane);
  if (bend.is_flat()) return;
  const Place place{"", 0, 0, pane.name + ".bow_mm"};
  const vec2 most = glm::min(2.0 * most_bow * bend.half_mm, vec2(most_bow_mm));
  if (std::abs(pane.bow_mm.x) > most.x || std::abs(pane.bow_mm.y) > most.y) {
    throw InputError(place, fmt::format("expected at most {:.6g} across and {:.6g} along, a tenth of the pane and {:g} mm, got "
                                        "({}, {})",
                                        most.x, most.y, most_bow_mm, pane.bow_mm.x, pane.bow_mm.y));
  }
  const double part = 0.5 * pane.thickness_mm * bend.curvature_per_mm();
  if (part <= most_bend_of_thickness) return;
  throw InputError(place, fmt::format("expected a radius of at least {:g} half thicknesses, got {:.3g}",
                                      1.0 / most_bend_of_thickness, 1.0 / part));
}

void require_film(const Pane& pane) {
  const auto* laminated = std::get_if<Laminated>(&pane.glass);
  if (laminated == nullptr || !laminated->film_mm || *laminated->film_mm <= 0.5 * pane.thickness_mm) return;
  throw InputError(
      Place{"", 0, 0, pane.name + ".laminate.film_mm"},
      fmt::format("expected at most half the thickness, {:.6g} mm, got {}", 0.5 * pane.thickness_mm, *laminated->film_mm));
}

// Which cracks of laminated glass run through both sheets.
void draw_through(const Pane& pane, double part, std::uint64_t seed, CrackNetwork& network) {
  const Id id = Id(pane.name).child("through");
  for (Crack& crack : network.cracks) {
    const Address address{Stream::through, id.child(static_cast<std::uint64_t>(crack.id))};
    crack.through = crack.through && uniform(seed, address) < part;
  }
}

// The far sheet as a pane: with so many fewer cracks, and draws of its own.
Pane far_pane(const Pane& pane, const CrackNetwork& near) {
  const double share = std::get<Laminated>(pane.glass).far_cracks;
  const auto fewer = [&](int count) { return static_cast<int>(std::lround(share * count)); };
  Pane far = pane;
  far.name += " far";
  far.rings.count = fewer(pane.rings.count);
  for (std::size_t i = 0; i < far.impacts.size(); ++i) {
    const ImpactCounts& counts = near.impacts[i];
    far.impacts[i].radial_count = std::max(1, fewer(counts.radial_count));
    far.impacts[i].large_count = std::min(*far.impacts[i].radial_count, fewer(counts.large_count));
    far.impacts[i].circular_count = fewer(counts.circular_count);
  }
  return far;
}

}  // namespace

void require_breakable(const Pane& pane) {
  require_impacts_inside(pane);
  require_bendable(pane);
  require_film(pane);
  if (pane.given_cracks) return;
  std::visit(Overloaded{[&](const Annealed&) { require_few_steps(pane); }, [&](const Laminated&) { require_few_steps(pane); },
                        [&](const Tempered& glass) { require_few_fragments(pane, glass); }},
             pane.glass);
}

CrackNetwork broken(const Pane& pane, std::uint64_t seed) {
  require_breakable(pane);
  if (pane.given_cracks) {
    CrackNetwork given = *pane.given_cracks;
    if (pane.time_us) time_by_front(pane, given);
    return given;
  }
  const auto laminated = [&](const Laminated& glass) {
    CrackNetwork network = grown_cracks(pane, seed);
    draw_through(pane, has_two_sheets(pane) ? 0.0 : glass.through, seed, network);
    return network;
  };
  CrackNetwork network = std::visit(Overloaded{[&](const Annealed&) { return grown_cracks(pane, seed); }, laminated,
                                               [&](const Tempered& glass) { return diced_pane(pane, glass, seed); }},
                                    pane.glass);
  if (pane.time_us) settle_times(network);
  return network;
}

CrackNetwork broken_far_sheet(const Pane& pane, const CrackNetwork& near, std::uint64_t seed) {
  if (!has_two_sheets(pane) || std::get<Laminated>(pane.glass).far_cracks == 0.0) return {};
  CrackNetwork network = grown_cracks(far_pane(pane, near), seed);
  draw_through(pane, 0.0, seed, network);
  if (pane.time_us) settle_times(network);
  const auto first = static_cast<int>(near.cracks.size());
  for (Crack& crack : network.cracks) {
    crack.id += first;
    for (CrackEnd* end : {&crack.start, &crack.end}) {
      if (end->crack) *end->crack += first;
    }
  }
  return network;
}

}  // namespace shatterpave::glass
