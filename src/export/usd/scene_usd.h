// All bodies as one layer of OpenUSD, which Houdini (Solaris, Karma), usdview, Maya, Blender, Omniverse and others read.
#pragma once

#include <vector>

#include "export/shapes/bodies.h"
#include "export/target.h"

namespace shatterpave::exporting::usd {

// `SCENE.usda`, text, and beside it the pictures that it names: of swatches (export/swatches), and of what is all around. 1
// unit = 1 m, y up, as in all mesh targets; x to the right, z towards the viewer.
//
//   /SCENE                       assembly, the default prim
//     geometry                   group
//       THING                    component: a pane or a pavement
//         slab, crack_4, shard_c12l3, stone_17, joints, water …      subcomponents: the bodies (export/shapes/bodies.h)
//         prototypes             class: meshes that stones which are alike share; those are instances of them
//         materials
//     camera
//     lights                     environment, a dome, and the sun (export/shapes/stage.h); exposure is in both
//   /Render/settings             how large the picture is, where the scene says so
//
// Names of prims are identifiers: what else stands in the names of scene and things is '_' there. Bodies tell their id and kind
// by `userProperties:id` and `userProperties:kind`. A thing holds all that it needs, so that another layer can refer to it
// alone.
//
// Guarantees:
// 1. Points are in tenths of a µm, about the body's own pivot, and no two of a body are at one place: what is closed is closed,
//    and no facet has two corners at one place.
// 2. Facets are counter-clockwise from outside; each corner has a normal and a place in a texture, in metres.
// 3. Every facet of a body of several materials is in one of its GeomSubsets.
// Throws InputError where there is nothing to be written.
std::vector<OutputFile> usd_files(const Model& model);  // without the environment

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{.name = "usd",
                               .sentence = "all meshes with their materials as a layer of OpenUSD (SCENE.usda)",
                               .require = shapes::require_few_stones,
                               .holds_motion = true,
                               .glass_is_clean = true};

}  // namespace shatterpave::exporting::usd
