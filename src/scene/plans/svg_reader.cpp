#include "scene/plans/svg_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/lattice.h"
#include "scene/plans/svg_css.h"

namespace shatterpave::scene {

namespace {

constexpr int deepest_groups = 100;
// Elements that are visited: `use` of groups with `use` in them could be any number.
constexpr std::size_t most_elements = 1'000'000;

bool is_group_name(std::string_view name) {
  constexpr std::array<std::string_view, 5> names = {"g", "a", "svg", "switch", "use"};
  return std::ranges::find(names, name) != names.end();
}

// Elements that are drawn but are no shapes.
bool is_unread_name(std::string_view name) {
  constexpr std::array<std::string_view, 4> names = {"text", "image", "foreignObject", "flowRoot"};
  return std::ranges::find(names, name) != names.end();
}

bool is_drawn(const pugi::xml_node& node) {
  const std::string_view name = local_name(node);
  return node.type() == pugi::node_element && (is_shape_name(name) || is_group_name(name) || is_unread_name(name));
}

PlanFeature feature_of(const pugi::xml_node& node, const SvgInherited& from_parent) {
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

// How the subpaths of an element end.
enum class Ending { closed, nearly, open };

Ending ending_of(const Subpath& subpath, double tolerance_mm) {
  const std::vector<vec2>& points = subpath.points;
  const bool returns = points.size() > 2 && geometry::on_lattice(points.front()) == geometry::on_lattice(points.back());
  if (subpath.closed || returns) return Ending::closed;
  const double gap = glm::distance(points.front(), points.back());
  if (points.size() < 4 || gap > tolerance_mm) return Ending::open;
  // A wider gap, in a line no longer than this, may be meant.
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += glm::distance(points[i], points[i + 1]);
  return gap <= 0.01 * length ? Ending::nearly : Ending::open;
}

}  // namespace

SvgReader::SvgReader(std::string_view text, double scale, Plan& plan)
    : index_(text),
      scale_(scale),
      plan_(plan),
      property_of_([this](const pugi::xml_node& node, const char* property) { return value(node, property); }) {}

void SvgReader::read(const pugi::xml_node& svg) {
  root_ = svg;
  try {
    read_styles(svg);
    if (is_hidden(svg) || is_transparent(svg)) return;
    const Affine transform = transform_of_element(svg).value_or(Affine{});
    const SvgPage page = page_of(svg, scale_, transform);
    SvgInherited inherited;
    inherited.to_mm = page.to_mm;
    inherited.viewport = page.viewport;
    take_styles(svg, inherited);
    visit_children(svg, inherited);
    limit_shapes(svg, page.outer_to_mm, page.viewport, {});
  } catch (const SvgError& error) {
    throw InputError(place_of(svg), fmt::format("expected {}", error.what()));
  }
  join_lines(pieces_, join_tolerance_mm(scale_), plan_);
}

Place SvgReader::place_of(const pugi::xml_node& node) const {
  const TextPosition position = index_.position(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  const std::string id = node.attribute("id").value();
  const std::string name(local_name(node));
  return {plan_.file, position.line, position.column, id.empty() ? name : fmt::format("{}#{}", name, id)};
}

void SvgReader::read_styles(const pugi::xml_node& svg) {
  for (pugi::xml_node node = svg; node;) {
    if (node.type() == pugi::node_element && local_name(node) == "style") add_style(node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != svg && !node.next_sibling()) node = node.parent();
    node = node == svg ? pugi::xml_node() : node.next_sibling();
  }
}

void SvgReader::add_style(const pugi::xml_node& style) {
  const std::string type = lower_case(trimmed(style.attribute("type").value()));
  const auto applies = css_media_apply(style.attribute("media").value());
  std::string css;
  for (const pugi::xml_node& child : style.children()) css += child.value();
  try {
    if (!applies) throw SvgError("a style sheet that does not depend on the screen, got one that does");
    if ((type.empty() || type == "text/css") && *applies && styles_.add(css)) {
      add_note({place_of(style), "the style sheet that @import names is not loaded"}, plan_.notes);
    }
  } catch (const SvgError& error) {
    throw InputError(place_of(style), fmt::format("expected {}", error.what()));
  }
}

void SvgReader::visit_children(const pugi::xml_node& node, const SvgInherited& inherited) {
  for (const pugi::xml_node& child : node.children()) visit(child, inherited);
}

// What SVG draws of a `switch`: the first child that asks for nothing special.
void SvgReader::visit_first(const pugi::xml_node& node, const SvgInherited& inherited) {
  for (const pugi::xml_node& child : node.children()) {
    if (!is_drawn(child) || child.attribute("requiredExtensions") || child.attribute("systemLanguage")) continue;
    return visit(child, inherited);
  }
}

bool SvgReader::is_transparent(const pugi::xml_node& node) const {
  const std::string_view opacity = value(node, "opacity");
  if (opacity.empty()) return false;
  SvgNumbers numbers(opacity);
  return numbers.at_number() && numbers.number() <= 0.0;
}

void SvgReader::visit(const pugi::xml_node& node, const SvgInherited& from_parent, const pugi::xml_node& sized_by) {
  if (!is_drawn(node)) return;
  try {
    if (is_hidden(node)) return;
    if (++visited_ > most_elements) throw SvgError(fmt::format("at most {} elements, got more", most_elements));
    if (is_unread_name(local_name(node))) return add_unread(node, from_parent);
    const SvgInherited inherited = handed_on(node, from_parent);
    const Begin first = begin();
    visit_within(node, inherited, sized_by);
    limit_shapes(node, inherited.to_mm, inherited.viewport, first);
  } catch (const SvgError& error) {
    throw InputError(place_of(node), fmt::format("expected {}", error.what()));
  }
}

void SvgReader::visit_within(const pugi::xml_node& node, const SvgInherited& inherited, const pugi::xml_node& sized_by) {
  const std::string_view name = local_name(node);
  if (is_shape_name(name)) return add(node, name, inherited);
  if (inherited.depth > deepest_groups) throw SvgError(fmt::format("at most {} groups in groups, got more", deepest_groups));
  if (name == "use") return visit_used(node, inherited);
  if (name == "switch") return visit_first(node, inherited);
  if (name == "svg") return visit_viewport(node, inherited, sized_by ? sized_by : node);
  visit_children(node, inherited);
}

void SvgReader::take_styles(const pugi::xml_node& node, SvgInherited& inherited) const {
  const auto take_rule = [&](const char* property, FillRule& rule) {
    const std::string_view text = value(node, property);
    if (text == "evenodd") rule = FillRule::evenodd;
    if (text == "nonzero" || text == "initial") rule = FillRule::nonzero;
  };
  take_rule("fill-rule", inherited.fill_rule);
  take_rule("clip-rule", inherited.clip_rule);
  const std::string_view visibility = value(node, "visibility");
  if (!visibility.empty() && visibility != "inherit" && visibility != "unset") {
    inherited.visible = visibility == "visible" || visibility == "initial";
  }
  if (is_transparent(node)) inherited.transparent = true;
  const std::string_view fill = value(node, "fill");
  if (!fill.empty() && fill != "inherit" && fill != "unset") {
    inherited.fill = fill == "none" ? SvgInherited::Fill::none : SvgInherited::Fill::painted;
  }
}

std::optional<Affine> SvgReader::transform_of_element(const pugi::xml_node& node) const {
  for (const char* name : {"translate", "rotate", "scale"}) {
    // Of CSS only; attributes of these names belong to text.
    const std::string_view text = node.attribute(name) ? std::string_view() : value(node, name);
    if (!text.empty() && text != "none") throw SvgError(fmt::format("transforms by `transform`, got {}", name));
  }
  const std::string transform(value(node, "transform"));
  if (transform.empty() || transform == "none") return std::nullopt;
  for (const char* name : {"transform-origin", "transform-box"}) {
    const std::string_view text = value(node, name);
    if (!text.empty() && text != "0 0" && text != "view-box")
      throw SvgError(fmt::format("no {} beside a transform, got {}", name, in_quotes(text)));
  }
  return transform_of(transform);
}

SvgInherited SvgReader::handed_on(const pugi::xml_node& node, const SvgInherited& from_parent) {
  SvgInherited inherited = from_parent;
  if (const auto transform = transform_of_element(node)) inherited.to_mm = from_parent.to_mm.after(*transform);
  take_styles(node, inherited);
  inherited.group = plan_.features.size();
  plan_.features.push_back(feature_of(node, from_parent));
  ++inherited.depth;
  return inherited;
}

// The viewport that `node` opens, which cuts off what lies outside unless `overflow` says otherwise.
void SvgReader::visit_viewport(const pugi::xml_node& node, const SvgInherited& from_parent, const pugi::xml_node& sized_by) {
  SvgInherited inherited = from_parent;
  const Lengths own = lengths_of(node, from_parent.viewport);
  const Lengths sized = lengths_of(sized_by, from_parent.viewport);
  const vec2 size{sized.x("width", own.x("width", from_parent.viewport.x)),
                  sized.y("height", own.y("height", from_parent.viewport.y))};
  const bool is_svg = local_name(node) == "svg";
  const vec2 low{is_svg ? own.x("x") : 0.0, is_svg ? own.y("y") : 0.0};
  const auto box = view_box(node);
  Affine placed{1, 0, 0, 1, low.x, low.y};
  // A page without a size has none to give.
  const bool has_size = size.x > 0.0 && size.y > 0.0;
  const bool is_given = !value(sized_by, "width").empty() || !value(sized_by, "height").empty();
  if (!has_size && is_given) return;
  if (box && has_size) placed = placed.after(fitted(*box, size, node.attribute("preserveAspectRatio").value()));
  inherited.to_mm = from_parent.to_mm.after(placed);
  inherited.viewport = box ? box->size : size;
  const std::size_t first = plan_.shapes.size();
  visit_children(node, inherited);
  const std::string_view overflow = value(node, "overflow");
  if (!has_size || overflow == "visible" || overflow == "auto" || overflow == "initial" || plan_.shapes.size() == first) return;
  const Affine& to_mm = from_parent.to_mm;
  const Ring viewport{{to_mm(low), to_mm({low.x + size.x, low.y}), to_mm(low + size), to_mm({low.x, low.y + size.y})},
                      place_of(node)};
  clip_shapes(drawn_regions({viewport}, FillRule::nonzero), first);
}

pugi::xml_node SvgReader::referred(const pugi::xml_node& use) {
  const pugi::xml_attribute plain = use.attribute("href");
  const std::string_view link = plain ? plain.value() : use.attribute("xlink:href").value();
  if (link.empty()) return {};
  const auto target = link.front() == '#' ? nodes_by_id().find(link.substr(1)) : nodes_by_id().end();
  if (target == nodes_by_id().end()) throw SvgError(fmt::format("a reference to an id of this file, got {}", in_quotes(link)));
  return target->second;
}

void SvgReader::visit_used(const pugi::xml_node& use, const SvgInherited& from_parent) {
  const pugi::xml_node node = referred(use);
  if (!node) return;
  SvgInherited inherited = from_parent;
  const Lengths lengths = lengths_of(use, from_parent.viewport);
  inherited.to_mm = from_parent.to_mm.after({1, 0, 0, 1, lengths.x("x"), lengths.y("y")});
  inherited.copied = true;
  if (local_name(node) != "symbol") return visit(node, inherited, use);
  if (is_hidden(node)) return;
  const Begin first = begin();
  const SvgInherited within = handed_on(node, inherited);
  visit_viewport(node, within, use);
  limit_shapes(node, within.to_mm, within.viewport, first);
}

const std::map<std::string_view, pugi::xml_node>& SvgReader::nodes_by_id() {
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

void SvgReader::add(const pugi::xml_node& node, std::string_view name, const SvgInherited& inherited) {
  Outliner outliner(inherited.to_mm, svg_tolerance_mm);
  outline_element(node, name, lengths_of(node, inherited.viewport), outliner);
  for (const Subpath& subpath : outliner.subpaths()) points_ += subpath.points.size();
  if (points_ > most_vertices) throw SvgError(fmt::format("at most {} points in all, got more", most_vertices));
  if (!inherited.visible || inherited.transparent) return add_hidden(outliner.subpaths());
  if (!outliner.subpaths().empty()) add_areas(outliner.subpaths(), place_of(node), inherited);
}

void SvgReader::add_hidden(const std::vector<Subpath>& subpaths) {
  PlanShape shape;
  for (const Subpath& subpath : subpaths) shape.rings.push_back({subpath.points, {}});
  hidden_.push_back(std::move(shape));
}

// Keeps those subpaths that do not end where they start as lines, and adds to the rings of the areas. Returns the shapes of the
// lines whose ends are apart; nothing where all subpaths are closed.
std::optional<std::vector<std::size_t>> SvgReader::add_lines(const std::vector<Subpath>& subpaths, const Place& place,
                                                             const SvgInherited& inherited, PlanShape& closed,
                                                             PlanShape& filled) {
  const double tolerance = join_tolerance_mm(scale_);
  std::vector<std::size_t> lines;
  bool all_closed = true;
  for (const Subpath& subpath : subpaths) {
    if (subpath.points.size() < 2) continue;
    Ring ring{subpath.points, place};
    const Ending ending = ending_of(subpath, tolerance);
    if (ending != Ending::closed) {
      all_closed = false;
      PlanShape line{.kind = ShapeKind::line, .rings = {ring}, .feature = *inherited.group};
      if (ending == Ending::nearly) line.asked_for = AskedFor::lines_alone;
      const std::size_t shape = keep(std::move(line));
      if (ending == Ending::open) lines.push_back(shape);
    }
    if (ending == Ending::nearly) ring.points_mm.pop_back();
    if (ending != Ending::open) closed.rings.push_back(ring);
    if (ending != Ending::open || inherited.fill != SvgInherited::Fill::none) filled.rings.push_back(std::move(ring));
  }
  return all_closed ? std::nullopt : std::optional(std::move(lines));
}

void SvgReader::add_areas(const std::vector<Subpath>& subpaths, const Place& place, const SvgInherited& inherited) {
  const std::size_t feature = *inherited.group;
  PlanShape closed{.kind = ShapeKind::area, .filling = inherited.fill_rule, .feature = feature};
  PlanShape filled = closed;
  filled.asked_for = AskedFor::areas_alone;
  const auto lines = add_lines(subpaths, place, inherited, closed, filled);
  if (!lines) {
    if (!closed.rings.empty()) keep(std::move(closed));
    return;
  }
  std::optional<std::size_t> area;
  filled.open = closed.rings.empty();
  if (std::ranges::any_of(filled.rings, has_area)) area = keep(std::move(filled));
  closed.asked_for = AskedFor::areas_beside_lines;
  const bool is_open = closed.rings.empty();
  if (!is_open) keep(std::move(closed));
  if (inherited.fill == SvgInherited::Fill::painted) return;
  for (const std::size_t line : *lines) {
    pieces_.push_back({plan_.features[feature].group, line, is_open ? area : std::nullopt});
  }
}

void SvgReader::add_unread(const pugi::xml_node& node, const SvgInherited& from_parent) {
  SvgInherited inherited = from_parent;
  take_styles(node, inherited);
  if (!inherited.visible || inherited.transparent) {
    hidden_.push_back({.kind = ShapeKind::unread});
    return;
  }
  PlanShape shape{.kind = ShapeKind::unread, .feature = plan_.features.size()};
  plan_.features.push_back(feature_of(node, from_parent));
  shape.notes.push_back({place_of(node), fmt::format("<{}> is no shape and is not read", local_name(node))});
  keep(std::move(shape));
}

std::size_t SvgReader::keep(PlanShape shape) {
  if (plan_.shapes.size() == most_shapes) throw SvgError(fmt::format("at most {} shapes, got more", most_shapes));
  plan_.shapes.push_back(std::move(shape));
  return plan_.shapes.size() - 1;
}

}  // namespace shatterpave::scene
