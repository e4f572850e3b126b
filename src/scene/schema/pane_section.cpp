#include "scene/schema/pane_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "geometry/lattice.h"
#include "glass/presets.h"
#include "scene/input_file.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/pane_keys.h"
#include "scene/schema/ranges.h"
#include "scene/schema/section.h"

namespace shatterpave::scene {

namespace {

void read_glass(const TomlTable& /*pane*/, glass::Annealed& /*annealed*/) {}
void read_glass(const TomlTable& pane, glass::Laminated& laminated) { laminate_keys.read_in(pane, laminated); }
void read_glass(const TomlTable& pane, glass::Tempered& tempered) { tempering_keys.read_in(pane, tempered); }

// Of all kinds of glass, in their order. The tables of those that were not chosen are checked, so that kinds can be tried in
// turn.
template <typename... Kinds>
void read_kinds(const TomlTable& pane, glass::Glass& chosen, const std::variant<Kinds...>& /*any*/) {
  const auto read = [&](auto kind) {
    auto* own = std::get_if<decltype(kind)>(&chosen);
    read_glass(pane, own != nullptr ? *own : kind);
  };
  (read(Kinds{}), ...);
}

void read_shards(const TomlTable& pane, std::optional<glass::ShardRules>& shards) {
  ShardsAsked asked;
  const auto table = shards_keys.read_in(pane, asked);
  if (!table) return;
  const glass::ShardRules& rules = asked.rules;
  if (rules.floor_drop_mm < rules.sill_drop_mm) {
    refuse(table->place("floor_drop_mm"), fmt::format("a floor not above the sill, so {} or more", rules.sill_drop_mm),
           fmt::format("{}", rules.floor_drop_mm));
  }
  if (asked.enabled) shards = rules;
}

void read_crack_sheet(const TomlTable& pane, glass::Pane& result) {
  for (const glass::Impact& impact : result.impacts) {
    if (impact.hole_mm > 0.0 && result.crack_body != glass::CrackBody::sheet) {
      refuse(pane.place("crack_body"), "\"sheet\", since an impact has a hole_mm", "\"cylinder\"");
    }
  }
  const auto table = crack_sheet_keys.read_in(pane, result.crack_sheet);
  if (table && result.crack_body != glass::CrackBody::sheet) {
    refuse(table->place(), "crack_body = \"sheet\" beside it", "none");
  }
}

const glass::Preset* preset_of(const TomlTable& pane) {
  const auto name = pane.text("preset");
  if (!name) return nullptr;
  if (const glass::Preset* preset = glass::preset(*name)) return preset;
  std::vector<std::string_view> names;
  for (const glass::Preset& preset : glass::presets()) names.push_back(preset.name);
  const std::string_view meant = nearest(*name, names);
  refuse(pane.place("preset"), fmt::format("a preset such as \"{}\"", meant.empty() ? names.front() : meant), in_quotes(*name));
}

// The counts of the printed experiment. N and R go with their M, so another M leaves them to follow from it.
void apply_counts(const glass::Preset& preset, glass::Impact& impact) {
  if (!impact.radial_count && !impact.mean_radial_count) {
    impact.radial_count = preset.radial_count;
    if (!impact.large_count) impact.large_count = std::min(preset.large_count, preset.radial_count);
    if (!impact.circular_count) impact.circular_count = preset.circular_count;
  }
}

glass::Impact impact_of(const TomlTable& table, const glass::Pane& pane) {
  glass::Impact impact;
  const auto at = table.point("at_mm", coordinate_range);
  if (!at) refuse(table.place("at_mm"), "a point [x, y]", "none");
  impact.at_mm = geometry::on_lattice(*at);
  if (!geometry::contains_strictly(pane.outline_mm, impact.at_mm)) {
    refuse(table.place("at_mm"), "a point inside the outline of the pane", fmt::format("({}, {})", at->x, at->y));
  }
  impact_keys.read(table, impact);
  if (impact.mean_radial_count && impact.radial_count) {
    refuse(table.place("mean_radial_count"), "either radial_count or mean_radial_count", "both");
  }
  if (impact.radial_count && impact.large_count > impact.radial_count) {
    refuse(table.place("large_count"), description(WholeRange{0, *impact.radial_count}),
           fmt::format("{}", *impact.large_count));
  }
  if (impact.spall_mm && *impact.spall_mm < impact.hole_mm) {
    refuse(table.place("spall_mm"), description(Range{impact.hole_mm, largest_spall_mm}), fmt::format("{}", *impact.spall_mm));
  }
  return impact;
}

std::vector<glass::Impact> impacts_of(const TomlTable& table, const glass::Pane& pane, bool has_preset) {
  std::vector<glass::Impact> impacts;
  for (const TomlTable& impact : impact_keys.tables_in(table, most_impacts)) {
    impacts.push_back(impact_of(impact, pane));
  }
  if (!impacts.empty()) return impacts;
  // The paper's experiments hit the middle of the pane.
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  glass::Impact middle;
  middle.at_mm = geometry::on_lattice(0.5 * (box.low + box.high));
  if (!has_preset || !geometry::contains_strictly(pane.outline_mm, middle.at_mm)) {
    refuse(table.place("impact"), "one or more tables [[pane.impact]]", "none");
  }
  return {middle};
}

geometry::Polygon pane_outline(const TomlTable& table, Plans& plans, bool has_preset) {
  std::vector<geometry::Region> regions =
      outlines_of(table, plans, has_preset ? std::optional(vec2{300.0, 300.0}) : std::nullopt);
  if (regions.size() > 1) refuse(table.place("outline_file"), "one outline", fmt::format("{}", regions.size()));
  geometry::Region& region = regions.front();
  if (!region.holes.empty()) refuse(table.place("outline_file"), "an outline without holes", "one with holes");
  return std::move(region.outline);
}

glass::Pane pane_of(const TomlTable& table, Plans& plans, Names& names) {
  glass::Pane pane;
  pane.name = name_of(table);
  names.add(pane.name, table.path(), table.place("name"));
  const glass::Preset* preset = preset_of(table);
  if (preset != nullptr) pane.growth = preset->growth;
  pane.outline_mm = pane_outline(table, plans, preset != nullptr);
  pane_keys.read(table, pane);
  pane.impacts = impacts_of(table, pane, preset != nullptr);
  if (preset != nullptr) {
    for (glass::Impact& impact : pane.impacts) apply_counts(*preset, impact);
  }
  growth_keys.read_in(table, pane.growth);
  rings_keys.read_in(table, pane.rings);
  crater_keys.read_in(table, pane);
  read_kinds(table, pane.glass, pane.glass);
  read_shards(table, pane.shards);
  read_crack_sheet(table, pane);
  tell_idle_keys(table, pane, plans.notes());
  return pane;
}

}  // namespace

void read_panes(const TomlTable& root, Plans& plans, Names& names, Scene& scene) {
  for (const TomlTable& table : root.tables("pane", most_panes, pane_keys.names())) {
    scene.panes.push_back(pane_of(table, plans, names));
    scene.pane_places.emplace_back(table);
  }
}

}  // namespace shatterpave::scene
