#include "glass/network_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "glass/gaps/crack_faces.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
__extension__ using Wide = __int128;

struct Piece {
  LatticePoint a;
  LatticePoint b;
  int crack = 0;

  std::int64_t low_x() const { return std::min(a.x, b.x); }
  std::int64_t high_x() const { return std::max(a.x, b.x); }
};

CrackFaces::Polyline on_lattice(const Crack& crack) {
  CrackFaces::Polyline points(crack.points_mm.size());
  std::ranges::transform(crack.points_mm, points.begin(), [](vec2 p) { return geometry::to_lattice(p); });
  return points;
}

std::vector<Piece> pieces(const CrackNetwork& network) {
  std::vector<Piece> all;
  for (const Crack& crack : network.cracks) {
    const CrackFaces::Polyline points = on_lattice(crack);
    for (std::size_t i = 1; i < points.size(); ++i) all.push_back({points[i - 1], points[i], crack.id});
  }
  return all;
}

std::vector<Piece> sides(const geometry::Polygon& outline) {
  std::vector<Piece> all;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    all.push_back({geometry::to_lattice(outline[i]), geometry::to_lattice(outline[(i + 1) % outline.size()]), -1});
  }
  return all;
}

// Calls visit(p, q) once for every two pieces whose boxes have a point in common; others cannot touch.
template <typename Visit>
void visit_pairs(std::vector<Piece> all, Visit visit) {
  std::ranges::sort(all, {}, &Piece::low_x);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size() && all[j].low_x() <= all[i].high_x(); ++j) {
      const auto [low, high] = std::minmax(all[i].a.y, all[i].b.y);
      if (std::max(all[j].a.y, all[j].b.y) >= low && std::min(all[j].a.y, all[j].b.y) <= high) visit(all[i], all[j]);
    }
  }
}

bool in_middle(const Piece& piece, LatticePoint p) {
  return p != piece.a && p != piece.b && geometry::on_segment(piece.a, piece.b, p);
}

// Whether the point is within one unit of the lattice of the piece.
bool is_near(LatticePoint p, const Piece& piece) {
  const auto dot = [](LatticePoint o, LatticePoint u, LatticePoint v) {
    return static_cast<Wide>(u.x - o.x) * (v.x - o.x) + static_cast<Wide>(u.y - o.y) * (v.y - o.y);
  };
  const Wide along = dot(piece.a, piece.b, p);
  const Wide length = dot(piece.a, piece.b, piece.b);
  if (along < 0 || along > length) return dot(p, piece.a, piece.a) <= 1 || dot(p, piece.b, piece.b) <= 1;
  const Wide off = static_cast<Wide>(piece.b.x - piece.a.x) * (p.y - piece.a.y) -
                   static_cast<Wide>(piece.b.y - piece.a.y) * (p.x - piece.a.x);
  return off * off <= length;
}

class Faults {
 public:
  template <typename... Arguments>
  void add(const Crack& crack, fmt::format_string<Arguments...> what, Arguments&&... arguments) {
    found.push_back(fmt::format("crack {}: {}", crack.id, fmt::format(what, std::forward<Arguments>(arguments)...)));
  }
  std::vector<std::string> found;
};

// The crack with the id, if there is one.
const Crack* crack_with(const CrackNetwork& network, int id) {
  const auto found = std::ranges::find(network.cracks, id, &Crack::id);
  return found == network.cracks.end() ? nullptr : &*found;
}

// Whether the point is one of the crack's vertices.
bool is_vertex(LatticePoint p, const Crack& crack) {
  const CrackFaces::Polyline points = on_lattice(crack);
  return std::ranges::find(points, p) != points.end();
}

bool may_start(CrackKind kind, CrackEnd::At at) {
  switch (kind) {
    case CrackKind::circular:
    case CrackKind::rung:
      return at == CrackEnd::At::ring;
    case CrackKind::branch:
    case CrackKind::chip:
      return at == CrackEnd::At::crack;
    case CrackKind::dice:
      return at == CrackEnd::At::impact || at == CrackEnd::At::crack || at == CrackEnd::At::origin;
    case CrackKind::large:
    case CrackKind::radial:
      break;
  }
  return at == CrackEnd::At::impact;
}

void check_start(const Crack& crack, const CrackNetwork& network, Faults& faults) {
  if (crack.impact < 0 || crack.impact >= static_cast<int>(network.impacts.size())) return faults.add(crack, "of no impact");
  if (!may_start(crack.kind, crack.start.at)) faults.add(crack, "a wrong start");
  if (crack.start.crack.has_value() != (crack.start.at == CrackEnd::At::crack)) faults.add(crack, "a start without its crack");
  const vec2 impact = network.impacts[static_cast<std::size_t>(crack.impact)].at_mm;
  if (crack.start.at == CrackEnd::At::impact && crack.points_mm.front() != impact) {
    faults.add(crack, "does not start at its impact");
  }
  if (crack.start.crack) {
    const Crack* on = *crack.start.crack == crack.id ? nullptr : crack_with(network, *crack.start.crack);
    if (on == nullptr || !is_vertex(geometry::to_lattice(crack.points_mm.front()), *on)) {
      faults.add(crack, "starts on no crack");
    }
  }
  const auto starts_with = [&](const Crack& other) {
    return other.kind == CrackKind::circular && other.points_mm.front() == crack.points_mm.front();
  };
  if (crack.kind == CrackKind::circular && std::ranges::count_if(network.cracks, starts_with) > 2) {
    faults.add(crack, "a third arm");
  }
}

void check_end(const Crack& crack, const CrackNetwork& network, const std::vector<Piece>& edge, Faults& faults) {
  const LatticePoint tip = geometry::to_lattice(crack.points_mm.back());
  const bool at_edge = std::ranges::any_of(edge, [&](const Piece& side) { return is_near(tip, side); });
  if (crack.end.at == CrackEnd::At::edge && !at_edge) faults.add(crack, "ends off the edge");
  if (crack.end.at == CrackEnd::At::impact || crack.end.at == CrackEnd::At::ring) faults.add(crack, "ends at a start");
  if (crack.end.at != CrackEnd::At::crack) {
    if (crack.end.crack) faults.add(crack, "names a crack that it does not end on");
    return;
  }
  const Crack* const met = crack.end.crack ? crack_with(network, *crack.end.crack) : nullptr;
  if (met == nullptr) return faults.add(crack, "ends on no crack");
  const Crack& other = *met;
  if (other.impact > crack.impact) faults.add(crack, "stopped at a later impact's crack {}", other.id);
  const CrackFaces::Polyline points = on_lattice(other);
  const auto end = other.id == crack.id ? points.end() - 1 : points.end();
  if (std::find(points.begin(), end, tip) == end) faults.add(crack, "ends beside a vertex of crack {}", other.id);
}

void check_points(const Crack& crack, const geometry::Polygon& outline, const std::vector<Piece>& edge, Faults& faults) {
  for (const vec2& p : crack.points_mm) {
    if (p != geometry::on_lattice(p)) faults.add(crack, "a vertex off the lattice");
    if (!geometry::contains(outline, p)) faults.add(crack, "a vertex outside the pane");
  }
  if (std::ranges::adjacent_find(crack.points_mm) != crack.points_mm.end()) faults.add(crack, "a vertex twice running");
  const CrackFaces::Polyline points = on_lattice(crack);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto on_edge = [&](const Piece& side) { return geometry::on_segment(side.a, side.b, points[i]); };
    if (std::ranges::any_of(edge, on_edge)) faults.add(crack, "goes on beyond the edge at vertex {} of {}", i, points.size());
  }
}

// Which cracks come through each point without starting or ending there.
void check_meetings(const CrackNetwork& network, Faults& faults) {
  std::vector<std::pair<LatticePoint, int>> through;
  for (const Crack& crack : network.cracks) {
    const CrackFaces::Polyline points = on_lattice(crack);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) through.emplace_back(points[i], crack.id);
  }
  std::ranges::sort(through);
  for (std::size_t i = 1; i < through.size(); ++i) {
    if (through[i].first != through[i - 1].first) continue;
    faults.found.push_back(fmt::format("cracks {} and {} both go on through ({}, {}) µm", through[i - 1].second,
                                       through[i].second, through[i].first.x, through[i].first.y));
  }
}

void check_pairs(const CrackNetwork& network, const std::vector<Piece>& edge, Faults& faults) {
  std::vector<Piece> all = pieces(network);
  all.insert(all.end(), edge.begin(), edge.end());
  visit_pairs(all, [&](const Piece& p, const Piece& q) {
    const auto fault = [&](const char* what) {
      faults.found.push_back(fmt::format("pieces of {} and {} about ({}, {}) µm {}", p.crack, q.crack, p.a.x, p.a.y, what));
    };
    if (geometry::segments_cross(p.a, p.b, q.a, q.b)) fault("cross");
    if (p.crack < 0 && q.crack < 0) return;
    if ((p.a == q.a && p.b == q.b) || (p.a == q.b && p.b == q.a)) fault("are the same");
    // A piece may touch another only in a common vertex, and the edge with its ends.
    if (p.crack >= 0 && (in_middle(p, q.a) || in_middle(p, q.b))) fault("touch");
    if (q.crack >= 0 && (in_middle(q, p.a) || in_middle(q, p.b))) fault("touch");
  });
}

// Pieces whose ends lie in the pane, and which do not cross the edge, lie in it if their middles do.
void check_inside(const CrackNetwork& network, const geometry::Polygon& outline, Faults& faults) {
  geometry::Polygon doubled = outline;
  for (vec2& vertex : doubled) vertex *= 2.0;
  for (const Piece& piece : pieces(network)) {
    const LatticePoint middle{piece.a.x + piece.b.x, piece.a.y + piece.b.y};
    if (!geometry::contains(doubled, geometry::to_mm(middle))) {
      faults.found.push_back(fmt::format("crack {}: a piece outside the pane", piece.crack));
    }
  }
}

}  // namespace

int crossings(const CrackNetwork& network) {
  int count = 0;
  visit_pairs(pieces(network), [&](const Piece& p, const Piece& q) {
    if (geometry::segments_cross(p.a, p.b, q.a, q.b)) ++count;
  });
  return count;
}

std::vector<std::string> faults(const CrackNetwork& network, const geometry::Polygon& outline, bool grows) {
  Faults faults;
  const std::vector<Piece> edge = sides(outline);
  for (std::size_t i = 0; i < network.cracks.size(); ++i) {
    const Crack& crack = network.cracks[i];
    const bool in_order = grows ? i == 0 || network.cracks[i - 1].id < crack.id : crack.id == static_cast<int>(i);
    if (!in_order) faults.add(crack, "not its place");
    if (crack.points_mm.size() < 2) {
      faults.add(crack, "fewer than two points");
      continue;
    }
    check_points(crack, outline, edge, faults);
    check_start(crack, network, faults);
    check_end(crack, network, edge, faults);
  }
  check_meetings(network, faults);
  check_pairs(network, edge, faults);
  check_inside(network, outline, faults);
  return faults.found;
}

std::vector<std::string> enclosure_faults(const CrackNetwork& network) {
  Faults faults;
  std::vector<CrackFaces::Polyline> polylines;
  CrackFaces earlier(polylines);
  for (int impact = 0; impact < static_cast<int>(network.impacts.size()); ++impact) {
    for (const Crack& crack : network.cracks) {
      if (crack.impact == impact) polylines.push_back(on_lattice(crack));
    }
    CrackFaces now(polylines);
    for (const Crack& crack : network.cracks) {
      if (crack.impact != impact) continue;
      const bool is_ring = crack.kind == CrackKind::circular;
      const LatticePoint tip = geometry::to_lattice(crack.points_mm.back());
      if (crack.end.at == CrackEnd::At::enclosed) {
        if (is_ring) faults.add(crack, "a ring crack that stopped enclosed");
        if (!now.surround(tip)) faults.add(crack, "enclosed by nothing");
      } else if (crack.end.at == CrackEnd::At::open && !is_ring && now.surround(tip)) {
        const CrackFaces::Polyline points = on_lattice(crack);
        if (!earlier.surround_middle(points[0], points[1])) faults.add(crack, "open, but enclosed");
      }
    }
    earlier = std::move(now);
  }
  return faults.found;
}

}  // namespace shatterpave::glass
