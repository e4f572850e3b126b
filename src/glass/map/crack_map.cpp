// Where a crack meets another, the meeting point has to be rounded to the lattice, and both cracks are led through the rounded
// point. That moves them by up to a lattice unit, which could push them over a third crack. So a meeting point is taken only
// if the moved pieces, checked exactly against everything about, are free; else the next nearest point of the lattice is tried,
// then the ends of the segment that was met, where no crack but the arriving one has to move.
#include "glass/map/crack_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/predicates.h"
#include "geometry/segment_distance.h"

namespace shatterpave::glass {

using geometry::LatticePoint;
using geometry::Segment;
using geometry::Side;

namespace {

// Room that a crack is given at once: as many pieces as most radials come to.
constexpr std::size_t usual_piece_count = 16;

// Whether the segments from `shared` to `p` and from `shared` to `q` lie on each other.
bool overlap(LatticePoint shared, LatticePoint p, LatticePoint q) {
  if (geometry::side(shared, p, q) != Side::on) return false;
  const auto same_way = [](std::int64_t s, std::int64_t a, std::int64_t b) { return (a > s && b > s) || (a < s && b < s); };
  return same_way(shared.x, p.x, q.x) || same_way(shared.y, p.y, q.y);
}

// Whether the box about `p` and `q` and that about the segment have a point in common: cheap, and mostly they have none.
bool boxes_meet(LatticePoint p, LatticePoint q, const Segment& segment) {
  return std::max(p.x, q.x) >= std::min(segment.a.x, segment.b.x) && std::min(p.x, q.x) <= std::max(segment.a.x, segment.b.x) &&
         std::max(p.y, q.y) >= std::min(segment.a.y, segment.b.y) && std::min(p.y, q.y) <= std::max(segment.a.y, segment.b.y);
}

// Whether a crack that goes on from `from`, straight to `to`, runs into the segment. A common point in `from` is none.
bool runs_into(LatticePoint from, LatticePoint to, const Segment& segment) {
  if (segment.a == from) return overlap(from, to, segment.b);
  if (segment.b == from) return overlap(from, to, segment.a);
  if (!boxes_meet(from, to, segment)) return false;
  return geometry::segments_meet(from, to, segment.a, segment.b);
}

// Whether the piece from `p` to `q` of a crack and the segment have no point in common but an end of both.
bool apart(LatticePoint p, LatticePoint q, const Segment& segment) {
  const std::array<std::array<LatticePoint, 2>, 2> piece = {{{p, q}, {q, p}}};
  bool share_an_end = false;
  for (const auto& [end, other] : piece) {
    if (segment.a != end && segment.b != end) continue;
    share_an_end = true;
    if (overlap(end, other, segment.a == end ? segment.b : segment.a)) return false;
  }
  return share_an_end || !geometry::segments_meet(p, q, segment.a, segment.b);
}

// As `apart`, for a segment of the outline: the piece may also end on it.
bool within(LatticePoint p, LatticePoint q, const Segment& segment) {
  const auto inside_piece = [&](LatticePoint v) { return v != p && v != q && geometry::on_segment(p, q, v); };
  return !geometry::segments_cross(p, q, segment.a, segment.b) && !inside_piece(segment.a) && !inside_piece(segment.b);
}

// The share of the way from `from` to `to` at which it meets the segment.
double share_of_way(LatticePoint from, LatticePoint to, const Segment& segment) {
  const auto difference = [](LatticePoint p, LatticePoint q) {
    return vec2{static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y)};
  };
  const vec2 way = difference(to, from);
  const vec2 along = difference(segment.b, segment.a);
  const vec2 offset = difference(segment.a, from);
  const double turn = cross(way, along);
  const double share = turn != 0.0 ? cross(offset, along) / turn
                                   : std::min(glm::dot(offset, way), glm::dot(offset + along, way)) / glm::dot(way, way);
  return std::clamp(share, 0.0, 1.0);
}

// Whether the point is at most one unit of the lattice from the segment.
bool is_beside(LatticePoint p, const Segment& segment) {
  __extension__ using Wide = __int128;
  const auto dot = [](LatticePoint o, LatticePoint u, LatticePoint v) {
    return static_cast<Wide>(u.x - o.x) * (v.x - o.x) + static_cast<Wide>(u.y - o.y) * (v.y - o.y);
  };
  const Wide length = dot(segment.a, segment.b, segment.b);
  const Wide along = dot(segment.a, segment.b, p);
  const Wide distance = dot(segment.a, p, p);
  if (along < 0) return distance <= 1;
  if (along > length) return dot(segment.b, p, p) <= 1;
  return distance * length - along * along <= length;
}

// When a tip that goes `way_mm` from one time to another, at one speed, has gone the first `gone_mm` of them.
double time_between(double from_us, double to_us, double gone_mm, double way_mm) {
  return way_mm > 0.0 ? from_us + std::clamp(gone_mm / way_mm, 0.0, 1.0) * (to_us - from_us) : from_us;
}

std::vector<int> distinct(std::vector<int> numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

// The places to try for a meeting at `ideal`, in lattice units, with `met`: the best first.
std::array<LatticePoint, 11> candidate_joints(vec2 ideal, const Segment& met) {
  const LatticePoint centre{std::llround(ideal.x), std::llround(ideal.y)};
  std::array<LatticePoint, 11> candidates;
  std::size_t count = 0;
  for (std::int64_t dy = -1; dy <= 1; ++dy) {
    for (std::int64_t dx = -1; dx <= 1; ++dx) candidates[count++] = {centre.x + dx, centre.y + dy};
  }
  const auto distance = [ideal](LatticePoint p) {
    return glm::length(vec2{static_cast<double>(p.x), static_cast<double>(p.y)} - ideal);
  };
  std::sort(candidates.begin(), candidates.begin() + 9,
            [&](LatticePoint p, LatticePoint q) { return distance(p) != distance(q) ? distance(p) < distance(q) : p < q; });
  const bool first_is_nearer = distance(met.a) <= distance(met.b);
  candidates[9] = first_is_nearer ? met.a : met.b;
  candidates[10] = first_is_nearer ? met.b : met.a;
  return candidates;
}

}  // namespace

CrackMap::CrackMap(geometry::Polygon outline, double cell_mm, bool tells_regions)
    : outline_(std::move(outline)), tells_regions_(tells_regions), index_(cell_mm) {
  LatticePoint previous = geometry::to_lattice(outline_.back());
  for (const vec2& vertex : outline_) {
    const LatticePoint current = geometry::to_lattice(vertex);
    index_.add({previous, current, edge_owner});
    previous = current;
  }
}

bool CrackMap::is_edge(int segment) const { return index_.segment(segment).owner == edge_owner; }

CrackMap::Hub CrackMap::add_hub(LatticePoint at) {
  const int node = graph_.add();
  crack_of_node_.push_back(-1);
  hubs_.push_back({at, node, -1});
  hub_places_.insert(at);
  std::vector<int> through;
  index_.visit_near(at, at, [&](int number) {
    const Segment segment = index_.segment(number);
    if (segment.owner != edge_owner && geometry::on_segment(segment.a, segment.b, at)) through.push_back(number);
  });
  for (const int number : distinct(std::move(through))) {
    const Segment segment = index_.segment(number);
    if (at != segment.a && at != segment.b) insert_vertex(number, at);
    graph_.connect(node, record(segment.owner).node, at);
    hubs_.back().crack = segment.owner;
  }
  return static_cast<Hub>(hubs_.size()) - 1;
}

bool CrackMap::is_taken(LatticePoint at) const { return hub_places_.contains(at) || is_taken(at, -1); }

bool CrackMap::is_taken(LatticePoint at, int except) const {
  bool taken = false;
  index_.visit_near(at, at, [&](int number) {
    const Segment segment = index_.segment(number);
    taken = taken || (number != except && geometry::on_segment(segment.a, segment.b, at));
  });
  return taken;
}

bool CrackMap::is_barred(LatticePoint from, LatticePoint to, int impact) const {
  bool barred = false;
  index_.visit_near(from, to, [&](int number) {
    const Segment segment = index_.segment(number);
    const bool bars = segment.owner == edge_owner || record(segment.owner).impact < impact;
    barred = barred || (bars && runs_into(from, to, segment));
  });
  return barred;
}

int CrackMap::start(Hub hub, CrackKind kind, int impact, CrackEnd::At start, double at_us) {
  ENSURE(start != CrackEnd::At::crack || hubs_[static_cast<std::size_t>(hub)].crack >= 0);
  const int crack = static_cast<int>(cracks_.size());
  Record& fresh = cracks_.push_back({});
  fresh.kind = kind;
  fresh.impact = impact;
  fresh.hub = hub;
  fresh.node = graph_.add();
  fresh.pieces.reserve(usual_piece_count);
  fresh.times_us.reserve(usual_piece_count + 1);
  fresh.times_us.push_back(at_us);
  fresh.start = start;
  crack_of_node_.push_back(crack);
  graph_.connect(fresh.node, hubs_[static_cast<std::size_t>(hub)].node, origin(fresh));
  return crack;
}

std::vector<LatticePoint> CrackMap::points(int crack) const {
  const Record& asked = record(crack);
  std::vector<LatticePoint> result{origin(asked)};
  result.reserve(asked.pieces.size() + 1);
  for (const int piece : asked.pieces) result.push_back(segment(piece).b);
  return result;
}

// What is in the way, in the order in which it is met.
std::vector<CrackMap::Hit> CrackMap::hits(LatticePoint from, LatticePoint to) const {
  std::vector<int> met;
  index_.visit_near(from, to, [&](int number) {
    if (runs_into(from, to, index_.segment(number))) met.push_back(number);
  });
  std::vector<Hit> found;
  for (const int number : distinct(std::move(met))) {
    const Segment segment = index_.segment(number);
    const bool at_once = segment.a == from || segment.b == from;
    found.push_back({number, at_once ? 0.0 : share_of_way(from, to, segment)});
  }
  std::ranges::sort(found,
                    [](const Hit& a, const Hit& b) { return a.share != b.share ? a.share < b.share : a.segment < b.segment; });
  return found;
}

// Whether a piece of a crack can lie from `from` to `to`, among all segments but `except`.
bool CrackMap::is_free(LatticePoint from, LatticePoint to, int except) const {
  bool free = true;
  index_.visit_near(from, to, [&](int number) {
    if (!free || number == except) return;
    const Segment segment = index_.segment(number);
    free = segment.owner == edge_owner ? within(from, to, segment) : apart(from, to, segment);
  });
  return free;
}

// Whether a crack whose last vertex is `from` can end at `joint` on the segment `met`, which is led through it.
bool CrackMap::can_join(LatticePoint from, LatticePoint joint, int met) const {
  const Segment segment = index_.segment(met);
  if (from != joint && !is_free(from, joint, met)) return false;
  if (is_edge(met)) {
    return within(from, joint, segment) && is_beside(joint, segment) && geometry::contains(outline_, geometry::to_mm(joint));
  }
  if (joint == segment.a || joint == segment.b) return from == joint || apart(from, joint, segment);
  // The crack that was met is not to run through another one's vertex, nor to go on beyond the edge.
  if (from != joint && is_taken(joint, met)) return false;
  if (from != joint && (overlap(joint, from, segment.a) || overlap(joint, from, segment.b))) return false;
  return !overlap(joint, segment.a, segment.b) && is_free(segment.a, joint, met) && is_free(joint, segment.b, met);
}

void CrackMap::append(int crack, LatticePoint to, double at_us) {
  const int piece = index_.add({tip(crack), to, crack});
  record(crack).pieces.push_back(piece);
  record(crack).times_us.push_back(at_us);
}

double CrackMap::time_us(int crack, LatticePoint p) const {
  const Record& asked = record(crack);
  const vec2 place = geometry::to_mm(p);
  double nearest_mm = std::numeric_limits<double>::infinity();
  double time = asked.times_us.front();
  for (std::size_t i = 0; i < asked.pieces.size(); ++i) {
    const Segment piece = segment(asked.pieces[i]);
    const vec2 a = geometry::to_mm(piece.a);
    const vec2 b = geometry::to_mm(piece.b);
    const vec2 nearest = geometry::nearest_on_segment(place, a, b);
    const double distance_mm = glm::length(nearest - place);
    if (distance_mm >= nearest_mm) continue;
    nearest_mm = distance_mm;
    time = time_between(asked.times_us[i], asked.times_us[i + 1], glm::length(nearest - a), glm::length(b - a));
  }
  return time;
}

std::optional<Arrest> CrackMap::run(int crack, LatticePoint to, double speed_mm_us) {
  return extend(crack, to, tip_us(crack) + glm::length(geometry::to_mm(to) - geometry::to_mm(tip(crack))) / speed_mm_us);
}

std::optional<Arrest> CrackMap::extend(int crack, LatticePoint to, double at_us) {
  ENSURE(record(crack).growing);
  const LatticePoint from = tip(crack);
  if (from == to) return std::nullopt;
  const std::vector<Hit> in_the_way = hits(from, to);
  if (in_the_way.empty()) {
    append(crack, to, at_us);
    return std::nullopt;
  }
  const vec2 start{static_cast<double>(from.x), static_cast<double>(from.y)};
  const vec2 way{static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
  for (const Hit& hit : in_the_way) {
    // To end where it is, it must have a length, and meet more than its own last piece.
    const bool can_stay = !pieces(crack).empty() && pieces(crack).back() != hit.segment;
    for (const LatticePoint joint : candidate_joints(start + hit.share * way, index_.segment(hit.segment))) {
      if ((joint != from || can_stay) && can_join(from, joint, hit.segment)) {
        const double gone_mm = glm::length(geometry::to_mm(joint) - geometry::to_mm(from));
        const double way_mm = glm::length(geometry::to_mm(to) - geometry::to_mm(from));
        return join(crack, joint, hit.segment, time_between(tip_us(crack), at_us, gone_mm, way_mm));
      }
    }
  }
  // Nothing about can be moved by a lattice unit: the crack ends short of what it was to meet.
  stop(crack, CrackEnd::At::open);
  return Arrest{record(crack).end, {}};
}

// A crack other than `but` that ends in the point, −1 if there is none: cracks that end in one point of the edge touch.
int CrackMap::ended_at(LatticePoint at, int but) const {
  int found = -1;
  index_.visit_near(at, at, [&](int number) {
    const Segment segment = index_.segment(number);
    if (segment.owner != edge_owner && segment.owner != but && segment.b == at) found = segment.owner;
  });
  return found;
}

// Ends the crack at `joint` on the segment `met`.
Arrest CrackMap::join(int crack, LatticePoint joint, int met, double at_us) {
  Record& ending = record(crack);
  const Segment segment = index_.segment(met);
  if (joint != tip(crack)) append(crack, joint, at_us);
  ending.growing = false;
  const bool at_edge = segment.owner == edge_owner;
  const int touched = at_edge ? ended_at(joint, crack) : segment.owner;
  ending.end = at_edge ? CrackEnd{CrackEnd::At::edge, std::nullopt} : CrackEnd{CrackEnd::At::crack, touched};
  if (touched < 0) return {ending.end, {}};
  if (joint != segment.a && joint != segment.b && !at_edge) insert_vertex(met, joint);
  Arrest arrest{ending.end, tells_regions_ ? closed_region(crack, touched) : std::vector<LatticePoint>{}};
  Record& other = record(touched);
  graph_.connect(ending.node, other.node, joint);
  if (other.growing && tip(touched) == joint) {
    other.growing = false;
    other.end = {CrackEnd::At::crack, crack};
  }
  return arrest;
}

void CrackMap::stop(int crack, CrackEnd::At at) {
  Record& ending = record(crack);
  ENSURE(ending.growing);
  ending.growing = false;
  ending.end = {at, std::nullopt};
}

// Leads the crack that owns the segment through `point`.
void CrackMap::insert_vertex(int segment, LatticePoint point) {
  const Segment old = index_.segment(segment);
  std::vector<int>& pieces = record(old.owner).pieces;
  std::vector<double>& times_us = record(old.owner).times_us;
  const auto place = std::ranges::find(pieces, segment);
  ENSURE(place != pieces.end());
  const auto time = times_us.begin() + (place - pieces.begin());
  const vec2 a = geometry::to_mm(old.a);
  times_us.insert(time + 1, time_between(*time, *(time + 1), glm::length(geometry::to_mm(point) - a),
                                         glm::length(geometry::to_mm(old.b) - a)));
  index_.remove(segment);
  *place = index_.add({old.a, point, old.owner});
  pieces.insert(place + 1, index_.add({point, old.b, old.owner}));
}

// Adds to `border` the vertices of the node between two points on it: after `from`, up to and with `to`.
void CrackMap::walk(int node, LatticePoint from, LatticePoint to, std::vector<LatticePoint>& border) const {
  const int crack = crack_of_node_[static_cast<std::size_t>(node)];
  if (crack < 0) return;  // a hub is one point
  const std::vector<LatticePoint> points = this->points(crack);
  auto here = std::ranges::find(points, from);
  const auto there = std::ranges::find(points, to);
  ENSURE(here != points.end() && there != points.end());
  while (here != there) {
    here += here < there ? 1 : -1;
    border.push_back(*here);
  }
}

// The border of a region that `crack` closed by ending on the crack `met`: from its tip back along cracks that touch one
// another to where it ended. Its ending splits one region in two. If that was not closed before, one of the two is the open
// rest, which no way along cracks surrounds, so any way back has the newly closed one inside.
std::vector<LatticePoint> CrackMap::closed_region(int crack, int met) {
  const LatticePoint joint = tip(crack);
  if (crack == met) {
    const std::vector<LatticePoint> loop = points(crack);
    return {std::ranges::find(loop, joint), loop.end() - 1};
  }
  const int start = record(crack).node;
  const int goal = record(met).node;
  if (!graph_.connected(start, goal)) return {};
  std::vector<LatticePoint> border;
  border.reserve(4 * usual_piece_count);
  int node = start;
  LatticePoint at = joint;
  for (const ContactGraph::Contact& step : graph_.way(start, goal)) {
    walk(node, at, step.at, border);
    node = step.node;
    at = step.at;
  }
  walk(node, at, joint, border);
  return border;
}

std::vector<Crack> CrackMap::cracks(bool with_times) const {
  std::vector<int> ids(cracks_.size(), -1);
  int next = 0;
  for (std::size_t i = 0; i < cracks_.size(); ++i) {
    if (!cracks_[i].pieces.empty()) ids[i] = next++;
  }
  std::vector<Crack> result;
  result.reserve(static_cast<std::size_t>(next));
  for (std::size_t i = 0; i < cracks_.size(); ++i) {
    const Record& record = cracks_[i];
    if (ids[i] < 0) continue;
    Crack crack{ids[i], record.impact, record.kind, {}, {record.start, std::nullopt}, record.end};
    if (record.start == CrackEnd::At::crack) {
      crack.start.crack = ids[static_cast<std::size_t>(hubs_[static_cast<std::size_t>(record.hub)].crack)];
    }
    crack.points_mm.reserve(record.pieces.size() + 1);
    crack.points_mm.push_back(geometry::to_mm(origin(record)));
    for (const int piece : record.pieces) crack.points_mm.push_back(geometry::to_mm(segment(piece).b));
    crack.through = record.kind != CrackKind::chip;
    if (with_times) crack.times_us = record.times_us;
    if (crack.end.crack) crack.end.crack = ids[static_cast<std::size_t>(*crack.end.crack)];
    result.push_back(std::move(crack));
  }
  return result;
}

}  // namespace shatterpave::glass
