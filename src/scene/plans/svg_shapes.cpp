#include "scene/plans/svg_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

constexpr double mm_per_px = 25.4 / 96.0;

void outline_ellipse(vec2 centre, vec2 radii, Outliner& outliner) {
  outliner.move_to(centre + vec2{radii.x, 0.0});
  outliner.arc_to(radii, 0.0, false, true, centre - vec2{radii.x, 0.0});
  outliner.arc_to(radii, 0.0, false, true, centre + vec2{radii.x, 0.0});
  outliner.close();
}

// SVG 1.1, 9.2: a missing radius is as the other one, and neither is more than half the side.
void outline_rect(const Lengths& lengths, Outliner& outliner) {
  const vec2 low{lengths.x("x"), lengths.y("y")};
  const vec2 size{lengths.x("width"), lengths.y("height")};
  if (size.x <= 0.0 || size.y <= 0.0) return;
  const auto rx = lengths.radius("rx", lengths.viewport().x);
  const auto ry = lengths.radius("ry", lengths.viewport().y);
  const vec2 r{std::clamp(rx ? *rx : ry.value_or(0.0), 0.0, 0.5 * size.x),
               std::clamp(ry ? *ry : rx.value_or(0.0), 0.0, 0.5 * size.y)};
  const vec2 high = low + size;
  outliner.move_to({low.x + r.x, low.y});
  outliner.line_to({high.x - r.x, low.y});
  outliner.arc_to(r, 0.0, false, true, {high.x, low.y + r.y});
  outliner.line_to({high.x, high.y - r.y});
  outliner.arc_to(r, 0.0, false, true, {high.x - r.x, high.y});
  outliner.line_to({low.x + r.x, high.y});
  outliner.arc_to(r, 0.0, false, true, {low.x, high.y - r.y});
  outliner.line_to({low.x, low.y + r.y});
  outliner.arc_to(r, 0.0, false, true, {low.x + r.x, low.y});
  outliner.close();
}

void outline_points(const pugi::xml_node& node, bool closed, Outliner& outliner) {
  SvgNumbers numbers(node.attribute("points").value());
  bool first = true;
  while (!numbers.at_end()) {
    const double x = numbers.number();
    const vec2 p{x, numbers.number()};
    first ? outliner.move_to(p) : outliner.line_to(p);
    first = false;
  }
  if (closed) outliner.close();
}

}  // namespace

bool is_shape_name(std::string_view name) {
  constexpr std::array<std::string_view, 7> names = {"path", "polygon", "polyline", "rect", "circle", "ellipse", "line"};
  return std::ranges::find(names, name) != names.end();
}

void outline_element(const pugi::xml_node& node, std::string_view name, const Lengths& lengths, Outliner& outliner) {
  if (name == "path") {
    const std::string_view path = node.attribute("d").value();
    // Browsers follow it, most drawing programs do not.
    if (const std::string_view styled = lengths.text("d"); path.find(styled) == std::string_view::npos) {
      throw SvgError(fmt::format("a path in the attribute d, got {} in its style", in_quotes(styled)));
    }
    return follow_path(path, outliner);
  }
  if (name == "polygon" || name == "polyline") return outline_points(node, name == "polygon", outliner);
  if (name == "rect") return outline_rect(lengths, outliner);
  if (name == "line") {
    outliner.move_to({lengths.x("x1"), lengths.y("y1")});
    return outliner.line_to({lengths.x("x2"), lengths.y("y2")});
  }
  const vec2 centre{lengths.x("cx"), lengths.y("cy")};
  const double r = lengths.along("r");
  const vec2 radii = name == "circle" ? vec2{r, r} : vec2{lengths.x("rx"), lengths.y("ry")};
  if (radii.x > 0.0 && radii.y > 0.0) outline_ellipse(centre, radii, outliner);
}

double Lengths::along(const char* name) const { return length(name, glm::length(viewport_) / std::sqrt(2.0), 0.0); }

std::optional<double> Lengths::radius(const char* name, double whole) const {
  const std::string_view text = property_(node_, name);
  if (text.empty() || text == "auto") return std::nullopt;
  return length(name, whole, 0.0);
}

double Lengths::length(const char* name, double whole, double otherwise) const {
  const std::string_view text = property_(node_, name);
  if (text.empty() || text == "auto") return otherwise;
  if (!text.ends_with('%')) return px_of(text);
  // Of a page without a size, which a browser would make as large as its window.
  if (whole <= 0.0) throw SvgError(fmt::format("a viewBox, or a size of the page, beside {}, got none", in_quotes(text)));
  return px_of(text.substr(0, text.size() - 1)) / 100.0 * whole;
}

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::optional<ViewBox> view_box(const pugi::xml_node& svg) {
  const pugi::xml_attribute attribute = svg.attribute("viewBox");
  if (!attribute) return std::nullopt;
  SvgNumbers numbers(attribute.value());
  std::array<double, 4> box{};
  for (double& value : box) value = numbers.number();
  if (!numbers.at_end() || box[2] <= 0.0 || box[3] <= 0.0) throw SvgError("a viewBox of x y width height, got another");
  return ViewBox{{box[0], box[1]}, {box[2], box[3]}};
}

// Where a viewBox lies in its viewport of the given size (SVG 1.1, 7.8): (0, 0) is the viewport's corner.
Affine fitted(const ViewBox& box, vec2 viewport, std::string_view aspect_ratio) {
  std::vector<std::string> words = words_of(aspect_ratio);
  if (!words.empty() && words.front() == "defer") words.erase(words.begin());
  const std::string align = words.empty() ? "xMidYMid" : words.front();
  vec2 scale = viewport / box.size;
  if (align == "none") return {scale.x, 0, 0, scale.y, -scale.x * box.low.x, -scale.y * box.low.y};
  const auto part = [&](std::size_t at) -> double {
    const std::string word = align.size() == 8 ? align.substr(at, 3) : std::string();
    if (word == "Min") return 0.0;
    if (word == "Mid") return 0.5;
    if (word == "Max") return 1.0;
    throw SvgError(fmt::format("a preserveAspectRatio of SVG, got {}", in_quotes(aspect_ratio)));
  };
  const bool slice = words.size() > 1 && words[1] == "slice";
  const double factor = slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
  const vec2 spare = (viewport - factor * box.size) * vec2{part(1), part(5)};
  return {factor, 0, 0, factor, spare.x - factor * box.low.x, spare.y - factor * box.low.y};
}

namespace {

// A length of the page; nothing where it is missing or relative to a screen.
std::optional<double> page_length(const pugi::xml_node& svg, const char* name) {
  const std::string_view text = svg.attribute(name).value();
  if (text.empty() || text == "auto" || text.ends_with('%')) return std::nullopt;
  const double length = px_of(text);
  if (length <= 0.0) throw SvgError(fmt::format("a {} above 0, got {}", name, in_quotes(text)));
  return length;
}

}  // namespace

SvgPage page_of(const pugi::xml_node& svg, double scale, const Affine& transform) {
  const auto box = view_box(svg);
  auto width = page_length(svg, "width");
  auto height = page_length(svg, "height");
  Affine to_px;
  if (box) {
    if (!width && !height) width = box->size.x;
    if (!width) width = *height * box->size.x / box->size.y;
    if (!height) height = *width * box->size.y / box->size.x;
    to_px = fitted(*box, {*width, *height}, svg.attribute("preserveAspectRatio").value());
  }
  const double mm = scale * mm_per_px;
  const Affine outer = Affine{mm, 0, 0, -mm, 0, mm * height.value_or(0.0)}.after(transform);
  return {outer.after(to_px), outer, box ? box->size : vec2{width.value_or(0.0), height.value_or(0.0)}};
}

}  // namespace shatterpave::scene
