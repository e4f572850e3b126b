#include "glass/gaps/crack_faces.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/predicates.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::Side;
__extension__ using Wide = __int128;

constexpr std::size_t none = static_cast<std::size_t>(-1);

LatticePoint doubled(LatticePoint p) { return {2 * p.x, 2 * p.y}; }

// Whether the direction from `o` to `p` comes before that to `q`, counter-clockwise from +x.
bool turns_before(LatticePoint o, LatticePoint p, LatticePoint q) {
  const auto lower = [o](LatticePoint v) { return v.y < o.y || (v.y == o.y && v.x < o.x); };
  if (lower(p) != lower(q)) return lower(q);
  return geometry::side(o, p, q) == Side::left;
}

}  // namespace

CrackFaces::CrackFaces(std::span<const Polyline> cracks) {
  for (const Polyline& crack : cracks) std::ranges::transform(crack, std::back_inserter(vertices_), doubled);
  std::ranges::sort(vertices_);
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  add_pieces(cracks);
  add_walks();
}

std::size_t CrackFaces::vertex(LatticePoint p) const {
  const auto found = std::ranges::lower_bound(vertices_, p);
  return found != vertices_.end() && *found == p ? static_cast<std::size_t>(found - vertices_.begin()) : none;
}

void CrackFaces::add_pieces(std::span<const Polyline> cracks) {
  leaving_.resize(vertices_.size());
  for (const Polyline& crack : cracks) {
    for (std::size_t i = 1; i < crack.size(); ++i) {
      const std::size_t a = vertex(doubled(crack[i - 1]));
      const std::size_t b = vertex(doubled(crack[i]));
      leaving_[a].push_back(darts_.size());
      darts_.push_back({a, b});
      leaving_[b].push_back(darts_.size());
      darts_.push_back({b, a});
    }
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    std::ranges::sort(leaving_[v], [&](std::size_t p, std::size_t q) {
      return turns_before(vertices_[v], vertices_[darts_[p].to], vertices_[darts_[q].to]);
    });
  }
}

// At the end of a dart the walk goes on along the next piece clockwise from where it came.
void CrackFaces::add_walks() {
  walk_of_.assign(darts_.size(), none);
  for (std::size_t first = 0; first < darts_.size(); ++first) {
    if (walk_of_[first] != none) continue;
    Walk walk;
    Wide twice_area = 0;
    const LatticePoint origin = vertices_[darts_[first].from];
    for (std::size_t dart = first; walk_of_[dart] == none;) {
      walk_of_[dart] = walks_.size();
      walk.darts.push_back(dart);
      const LatticePoint a = vertices_[darts_[dart].from];
      const LatticePoint b = vertices_[darts_[dart].to];
      twice_area += static_cast<Wide>(a.x - origin.x) * (b.y - origin.y) - static_cast<Wide>(a.y - origin.y) * (b.x - origin.x);
      const std::vector<std::size_t>& around = leaving_[darts_[dart].to];
      const auto back = std::ranges::find(around, dart ^ 1U);
      ENSURE(back != around.end());
      dart = back == around.begin() ? around.back() : *(back - 1);
    }
    walk.is_outer = twice_area <= 0;
    if (!walk.is_outer) ++count_;
    walks_.push_back(std::move(walk));
  }
}

// Whether a ray from `p` towards +x crosses an outer walk but `but` an odd number of times: then what that walk goes about
// has `p` inside. Pieces with the outside on both sides are crossed twice.
bool CrackFaces::odd_outer_walk(LatticePoint p, std::size_t but) const {
  for (std::size_t w = 0; w < walks_.size(); ++w) {
    if (!walks_[w].is_outer || w == but) continue;
    bool odd = false;
    for (const std::size_t dart : walks_[w].darts) {
      const LatticePoint a = vertices_[darts_[dart].from];
      const LatticePoint b = vertices_[darts_[dart].to];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if ((b.y > a.y) == (geometry::side(a, b, p) == Side::left)) odd = !odd;
    }
    if (odd) return true;
  }
  return false;
}

bool CrackFaces::surround_middle(LatticePoint p, LatticePoint q) const { return odd_outer_walk({p.x + q.x, p.y + q.y}, none); }

bool CrackFaces::surround(LatticePoint p) const {
  const std::size_t v = vertex(doubled(p));
  if (v == none) return odd_outer_walk(doubled(p), none);
  return std::ranges::all_of(leaving_[v], [&](std::size_t dart) {
    const std::size_t walk = walk_of_[dart];
    return !walks_[walk].is_outer || odd_outer_walk(vertices_[v], walk);
  });
}

}  // namespace shatterpave::glass
