#include "glass/breaking.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/overloaded.h"
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
void draw_through(const Pane& pane, double part, std::uint64_t seed, CrackNetwork& network) {
  const Id id = Id(pane.name).child("through");
  for (Crack& crack : network.cracks) {
    const Address address{Stream::through, id.child(static_cast<std::uint64_t>(crack.id))};
    crack.through = uniform(seed, address) < part;
  }
}

}  // namespace

void require_breakable(const Pane& pane) {
  require_impacts_inside(pane);
  std::visit(Overloaded{[&](const Annealed&) { require_few_steps(pane); }, [&](const Laminated&) { require_few_steps(pane); },
                        [&](const Tempered& glass) { require_few_fragments(pane, glass); }},
             pane.glass);
}

CrackNetwork broken(const Pane& pane, std::uint64_t seed) {
  require_breakable(pane);
  const auto laminated = [&](const Laminated& glass) {
    CrackNetwork network = grown_cracks(pane, seed);
    draw_through(pane, glass.through, seed, network);
    return network;
  };
  return std::visit(Overloaded{[&](const Annealed&) { return grown_cracks(pane, seed); }, laminated,
                               [&](const Tempered& glass) { return diced_pane(pane, glass, seed); }},
                    pane.glass);
}

}  // namespace shatterpave::glass
