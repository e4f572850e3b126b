// Lines are cut at the edge, then made to share vertices: wherever two pieces meet, both get that point, rounded to the
// lattice. Rounding bends pieces a little, by which they may meet others, so this goes on until nothing is left to do. Then
// lines meet in vertices alone, and what passes through where is decided vertex by vertex.
#include "glass/map/proper_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/error.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "geometry/segment_index.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::Segment;
using geometry::SegmentIndex;

struct Line {
  CrackKind kind = CrackKind::radial;
  int impact = 0;
  bool through = true;
  std::vector<LatticePoint> points;
};

// Lower ones pass where two cross.
int rank_of(CrackKind kind) {
  switch (kind) {
    case CrackKind::large:
    case CrackKind::radial:
      return 0;
    case CrackKind::branch:
      return 1;
    case CrackKind::circular:
      return 2;
    case CrackKind::dice:
      return 3;
    case CrackKind::rung:
      return 4;
    case CrackKind::chip:
      return 5;
  }
  return 6;
}

void drop_repeated(std::vector<LatticePoint>& points) { points.erase(std::unique(points.begin(), points.end()), points.end()); }

double share_along(LatticePoint p, LatticePoint a, LatticePoint b) {
  const vec2 ab = geometry::to_mm(b) - geometry::to_mm(a);
  const double square = glm::dot(ab, ab);
  return square > 0.0 ? glm::dot(geometry::to_mm(p) - geometry::to_mm(a), ab) / square : 0.0;
}

vec2 nearest_on(vec2 p, vec2 a, vec2 b) {
  const vec2 ab = b - a;
  const double square = glm::dot(ab, ab);
  const double share = square > 0.0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return a + share * ab;
}

// Where the lines a b and c d cross, rounded.
LatticePoint crossing_of(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const vec2 ab = geometry::to_mm(b) - geometry::to_mm(a);
  const vec2 cd = geometry::to_mm(d) - geometry::to_mm(c);
  const vec2 ac = geometry::to_mm(c) - geometry::to_mm(a);
  const double share = std::clamp(cross(ac, cd) / cross(ab, cd), 0.0, 1.0);
  return geometry::to_lattice(geometry::to_mm(a) + share * ab);
}

// ---- the edge of the pane

class Rim {
 public:
  explicit Rim(const geometry::Polygon& outline) : outline_(outline) {
    for (const vec2 p : outline) corners_.push_back(geometry::to_lattice(p));
  }

  bool holds(LatticePoint p) const { return geometry::contains(outline_, geometry::to_mm(p)); }

  // A point of the lattice on the edge or within 1 µm inside it, next to `p`, where that is no farther off than `reach_mm`.
  std::optional<LatticePoint> beside(LatticePoint p, double reach_mm) const {
    const vec2 at = geometry::to_mm(p);
    vec2 best{0.0, 0.0};
    double least = reach_mm;
    bool found = false;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const vec2 on = nearest_on(at, outline_[i], outline_[(i + 1) % outline_.size()]);
      const double distance = glm::length(on - at);
      if (distance > least) continue;
      least = distance;
      best = on;
      found = true;
    }
    return found ? inside_near(geometry::to_lattice(best)) : std::nullopt;
  }

  bool is_on(LatticePoint p) const {
    constexpr double lattice_step_mm = 0.0015;  // 1 µm on both axes
    const vec2 at = geometry::to_mm(p);
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      if (glm::length(nearest_on(at, outline_[i], outline_[(i + 1) % outline_.size()]) - at) <= lattice_step_mm) return true;
    }
    return false;
  }

  // The parts of the line that lie in the pane.
  std::vector<std::vector<LatticePoint>> inside(const std::vector<LatticePoint>& line) const {
    std::vector<std::vector<LatticePoint>> parts;
    std::vector<LatticePoint> part;
    const auto finish = [&] {
      drop_repeated(part);
      if (part.size() >= 2) parts.push_back(part);
      part.clear();
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const std::vector<LatticePoint> stops = stops_along(line[i], line[i + 1]);
      for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
        const vec2 middle = 0.5 * (geometry::to_mm(stops[k]) + geometry::to_mm(stops[k + 1]));
        // What runs along the edge is the edge.
        const bool in = geometry::contains(outline_, geometry::on_lattice(middle)) && !is_on(geometry::to_lattice(middle)) &&
                        holds(stops[k]) && holds(stops[k + 1]);
        if (!in) {
          finish();
          continue;
        }
        if (part.empty()) part.push_back(stops[k]);
        part.push_back(stops[k + 1]);
      }
    }
    finish();
    return parts;
  }

 private:
  std::optional<LatticePoint> inside_near(LatticePoint p) const {
    for (std::int64_t reach = 0; reach <= 2; ++reach) {
      for (std::int64_t dy = -reach; dy <= reach; ++dy) {
        for (std::int64_t dx = -reach; dx <= reach; ++dx) {
          if (holds({p.x + dx, p.y + dy})) return LatticePoint{p.x + dx, p.y + dy};
        }
      }
    }
    return std::nullopt;
  }

  // The ends of the piece and, between them, the points where it crosses the edge.
  std::vector<LatticePoint> stops_along(LatticePoint a, LatticePoint b) const {
    std::vector<LatticePoint> stops = {a};
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const LatticePoint c = corners_[i];
      const LatticePoint d = corners_[(i + 1) % corners_.size()];
      if (geometry::segments_cross(a, b, c, d)) {
        if (const auto at = inside_near(crossing_of(a, b, c, d))) stops.push_back(*at);
      } else if (geometry::on_segment(a, b, c)) {
        stops.push_back(c);
      }
    }
    stops.push_back(b);
    std::ranges::sort(stops, {}, [&](LatticePoint p) { return share_along(p, a, b); });
    stops.front() = a;
    stops.back() = b;
    drop_repeated(stops);
    return stops;
  }

  const geometry::Polygon& outline_;
  std::vector<LatticePoint> corners_;
};

// ---- common vertices

std::size_t piece_count(const std::vector<Line>& lines) {
  std::size_t count = 0;
  for (const Line& line : lines) count += line.points.size() - 1;
  return count;
}

void require_few(const std::vector<Line>& lines) {
  const std::size_t count = piece_count(lines);
  if (count > most_drawn_pieces) {
    throw InputError(fmt::format("expected lines that make at most {} pieces, got {}", most_drawn_pieces, count));
  }
}

// The pieces of all lines, by place. The number of a piece in the index is its number here.
class Pieces {
 public:
  explicit Pieces(const std::vector<Line>& lines) : index_(mean_length(lines)) {
    for (std::size_t line = 0; line < lines.size(); ++line) {
      for (std::size_t i = 0; i + 1 < lines[line].points.size(); ++i) {
        index_.add({lines[line].points[i], lines[line].points[i + 1], static_cast<int>(line)});
        places_.push_back({line, i});
      }
    }
  }

  struct Place {
    std::size_t line = 0;
    std::size_t piece = 0;
  };
  std::size_t count() const { return places_.size(); }
  Place place(int number) const { return places_[static_cast<std::size_t>(number)]; }
  Segment segment(int number) const { return index_.segment(number); }
  std::vector<int> near(LatticePoint a, LatticePoint b) const { return index_.near(a, b); }

 private:
  static double mean_length(const std::vector<Line>& lines) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Line& line : lines) {
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        sum += glm::length(geometry::to_mm(line.points[i + 1]) - geometry::to_mm(line.points[i]));
        ++count;
      }
    }
    return std::clamp(sum / static_cast<double>(std::max<std::size_t>(count, 1)), 0.01, 1000.0);
  }

  SegmentIndex index_;
  std::vector<Place> places_;
};

// Points that pieces shall get, by the number of the piece.
using Additions = std::map<int, std::vector<LatticePoint>>;

void note_meeting(const Segment& one, int i, const Segment& two, int j, Additions& additions) {
  const auto add = [&](int piece, const Segment& segment, LatticePoint p) {
    if (p != segment.a && p != segment.b) additions[piece].push_back(p);
  };
  if (geometry::segments_cross(one.a, one.b, two.a, two.b)) {
    const LatticePoint at = crossing_of(one.a, one.b, two.a, two.b);
    add(i, one, at);
    add(j, two, at);
    return;
  }
  for (const LatticePoint p : {two.a, two.b}) {
    if (geometry::on_segment(one.a, one.b, p)) add(i, one, p);
  }
  for (const LatticePoint p : {one.a, one.b}) {
    if (geometry::on_segment(two.a, two.b, p)) add(j, two, p);
  }
}

// One round; whether anything was added.
bool share_vertices(std::vector<Line>& lines) {
  const Pieces pieces(lines);
  Additions additions;
  for (int i = 0; i < static_cast<int>(pieces.count()); ++i) {
    const Segment one = pieces.segment(i);
    for (const int j : pieces.near(one.a, one.b)) {
      if (j > i) note_meeting(one, i, pieces.segment(j), j, additions);
    }
  }
  // From the last piece of each line to the first, so that the places of those before stay.
  for (auto at = additions.rbegin(); at != additions.rend(); ++at) {
    const auto [line, piece] = pieces.place(at->first);
    std::vector<LatticePoint>& points = lines[line].points;
    const LatticePoint a = points[piece];
    const LatticePoint b = points[piece + 1];
    std::vector<LatticePoint>& added = at->second;
    std::ranges::sort(added, [&](LatticePoint p, LatticePoint q) {
      const double one = share_along(p, a, b);
      const double two = share_along(q, a, b);
      return one != two ? one < two : p < q;
    });
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(piece) + 1, added.begin(), added.end());
  }
  for (Line& line : lines) drop_repeated(line.points);
  std::erase_if(lines, [](const Line& line) { return line.points.size() < 2; });
  return !additions.empty();
}

// The point of another line within `snap_mm` that is nearest to `p`, an end of `line`; `p` itself where there is none, or where
// it is the end of a piece already.
LatticePoint snapped(LatticePoint p, std::size_t line, const Pieces& pieces, double snap_mm) {
  const std::int64_t reach = geometry::to_lattice(snap_mm) + 1;
  LatticePoint best = p;
  double least = snap_mm;
  for (const int number : pieces.near({p.x - reach, p.y - reach}, {p.x + reach, p.y + reach})) {
    if (pieces.place(number).line == line) continue;
    const Segment segment = pieces.segment(number);
    if (segment.a == p || segment.b == p) return p;
    const vec2 on = nearest_on(geometry::to_mm(p), geometry::to_mm(segment.a), geometry::to_mm(segment.b));
    const double distance = glm::length(on - geometry::to_mm(p));
    if (distance > least) continue;
    least = distance;
    best = geometry::to_lattice(on);
  }
  return best;
}

// Moves ends that nearly lie on a line to the nearest point of it, which becomes a vertex there.
void snap_to_lines(std::vector<Line>& lines, double snap_mm) {
  if (snap_mm <= 0.0 || lines.empty()) return;
  const Pieces pieces(lines);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::vector<LatticePoint>& points = lines[line].points;
    points.front() = snapped(points.front(), line, pieces, snap_mm);
    points.back() = snapped(points.back(), line, pieces, snap_mm);
    drop_repeated(points);
  }
  std::erase_if(lines, [](const Line& line) { return line.points.size() < 2; });
}

// ---- who passes

using Side = std::array<LatticePoint, 2>;

Side side_of(LatticePoint a, LatticePoint b) { return a < b ? Side{a, b} : Side{b, a}; }

// Cuts lines where they share a side with one before them, and leaves that part to it. The lines must be in order of rank.
std::vector<Line> without_common_sides(const std::vector<Line>& lines) {
  std::set<Side> taken;
  std::vector<Line> result;
  for (const Line& line : lines) {
    Line part{line.kind, line.impact, line.through, {line.points.front()}};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      if (taken.insert(side_of(line.points[i - 1], line.points[i])).second) {
        part.points.push_back(line.points[i]);
        continue;
      }
      if (part.points.size() >= 2) result.push_back(part);
      part.points = {line.points[i]};
    }
    if (part.points.size() >= 2) result.push_back(part);
  }
  return result;
}

// Cuts lines at vertices where they may not pass: at impacts, on the edge, and where one before them passes, or they
// themselves.
std::vector<Line> cut_where_others_pass(const std::vector<Line>& lines, const std::set<LatticePoint>& barred, const Rim& rim) {
  std::set<LatticePoint> passed;
  std::vector<Line> result;
  for (const Line& line : lines) {
    Line part{line.kind, line.impact, line.through, {line.points.front()}};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const LatticePoint p = line.points[i];
      part.points.push_back(p);
      if (i + 1 == line.points.size()) break;
      if (!barred.contains(p) && !rim.is_on(p) && passed.insert(p).second) continue;
      result.push_back(part);
      part.points = {p};
    }
    result.push_back(part);
  }
  return result;
}

// Who lies at a vertex: the one that passes there, or else the first that ends there.
struct Meeting {
  int passing = -1;
  int first = -1;
};

std::map<LatticePoint, Meeting> meetings_of(const std::vector<Line>& lines) {
  std::map<LatticePoint, Meeting> meetings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < lines[i].points.size(); ++k) {
      Meeting& meeting = meetings[lines[i].points[k]];
      if (meeting.first < 0) meeting.first = static_cast<int>(i);
      if (k > 0 && k + 1 < lines[i].points.size()) meeting.passing = static_cast<int>(i);
    }
  }
  return meetings;
}

CrackEnd end_at(LatticePoint p, int own, bool starts, const std::map<LatticePoint, Meeting>& meetings,
                const std::set<LatticePoint>& impacts, const Rim& rim) {
  if (impacts.contains(p)) return {starts ? CrackEnd::At::impact : CrackEnd::At::open, {}};
  if (rim.is_on(p)) return {CrackEnd::At::edge, {}};
  const Meeting& meeting = meetings.at(p);
  if (meeting.passing >= 0 && meeting.passing != own) return {CrackEnd::At::crack, meeting.passing};
  if (meeting.passing < 0 && meeting.first != own) return {CrackEnd::At::crack, meeting.first};
  return {starts ? CrackEnd::At::origin : CrackEnd::At::open, {}};
}

void turn_outward(Line& line, const std::vector<ImpactCounts>& impacts) {
  if (impacts.empty()) return;
  const vec2 impact = impacts[static_cast<std::size_t>(line.impact)].at_mm;
  const double first = glm::length(geometry::to_mm(line.points.front()) - impact);
  const double last = glm::length(geometry::to_mm(line.points.back()) - impact);
  const bool loose = line.kind == CrackKind::circular || line.kind == CrackKind::rung;
  if (last < first && (!loose || last == 0.0)) std::ranges::reverse(line.points);
}

std::vector<Line> lines_in_pane(const std::vector<DrawnCrack>& drawn, const Rim& rim, const std::vector<ImpactCounts>& impacts,
                                double snap_mm) {
  std::vector<Line> lines;
  for (const DrawnCrack& crack : drawn) {
    std::vector<LatticePoint> points;
    for (const vec2 p : crack.points_mm) points.push_back(geometry::to_lattice(p));
    drop_repeated(points);
    const auto snapped = [&](LatticePoint p) {
      for (const ImpactCounts& impact : impacts) {
        if (glm::length(impact.at_mm - geometry::to_mm(p)) <= snap_mm) return geometry::to_lattice(impact.at_mm);
      }
      return rim.beside(p, snap_mm).value_or(p);
    };
    if (points.size() < 2) continue;
    points.front() = snapped(points.front());
    points.back() = snapped(points.back());
    for (std::vector<LatticePoint>& part : rim.inside(points)) {
      lines.push_back({crack.kind, crack.impact, crack.through, std::move(part)});
    }
  }
  std::ranges::stable_sort(lines, {}, [](const Line& line) { return rank_of(line.kind); });
  return lines;
}

}  // namespace

double radiality(const std::vector<vec2>& points, vec2 impact) {
  double sum = 0.0;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const vec2 way = points[i] - points[i - 1];
    const vec2 out = 0.5 * (points[i] + points[i - 1]) - impact;
    const double a = glm::length(way);
    const double b = glm::length(out);
    if (a == 0.0 || b == 0.0) continue;
    const double cosine = glm::dot(way, out) / (a * b);
    sum += a * (2.0 * cosine * cosine - 1.0);
    length += a;
  }
  return length > 0.0 ? sum / length : 1.0;
}

CrackKind kind_by_direction(const std::vector<vec2>& points, vec2 impact) {
  return radiality(points, impact) > 0.0 ? CrackKind::radial : CrackKind::circular;
}

CrackNetwork proper_network(const std::vector<DrawnCrack>& drawn, const geometry::Polygon& outline_mm,
                            const std::vector<ImpactCounts>& impacts, double snap_mm) {
  const Rim rim(outline_mm);
  std::vector<Line> lines = lines_in_pane(drawn, rim, impacts, snap_mm);
  require_few(lines);
  snap_to_lines(lines, snap_mm);
  // Each round halves what is left at the least, as far as is known; without a bound a fault here would not end.
  constexpr int most_rounds = 100;
  int rounds = 0;
  while (share_vertices(lines)) {
    require_few(lines);
    ENSURE(++rounds < most_rounds);
  }
  std::set<LatticePoint> hubs;
  for (const ImpactCounts& impact : impacts) hubs.insert(geometry::to_lattice(impact.at_mm));
  lines = cut_where_others_pass(without_common_sides(lines), hubs, rim);
  if (lines.empty()) throw InputError("expected lines within the pane, got none");
  for (Line& line : lines) turn_outward(line, impacts);
  const std::map<LatticePoint, Meeting> meetings = meetings_of(lines);
  CrackNetwork network{impacts, {}};
  for (const Line& line : lines) {
    Crack crack;
    crack.id = static_cast<int>(network.cracks.size());
    crack.impact = line.impact;
    crack.kind = line.kind;
    crack.through = line.through;
    for (const LatticePoint p : line.points) crack.points_mm.push_back(geometry::to_mm(p));
    crack.start = end_at(line.points.front(), crack.id, true, meetings, hubs, rim);
    crack.end = end_at(line.points.back(), crack.id, false, meetings, hubs, rim);
    network.cracks.push_back(std::move(crack));
  }
  return network;
}

void count_again(CrackNetwork& network, int impact) {
  ImpactCounts& counts = network.impacts[static_cast<std::size_t>(impact)];
  int starting = 0;
  counts.large_count = 0;
  counts.circular_count = 0;
  for (const Crack& crack : network.cracks) {
    if (crack.impact != impact) continue;
    const bool leaves = crack.kind == CrackKind::large || crack.kind == CrackKind::radial;
    starting += leaves && crack.start.at == CrackEnd::At::impact ? 1 : 0;
    counts.large_count += leaves && crack.end.at == CrackEnd::At::edge ? 1 : 0;
    counts.circular_count += crack.kind == CrackKind::circular ? 1 : 0;
  }
  counts.radial_count = std::max({counts.radial_count, starting, counts.large_count});
}

}  // namespace shatterpave::glass
