// What a scene may say of the texture maps of a pavement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "geometry/polygon.h"

namespace shatterpave::paving {

enum class TextureFormat {
  png,       // 8 bits, 16 for height and normal; base colour in sRGB
  exr,       // half float, float for height and stone id; base colour linear
  tiled_exr  // the same in tiles, with all smaller sizes in the same file (mip maps)
};

struct TextureSet {
  std::size_t size_px = 2048;         // of the longer side, 16 … 16384
  std::optional<geometry::Box> area;  // the part of the plane, mm; none: the bounding box of the pavement's area
  TextureFormat format = TextureFormat::png;
  bool seamless = false;  // instead of that part a tile that meets itself on all sides (paving/seamless.h)
  // Of the seamless pictures of the material that stones in meshes show, 0 … 4096; 0: colours alone. By eye: a millimetre of
  // stone a pixel is enough from two metres away, and makes two megabytes.
  std::uint16_t swatch_px = 1024;
  bool normals_down = false;     // also normals for DirectX, whose green is turned over
  bool packed_channels = false;  // also occlusion, roughness and metal in the three channels of one picture
  std::optional<vec2> tile_mm;   // width and height of the tile; none: near ten stones
};

inline bool operator==(const TextureSet& a, const TextureSet& b) {
  return a.size_px == b.size_px && a.format == b.format && a.seamless == b.seamless && a.tile_mm == b.tile_mm &&
         a.swatch_px == b.swatch_px && a.normals_down == b.normals_down && a.packed_channels == b.packed_channels &&
         a.area.has_value() == b.area.has_value() && (!a.area || (a.area->low == b.area->low && a.area->high == b.area->high));
}

}  // namespace shatterpave::paving
