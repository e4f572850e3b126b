// Cracks as gaps of air for POV-Ray: closed mesh2 objects within a slab of glass, no two of which touch
// (glass/gaps/crack_surface.h).
#pragma once

#include <string>

#include "glass/gaps/crack_surface.h"

namespace shatterpave::exporting::povray {

// A mesh2 without material, with smooth normals and an inside; indented by 3 spaces, with a new line at its end. Normals
// are rounded to a thousandth.
std::string sheet_mesh(const glass::CrackSurface& surface);
std::string shot_hole_mesh(const glass::ShotHole& shot_hole);

}  // namespace shatterpave::exporting::povray
