#include "export/swatches/environment.h"

#include <algorithm>

#include "relief/out_of_focus.h"
#include "relief/panorama.h"

namespace shatterpave::exporting::swatches {

relief::Raster sharp_environment(const shapes::Stage& stage) {
  return relief::panorama(*stage.environment.content, stage.environment.ending);
}

relief::Raster seen_environment(const shapes::Stage& stage) {
  return relief::out_of_focus(sharp_environment(stage), stage.light.environment_blur);
}

void append_environment(const shapes::Stage& stage, Outputs& outputs) {
  if (std::ranges::find(outputs.files, stage.environment_name, &OutputFile::name) != outputs.files.end()) return;
  if (stage.light.environment_blur > Angle()) {
    outputs.files.push_back({stage.environment_name, relief::encoded(seen_environment(stage), relief::RasterFormat::exr_half)});
  } else {
    outputs.files.push_back({stage.environment_name, *stage.environment.content});
  }
}

}  // namespace shatterpave::exporting::swatches
