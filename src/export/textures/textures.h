// Texture sets: maps of a pavement as other renderers, Blender, Substance and game engines take them.
//
// For each pavement, of its window and size (`Pavement::textures`), with NAME that of the pavement:
//   NAME_BaseColor         PNG: sRGB, 8 bits. EXR: linear, half
//   NAME_Roughness         8 bits, or half
//   NAME_Normal            tangent space, OpenGL: green is up in the picture. 16 bits, or half
//   NAME_Height            0 is the lowest and 1 the highest of the window; how many mm that is stands in NAME_textures.json
//   NAME_AmbientOcclusion  1 is open. 8 bits, or half
//   NAME_ID                PNG: a colour for each stone, black is the joint (maps.h). EXR: one channel, the stone's id plus 1
//   NAME_textures.json     sizes, heights and conventions
#pragma once

#include <vector>

#include "export/target.h"

namespace shatterpave::exporting::textures {

// One for each pavement. Files are written row by row: memory is about 12 bytes a pixel, and some 30 MB a thread; for tiled EXR
// a third of a map's pixels more.
std::vector<FileSet> texture_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{
    .name = "textures",
    .sentence = "maps of each pavement as other renderers take them: colour, normal, roughness, height, occlusion, ids"};

}  // namespace shatterpave::exporting::textures
