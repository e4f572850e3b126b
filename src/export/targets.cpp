#include "export/targets.h"

#include <array>

#include "export/csv/tables_csv.h"
#include "export/gltf/scene_gltf.h"
#include "export/json/geometry_json.h"
#include "export/mitsuba/scene_mitsuba.h"
#include "export/obj/bodies_obj.h"
#include "export/ply/bodies_ply.h"
#include "export/povray/povray.h"
#include "export/svg/drawing_svg.h"
#include "export/textures/textures.h"
#include "export/usd/scene_usd.h"

namespace shatterpave::exporting {

std::span<const Target* const> targets() {
  static constexpr std::array table = {&povray::target, &json::target, &svg::target, &textures::target, &csv::target,
                                       &gltf::target,   &obj::target,  &ply::target, &usd::target,      &mitsuba::target};
  return table;
}

}  // namespace shatterpave::exporting
