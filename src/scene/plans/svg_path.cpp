#include "scene/plans/svg_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "core/functions.h"
#include "geometry/lattice.h"
#include "scene/input_file.h"
#include "scene/plans/outline.h"

namespace shatterpave::scene {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

Affine rotation(double degrees) {
  const double angle = degrees * (pi / 180.0);
  return {cosine(angle), sine(angle), -sine(angle), cosine(angle), 0.0, 0.0};
}

double tangent(double degrees) {
  const double angle = degrees * (pi / 180.0);
  const double c = cosine(angle);
  if (c == 0.0) throw SvgError("a skew of less than 90 degrees");
  return sine(angle) / c;
}

Affine one_transform(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return {1, 0, 0, 1, v[0], n == 2 ? v[1] : 0.0};
  if (name == "scale" && (n == 1 || n == 2)) return {v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
  if (name == "rotate" && n == 1) return rotation(v[0]);
  if (name == "rotate" && n == 3) {
    const Affine there{1, 0, 0, 1, v[1], v[2]};
    const Affine back{1, 0, 0, 1, -v[1], -v[2]};
    return there.after(rotation(v[0])).after(back);
  }
  if (name == "skewX" && n == 1) return {1, 0, tangent(v[0]), 1, 0, 0};
  if (name == "skewY" && n == 1) return {1, tangent(v[0]), 0, 1, 0, 0};
  throw SvgError(fmt::format("a transform of SVG, got {} with {} numbers", in_quotes(name), n));
}

// The arc as a centre, an angle to start from and one to go on by, on the unit circle that `frame` takes to the ellipse.
struct CentredArc {
  Affine frame;
  double start = 0.0;
  double turn = 0.0;
};

// SVG 1.1, F.6.5 and F.6.6; the points differ and the radii are not 0.
CentredArc centred_arc(vec2 from, vec2 to, vec2 radii, double rotation_deg, bool large, bool sweep) {
  const Affine turned = rotation(rotation_deg);
  const Affine turned_back = rotation(-rotation_deg);
  const vec2 half = turned_back(0.5 * (from - to));
  vec2 r{std::abs(radii.x), std::abs(radii.y)};
  const double needed = (half.x / r.x) * (half.x / r.x) + (half.y / r.y) * (half.y / r.y);
  if (needed > 1.0) r *= std::sqrt(needed);
  const vec2 unit = half / r;  // of length <= 1
  const double length_2 = std::min(1.0, glm::dot(unit, unit));
  const double distance = std::sqrt(std::max(0.0, (1.0 - length_2) / length_2)) * (large == sweep ? -1.0 : 1.0);
  const vec2 centre_unit = distance * vec2{unit.y, -unit.x};
  const vec2 centre = turned(centre_unit * r) + 0.5 * (from + to);
  const vec2 a = unit - centre_unit;
  const vec2 b = -unit - centre_unit;
  CentredArc arc;
  arc.frame = Affine{1, 0, 0, 1, centre.x, centre.y}.after(turned).after({r.x, 0, 0, r.y, 0, 0});
  arc.start = arctangent(a.y, a.x);
  arc.turn = arctangent(b.y, b.x) - arc.start;
  if (sweep && arc.turn < 0.0) arc.turn += 2.0 * pi;
  if (!sweep && arc.turn > 0.0) arc.turn -= 2.0 * pi;
  return arc;
}

}  // namespace

Affine Affine::after(const Affine& first) const {
  return {a * first.a + c * first.b, b * first.a + d * first.b,     a * first.c + c * first.d,
          b * first.c + d * first.d, a * first.e + c * first.f + e, b * first.e + d * first.f + f};
}

void SvgNumbers::skip_separators() {
  while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ',')) ++at_;
}

bool SvgNumbers::at_end() {
  skip_separators();
  return at_ == text_.size();
}

bool SvgNumbers::at_number() {
  if (at_end()) return false;
  const char c = text_[at_];
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

double SvgNumbers::number() {
  if (!at_number()) throw SvgError(fmt::format("a number, got {}", in_quotes(text_.substr(at_, 10))));
  const std::size_t start = at_ + (text_[at_] == '+' ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text_.data() + start, text_.data() + text_.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) {
    throw SvgError(fmt::format("a number, got {}", in_quotes(text_.substr(at_, 10))));
  }
  at_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

bool SvgNumbers::flag() {
  skip_separators();
  if (at_ == text_.size() || (text_[at_] != '0' && text_[at_] != '1'))
    throw SvgError("a flag 0 or 1 of an arc, got something else");
  return text_[at_++] == '1';
}

char SvgNumbers::letter() {
  if (at_end() || !is_letter(text_[at_])) throw SvgError(fmt::format("a letter, got {}", in_quotes(text_.substr(at_, 10))));
  return text_[at_++];
}

void SvgNumbers::skip_character(char c) {
  if (at_end() || text_[at_] != c) throw SvgError(fmt::format("'{}', got {}", c, in_quotes(text_.substr(at_, 10))));
  ++at_;
}

std::string_view SvgNumbers::word() {
  skip_separators();
  const std::size_t start = at_;
  while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
  return text_.substr(start, at_ - start);
}

namespace {

// CSS writes the numbers of a transform with units; SVG's attribute has px and degrees without.
double css_factor(std::string_view unit) {
  if (unit.empty() || unit == "px" || unit == "deg") return 1.0;
  if (unit == "rad") return 180.0 / pi;
  if (unit == "turn") return 360.0;
  throw SvgError(fmt::format("a transform in px and deg, got {}", in_quotes(unit)));
}

}  // namespace

std::string_view SvgNumbers::unit() { return at_ < text_.size() && is_letter(text_[at_]) ? word() : std::string_view(); }

Affine transform_of(std::string_view text) {
  Affine result;
  SvgNumbers numbers(text);
  while (!numbers.at_end()) {
    const std::string_view name = numbers.word();
    numbers.skip_character('(');
    std::vector<double> values;
    while (numbers.at_number() && values.size() < 7) values.push_back(numbers.number() * css_factor(numbers.unit()));
    numbers.skip_character(')');
    result = result.after(one_transform(name, values));
  }
  return result;
}

double px_of(std::string_view text) {
  SvgNumbers numbers(text);
  const double value = numbers.number();
  const std::string_view unit = numbers.word();
  if (!numbers.at_end()) throw SvgError(fmt::format("a length, got {}", in_quotes(text)));
  constexpr double inch = 96.0;
  if (unit.empty() || unit == "px") return value;
  if (unit == "mm") return value * inch / 25.4;
  if (unit == "cm") return value * inch / 2.54;
  if (unit == "Q") return value * inch / 101.6;
  if (unit == "in") return value * inch;
  if (unit == "pt") return value * inch / 72.0;
  if (unit == "pc") return value * inch / 6.0;
  throw SvgError(fmt::format("a length in mm, cm, in, px, pt, pc or Q, got {}", in_quotes(text)));
}

vec2 Outliner::in_mm(vec2 p) const {
  const vec2 mm = to_mm_(p);
  const double limit = geometry::largest_coordinate_mm;
  if (!(std::abs(mm.x) <= limit && std::abs(mm.y) <= limit)) {
    throw SvgError(fmt::format("coordinates from {} to {} mm, got ({}, {})", -limit, limit, mm.x, mm.y));
  }
  return mm;
}

void Outliner::add(vec2 mm) {
  if (++count_ > most_vertices) throw SvgError(fmt::format("at most {} points, got more", most_vertices));
  subpaths_.back().points.push_back(mm);
}

void Outliner::move_to(vec2 p) {
  start_ = current_ = p;
  fresh_ = true;
}

void Outliner::line_to(vec2 p) {
  if (fresh_) {
    subpaths_.emplace_back();
    fresh_ = false;
    add(in_mm(current_));
  }
  add(in_mm(p));
  current_ = p;
}

void Outliner::cubic_to(vec2 control_1, vec2 control_2, vec2 p) {
  const vec2 a = in_mm(current_);
  const vec2 b = in_mm(control_1);
  const vec2 c = in_mm(control_2);
  const vec2 d = in_mm(p);
  // A chord over 1/n of the curve is off by at most |B″| / (8 n²), and |B″| <= 6 times the larger second difference.
  const double bend = std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d));
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::sqrt(0.75 * bend / tolerance_))));
  if (fresh_) {
    subpaths_.emplace_back();
    fresh_ = false;
    add(a);
  }
  for (int i = 1; i < pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const double s = 1.0 - t;
    add(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
  }
  add(d);
  current_ = p;
}

void Outliner::quadratic_to(vec2 control, vec2 p) {
  const vec2 from = current_;
  cubic_to(from + (2.0 / 3.0) * (control - from), p + (2.0 / 3.0) * (control - p), p);
}

void Outliner::arc_to(vec2 radii, double rotation_deg, bool large, bool sweep, vec2 p) {
  if (p == current_) return;
  if (radii.x == 0.0 || radii.y == 0.0) return line_to(p);
  const CentredArc arc = centred_arc(current_, p, radii, rotation_deg, large, sweep);
  // Cubics over an eighth of a half turn are off by less than 1e-7 of the radius.
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.turn) / (pi / 8.0))));
  const double step = arc.turn / pieces;
  const double reach = 4.0 / 3.0 * sine(step / 4.0) / cosine(step / 4.0);
  for (int i = 0; i < pieces; ++i) {
    const double t = arc.start + i * step;
    const vec2 from{cosine(t), sine(t)};
    const vec2 to{cosine(t + step), sine(t + step)};
    const vec2 end = i + 1 == pieces ? p : arc.frame(to);
    cubic_to(arc.frame(from + reach * left_of(from)), arc.frame(to - reach * left_of(to)), end);
  }
}

void Outliner::close() {
  if (!fresh_) subpaths_.back().closed = true;
  current_ = start_;
  fresh_ = true;
}

namespace {

// One path as it is followed: what curves that continue the one before need to know of it.
class PathFollower {
 public:
  PathFollower(std::string_view data, Outliner& outliner) : in_(data), out_(outliner) {}

  void follow() {
    if (in_.at_end()) return;
    char command = in_.letter();
    if (lower(command) != 'm') throw SvgError("a path that begins with M, got another letter");
    while (true) {
      if (lower(command) == 'z') {
        out_.close();
      } else {
        step(command);
        // Further pairs after a move are lines.
        if (lower(command) == 'm') command = command == 'm' ? 'l' : 'L';
        while (in_.at_number()) step(command);
      }
      if (in_.at_end()) return;
      command = in_.letter();
    }
  }

 private:
  vec2 point(char command) {
    const double x = in_.number();
    const double y = in_.number();
    return vec2{x, y} + (lower(command) == command ? out_.current() : vec2{0.0, 0.0});
  }

  // The control point that makes the next curve go on smoothly; the current point if the last one was of another kind.
  vec2 reflected(const std::optional<vec2>& control) const {
    return control ? 2.0 * out_.current() - *control : out_.current();
  }

  void step(char command) {
    const std::optional<vec2> cubic = std::exchange(last_cubic_, std::nullopt);
    const std::optional<vec2> quadratic = std::exchange(last_quadratic_, std::nullopt);
    switch (lower(command)) {
      case 'm':
        return out_.move_to(point(command));
      case 'l':
        return out_.line_to(point(command));
      case 'h':
        return out_.line_to({in_.number() + (command == 'h' ? out_.current().x : 0.0), out_.current().y});
      case 'v':
        return out_.line_to({out_.current().x, in_.number() + (command == 'v' ? out_.current().y : 0.0)});
      case 'c':
        return cubic_from(point(command), command);
      case 's':
        return cubic_from(reflected(cubic), command);
      case 'q':
        return quadratic_from(point(command), command);
      case 't':
        return quadratic_from(reflected(quadratic), command);
      case 'a':
        return arc(command);
      default:
        throw SvgError(fmt::format("a command of a path, got {}", in_quotes(std::string_view(&command, 1))));
    }
  }

  void cubic_from(vec2 control_1, char command) {
    const vec2 control_2 = point(command);
    const vec2 end = point(command);
    out_.cubic_to(control_1, control_2, end);
    last_cubic_ = control_2;
  }

  void quadratic_from(vec2 control, char command) {
    const vec2 end = point(command);
    out_.quadratic_to(control, end);
    last_quadratic_ = control;
  }

  void arc(char command) {
    const double rx = in_.number();
    const double ry = in_.number();
    const double rotation_deg = in_.number();
    const bool large = in_.flag();
    const bool sweep = in_.flag();
    out_.arc_to({rx, ry}, rotation_deg, large, sweep, point(command));
  }

  SvgNumbers in_;
  Outliner& out_;
  std::optional<vec2> last_cubic_;
  std::optional<vec2> last_quadratic_;
};

}  // namespace

void follow_path(std::string_view data, Outliner& outliner) { PathFollower(data, outliner).follow(); }

}  // namespace shatterpave::scene
