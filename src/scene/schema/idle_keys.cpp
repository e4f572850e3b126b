// One row a rule: the key, when it has no effect, and the words for it. Of the rows of a key the first that holds is told;
// where a whole table is told, its keys are not.
#include "scene/schema/idle_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/random.h"
#include "glass/growth/counts.h"
#include "paving/bonds/table.h"
#include "scene/schema/keys.h"

namespace shatterpave::scene {

namespace {

using glass::GlassKind;
using glass::Impact;
using paving::Bending;

template <typename Facts>
struct Rule {
  std::string_view key;  // from the thing's table on
  bool (*is_idle)(const Facts&);
  std::string_view why;
};

// Whether the key lies in a table that is among those told.
bool is_within(std::string_view key, const std::vector<std::string_view>& told) {
  return std::ranges::any_of(told, [&](std::string_view table) {
    return key.starts_with(table) && (key.size() == table.size() || key[table.size()] == '.');
  });
}

template <typename Facts>
void tell_by(std::span<const Rule<Facts>> rules, const Facts& facts, std::vector<Note>& notes) {
  std::vector<std::string_view> told;
  for (const Rule<Facts>& rule : rules) {
    if (is_within(rule.key, told)) continue;
    const std::optional<Place> place = facts.table.place_of_given(rule.key);
    if (!place || !rule.is_idle(facts)) continue;
    add_note({*place, fmt::format("has no effect {}", rule.why)}, notes);
    told.push_back(rule.key);
  }
}

struct PaneFacts {
  const TomlTable& table;
  const glass::Pane& pane;

  bool has(std::string_view key) const { return table.place_of_given(key).has_value(); }
  bool is_tempered() const { return pane.glass == GlassKind::tempered; }
  bool is_laminated() const { return pane.glass == GlassKind::laminated; }
  bool is_real() const { return pane.pattern == glass::Pattern::real; }
  bool all_impacts(bool (*is_so)(const Impact&)) const { return std::ranges::all_of(pane.impacts, is_so); }
};

constexpr std::string_view beside_tempered = "beside glass = \"tempered\"";
constexpr std::string_view beside_real = "beside pattern = \"real\"";
constexpr std::string_view without_real = "without pattern = \"real\"";
constexpr std::string_view beside_shards = "beside [pane.shards]";
constexpr std::string_view without_ring_cracks = "without ring cracks: circular_count is 0, or radial_count too low for them";
constexpr std::string_view beside_few_radials = "beside a radial_count up to circular_threshold";
constexpr std::string_view beside_no_bevels = "beside bevel_mm = 0, which leaves edges sharp";
constexpr std::string_view beside_preset_counts = "beside radial_count, mean_radial_count or preset";

bool on_tempered(const PaneFacts& f) { return f.is_tempered(); }
bool on_real(const PaneFacts& f) { return f.is_real(); }
bool with_shards(const PaneFacts& f) { return f.pane.shards.has_value(); }
bool with_counts(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.radial_count.has_value(); });
}
bool with_counts_or_means(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.radial_count || i.mean_radial_count; });
}
bool with_large_counts(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.large_count.has_value(); });
}
bool with_ring_counts(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.circular_count.has_value(); });
}
// By what the scene says of counts. Where M is drawn, rings may start.
bool without_ring_starts(const PaneFacts& f) {
  return std::ranges::all_of(f.pane.impacts, [&](const Impact& i) {
    const bool is_known = i.circular_count || i.radial_count;
    return is_known && glass::drawn_counts(i, f.pane.growth, 0, Id("impact")).circular_count == 0;
  });
}
bool within_threshold(const PaneFacts& f) {
  return std::ranges::all_of(f.pane.impacts, [&](const Impact& i) {
    return i.circular_count || (i.radial_count && *i.radial_count <= f.pane.growth.circular_threshold);
  });
}
bool is_hit_once(const PaneFacts& f) { return f.pane.impacts.size() == 1; }
bool without_spread(const PaneFacts& f) { return f.pane.growth.spread_limit == 0.0; }
bool without_rings(const PaneFacts& f) { return f.pane.rings.count == 0; }
bool all_interrupted(const PaneFacts& f) { return f.pane.rings.interruption == 1.0; }
bool without_bevels(const PaneFacts& f) { return f.pane.shards && f.pane.shards->bevel_mm == 0.0; }
bool none_missing(const PaneFacts& f) { return f.pane.shards && f.pane.shards->missing == 0.0; }
bool none_fallen(const PaneFacts& f) { return f.pane.shards && f.pane.shards->fallen == 0.0; }

const std::vector<Rule<PaneFacts>> pane_rules = {
    {"preset",
     [](const PaneFacts& f) {
       return f.is_tempered() && f.has("impact") && (f.has("size_mm") || f.has("outline_mm") || f.has("outline_file"));
     },
     beside_tempered},
    {"pattern", on_tempered, beside_tempered},
    {"growth", on_tempered, beside_tempered},
    {"rings", on_tempered, beside_tempered},
    {"rings", [](const PaneFacts& f) { return !f.is_real(); }, without_real},
    {"crater", on_tempered, beside_tempered},
    {"crater", [](const PaneFacts& f) { return f.is_laminated(); }, "beside glass = \"laminated\""},
    {"crater", [](const PaneFacts& f) { return !f.is_real(); }, without_real},
    {"laminate", [](const PaneFacts& f) { return !f.is_laminated(); }, "without glass = \"laminated\""},
    {"tempering", [](const PaneFacts& f) { return !f.is_tempered(); }, "without glass = \"tempered\""},
    {"crack_body", with_shards, beside_shards},
    {"crack_sheet", with_shards, beside_shards},
    {"crack_sheet.depth", on_tempered, beside_tempered},
    {"growth.spread", without_spread, "beside spread_limit = 0"},
    {"growth.spread_deviation", without_spread, "beside spread_limit = 0"},
    {"growth.spread_deviation", [](const PaneFacts& f) { return f.pane.growth.spread == glass::Spread::uniform; },
     "beside spread = \"uniform\""},
    {"growth.circular_speed_px", on_real, beside_real},
    {"growth.circular_speed_px", without_ring_starts, without_ring_cracks},
    {"growth.circular_threshold", on_real, beside_real},
    {"growth.circular_threshold", with_ring_counts, "beside circular_count or preset"},
    {"growth.circular_slope", on_real, beside_real},
    {"growth.circular_slope", with_ring_counts, "beside circular_count or preset"},
    {"growth.circular_slope", within_threshold, beside_few_radials},
    {"growth.circular_offset", on_real, beside_real},
    {"growth.circular_offset", with_ring_counts, "beside circular_count or preset"},
    {"growth.circular_offset", within_threshold, beside_few_radials},
    {"growth.ring_radius_slope_mm", on_real, beside_real},
    {"growth.ring_radius_slope_mm", without_ring_starts, without_ring_cracks},
    {"growth.ring_radius_offset_mm", on_real, beside_real},
    {"growth.ring_radius_offset_mm", without_ring_starts, without_ring_cracks},
    {"growth.ring_pull", on_real, beside_real},
    {"growth.ring_pull", without_ring_starts, without_ring_cracks},
    {"growth.ring_onset", on_real, beside_real},
    {"growth.ring_onset", without_ring_starts, without_ring_cracks},
    // Radials do not see those of their own impact (see crack_before of growth.cpp).
    {"growth.crack_gain_px2", [](const PaneFacts& f) { return is_hit_once(f) && f.is_real(); },
     "beside pattern = \"real\" and a single impact"},
    {"growth.crack_gain_px2", [](const PaneFacts& f) { return is_hit_once(f) && without_ring_starts(f); },
     "on the radial cracks of a single impact"},
    {"growth.large_slope", with_large_counts, "beside large_count or preset"},
    {"growth.large_offset", with_large_counts, "beside large_count or preset"},
    {"growth.large_deviation", with_large_counts, "beside large_count or preset"},
    {"growth.large_rounding", with_large_counts, "beside large_count or preset"},
    {"growth.reference_radial_count", with_counts_or_means, beside_preset_counts},
    {"growth.energy_exponent", with_counts_or_means, beside_preset_counts},
    {"growth.energy_exponent",
     [](const PaneFacts& f) {
       return f.all_impacts([](const Impact& i) {
         return i.ball_diameter_mm == Impact{}.ball_diameter_mm && i.speed_m_s == Impact{}.speed_m_s;
       });
     },
     "without another ball_diameter_mm or speed_m_s"},
    {"growth.count_law", with_counts, "beside radial_count or preset"},
    {"growth.count_law", [](const PaneFacts& f) { return f.has("growth.count_dispersion"); }, "beside count_dispersion"},
    {"growth.count_dispersion", with_counts, "beside radial_count or preset"},
    {"growth.branch_angle_deg", [](const PaneFacts& f) { return f.pane.growth.branch_rate_per_m == 0.0; },
     "without branch_rate_per_m"},
    {"rings.first_radius_mm", without_rings, "beside count = 0"},
    {"rings.ratio", without_rings, "beside count = 0"},
    {"rings.spread", without_rings, "beside count = 0"},
    {"rings.interruption", without_rings, "beside count = 0"},
    {"rings.bow", without_rings, "beside count = 0"},
    {"rings.count", all_interrupted, "beside interruption = 1"},
    {"rings.first_radius_mm", all_interrupted, "beside interruption = 1"},
    {"rings.ratio", all_interrupted, "beside interruption = 1"},
    {"rings.spread", all_interrupted, "beside interruption = 1"},
    {"rings.bow", all_interrupted, "beside interruption = 1"},
    {"tempering.surface_stress_mpa", [](const PaneFacts& f) { return f.pane.tempering.count_per_square.has_value(); },
     "beside count_per_square"},
    {"shards.chip_mm", [](const PaneFacts& f) { return f.pane.shards && f.pane.shards->chips_per_m == 0.0; },
     "beside chips_per_m = 0"},
    {"shards.chips_per_m", [](const PaneFacts& f) { return f.pane.shards && f.pane.shards->chip_mm == 0.0; },
     "beside chip_mm = 0"},
    {"shards.chip_mm", without_bevels, beside_no_bevels},
    {"shards.chips_per_m", without_bevels, beside_no_bevels},
    {"shards.missing_mm", none_missing, "beside missing = 0"},
    {"shards.throw_m_s", none_fallen, "beside fallen = 0"},
};

struct ImpactFacts {
  const TomlTable& table;  // of the impact
  const PaneFacts& pane;
  const Impact& impact;  // with what a preset sets
  std::size_t index;

  bool has_crater() const { return pane.is_real() || pane.is_laminated(); }
};

bool struck_tempered(const ImpactFacts& f) { return f.pane.is_tempered(); }
bool by_count(const ImpactFacts& f) { return !f.has_crater() && (f.impact.radial_count || f.impact.mean_radial_count); }
bool on_shards(const ImpactFacts& f) { return f.pane.pane.shards.has_value(); }

const std::vector<Rule<ImpactFacts>> impact_rules = {
    {"mean_radial_count", struck_tempered, beside_tempered},
    {"radial_count", struck_tempered, beside_tempered},
    {"large_count", struck_tempered, beside_tempered},
    {"circular_count", struck_tempered, beside_tempered},
    {"circular_count", [](const ImpactFacts& f) { return f.pane.is_real(); }, beside_real},
    {"ball_diameter_mm", struck_tempered, beside_tempered},
    {"ball_diameter_mm", by_count, beside_preset_counts},
    {"speed_m_s", struck_tempered, beside_tempered},
    {"speed_m_s", by_count, beside_preset_counts},
    {"hole_mm", on_shards, beside_shards},
    {"spall_mm", on_shards, beside_shards},
    {"spall_mm", [](const ImpactFacts& f) { return f.impact.hole_mm == 0.0; }, "without hole_mm"},
};

struct PavementFacts {
  const TomlTable& table;
  const paving::Pavement& pavement;
  bool is_flight;

  bool has(std::string_view key) const { return table.place_of_given(key).has_value(); }
  // What is laid: a flight is of rows, running ones unless told.
  const paving::BondType& bond() const {
    const paving::BondType& type = paving::type_of(pavement);
    return is_flight && type.bending != Bending::rows ? paving::type_of(paving::Bond::running) : type;
  }
  template <typename Kind>
  bool runs() const {
    return std::holds_alternative<Kind>(pavement.direction);
  }
  bool is_straight() const { return runs<paving::ConstantDirection>(); }
  bool has_body() const { return pavement.body.finish != paving::Finish::none; }
};

bool in_a_flight(const PavementFacts& f) { return f.is_flight; }
bool with_body(const PavementFacts& f) { return f.has_body(); }
bool without_guides(const PavementFacts& f) { return !f.runs<paving::GuidesDirection>(); }
bool without_kerb(const PavementFacts& f) { return f.pavement.kerb.width_mm == 0.0; }
bool without_joints(const PavementFacts& f) { return f.pavement.joint_mm == 0.0; }
bool none_laid(const PavementFacts& f) { return f.pavement.variation.missing == 1.0; }

constexpr std::string_view beside_finish = "beside finish";
constexpr std::string_view beside_steps = "beside [pavement.steps]";
constexpr std::string_view without_guides_kind = "without kind = \"guides\"";
constexpr std::string_view without_kerb_width = "without kerb_width_mm";
constexpr std::string_view without_a_joint = "beside joint_mm = 0, which leaves stones no room";
constexpr std::string_view beside_none_laid = "beside missing = 1, which leaves no stone";

// With the names of the bonds that differ from the one that is laid.
std::string of_bonds(std::string_view word, bool (*is_so)(const paving::BondType&)) {
  return fmt::format("{} bond = \"{}\"", word, fmt::join(paving::names_of_bonds(is_so), "\" or \""));
}
const std::string without_offset = of_bonds("without", [](const paving::BondType& type) -> bool { return type.takes_offset; });
const std::string without_span = of_bonds("without", [](const paving::BondType& type) -> bool { return type.takes_span; });
const std::string beside_packed =
    of_bonds("beside", [](const paving::BondType& type) { return type.bending == Bending::packed; });

const std::vector<Rule<PavementFacts>> pavement_rules = {
    {"stone_preset", [](const PavementFacts& f) { return f.has("stone_mm") && f.has("joint_mm"); },
     "beside stone_mm and joint_mm"},
    {"bond_offset", [](const PavementFacts& f) { return !f.bond().takes_offset; }, without_offset},
    {"bond_turn_deg",
     [](const PavementFacts& f) { return f.bond().bending == Bending::packed && !f.pavement.textures.seamless; },
     beside_packed},
    {"bond_turn_deg", [](const PavementFacts& f) { return !f.is_straight() && f.bond().bending == Bending::rows; },
     "on rows that follow the direction"},
    {"bond_span_mm", [](const PavementFacts& f) { return !f.bond().takes_span; }, without_span},
    {"border_stone_mm", [](const PavementFacts& f) { return f.pavement.border.course == paving::BorderCourse::none; },
     "without border_course"},
    {"direction.angle_deg", [](const PavementFacts& f) { return !f.is_straight(); }, "without kind = \"constant\""},
    {"direction.centre_mm", [](const PavementFacts& f) { return !f.runs<paving::RadialDirection>(); },
     "without kind = \"radial\""},
    {"direction.centre_mm", [](const PavementFacts& f) { return f.bond().bending == Bending::straight; },
     "on a bond that cannot bend"},
    {"direction.guides_mm", without_guides, without_guides_kind},
    {"direction.guides_file", without_guides, without_guides_kind},
    {"direction.guides_feature", without_guides, without_guides_kind},
    {"direction.guides_class", without_guides, without_guides_kind},
    {"variation", in_a_flight, beside_steps},
    {"surface.inset", with_body, beside_finish},
    {"surface.inset", in_a_flight, beside_steps},
    {"surface.inset_spread", with_body, beside_finish},
    {"surface.inset_spread", in_a_flight, beside_steps},
    {"surface.inset_spread", [](const PavementFacts& f) { return f.pavement.surface.inset == 0.0; }, "beside inset = 0"},
    {"surface.height_spread", in_a_flight, beside_steps},
    {"surface.height_spread", [](const PavementFacts& f) { return f.pavement.surface.height_mm == 0.0; },
     "beside height_mm = 0"},
    {"surface.chips_per_m", [](const PavementFacts& f) { return f.pavement.body.arris == paving::Arris::chamfered; },
     "on chamfered arrises"},
    {"variation.size", none_laid, beside_none_laid},
    {"variation.size", without_joints, without_a_joint},
    {"variation.rotation_deg", none_laid, beside_none_laid},
    {"variation.rotation_deg", without_joints, without_a_joint},
    {"variation.offset_mm", none_laid, beside_none_laid},
    {"variation.offset_mm", without_joints, without_a_joint},
    {"variation.sink_mm", none_laid, beside_none_laid},
    {"variation.tilt_deg", none_laid, beside_none_laid},
    {"relief", [](const PavementFacts& f) { return f.is_flight && !f.has_body(); }, "beside [pavement.steps] without a finish"},
    {"relief.hurst", [](const PavementFacts& f) { return f.pavement.relief.rms_mm == 0.0; }, "beside rms_mm = 0"},
    {"ground.fall_deg", [](const PavementFacts& f) { return f.pavement.ground.fall_percent == 0.0; }, "without fall_percent"},
    {"ground.settlement_mm", in_a_flight, beside_steps},
    {"ground.settlement_length_mm", in_a_flight, beside_steps},
    {"ground.settlement_length_mm", [](const PavementFacts& f) { return f.pavement.ground.settlement_mm == 0.0; },
     "without settlement_mm"},
    {"ground.kerb_length_mm", without_kerb, without_kerb_width},
    {"ground.kerb_height_mm", without_kerb, without_kerb_width},
    {"detail.mesh_mm", [](const PavementFacts& f) { return f.pavement.detail && f.pavement.detail->close_mm == 0.0; },
     "without close_mm"},
};

// Whether a plan of that kind is taken anywhere in the scene.
struct SceneFacts {
  const TomlTable& table;

  bool has_pane() const { return table.has("pane"); }
  bool takes_plan(bool svg) const { return takes_plan(table.node(), svg); }

 private:
  static bool takes_plan(const toml::node& node, bool svg);
};

bool is_svg(std::string_view name) {
  constexpr std::string_view ending = ".svg";
  if (name.size() < ending.size()) return false;
  const std::string_view end = name.substr(name.size() - ending.size());
  return std::ranges::equal(end, ending, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

bool SceneFacts::takes_plan(const toml::node& node, bool svg) {
  if (const toml::array* array = node.as_array()) {
    return std::ranges::any_of(*array,
                               [&](const toml::node& element) { return element.is_table() && takes_plan(element, svg); });
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) return false;
  for (const auto& [key, value] : *table) {
    const auto* name = value.as_string();
    if (name != nullptr && key.str().ends_with("_file") && is_svg(name->get()) == svg) return true;
    if (takes_plan(value, svg)) return true;
  }
  return false;
}

const std::vector<Rule<SceneFacts>> scene_rules = {
    {"still.dispersion", [](const SceneFacts& f) { return !f.has_pane(); }, "without a pane"},
    {"still.caustics", [](const SceneFacts& f) { return !f.has_pane(); }, "without a pane"},
    {"plan.origin", [](const SceneFacts& f) { return !f.takes_plan(false); }, "without a plan in GeoJSON"},
    {"plan.svg_scale", [](const SceneFacts& f) { return !f.takes_plan(true); }, "without a plan in SVG"},
};

}  // namespace

void tell_idle_keys(const TomlTable& table, const glass::Pane& pane, std::vector<Note>& notes) {
  const PaneFacts facts{table, pane};
  tell_by<PaneFacts>(pane_rules, facts, notes);
  const std::vector<TomlTable> impacts = table.tables("impact", pane.impacts.size(), impact_keys);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    if (i > 0 && facts.is_tempered()) {
      add_note({impacts[i].place(), "has no effect on tempered glass, which breaks at its first impact"}, notes);
      continue;
    }
    tell_by<ImpactFacts>(impact_rules, {impacts[i], facts, pane.impacts[i], i}, notes);
  }
}

void tell_idle_keys(const TomlTable& table, const paving::Pavement& pavement, bool is_flight, std::vector<Note>& notes) {
  tell_by<PavementFacts>(pavement_rules, {table, pavement, is_flight}, notes);
}

void tell_idle_keys(const TomlTable& root, std::vector<Note>& notes) { tell_by<SceneFacts>(scene_rules, {root}, notes); }

}  // namespace shatterpave::scene
