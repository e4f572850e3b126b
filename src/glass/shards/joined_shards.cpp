// Who stands was decided piece by piece, and so it stays. The segments with faces that stand on both sides are taken out of the
// map, which then has one face in place of many; that gives up half the gap along what cracks are left on its border, as any
// face does. Chips are those of the pieces, where their edges are still edges.
#include "glass/shards/joined_shards.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/segment_distance.h"
#include "geometry/segment_index.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

namespace {

using geometry::FaceRing;
using geometry::FaceSide;
using geometry::Polygon;
using geometry::Region;

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

template <typename Act>
void visit_sides(const geometry::Face& face, const Act& act) {
  std::ranges::for_each(face.outline, act);
  for (const FaceRing& hole : face.holes) std::ranges::for_each(hole, act);
}

// The face on the left of each segment and that on its right.
std::vector<std::array<std::size_t, 2>> faces_beside(const FacedPane& faced) {
  std::vector<std::array<std::size_t, 2>> beside(faced.segments.size(), {nobody, nobody});
  for (std::size_t i = 0; i < faced.faces.size(); ++i) {
    visit_sides(faced.faces[i].face, [&](const FaceSide& side) { beside[side.segment][side.forward ? 0 : 1] = i; });
  }
  return beside;
}

// Has the face's segments go by `numbers`.
void number_by(const std::vector<std::size_t>& numbers, geometry::Face& face) {
  const auto renumber = [&](FaceRing& ring) {
    for (FaceSide& side : ring) side.segment = numbers[side.segment];
  };
  renumber(face.outline);
  std::ranges::for_each(face.holes, renumber);
}

// ---- bodies

struct Body {
  Shard shard;
  std::vector<std::size_t> pieces;
};

// What both have in common.
double common_mm2(const Region& a, const Region& b) {
  if (!geometry::boxes_meet(geometry::bounding_box(a.outline), geometry::bounding_box(b.outline))) return 0.0;
  double sum = 0.0;
  for (const Region& one : geometry::intersection(a, b)) sum += geometry::area(one);
  return sum;
}

// The part in which most of the piece's corners lie: cutting rounds, so that some may lie 1 µm outside. All of them may where
// nothing of the piece but its border is that of the part: then that which has half of it. None where the cut has left nothing
// there.
std::optional<std::size_t> part_about(const Region& piece, const std::vector<Region>& parts) {
  std::vector<std::ptrdiff_t> inside(parts.size());
  std::ranges::transform(parts, inside.begin(), [&](const Region& part) {
    return std::ranges::count_if(piece.outline, [&](vec2 p) { return geometry::contains(part, p); });
  });
  const auto most = std::ranges::max_element(inside);
  if (most != inside.end() && *most > 0) return static_cast<std::size_t>(most - inside.begin());
  const double half_mm2 = 0.5 * geometry::area(piece);
  const auto about = std::ranges::find_if(parts, [&](const Region& part) { return common_mm2(part, piece) > half_mm2; });
  if (about == parts.end()) return std::nullopt;
  return static_cast<std::size_t>(about - parts.begin());
}

// Whether points lie on the border of a region, but for what cutting rounds.
class ShardBorder {
 public:
  explicit ShardBorder(const Region& region) : index_(cell_mm) {
    add(region.outline);
    std::ranges::for_each(region.holes, [&](const Polygon& hole) { add(hole); });
  }
  bool holds(vec2 p) const {
    const vec2 margin{edge_tolerance_mm, edge_tolerance_mm};
    return std::ranges::any_of(
        index_.near(geometry::to_lattice(p - margin), geometry::to_lattice(p + margin)), [&](int number) {
          const geometry::Segment side = index_.segment(number);
          return geometry::distance_to_segment(p, geometry::to_mm(side.a), geometry::to_mm(side.b)) <= edge_tolerance_mm;
        });
  }

 private:
  static constexpr double cell_mm = 4.0;

  void add(const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      index_.add({geometry::to_lattice(ring[i]), geometry::to_lattice(ring[(i + 1) % ring.size()])});
  }

  geometry::SegmentIndex index_;
};

// The chips of the pieces off edges that are still edges of the region.
Chips chips_left(const Region& region, const std::vector<const ShardPiece*>& pieces, const ShardRules& rules,
                 std::uint64_t seed) {
  const ShardBorder border(region);
  Chips left;
  const auto keep = [&](std::vector<Chip>& chips, std::vector<Chip>& kept) {
    std::erase_if(chips, [&](const Chip& chip) { return !border.holds(chip.at_mm); });
    std::ranges::move(chips, std::back_inserter(kept));
  };
  for (const ShardPiece* piece : pieces) {
    Chips some = chips(piece->blank, rules, seed);
    keep(some.front, left.front);
    keep(some.back, left.back);
  }
  return left;
}

Shard joined_body(const Pane& pane, const FacedPane& faced, const JoinedFace& joined, Region part,
                  const std::vector<const ShardPiece*>& pieces, std::uint64_t seed, const Lean& lean) {
  ShardPiece piece = piece_of(pane, joined.face, faced.segments, std::move(part), pieces.front()->id);
  Shard shard;
  shard.id = piece.id;
  if (pieces.size() > 1) {
    for (const ShardPiece* one : pieces) shard.joined.push_back(one->id);
  }
  shard.frame_mm = piece.frame_mm;
  shard.solid = shard_solid(piece.blank, *pane.shards, chips_left(piece.blank.region, pieces, *pane.shards, seed), lean);
  shard.face = std::move(piece.blank.region);
  return shard;
}

// The bodies of the face. Pieces of it may be in none: what the hole takes off a piece may be too little for a cut, and enough
// where several are one.
std::vector<Body> bodies_of(const Pane& pane, const FacedPane& faced, const JoinedFace& joined, const std::vector<Region>& hole,
                            const std::vector<ShardPiece>& pieces, std::uint64_t seed, const Lean& lean) {
  // Where pieces stand that are less than a splinter, so do bodies of them.
  const ShardRules rules = rules_of_standing(*pane.shards, hole);
  std::vector<Region> parts = cut_parts(parts_of(joined.face, faced.segments, rules), hole, rules).outside;
  std::vector<std::vector<std::size_t>> within(parts.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].leaves || !std::ranges::binary_search(joined.faces, pieces[i].face)) continue;
    if (const auto part = part_about(pieces[i].blank.region, parts)) within[*part].push_back(i);
  }
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (within[i].empty()) continue;  // splinters side by side
    std::vector<const ShardPiece*> some(within[i].size());
    std::ranges::transform(within[i], some.begin(), [&](std::size_t piece) { return &pieces[piece]; });
    bodies.push_back({joined_body(pane, faced, joined, std::move(parts[i]), some, seed, lean), std::move(within[i])});
  }
  return bodies;
}

}  // namespace

std::vector<JoinedFace> joined_faces(const FacedPane& faced, const std::vector<bool>& stands) {
  const std::vector<std::array<std::size_t, 2>> beside = faces_beside(faced);
  DisjointSets companies(faced.faces.size());  // of faces that stand together
  std::vector<std::size_t> kept;
  std::vector<geometry::Segment> segments;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    const auto [left, right] = beside[i];
    if (left != nobody && right != nobody && stands[left] && stands[right]) {
      companies.join(left, right);
    } else if (left != right || faced.segments[i].owner == pane_edge) {
      kept.push_back(i);
      segments.push_back(faced.segments[i]);
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> members;  // by the least of them
  for (std::size_t i = 0; i < faced.faces.size(); ++i) members[companies.of(i)].push_back(i);
  std::vector<JoinedFace> result;
  for (geometry::Face& face : geometry::faces(segments, faced.outward)) {
    const FaceSide& side = face.outline.front();
    const std::size_t old = beside[kept[side.segment]][side.forward ? 0 : 1];
    if (old == nobody || members[companies.of(old)].size() < 2) continue;
    number_by(kept, face);
    result.push_back({members[companies.of(old)], std::move(face)});
  }
  return result;
}

std::vector<Shard> joined_shards(const Pane& pane, const FacedPane& faced, const std::vector<Region>& hole,
                                 const std::vector<ShardPiece>& pieces, std::vector<Shard> shards, std::uint64_t seed,
                                 const Lean& lean) {
  std::vector<bool> stands(faced.faces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (shards[i].state == ShardState::standing) stands[pieces[i].face] = true;
  }
  const std::vector<JoinedFace> joined = joined_faces(faced, stands);
  std::vector<std::vector<Body>> bodies(joined.size());
  parallel_for(joined.size(), [&](std::size_t i) { bodies[i] = bodies_of(pane, faced, joined[i], hole, pieces, seed, lean); });
  std::vector<bool> is_joined(pieces.size(), false);
  std::map<std::size_t, Shard> body_at;  // by its first piece
  for (std::vector<Body>& some : bodies) {
    for (Body& one : some) {
      for (const std::size_t piece : one.pieces) is_joined[piece] = true;
      body_at[one.pieces.front()] = std::move(one.shard);
    }
  }
  parallel_for(pieces.size(), [&](std::size_t i) {
    if (!is_joined[i])
      shards[i].solid = shard_solid(pieces[i].blank, *pane.shards, chips(pieces[i].blank, *pane.shards, seed), lean);
  });
  std::vector<Shard> result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (const auto body = body_at.find(i); body != body_at.end()) {
      result.push_back(std::move(body->second));
    } else if (!is_joined[i]) {
      result.push_back(std::move(shards[i]));
    }
  }
  return result;
}

}  // namespace shatterpave::glass
