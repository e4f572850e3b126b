// Snap rounding (Hobby, "Practical segment intersection with finite precision output", 1999; Guibas and Marimont, "Rounding
// arrangements dynamically", 1998), then winding numbers.
//
// The ends of all sides and the points where two cross, rounded, are hot: so are the squares of the lattice about them. Each
// side is led through the centres of all hot squares that it meets. Sides treated so have nothing in common but ends, so they
// make a planar map, whose faces have one winding number each; what lies between filled and unfilled faces is the border of
// the regions. All decisions are integer ones.
#include "geometry/fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>

#include "core/error.h"
#include "geometry/clip.h"
#include "geometry/planar_map.h"
#include "geometry/predicates.h"
#include "geometry/segment_index.h"
#include "geometry/simple.h"

namespace shatterpave::geometry {

namespace {

__extension__ using Wide = __int128;

// A side of one or more rings; `winding` is how many run from a to b less those from b to a.
struct WoundSide {
  LatticePoint a;
  LatticePoint b;
  int winding = 0;
};

// Each side once, from its smaller end; sides that run as often one way as the other bound nothing and are left out.
std::vector<WoundSide> merged(std::vector<WoundSide> sides) {
  for (WoundSide& side : sides) {
    if (side.b < side.a) side = {side.b, side.a, -side.winding};
  }
  std::ranges::sort(sides, [](const WoundSide& p, const WoundSide& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  std::vector<WoundSide> result;
  for (const WoundSide& side : sides) {
    if (side.a == side.b) continue;
    if (!result.empty() && result.back().a == side.a && result.back().b == side.b) {
      result.back().winding += side.winding;
    } else {
      result.push_back(side);
    }
  }
  std::erase_if(result, [](const WoundSide& side) { return side.winding == 0; });
  return result;
}

std::vector<WoundSide> sides_of(const std::vector<Polygon>& rings) {
  std::vector<WoundSide> sides;
  for (const Polygon& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      sides.push_back({to_lattice(ring[i]), to_lattice(ring[(i + 1) % ring.size()]), 1});
    }
  }
  return merged(std::move(sides));
}

// Cells about as long as a typical side.
SegmentIndex index_of(const std::vector<WoundSide>& sides) {
  double length_mm = 0.0;
  for (const WoundSide& side : sides) length_mm += glm::distance(to_mm(side.a), to_mm(side.b));
  SegmentIndex index(std::max(0.01, length_mm / static_cast<double>(std::max<std::size_t>(1, sides.size()))));
  for (const WoundSide& side : sides) index.add({side.a, side.b});
  return index;
}

std::int64_t rounded_quotient(Wide numerator, Wide denominator) {
  // To the nearest, halves upwards; the denominator is above 0.
  const Wide doubled = 2 * numerator + denominator;
  Wide quotient = doubled / (2 * denominator);
  if (quotient * 2 * denominator > doubled) --quotient;
  return static_cast<std::int64_t>(quotient);
}

// The point where two sides cross, rounded to the lattice.
LatticePoint crossing(const WoundSide& p, const WoundSide& q) {
  const Wide px = p.b.x - p.a.x;
  const Wide py = p.b.y - p.a.y;
  const Wide qx = q.b.x - q.a.x;
  const Wide qy = q.b.y - q.a.y;
  Wide denominator = px * qy - py * qx;
  Wide along = Wide{q.a.x - p.a.x} * qy - Wide{q.a.y - p.a.y} * qx;
  if (denominator < 0) {
    denominator = -denominator;
    along = -along;
  }
  return {p.a.x + rounded_quotient(along * px, denominator), p.a.y + rounded_quotient(along * py, denominator)};
}

std::vector<LatticePoint> hot_points(const std::vector<WoundSide>& sides, const SegmentIndex& index) {
  std::vector<LatticePoint> points;
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const WoundSide& side = sides[i];
    points.push_back(side.a);
    points.push_back(side.b);
    std::vector<int> near;
    index.visit_near(side.a, side.b, [&](int number) {
      if (static_cast<std::size_t>(number) > i) near.push_back(number);
    });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const int number : near) {
      const WoundSide& other = sides[static_cast<std::size_t>(number)];
      if (!segments_cross(side.a, side.b, other.a, other.b)) continue;
      if (++crossings > most_crossings) throw TooManyCrossings("more sides cross than can be followed");
      points.push_back(crossing(side, other));
    }
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Whether a side meets the square of the lattice about a point: of half a step each way, its left and lower borders belong to
// it, the others do not. Doubled coordinates: the square's corners are odd, so no end of a side lies on its border.
bool meets_square(const WoundSide& side, LatticePoint centre) {
  const LatticePoint a{2 * (side.a.x - centre.x), 2 * (side.a.y - centre.y)};
  const LatticePoint b{2 * (side.b.x - centre.x), 2 * (side.b.y - centre.y)};
  if (std::max(a.x, b.x) < -1 || std::min(a.x, b.x) > 1 || std::max(a.y, b.y) < -1 || std::min(a.y, b.y) > 1) return false;
  const Side lower_left = shatterpave::geometry::side(a, b, {-1, -1});
  int left = 0;
  int right = 0;
  for (const LatticePoint corner : {LatticePoint{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Side s = shatterpave::geometry::side(a, b, corner);
    if (s == Side::left) ++left;
    if (s == Side::right) ++right;
  }
  if (left > 0 && right > 0) return true;
  // It only grazes the border: along the left or the lower one, or in the corner between them.
  return lower_left == Side::on;
}

// One pass: leads each side through the hot squares that it meets. Returns nothing if no side has to be moved.
std::optional<std::vector<WoundSide>> snapped(const std::vector<WoundSide>& sides) {
  const SegmentIndex index = index_of(sides);
  std::vector<std::vector<LatticePoint>> stops(sides.size());
  bool changed = false;
  for (const LatticePoint& hot : hot_points(sides, index)) {
    for (const int number : index.near({hot.x - 1, hot.y - 1}, {hot.x + 1, hot.y + 1})) {
      const auto i = static_cast<std::size_t>(number);
      if (!meets_square(sides[i], hot)) continue;
      stops[i].push_back(hot);
      if (hot != sides[i].a && hot != sides[i].b) changed = true;
    }
  }
  if (!changed) return std::nullopt;
  std::vector<WoundSide> pieces;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    // a < b, so x never falls, and y only rises or only falls.
    const std::int64_t up = sides[i].b.y >= sides[i].a.y ? 1 : -1;
    std::ranges::sort(stops[i], [up](LatticePoint p, LatticePoint q) { return p.x != q.x ? p.x < q.x : up * p.y < up * q.y; });
    for (std::size_t k = 0; k + 1 < stops[i].size(); ++k) {
      pieces.push_back({stops[i][k], stops[i][k + 1], sides[i].winding});
    }
  }
  return merged(std::move(pieces));
}

std::vector<WoundSide> noded(std::vector<WoundSide> sides) {
  // One pass makes all sides meet in ends only; the next finds nothing to do.
  constexpr int most_passes = 16;
  for (int pass = 0; pass < most_passes; ++pass) {
    auto next = snapped(sides);
    if (!next) return sides;
    sides = std::move(*next);
  }
  ENSURE(!snapped(sides));
  return sides;
}

std::vector<Segment> segments_of(const std::vector<WoundSide>& sides) {
  std::vector<Segment> segments;
  segments.reserve(sides.size());
  for (const WoundSide& side : sides) segments.push_back({side.a, side.b});
  return segments;
}

// A bounded face, or `outside`.
constexpr int outside = -1;
struct Neighbours {
  int left = outside;
  int right = outside;
};

std::vector<Neighbours> neighbours_of(const std::vector<Face>& map, std::size_t side_count) {
  std::vector<Neighbours> neighbours(side_count);
  const auto note = [&](const FaceRing& ring, int face) {
    for (const FaceSide& side : ring) (side.forward ? neighbours[side.segment].left : neighbours[side.segment].right) = face;
  };
  for (std::size_t f = 0; f < map.size(); ++f) {
    const int face = static_cast<int>(f);
    note(map[f].outline, face);
    for (const FaceRing& hole : map[f].holes) note(hole, face);
    for (const std::size_t spur : map[f].spurs) neighbours[spur] = {face, face};
  }
  return neighbours;
}

// The winding number of each face: that of a neighbour and what the side between them adds, from outside inwards.
std::vector<int> windings_of(const std::vector<Face>& map, const std::vector<WoundSide>& sides,
                             const std::vector<Neighbours>& neighbours) {
  // The outside stands last.
  const auto slot = [&](int face) { return face == outside ? map.size() : static_cast<std::size_t>(face); };
  std::vector<std::vector<std::size_t>> sides_at(map.size() + 1);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (neighbours[i].left == neighbours[i].right) continue;
    sides_at[slot(neighbours[i].left)].push_back(i);
    sides_at[slot(neighbours[i].right)].push_back(i);
  }
  std::vector<std::optional<int>> winding(map.size() + 1);
  winding.back() = 0;
  std::deque<std::size_t> reached{map.size()};
  for (; !reached.empty(); reached.pop_front()) {
    const std::size_t from = reached.front();
    for (const std::size_t i : sides_at[from]) {
      const bool to_left = slot(neighbours[i].right) == from;
      const std::size_t to = slot(to_left ? neighbours[i].left : neighbours[i].right);
      if (winding[to]) continue;
      winding[to] = *winding[from] + (to_left ? sides[i].winding : -sides[i].winding);
      reached.push_back(to);
    }
  }
  std::vector<int> result;
  for (std::size_t f = 0; f < map.size(); ++f) result.push_back(winding[f].value_or(0));
  return result;
}

// Whether a place with that winding number is filled.
using IsFilled = bool (*)(int);

IsFilled is_filled_by(FillRule rule) {
  if (rule == FillRule::nonzero) return [](int winding) { return winding != 0; };
  return [](int winding) { return winding % 2 != 0; };
}

// The sides between filled and unfilled areas, each with the filled one on its left.
std::vector<Segment> border_of(const std::vector<WoundSide>& sides, IsFilled is_filled_at) {
  const std::vector<Face> map = faces(segments_of(sides));
  const std::vector<Neighbours> neighbours = neighbours_of(map, sides.size());
  const std::vector<int> windings = windings_of(map, sides, neighbours);
  const auto is_filled = [&](int face) { return is_filled_at(face == outside ? 0 : windings[static_cast<std::size_t>(face)]); };
  std::vector<Segment> border;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool left = is_filled(neighbours[i].left);
    if (left == is_filled(neighbours[i].right)) continue;
    border.push_back(left ? Segment{sides[i].a, sides[i].b} : Segment{sides[i].b, sides[i].a});
  }
  return border;
}

// Whether the ring is everywhere thinner than the lattice can show.
bool is_sliver(const Polygon& ring) {
  if (ring.size() < 3) return true;
  double round = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) round += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
  return std::abs(area(ring)) <= 0.5 * round / lattice_per_mm;
}

Polygon polygon_of(const FaceRing& ring) {
  Polygon polygon;
  for (const FaceSide& side : ring) polygon.push_back(to_mm(side.from));
  polygon = cleaned(polygon);
  const auto first = std::ranges::min_element(polygon, [](vec2 p, vec2 q) { return to_lattice(p) < to_lattice(q); });
  std::rotate(polygon.begin(), first, polygon.end());
  return polygon;
}

std::vector<Region> regions_within(const std::vector<Segment>& border) {
  std::vector<Region> regions;
  for (const Face& face : faces(border)) {
    if (!face.outline.front().forward) continue;  // the filled area lies on the other side
    Region region{polygon_of(face.outline), {}};
    if (is_sliver(region.outline)) continue;
    for (const FaceRing& ring : face.holes) {
      Polygon hole = polygon_of(ring);
      if (!is_sliver(hole)) region.holes.push_back(std::move(hole));
    }
    regions.push_back(std::move(region));
  }
  const auto leftmost = [](const Region& p, const Region& q) {
    return to_lattice(p.outline.front()) < to_lattice(q.outline.front());
  };
  std::ranges::stable_sort(regions, leftmost);
  return regions;
}

std::vector<Region> filled_where(const std::vector<Polygon>& rings, IsFilled is_filled_at) {
  const std::vector<WoundSide> sides = noded(sides_of(rings));
  return regions_within(border_of(sides, is_filled_at));
}

// Outlines counter-clockwise, holes clockwise.
void append_rings(std::vector<Region> regions, std::vector<Polygon>& rings) {
  for (Region& region : regions) {
    Region wound = oriented_region(std::move(region.outline), std::move(region.holes));
    rings.push_back(std::move(wound.outline));
    std::ranges::move(wound.holes, std::back_inserter(rings));
  }
}

}  // namespace

std::vector<Region> filled(const std::vector<Polygon>& rings, FillRule rule) { return filled_where(rings, is_filled_by(rule)); }

std::vector<Region> filled_without(const Polygon& outline, const std::vector<Polygon>& holes, FillRule rule) {
  std::vector<Polygon> rings;
  for (const Polygon& hole : holes) append_rings(filled({hole}, rule), rings);
  // Reversed, so that each hole takes one off the winding number, which is 1 inside the outline.
  for (Polygon& ring : rings) std::ranges::reverse(ring);
  append_rings(filled({outline}, rule), rings);
  return filled_where(rings, [](int winding) { return winding > 0; });
}

std::vector<Region> without_faults(std::vector<Region> regions) {
  const auto has_fault = [](const Region& region) { return region_fault(region.outline, region.holes).has_value(); };
  if (std::ranges::none_of(regions, has_fault)) return regions;
  std::vector<Polygon> rings;
  append_rings(std::move(regions), rings);
  return filled(rings, FillRule::nonzero);
}

}  // namespace shatterpave::geometry
