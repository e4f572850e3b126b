// The shards of panes as Wavefront OBJ, which Blender, Houdini and others read.
#pragma once

#include <vector>

#include "export/target.h"

namespace shatterpave::exporting::obj {

// `SCENE.obj` and its materials `SCENE.mtl`. Each shard that is not missing is an object and a group `PANE.ID`, where it is
// now; its faces are in the materials glass_old and glass_broken. 1 unit = 1 m, x to the right, y up, z towards the viewer;
// outward faces are counter-clockwise. Pavements are left out.
//
// Guarantees:
// 1. No triangle is without area: what stands is written in whole µm, what has fallen in all digits of its place. The least
//    height of a triangle on the lattice is 1 µm² over its longest side, and the digits reach a thousandth of that for panes of
//    30 m.
// 2. Each shard is closed, also where readers take vertices in one place for one.
// 3. Each corner has the normal of its facet, and a place in a texture (vt): that of the vertex in the pane, in metres, on the
//    two axes that the facet faces most squarely.
// Throws InputError where there is nothing to be written: see require_shards, or all shards are missing.
std::vector<OutputFile> obj_files(const Model& model);

void append(const Model& model, Outputs& outputs);

// Throws InputError unless one of the panes asks for shards: what obj_files would refuse, known before anything is made.
void require_shards(const Things& things);

inline constexpr Target target{.name = "obj",
                               .sentence = "the shards of panes as meshes in Wavefront's format (SCENE.obj, SCENE.mtl)",
                               .append = append,
                               .require = require_shards};

}  // namespace shatterpave::exporting::obj
