// Panes that shots went through, with true openings in their faces. The bodies of all targets keep the faces whole, as a skin
// over the air of a hole (glass_bodies.h); rays that start farther from a surface than the skin is thick pass through it
// unseen.
#pragma once

#include <vector>

#include "export/model.h"
#include "export/shapes/body.h"

namespace shatterpave::exporting::shapes {

// Together closed: the slab with its openings, and the wall of each hole, from face to face, which looks into the hole.
struct OpenSlab {
  Mesh slab;
  std::vector<Mesh> walls;  // one for each hole of `broken.surfaces.shot_holes`
};
OpenSlab open_slab(const BrokenPane& broken);

}  // namespace shatterpave::exporting::shapes
