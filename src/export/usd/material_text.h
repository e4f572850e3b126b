// Materials as prims.
#pragma once

#include <string>

#include "export/shapes/body.h"
#include "export/usd/prim_text.h"

namespace shatterpave::exporting::usd {

// The pictures of a swatch, as files beside the layer.
struct SwatchFiles {
  std::string base_color;
  std::string normal;
  std::string occlusion_roughness_metallic;
  double side_m = 1.0;  // of the square that they show
};

// A Material of the material's name, in the prim at that path, with a UsdPreviewSurface, which all renderers read. That can say
// of glass and water only that light goes through; what refracts and takes colour on the way is a standard_surface of MaterialX
// beside it, which those prefer that know it (Karma, Arnold, RenderMan, Storm).
//   swatch  that the material shows in its tint; null: it has its colour alone
void put_material(PrimText& text, const std::string& path, const shapes::Material& material, const SwatchFiles* swatch);

}  // namespace shatterpave::exporting::usd
