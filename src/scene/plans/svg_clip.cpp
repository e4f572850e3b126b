// Clip paths, masks and filters. A clip path is an area of its own (SVG 1.1, 14.3): the union of its children, each filled by
// its clip-rule, in the user space of the element that it clips.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "scene/plans/plan_areas.h"
#include "scene/plans/svg_css.h"
#include "scene/plans/svg_reader.h"

namespace shatterpave::scene {

namespace {

constexpr int deepest_clips = 20;

bool is_none(std::string_view text) { return text.empty() || text == "none" || text == "initial" || text == "unset"; }

// The points that `to_mm` takes to the given ones; nothing where it takes all to a line.
std::optional<Affine> inverse(const Affine& m) {
  const double determinant = m.a * m.d - m.b * m.c;
  if (determinant == 0.0 || !std::isfinite(1.0 / determinant)) return std::nullopt;
  const Affine turned{m.d / determinant, -m.b / determinant, -m.c / determinant, m.a / determinant, 0.0, 0.0};
  const vec2 moved = turned({m.e, m.f});
  return Affine{turned.a, turned.b, turned.c, turned.d, -moved.x, -moved.y};
}

}  // namespace

void SvgReader::refuse_shapes(const pugi::xml_node& node, const std::string& expected, std::size_t first) {
  const Note note{place_of(node), fmt::format("expected {}", expected)};
  for (std::size_t i = first; i < plan_.shapes.size(); ++i) plan_.shapes[i].unfollowed = note;
}

void SvgReader::clip_shapes(const Regions& clip, std::size_t first) {
  const auto shared = std::make_shared<const Regions>(clip);
  for (std::size_t i = first; i < plan_.shapes.size(); ++i) plan_.shapes[i].clips.push_back(shared);
}

void SvgReader::limit_shapes(const pugi::xml_node& node, const Affine& to_mm, vec2 viewport, Begin begin) {
  const std::size_t first = begin.shapes;
  if (plan_.shapes.size() == first) return;
  if (!is_none(value(node, "mask"))) refuse_shapes(node, "no mask, got one", first);
  if (!is_none(value(node, "filter"))) {
    const Note note{place_of(node), "the filter is not followed"};
    for (std::size_t i = first; i < plan_.shapes.size(); ++i) plan_.shapes[i].notes.push_back(note);
  }
  try {
    if (const auto clip = clip_of(node, to_mm, viewport, begin)) clip_shapes(*clip, first);
  } catch (const SvgError& error) {
    refuse_shapes(node, error.what(), first);
  }
}

pugi::xml_node SvgReader::node_of_url(std::string_view url) {
  std::string_view inner = trimmed(url.substr(4, url.size() - 5));
  if (inner.size() >= 2 && (inner.front() == '"' || inner.front() == '\'')) inner = trimmed(inner.substr(1, inner.size() - 2));
  if (!inner.starts_with('#')) throw SvgError(fmt::format("a clip path of this file, got {}", in_quotes(inner)));
  const auto found = nodes_by_id().find(inner.substr(1));
  return found == nodes_by_id().end() ? pugi::xml_node() : found->second;
}

// Nothing where the element is not clipped.
std::optional<SvgReader::Regions> SvgReader::clip_of(const pugi::xml_node& node, const Affine& to_mm, vec2 viewport,
                                                     Begin first) {
  const std::string_view text = value(node, "clip-path");
  if (is_none(text)) return std::nullopt;
  if (!text.starts_with("url(") || !text.ends_with(')')) {
    throw SvgError(fmt::format("a clip path as url(#id), got {}", in_quotes(text)));
  }
  const pugi::xml_node clip = node_of_url(text);
  // A reference to nothing clips nothing (CSS Masking, 5.1).
  if (!clip || local_name(clip) != "clipPath") {
    const Note note{place_of(node), fmt::format("the clip path {} is not in the file: nothing is clipped", in_quotes(text))};
    for (std::size_t i = first.shapes; i < plan_.shapes.size(); ++i) plan_.shapes[i].notes.push_back(note);
    return std::nullopt;
  }
  const bool by_box = std::string_view(clip.attribute("clipPathUnits").value()) == "objectBoundingBox";
  if (!by_box) return clip_regions(clip, to_mm, viewport, 0);
  return clip_regions(clip, to_mm.after(unit_box(to_mm, first)), {1.0, 1.0}, 0);
}

// Takes the unit square to the box about the shapes from `first` on, drawn or hidden, clipped or not, in the user space that
// `to_mm` starts from (SVG 2, 8.10).
Affine SvgReader::unit_box(const Affine& to_mm, Begin first) const {
  const auto to_user = inverse(to_mm);
  std::optional<geometry::Box> box;
  const auto add = [&](const PlanShape& shape) {
    if (shape.kind == ShapeKind::unread) throw SvgError("a clip path in units of the page about what cannot be read");
    for (const Ring& ring : shape.rings) {
      for (const vec2& mm : ring.points_mm) {
        const vec2 p = to_user ? (*to_user)(mm) : vec2{0.0, 0.0};
        box = box ? geometry::Box{glm::min(box->low, p), glm::max(box->high, p)} : geometry::Box{p, p};
      }
    }
  };
  for (std::size_t i = first.shapes; i < plan_.shapes.size(); ++i) add(plan_.shapes[i]);
  for (std::size_t i = first.hidden; i < hidden_.size(); ++i) add(hidden_[i]);
  if (!box) return {0, 0, 0, 0, 0, 0};
  const vec2 size = box->high - box->low;
  return {size.x, 0, 0, size.y, box->low.x, box->low.y};
}

// The value of a property that children take from their parents, by the document.
std::string_view SvgReader::inherited_value(const pugi::xml_node& node, const char* property) const {
  for (pugi::xml_node at = node; at && at.type() == pugi::node_element; at = at.parent()) {
    const std::string_view text = value(at, property);
    if (!text.empty() && text != "inherit" && text != "unset") return text;
  }
  return {};
}

SvgReader::Regions SvgReader::clip_regions(const pugi::xml_node& clip, const Affine& to_mm, vec2 viewport, int depth) {
  if (depth > deepest_clips) throw SvgError(fmt::format("at most {} clip paths in clip paths, got more", deepest_clips));
  const Affine placed = to_mm.after(transform_of_element(clip).value_or(Affine{}));
  Regions all;
  for (const pugi::xml_node& child : clip.children()) {
    if (child.type() != pugi::node_element) continue;
    if (++visited_ > deepest_clips * std::size_t{50'000}) throw SvgError("fewer elements of clip paths, got too many");
    std::ranges::move(clip_child(child, child, placed, viewport, depth), std::back_inserter(all));
  }
  all = merged(all);
  const std::string own(value(clip, "clip-path"));
  if (is_none(own)) return all;
  const pugi::xml_node outer = own.starts_with("url(") ? node_of_url(own) : pugi::xml_node();
  if (!outer || local_name(outer) != "clipPath") return all;
  return within(all, clip_regions(outer, to_mm, viewport, depth + 1));
}

SvgReader::Regions SvgReader::clip_shape(const pugi::xml_node& shape, const pugi::xml_node& ruled_by, const Affine& to_mm,
                                         vec2 viewport) {
  Outliner outliner(to_mm, svg_tolerance_mm);
  outline_element(shape, local_name(shape), lengths_of(shape, viewport), outliner);
  std::vector<Ring> rings;
  for (const Subpath& subpath : outliner.subpaths()) {
    points_ += subpath.points.size();
    rings.push_back({subpath.points, place_of(shape)});
  }
  if (points_ > most_vertices) throw SvgError(fmt::format("at most {} points in all, got more", most_vertices));
  std::string_view rule = value(shape, "clip-rule");
  if (rule.empty()) rule = inherited_value(ruled_by, "clip-rule");
  return drawn_regions(rings, rule == "evenodd" ? FillRule::evenodd : FillRule::nonzero);
}

SvgReader::Regions SvgReader::clip_child(const pugi::xml_node& child, const pugi::xml_node& ruled_by, const Affine& to_mm,
                                         vec2 viewport, int depth) {
  const std::string_view name = local_name(child);
  if (value(child, "display") == "none") return {};
  const std::string_view visibility = inherited_value(child, "visibility");
  if (visibility == "hidden" || visibility == "collapse") return {};
  if (name == "text") throw SvgError("a clip path without text, got one with it");
  Affine placed = to_mm.after(transform_of_element(child).value_or(Affine{}));
  Regions regions;
  if (name == "use") {
    const pugi::xml_node target = referred(child);
    const std::string_view what = target ? local_name(target) : std::string_view();
    if (!is_shape_name(what) && what != "text") return {};
    const Lengths lengths = lengths_of(child, viewport);
    placed = placed.after({1, 0, 0, 1, lengths.x("x"), lengths.y("y")});
    regions = clip_child(target, child, placed, viewport, depth);
  } else if (is_shape_name(name)) {
    regions = clip_shape(child, ruled_by, placed, viewport);
  }
  return clipped_child(child, std::move(regions), placed, viewport, depth);
}

// What the clip path of a child of a clip path leaves of it.
SvgReader::Regions SvgReader::clipped_child(const pugi::xml_node& child, Regions regions, const Affine& to_mm, vec2 viewport,
                                            int depth) {
  const std::string own(value(child, "clip-path"));
  if (regions.empty() || is_none(own)) return regions;
  const pugi::xml_node inner = own.starts_with("url(") ? node_of_url(own) : pugi::xml_node();
  if (!inner || local_name(inner) != "clipPath") return regions;
  if (std::string_view(inner.attribute("clipPathUnits").value()) == "objectBoundingBox") {
    throw SvgError("a clip path in user units on parts of a clip path, got one in units of their box");
  }
  return within(regions, clip_regions(inner, to_mm, viewport, depth + 1));
}

}  // namespace shatterpave::scene
