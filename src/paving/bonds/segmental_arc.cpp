// Setts in flat arcs, side by side and behind one another. stone_mm = [a, b]: mean along a course, and depth of a course, in
// the middle of the arc. The arcs are drawn with one corner wherever a perpend ends on them, on either side; stones taper and
// bend by what the arc asks for, so that the joints are as wide at one end as at the other.
#include <array>
#include <cmath>

#include "core/functions.h"
#include "paving/bonds/course_line.h"
#include "paving/bonds/setts.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

// Rise over span. Arcs behind one another are copies, so their distance falls from a pitch in the middle to its cosine at the
// foot; with a sixth (a foot of 36.9°) to 0.8, which setts sorted 8 to 10 cm (EN 1342) give.
constexpr double rise = 1.0 / 6.0;

class SegmentalArc {
 public:
  // The foot of course `number` is at v = number · pitch.y.
  SegmentalArc(vec2 pitch, double span_mm)
      : depth_(pitch.y),
        half_(0.5 * span_mm),
        radius_(span_mm * (1.0 + 4.0 * rise * rise) / (8.0 * rise)),
        foot_(0.5 * pi - arccosine(half_ / radius_)) {
    // Stones of one width w but for the two at the ends: 1.25 w in one course, 0.75 w in the next, which has one more. So
    // each course is half a stone off the last, and none begins with half a stone.
    const double length = 2.0 * radius_ * foot_;
    const double inner = std::max(1.0, std::round(length / pitch.x - 0.5));
    const double step = 2.0 * foot_ / (inner + 0.5);
    for (const int course : {0, 1}) {
      const int perpends = static_cast<int>(inner) - 1 + course;
      for (int i = 0; i < perpends; ++i) {
        perpends_[static_cast<std::size_t>(course)].push_back(-foot_ + (1.25 - 0.5 * course + i) * step);
      }
    }
  }

  std::vector<Tile> tiles() const {
    std::vector<Tile> result;
    for (const std::size_t course : {std::size_t{0}, std::size_t{1}}) {
      const CourseLine low = line_below(course);
      const CourseLine high = line_below(1 - course);
      const auto& at = perpends_[course];
      for (std::size_t i = 0; i <= at.size(); ++i) {
        const double from = i == 0 ? -foot_ : at[i - 1];
        const double to = i == at.size() ? foot_ : at[i];
        const auto on = [&](std::size_t line) { return [this, line](double u) { return point(u, line); }; };
        Tile tile{{point(below(from), course)}, Angle::radians(-0.5 * (from + to)).direction()};
        low.append_between(below(from), below(to), on(course), tile.outline_mm);
        tile.outline_mm.push_back(point(below(to), course));
        tile.outline_mm.push_back(point(above(to), course + 1));
        high.append_between(above(to), above(from), on(course + 1), tile.outline_mm);
        tile.outline_mm.push_back(point(above(from), course + 1));
        result.push_back(std::move(tile));
      }
    }
    return result;
  }

 private:
  bool is_foot(double angle) const { return std::abs(angle) == foot_; }

  // u where the perpend at `angle` from v, which crosses the middle of its course at right angles, ends on the arc below the
  // course, or above it. With the middle arc about the origin the arc below is about (0, −depth / 2).
  double end(double angle, double half_depth) const {
    if (is_foot(angle)) return half_ + std::copysign(half_, angle);
    const double s = half_depth * sine(angle);
    return half_ + sine(angle) * (half_depth * cosine(angle) + std::sqrt(radius_ * radius_ - s * s));
  }
  double below(double angle) const { return end(angle, -0.5 * depth_); }
  double above(double angle) const { return end(angle, 0.5 * depth_); }

  // The arc below course `line`, 0 … 2.
  vec2 point(double u, std::size_t line) const {
    const double d = u - half_;
    const double height = std::sqrt(radius_ * radius_ - d * d) - std::sqrt(radius_ * radius_ - half_ * half_);
    return {u, height + static_cast<double>(line) * depth_};
  }

  CourseLine line_below(std::size_t course) const {
    std::vector<double> stops;
    for (const double angle : perpends_[course]) stops.push_back(below(angle));
    for (const double angle : perpends_[1 - course]) stops.push_back(above(angle));
    return {std::move(stops), same_place_mm};
  }

  double depth_;
  double half_;
  double radius_;
  double foot_;                                    // angle of the arc's end from its middle, radians
  std::array<std::vector<double>, 2> perpends_{};  // of even and odd courses: angles from v to the right, ascending
};

// Chords of one span along u, bulging towards +v; one arc beside the other, and one behind the other by a pitch.
Pattern segmental_arc_pattern(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  const double span = span_mm(pavement);
  return {{span, 2.0 * pitch.y}, 0.0, SegmentalArc(pitch, span).tiles()};
}

}  // namespace

extern constinit const BondType segmental_arc_bond{
    .id = Bond::segmental_arc,
    .name = "segmental_arc",
    .sentence = "setts in flat arcs beside one another; rise a sixth of the span",
    .stone_words = "along and across a course, in the middle of the arc",
    .stock_words = largest_of_pattern,
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = sett_shapes,
    .takes_offset = false,
    .takes_span = true,
    .has_square_stones = false,
    .has_stones_of_a_size = false,
    .pattern_turn = Angle(),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = pattern_stock,
    .pattern = segmental_arc_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
