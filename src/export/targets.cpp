#include "export/targets.h"

#include <array>

#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "export/povray/povray.h"
#include "export/svg/drawing_svg.h"
#include "export/textures/textures.h"

namespace shatterpave::exporting {

std::span<const Target* const> targets() {
  static constexpr std::array table = {&povray::target, &json::target, &svg::target, &textures::target, &obj::target};
  return table;
}

}  // namespace shatterpave::exporting
