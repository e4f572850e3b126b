#include "scene/schema/section.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/input_file.h"
#include "scene/plans/outline.h"
#include "scene/schema/ranges.h"

namespace shatterpave::scene {

namespace {

bool is_name_character(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; }

// The one key of those that say where the outline comes from; "" for none.
std::string_view outline_key(const TomlTable& table) {
  std::string_view found;
  for (const std::string_view key : {"size_mm", "outline_mm", "outline_file"}) {
    if (!table.has(key)) continue;
    if (!found.empty()) refuse(table.place(key), "one outline", fmt::format("{} beside {}", key, found));
    found = key;
  }
  for (const std::string_view key :
       {"outline_feature", "outline_class", "outline_width_mm", "outline_units", "within_feature", "within_class"}) {
    if (table.has(key) && found != "outline_file") refuse(table.place(key), "outline_file beside it", "none");
  }
  if (table.has("holes_mm") && found == "outline_file") {
    refuse(table.place("holes_mm"), "holes in the outline file", "holes_mm beside outline_file");
  }
  return found;
}

Ring rectangle(vec2 size_mm, const Place& place) { return {{{0.0, 0.0}, {size_mm.x, 0.0}, size_mm, {0.0, size_mm.y}}, place}; }

std::vector<Ring> holes_of(const TomlTable& table) {
  std::vector<Ring> holes;
  if (!table.has("holes_mm")) return holes;
  for (PlacedPoints& hole : table.point_lists("holes_mm", coordinate_range)) {
    holes.push_back({std::move(hole.points), std::move(hole.place)});
  }
  return holes;
}

}  // namespace

std::string name_of(const TomlTable& table) {
  const auto name = table.text("name");
  if (!name) refuse(table.place("name"), "a name", "none");
  const bool valid =
      !name->empty() && name->size() <= 64 && is_letter(name->front()) && std::ranges::all_of(*name, is_name_character);
  if (!valid) {
    refuse(table.place("name"), "1 to 64 letters, digits, '_' and '-', the first a letter", in_quotes(*name));
  }
  return *name;
}

std::vector<geometry::Region> outlines_of(const TomlTable& table, Plans& plans, std::optional<vec2> default_size_mm) {
  const std::string_view key = outline_key(table);
  if (key == "outline_file") return outlines_of_plan(table, plans);
  if (key == "outline_mm") {
    PlacedPoints outline = *table.points("outline_mm", coordinate_range);
    return {region_of({std::move(outline.points), std::move(outline.place)}, holes_of(table), &plans.notes())};
  }
  const auto size = table.point("size_mm", size_range);
  if (!size && !default_size_mm) refuse(table.place("outline_mm"), "size_mm, outline_mm or outline_file", "none of them");
  return {region_of(rectangle(size.value_or(default_size_mm.value_or(vec2{})), table.place("size_mm")), holes_of(table),
                    &plans.notes())};
}

}  // namespace shatterpave::scene
