#include "glass/growth/crack_chips.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle.h"
#include "core/functions.h"
#include "geometry/lattice.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;

// A radial bends in a vertex where it turns by this much. By eye.
constexpr Angle least_bend = Angle::degrees(4.0);
// The part of such vertices at which a chip has come off. By eye.
constexpr double chipped = 0.2;
// Chips are two to four ribbons of 0.4 to 2.5 mm wide in photographs, and about three times as long; near the impact they are
// no longer than this share of the distance from it.
constexpr double least_length_mm = 1.2;
constexpr double greatest_length_mm = 5.0;
constexpr double longest_share = 0.2;
constexpr double least_width_share = 0.2;
constexpr double greatest_width_share = 0.4;

constexpr int arc_pieces = 6;

// The point `way_mm` farther on along the line than its vertex `from`; its end where it is shorter.
vec2 farther_on(const std::vector<vec2>& line, std::size_t from, double way_mm) {
  for (std::size_t i = from + 1; i < line.size(); ++i) {
    const double length = glm::length(line[i] - line[i - 1]);
    if (length >= way_mm) return glm::mix(line[i - 1], line[i], way_mm / length);
    way_mm -= length;
  }
  return line.back();
}

bool bends(const std::vector<vec2>& line, std::size_t i) {
  const vec2 before = line[i] - line[i - 1];
  const vec2 after = line[i + 1] - line[i];
  return std::abs(arctangent(cross(before, after), glm::dot(before, after))) > least_bend.radians();
}

struct ChipArc {
  LatticePoint at;
  vec2 end_mm{0.0, 0.0};
  double width_mm = 0.0;  // to the left, or below 0 to the right
  double from_us = 0.0;
};

void lay_chip(const ChipArc& arc, int impact, double speed_mm_us, CrackMap& map) {
  const auto& [at, end_mm, width_mm, from_us] = arc;
  const vec2 start_mm = geometry::to_mm(at);
  const vec2 aside = left_of(glm::normalize(end_mm - start_mm));
  const int crack = map.start(map.add_hub(at), CrackKind::chip, impact, CrackEnd::At::crack, from_us);
  for (int k = 1; k <= arc_pieces + 1; ++k) {
    // A piece beyond its end, for arcs that rounding has miss the radial.
    const double t = static_cast<double>(k) / arc_pieces;
    const vec2 on_arc = glm::mix(start_mm, end_mm, t) + 4.0 * t * (1.0 - t) * width_mm * aside;
    if (map.run(crack, geometry::to_lattice(on_arc), speed_mm_us)) return;
  }
  map.stop(crack, CrackEnd::At::open);
}

}  // namespace

void lay_chips(std::span<const int> radials, const RingCentre& centre, double speed_mm_us, std::uint64_t seed, CrackMap& map) {
  for (std::size_t r = 0; r < radials.size(); ++r) {
    const std::vector<LatticePoint> points = map.points(radials[r]);
    std::vector<vec2> line(points.size());
    std::ranges::transform(points, line.begin(), [](LatticePoint p) { return geometry::to_mm(p); });
    double chipped_to_mm = 0.0;  // chips of one radial lie apart
    for (std::size_t i = 1; i + 2 < line.size(); ++i) {
      const auto draw = [&](std::uint32_t number) {
        return uniform(seed, {Stream::crack_chip, centre.id.child("chip").child(r).child(i), number});
      };
      const double out_mm = glm::length(line[i] - centre.at_mm);
      const double length_mm = least_length_mm + (greatest_length_mm - least_length_mm) * draw(1) * draw(2);
      if (out_mm < chipped_to_mm || length_mm > longest_share * out_mm || !bends(line, i) || draw(0) >= chipped) continue;
      const vec2 end_mm = farther_on(line, i, length_mm);
      if (glm::length(end_mm - line[i]) < 0.5 * length_mm) continue;
      const double width = least_width_share + (greatest_width_share - least_width_share) * draw(3);
      const double gone_by_us = map.time_us(radials[r], geometry::to_lattice(end_mm));
      lay_chip({points[i], end_mm, (draw(4) < 0.5 ? width : -width) * length_mm, gone_by_us}, centre.impact, speed_mm_us, map);
      chipped_to_mm = out_mm + 1.5 * length_mm;
    }
  }
}

}  // namespace shatterpave::glass
