// All bodies as one Stanford PLY, which MeshLab, Mitsuba, trimesh and others read.
#pragma once

#include <vector>

#include "export/shapes/bodies.h"
#include "export/target.h"

namespace shatterpave::exporting::ply {

// `SCENE.ply`, binary, little endian. Vertices have x, y, z (metres, y up), normals nx, ny, nz, and places in textures s, t
// (metres). Faces are triangles, counter-clockwise from outside, with the number of their body and of their material, which
// comments of the header name:
//   comment material 0 glass_old
//   comment body 0 window.slab pane
// Refuses what its 32-bit indices cannot hold.
std::vector<OutputFile> ply_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{.name = "ply",
                               .sentence = "all meshes in one file, with bodies and materials as numbers of faces (SCENE.ply)",
                               .append = append,
                               .require = shapes::require_few_stones,
                               .glass_is_clean = true};

}  // namespace shatterpave::exporting::ply
