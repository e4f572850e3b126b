// Shapes of SVG as polylines in millimetres.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace shatterpave::scene {

// (x, y) → (a x + c y + e, b x + d y + f), as SVG's matrix(a b c d e f).
struct Affine {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

  vec2 operator()(vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  // This after `first`.
  Affine after(const Affine& first) const;
};

// A value that is not as SVG wants it; what() continues "expected …".
class SvgError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Numbers out of a list with spaces and commas, as SVG has them everywhere.
class SvgNumbers {
 public:
  explicit SvgNumbers(std::string_view text) : text_(text) {}

  bool at_end();                // nothing but spaces is left
  bool at_number();             // a number comes next
  double number();              // finite; throws SvgError
  bool flag();                  // 0 or 1, which need no space after them
  char letter();                // the next letter; throws SvgError
  void skip_character(char c);  // which must come next
  std::string_view word();      // letters up to the next other character
  std::string_view unit();      // letters right here, which may be none

 private:
  void skip_separators();

  std::string_view text_;
  std::size_t at_ = 0;
};

// The value of a `transform`.
Affine transform_of(std::string_view text);

// A length in px of CSS (1/96 inch). `text` may have a unit: mm, cm, in, px, pt, pc, Q.
double px_of(std::string_view text);

struct Subpath {
  std::vector<vec2> points;  // mm
  bool closed = false;
};

// Collects subpaths, given in user units, as points in mm, with curves no more than `tolerance` off.
class Outliner {
 public:
  Outliner(const Affine& to_mm, double tolerance_mm) : to_mm_(to_mm), tolerance_(tolerance_mm) {}

  void move_to(vec2 p);
  void line_to(vec2 p);
  void cubic_to(vec2 control_1, vec2 control_2, vec2 p);
  void quadratic_to(vec2 control, vec2 p);
  // An elliptical arc by its end, as in paths (SVG 1.1, F.6).
  void arc_to(vec2 radii, double rotation_deg, bool large, bool sweep, vec2 p);
  void close();

  vec2 current() const { return current_; }
  const std::vector<Subpath>& subpaths() const { return subpaths_; }

 private:
  void add(vec2 mm);
  vec2 in_mm(vec2 p) const;

  Affine to_mm_;
  double tolerance_;
  vec2 start_{0.0, 0.0};
  vec2 current_{0.0, 0.0};
  std::size_t count_ = 0;
  bool fresh_ = true;  // no subpath is open
  std::vector<Subpath> subpaths_;
};

// Follows the data of a path.
void follow_path(std::string_view data, Outliner& outliner);

}  // namespace shatterpave::scene
