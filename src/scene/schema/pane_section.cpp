#include "scene/schema/pane_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "geometry/lattice.h"
#include "glass/presets.h"
#include "scene/cracks_file.h"
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
  shards = asked.enabled ? std::optional(rules) : std::nullopt;
}

void read_crack_sheet(const TomlTable& pane, glass::Pane& result) {
  for (const glass::Impact& impact : result.impacts) {
    if (impact.hole_mm > 0.0 && result.crack_body != glass::CrackBody::sheet && !result.shards) {
      refuse(pane.place("crack_body"), "\"sheet\", since an impact has a hole_mm", "\"cylinder\"");
    }
  }
  const auto table = crack_sheet_keys.read_in(pane, result.crack_sheet);
  const bool has_leaning_shards = result.shards && result.shards->leaning;
  if (table && result.crack_body != glass::CrackBody::sheet && !has_leaning_shards) {
    refuse(table->place(), "crack_body = \"sheet\" beside it", "none");
  }
}

// One of the paper's experiments, or a window, or neither.
struct ChosenPreset {
  const glass::Preset* experiment = nullptr;
  const glass::WindowPreset* window = nullptr;

  bool is_one() const { return experiment != nullptr || window != nullptr; }
  vec2 size_mm() const { return window != nullptr ? window->size_mm : vec2{300.0, 300.0}; }
};

ChosenPreset preset_of(const TomlTable& pane) {
  const auto name = pane.text("preset");
  if (!name) return {};
  if (const glass::Preset* preset = glass::preset(*name)) return {preset, nullptr};
  if (*name == glass::stone_through_window.name) return {nullptr, &glass::stone_through_window};
  std::vector<std::string_view> names{glass::stone_through_window.name};
  for (const glass::Preset& preset : glass::presets()) names.push_back(preset.name);
  const std::string_view meant = nearest(*name, names);
  refuse(pane.place("preset"), fmt::format("a preset such as \"{}\"", meant.empty() ? glass::presets().front().name : meant),
         in_quotes(*name));
}

// The counts of the printed experiment. N and R go with their M, so another M leaves them to follow from it.
void apply_counts(const glass::Preset& preset, glass::Impact& impact) {
  if (!impact.radial_count && !impact.mean_radial_count) {
    impact.radial_count = preset.radial_count;
    if (!impact.large_count) impact.large_count = std::min(preset.large_count, preset.radial_count);
    if (!impact.circular_count) impact.circular_count = preset.circular_count;
  }
}

// The counts of a window that a stone goes through, where the scene gives none.
void apply_counts(const glass::WindowPreset& preset, glass::Impact& impact) {
  if (impact.radial_count || impact.mean_radial_count) return;
  impact.mean_radial_count = preset.mean_radial_count;
  if (!impact.large_count) impact.large_count = preset.large_count;
}

glass::Impact impact_of(const TomlTable& table, const glass::Pane& pane, const ChosenPreset& preset) {
  glass::Impact impact;
  if (preset.window != nullptr) glass::apply(*preset.window, impact);
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

// The pane of the file that `cracks_file` names: the one of the scene's pane's name, or the only one.
FilePane file_pane(const TomlTable& table, const std::string& name, Plans& plans) {
  const std::string asked = *table.text("cracks_file");
  const Place place = table.place("cracks_file");
  if (asked.empty()) refuse(place, "a file name", "an empty one");
  const CracksFile file = cracks_of_file(std::filesystem::path(place.file).parent_path() / asked, place);
  plans.note_sum(file.sum);
  const auto named = std::ranges::find(file.panes, name, &FilePane::name);
  if (named != file.panes.end()) return *named;
  if (file.panes.size() > 1)
    refuse(place, "a file with one pane, or with one of this name", fmt::format("{}", file.panes.size()));
  return file.panes.front();
}

// Takes the cracks of the file. Where the scene has no impacts, the file's are those that were found there.
void take_cracks(const FilePane& from, const TomlTable& table, glass::Pane& pane) {
  std::vector<glass::ImpactCounts> impacts;
  for (const glass::Impact& impact : pane.impacts) impacts.push_back({impact.at_mm, impact.radial_count.value_or(0), 0, 0, {}});
  try {
    pane.given_cracks = network_of(from, pane.outline_mm, impacts);
  } catch (const InputError& error) {
    throw InputError(table.place("cracks_file"), error.message());
  }
  for (std::size_t i = 0; i < pane.impacts.size(); ++i) glass::count_again(*pane.given_cracks, static_cast<int>(i));
}

std::vector<glass::Impact> impacts_of_file(const FilePane& file) {
  std::vector<glass::Impact> impacts;
  for (const glass::ImpactCounts& counts : file.impacts) {
    glass::Impact impact;
    impact.at_mm = counts.at_mm;
    if (counts.radial_count > 0) impact.radial_count = counts.radial_count;
    impacts.push_back(impact);
  }
  return impacts;
}

std::vector<glass::Impact> impacts_of(const TomlTable& table, const glass::Pane& pane, const ChosenPreset& preset) {
  std::vector<glass::Impact> impacts;
  for (const TomlTable& impact : impact_keys.tables_in(table, most_impacts)) {
    impacts.push_back(impact_of(impact, pane, preset));
    const double earlier_us = impacts.size() > 1 ? impacts[impacts.size() - 2].time_us : 0.0;
    if (impacts.back().time_us < earlier_us) {
      refuse(impact.place("time_us"), fmt::format("a time not before the impact before it, so {} or more", earlier_us),
             fmt::format("{}", impacts.back().time_us));
    }
  }
  if (!impacts.empty()) return impacts;
  // The paper's experiments hit the middle of the pane.
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  glass::Impact middle;
  if (preset.window != nullptr) glass::apply(*preset.window, middle);
  middle.at_mm = geometry::on_lattice(0.5 * (box.low + box.high));
  if (!preset.is_one() || !geometry::contains_strictly(pane.outline_mm, middle.at_mm)) {
    refuse(table.place("impact"), "one or more tables [[pane.impact]]", "none");
  }
  return {middle};
}

geometry::Polygon pane_outline(const TomlTable& table, Plans& plans, const ChosenPreset& preset) {
  std::vector<geometry::Region> regions =
      outlines_of(table, plans, preset.is_one() ? std::optional(preset.size_mm()) : std::nullopt);
  if (regions.size() > 1) refuse(table.place("outline_file"), "one outline", fmt::format("{}", regions.size()));
  geometry::Region& region = regions.front();
  if (!region.holes.empty()) refuse(table.place("outline_file"), "an outline without holes", "one with holes");
  return std::move(region.outline);
}

glass::Pane pane_of(const TomlTable& table, Plans& plans, Names& names) {
  glass::Pane pane;
  pane.name = name_of(table);
  names.add(pane.name, table.path(), table.place("name"));
  const ChosenPreset preset = preset_of(table);
  if (preset.experiment != nullptr) pane.growth = preset.experiment->growth;
  if (preset.window != nullptr) glass::apply(*preset.window, pane);
  std::optional<FilePane> file;
  if (table.has("cracks_file")) file = file_pane(table, pane.name, plans);
  const bool has_outline = table.has("size_mm") || table.has("outline_mm") || table.has("outline_file");
  pane.outline_mm = file && file->outline && !has_outline ? *file->outline : pane_outline(table, plans, preset);
  pane_keys.read(table, pane);
  const bool has_impacts = table.has("impact") || !file || file->impacts.empty();
  pane.impacts = has_impacts ? impacts_of(table, pane, preset) : impacts_of_file(*file);
  for (glass::Impact& impact : pane.impacts) {
    if (preset.experiment != nullptr) apply_counts(*preset.experiment, impact);
    if (preset.window != nullptr) apply_counts(*preset.window, impact);
  }
  growth_keys.read_in(table, pane.growth);
  rings_keys.read_in(table, pane.rings);
  crater_keys.read_in(table, pane);
  read_kinds(table, pane.glass, pane.glass);
  read_shards(table, pane.shards);
  read_crack_sheet(table, pane);
  if (file) take_cracks(*file, table, pane);
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
