// Setts in flat arcs, side by side and behind one another. stone_mm = [a, b]: mean along a course, and depth of a course, in
// the middle of the arc. The arcs are drawn with one corner wherever a perpend ends on them, on either side; stones taper and
// bend by what the arc asks for, so that the joints are as wide at one end as at the other.
//
// Where two arcs meet, in the valley, courses interlock as a paviour lays them: by turns that of the one arc and that of the
// other reaches three quarters of a stone across, and so far the joints lie flat. So there is no straight joint from front to
// back, and each course is half a stone off the last with stones of one kind only.
#include <algorithm>
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

// Stones are narrower towards the feet, where courses are less deep, too: of stones of one width, how far along the arc a
// perpend is, −1 … 1, as that part of the foot's angle. The slope goes from 1.025 to 0.95, by eye: those in the valley, which
// stand upright, look like slats if they are much narrower.
double sorted(double t) { return t * (1.025 - 0.025 * t * t); }

// How far a course reaches across the valley, in stones. With a quarter courses are half a stone off, too, but look cut by a
// saw.
constexpr double reach = 0.75;

class SegmentalArc {
 public:
  // The foot of course `number` is at v = number · pitch.y.
  SegmentalArc(vec2 pitch, double span_mm)
      : depth_(pitch.y),
        half_(0.5 * span_mm),
        radius_(span_mm * (1.0 + 4.0 * rise * rise) / (8.0 * rise)),
        foot_(0.5 * pi - arccosine(half_ / radius_)) {
    const double length = 2.0 * radius_ * foot_;
    const double stones = std::max(3.0, std::round(length / pitch.x));
    const auto angle = [&](double stone) { return foot_ * sorted(2.0 * stone / stones - 1.0); };
    flat_ = -angle(reach);
    across_mm_ = half_ - radius_ * sine(flat_);
    // Courses begin to the right of the valley, or to the left of it.
    for (const int course : {0, 1}) {
      const double first = course == 0 ? reach : -reach;
      for (int i = 1; i < static_cast<int>(stones); ++i) {
        perpends_[static_cast<std::size_t>(course)].push_back(angle(first + i));
      }
    }
  }

  std::vector<Tile> tiles() const {
    std::vector<Tile> result;
    for (const std::size_t course : {std::size_t{0}, std::size_t{1}}) {
      const CourseLine low = line_below(course);
      const CourseLine high = line_below(1 - course);
      const auto& at = perpends_[course];
      const double aside = course == 0 ? across_mm_ : -across_mm_;
      const Perpend first{aside, aside, 0.0};
      const Perpend last{2.0 * half_ + aside, 2.0 * half_ + aside, 0.0};
      for (std::size_t i = 0; i <= at.size(); ++i) {
        const Perpend from = i == 0 ? first : perpend(at[i - 1]);
        const Perpend to = i == at.size() ? last : perpend(at[i]);
        const auto on = [&](std::size_t line) { return [this, line](double u) { return point(u, line); }; };
        Tile tile{{point(from.below, course)}, Angle::radians(-0.5 * (from.lean + to.lean)).direction()};
        low.append_between(from.below, to.below, on(course), tile.outline_mm);
        tile.outline_mm.push_back(point(to.below, course));
        tile.outline_mm.push_back(point(to.above, course + 1));
        high.append_between(to.above, from.above, on(course + 1), tile.outline_mm);
        tile.outline_mm.push_back(point(from.above, course + 1));
        result.push_back(std::move(tile));
      }
    }
    return result;
  }

 private:
  // A joint between two stones of a course: u where it ends on the arc below and above, and how far it leans from v,
  // radians.
  struct Perpend {
    double below = 0.0;
    double above = 0.0;
    double lean = 0.0;
  };

  // It crosses the middle of its course at right angles, but for those near the valley, which turn upright as those in it are.
  // With the middle arc about the origin the arc below is about (0, −depth / 2).
  Perpend perpend(double angle) const {
    const double part = std::min(1.0, angle * angle / (flat_ * flat_));
    const auto end = [&](double half_depth) {
      const double s = half_depth * sine(angle);
      const double radial = half_depth * cosine(angle) + std::sqrt(radius_ * radius_ - s * s);
      return half_ + sine(angle) * (radial + part * part * (radius_ - radial));
    };
    return {end(-0.5 * depth_), end(0.5 * depth_), angle * (1.0 - part * part)};
  }

  // The arc below course `line`, 0 … 2; flat where courses reach across the valley.
  vec2 point(double u, std::size_t line) const {
    const double d = std::min(std::abs(u - half_), half_ - across_mm_);
    const double height = std::sqrt(radius_ * radius_ - d * d) - std::sqrt(radius_ * radius_ - half_ * half_);
    return {u, height + static_cast<double>(line) * depth_};
  }

  CourseLine line_below(std::size_t course) const {
    std::vector<double> stops{across_mm_, 2.0 * half_ - across_mm_};
    for (const double angle : perpends_[course]) stops.push_back(perpend(angle).below);
    for (const double angle : perpends_[1 - course]) stops.push_back(perpend(angle).above);
    return {std::move(stops), same_place_mm};
  }

  double depth_;
  double half_;
  double radius_;
  double foot_;                                    // angle of the arc's end from its middle, radians
  double flat_ = 0.0;                              // and of where its joints begin to lie flat
  double across_mm_ = 0.0;                         // from there to the valley, along u
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
    .sentence = "setts in flat arcs that interlock where they meet; rise a sixth of the span",
    .stone_words = "along and across a course, in the middle of the arc",
    .stock_words = largest_of_pattern,
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = sett_shapes,
    .takes_offset = false,
    .takes_span = true,
    .takes_module = false,
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
