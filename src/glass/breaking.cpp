#include "glass/breaking.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/random.h"
#include "glass/dicing/dice.h"
#include "glass/growth/growth.h"

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

// Which cracks of laminated glass run through both sheets.
void draw_through(const Pane& pane, std::uint64_t seed, CrackNetwork& network) {
  const Id id = Id(pane.name).child("through");
  for (Crack& crack : network.cracks) {
    const Address address{Stream::through, id.child(static_cast<std::uint64_t>(crack.id))};
    crack.through = uniform(seed, address) < pane.laminate.through;
  }
}

}  // namespace

CrackNetwork broken(const Pane& pane, std::uint64_t seed) {
  require_impacts_inside(pane);
  if (pane.glass == GlassKind::tempered) return diced_pane(pane, seed);
  CrackNetwork network = grown_cracks(pane, seed);
  if (pane.glass == GlassKind::laminated) draw_through(pane, seed, network);
  return network;
}

}  // namespace shatterpave::glass
