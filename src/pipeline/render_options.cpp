#include "pipeline/render_options.h"

namespace shatterpave::pipeline {

PictureSize size_of(const RenderOptions& options) {
  const bool final = options.quality == Quality::final;
  return {options.width > 0 ? options.width : final ? 1200 : 640, options.height > 0 ? options.height : final ? 900 : 480};
}

}  // namespace shatterpave::pipeline
