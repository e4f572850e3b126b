#include "scene/schema/module_section.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "paving/bonds/module_cells.h"
#include "paving/bonds/table.h"
#include "scene/input_file.h"
#include "scene/plans/plan_areas.h"
#include "scene/schema/ranges.h"

namespace shatterpave::scene {

namespace {

// Of all shapes in the file, or those that the keys choose.
ShapeChoice stones_chosen(const TomlTable& table) {
  ShapeChoice choice;
  choice.shapes = table.indices_or_texts("module_feature");
  choice.class_name = table.text("module_class");
  choice.place = table.place(choice.class_name ? "module_class" : "module_feature");
  if (choice.class_name && !choice.shapes.empty()) refuse(choice.place, "module_feature or module_class", "both");
  return choice;
}

std::vector<paving::DrawnStone> stones_of(const TomlTable& table, double scale, Plans& plans) {
  const Plan& plan = plans.plan(table, "module_file", scale);
  if (!plan.svg) refuse(table.place("module_file"), "an SVG file", in_quotes(*table.text("module_file")));
  std::vector<paving::DrawnStone> stones;
  for (const std::size_t s : chosen_shapes(plan, {ShapeKind::area}, stones_chosen(table), ByDefault::all)) {
    const PlanShape& shape = plan.shapes[s];
    if (shape.fault) throw InputError(*shape.fault);
    for (geometry::Region& region : regions_of(plan, {s}, PlanFrame{}, 0.0, &plans.notes())) {
      stones.push_back({std::move(region), shape.rings.front().place});
    }
  }
  if (stones.empty()) refuse(table.place("module_file"), "a drawing with a closed shape for each stone", "none");
  return stones;
}

}  // namespace

void read_module(const TomlTable& table, Plans& plans, paving::Pavement& pavement) {
  const bool asked = paving::type_of(pavement).takes_module;
  if (asked && !table.has("module_file"))
    refuse(table.place("module_file"), "module_file = \"…\", a drawing of the stones", "none");
  const auto vectors = table.points("module_mm", coordinate_range);
  if (asked && !vectors) refuse(table.place("module_mm"), "module_mm = [[x, y], [x, y]], by which the stones repeat", "none");
  if (vectors && vectors->points.size() != 2) {
    refuse(vectors->place, "two vectors, [[x, y], [x, y]]", fmt::format("{}", vectors->points.size()));
  }
  const double scale = table.number("module_scale", svg_scale_range).value_or(1.0);
  if (!table.has("module_file")) return;
  std::vector<paving::DrawnStone> stones = stones_of(table, scale, plans);
  if (!vectors) return;
  paving::Pavement drawn = pavement;
  lay_as_drawn(drawn, {std::move(stones), vectors->points[0], vectors->points[1], table.place("module_file"), vectors->place});
  if (asked) pavement = std::move(drawn);
}

}  // namespace shatterpave::scene
