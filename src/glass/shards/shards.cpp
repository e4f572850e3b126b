// Each face of the network gives up half the opening along its cracks; what is left is a shard, or several where the face is
// narrower than that somewhere. Then each shard is asked whether it leaves the pane: likely near an impact. Those that have too
// little left to hold them follow, round after round, until what stands stands. What fell is let fall (fall.h).
#include "glass/shards/shards.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "core/random.h"
#include "glass/shards/fall.h"
#include "glass/shards/joined_shards.h"
#include "glass/shards/shard_faces.h"
#include "glass/shards/shard_pieces.h"
#include "glass/shards/shard_solid.h"

namespace shatterpave::glass {

namespace {

using geometry::FaceRing;
using geometry::FaceSide;

// The frame grips a shard that has this part of its border in it, however little else holds it.
constexpr double grip = 0.1;

double distance_to_impact(const Pane& pane, vec2 p) {
  double least = -1.0;
  for (const Impact& impact : pane.impacts) {
    const double distance = glm::length(p - impact.at_mm);
    if (least < 0.0 || distance < least) least = distance;
  }
  return least;
}

bool is_struck_out(const Pane& pane, const Shard& shard, std::uint64_t seed) {
  const double away = distance_to_impact(pane, geometry::centroid(shard.face.outline));
  if (away < 0.0) return false;
  const double x = away / pane.shards->missing_mm;
  const double probability = pane.shards->missing * exponential(-x * x * x * x);
  return uniform(seed, {Stream::shard_missing, shard_id(pane, shard.id)}) < probability;
}

// How long the border is that each face has with the frame, with each neighbour, and in all.
struct Borders {
  double frame_mm = 0.0;
  double all_mm = 0.0;
  std::map<std::size_t, double> shared_mm;  // by face
};

std::vector<Borders> borders_of(const FacedPane& faced) {
  std::vector<std::array<std::optional<std::size_t>, 2>> faces_at(faced.segments.size());
  const auto each_side = [&](auto act) {
    for (std::size_t i = 0; i < faced.faces.size(); ++i) {
      for (const FaceSide& side : faced.faces[i].face.outline) act(i, side);
      for (const FaceRing& hole : faced.faces[i].face.holes) {
        for (const FaceSide& side : hole) act(i, side);
      }
    }
  };
  each_side([&](std::size_t face, const FaceSide& side) { faces_at[side.segment][side.forward ? 0 : 1] = face; });
  std::vector<Borders> borders(faced.faces.size());
  each_side([&](std::size_t face, const FaceSide& side) {
    const geometry::Segment& segment = faced.segments[side.segment];
    const double length_mm = glm::length(geometry::to_mm(segment.b) - geometry::to_mm(segment.a));
    borders[face].all_mm += length_mm;
    if (segment.owner == pane_edge) borders[face].frame_mm += length_mm;
    if (const auto neighbour = faces_at[side.segment][side.forward ? 1 : 0]) borders[face].shared_mm[*neighbour] += length_mm;
  });
  return borders;
}

// Lets go of what is not held, round after round. A face stands where its first piece does; further pieces go with it.
std::vector<bool> standing_faces(const FacedPane& faced, const ShardRules& rules, std::vector<bool> stands) {
  const std::vector<Borders> borders = borders_of(faced);
  const auto is_held = [&](std::size_t face) {
    const Borders& border = borders[face];
    double held_mm = border.frame_mm;
    for (const auto& [neighbour, length_mm] : border.shared_mm) held_mm += stands[neighbour] ? length_mm : 0.0;
    return border.frame_mm >= grip * border.all_mm || held_mm >= rules.held * border.all_mm;
  };
  for (bool changed = true; changed;) {
    std::vector<std::size_t> falling;
    for (std::size_t i = 0; i < stands.size(); ++i) {
      if (stands[i] && !is_held(i)) falling.push_back(i);
    }
    for (const std::size_t face : falling) stands[face] = false;
    changed = !falling.empty();
  }
  return stands;
}

void let_go(const Pane& pane, const FacedPane& faced, const std::vector<ShardPiece>& pieces, std::vector<Shard>& shards,
            std::uint64_t seed) {
  std::vector<bool> stands(faced.faces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!is_struck_out(pane, shards[i], seed)) stands[pieces[i].face] = true;
  }
  stands = standing_faces(faced, *pane.shards, std::move(stands));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (stands[pieces[i].face]) continue;
    const double draw = uniform(seed, {Stream::shard_fallen, shard_id(pane, shards[i].id)});
    shards[i].state = draw < pane.shards->fallen ? ShardState::fallen : ShardState::missing;
  }
}

}  // namespace

vec3 moved(const Motion& motion, vec3 p_mm) {
  return vec3{glm::dot(motion.rows[0], p_mm), glm::dot(motion.rows[1], p_mm), glm::dot(motion.rows[2], p_mm)} + motion.shift_mm;
}

vec3 in_pane_mm(const geometry::LatticePoint3& vertex, double thickness_mm) {
  return {geometry::to_mm(vertex.x), geometry::to_mm(vertex.y), geometry::to_mm(vertex.z) - 0.5 * thickness_mm};
}

std::vector<Shard> shards(const Pane& pane, const CrackNetwork& network, std::uint64_t seed) {
  ENSURE(pane.shards.has_value());
  const FacedPane faced = faced_pane(pane, network);
  const std::vector<ShardPiece> pieces = shard_pieces(pane, faced);
  std::vector<Shard> result(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    result[i].id = pieces[i].id;
    result[i].face = pieces[i].blank.region;
    result[i].frame_mm = pieces[i].frame_mm;
  }
  let_go(pane, faced, pieces, result, seed);
  let_fall(pane, result, seed);
  if (pane.shards->joined) return joined_shards(pane, faced, pieces, std::move(result), seed);
  parallel_for(pieces.size(), [&](std::size_t i) {
    result[i].solid = shard_solid(pieces[i].blank, *pane.shards, chips(pieces[i].blank, *pane.shards, seed));
  });
  return result;
}

}  // namespace shatterpave::glass
