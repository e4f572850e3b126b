// The pieces of a broken pane: closed solids with gaps between them, and where each has gone.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"
#include "geometry/polygon.h"
#include "geometry/solid.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

enum class ShardState {
  standing,  // in the frame, where it was
  fallen,    // lies on the sill or the floor
  missing,   // gone
};

// What a triangle of a shard's solid is part of: the slots of its materials.
enum class ShardSurface {
  old = 0,     // front, back and edge of the pane
  broken = 1,  // walls of cracks, bevels and chips along them
};

// A rigid motion: the point p of the pane goes to rows · p + shift_mm.
struct Motion {
  std::array<vec3, 3> rows{vec3{1.0, 0.0, 0.0}, vec3{0.0, 1.0, 0.0}, vec3{0.0, 0.0, 1.0}};
  vec3 shift_mm{0.0, 0.0, 0.0};

  bool operator==(const Motion&) const = default;
};
vec3 moved(const Motion& motion, vec3 p_mm);

struct Shard {
  std::string id;  // as ShardFace; a face that gaps cut in several adds "p1", "p2" … to all but the largest. Of a joined body:
                   // that of its first piece
  std::vector<std::string> joined;  // ids of the pieces that are one body here, in order: two or more, or none
  geometry::Region face;            // of the pane before bevels and chips, in the pane's plane
  geometry::Solid solid;            // slots are ShardSurface; z from 0, the back of the pane, to its thickness
  double frame_mm = 0.0;            // length of its border that the frame holds
  ShardState state = ShardState::standing;
  Motion motion;  // from where it was in the pane to where it is

  bool operator==(const Shard&) const = default;
};

// Where a shard that left the pane is at a time.
struct ShardPlace {
  ShardState state = ShardState::fallen;
  Motion motion;

  bool operator==(const ShardPlace&) const = default;
};

// Its vertices where it was in the pane, z from the middle plane.
vec3 in_pane_mm(const geometry::LatticePoint3& vertex, double thickness_mm);

// All shards of the pane that are larger than a splinter, in an order that depends on the network alone. A pure function of its
// arguments.
//
// Guarantees, exact on the lattice:
// 1. every solid is closed and oriented (geometry/solid.h);
// 2. no two that stand overlap: each lies within its own face, at least half the gap less 2 µm from every crack on its border;
//    where walls lean (lean.h), at no height do two that stand meet: the field leaves a quarter of the gap between them;
// 3. what shards leave of the pane's volume are gaps, bevels, chips and splinters alone.
// 4. rules.joined changes neither who stands nor where what has fallen lies: pieces that stand, and whose faces have a stretch
// of
//    crack in common, are one body then. Its face keeps 2. for the cracks on its border; those within it leave no trace.
// Of those that have fallen, none reaches into another, the sill, the floor or a standing one (fall.h).
//
// At a time_us of the pane, faces are those that its cracks enclose by then; what they do not yet part is one shard, which
// stands. What is whole has its id, its shape and its fate from the end, but for cracks that still grow inside it. With a
// time_s, what left the pane is where it has fallen by then (fall.h): in the pane until it is let go.
//   REQUIRES pane.shards; the network is that of the pane, when all has grown
std::vector<Shard> shards(const Pane& pane, const CrackNetwork& network, std::uint64_t seed);

// Where each shard that leaves the pane is at each of the times, which must not fall (fall.h), by its id. At the pane's time_s
// it is where `shards` has it.
std::map<std::string, std::vector<ShardPlace>> shard_paths(const Pane& pane, const CrackNetwork& network, std::uint64_t seed,
                                                           std::span<const double> times_s);

}  // namespace shatterpave::glass
