#include "scene/schema/pane_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/lattice.h"
#include "glass/presets.h"
#include "scene/input_file.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/keys.h"
#include "scene/schema/section.h"

namespace shatterpave::scene {

namespace {

using glass::Growth;
using glass::ShardRules;

constexpr std::size_t most_panes = 1000;
constexpr std::size_t most_impacts = 1000;
constexpr int most_radials = 10'000;
constexpr int most_ring_starts = 1000;
constexpr int most_rings = 100;

struct GrowthNumber {
  std::string_view key;
  double Growth::*member;
  Range range;
};

// Ranges are wide: they keep numbers where the model has a meaning and ends, not where it looks good.
constexpr std::array growth_numbers = {
    GrowthNumber{"spread_limit", &Growth::spread_limit, {0.0, 1.0, false, true}},
    GrowthNumber{"spread_deviation", &Growth::spread_deviation, {0.0, 10.0}},
    GrowthNumber{"large_speed_px", &Growth::large_speed, {0.1, 1000.0}},
    GrowthNumber{"radial_speed_px", &Growth::radial_speed, {0.1, 1000.0}},
    GrowthNumber{"circular_speed_px", &Growth::circular_speed, {0.1, 1000.0}},
    GrowthNumber{"sector_radius_px", &Growth::sector_radius, {1.0, 1000.0}},
    GrowthNumber{"weight_time", &Growth::weight_time, {0.01, 1000.0}},
    GrowthNumber{"step_length_px", &Growth::step_length, {0.1, 100.0}},
    GrowthNumber{"reference_radial_count", &Growth::reference_radial_count, {1.0, 10000.0}},
    GrowthNumber{"energy_exponent", &Growth::energy_exponent, {0.0, 2.0}},
    GrowthNumber{"count_dispersion", &Growth::count_dispersion, {1.0, 1000.0}},
    GrowthNumber{"circular_threshold", &Growth::circular_threshold, {0.0, 10000.0}},
    GrowthNumber{"circular_slope", &Growth::circular_slope, {0.0, 1.0}},
    GrowthNumber{"circular_offset", &Growth::circular_offset, {-1000.0, 1000.0}},
    GrowthNumber{"large_slope", &Growth::large_slope, {0.0, 1.0}},
    GrowthNumber{"large_offset", &Growth::large_offset, {-1000.0, 1000.0}},
    GrowthNumber{"large_deviation", &Growth::large_deviation, {0.0, 1000.0}},
    GrowthNumber{"ring_radius_slope_mm", &Growth::ring_radius_slope_mm, {0.0, 100.0}},
    GrowthNumber{"ring_radius_offset_mm", &Growth::ring_radius_offset_mm, {0.0, 10000.0}},
    GrowthNumber{"tip_gain_px2", &Growth::tip_gain, {0.0, 1e6}},
    GrowthNumber{"crack_gain_px2", &Growth::crack_gain, {0.0, 1e6}},
    GrowthNumber{"sibling_gain_px2", &Growth::sibling_gain, {-1e6, 1e6}},
    GrowthNumber{"edge_gain_px2", &Growth::edge_gain, {0.0, 1e6}},
    GrowthNumber{"turn_length_px", &Growth::turn_length, {0.1, 1000.0}},
    GrowthNumber{"radial_pull", &Growth::radial_pull, {0.0, 1000.0}},
    GrowthNumber{"ring_pull", &Growth::ring_pull, {0.0, 1000.0}},
    GrowthNumber{"ring_onset", &Growth::ring_onset, {0.0, 1000.0}},
    GrowthNumber{"radial_onset", &Growth::radial_onset, {0.0, 1000.0}},
    GrowthNumber{"branch_rate_per_m", &Growth::branch_rate_per_m, {0.0, 1000.0}},
};

struct ShardNumber {
  std::string_view key;
  double ShardRules::*member;
  Range range;
};

constexpr std::array shard_numbers = {
    ShardNumber{"gap_mm", &ShardRules::gap_mm, {0.02, 10.0}},
    ShardNumber{"splinter_mm2", &ShardRules::splinter_mm2, {0.01, 1e6}},
    ShardNumber{"bevel_mm", &ShardRules::bevel_mm, {0.0, 10.0}},
    ShardNumber{"chips_per_m", &ShardRules::chips_per_m, {0.0, 1000.0}},
    ShardNumber{"chip_mm", &ShardRules::chip_mm, {0.0, 100.0}},
    ShardNumber{"missing", &ShardRules::missing, {0.0, 1.0}},
    ShardNumber{"missing_mm", &ShardRules::missing_mm, {0.0, 100000.0, true}},
    ShardNumber{"held", &ShardRules::held, {0.0, 1.0}},
    ShardNumber{"fallen", &ShardRules::fallen, {0.0, 1.0}},
    ShardNumber{"throw_m_s", &ShardRules::throw_m_s, {0.0, 20.0}},
    ShardNumber{"sill_drop_mm", &ShardRules::sill_drop_mm, {0.0, 10000.0}},
    ShardNumber{"sill_depth_mm", &ShardRules::sill_depth_mm, {0.0, 10000.0}},
    ShardNumber{"frame_mm", &ShardRules::frame_mm, {0.0, 1000.0}},
    ShardNumber{"reveal_mm", &ShardRules::reveal_mm, {0.0, 10000.0}},
    ShardNumber{"floor_drop_mm", &ShardRules::floor_drop_mm, {0.0, 10000.0}},
};

void read_shards(const TomlTable& pane, std::optional<ShardRules>& shards) {
  const auto table = pane.table("shards", shards_keys);
  if (!table) return;
  ShardRules rules;
  for (const ShardNumber& number : shard_numbers) table->read(number.key, number.range, rules.*number.member);
  if (rules.floor_drop_mm < rules.sill_drop_mm) {
    refuse(table->place("floor_drop_mm"), fmt::format("a floor not above the sill, so {} or more", rules.sill_drop_mm),
           fmt::format("{}", rules.floor_drop_mm));
  }
  rules.joined = table->flag("joined").value_or(rules.joined);
  if (table->flag("enabled").value_or(true)) shards = rules;
}

void read_angle(const TomlTable& table, std::string_view key, const Range& range, Angle& angle) {
  if (const auto degrees = table.number(key, range)) angle = Angle::degrees(*degrees);
}

void read_growth(const TomlTable& pane, Growth& growth) {
  const auto table = pane.table("growth", growth_keys);
  if (!table) return;
  if (const auto law = table->choice("count_law", {"poisson", "table1"})) {
    growth.count_dispersion = *law == 0 ? 1.0 : glass::table_1_dispersion;
  }
  for (const GrowthNumber& number : growth_numbers) table->read(number.key, number.range, growth.*number.member);
  read_angle(*table, "sector_angle_deg", {1.0, 180.0}, growth.sector_angle);
  read_angle(*table, "turn_limit_deg", {0.0, 90.0}, growth.turn_limit);
  read_angle(*table, "wander_deg", {0.0, 90.0}, growth.wander);
  if (const auto range = table->point("branch_angle_deg", {0.0, 90.0})) {
    if (range->x > range->y) {
      refuse(table->place("branch_angle_deg"), "the least angle, then the greatest",
             fmt::format("[{}, {}]", range->x, range->y));
    }
    growth.least_branch_angle = Angle::degrees(range->x);
    growth.greatest_branch_angle = Angle::degrees(range->y);
  }
  if (const auto law = table->choice("spread", {"normal", "uniform"})) {
    growth.spread = *law == 0 ? glass::Spread::normal : glass::Spread::uniform;
  }
  if (const auto rounding = table->choice("large_rounding", {"down", "nearest", "up"})) {
    constexpr std::array values = {glass::Rounding::down, glass::Rounding::nearest, glass::Rounding::up};
    growth.large_rounding = values[*rounding];
  }
}

void read_glass(const TomlTable& /*pane*/, glass::Annealed& /*annealed*/) {}

void read_glass(const TomlTable& pane, glass::Laminated& laminated) {
  const auto table = pane.table("laminate", laminate_keys);
  if (!table) return;
  table->read("through", {0.0, 1.0}, laminated.through);
  table->read("milky_width_mm", {0.0, 1000.0}, laminated.milky_width_mm);
}

void read_glass(const TomlTable& pane, glass::Tempered& tempered) {
  const auto table = pane.table("tempering", tempering_keys);
  if (!table) return;
  table->read("surface_stress_mpa", {20.0, 1000.0}, tempered.surface_stress_mpa);
  tempered.count_per_square = table->number("count_per_square", {1.0, 2500.0});
  tempered.splinter_ratio = table->number("splinter_ratio", {1.0, 20.0});
  table->read("splinter_reach_mm", {1.0, 10'000.0}, tempered.splinter_reach_mm);
}

// Of all kinds of glass, in their order, the one that is asked for. The tables of the others are checked, so that kinds can be
// tried in turn.
template <class... Kinds>
glass::Glass chosen_glass(const TomlTable& pane, std::variant<Kinds...> /*any*/) {
  std::array<glass::Glass, sizeof...(Kinds)> kinds = {Kinds{}...};
  for (glass::Glass& kind : kinds) std::visit([&](auto& glass) { read_glass(pane, glass); }, kind);
  return kinds.at(pane.choice("glass", {Kinds::name...}).value_or(0));
}

glass::Glass glass_of(const TomlTable& pane) { return chosen_glass(pane, glass::Glass()); }

// The kind of glass, and what belongs to one kind or pattern only.
void read_kind(const TomlTable& pane, glass::Pane& result) {
  result.glass = glass_of(pane);
  if (std::holds_alternative<glass::Laminated>(result.glass)) {
    result.pattern = glass::Pattern::real;
    result.rings = glass::laminated_rings;
  }
  if (const auto pattern = pane.choice("pattern", {"agui1992", "real"})) {
    result.pattern = *pattern == 0 ? glass::Pattern::agui1992 : glass::Pattern::real;
  }
  if (const auto rings = pane.table("rings", rings_keys)) {
    if (const auto count = rings->whole_number("count", 0, most_rings)) result.rings.count = static_cast<int>(*count);
    rings->read("first_radius_mm", {0.1, 100'000.0}, result.rings.first_radius_mm);
    rings->read("ratio", {1.01, 100.0}, result.rings.ratio);
    rings->read("spread", {0.0, 0.5}, result.rings.spread);
    rings->read("interruption", {0.0, 1.0}, result.rings.interruption);
    rings->read("bow", {0.0, 1.0}, result.rings.bow);
  }
  if (const auto crater = pane.table("crater", crater_keys)) {
    read_angle(*crater, "cone_deg", {0.0, 85.0}, result.crater_cone);
  }
}

// Leans and bows are limited so that a wall reaches no farther aside than three thicknesses of the pane.
void read_crack_body(const TomlTable& pane, glass::Pane& result) {
  if (const auto body = pane.choice("crack_body", {"cylinder", "sheet"})) {
    result.crack_body = *body == 0 ? glass::CrackBody::cylinder : glass::CrackBody::sheet;
  }
  for (const glass::Impact& impact : result.impacts) {
    if (impact.hole_mm > 0.0 && result.crack_body != glass::CrackBody::sheet) {
      refuse(pane.place("crack_body"), "\"sheet\", since an impact has a hole_mm", "\"cylinder\"");
    }
  }
  const auto table = pane.table("crack_sheet", crack_sheet_keys);
  if (!table) return;
  if (result.crack_body != glass::CrackBody::sheet) {
    refuse(table->place(), "crack_body = \"sheet\" beside it", "none");
  }
  glass::CrackSheet& sheet = result.crack_sheet;
  read_angle(*table, "tilt_deg", {0.0, 70.0}, sheet.tilt);
  read_angle(*table, "curve_deg", {0.0, 70.0}, sheet.curve);
  table->read("twist_mm", {1.0, 1000.0}, sheet.twist_mm);
  table->read("opening_mm", {0.001, 10.0}, sheet.opening_mm);
  table->read("opening_variation", {0.0, 1.0}, sheet.opening_variation);
  if (const auto depth = table->point("depth", {0.05, 1.0})) {
    if (depth->x > depth->y) refuse(table->place("depth"), "[least, greatest]", "the greater one first");
    sheet.least_depth = depth->x;
    sheet.greatest_depth = depth->y;
  }
  table->read("relief", {0.0, 10.0}, sheet.relief);
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

std::optional<int> count_of(const TomlTable& table, std::string_view key, int low, int high) {
  const auto value = table.whole_number(key, low, high);
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

glass::Impact impact_of(const TomlTable& table, const glass::Pane& pane) {
  glass::Impact impact;
  const auto at = table.point("at_mm", coordinate_range);
  if (!at) refuse(table.place("at_mm"), "a point [x, y]", "none");
  impact.at_mm = geometry::on_lattice(*at);
  if (!geometry::contains_strictly(pane.outline_mm, impact.at_mm)) {
    refuse(table.place("at_mm"), "a point inside the outline of the pane", fmt::format("({}, {})", at->x, at->y));
  }
  impact.mean_radial_count = table.number("mean_radial_count", {1.0, most_radials});
  impact.radial_count = count_of(table, "radial_count", 1, most_radials);
  if (impact.mean_radial_count && impact.radial_count) {
    refuse(table.place("mean_radial_count"), "either radial_count or mean_radial_count", "both");
  }
  impact.large_count = count_of(table, "large_count", 0, impact.radial_count.value_or(most_radials));
  impact.circular_count = count_of(table, "circular_count", 0, most_ring_starts);
  table.read("ball_diameter_mm", {0.0, 1000.0, true}, impact.ball_diameter_mm);
  table.read("speed_m_s", {0.0, 2000.0, true}, impact.speed_m_s);
  table.read("hole_mm", {0.0, 1000.0}, impact.hole_mm);
  impact.spall_mm = table.number("spall_mm", {impact.hole_mm, 10000.0});
  return impact;
}

std::vector<glass::Impact> impacts_of(const TomlTable& table, const glass::Pane& pane, bool has_preset) {
  std::vector<glass::Impact> impacts;
  for (const TomlTable& impact : table.tables("impact", most_impacts, impact_keys)) {
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
  table.read("thickness_mm", {0.1, 1000.0}, pane.thickness_mm);
  pane.impacts = impacts_of(table, pane, preset != nullptr);
  if (preset != nullptr) {
    for (glass::Impact& impact : pane.impacts) apply_counts(*preset, impact);
  }
  read_growth(table, pane.growth);
  read_kind(table, pane);
  read_shards(table, pane.shards);
  read_crack_body(table, pane);
  tell_idle_keys(table, pane, plans.notes());
  return pane;
}

}  // namespace

void read_panes(const TomlTable& root, Plans& plans, Names& names, Scene& scene) {
  for (const TomlTable& table : root.tables("pane", most_panes, pane_keys)) {
    scene.panes.push_back(pane_of(table, plans, names));
    scene.pane_places.emplace_back(table);
  }
}

}  // namespace shatterpave::scene
