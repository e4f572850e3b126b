// Meshes of what broken panes are made of: flat, as the pane is drawn, and bent, as it is.
#pragma once

#include "export/shapes/body.h"
#include "export/shapes/tubes.h"
#include "geometry/bend.h"
#include "glass/gaps/crack_surface.h"
#include "glass/gaps/shot_hole.h"
#include "glass/pane.h"
#include "glass/shards/shards.h"

namespace shatterpave::exporting::shapes {

// Of crushed glass, below the faces of the pane.
inline constexpr double crushed_skin_mm = 0.01;

// How far bent triangles are off the bent surface at the most. What lies within a pane keeps 0.01 mm below its faces, which
// both may be off by a fifth of; shards have nothing near their faces.
inline constexpr double bent_pane_bound_mm = 0.002;
inline constexpr double bent_shard_bound_mm = 0.02;

// Cavities: what bounds them looks into them.
Mesh gap_mesh(const glass::CrackSurface& surface);
Mesh tube_mesh(const Tube& tube);  // of six sides
Mesh hole_mesh(const glass::ShotHole& hole);
// A disc about the middle plane, as thick as twice `half_mm`.
//   REQUIRES  half_mm > 0, and the zone has a radius
Mesh crushed_mesh(const glass::ImpactZone& zone, double half_mm);

// The whole pane, closed, with sharp edges.
Mesh slab_mesh(const glass::Pane& pane);
// The triangles of a shard that are of this surface, each with points of its own, where it was in the pane.
Mesh shard_mesh(const glass::Shard& shard, glass::ShardSurface slot, double thickness_mm);

// The mesh of a flat pane as it is once the pane is bent: cut until it follows the bend, with normals bent too. Meshes that
// share an edge still do. A flat bend leaves it as it is.
Mesh bent(Mesh mesh, const geometry::Bend& bend, double bound_mm);

}  // namespace shatterpave::exporting::shapes
