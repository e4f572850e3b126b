#include "glass/growth/crater.h"

#include <variant>

#include "core/functions.h"
#include "core/overloaded.h"

namespace shatterpave::glass {

namespace {

// Steel on glass: Young's moduli 210 and 70 GPa, Poisson's ratios 0.30 and 0.22.
constexpr double steel_density_kg_m3 = 7800.0;
constexpr double contact_modulus_pa = 1.0 / ((1.0 - 0.30 * 0.30) / 210e9 + (1.0 - 0.22 * 0.22) / 70e9);

// Flakes about the crushed zone on the side of the impact, in units of its radius. By eye.
constexpr double near_spall = 1.3;

}  // namespace

bool makes_crater(const Pane& pane) {
  return std::visit(Overloaded{[&](const Annealed&) { return pane.pattern == Pattern::real; },
                               [](const Laminated&) { return true; }, [](const Tempered&) { return false; }},
                    pane.glass);
}

Crater crater_of(const Impact& impact, const Pane& pane) {
  const double pressure_pa = 1.25 * pi * steel_density_kg_m3 * impact.speed_m_s * impact.speed_m_s;
  Crater crater;
  crater.crushed_radius_mm = 0.5 * impact.ball_diameter_mm * power(pressure_pa / contact_modulus_pa, 0.2);
  crater.near_radius_mm = near_spall * crater.crushed_radius_mm;
  const double opening = sine(pane.crater_cone.radians()) / cosine(pane.crater_cone.radians());
  const auto cone = [&] { return crater.near_radius_mm + opening * pane.thickness_mm; };
  std::visit(Overloaded{[&](const Annealed&) { crater.far_radius_mm = cone(); },
                        [&](const Laminated& glass) {
                          crater.far_radius_mm = crater.near_radius_mm;
                          crater.milky_radius_mm = crater.near_radius_mm + glass.milky_width_mm;
                        },
                        [&](const Tempered&) { crater.far_radius_mm = cone(); }},
             pane.glass);
  return crater;
}

}  // namespace shatterpave::glass
