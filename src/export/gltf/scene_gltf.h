// All bodies as one binary glTF 2.0 file, which Blender, three.js, Unreal, Houdini and others read.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "export/shapes/bodies.h"
#include "export/swatches/swatches.h"
#include "export/target.h"

namespace shatterpave::exporting::gltf {

// `SCENE.glb`. Metres, right-handed, y up, z towards the viewer. A node for each pane and pavement, and below it one for each
// body (export/shapes/bodies.h), named as it is, with its kind in `extras`; bodies that are alike share one mesh. Glass is a
// real dielectric: KHR_materials_transmission, _ior and _volume, as thick as its pane, none of them required; stones and joints
// show the swatches of their materials (export/swatches), which are in the file, in the tint of their tone; or their colours
// alone, where the pavement asks for that. Places in textures are in sides of the swatch; without one, in metres. A camera, and
// the sun by KHR_lights_punctual (export/shapes/stage.h); the format has no environments.
std::vector<OutputFile> gltf_files(const Model& model);

// The pictures of a swatch, for a seed, as swatches::files of swatches::drawn are.
using SwatchFiles = std::function<swatches::Files(const shapes::Swatch& swatch, std::uint64_t seed)>;
// The same where pictures come from elsewhere, such as from an earlier file.
OutputFile gltf_file(const Model& model, const SwatchFiles& pictures);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{.name = "gltf",
                               .sentence = "all meshes with their materials as binary glTF 2.0 (SCENE.glb)",
                               .require = shapes::require_few_stones,
                               .holds_motion = true,
                               .glass_is_clean = true};

}  // namespace shatterpave::exporting::gltf
