// Whether shards are what they say, asked of their triangles alone: by normal and place, without a look at how they were made.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "glass/pane.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {

struct ShardFindings {
  std::size_t shards = 0;
  std::size_t triangles = 0;
  std::size_t faces = 0;      // of these, in the faces of the pane
  std::size_t edges = 0;      // upright on its outline
  std::size_t walls = 0;      // upright elsewhere
  std::size_t bevels = 0;     // between, of which the nearest side of the border tells the surface
  std::size_t undecided = 0;  // between, where sides of both kinds are near
  std::size_t narrow = 0;     // level below a face, but narrower than 8 µm in the plane; upright and as narrow, on the outline
  std::size_t thin = 0;       // with a height below half a µm
  double least_height_um = 1e300;
  double level_bevel_mm2 = 0.0;  // area of what is level and neither face nor narrow
  std::vector<std::string> faults;

  void add(const ShardFindings& other);
};

// What is at fault: a triangle in a face of the pane or on its outline that is not old, one on a wall of a crack that is not
// broken, a bevel of another surface than the wall below it; a triangle without area, or turned against the normal of the face
// that it lies in; a vertex outside of the pane; an edge without its reverse, or with more than one, where vertices in one
// place count as one.
ShardFindings findings(const Pane& pane, const Shard& shard);
ShardFindings findings(const Pane& pane, const std::vector<Shard>& shards);

// The part of the front and back of the shard's plan that lies in the pane's faces and is old.
double flat_share(const Pane& pane, const Shard& shard);

}  // namespace shatterpave::glass
