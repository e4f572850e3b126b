// Each segment is two darts, one for each of its sides. A walk that always turns to the next segment clockwise from where it
// came goes round one face. A segment that one walk has on both sides is a spur: spurs are taken out, and what is left is
// walked again. Such a walk may still come to a vertex twice, where the face touches itself; there it is parted into rings. The
// ring of a face that runs counter-clockwise is its outline. Walks without one go round the outside of what hangs together, and
// are holes of the face that this lies in, if it lies in one.
#include "geometry/planar_map.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "core/error.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {

namespace {

__extension__ using Wide = __int128;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Whether the direction from `o` to `p` comes before that to `q`, counter-clockwise from +x.
bool turns_before(LatticePoint o, LatticePoint p, LatticePoint q) {
  const auto lower = [o](LatticePoint v) { return v.y < o.y || (v.y == o.y && v.x < o.x); };
  if (lower(p) != lower(q)) return lower(q);
  return side(o, p, q) == Side::left;
}

// Whether the direction to `p` comes before that to `q`, counter-clockwise from `cut`.
bool turns_before_from(LatticePoint o, LatticePoint cut, LatticePoint p, LatticePoint q) {
  const auto half = [&](LatticePoint v) {
    const Side s = side(o, cut, v);
    const Wide along = static_cast<Wide>(cut.x - o.x) * (v.x - o.x) + static_cast<Wide>(cut.y - o.y) * (v.y - o.y);
    return s == Side::left || (s == Side::on && along > 0) ? 0 : 1;
  };
  if (half(p) != half(q)) return half(p) < half(q);
  return side(o, p, q) == Side::left;
}

// Dart 2 i runs along segment i, dart 2 i + 1 against it.
class Darts {
 public:
  Darts(std::span<const Segment> segments, std::span<const LatticePoint> outward);

  LatticePoint from(std::size_t dart) const { return dart % 2 == 0 ? segments_[dart / 2].a : segments_[dart / 2].b; }
  LatticePoint to(std::size_t dart) const { return from(dart ^ 1U); }
  std::size_t walk_of(std::size_t dart) const { return walk_of_[dart]; }
  const std::vector<std::vector<std::size_t>>& walks() const { return walks_; }

  // Walks along all segments for which is_there[i] holds.
  void walk(const std::vector<bool>& is_there);

 private:
  bool comes_before(std::size_t p, std::size_t q) const;
  void sort_about_vertices(const std::vector<bool>& is_there);

  std::span<const Segment> segments_;
  std::size_t rim_count_;
  std::map<LatticePoint, LatticePoint> cuts_;  // of the rim's vertices: a point outside of each
  std::vector<std::size_t> next_;              // the dart that a walk goes on along
  std::vector<std::size_t> walk_of_;
  std::vector<std::vector<std::size_t>> walks_;
};

Darts::Darts(std::span<const Segment> segments, std::span<const LatticePoint> outward)
    : segments_(segments), rim_count_(outward.size()), walk_of_(2 * segments.size(), none) {
  for (std::size_t i = 0; i < outward.size(); ++i) {
    const LatticePoint at = segments[i].a;
    cuts_[at] = {at.x + outward[i].x, at.y + outward[i].y};
  }
}

// Of two darts that leave one vertex, counter-clockwise. About a vertex of the rim the rim's own darts are first and last.
bool Darts::comes_before(std::size_t p, std::size_t q) const {
  const LatticePoint o = from(p);
  const auto cut = cuts_.find(o);
  if (cut == cuts_.end()) {
    if (turns_before(o, to(p), to(q)) != turns_before(o, to(q), to(p))) return turns_before(o, to(p), to(q));
    return p < q;
  }
  const auto rank = [&](std::size_t dart) { return dart / 2 >= rim_count_ ? 1 : (dart % 2 == 0 ? 0 : 2); };
  if (rank(p) != rank(q)) return rank(p) < rank(q);
  const bool before = turns_before_from(o, cut->second, to(p), to(q));
  return before != turns_before_from(o, cut->second, to(q), to(p)) ? before : p < q;
}

void Darts::sort_about_vertices(const std::vector<bool>& is_there) {
  std::vector<std::size_t> darts;
  for (std::size_t dart = 0; dart < 2 * segments_.size(); ++dart) {
    if (is_there[dart / 2]) darts.push_back(dart);
  }
  std::ranges::sort(darts,
                    [&](std::size_t p, std::size_t q) { return from(p) != from(q) ? from(p) < from(q) : comes_before(p, q); });
  next_.assign(2 * segments_.size(), none);
  for (std::size_t first = 0; first < darts.size();) {
    std::size_t end = first;
    while (end < darts.size() && from(darts[end]) == from(darts[first])) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t clockwise = i == first ? end - 1 : i - 1;
      next_[darts[i] ^ 1U] = darts[clockwise];
    }
    first = end;
  }
}

void Darts::walk(const std::vector<bool>& is_there) {
  sort_about_vertices(is_there);
  std::ranges::fill(walk_of_, none);
  walks_.clear();
  for (std::size_t first = 0; first < walk_of_.size(); ++first) {
    if (!is_there[first / 2] || walk_of_[first] != none) continue;
    std::vector<std::size_t> walk;
    for (std::size_t dart = first; walk_of_[dart] == none; dart = next_[dart]) {
      walk_of_[dart] = walks_.size();
      walk.push_back(dart);
    }
    walks_.push_back(std::move(walk));
  }
}

// The rings of a walk: it is parted at every vertex that it comes to twice.
std::vector<FaceRing> rings(const std::vector<std::size_t>& walk, const Darts& darts) {
  std::vector<FaceRing> result;
  FaceRing open;
  std::map<LatticePoint, std::size_t> place;  // of the vertices of the open part
  for (const std::size_t dart : walk) {
    place[darts.from(dart)] = open.size();
    open.push_back({dart / 2, dart % 2 == 0, darts.from(dart)});
    const auto closed = place.find(darts.to(dart));
    if (closed == place.end()) continue;
    const auto begin = open.begin() + static_cast<std::ptrdiff_t>(closed->second);
    result.emplace_back(begin, open.end());
    for (const FaceSide& side : result.back()) place.erase(side.from);
    open.erase(begin, open.end());
  }
  ENSURE(open.empty());
  return result;
}

// Whether a ray from `p` towards +x crosses the ring an odd number of times. Where `p` is a vertex of the ring, no other one
// may lie farther towards +x; then the answer is no.
bool surrounds(const FaceRing& ring, LatticePoint p) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint a = ring[i].from;
    const LatticePoint b = ring[(i + 1) % ring.size()].from;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (side(a, b, p) == (b.y > a.y ? Side::left : Side::right)) odd = !odd;
  }
  return odd;
}

// The face in which `p` lies, a vertex of no outline or the farthest towards +x of what hangs together with it: of those whose
// outlines surround it the smallest.
std::size_t face_about(LatticePoint p, const std::vector<Face>& faces) {
  std::size_t found = none;
  std::int64_t least = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!surrounds(faces[i].outline, p)) continue;
    const std::int64_t size = doubled_area(faces[i].outline);
    if (found != none && size >= least) continue;
    found = i;
    least = size;
  }
  return found;
}

LatticePoint rightmost(const std::vector<FaceRing>& rings) {
  LatticePoint found = rings.front().front().from;
  for (const FaceRing& ring : rings) {
    for (const FaceSide& side : ring) found = std::max(found, side.from);
  }
  return found;
}

struct Walked {
  std::vector<Face> faces;
  std::vector<std::size_t> face_of_walk;  // none: outside of all
};

Walked walked_faces(const Darts& darts) {
  Walked result;
  std::vector<std::pair<std::size_t, std::vector<FaceRing>>> outside;  // walks without an outline
  for (std::size_t walk = 0; walk < darts.walks().size(); ++walk) {
    std::vector<FaceRing> parts = rings(darts.walks()[walk], darts);
    const auto outline = std::ranges::find_if(parts, [](const FaceRing& ring) { return doubled_area(ring) > 0; });
    result.face_of_walk.push_back(none);
    if (outline == parts.end()) {
      outside.emplace_back(walk, std::move(parts));
      continue;
    }
    result.face_of_walk.back() = result.faces.size();
    Face face;
    face.outline = std::move(*outline);
    parts.erase(outline);
    face.holes = std::move(parts);
    result.faces.push_back(std::move(face));
  }
  for (auto& [walk, parts] : outside) {
    const std::size_t about = face_about(rightmost(parts), result.faces);
    result.face_of_walk[walk] = about;
    if (about != none) std::ranges::move(parts, std::back_inserter(result.faces[about].holes));
  }
  return result;
}

// The walk that each spur had on both sides before it was taken out.
std::map<std::size_t, std::vector<std::size_t>> spurs_by_walk(const Darts& darts, std::size_t count) {
  std::map<std::size_t, std::vector<std::size_t>> spurs;
  for (std::size_t i = 0; i < count; ++i) {
    if (darts.walk_of(2 * i) == darts.walk_of(2 * i + 1)) spurs[darts.walk_of(2 * i)].push_back(i);
  }
  return spurs;
}

}  // namespace

std::vector<Face> faces(std::span<const Segment> segments, std::span<const LatticePoint> outward) {
  Darts darts(segments, outward);
  std::vector<bool> is_border(segments.size(), true);
  darts.walk(is_border);
  const std::map<std::size_t, std::vector<std::size_t>> spurs = spurs_by_walk(darts, segments.size());
  const std::vector<std::vector<std::size_t>> old_walks = darts.walks();
  for (const auto& [walk, members] : spurs) {
    for (const std::size_t segment : members) is_border[segment] = false;
  }
  darts.walk(is_border);
  Walked walked = walked_faces(darts);
  for (const auto& [walk, members] : spurs) {
    const auto kept = std::ranges::find_if(old_walks[walk], [&](std::size_t dart) { return is_border[dart / 2]; });
    const std::size_t face = kept != old_walks[walk].end() ? walked.face_of_walk[darts.walk_of(*kept)]
                                                           : face_about(segments[members.front()].a, walked.faces);
    if (face != none) std::ranges::copy(members, std::back_inserter(walked.faces[face].spurs));
  }
  return std::move(walked.faces);
}

std::int64_t doubled_area(std::span<const LatticePoint> ring) {
  Wide sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint a = ring[i];
    const LatticePoint b = ring[(i + 1) % ring.size()];
    sum += static_cast<Wide>(a.x) * b.y - static_cast<Wide>(a.y) * b.x;
  }
  return static_cast<std::int64_t>(sum);
}

std::int64_t doubled_area(const FaceRing& ring) {
  std::vector<LatticePoint> points(ring.size());
  std::ranges::transform(ring, points.begin(), [](const FaceSide& side) { return side.from; });
  return doubled_area(points);
}

std::int64_t doubled_area(const Face& face) {
  std::int64_t sum = doubled_area(face.outline);
  for (const FaceRing& hole : face.holes) sum += doubled_area(hole);
  return sum;
}

}  // namespace shatterpave::geometry
