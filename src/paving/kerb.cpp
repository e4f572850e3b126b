#include "paving/kerb.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/clip.h"
#include "paving/finishes.h"
#include "paving/stone_surface.h"

namespace shatterpave::paving {

namespace {

// Beyond this many widths a corner of the outer line is cut square.
constexpr double miter_limit = 4.0;
constexpr double widest_joint_mm = 6.0;  // kerbs are set close
constexpr double arris_mm = 6.0;         // by eye, as real ones have chamfers of 5 to 25 mm

// Of the faces above the outlines of the stones, in the mean.
double face_mm(const Pavement& pavement) {
  const double height = pavement.surface.height_mm;
  return pavement.body.finish == Finish::none ? top_mm(pavement) / (1.0 + pavement.surface.height_spread)
                                              : bed_level_mm(pavement) + height;
}

}  // namespace

Pavement kerb(const Pavement& pavement) {
  Pavement result = pavement;
  result.name = kerb_name(pavement);
  result.kerb = {};
  result.joint_mm = std::min({pavement.joint_mm, widest_joint_mm, 0.5 * pavement.kerb.width_mm});
  result.stone_mm = {pavement.kerb.length_mm, pavement.kerb.width_mm - result.joint_mm};
  const auto outer = geometry::offset({pavement.area.outline, {}}, pavement.kerb.width_mm, miter_limit);
  ENSURE(!outer.empty());
  geometry::Polygon hole = pavement.area.outline;
  std::ranges::reverse(hole);
  result.area = {outer.front().outline, {hole}};
  result.direction = BoundaryDirection{};
  result.bonding = {};
  result.bonding.bond = Bond::course;
  result.border = {};
  result.variation = {};
  result.variation.tilt = Angle();
  const auto bush_hammered =
      std::ranges::find(finish_presets, Finish::bush_hammered, [](const FinishPreset& preset) { return preset.body.finish; });
  result.body = bush_hammered->body;
  result.body.arris = Arris::chamfered;
  result.body.arris_mm = std::min(arris_mm, 0.1 * pavement.kerb.width_mm);
  result.relief = bush_hammered->relief;
  result.surface.height_spread = 0.0;
  result.surface.height_mm = pavement.kerb.height_mm + face_mm(pavement) - bed_level_mm(pavement);
  result.look.wetness = std::min(pavement.look.wetness, 0.5);  // no water stands on a kerb
  result.ground.settlement_mm = 0.0;
  result.ground.level_mm += face_mm(pavement) + pavement.kerb.height_mm - face_mm(result);
  return result;
}

}  // namespace shatterpave::paving
