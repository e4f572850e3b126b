#include "export/raster_targets.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "export/gltf/scene_gltf.h"
#include "export/mitsuba/scene_mitsuba.h"
#include "export/povray/povray.h"
#include "export/textures/textures.h"
#include "export/usd/scene_usd.h"

namespace shatterpave::exporting {

namespace {

struct RasterTarget {
  const Target* target;
  AppendFiles append;
};

constexpr std::array raster_targets = {RasterTarget{&povray::target, povray::append},
                                       RasterTarget{&textures::target, textures::append},
                                       RasterTarget{&gltf::target, gltf::append}, RasterTarget{&usd::target, usd::append},
                                       RasterTarget{&mitsuba::target, mitsuba::append}};

}  // namespace

void append_files(const Target& target, const Model& model, Outputs& outputs) {
  if (!target.has_rasters()) {
    target.append(model, outputs);
    return;
  }
  const auto* found = std::ranges::find(raster_targets, &target, &RasterTarget::target);
  ENSURE(found != raster_targets.end());
  found->append(model, outputs);
}

}  // namespace shatterpave::exporting
