// Each face of the network gives up half the opening along its cracks; what is left is a shard, or several where the face is
// narrower than that somewhere. Then each shard is asked whether it leaves the pane: likely near an impact. Those that have too
// little left to hold them follow, round after round, until what stands stands. What fell is let fall (fall.h).
#include "glass/shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "core/random.h"
#include "geometry/clip.h"
#include "glass/fall.h"
#include "glass/shard_faces.h"
#include "glass/shard_solid.h"

namespace shatterpave::glass {

namespace {

using geometry::FaceRing;
using geometry::FaceSide;
using geometry::Polygon;
using geometry::Region;

// The frame grips a shard that has this part of its border in it, however little else holds it.
constexpr double grip = 0.1;

// Sides of a shard are the pane's edge where they lie within this of it: cutting rounds by 1 µm, and so do ends of cracks.
constexpr double edge_tolerance_mm = 0.003;

// Lines that gaps follow run on beyond the edge by so many openings, so that a gap at an acute angle is cut through.
constexpr double overrun = 4.0;

Id id_of(const Pane& pane, const std::string& shard) { return Id(pane.name).child("shard").child(shard); }

// ---- gaps

// The cracks on a ring: polylines along the sides that are no edge of the pane. Ends on the edge run on beyond it.
void append_cracks(const FaceRing& ring, const std::vector<geometry::Segment>& segments, double gap_mm,
                   std::vector<std::vector<vec2>>& polylines) {
  const std::size_t n = ring.size();
  const auto is_edge = [&](std::size_t i) { return segments[ring[i % n].segment].owner == pane_edge; };
  const auto point = [&](std::size_t i) { return geometry::to_mm(ring[i % n].from); };
  std::size_t first = 0;
  while (first < n && !is_edge(first)) ++first;
  if (first == n) {
    std::vector<vec2>& closed = polylines.emplace_back();
    for (std::size_t i = 0; i < n + 2; ++i) closed.push_back(point(i));
    return;
  }
  const auto beyond = [&](vec2 from, vec2 end) {
    return geometry::on_lattice(end + overrun * gap_mm * glm::normalize(end - from));
  };
  for (std::size_t i = first; i < first + n; ++i) {
    if (is_edge(i)) continue;
    if (is_edge(i + n - 1)) polylines.push_back({beyond(point(i + 1), point(i)), point(i)});
    polylines.back().push_back(point(i + 1));
    if (is_edge(i + 1)) polylines.back().push_back(beyond(point(i), point(i + 1)));
  }
}

// The face less half the opening along its cracks, the largest part first.
std::vector<Region> parts_of(const geometry::Face& face, const std::vector<geometry::Segment>& segments,
                             const ShardRules& rules) {
  std::vector<std::vector<vec2>> cracks;
  append_cracks(face.outline, segments, rules.gap_mm, cracks);
  for (const FaceRing& hole : face.holes) append_cracks(hole, segments, rules.gap_mm, cracks);
  std::vector<Region> parts{region(face)};
  if (!cracks.empty()) parts = geometry::difference(parts.front(), geometry::thickened(cracks, 0.5 * rules.gap_mm));
  std::erase_if(parts, [&](const Region& part) { return geometry::area(part) < rules.splinter_mm2; });
  std::ranges::stable_sort(parts, std::ranges::greater{}, [](const Region& part) { return geometry::area(part); });
  return parts;
}

// ---- the edge of the pane

class PaneEdge {
 public:
  PaneEdge(const geometry::Face& face, const std::vector<geometry::Segment>& segments) {
    for (const FaceSide& side : face.outline) {
      const geometry::Segment& segment = segments[side.segment];
      if (segment.owner == pane_edge) sides_.emplace_back(geometry::to_mm(segment.a), geometry::to_mm(segment.b));
    }
  }
  bool holds(vec2 p) const {
    return std::ranges::any_of(sides_, [&](const auto& side) {
      const vec2 along = side.second - side.first;
      const double share = std::clamp(glm::dot(p - side.first, along) / glm::dot(along, along), 0.0, 1.0);
      const vec2 off = p - side.first - share * along;
      return glm::dot(off, off) <= edge_tolerance_mm * edge_tolerance_mm;
    });
  }

 private:
  std::vector<std::pair<vec2, vec2>> sides_;
};

std::vector<bool> old_sides(const Polygon& ring, const PaneEdge& edge) {
  std::vector<bool> is_old(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const vec2 a = ring[i];
    const vec2 b = ring[(i + 1) % ring.size()];
    is_old[i] = edge.holds(a) && edge.holds(b) && edge.holds(0.5 * (a + b));
  }
  return is_old;
}

// ---- all pieces of the pane

struct Piece {
  Shard shard;
  std::size_t face = 0;
};

std::vector<Piece> pieces_of(const Pane& pane, const FacedPane& faced, std::size_t number, std::uint64_t seed) {
  const ShardFace& face = faced.faces[number];
  const PaneEdge edge(face.face, faced.segments);
  std::vector<Piece> pieces;
  for (Region& part : parts_of(face.face, faced.segments, *pane.shards)) {
    Piece piece;
    piece.face = number;
    piece.shard.id = pieces.empty() ? face.id : fmt::format("{}p{}", face.id, pieces.size());
    ShardBlank blank{part, {old_sides(part.outline, edge)}, pane.thickness_mm, id_of(pane, piece.shard.id)};
    for (const Polygon& hole : part.holes) blank.is_old.emplace_back(hole.size(), false);
    for (std::size_t i = 0; i < part.outline.size(); ++i) {
      if (blank.is_old.front()[i])
        piece.shard.frame_mm += glm::length(part.outline[(i + 1) % part.outline.size()] - part.outline[i]);
    }
    piece.shard.solid = shard_solid(blank, *pane.shards, seed);
    piece.shard.face = std::move(part);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<Piece> all_pieces(const Pane& pane, const FacedPane& faced, std::uint64_t seed) {
  std::vector<std::vector<Piece>> of_faces(faced.faces.size());
  parallel_for(of_faces.size(), [&](std::size_t i) { of_faces[i] = pieces_of(pane, faced, i, seed); });
  std::vector<Piece> pieces;
  for (std::vector<Piece>& some : of_faces) std::ranges::move(some, std::back_inserter(pieces));
  return pieces;
}

// ---- who leaves

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
  return uniform(seed, {Stream::shard_missing, id_of(pane, shard.id)}) < probability;
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

void let_go(const Pane& pane, const FacedPane& faced, std::vector<Piece>& pieces, std::uint64_t seed) {
  std::vector<bool> stands(faced.faces.size(), false);
  for (const Piece& piece : pieces) {
    if (!is_struck_out(pane, piece.shard, seed)) stands[piece.face] = true;
  }
  stands = standing_faces(faced, *pane.shards, std::move(stands));
  for (Piece& piece : pieces) {
    if (stands[piece.face]) continue;
    const double draw = uniform(seed, {Stream::shard_fallen, id_of(pane, piece.shard.id)});
    piece.shard.state = draw < pane.shards->fallen ? ShardState::fallen : ShardState::missing;
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
  std::vector<Piece> pieces = all_pieces(pane, faced, seed);
  let_go(pane, faced, pieces, seed);
  std::vector<Shard> result;
  result.reserve(pieces.size());
  for (Piece& piece : pieces) result.push_back(std::move(piece.shard));
  let_fall(pane, result, seed);
  return result;
}

}  // namespace shatterpave::glass
