#include "paving/derived/kerb.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/clip.h"
#include "paving/catalogue/finishes.h"
#include "paving/catalogue/stone_sizes.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::paving {

namespace {

// Beyond this many widths a corner of the outer line is cut square.
constexpr double miter_limit = 4.0;
constexpr double arris_mm = 6.0;  // by eye, as real ones have chamfers of 5 to 25 mm

}  // namespace

Pavement kerb(const Pavement& pavement) {
  Pavement result = pavement;
  result.name = kerb_name(pavement);
  result.kerb = {};
  result.joint_mm = std::min({pavement.joint_mm, widest_block_joint_mm, 0.5 * pavement.kerb.width_mm});
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
  result.hand = {};  // kerb stones are sawn
  result.look.colours = {};
  result.variation.tilt = Angle();
  const FinishPreset& preset = preset_of(Finish::bush_hammered);
  result.body = preset.body;
  result.body.arris = Arris::chamfered;
  result.body.arris_mm = std::min(arris_mm, 0.1 * pavement.kerb.width_mm);
  result.relief = preset.relief;
  result.surface.height_spread = 0.0;
  result.sizes = EqualSizes{};
  result.cell = CellShape{};
  result.surface.height_mm = pavement.kerb.height_mm + face_mm(pavement) - bed_level_mm(pavement);
  result.look.wetness = std::min(pavement.look.wetness, 0.5);  // no water stands on a kerb
  result.textures.seamless = false;                            // a strip about a corner repeats in no direction
  result.textures.tile_mm.reset();
  result.ground.settlement_mm = 0.0;
  result.ground.level_mm += face_mm(pavement) + pavement.kerb.height_mm - face_mm(result);
  return result;
}

}  // namespace shatterpave::paving
