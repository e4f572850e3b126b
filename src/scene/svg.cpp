// SVG is read by pugixml, which loads no external entity and expands none of a document type.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>

#include "geometry/lattice.h"
#include "scene/input_file.h"
#include "scene/plan.h"
#include "scene/svg_path.h"

namespace shatterpave::scene {

namespace {

constexpr int deepest_groups = 100;
constexpr std::size_t most_shapes = 100'000;
// Elements that are visited: `use` of groups with `use` in them could be any number.
constexpr std::size_t most_elements = 1'000'000;
constexpr double mm_per_px = 25.4 / 96.0;

// What an element hands on to those inside it.
struct Inherited {
  Affine to_mm;
  vec2 viewport{0.0, 0.0};  // in user units, for percentages
  FillRule fill_rule = FillRule::nonzero;
  bool visible = true;
  bool copied = false;  // by `use`: ids are those of the original
  std::optional<std::size_t> group;
  int depth = 0;
};

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view spaces = " \t\n\r\f";
  const std::size_t first = std::min(text.find_first_not_of(spaces), text.size());
  return text.substr(first, text.find_last_not_of(spaces) + 1 - first);
}

// A property of `style`; empty if it is not there.
std::string_view style_property(const pugi::xml_node& node, std::string_view wanted) {
  const std::string_view style = node.attribute("style").value();
  for (std::size_t at = 0; at < style.size();) {
    const std::size_t end = std::min(style.find(';', at), style.size());
    const std::string_view declaration = style.substr(at, end - at);
    at = end + 1;
    const std::size_t colon = declaration.find(':');
    if (colon != std::string_view::npos && trimmed(declaration.substr(0, colon)) == wanted)
      return trimmed(declaration.substr(colon + 1));
  }
  return {};
}

// An attribute, or the property of the same name in `style`, which wins.
std::string_view property(const pugi::xml_node& node, const char* name) {
  const std::string_view style = style_property(node, name);
  return style.empty() ? trimmed(node.attribute(name).value()) : style;
}

// An element's attributes as lengths in user units; percentages are of the viewport (SVG 1.1, 7.10).
class Lengths {
 public:
  Lengths(const pugi::xml_node& node, vec2 viewport) : node_(node), viewport_(viewport) {}

  double x(const char* name, double otherwise = 0.0) const { return length(name, viewport_.x, otherwise); }
  double y(const char* name, double otherwise = 0.0) const { return length(name, viewport_.y, otherwise); }
  double along(const char* name) const { return length(name, glm::length(viewport_) / std::sqrt(2.0), 0.0); }
  // A radius that may be "auto", which is as none.
  std::optional<double> radius(const char* name, double whole) const {
    const std::string_view text = property(node_, name);
    if (text.empty() || text == "auto") return std::nullopt;
    return length(name, whole, 0.0);
  }
  vec2 viewport() const { return viewport_; }

 private:
  double length(const char* name, double whole, double otherwise) const {
    const std::string_view text = property(node_, name);
    if (text.empty() || text == "auto") return otherwise;
    if (!text.ends_with('%')) return px_of(text);
    // Of a page without a size, which a browser would make as large as its window.
    if (whole <= 0.0) throw SvgError(fmt::format("a viewBox, or a size of the page, beside {}, got none", in_quotes(text)));
    return px_of(text.substr(0, text.size() - 1)) / 100.0 * whole;
  }

  const pugi::xml_node& node_;
  vec2 viewport_;
};

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

void outline_element(const pugi::xml_node& node, std::string_view name, const Lengths& lengths, Outliner& outliner) {
  if (name == "path") return follow_path(node.attribute("d").value(), outliner);
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

struct ViewBox {
  vec2 low{0.0, 0.0};
  vec2 size{0.0, 0.0};
};

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

// A length of the page; nothing where it is missing or relative to a screen.
std::optional<double> page_length(const pugi::xml_node& svg, const char* name) {
  const std::string_view text = svg.attribute(name).value();
  if (text.empty() || text == "auto" || text.ends_with('%')) return std::nullopt;
  const double length = px_of(text);
  if (length <= 0.0) throw SvgError(fmt::format("a {} above 0, got {}", name, in_quotes(text)));
  return length;
}

// What the root hands on: from its user units to mm times `scale`, y up. Without width and height a user unit is a px.
Inherited page(const pugi::xml_node& svg, double scale) {
  Inherited inherited;
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
  inherited.to_mm = Affine{mm, 0, 0, -mm, 0, mm * height.value_or(0.0)}.after(to_px);
  inherited.viewport = box ? box->size : vec2{width.value_or(0.0), height.value_or(0.0)};
  return inherited;
}

class ShapeReader {
 public:
  ShapeReader(std::string_view text, Plan& plan) : index_(text), plan_(plan) {}

  void read(const pugi::xml_node& svg, double scale) {
    try {
      root_ = svg;
      visit_children(svg, page(svg, scale));
    } catch (const SvgError& error) {
      throw InputError(place_of(svg), fmt::format("expected {}", error.what()));
    }
  }

 private:
  static constexpr std::array<std::string_view, 7> shape_names = {"path",   "polygon", "polyline", "rect",
                                                                  "circle", "ellipse", "line"};
  static constexpr std::array<std::string_view, 5> group_names = {"g", "a", "svg", "switch", "use"};

  static bool is_known(const pugi::xml_node& node) {
    const std::string_view name = local_name(node);
    return node.type() == pugi::node_element && (std::ranges::find(shape_names, name) != shape_names.end() ||
                                                 std::ranges::find(group_names, name) != group_names.end());
  }

  Place place_of(const pugi::xml_node& node) const {
    const TextPosition position = index_.position(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
    const std::string id = node.attribute("id").value();
    const std::string name(local_name(node));
    return {plan_.file, position.line, position.column, id.empty() ? name : fmt::format("{}#{}", name, id)};
  }

  void visit_children(const pugi::xml_node& node, const Inherited& inherited) {
    for (const pugi::xml_node& child : node.children()) visit(child, inherited);
  }

  // What SVG draws of a `switch`: the first child that asks for nothing special.
  void visit_first(const pugi::xml_node& node, const Inherited& inherited) {
    for (const pugi::xml_node& child : node.children()) {
      if (!is_known(child) || child.attribute("requiredExtensions") || child.attribute("systemLanguage")) continue;
      return visit(child, inherited);
    }
  }

  void visit(const pugi::xml_node& node, const Inherited& from_parent) {
    if (!is_known(node) || property(node, "display") == "none") return;
    try {
      if (++visited_ > most_elements) throw SvgError(fmt::format("at most {} elements, got more", most_elements));
      const Inherited inherited = handed_on(node, from_parent);
      const std::string_view name = local_name(node);
      if (std::ranges::find(shape_names, name) != shape_names.end()) return add(node, name, inherited);
      if (inherited.depth > deepest_groups) {
        throw SvgError(fmt::format("at most {} groups in groups, got more", deepest_groups));
      }
      if (name == "use") return visit_used(node, inherited);
      if (name == "switch") return visit_first(node, inherited);
      visit_children(node, name == "svg" ? in_viewport(node, node, inherited) : inherited);
    } catch (const SvgError& error) {
      throw InputError(place_of(node), fmt::format("expected {}", error.what()));
    }
  }

  Inherited handed_on(const pugi::xml_node& node, const Inherited& from_parent) {
    Inherited inherited = from_parent;
    const std::string_view css = style_property(node, "transform");
    const std::string_view transform = css.empty() ? node.attribute("transform").value() : css;
    if (!transform.empty() && transform != "none") {
      for (const char* name : {"transform-origin", "transform-box"}) {
        const std::string_view value = property(node, name);
        if (!value.empty() && value != "0 0" && value != "view-box")
          throw SvgError(fmt::format("no {} beside a transform, got {}", name, in_quotes(value)));
      }
      inherited.to_mm = from_parent.to_mm.after(transform_of(transform));
    }
    const std::string_view rule = property(node, "fill-rule");
    if (rule == "evenodd") inherited.fill_rule = FillRule::evenodd;
    if (rule == "nonzero") inherited.fill_rule = FillRule::nonzero;
    const std::string_view visibility = property(node, "visibility");
    if (!visibility.empty() && visibility != "inherit") inherited.visible = visibility == "visible";
    inherited.group = plan_.features.size();
    plan_.features.push_back(feature_of(node, from_parent));
    ++inherited.depth;
    return inherited;
  }

  static PlanFeature feature_of(const pugi::xml_node& node, const Inherited& from_parent) {
    PlanFeature feature;
    feature.group = from_parent.group;
    feature.classes = words_of(node.attribute("class").value());
    if (from_parent.copied) return feature;
    for (const char* name : {"id", "inkscape:label", "data-name"}) {
      const std::string value = node.attribute(name).value();
      if (!value.empty() && std::ranges::find(feature.ids, value) == feature.ids.end()) feature.ids.push_back(value);
    }
    return feature;
  }

  // The viewport that `node` opens; its sizes may be given by the `use` that refers to it.
  static Inherited in_viewport(const pugi::xml_node& node, const pugi::xml_node& sized_by, const Inherited& from_parent) {
    Inherited inherited = from_parent;
    const Lengths own(node, from_parent.viewport);
    const Lengths sized(sized_by, from_parent.viewport);
    const vec2 size{sized.x("width", own.x("width", from_parent.viewport.x)),
                    sized.y("height", own.y("height", from_parent.viewport.y))};
    const auto box = view_box(node);
    const bool is_svg = local_name(node) == "svg";
    Affine placed{1, 0, 0, 1, is_svg ? own.x("x") : 0.0, is_svg ? own.y("y") : 0.0};
    if (box && size.x > 0.0 && size.y > 0.0) {
      placed = placed.after(fitted(*box, size, node.attribute("preserveAspectRatio").value()));
    }
    inherited.to_mm = from_parent.to_mm.after(placed);
    inherited.viewport = box ? box->size : size;
    return inherited;
  }

  void visit_used(const pugi::xml_node& use, const Inherited& from_parent) {
    const pugi::xml_attribute plain = use.attribute("href");
    const std::string_view link = plain ? plain.value() : use.attribute("xlink:href").value();
    if (link.empty()) return;
    if (link.front() != '#') throw SvgError(fmt::format("a reference to an id of this file, got {}", in_quotes(link)));
    const auto target = nodes_by_id().find(link.substr(1));
    if (target == nodes_by_id().end())
      throw SvgError(fmt::format("a reference to an id of this file, got {}", in_quotes(link)));
    Inherited inherited = from_parent;
    const Lengths lengths(use, from_parent.viewport);
    inherited.to_mm = from_parent.to_mm.after({1, 0, 0, 1, lengths.x("x"), lengths.y("y")});
    inherited.copied = true;
    const pugi::xml_node& node = target->second;
    if (local_name(node) != "symbol") return visit(node, inherited);
    visit_children(node, in_viewport(node, use, handed_on(node, inherited)));
  }

  const std::map<std::string_view, pugi::xml_node>& nodes_by_id() {
    if (!nodes_by_id_.empty()) return nodes_by_id_;
    nodes_by_id_.emplace();
    for (pugi::xml_node node = root_; node;) {
      if (const pugi::xml_attribute id = node.attribute("id")) nodes_by_id_.emplace(id.value(), node);
      if (node.first_child()) {
        node = node.first_child();
        continue;
      }
      while (node && node != root_ && !node.next_sibling()) node = node.parent();
      node = node == root_ ? pugi::xml_node() : node.next_sibling();
    }
    return nodes_by_id_;
  }

  void add(const pugi::xml_node& node, std::string_view name, const Inherited& inherited) {
    if (!inherited.visible) return;
    Outliner outliner(inherited.to_mm, svg_tolerance_mm);
    outline_element(node, name, Lengths(node, inherited.viewport), outliner);
    if (outliner.subpaths().empty()) return;
    const Place place = place_of(node);
    PlanShape area{ShapeKind::area, {}, inherited.fill_rule, *inherited.group};
    for (const Subpath& subpath : outliner.subpaths()) {
      points_ += subpath.points.size();
      if (points_ > most_vertices) throw SvgError(fmt::format("at most {} points in all, got more", most_vertices));
      const bool returns = subpath.points.size() > 2 &&
                           geometry::on_lattice(subpath.points.front()) == geometry::on_lattice(subpath.points.back());
      if (subpath.closed || returns) {
        area.rings.push_back({subpath.points, place});
      } else if (subpath.points.size() > 1) {
        keep({ShapeKind::line, {{subpath.points, place}}, std::nullopt, *inherited.group});
      }
    }
    if (!area.rings.empty()) keep(std::move(area));
  }

  void keep(PlanShape shape) {
    if (plan_.shapes.size() == most_shapes) throw SvgError(fmt::format("at most {} shapes, got more", most_shapes));
    plan_.shapes.push_back(std::move(shape));
  }

  TextIndex index_;
  Plan& plan_;
  pugi::xml_node root_;
  std::map<std::string_view, pugi::xml_node> nodes_by_id_;
  std::size_t visited_ = 0;
  std::size_t points_ = 0;
};

}  // namespace

Plan plan_of_svg(std::string_view text, const std::string& file, double scale) {
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
  Plan plan;
  plan.file = file;
  plan.svg = true;
  ShapeReader(text, plan).read(svg, scale);
  return plan;
}

}  // namespace shatterpave::scene
