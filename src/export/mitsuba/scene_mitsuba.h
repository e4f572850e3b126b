// A scene that Mitsuba 3 renders as it is.
#pragma once

#include <vector>

#include "export/shapes/bodies.h"
#include "export/target.h"

namespace shatterpave::exporting::mitsuba {

// `SCENE.xml`, its meshes `SCENE-THING-MATERIAL.ply` (mesh_file.h), the pictures of its stones and its environment. Metres, y
// up, z towards the viewer. Camera, sampler and lights are those of the model, the exposure a factor on the lights. Without
// glass the integrator is `path`, with it `volpath`, since glass is a medium that takes light.
//
// The bodies of a thing that are of one material are one shape, THING.MATERIAL; `face_body` numbers its faces by their bodies.
// Where a pavement has many stones, those that are alike are instances of a shape group, called as the stone is (THING.ID).
//
// Slabs, shards, tubes and holes are `dielectric`, closed, with a medium within that takes light; shots leave true openings
// (shapes/open_slab.h). Cracks that are gaps are closed, too, but rays of Mitsuba start (1 + |p|) · 0.09 mm away from a surface
// at p metres from the origin: they step over a gap of 0.05 mm, and were its walls dielectrics, they would leave the glass and
// never come back. So the walls are layers of air in glass (`thindielectric`), which turn back what the two walls do together,
// and all light beyond the critical angle. Where a gap is wide enough for both to be met, at opening_mm above 0.1, up to a
// tenth more is turned back than should be. Powder of crushed glass scatters and does not bend.
std::vector<OutputFile> mitsuba_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{.name = "mitsuba",
                               .sentence = "a scene for Mitsuba 3 (SCENE.xml, with meshes as PLY, and textures)",
                               .require = shapes::require_few_stones,
                               .glass_is_clean = true};

}  // namespace shatterpave::exporting::mitsuba
