// A sweep over the vertices by x, then y (Shamos and Hoey, "Geometric intersection problems", 1976). Edges that meet the sweep
// line are kept in their order along it; two edges that cross are neighbours just before they do, so only neighbours are
// tested. Every decision is an integer one.
//
// Ordering by x, then y, is a sweep line turned by an infinitesimal angle: no edge is parallel to it.
//
// Two things go beyond the textbook. Rings may touch in a point, so around each vertex the edges of the same ring are looked
// at as well; and each edge carries what lies on either side of it (within the outline or not, how many holes), which finds
// holes outside the outline, holes in holes, and rings that pass through each other at a vertex, where no two edges cross.
#include "geometry/simple.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {

namespace {

// What covers a place: the outline or not, and how many holes.
struct Cover {
  bool in_outline = false;
  int holes = 0;
};

struct SweptEdge {
  LatticePoint left;  // the smaller end, by x, then y
  LatticePoint right;
  RingEdge name;
  bool inside_above = false;  // whether the inside of its own ring is above it
  std::size_t index = 0;
  Cover above;
};

// Whether edge a runs below edge b where both meet the sweep line. A total order as long as no two edges cross; edges that
// overlap are told apart by their indices.
struct Below {
  bool operator()(const SweptEdge* a, const SweptEdge* b) const {
    if (a == b) return false;
    if (a->left <= b->left) {
      const Side s = side_of(*a, *b);
      return s == Side::on ? a->index < b->index : s == Side::left;
    }
    const Side s = side_of(*b, *a);
    return s == Side::on ? a->index < b->index : s == Side::right;
  }
  // The side of `first` on which `later` starts, or else goes on.
  static Side side_of(const SweptEdge& first, const SweptEdge& later) {
    const Side s = side(first.left, first.right, later.left);
    return s != Side::on ? s : side(first.left, first.right, later.right);
  }
};

using Status = std::set<SweptEdge*, Below>;

struct Event {
  LatticePoint at;
  std::vector<SweptEdge*> ends;
  std::vector<SweptEdge*> starts;
};

// Exact, unlike the sign of `area`, which rounds.
bool counter_clockwise(const Polygon& ring) {
  __extension__ __int128 twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint a = to_lattice(ring[i]);
    const LatticePoint b = to_lattice(ring[(i + 1) % ring.size()]);
    twice += static_cast<decltype(twice)>(a.x) * b.y - static_cast<decltype(twice)>(a.y) * b.x;
  }
  return twice > 0;
}

void add_edges(std::vector<SweptEdge>& edges, const Polygon& ring, std::size_t number) {
  const bool inside_on_the_left = counter_clockwise(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint a = to_lattice(ring[i]);
    const LatticePoint b = to_lattice(ring[(i + 1) % ring.size()]);
    ENSURE(a != b);
    edges.push_back({std::min(a, b), std::max(a, b), {number, i}, (a < b) == inside_on_the_left, edges.size(), {}});
  }
}

std::vector<SweptEdge> swept_edges(const Polygon& outline, const std::vector<Polygon>& holes) {
  std::vector<SweptEdge> edges;
  add_edges(edges, outline, 0);
  for (std::size_t h = 0; h < holes.size(); ++h) add_edges(edges, holes[h], h + 1);
  return edges;
}

// The vertices in order of the sweep, each with the edges that end and start there.
std::vector<Event> events(std::vector<SweptEdge>& edges) {
  struct Tip {
    LatticePoint at;
    std::size_t edge;
    bool starts;
  };
  std::vector<Tip> tips;
  tips.reserve(2 * edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    tips.push_back({edges[i].left, i, true});
    tips.push_back({edges[i].right, i, false});
  }
  std::ranges::sort(tips, [](const Tip& a, const Tip& b) { return a.at != b.at ? a.at < b.at : a.edge < b.edge; });
  std::vector<Event> result;
  for (const Tip& tip : tips) {
    if (result.empty() || result.back().at != tip.at) result.push_back({tip.at, {}, {}});
    (tip.starts ? result.back().starts : result.back().ends).push_back(&edges[tip.edge]);
  }
  return result;
}

// Where the lines of two edges that cross meet; rounded, for messages only.
vec2 crossing_point(const SweptEdge& a, const SweptEdge& b) {
  const vec2 p = to_mm(a.left);
  const vec2 along_a = to_mm(a.right) - p;
  const vec2 along_b = to_mm(b.right) - to_mm(b.left);
  const double t = cross(to_mm(b.left) - p, along_b) / cross(along_a, along_b);
  return on_lattice(p + t * along_a);
}

std::optional<RegionFault> fault_of(RegionFault::Kind kind, const SweptEdge& a, const SweptEdge& b, vec2 at_mm) {
  const bool ordered = a.index <= b.index;
  return RegionFault{kind, ordered ? a.name : b.name, ordered ? b.name : a.name, at_mm};
}

// Two neighbours of the sweep line: whether they cross or overlap. Touching is judged at the vertices.
std::optional<RegionFault> neighbours_fault(const SweptEdge& a, const SweptEdge& b) {
  if (segments_cross(a.left, a.right, b.left, b.right)) {
    return fault_of(RegionFault::Kind::crossing, a, b, crossing_point(a, b));
  }
  const bool on_one_line = side(a.left, a.right, b.left) == Side::on && side(a.left, a.right, b.right) == Side::on;
  const LatticePoint low = std::max(a.left, b.left);
  if (on_one_line && low < std::min(a.right, b.right)) return fault_of(RegionFault::Kind::overlap, a, b, to_mm(low));
  return std::nullopt;
}

class Sweep {
 public:
  explicit Sweep(std::vector<SweptEdge>& edges) : edges_(edges) {}

  std::optional<RegionFault> fault() {
    for (const Event& event : events(edges_)) {
      if (auto found = repeated_vertex(event)) return found;
      if (auto found = removed(event)) return found;
      if (auto found = inserted(event)) return found;
    }
    return cover_fault_;
  }

 private:
  // Two vertices of one ring in one place.
  static std::optional<RegionFault> repeated_vertex(const Event& event) {
    std::vector<SweptEdge*> tips = event.ends;
    tips.insert(tips.end(), event.starts.begin(), event.starts.end());
    if (tips.size() < 3) return std::nullopt;
    std::ranges::sort(tips, [](const SweptEdge* a, const SweptEdge* b) { return a->index < b->index; });
    for (std::size_t i = 0; i + 2 < tips.size(); ++i) {
      if (tips[i]->name.ring != tips[i + 2]->name.ring) continue;
      return fault_of(RegionFault::Kind::touch, *tips[i], *tips[i + 2], to_mm(event.at));
    }
    return std::nullopt;
  }

  // Takes out the edges that end here, and tests the neighbours that this makes.
  std::optional<RegionFault> removed(const Event& event) {
    if (event.ends.empty()) return std::nullopt;
    if (auto found = through_vertex(event, event.ends)) return found;
    for (SweptEdge* edge : event.ends) {
      const auto after = status_.erase(place_of(edge));
      if (after == status_.begin() || after == status_.end()) continue;
      if (auto found = neighbours_fault(**std::prev(after), **after)) return found;
    }
    return std::nullopt;
  }

  // Puts in the edges that start here, tests them with their neighbours, and notes what they bound.
  std::optional<RegionFault> inserted(const Event& event) {
    if (event.starts.empty()) return std::nullopt;
    for (SweptEdge* edge : event.starts) {
      const auto [at, is_new] = status_.insert(edge);
      ENSURE(is_new);
      if (at != status_.begin()) {
        if (auto found = neighbours_fault(**std::prev(at), *edge)) return found;
      }
      if (std::next(at) != status_.end()) {
        if (auto found = neighbours_fault(*edge, **std::next(at))) return found;
      }
    }
    if (auto found = through_vertex(event, event.starts)) return found;
    cover(event);
    return std::nullopt;
  }

  // An edge of the same ring that passes through the vertex. Edges through the vertex stand together in the status: from
  // the neighbour below the tips to the neighbour above them.
  std::optional<RegionFault> through_vertex(const Event& event, const std::vector<SweptEdge*>& tips) {
    auto [low, high] = block_of(tips);
    if (low != status_.begin()) --low;
    if (high != status_.end()) ++high;
    for (auto at = low; at != high; ++at) {
      const SweptEdge& edge = **at;
      if (edge.left == event.at || edge.right == event.at || !on_segment(edge.left, edge.right, event.at)) continue;
      for (const SweptEdge* tip : tips) {
        if (tip->name.ring == edge.name.ring) return fault_of(RegionFault::Kind::touch, *tip, edge, to_mm(event.at));
      }
    }
    return std::nullopt;
  }

  // Finds what lies below and above each of the edges that start here, from the lowest upwards. A wrong cover is only a fault
  // if no two edges cross, so it is kept until the end.
  void cover(const Event& event) {
    const auto [low, high] = block_of(event.starts);
    Cover cover = low == status_.begin() ? Cover{} : (*std::prev(low))->above;
    for (auto at = low; at != high; ++at) {
      SweptEdge& edge = **at;
      const Cover below = cover;
      if (edge.name.ring == 0) {
        cover.in_outline = !cover.in_outline;
      } else {
        cover.holes += edge.inside_above ? 1 : -1;
      }
      edge.above = cover;
      if (!cover_fault_) cover_fault_ = cover_fault(at, below, event.at);
    }
  }

  std::optional<RegionFault> cover_fault(Status::iterator at, const Cover& below, LatticePoint place) const {
    const SweptEdge& edge = **at;
    for (const Cover& c : {below, edge.above}) {
      if (c.holes > 1) return fault_of(RegionFault::Kind::holes_overlap, edge, edge, to_mm(place));
      if (c.holes > 0 && !c.in_outline) {
        const SweptEdge& hole = *hole_edge_from(at);
        return fault_of(RegionFault::Kind::hole_outside, hole, hole, to_mm(place));
      }
    }
    return std::nullopt;
  }

  // The nearest edge of a hole, from `at` downwards.
  const SweptEdge* hole_edge_from(Status::iterator at) const {
    while ((*at)->name.ring == 0 && at != status_.begin()) --at;
    return *at;
  }

  Status::iterator place_of(SweptEdge* edge) {
    const auto at = status_.find(edge);
    ENSURE(at != status_.end());
    return at;
  }

  // The stretch of the status from the lowest of `tips` to just above the highest.
  std::pair<Status::iterator, Status::iterator> block_of(const std::vector<SweptEdge*>& tips) {
    const auto [low, high] = std::ranges::minmax(tips, Below{});
    return {place_of(low), std::next(place_of(high))};
  }

  std::vector<SweptEdge>& edges_;
  Status status_;
  std::optional<RegionFault> cover_fault_;
};

}  // namespace

std::optional<RegionFault> region_fault(const Polygon& outline, const std::vector<Polygon>& holes) {
  std::vector<SweptEdge> edges = swept_edges(outline, holes);
  return Sweep(edges).fault();
}

Region oriented_region(Polygon outline, std::vector<Polygon> holes) {
  if (!counter_clockwise(outline)) std::reverse(outline.begin() + 1, outline.end());
  for (Polygon& hole : holes) {
    if (counter_clockwise(hole)) std::reverse(hole.begin() + 1, hole.end());
  }
  return {std::move(outline), std::move(holes)};
}

}  // namespace shatterpave::geometry
