// The include file of a pavement for POV-Ray, and the height image that it reads.
//
// The stones are `bicubic_patch` objects with explicit control points; their relief reaches the normals by a `bump_map` of one
// periodic 16-bit height image, in which each stone has its own window by its `uv_vectors`. Beneath lies a bed of sand that
// hides the borders of the stones.
//
// What POV-Ray does with a bump_map, as measured: the slope is exact if bump_size is the range of the heights over the spacing
// of the pixels, but the axes of the image turn with the azimuth of the surface's normal about y, so that on the crown of a
// stone the relief whirls like fur. The include therefore shears the space of the normal, which moves the pole of those axes
// from the crown to shoulders that face +z, steeper than 31°; on level ground slope and direction are then exact.
//
// Stones share textures by tone: one `union` for each of `stone_tones` tones (stone_text.h), since a texture of its own for
// every stone would take kilobytes. A tone's stones lie scattered, as each draws its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "export/model.h"

namespace shatterpave::exporting::povray {

// `NAME.inc` and, unless the relief is left out, `NAME_relief.png`. Lengths are millimetres; POV-Ray's y is up, its z our y.
//   prefix  of the identifiers that the file declares
//   seed    of the scene: for the draws of each stone and for the relief
std::vector<OutputFile> pavement_files(const PavedArea& paved, const std::string& prefix, std::uint64_t seed);

}  // namespace shatterpave::exporting::povray
