// What faces of a crack network are once each has given up half the gap along its cracks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/planar_map.h"
#include "glass/pane.h"
#include "glass/shards/shard_faces.h"
#include "glass/shards/shard_solid.h"

namespace shatterpave::glass {

// Sides of a shard are the pane's edge where they lie within this of it: cutting rounds by 1 µm, and so do ends of cracks.
inline constexpr double edge_tolerance_mm = 0.003;

// The face less half the gap along its cracks, in parts that are no splinters, the largest first. Each lies at least half the
// gap less 2 µm from every crack on the face's border. No rings touch, neither of one part nor of two.
//   segments  those of the face
std::vector<geometry::Region> parts_of(const geometry::Face& face, const std::vector<geometry::Segment>& segments,
                                       const ShardRules& rules);

struct ShardPiece {
  std::string id;        // as in Shard
  std::size_t face = 0;  // of the pane's, of which it is a part
  ShardBlank blank;
  double frame_mm = 0.0;  // length of its border that the frame holds
  bool leaves = false;    // lies in the hole
};

// A part of the face as a piece.
ShardPiece piece_of(const Pane& pane, const geometry::Face& face, const std::vector<geometry::Segment>& segments,
                    geometry::Region part, std::string id);

// All pieces of the pane, face after face, cut along the border of the hole.
//   is_whole  of each face: one that is not so is not cut yet
std::vector<ShardPiece> shard_pieces(const Pane& pane, const FacedPane& faced, const std::vector<geometry::Region>& hole,
                                     const std::vector<bool>& is_whole);

// As `rules`, but for how small a splinter is where there is a hole: what stands away from it stays, however little more than
// dust it is.
ShardRules rules_of_standing(ShardRules rules, const std::vector<geometry::Region>& hole);

// What of the parts lies outside the hole, and inside, a gap apart; in parts that are no splinters, the largest first.
struct CutParts {
  std::vector<geometry::Region> outside;
  std::vector<geometry::Region> inside;
};
CutParts cut_parts(std::vector<geometry::Region> parts, const std::vector<geometry::Region>& hole, const ShardRules& rules);

// What draws for a shard are addressed by.
Id shard_id(const Pane& pane, const std::string& shard);

}  // namespace shatterpave::glass
