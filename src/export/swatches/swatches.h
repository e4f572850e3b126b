// The pictures of swatches (export/shapes/swatch.h), for targets whose materials have textures. Such a target stands in
// export/raster_targets.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "export/shapes/swatch.h"
#include "relief/raster.h"

namespace shatterpave::exporting::swatches {

// All are `size_px` square and meet themselves on all sides. Rows run from the top: the middle of the pixel in column c and row
// r is at uv_m = side_m * ((c + 0.5) / size_px, 1 - (r + 0.5) / size_px).
struct Pictures {
  relief::Raster base_color;                    // linear; times the tint of a material it is the material's
  relief::Raster normal;                        // (n + 1) / 2: x to the right, y up in the picture (OpenGL), z out of the stone
  relief::Raster occlusion_roughness_metallic;  // 1 is open; roughness as glTF means it, times the material's; metallic is 0
};

// The same to the bit for any number of threads. Two swatches that differ in nothing but their names are the same.
Pictures drawn(const shapes::Swatch& swatch, std::uint64_t seed);

// For formats that cannot multiply: the base colour of a material.
relief::Raster tinted(const relief::Raster& base_color, const shapes::Colour& tint);

struct PictureFile {
  std::string name;             // without folders
  std::string_view media_type;  // "image/png", "image/jpeg"
  std::string bytes;
};

// As files: NAME_BaseColor (in sRGB), NAME_Normal, NAME_OcclusionRoughnessMetallic, with NAME that of the swatch.
struct Files {
  PictureFile base_color;
  PictureFile normal;
  PictureFile occlusion_roughness_metallic;
};
Files files(const Pictures& pictures, const std::string& name);

// One of them: the base colour as a picture file, in sRGB, and one that holds numbers, as they are.
PictureFile colour_file(const relief::Raster& linear, const std::string& stem);
PictureFile data_file(const relief::Raster& raster, const std::string& stem);

}  // namespace shatterpave::exporting::swatches
