// All bodies as one binary glTF 2.0 file, which Blender, three.js, Unreal, Houdini and others read.
#pragma once

#include <vector>

#include "export/shapes/bodies.h"
#include "export/target.h"

namespace shatterpave::exporting::gltf {

// `SCENE.glb`. Metres, right-handed, y up, z towards the viewer. A node for each pane and pavement, and below it one for each
// body (export/shapes/bodies.h), named as it is, with its kind in `extras`; bodies that are alike share one mesh. Glass is a
// real dielectric: KHR_materials_transmission, _ior and _volume, none of them required; stones have the colour and roughness of
// their tone. Places in textures are in metres.
std::vector<OutputFile> gltf_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{.name = "gltf",
                               .sentence = "all meshes with their materials as binary glTF 2.0 (SCENE.glb)",
                               .append = append,
                               .require = shapes::require_few_stones};

}  // namespace shatterpave::exporting::gltf
