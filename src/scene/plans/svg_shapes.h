// Elements of SVG as outlines: basic shapes, paths, and the viewports that they lie in.
#pragma once

#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "scene/plans/svg_path.h"

namespace shatterpave::scene {

std::string_view local_name(const pugi::xml_node& node);

// What an element gets for a property (SvgStyles::value).
using PropertyOf = std::function<std::string_view(const pugi::xml_node&, const char*)>;

// An element's properties as lengths in user units; percentages are of the viewport (SVG 1.1, 7.10). Throws SvgError.
class Lengths {
 public:
  Lengths(const pugi::xml_node& node, vec2 viewport, const PropertyOf& property)
      : node_(node), viewport_(viewport), property_(property) {}

  double x(const char* name, double otherwise = 0.0) const { return length(name, viewport_.x, otherwise); }
  double y(const char* name, double otherwise = 0.0) const { return length(name, viewport_.y, otherwise); }
  double along(const char* name) const;
  // A radius that may be "auto", which is as none.
  std::optional<double> radius(const char* name, double whole) const;
  vec2 viewport() const { return viewport_; }
  // As style sheets have it, or else the attribute.
  std::string_view text(const char* name) const { return property_(node_, name); }

 private:
  double length(const char* name, double whole, double otherwise) const;

  const pugi::xml_node& node_;
  vec2 viewport_;
  const PropertyOf& property_;
};

// path, polygon, polyline, rect, circle, ellipse, line.
bool is_shape_name(std::string_view name);
void outline_element(const pugi::xml_node& node, std::string_view name, const Lengths& lengths, Outliner& outliner);

struct ViewBox {
  vec2 low{0.0, 0.0};
  vec2 size{0.0, 0.0};
};

std::optional<ViewBox> view_box(const pugi::xml_node& svg);

// Where a viewBox lies in its viewport of the given size (SVG 1.1, 7.8): (0, 0) is the viewport's corner.
Affine fitted(const ViewBox& box, vec2 viewport, std::string_view aspect_ratio);

// The page that the root opens: what takes its user units to mm times `scale`, y up, and its size in user units. Without width
// and height a user unit is a px. `transform` is the root's own.
struct SvgPage {
  Affine to_mm;
  Affine outer_to_mm;  // from px of the page, in which the root itself is clipped
  vec2 viewport{0.0, 0.0};
};
SvgPage page_of(const pugi::xml_node& svg, double scale, const Affine& transform);

}  // namespace shatterpave::scene
