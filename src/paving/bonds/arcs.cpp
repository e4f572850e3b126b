// Setts in arcs. The arcs are drawn with one corner wherever a perpend ends on them, on either side; stones taper and bend by
// what the arc asks for, so that the joints are as wide at one end as at the other.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/functions.h"
#include "paving/bonds/course_line.h"
#include "paving/bonds/patterns.h"

namespace shatterpave::paving {

namespace {

constexpr double same_place_mm = 0.01;

// ---- segmental arc

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

// ---- fan

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

}  // namespace

Pattern segmental_arc_pattern(vec2 pitch, double span_mm) {
  return {{span_mm, 2.0 * pitch.y}, 0.0, SegmentalArc(pitch, span_mm).tiles()};
}

Pattern fan_pattern(vec2 pitch, double span_mm) {
  return {{span_mm, 0.5 * span_mm / std::sqrt(3.0)}, 0.5, Fan(pitch, span_mm).tiles()};
}

}  // namespace shatterpave::paving
