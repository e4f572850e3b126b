#include "scene/plan_section.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "scene/input_file.h"
#include "scene/plan_areas.h"

namespace shatterpave::scene {

namespace {

constexpr Range width_range{1.0, 100'000.0};

// The keys of one use of a plan.
struct PlanKeys {
  std::string_view file;
  std::string_view feature;
  std::string_view class_name;
  std::string_view width;
};
constexpr PlanKeys outline_keys{"outline_file", "outline_feature", "outline_class", "outline_width_mm"};
constexpr PlanKeys hole_keys{"holes_file", "holes_feature", "holes_class", "holes_width_mm"};
constexpr PlanKeys within_keys{"outline_file", "within_feature", "within_class", ""};
constexpr PlanKeys guide_keys{"guides_file", "guides_feature", "guides_class", ""};

ShapeChoice choice_of(const TomlTable& table, const PlanKeys& keys) {
  ShapeChoice choice;
  choice.place = table.place(keys.feature);
  choice.shapes = table.indices_or_texts(keys.feature);
  choice.class_name = table.text(keys.class_name);
  if (!choice.class_name) return choice;
  choice.place = table.place(keys.class_name);
  if (!choice.shapes.empty()) {
    refuse(choice.place, std::string(keys.feature) + " or " + std::string(keys.class_name), "both");
  }
  return choice;
}

std::optional<PlanUnits> units_asked(const TomlTable& table, const Plan& plan) {
  const auto units = table.choice("outline_units", {"degrees", "metres", "millimetres"});
  if (!units || plan.svg) return std::nullopt;
  return static_cast<PlanUnits>(*units);
}

// Areas, and with a width lines and points too.
std::vector<ShapeKind> kinds_of(const std::optional<double>& width) {
  if (width) return {ShapeKind::area, ShapeKind::line, ShapeKind::point};
  return {ShapeKind::area};
}

// The plan of the key, or that of the outline.
const Plan& plan_of(const TomlTable& table, std::string_view key, const TomlTable& pavement, Plans& plans) {
  if (table.has(key)) return plans.plan(table, key);
  if (pavement.has(outline_keys.file)) return plans.plan(pavement, outline_keys.file);
  refuse(table.place(key), std::string(key) + " or an outline_file", "neither");
}

bool has_any(const TomlTable& table, const PlanKeys& keys) {
  return table.has(keys.file) || table.has(keys.feature) || table.has(keys.class_name);
}

}  // namespace

Plans::Plans(const TomlTable& root, std::vector<Note>& notes) : notes_(notes) {
  const auto table = root.table("plan", plan_keys);
  if (!table) return;
  constexpr double most = std::numeric_limits<double>::max();
  origin_ = table->point("origin", {-most, most});
  table->read("svg_scale", {0.001, 100'000.0}, svg_scale_);
}

const Plan& Plans::plan(const TomlTable& table, std::string_view file_key) {
  const Place place = table.place(file_key);
  const std::string name = *table.text(file_key);
  if (name.empty() || std::ranges::find(name, '\0') != name.end()) refuse(place, "the name of a file", in_quotes(name));
  const std::filesystem::path path = std::filesystem::path(table.file()).parent_path() / name;
  const auto found = plans_.find(path.string());
  if (found != plans_.end()) return found->second;
  return plans_.emplace(path.string(), plan_of_file(path, place, svg_scale_)).first->second;
}

const PlanFrame& Plans::frame(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units) {
  const std::size_t index = plan.svg ? frames_.size() - 1 : static_cast<std::size_t>(units.value_or(units_of(plan)));
  if (!frames_[index]) frames_[index] = frame_of(plan, shapes, units, origin_);
  return *frames_[index];
}

std::vector<geometry::Region> outlines_of_plan(const TomlTable& table, Plans& plans) {
  const Plan& plan = plans.plan(table, outline_keys.file);
  if (plan.svg && table.has("outline_units")) {
    refuse(table.place("outline_units"), "no such key for SVG, which has its own units", "it");
  }
  const auto width = table.number(outline_keys.width, width_range);
  const auto shapes = chosen_shapes(plan, kinds_of(width), choice_of(table, outline_keys), ByDefault::the_only_feature);
  const PlanFrame& frame = plans.frame(plan, shapes, units_asked(table, plan));
  std::vector<geometry::Region> areas = merged(regions_of(plan, shapes, frame, width.value_or(0.0)));
  if (areas.empty()) refuse(table.place(outline_keys.file), "an outline with an area", "none");
  const ShapeChoice limits = choice_of(table, within_keys);
  if (limits.shapes.empty() && !limits.class_name) return areas;
  const auto limit_shapes = chosen_shapes(plan, kinds_of(std::nullopt), limits, ByDefault::all);
  areas = within(areas, merged(regions_of(plan, limit_shapes, frame, 0.0)));
  if (areas.empty()) refuse(limits.place, "areas that the outline lies in", "none that it meets");
  return areas;
}

std::vector<geometry::Region> without_holes_of_plan(const TomlTable& table, Plans& plans, std::vector<geometry::Region> areas) {
  if (!has_any(table, hole_keys)) {
    if (table.has(hole_keys.width)) refuse(table.place(hole_keys.width), "holes_feature, holes_class or holes_file", "none");
    return areas;
  }
  const Plan& plan = plan_of(table, hole_keys.file, table, plans);
  const auto width = table.number(hole_keys.width, width_range);
  const ShapeChoice choice = choice_of(table, hole_keys);
  const auto shapes = chosen_shapes(plan, kinds_of(width), choice, ByDefault::all);
  const PlanFrame& frame = plans.frame(plan, shapes, units_asked(table, plan));
  std::vector<geometry::Region> left = without(areas, regions_of(plan, shapes, frame, width.value_or(0.0)));
  if (left.empty()) refuse(choice.place, "holes that leave something of the area", "none left");
  if (!choice.shapes.empty() && left == areas) refuse(choice.place, "a hole in the area", "none that meets it");
  return left;
}

bool has_guides_of_plan(const TomlTable& direction) { return has_any(direction, guide_keys); }

std::vector<std::vector<vec2>> guides_of_plan(const TomlTable& direction, const TomlTable& pavement, Plans& plans) {
  const Plan& plan = plan_of(direction, guide_keys.file, pavement, plans);
  const auto shapes = chosen_shapes(plan, {ShapeKind::line}, choice_of(direction, guide_keys), ByDefault::all);
  const PlanFrame& frame = plans.frame(plan, shapes, units_asked(pavement, plan));
  std::vector<std::vector<vec2>> guides;
  guides.reserve(shapes.size());
  for (const std::size_t shape : shapes) guides.push_back(line_of(frame(plan.shapes[shape].rings.front())));
  return guides;
}

}  // namespace shatterpave::scene
