#include "glass/shards/shard_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>

#include "core/disjoint_sets.h"
#include "core/error.h"

namespace shatterpave::glass {

namespace {

using geometry::FaceRing;
using geometry::FaceSide;
using geometry::LatticePoint;
using geometry::Segment;

__extension__ using Wide = __int128;

std::vector<LatticePoint> lattice_points(const std::vector<vec2>& points_mm) {
  std::vector<LatticePoint> points(points_mm.size());
  std::ranges::transform(points_mm, points.begin(), [](vec2 p) { return geometry::to_lattice(p); });
  return points;
}

double squared_distance(LatticePoint p, LatticePoint a, LatticePoint b) {
  const vec2 ab = geometry::to_mm(b) - geometry::to_mm(a);
  const vec2 ap = geometry::to_mm(p) - geometry::to_mm(a);
  const double share = std::clamp(glm::dot(ap, ab) / glm::dot(ab, ab), 0.0, 1.0);
  const vec2 off = ap - share * ab;
  return glm::dot(off, off);
}

std::size_t nearest_side(const std::vector<LatticePoint>& outline, LatticePoint p) {
  std::size_t nearest = 0;
  double least = -1.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double distance = squared_distance(p, outline[i], outline[(i + 1) % outline.size()]);
    if (least >= 0.0 && distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

// A direction out of the pane at a corner, half-way between its sides.
LatticePoint outward_at(LatticePoint before, LatticePoint corner, LatticePoint after) {
  constexpr double parts = 1e6;
  const vec2 in = glm::normalize(geometry::to_mm(corner) - geometry::to_mm(before));
  const vec2 out = glm::normalize(geometry::to_mm(after) - geometry::to_mm(corner));
  const vec2 along = in + out;
  return {std::llround(parts * along.y), std::llround(-parts * along.x)};
}

struct Edge {
  std::vector<LatticePoint> points;
  std::vector<LatticePoint> outward;  // a direction out of the pane at each
};

// The corners of the pane and, between them, the points at which cracks end on its edge.
Edge edge_of(const std::vector<LatticePoint>& outline, const CrackNetwork& network) {
  std::map<std::size_t, std::vector<LatticePoint>> on_edge;
  for (const Crack& crack : network.cracks) {
    const auto note = [&](vec2 end_mm) {
      const LatticePoint end = geometry::to_lattice(end_mm);
      on_edge[nearest_side(outline, end)].push_back(end);
    };
    if (crack.start.at == CrackEnd::At::edge) note(crack.points_mm.front());
    if (crack.end.at == CrackEnd::At::edge) note(crack.points_mm.back());
  }
  Edge edge;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const LatticePoint a = outline[i];
    const LatticePoint b = outline[(i + 1) % outline.size()];
    const auto along = [&](LatticePoint p) {
      return static_cast<Wide>(p.x - a.x) * (b.x - a.x) + static_cast<Wide>(p.y - a.y) * (b.y - a.y);
    };
    edge.points.push_back(a);
    edge.outward.push_back(outward_at(outline[(i + outline.size() - 1) % outline.size()], a, b));
    std::vector<LatticePoint>& ends = on_edge[i];
    std::ranges::sort(ends, [&](LatticePoint p, LatticePoint q) { return along(p) != along(q) ? along(p) < along(q) : p < q; });
    for (const LatticePoint end : ends) {
      if (end == edge.points.back() || end == b) continue;
      edge.points.push_back(end);
      edge.outward.push_back({b.y - a.y, a.x - b.x});
    }
  }
  return edge;
}

// The face on each side of each segment, left first; −1 where there is none or the segment is a spur.
using Sides = std::vector<std::array<int, 2>>;

Sides sides_of(const std::vector<geometry::Face>& faces, std::size_t segments) {
  Sides sides(segments, {-1, -1});
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto note = [&](const FaceRing& ring) {
      for (const FaceSide& side : ring) sides[side.segment][side.forward ? 0 : 1] = static_cast<int>(i);
    };
    note(faces[i].outline);
    std::ranges::for_each(faces[i].holes, note);
  }
  return sides;
}

struct FaceName {
  int crack = -1;
  int side = 0;  // 0: left
  int ordinal = 0;

  auto operator<=>(const FaceName&) const = default;
};

// Names the faces along one side of the cracks where that makes their names less. Segments of one crack stand in succession,
// from its start.
void name_along(int side, const std::vector<Segment>& segments, const Sides& sides, std::vector<FaceName>& names) {
  int last = -1;
  int ordinal = -1;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const int crack = segments[i].owner;
    if (i == 0 || segments[i - 1].owner != crack) last = ordinal = -1;
    const int face = sides[i][static_cast<std::size_t>(side)];
    if (crack == pane_edge || face < 0) continue;
    if (face != last) ++ordinal;
    last = face;
    FaceName& name = names[static_cast<std::size_t>(face)];
    const FaceName other{crack, side, ordinal};
    if (name.crack < 0 || other < name) name = other;
  }
}

std::string text_of(const FaceName& name) {
  if (name.crack < 0) return "whole";
  return fmt::format("c{}{}{}", name.crack, name.side == 0 ? 'l' : 'r', name.ordinal);
}

std::vector<std::string> names(const std::vector<Segment>& segments, const std::vector<geometry::Face>& faces) {
  const Sides sides = sides_of(faces, segments.size());
  std::vector<FaceName> names(faces.size());
  for (const int side : {0, 1}) name_along(side, segments, sides, names);
  std::vector<std::string> texts(names.size());
  std::ranges::transform(names, texts.begin(), text_of);
  return texts;
}

geometry::Polygon polygon(const FaceRing& ring) {
  geometry::Polygon result(ring.size());
  std::ranges::transform(ring, result.begin(), [](const FaceSide& side) { return geometry::to_mm(side.from); });
  return result;
}

}  // namespace

FacedPane faced_pane(const Pane& pane, const CrackNetwork& network) {
  FacedPane result;
  auto [edge, outward] = edge_of(lattice_points(pane.outline_mm), network);
  for (std::size_t i = 0; i < edge.size(); ++i) result.segments.push_back({edge[i], edge[(i + 1) % edge.size()], pane_edge});
  for (const Crack& crack : network.cracks) {
    if (!crack.through) continue;
    const std::vector<LatticePoint> points = lattice_points(crack.points_mm);
    for (std::size_t i = 1; i < points.size(); ++i) result.segments.push_back({points[i - 1], points[i], crack.id});
  }
  std::vector<geometry::Face> faces = geometry::faces(result.segments, outward);
  result.outward = std::move(outward);
  std::vector<std::string> ids = names(result.segments, faces);
  for (std::size_t i = 0; i < faces.size(); ++i) result.faces.push_back({std::move(ids[i]), std::move(faces[i])});
  return result;
}

namespace {

// For each segment of the map of `now` the one of the map at the end that it is; of one that is cut off at a tip none.
struct NowSegments {
  static constexpr std::size_t cut_off = static_cast<std::size_t>(-1);

  std::vector<geometry::Segment> segments;
  std::vector<std::size_t> at_end;
};

NowSegments segments_now(const FacedPane& end, const CrackNetwork& network, const CrackNetwork& now) {
  NowSegments result;
  std::size_t next = 0;
  for (; next < end.segments.size() && end.segments[next].owner == pane_edge; ++next) {
    result.segments.push_back(end.segments[next]);
    result.at_end.push_back(next);
  }
  auto grown = now.cracks.begin();
  for (const Crack& crack : network.cracks) {
    if (!crack.through) continue;
    while (grown != now.cracks.end() && grown->id < crack.id) ++grown;
    if (grown != now.cracks.end() && grown->id == crack.id) {
      const std::vector<LatticePoint> points = lattice_points(grown->points_mm);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const geometry::Segment segment{points[i - 1], points[i], crack.id};
        result.at_end.push_back(segment == end.segments[next + i - 1] ? next + i - 1 : NowSegments::cut_off);
        result.segments.push_back(segment);
      }
    }
    next += crack.points_mm.size() - 1;
  }
  return result;
}

}  // namespace

GrownFaces grown_faces(const FacedPane& end, const CrackNetwork& network, const CrackNetwork& now) {
  const NowSegments there = segments_now(end, network, now);
  std::vector<geometry::Face> at_end(end.faces.size());
  std::ranges::transform(end.faces, at_end.begin(), &ShardFace::face);
  const Sides sides = sides_of(at_end, end.segments.size());
  std::vector<bool> is_there(end.segments.size(), false);
  for (const std::size_t segment : there.at_end) {
    if (segment != NowSegments::cut_off) is_there[segment] = true;
  }
  DisjointSets companies(end.faces.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (is_there[i] || sides[i][0] < 0 || sides[i][1] < 0) continue;
    companies.join(static_cast<std::size_t>(sides[i][0]), static_cast<std::size_t>(sides[i][1]));
  }
  std::vector<std::vector<std::size_t>> members(end.faces.size());
  for (std::size_t i = 0; i < end.faces.size(); ++i) members[companies.of(i)].push_back(i);
  GrownFaces result;
  for (geometry::Face& face : geometry::faces(there.segments, end.outward)) {
    const FaceSide& side = face.outline.front();
    const std::size_t segment = there.at_end[side.segment];
    ENSURE(segment != NowSegments::cut_off);  // a tip is at no border
    const int within = sides[segment][side.forward ? 0 : 1];
    ENSURE(within >= 0);
    const std::vector<std::size_t>& pieces = members[companies.of(static_cast<std::size_t>(within))];
    result.pane.faces.push_back({end.faces[pieces.front()].id, std::move(face)});
    result.is_whole.push_back(pieces.size() == 1);
    result.becomes.push_back(pieces.front());
  }
  result.pane.segments = there.segments;
  result.pane.outward = end.outward;
  return result;
}

geometry::Region region(const geometry::Face& face) {
  geometry::Region result{polygon(face.outline), {}};
  for (const FaceRing& hole : face.holes) result.holes.push_back(polygon(hole));
  return result;
}

}  // namespace shatterpave::glass
