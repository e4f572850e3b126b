// Each face of the network gives up half the opening along its cracks; what is left is a shard, or several where the face is
// narrower than that somewhere. What lies in the hole (hole_outline.h) leaves the pane: shards on its border are broken along
// it. Those that have too little left to hold them follow, round after round, until what stands stands, and all that stands
// hangs together with the frame: so there is one hole. What fell is let fall (fall.h).
#include "glass/shards/shards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "core/random.h"
#include "geometry/clip.h"
#include "glass/map/growth_clock.h"
#include "glass/shards/fall.h"
#include "glass/shards/hole_outline.h"
#include "glass/shards/joined_shards.h"
#include "glass/shards/lean.h"
#include "glass/shards/shard_faces.h"
#include "glass/shards/shard_pieces.h"
#include "glass/shards/shard_solid.h"

namespace shatterpave::glass {

namespace {

using geometry::FaceRing;
using geometry::FaceSide;

// The frame grips a shard that has this part of its border in it, however little else holds it.
constexpr double grip = 0.1;

// How long the border is that each face has with the frame, with each neighbour, and in all.
struct Borders {
  double frame_mm = 0.0;
  double all_mm = 0.0;
  std::map<std::size_t, double> shared_mm;  // by face
};

// The part of the segment that lies outside the hole.
double share_outside(const geometry::Segment& segment, const std::vector<geometry::Region>& hole) {
  constexpr int samples = 12;
  const vec2 a = geometry::to_mm(segment.a);
  const vec2 b = geometry::to_mm(segment.b);
  const geometry::Box box{glm::min(a, b), glm::max(a, b)};
  int outside = samples;
  for (const geometry::Region& one : hole) {
    if (!geometry::boxes_meet(box, geometry::bounding_box(one.outline))) continue;
    for (int i = 0; i < samples; ++i) {
      if (geometry::contains(one, geometry::on_lattice(glm::mix(a, b, (i + 0.5) / samples)))) --outside;
    }
  }
  return static_cast<double>(std::max(outside, 0)) / samples;
}

// Does `act` to each side of each face, with the number of the face.
template <typename Act>
void each_side(const FacedPane& faced, const Act& act) {
  for (std::size_t i = 0; i < faced.faces.size(); ++i) {
    for (const FaceSide& side : faced.faces[i].face.outline) act(i, side);
    for (const FaceRing& ring : faced.faces[i].face.holes) {
      for (const FaceSide& side : ring) act(i, side);
    }
  }
}

// Of what of each face lies outside the hole.
std::vector<Borders> borders_of(const FacedPane& faced, const std::vector<ShardPiece>& pieces,
                                const std::vector<geometry::Region>& hole) {
  std::vector<std::array<std::optional<std::size_t>, 2>> faces_at(faced.segments.size());
  each_side(faced, [&](std::size_t face, const FaceSide& side) { faces_at[side.segment][side.forward ? 0 : 1] = face; });
  std::vector<Borders> borders(faced.faces.size());
  each_side(faced, [&](std::size_t face, const FaceSide& side) {
    const geometry::Segment& segment = faced.segments[side.segment];
    const double length_mm =
        glm::length(geometry::to_mm(segment.b) - geometry::to_mm(segment.a)) * share_outside(segment, hole);
    if (length_mm == 0.0) return;
    if (segment.owner == pane_edge) borders[face].frame_mm += length_mm;
    if (const auto neighbour = faces_at[side.segment][side.forward ? 1 : 0]) borders[face].shared_mm[*neighbour] += length_mm;
  });
  for (const ShardPiece& piece : pieces) {
    if (!piece.leaves) borders[piece.face].all_mm += geometry::perimeter(piece.blank.region.outline);
  }
  return borders;
}

// Only what hangs together with the frame stands.
void drop_islands(const std::vector<Borders>& borders, std::vector<bool>& stands) {
  std::vector<bool> hangs(stands.size(), false);
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < stands.size(); ++i) {
    if (stands[i] && borders[i].frame_mm > 0.0) {
      hangs[i] = true;
      waiting.push_back(i);
    }
  }
  while (!waiting.empty()) {
    const std::size_t face = waiting.back();
    waiting.pop_back();
    for (const auto& [neighbour, length_mm] : borders[face].shared_mm) {
      if (!stands[neighbour] || hangs[neighbour]) continue;
      hangs[neighbour] = true;
      waiting.push_back(neighbour);
    }
  }
  stands = std::move(hangs);
}

// Lets go of what is not held, round after round. A face stands where its first piece does; further pieces go with it.
std::vector<bool> standing_faces(const std::vector<Borders>& borders, const ShardRules& rules, std::vector<bool> stands) {
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
  drop_islands(borders, stands);
  return stands;
}

void let_go(const Pane& pane, const FacedPane& faced, const std::vector<geometry::Region>& hole,
            const std::vector<ShardPiece>& pieces, std::vector<Shard>& shards, std::uint64_t seed) {
  std::vector<bool> stands(faced.faces.size(), false);
  for (const ShardPiece& piece : pieces) {
    if (!piece.leaves) stands[piece.face] = true;
  }
  if (!hole.empty()) stands = standing_faces(borders_of(faced, pieces, hole), *pane.shards, std::move(stands));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (stands[pieces[i].face] && !pieces[i].leaves) continue;
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

namespace {

// A pane in pieces, before these are bodies.
struct PaneInPieces {
  FacedPane faced;
  std::vector<geometry::Region> hole;
  std::vector<ShardPiece> pieces;
  std::vector<Shard> shards;  // one a piece, without solids
};

std::vector<Shard> shards_without_solids(const std::vector<ShardPiece>& pieces) {
  std::vector<Shard> result(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    result[i].id = pieces[i].id;
    result[i].face = pieces[i].blank.region;
    result[i].frame_mm = pieces[i].frame_mm;
  }
  return result;
}

// When all cracks have grown; with what becomes of each piece.
PaneInPieces pieces_at_end(const Pane& pane, const CrackNetwork& network, std::uint64_t seed) {
  PaneInPieces end;
  end.faced = faced_pane(pane, network);
  end.hole = hole_outlines(pane, network, seed);
  end.pieces = shard_pieces(pane, end.faced, end.hole, std::vector<bool>(end.faced.faces.size(), true));
  end.shards = shards_without_solids(end.pieces);
  let_go(pane, end.faced, end.hole, end.pieces, end.shards, seed);
  return end;
}

// At the pane's time. What becomes of a piece is what becomes of it at the end, once its face is whole; until then it stands,
// and the hole does not cut it.
PaneInPieces pieces_at_time(const Pane& pane, const CrackNetwork& network, const PaneInPieces& end) {
  GrownFaces grown = grown_faces(end.faced, network, network_at(pane, network, *pane.time_us));
  PaneInPieces now;
  now.pieces = shard_pieces(pane, grown.pane, end.hole, grown.is_whole);
  now.shards = shards_without_solids(now.pieces);
  std::map<std::string, ShardState> becomes;
  for (const Shard& shard : end.shards) becomes[shard.id] = shard.state;
  std::vector<geometry::Region> not_whole;
  for (std::size_t i = 0; i < grown.is_whole.size(); ++i) {
    if (!grown.is_whole[i]) not_whole.push_back(region(grown.pane.faces[i].face));
  }
  for (std::size_t i = 0; i < now.pieces.size(); ++i) {
    if (!grown.is_whole[now.pieces[i].face]) continue;
    if (const auto found = becomes.find(now.shards[i].id); found != becomes.end()) now.shards[i].state = found->second;
  }
  for (const geometry::Region& hole : end.hole) {
    std::ranges::move(not_whole.empty() ? std::vector{hole} : geometry::difference(hole, not_whole),
                      std::back_inserter(now.hole));
  }
  now.faced = std::move(grown.pane);
  return now;
}

// By how much walls lean: all over the pane by less where a piece is too narrow for more.
constexpr std::array lean_parts = {1.0, 0.7, 0.5, 0.35, 0.25, 0.0};

// The shards with their solids, as they stand in the pane.
std::vector<Shard> with_solids(const Pane& pane, const PaneInPieces& all, const Lean& lean, std::uint64_t seed) {
  if (pane.shards->joined) return joined_shards(pane, all.faced, all.hole, all.pieces, all.shards, seed, lean);
  std::vector<Shard> result = all.shards;
  parallel_for(all.pieces.size(), [&](std::size_t i) {
    const ShardBlank& blank = all.pieces[i].blank;
    result[i].solid = shard_solid(blank, *pane.shards, chips(blank, *pane.shards, seed), lean);
  });
  return result;
}

// The shards with walls that lean as much as all of them can.
struct Fitted {
  std::size_t part = 0;  // of lean_parts
  Lean lean;
  std::vector<Shard> shards;
};

//   first  of lean_parts, to begin with
Fitted fitted(const Pane& pane, const PaneInPieces& all, std::uint64_t seed, std::size_t first) {
  Fitted result;
  for (result.part = first; result.part < lean_parts.size(); ++result.part) {
    result.lean = Lean(pane, seed, lean_parts.at(result.part));
    result.shards = with_solids(pane, all, result.lean, seed);
    if (std::ranges::none_of(result.shards, [](const Shard& shard) { return shard.solid.triangles.empty(); })) break;
  }
  return result;
}

}  // namespace

std::vector<Shard> shards(const Pane& pane, const CrackNetwork& network, std::uint64_t seed) {
  ENSURE(pane.shards.has_value());
  PaneInPieces all = pieces_at_end(pane, network, seed);
  std::vector<Shard> loose = all.shards;
  const std::vector<Shard> at_end = all.shards;
  std::size_t part = 0;
  if (pane.time_us) {
    if (pane.shards->leaning) part = fitted(pane, all, seed, 0).part;  // the same at all times
    all = pieces_at_time(pane, network, all);
  }
  Fitted now = fitted(pane, all, seed, part);
  std::vector<Shard> result = std::move(now.shards);
  let_fall(pane, loose, seed, now.lean);
  std::map<std::string, const Shard*> fallen;  // what left the pane, by id
  for (std::size_t i = 0; i < loose.size(); ++i) {
    if (at_end[i].state != ShardState::standing) fallen[loose[i].id] = &loose[i];
  }
  for (Shard& shard : result) {
    const auto found = fallen.find(shard.id);
    if (shard.state == ShardState::standing || found == fallen.end()) continue;
    shard.state = found->second->state;
    shard.motion = found->second->motion;
  }
  return result;
}

std::map<std::string, std::vector<ShardPlace>> shard_paths(const Pane& pane, const CrackNetwork& network, std::uint64_t seed,
                                                           std::span<const double> times_s) {
  ENSURE(pane.shards.has_value());
  const PaneInPieces all = pieces_at_end(pane, network, seed);
  const Lean lean = pane.shards->leaning ? fitted(pane, all, seed, 0).lean : Lean();
  const std::vector<std::vector<ShardPlace>> places = places_of_fall(pane, all.shards, seed, times_s, lean);
  std::map<std::string, std::vector<ShardPlace>> paths;
  for (std::size_t i = 0; i < all.shards.size(); ++i) {
    if (all.shards[i].state == ShardState::standing) continue;
    std::vector<ShardPlace>& path = paths[all.shards[i].id];
    path.reserve(places.size());
    for (const std::vector<ShardPlace>& now : places) path.push_back(now[i]);
  }
  return paths;
}

}  // namespace shatterpave::glass
