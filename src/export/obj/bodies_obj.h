// All bodies as Wavefront OBJ, which Blender, Houdini and others read.
#pragma once

#include <vector>

#include "export/shapes/bodies.h"
#include "export/target.h"

namespace shatterpave::exporting::obj {

// `SCENE.obj` and its materials `SCENE.mtl`. Each body (export/shapes/bodies.h) is an object and a group of its name, such as
// `PANE.ID`, where it is now: shards that are not missing, or the slab of a pane and the cracks in it; stones, joints, water.
// 1 unit = 1 m, x to the right, y up, z towards the viewer; outward faces are counter-clockwise.
//
// Guarantees:
// 1. No triangle is without area: what was not turned is written in whole µm, all else in all digits of its place. The least
//    height of a triangle of a shard on the lattice is 1 µm² over its longest side, and the digits reach a thousandth of that
//    for panes of 30 m.
// 2. What is closed stays closed, also where readers take vertices in one place for one: each place of a body is written once.
// 3. Each corner has a normal (vn) and a place in a texture (vt), in metres.
// Throws InputError where there is nothing to be written: all shards are missing, and there is nothing else.
std::vector<OutputFile> obj_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{.name = "obj",
                               .sentence = "all meshes in Wavefront's format (SCENE.obj, SCENE.mtl)",
                               .append = append,
                               .require = shapes::require_few_stones,
                               .glass_is_clean = true};

}  // namespace shatterpave::exporting::obj
