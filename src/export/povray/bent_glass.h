// Parts of bent panes for POV-Ray: meshes, where flat ones have boxes, prisms, cylinders and discs.
#pragma once

#include <string>
#include <vector>

#include "export/model.h"
#include "export/shapes/body.h"
#include "export/shapes/glass_meshes.h"
#include "geometry/bend.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::exporting::povray {

// A closed mesh2 with smooth normals and an inside, without material: as sheet_mesh. Either way round.
std::string closed_mesh(const shapes::Mesh& mesh);

// A shard as mesh2, in the textures Old and Broken, with normals of its own at each corner; without the brackets, so that a
// motion can follow.
std::string shard_mesh_text(const glass::Shard& shard, const geometry::Bend& bend, double thickness_mm);

// #declare PREFIX_Bend_Middle, _Half and _Bow, which the macros of shatterpave_bent_glass.inc take: `bend_arguments`.
std::string bend_declarations(const geometry::Bend& bend, const std::string& prefix);
std::string bend_arguments(const std::string& prefix);

// Layers of powder in a crushed zone, one object: the `number`-th of the pane.
std::string crushed_layers(const glass::ImpactZone& zone, const geometry::Bend& bend, double thickness_mm, std::size_t number);

}  // namespace shatterpave::exporting::povray
