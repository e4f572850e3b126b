#include "glass/shards/shard_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/contacts.h"
#include "geometry/needles.h"
#include "geometry/segment_distance.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

namespace {

using geometry::FaceRing;
using geometry::FaceSide;
using geometry::Polygon;
using geometry::Region;

// Lines that gaps follow run on beyond the edge by so many openings, so that a gap at an acute angle is cut through.
constexpr double gap_overrun = 4.0;

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
    return geometry::on_lattice(end + gap_overrun * gap_mm * glm::normalize(end - from));
  };
  for (std::size_t i = first; i < first + n; ++i) {
    if (is_edge(i)) continue;
    if (is_edge(i + n - 1)) polylines.push_back({beyond(point(i + 1), point(i)), point(i)});
    polylines.back().push_back(point(i + 1));
    if (is_edge(i + 1)) polylines.back().push_back(beyond(point(i), point(i + 1)));
  }
}

// Vertices of a part that were on the pane's edge lie within this of it: cutting rounds by 0.7 µm, and once more where parts
// are cut off one another.
constexpr double cut_tolerance_mm = 0.002;

// The sides of a face that are of the pane's edge.
class PaneEdge {
 public:
  PaneEdge(const geometry::Face& face, const std::vector<geometry::Segment>& segments) {
    const std::size_t n = face.outline.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (segments[face.outline[i].segment].owner != pane_edge) continue;
      sides_.emplace_back(geometry::to_mm(face.outline[i].from), geometry::to_mm(face.outline[(i + 1) % n].from));
    }
  }
  // Whether the side from a to b is what is left of them: it lies on them, and runs as they do. So the short first stretch of a
  // crack's wall, and the wall of what is left between the edge and a crack beside it, are not.
  bool holds(vec2 a, vec2 b) const {
    const vec2 middle = 0.5 * (a + b);
    const auto nearest = std::ranges::min_element(
        sides_, {}, [&](const auto& side) { return geometry::distance_to_segment(middle, side.first, side.second); });
    if (nearest == sides_.end() || !runs_near(a, b)) return false;
    const vec2 along = nearest->second - nearest->first;
    return glm::dot(b - a, along) > std::abs(cross(along, b - a));
  }

 private:
  // All the way, also where corners of the edge are very flat.
  bool runs_near(vec2 a, vec2 b) const {
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i) {
      if (!is_near(glm::mix(a, b, static_cast<double>(i) / steps))) return false;
    }
    return true;
  }

  bool is_near(vec2 p) const {
    return std::ranges::any_of(sides_, [&](const auto& side) {
      return geometry::distance_to_segment(p, side.first, side.second) <= cut_tolerance_mm;
    });
  }

  std::vector<std::pair<vec2, vec2>> sides_;
};

// A part that the hole takes less of is not cut, one of which it leaves less is gone.
constexpr double least_cut_mm2 = 0.01;

// Away from the hole pieces that are dust elsewhere stay in their place: a pane has one hole, and not a speck missing beside
// it.
constexpr double least_standing_mm2 = 0.05;

std::vector<bool> old_sides(const Polygon& ring, const PaneEdge& edge) {
  std::vector<bool> is_old(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) is_old[i] = edge.holds(ring[i], ring[(i + 1) % ring.size()]);
  return is_old;
}

// What is narrower is no glass: what rounding leaves between a gap and the edge, or another gap, metres long on large panes.
constexpr double sliver_mm = 0.004;

// By so much parts whose rings would touch where rounding has closed a narrow bay are drawn in.
constexpr double contact_mm = 0.004;

std::vector<Region> shrunk(const std::vector<Region>& regions) {
  std::vector<Region> result;
  for (const Region& region : regions) std::ranges::move(geometry::offset(region, -contact_mm), std::back_inserter(result));
  return result;
}

}  // namespace

Id shard_id(const Pane& pane, const std::string& shard) { return Id(pane.name).child("shard").child(shard); }

std::vector<Region> parts_of(const geometry::Face& face, const std::vector<geometry::Segment>& segments,
                             const ShardRules& rules) {
  std::vector<std::vector<vec2>> cracks;
  append_cracks(face.outline, segments, rules.gap_mm, cracks);
  for (const FaceRing& hole : face.holes) append_cracks(hole, segments, rules.gap_mm, cracks);
  std::vector<Region> parts{region(face)};
  if (!cracks.empty()) parts = geometry::difference(parts.front(), geometry::thickened(cracks, 0.5 * rules.gap_mm));
  parts = geometry::without_slivers(geometry::parted(std::move(parts)), sliver_mm);
  std::erase_if(parts, [&](const Region& part) { return geometry::area(part) < rules.splinter_mm2; });
  std::ranges::stable_sort(parts, std::ranges::greater{}, [](const Region& part) { return geometry::area(part); });
  return parts;
}

ShardPiece piece_of(const Pane& pane, const geometry::Face& face, const std::vector<geometry::Segment>& segments, Region part,
                    std::string id) {
  ShardPiece piece;
  piece.blank = {std::move(part), {}, pane.thickness_mm, shard_id(pane, id)};
  piece.id = std::move(id);
  const Polygon& outline = piece.blank.region.outline;
  piece.blank.is_old.push_back(old_sides(outline, PaneEdge(face, segments)));
  for (const Polygon& hole : piece.blank.region.holes) piece.blank.is_old.emplace_back(hole.size(), false);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (piece.blank.is_old.front()[i]) piece.frame_mm += glm::length(outline[(i + 1) % outline.size()] - outline[i]);
  }
  return piece;
}

ShardRules rules_of_standing(ShardRules rules, const std::vector<Region>& hole) {
  if (!hole.empty()) rules.splinter_mm2 = std::min(rules.splinter_mm2, least_standing_mm2);
  return rules;
}

namespace {

// What the hole takes of a part.
double area_within_mm2(const Region& part, const std::vector<Region>& hole) {
  double within_mm2 = 0.0;
  for (const Region& one : hole) {
    if (!geometry::boxes_meet(geometry::bounding_box(part.outline), geometry::bounding_box(one.outline))) continue;
    for (const Region& region : geometry::intersection(part, one)) within_mm2 += geometry::area(region);
  }
  return within_mm2;
}

// Cuts the part along the border of the hole, with a gap.
void cut_along(const Region& part, const std::vector<Region>& hole, double gap_mm, CutParts& cut) {
  for (const Region& one : hole) {
    for (const Region& less : geometry::offset(one, -gap_mm)) {
      std::ranges::move(geometry::intersection(part, less), std::back_inserter(cut.inside));
    }
  }
  std::ranges::move(geometry::difference(part, hole), std::back_inserter(cut.outside));
}

// Adds those that are no splinters, the largest first.
void add_cut(std::vector<Region> some, double splinter_mm2, std::vector<Region>& all) {
  const auto is_splinter = [&](const Region& part) { return geometry::area(part) < splinter_mm2; };
  some = geometry::without_slivers(some, sliver_mm);
  std::erase_if(some, is_splinter);
  if (!geometry::contacts(geometry::rings_of(some)).empty()) some = geometry::parted(shrunk(some));
  std::erase_if(some, is_splinter);
  std::ranges::move(some, std::back_inserter(all));
  std::ranges::stable_sort(all, std::ranges::greater{}, [](const Region& part) { return geometry::area(part); });
}

}  // namespace

CutParts cut_parts(std::vector<Region> parts, const std::vector<Region>& hole, const ShardRules& rules) {
  CutParts whole;  // what the border of the hole does not cut stays as it is, since cutting rounds
  CutParts cut;
  for (Region& part : parts) {
    const double gone_mm2 = area_within_mm2(part, hole);
    if (gone_mm2 < least_cut_mm2) {
      whole.outside.push_back(std::move(part));
    } else if (gone_mm2 > geometry::area(part) - least_cut_mm2) {
      whole.inside.push_back(std::move(part));
    } else {
      cut_along(part, hole, rules.gap_mm, cut);
    }
  }
  add_cut(std::move(cut.outside), rules.splinter_mm2, whole.outside);
  add_cut(std::move(cut.inside), rules.splinter_mm2, whole.inside);
  return whole;
}

std::vector<ShardPiece> shard_pieces(const Pane& pane, const FacedPane& faced, const std::vector<Region>& hole,
                                     const std::vector<bool>& is_whole) {
  const std::vector<Region> none;
  std::vector<std::vector<ShardPiece>> of_faces(faced.faces.size());
  parallel_for(of_faces.size(), [&](std::size_t i) {
    const ShardFace& face = faced.faces[i];
    const ShardRules rules = rules_of_standing(*pane.shards, hole);
    CutParts cut = cut_parts(parts_of(face.face, faced.segments, rules), is_whole[i] ? hole : none, *pane.shards);
    std::erase_if(cut.inside, [&](const Region& part) { return geometry::area(part) < pane.shards->splinter_mm2; });
    const auto add = [&](Region& part, bool leaves) {
      const std::size_t number = of_faces[i].size();
      of_faces[i].push_back(piece_of(pane, face.face, faced.segments, std::move(part),
                                     number == 0 ? face.id : fmt::format("{}p{}", face.id, number)));
      of_faces[i].back().face = i;
      of_faces[i].back().leaves = leaves;
    };
    for (Region& part : cut.outside) add(part, false);
    for (Region& part : cut.inside) add(part, true);
  });
  std::vector<ShardPiece> pieces;
  for (std::vector<ShardPiece>& some : of_faces) std::ranges::move(some, std::back_inserter(pieces));
  return pieces;
}

}  // namespace shatterpave::glass
