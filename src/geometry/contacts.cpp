#include "geometry/contacts.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/error.h"
#include "geometry/clip.h"
#include "geometry/predicates.h"
#include "geometry/segment_index.h"

namespace shatterpave::geometry {

namespace {

constexpr double contact_cell_mm = 1.0;
// Half the side of the square that is cut out about a contact: too large for rounding to close it again.
constexpr double half_square_mm = 0.002;
// Each cut rounds anew, but what it leaves is so far apart that a second one is rare. In bays of a few thousandths of a radian
// contacts move on by a square with each cut: after some, squares double, so that they are out of any bay soon.
constexpr int even_cuts = 4;
constexpr int most_cuts = 16;

struct RingSide {
  LatticePoint a;
  LatticePoint b;
};

// A point common to both sides.
std::optional<LatticePoint> contact(const RingSide& s, const RingSide& t) {
  if (!segments_meet(s.a, s.b, t.a, t.b)) return std::nullopt;
  for (const LatticePoint p : {t.a, t.b}) {
    if (on_segment(s.a, s.b, p)) return p;
  }
  for (const LatticePoint p : {s.a, s.b}) {
    if (on_segment(t.a, t.b, p)) return p;
  }
  const vec2 along = to_mm(s.b) - to_mm(s.a);
  const vec2 other = to_mm(t.b) - to_mm(t.a);
  const double share = cross(to_mm(t.a) - to_mm(s.a), other) / cross(along, other);
  return to_lattice(to_mm(s.a) + share * along);
}

// For neighbours, whose common vertex is no contact: an end of one that lies on the other.
std::optional<LatticePoint> doubling_back(const RingSide& before, const RingSide& after) {
  if (on_segment(before.a, before.b, after.b)) return after.b;
  if (on_segment(after.a, after.b, before.a)) return before.a;
  return std::nullopt;
}

}  // namespace

std::vector<Polygon> rings_of(const std::vector<Region>& regions) {
  std::vector<Polygon> rings;
  for (const Region& region : regions) {
    rings.push_back(region.outline);
    std::ranges::copy(region.holes, std::back_inserter(rings));
  }
  return rings;
}

std::vector<vec2> contacts(const std::vector<Polygon>& rings) {
  SegmentIndex index(contact_cell_mm);
  std::vector<RingSide> sides;
  std::vector<std::size_t> next;  // of each side
  for (const Polygon& ring : rings) {
    const std::size_t first = sides.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      sides.push_back({to_lattice(ring[i]), to_lattice(ring[j])});
      index.add({sides.back().a, sides.back().b});
      next.push_back(first + j);
    }
  }
  std::vector<vec2> result;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (const int number : index.near(sides[i].a, sides[i].b)) {
      const std::size_t j = static_cast<std::size_t>(number);
      std::optional<LatticePoint> point;
      if (next[j] == i) {
        point = doubling_back(sides[j], sides[i]);
      } else if (j > i && next[i] != j) {
        point = contact(sides[i], sides[j]);
      }
      if (point) result.push_back(to_mm(*point));
    }
  }
  return result;
}

std::vector<Region> parted(std::vector<Region> regions) {
  double half = half_square_mm;
  for (int cut = 0; cut < most_cuts; ++cut) {
    if (cut >= even_cuts) half *= 2.0;
    const std::vector<vec2> points = contacts(rings_of(regions));
    if (points.empty()) return regions;
    std::vector<Polygon> squares;
    squares.reserve(points.size());
    for (const vec2 p : points) {
      squares.push_back({p + vec2{-half, -half}, p + vec2{half, -half}, p + vec2{half, half}, p + vec2{-half, half}});
    }
    const std::vector<Region> removed = united(squares);
    std::vector<Region> left;
    for (const Region& region : regions) std::ranges::move(difference(region, removed), std::back_inserter(left));
    regions = std::move(left);
  }
  ENSURE(contacts(rings_of(regions)).empty());
  return regions;
}

}  // namespace shatterpave::geometry
