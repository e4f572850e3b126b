#include "scene/schema/plan_section.h"

#include <algorithm>
#include <filesystem>

#include "scene/input_file.h"
#include "scene/plans/plan_areas.h"
#include "scene/schema/ranges.h"
#include "scene/schema/scene_keys.h"

namespace shatterpave::scene {

namespace {

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
  const auto chosen = table.choice("outline_units", names_of(plan_unit_words));
  if (!chosen || plan.svg) return std::nullopt;
  return plan_unit_words.at(*chosen).value;
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

// A clip path that leaves the whole line is no matter.
std::vector<vec2> guide_of(const PlanShape& shape, const PlanFrame& frame) {
  const Ring& ring = shape.rings.front();
  std::vector<vec2> line = line_of(frame(ring));
  for (const auto& clip : shape.clips) {
    const bool inside = std::ranges::all_of(line, [&](vec2 p) {
      return std::ranges::any_of(*clip, [&](const geometry::Region& region) { return geometry::contains(region, p); });
    });
    if (!inside) throw InputError(ring.place, "expected a guide that no clip path or viewport cuts, got one that is cut");
  }
  return line;
}

}  // namespace

Plans::Plans(const TomlTable& root, std::vector<Note>& notes) : notes_(notes) {
  PlanAsked asked;
  plan_keys.read_in(root, asked);
  origin_ = asked.origin;
  svg_scale_ = asked.svg_scale;
}

const Plan& Plans::plan(const TomlTable& table, std::string_view file_key, double svg_scale) {
  const Place place = table.place(file_key);
  const std::string name = *table.text(file_key);
  if (name.empty() || std::ranges::find(name, '\0') != name.end()) refuse(place, "the name of a file", in_quotes(name));
  if (name == "-" && table.file() == "-") refuse(place, "a file beside the scene, which is the standard input", "\"-\" too");
  const std::filesystem::path folder =
      is_nameless(table.file()) ? std::filesystem::path() : std::filesystem::path(table.file()).parent_path();
  const std::filesystem::path path = name == "-" ? std::filesystem::path(name) : folder / name;
  const std::pair key(path.string(), svg_scale);
  const auto found = plans_.find(key);
  if (found != plans_.end()) return found->second;
  const Plan& plan = plans_.emplace(key, plan_of_file(path, place, svg_scale)).first->second;
  for (const Note& note : plan.notes) add_note(note, notes_);
  return plan;
}

std::string Plans::sums() const {
  std::string text;
  for (const auto& [key, plan] : plans_) text += plan.sum;
  return text + other_sums_;
}

PlanFrame Plans::frame(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units) {
  const PlanUnits used = units ? *units : units_of(plan);
  const auto shared = std::ranges::find_if(
      frames_, [&](const SharedFrame& frame) { return frame.svg == plan.svg && (plan.svg || alike(frame.units, used)); });
  if (shared != frames_.end()) return shared->frame;
  frames_.push_back(
      {plan.svg, used, frame_of(plan, shapes, units, origin_ ? std::optional(plan.axes(*origin_)) : std::nullopt)});
  return frames_.back().frame;
}

namespace {

// Shapes of a plan as a scene asks for them. What it calls by name must be sound. Of a class, or of all there are, a shape that
// is not is left out and told; that one at least is sound is asked for of each.
class Taken {
 public:
  Taken(const Plan& plan, const std::vector<ShapeKind>& kinds, const ShapeChoice& choice, ByDefault by_default,
        const std::optional<PlanUnits>& units, Plans& plans)
      : plan_(plan),
        notes_(plans.notes()),
        by_name_(!choice.class_name && (!choice.shapes.empty() || by_default == ByDefault::the_only_feature)),
        shapes_(chosen_shapes(plan, kinds, choice, by_default)) {
    drop_unsound(units ? *units : units_of(plan));
    frame_ = plans.frame(plan, shapes_, units);
  }

  const PlanFrame& frame() const { return frame_; }

  std::vector<geometry::Region> regions(double width_mm) const {
    std::vector<InputError> left_out;
    std::vector<geometry::Region> regions =
        regions_of(plan_, shapes_, frame_, width_mm, &notes_, by_name_ ? nullptr : &left_out);
    if (regions.empty() && !left_out.empty()) throw InputError(left_out.front());
    for (const InputError& error : left_out) tell(error);
    return regions;
  }

  std::vector<std::vector<vec2>> lines() const {
    std::vector<InputError> left_out;
    std::vector<std::vector<vec2>> lines;
    for (const std::size_t shape : shapes_) {
      try {
        lines.push_back(guide_of(plan_.shapes[shape], frame_));
      } catch (const InputError& error) {
        if (by_name_) throw;
        left_out.push_back(error);
      }
    }
    if (lines.empty() && !left_out.empty()) throw InputError(left_out.front());
    for (const InputError& error : left_out) tell(error);
    return lines;
  }

 private:
  void drop_unsound(const PlanUnits& units) {
    std::vector<InputError> left_out;
    std::vector<std::size_t> sound;
    for (const std::size_t shape : shapes_) {
      if (const auto fault = fault_of(plan_.shapes[shape], units)) {
        left_out.push_back(*fault);
      } else {
        sound.push_back(shape);
      }
    }
    if (!left_out.empty() && (by_name_ || sound.empty())) throw InputError(left_out.front());
    shapes_ = std::move(sound);
    for (const InputError& error : left_out) tell(error);
  }

  void tell(const InputError& error) const { add_note({error.place(), "left out: " + error.message()}, notes_); }

  const Plan& plan_;
  std::vector<Note>& notes_;
  bool by_name_;
  std::vector<std::size_t> shapes_;
  PlanFrame frame_;
};

}  // namespace

std::vector<geometry::Region> outlines_of_plan(const TomlTable& table, Plans& plans) {
  const Plan& plan = plans.plan(table, outline_keys.file);
  if (plan.svg && table.has("outline_units")) {
    refuse(table.place("outline_units"), "no such key for SVG, which has its own units", "it");
  }
  const auto width = table.number(outline_keys.width, width_range);
  const auto units = units_asked(table, plan);
  const Taken taken(plan, kinds_of(width), choice_of(table, outline_keys), ByDefault::the_only_feature, units, plans);
  std::vector<geometry::Region> areas = merged(taken.regions(width.value_or(0.0)));
  if (areas.empty()) refuse(table.place(outline_keys.file), "an outline with an area", "none");
  const ShapeChoice limits = choice_of(table, within_keys);
  if (limits.shapes.empty() && !limits.class_name) return areas;
  const Taken limit(plan, kinds_of(std::nullopt), limits, ByDefault::all, units, plans);
  areas = within(areas, merged(limit.regions(0.0)));
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
  const Taken taken(plan, kinds_of(width), choice, ByDefault::all, units_asked(table, plan), plans);
  std::vector<geometry::Region> left = without(areas, taken.regions(width.value_or(0.0)));
  if (left.empty()) refuse(choice.place, "holes that leave something of the area", "none left");
  if (!choice.shapes.empty() && left == areas) refuse(choice.place, "a hole in the area", "none that meets it");
  return left;
}

bool has_guides_of_plan(const TomlTable& direction) { return has_any(direction, guide_keys); }

std::vector<std::vector<vec2>> guides_of_plan(const TomlTable& direction, const TomlTable& pavement, Plans& plans) {
  const Plan& plan = plan_of(direction, guide_keys.file, pavement, plans);
  return Taken(plan, {ShapeKind::line}, choice_of(direction, guide_keys), ByDefault::all, units_asked(pavement, plan), plans)
      .lines();
}

}  // namespace shatterpave::scene
