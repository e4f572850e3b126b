// SVG is read by pugixml, which loads no external entity and expands none of a document type.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>

#include "scene/input_file.h"
#include "scene/outline.h"
#include "scene/outline_file.h"
#include "scene/shape_choice.h"
#include "scene/svg_path.h"

namespace shatterpave::scene {

namespace {

constexpr int deepest_groups = 100;
constexpr std::size_t most_shapes = 100'000;
constexpr double mm_per_px = 25.4 / 96.0;

enum class FillRule { nonzero, evenodd };

// What an element hands on to those inside it.
struct Inherited {
  Affine to_mm;
  FillRule fill_rule = FillRule::nonzero;
};

struct ClosedShape {
  pugi::xml_node node;
  FillRule fill_rule = FillRule::nonzero;
  std::vector<geometry::Polygon> rings;  // mm
};

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// An attribute, or the property of the same name in `style`, which wins.
std::string_view property(const pugi::xml_node& node, const char* name) {
  const std::string_view style = node.attribute("style").value();
  const std::string_view wanted = name;
  for (std::size_t at = 0; at < style.size();) {
    const std::size_t end = std::min(style.find(';', at), style.size());
    std::string_view declaration = style.substr(at, end - at);
    at = end + 1;
    const auto trim = [](std::string_view text) {
      while (!text.empty() && (text.front() == ' ' || text.front() == '\n')) text.remove_prefix(1);
      while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) text.remove_suffix(1);
      return text;
    };
    const std::size_t colon = declaration.find(':');
    if (colon != std::string_view::npos && trim(declaration.substr(0, colon)) == wanted)
      return trim(declaration.substr(colon + 1));
  }
  return node.attribute(name).value();
}

double length_or(const pugi::xml_node& node, const char* name, double otherwise) {
  const pugi::xml_attribute attribute = node.attribute(name);
  return attribute ? px_of(attribute.value()) : otherwise;
}

void outline_ellipse(vec2 centre, vec2 radii, Outliner& outliner) {
  outliner.move_to(centre + vec2{radii.x, 0.0});
  outliner.arc_to(radii, 0.0, false, true, centre - vec2{radii.x, 0.0});
  outliner.arc_to(radii, 0.0, false, true, centre + vec2{radii.x, 0.0});
  outliner.close();
}

// SVG 1.1, 9.2: a missing radius is as the other one, and neither is more than half the side.
void outline_rect(const pugi::xml_node& node, Outliner& outliner) {
  const vec2 low{length_or(node, "x", 0.0), length_or(node, "y", 0.0)};
  const vec2 size{length_or(node, "width", 0.0), length_or(node, "height", 0.0)};
  if (size.x <= 0.0 || size.y <= 0.0) return;
  const double rx = length_or(node, "rx", length_or(node, "ry", 0.0));
  const double ry = length_or(node, "ry", rx);
  const vec2 r{std::clamp(rx, 0.0, 0.5 * size.x), std::clamp(ry, 0.0, 0.5 * size.y)};
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

void outline_element(const pugi::xml_node& node, std::string_view name, Outliner& outliner) {
  if (name == "path") return follow_path(node.attribute("d").value(), outliner);
  if (name == "polygon" || name == "polyline") return outline_points(node, name == "polygon", outliner);
  if (name == "rect") return outline_rect(node, outliner);
  const vec2 centre{length_or(node, "cx", 0.0), length_or(node, "cy", 0.0)};
  const double r = length_or(node, "r", 0.0);
  const vec2 radii = name == "circle" ? vec2{r, r} : vec2{length_or(node, "rx", 0.0), length_or(node, "ry", 0.0)};
  if (radii.x > 0.0 && radii.y > 0.0) outline_ellipse(centre, radii, outliner);
}

class ShapeSearch {
 public:
  ShapeSearch(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void visit(const pugi::xml_node& node, const Inherited& from_parent, int depth) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element || property(child, "display") == "none") continue;
      const std::string_view name = local_name(child);
      const bool group = name == "g" || name == "a";
      if (!group && std::ranges::find(shape_names, name) == shape_names.end()) continue;
      try {
        const Inherited inherited = handed_on(child, from_parent);
        if (!group) {
          add(child, name, inherited);
        } else if (depth == deepest_groups) {
          throw SvgError(fmt::format("at most {} groups in groups, got more", deepest_groups));
        } else {
          visit(child, inherited, depth + 1);
        }
      } catch (const SvgError& error) {
        throw InputError(place_of(child), fmt::format("expected {}", error.what()));
      }
    }
  }

  Place place_of(const pugi::xml_node& node) const {
    const TextPosition position =
        text_position(text_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
    const std::string id = node.attribute("id").value();
    const std::string name(local_name(node));
    return {file_, position.line, position.column, id.empty() ? name : fmt::format("{}#{}", name, id)};
  }

  std::vector<ClosedShape>& found() { return found_; }

 private:
  static constexpr std::array<std::string_view, 6> shape_names = {"path", "polygon", "polyline", "rect", "circle", "ellipse"};

  static Inherited handed_on(const pugi::xml_node& node, const Inherited& from_parent) {
    Inherited inherited = from_parent;
    if (const auto transform = node.attribute("transform"))
      inherited.to_mm = from_parent.to_mm.after(transform_of(transform.value()));
    const std::string_view rule = property(node, "fill-rule");
    if (rule == "evenodd") inherited.fill_rule = FillRule::evenodd;
    if (rule == "nonzero") inherited.fill_rule = FillRule::nonzero;
    return inherited;
  }

  void add(const pugi::xml_node& node, std::string_view name, const Inherited& inherited) {
    Outliner outliner(inherited.to_mm, svg_tolerance_mm);
    outline_element(node, name, outliner);
    ClosedShape shape{node, inherited.fill_rule, {}};
    for (const Subpath& subpath : outliner.subpaths()) {
      const bool returns = subpath.points.size() > 2 && subpath.points.front() == subpath.points.back();
      if (subpath.closed || returns) shape.rings.push_back(subpath.points);
    }
    if (shape.rings.empty()) return;
    for (const geometry::Polygon& ring : shape.rings) points_ += ring.size();
    if (points_ > most_vertices) throw SvgError(fmt::format("at most {} points in all, got more", most_vertices));
    if (found_.size() == most_shapes) throw SvgError(fmt::format("at most {} shapes, got more", most_shapes));
    found_.push_back(std::move(shape));
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t points_ = 0;
  std::vector<ClosedShape> found_;
};

std::optional<std::array<double, 4>> view_box(const pugi::xml_node& svg) {
  const pugi::xml_attribute attribute = svg.attribute("viewBox");
  if (!attribute) return std::nullopt;
  SvgNumbers numbers(attribute.value());
  std::array<double, 4> box{};
  for (double& value : box) value = numbers.number();
  if (!numbers.at_end() || box[2] <= 0.0 || box[3] <= 0.0) throw SvgError("a viewBox of x y width height, got another");
  return box;
}

// A length of the page; nothing where it is missing or relative to a screen.
std::optional<double> page_length(const pugi::xml_node& svg, const char* name) {
  const std::string_view text = svg.attribute(name).value();
  if (text.empty() || text == "auto" || text.ends_with('%')) return std::nullopt;
  const double length = px_of(text);
  if (length <= 0.0) throw SvgError(fmt::format("a {} above 0, got {}", name, in_quotes(text)));
  return length;
}

// From user units of the root to mm, y up. Without width and height a user unit is a px; a viewBox is fitted into the page as
// preserveAspectRatio="xMidYMid meet" does, which is the default.
Affine page_to_mm(const pugi::xml_node& svg) {
  const auto box = view_box(svg);
  auto width = page_length(svg, "width");
  auto height = page_length(svg, "height");
  Affine to_px;
  if (box) {
    if (!width && !height) width = (*box)[2];
    if (!width) width = *height * (*box)[2] / (*box)[3];
    if (!height) height = *width * (*box)[3] / (*box)[2];
    const double scale = std::min(*width / (*box)[2], *height / (*box)[3]);
    const vec2 spare = 0.5 * (vec2{*width, *height} - scale * vec2{(*box)[2], (*box)[3]});
    to_px = {scale, 0, 0, scale, spare.x - scale * (*box)[0], spare.y - scale * (*box)[1]};
  }
  return Affine{mm_per_px, 0, 0, -mm_per_px, 0, mm_per_px * height.value_or(0.0)}.after(to_px);
}

// The largest ring is the outline; the others are holes, unless the rule "nonzero" fills them: they turn the same way.
geometry::Region region_of_shape(const ClosedShape& shape, const Place& place) {
  const auto larger = [](const geometry::Polygon& a, const geometry::Polygon& b) {
    return std::abs(geometry::area(a)) < std::abs(geometry::area(b));
  };
  const auto outline = std::ranges::max_element(shape.rings, larger);
  const bool turns_left = geometry::area(*outline) > 0.0;
  std::vector<Ring> holes;
  for (const geometry::Polygon& ring : shape.rings) {
    if (&ring == &*outline) continue;
    const bool filled = shape.fill_rule == FillRule::nonzero && (geometry::area(ring) > 0.0) == turns_left;
    if (!filled || !geometry::contains(*outline, ring.front())) holes.push_back({ring, place});
  }
  return region_of({*outline, place}, holes);
}

}  // namespace

geometry::Region outline_of_svg(std::string_view text, const std::string& file, const OutlineChoice& choice) {
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const TextPosition position = text_position(text, static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)));
    throw InputError(Place{file, position.line, position.column, ""},
                     fmt::format("expected XML, got an error: {}", result.description()));
  }
  const pugi::xml_node svg = document.document_element();
  if (local_name(svg) != "svg")
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected an <svg>, got {}", in_quotes(local_name(svg))));
  ShapeSearch search(text, file);
  try {
    search.visit(svg, {page_to_mm(svg), FillRule::nonzero}, 0);
  } catch (const SvgError& error) {
    throw InputError(search.place_of(svg), fmt::format("expected {}", error.what()));
  }
  std::vector<std::string> ids;
  for (const ClosedShape& shape : search.found()) ids.emplace_back(shape.node.attribute("id").value());
  const ClosedShape& shape = search.found()[chosen_shape(ids, "closed shape", choice, file)];
  return region_of_shape(shape, search.place_of(shape.node));
}

}  // namespace shatterpave::scene
