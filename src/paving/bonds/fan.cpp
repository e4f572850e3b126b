// Setts in rings about the feet of fans, which overlap like scales. stone_mm = [a, b]: mean along a ring, and depth of a ring.
// As in segmental arcs, lines are drawn with one corner wherever a perpend ends on them, and joints are as wide at one end as
// at the other.
#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "paving/bonds/course_line.h"
#include "paving/bonds/setts.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

// A fan opens from its foot between the backs of two others, and ends in an arc about its foot. The backs are arcs of the same
// radius R about their own feet, at (±√3/2 R, −R/2): so feet, backs and rings all fit, and the fans leave nothing between them.
class Fan {
 public:
  Fan(vec2 pitch, double span_mm) : span_(span_mm), radius_(span_mm / std::sqrt(3.0)) {
    const int rings = std::max(1, static_cast<int>(std::lround(radius_ / pitch.y)));
    for (int k = 0; k <= rings; ++k) radii_.push_back(radius_ * k / rings);
    perpends_.resize(static_cast<std::size_t>(rings));
    for (int k = 0; k < rings; ++k) divide(k, pitch.x);
    std::vector<double> back = perpends_.back();
    for (std::size_t k = 1; k + 1 < radii_.size(); ++k) {
      back.push_back(landing(k));
      back.push_back(-landing(k));
    }
    back.push_back(0.0);  // where the feet of others stand
    for (std::size_t k = 0; k + 1 < radii_.size(); ++k) {
      std::vector<double> stops = perpends_[k];
      if (k > 0) stops.insert(stops.end(), perpends_[k - 1].begin(), perpends_[k - 1].end());
      lines_.emplace_back(std::move(stops), same_place_mm / radius_);
    }
    lines_.emplace_back(std::move(back), same_place_mm / radius_);
  }

  std::vector<Tile> tiles() const {
    std::vector<Tile> result;
    for (std::size_t k = 0; k < perpends_.size(); ++k) {
      for (std::size_t i = 0; i <= perpends_[k].size(); ++i) result.push_back(tile(k, i));
    }
    return result;
  }

 private:
  static double foot_angle() { return pi / 3.0; }

  vec2 polar(double radius, double angle) const { return {radius * sine(angle), radius * cosine(angle)}; }

  // Ring k has a whole number of stones, odd and even by turns, so that no perpend goes on through rings, unless stones became
  // too long or too short for that.
  void divide(int k, double pitch) {
    constexpr double most_off = 0.18;  // by eye
    const auto ring = static_cast<std::size_t>(k);
    const double middle = 0.5 * (radii_[ring] + radii_[ring + 1]);
    const double half = arccosine(-0.5 * middle / radius_) - foot_angle();
    const double wanted = 2.0 * half * middle / pitch;
    const double like = 2.0 * std::round(0.5 * (wanted - 1.0 - k % 2)) + 1.0 + k % 2;
    const double count = std::max(1.0, std::abs(wanted / like - 1.0) <= most_off ? like : std::round(wanted));
    for (double i = 1.0; i < count; i += 1.0) perpends_[ring].push_back(half * (2.0 * i / count - 1.0));
  }

  // The angle on the back of a fan at which the k-th ring of the fan behind it to the right ends: as long a chord from the foot
  // of that one, which stands at the end of the back, as the ring's radius.
  double landing(std::size_t k) const { return foot_angle() - 2.0 * (0.5 * pi - arccosine(0.5 * radii_[k] / radius_)); }

  // The end of the line below ring k; sign −1: to the left, 1: to the right. It stands on the back of the fan before.
  vec2 on_side(double angle_of_back, double sign) const {
    const vec2 right = vec2{0.5 * span_, -0.5 * radius_} + polar(radius_, -angle_of_back);
    return {sign * right.x, right.y};
  }

  Tile tile(std::size_t k, std::size_t i) const {
    const auto& at = perpends_[k];
    const bool leftmost = i == 0;
    const bool rightmost = i == at.size();
    const double from = leftmost ? -pi : at[i - 1];
    const double to = rightmost ? pi : at[i];
    Tile tile;
    geometry::Polygon& outline = tile.outline_mm;
    const auto along_line = [&](std::size_t line, double a, double b) {
      lines_[line].append_between(
          a, b, [&](double angle) { return polar(radii_[line], angle); }, outline);
    };
    const auto along_side = [&](double sign, std::size_t a, std::size_t b) {
      lines_.back().append_between(
          landing(a), landing(b), [&](double angle) { return on_side(angle, sign); }, outline);
    };
    if (k == 0) {
      outline.push_back({0.0, 0.0});
    } else {
      outline.push_back(leftmost ? on_side(landing(k), -1.0) : polar(radii_[k], from));
      along_line(k, from, to);
      outline.push_back(rightmost ? on_side(landing(k), 1.0) : polar(radii_[k], to));
    }
    if (rightmost) along_side(1.0, k, k + 1);
    outline.push_back(rightmost ? on_side(landing(k + 1), 1.0) : polar(radii_[k + 1], to));
    along_line(k + 1, to, from);
    outline.push_back(leftmost ? on_side(landing(k + 1), -1.0) : polar(radii_[k + 1], from));
    if (leftmost) along_side(-1.0, k + 1, k);
    const vec2 middle = geometry::centroid(outline);
    tile.axis = glm::normalize(-left_of(middle));
    return tile;
  }

  double span_;
  double radius_;
  std::vector<double> radii_;                  // of the lines below the rings, and of the back
  std::vector<std::vector<double>> perpends_;  // of each ring: angles from v to the right, ascending
  std::vector<CourseLine> lines_;
};

// Fans of one span, which open towards +v.
Pattern fan_pattern(const Pavement& pavement) {
  const double span = span_mm(pavement);
  return {{span, 0.5 * span / std::sqrt(3.0)}, 0.5, Fan(pitch_mm(pavement), span).tiles()};
}

}  // namespace

extern constinit const BondType fan_bond{
    .id = Bond::fan,
    .name = "fan",
    .sentence = "setts in rings that fill fans, one behind the other like scales",
    .stone_words = "along and across a ring, in the mean",
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
    .pattern = fan_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
