// Every key of the scene file has an effect somewhere, and where one that is given has none, it is told.
//
// A key is tried in many surroundings: it is given one value and then another, and all that every target writes is compared.
// Where the bytes are the same, the scene must have a note at the key (or refuse the value); where they are not, there must be
// none.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "export/povray/povray.h"
#include "export/svg/drawing_svg.h"
#include "export/textures/textures.h"
#include "pipeline/generate.h"
#include "scene/keys.h"
#include "scene/read_scene.h"

namespace shatterpave::pipeline {
namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void take(std::vector<exporting::OutputFile> made, Files& files) {
  for (exporting::OutputFile& file : made) files[file.name] = std::move(file.content);
}

// What every target writes of the scene.
Files written(const scene::Scene& scene) {
  const exporting::Model model = generated(scene);
  Files files;
  take(exporting::povray::povray_files(model), files);
  take({exporting::json_file(model)}, files);
  take(exporting::svg_files(model), files);
  const auto has_shards = [](const exporting::BrokenPane& broken) { return broken.pane.shards.has_value(); };
  if (std::ranges::any_of(model.panes, has_shards)) take(exporting::obj_files(model), files);
  std::string pattern = (fs::temp_directory_path() / "key-effects-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder");
  for (const exporting::FileSet& set : exporting::textures::texture_files(model)) {
    set.write(pattern);
    for (const std::string& name : set.names) files[name] = text_of(fs::path(pattern) / name);
  }
  fs::remove_all(pattern);
  return files;
}

struct Change {
  std::string key;  // as --set takes it
  std::string one;
  std::string other;
};

// Lines of a scene: the key is set in these.
struct Surroundings {
  std::string name;
  std::vector<std::string> sets;  // KEY=VALUE
};

scene::Scene scene_with(const std::string& text, const std::vector<std::string>& sets, const fs::path& file) {
  std::vector<scene::Override> overrides;
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    overrides.push_back({"--set " + set, set.substr(0, equals), set.substr(equals + 1)});
  }
  return scene::scene_of_text(text, file, overrides);
}

// What became of a key in its surroundings.
struct Outcome {
  bool refused = false;
  bool has_effect = false;
  std::string told;
};

// The notes at the key or at a table that it lies in.
std::string told_of(const scene::Scene& scene, const std::string& key) {
  for (const Note& note : scene.notes) {
    if (key.starts_with(note.place.key) && note.what.find("has no effect") != std::string::npos) return note.what;
  }
  return {};
}

Outcome outcome(const std::string& text, const Surroundings& around, const Change& change, const fs::path& file = "keys.toml") {
  Outcome result;
  std::vector<std::string> sets = around.sets;
  sets.push_back(change.key + "=" + change.one);
  try {
    const scene::Scene first = scene_with(text, sets, file);
    sets.back() = change.key + "=" + change.other;
    const scene::Scene second = scene_with(text, sets, file);
    result.told = told_of(second, change.key);
    result.has_effect = written(first) != written(second);
  } catch (const InputError&) {
    result.refused = true;
  }
  return result;
}

// Keys that are told although bytes change: of these, JSON repeats what the scene says, but nothing is made of it.
using Exceptions = std::set<std::pair<std::string, std::string>>;  // surroundings, key; "" for all

void expect_effect_or_word(const std::string& text, const std::vector<Surroundings>& surroundings,
                           const std::vector<Change>& changes, std::set<std::string>& alive,
                           const Exceptions& exceptions = {}) {
  for (const Surroundings& around : surroundings) {
    for (const Change& change : changes) {
      const std::string set_key = change.key + "=";
      const auto is_of_it = [&](const std::string& set) { return set.starts_with(set_key); };
      if (std::ranges::any_of(around.sets, is_of_it)) continue;
      const Outcome result = outcome(text, around, change);
      if (result.has_effect) alive.insert(change.key);
      if (result.refused || exceptions.contains({around.name, change.key}) || exceptions.contains({"", change.key})) continue;
      EXPECT_EQ(result.has_effect, result.told.empty())
          << around.name << ": " << change.key << " = " << change.one << " or " << change.other
          << (result.has_effect ? " changes files, but is told: " + result.told : " changes nothing, and nothing is told");
    }
  }
}

const std::string one_pane = R"(seed = 3
[[pane]]
name = "w"
size_mm = [90, 70]
[[pane.impact]]
at_mm = [40, 33]
[pane.growth]
step_length_px = 8
)";

const std::vector<Change> pane_changes = {
    {"pane[0].thickness_mm", "3", "4"},
    {"pane[0].preset", "agui1992-fig15a", "agui1992-fig16d"},
    {"pane[0].glass", "annealed", "laminated"},
    {"pane[0].pattern", "agui1992", "real"},
    {"pane[0].crack_body", "cylinder", "sheet"},
    {"pane[0].impact[0].at_mm", "[40, 33]", "[50, 36]"},
    {"pane[0].impact[0].radial_count", "30", "40"},
    {"pane[0].impact[0].mean_radial_count", "30", "40"},
    {"pane[0].impact[0].large_count", "3", "9"},
    {"pane[0].impact[0].circular_count", "2", "6"},
    {"pane[0].impact[0].ball_diameter_mm", "10", "30"},
    {"pane[0].impact[0].speed_m_s", "3", "20"},
    {"pane[0].impact[0].hole_mm", "3", "5"},
    {"pane[0].impact[0].spall_mm", "8", "12"},
    {"pane[0].growth.spread", "normal", "uniform"},
    {"pane[0].growth.spread_limit", "0.1", "0.6"},
    {"pane[0].growth.spread_deviation", "0.1", "0.9"},
    {"pane[0].growth.large_speed_px", "20", "60"},
    {"pane[0].growth.radial_speed_px", "5", "20"},
    {"pane[0].growth.circular_speed_px", "5", "20"},
    {"pane[0].growth.sector_angle_deg", "60", "120"},
    {"pane[0].growth.sector_radius_px", "30", "70"},
    {"pane[0].growth.turn_limit_deg", "2", "40"},
    {"pane[0].growth.weight_time", "1", "100"},
    {"pane[0].growth.step_length_px", "6", "10"},
    {"pane[0].growth.reference_radial_count", "20", "50"},
    {"pane[0].growth.energy_exponent", "0.1", "1"},
    {"pane[0].growth.count_law", "poisson", "table1"},
    {"pane[0].growth.count_dispersion", "1", "40"},
    {"pane[0].growth.circular_threshold", "0", "1000"},
    {"pane[0].growth.circular_slope", "0.01", "0.9"},
    {"pane[0].growth.circular_offset", "1", "9"},
    {"pane[0].growth.large_slope", "0.01", "0.5"},
    {"pane[0].growth.large_offset", "1", "9"},
    {"pane[0].growth.large_deviation", "0", "5"},
    {"pane[0].growth.large_rounding", "down", "up"},
    {"pane[0].growth.ring_radius_slope_mm", "0.1", "0.3"},
    {"pane[0].growth.ring_radius_offset_mm", "3", "9"},
    {"pane[0].growth.tip_gain_px2", "1", "900"},
    {"pane[0].growth.crack_gain_px2", "1", "900"},
    {"pane[0].growth.sibling_gain_px2", "0", "-900"},
    {"pane[0].growth.edge_gain_px2", "1", "9000"},
    {"pane[0].growth.wander_deg", "1", "40"},
    {"pane[0].growth.turn_length_px", "2", "40"},
    {"pane[0].growth.radial_pull", "0", "4"},
    {"pane[0].growth.ring_pull", "0", "9"},
    {"pane[0].growth.ring_onset", "0", "9"},
    {"pane[0].growth.radial_onset", "0", "9"},
    {"pane[0].growth.branch_rate_per_m", "0", "90"},
    {"pane[0].growth.branch_angle_deg", "[10, 15]", "[40, 80]"},
    {"pane[0].rings.count", "2", "6"},
    {"pane[0].rings.first_radius_mm", "5", "9"},
    {"pane[0].rings.ratio", "1.3", "1.8"},
    {"pane[0].rings.spread", "0.1", "0.4"},
    {"pane[0].rings.interruption", "0", "0.5"},
    {"pane[0].rings.bow", "0", "1"},
    {"pane[0].crater.cone_deg", "30", "60"},
    {"pane[0].laminate.through", "0.1", "0.9"},
    {"pane[0].laminate.milky_width_mm", "5", "20"},
    {"pane[0].tempering.surface_stress_mpa", "90", "110"},
    {"pane[0].tempering.count_per_square", "40", "80"},
    {"pane[0].tempering.splinter_ratio", "2", "9"},
    {"pane[0].tempering.splinter_reach_mm", "10", "60"},
    {"pane[0].crack_sheet.tilt_deg", "10", "40"},
    {"pane[0].crack_sheet.curve_deg", "5", "30"},
    {"pane[0].crack_sheet.twist_mm", "5", "50"},
    {"pane[0].crack_sheet.opening_mm", "0.03", "0.09"},
    {"pane[0].crack_sheet.opening_variation", "0.1", "0.9"},
    {"pane[0].crack_sheet.depth", "[0.2, 0.3]", "[0.8, 0.9]"},
    {"pane[0].crack_sheet.relief", "0", "3"},
    {"pane[0].shards.gap_mm", "0.05", "0.2"},
    {"pane[0].shards.splinter_mm2", "1", "90"},
    {"pane[0].shards.bevel_mm", "0.1", "0.3"},
    {"pane[0].shards.chips_per_m", "20", "400"},
    {"pane[0].shards.chip_mm", "0.8", "3"},
    {"pane[0].shards.missing", "0.1", "0.9"},
    {"pane[0].shards.missing_mm", "10", "90"},
    {"pane[0].shards.held", "0.1", "0.9"},
    {"pane[0].shards.fallen", "0.1", "0.9"},
    {"pane[0].shards.throw_m_s", "0.1", "3"},
    {"pane[0].shards.sill_drop_mm", "5", "40"},
    {"pane[0].shards.sill_depth_mm", "40", "200"},
    {"pane[0].shards.frame_mm", "5", "30"},
    {"pane[0].shards.reveal_mm", "10", "90"},
    {"pane[0].shards.floor_drop_mm", "90", "900"},
    {"pane[0].shards.joined", "false", "true"},
    {"pane[0].shards.enabled", "true", "false"},
};

const std::string counted = "pane[0].impact[0].radial_count=24";
const std::string ringed = "pane[0].impact[0].circular_count=4";
const std::string real = "pane[0].pattern=real";
const std::string laminated = "pane[0].glass=laminated";
const std::string tempered = "pane[0].glass=tempered";
const std::string sheet = "pane[0].crack_body=sheet";
const std::string shards = "pane[0].shards={throw_m_s = 0.5}";

const std::vector<Surroundings> pane_surroundings = {
    {"ball", {"pane[0].growth.reference_radial_count=30"}},
    {"another ball", {"pane[0].growth.reference_radial_count=30", "pane[0].impact[0].speed_m_s=9"}},
    {"counted", {counted, ringed}},
    {"fully counted", {counted, ringed, "pane[0].impact[0].large_count=6"}},
    {"many", {"pane[0].impact[0].radial_count=90"}},
    {"mean", {"pane[0].impact[0].mean_radial_count=24"}},
    {"preset", {"pane[0].preset=agui1992-fig14a"}},
    {"no rings", {counted, "pane[0].impact[0].circular_count=0"}},
    {"no spread", {counted, ringed, "pane[0].growth.spread_limit=0"}},
    {"uniform", {counted, ringed, "pane[0].growth.spread=uniform"}},
    {"branches", {counted, "pane[0].growth.branch_rate_per_m=60"}},
    {"dispersed", {"pane[0].growth.reference_radial_count=30", "pane[0].growth.count_dispersion=10"}},
    {"real", {counted, real}},
    {"real, no rings", {counted, real, "pane[0].rings.count=0"}},
    {"real, one ring", {counted, real, "pane[0].rings.count=1"}},
    {"real, interrupted", {counted, real, "pane[0].rings.interruption=1"}},
    {"real sheets", {counted, real, sheet}},
    {"laminated", {counted, laminated}},
    {"laminated, the paper's", {counted, ringed, laminated, "pane[0].pattern=agui1992"}},
    {"laminated sheets", {counted, laminated, sheet}},
    {"tempered", {tempered}},
    {"tempered, counted", {tempered, "pane[0].tempering.count_per_square=50"}},
    {"tempered, no splinters", {tempered, "pane[0].tempering.splinter_ratio=1"}},
    {"tempered sheets", {tempered, sheet}},
    {"sheets", {counted, ringed, sheet}},
    {"sheets, upright", {counted, sheet, "pane[0].crack_sheet.tilt_deg=0"}},
    {"sheets, upright and straight", {counted, sheet, "pane[0].crack_sheet.tilt_deg=0", "pane[0].crack_sheet.curve_deg=0"}},
    {"sheets with a hole", {counted, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"real sheets with a hole", {counted, real, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"laminated sheets with a hole", {counted, laminated, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"tempered sheets with a hole", {tempered, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"shards", {counted, ringed, shards}},
    {"shards, whole", {counted, ringed, shards, "pane[0].shards.missing=0"}},
    {"shards, whole and joined", {counted, shards, "pane[0].shards.missing=0", "pane[0].shards.joined=true"}},
    {"shards, none fallen", {counted, shards, "pane[0].shards.fallen=0"}},
    {"shards, joined", {counted, shards, "pane[0].shards.joined=true"}},
    {"shards without chips", {counted, shards, "pane[0].shards.chips_per_m=0"}},
    {"shards with chips of no size", {counted, shards, "pane[0].shards.chip_mm=0"}},
    {"shards without bevels", {counted, shards, "pane[0].shards.bevel_mm=0"}},
    {"shards, sheets", {counted, shards, sheet}},
    {"shards, a hole", {counted, shards, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"shards, real", {counted, shards, real}},
    {"shards, laminated", {counted, shards, laminated}},
    {"shards, tempered", {shards, tempered}},
};

const std::string one_pavement = R"(seed = 3
[[pavement]]
name = "p"
outline_mm = [[0, 0], [620, 0], [650, 430], [80, 470]]
textures.size_px = 256
)";

const std::vector<Change> pavement_changes = {
    {"pavement[0].holes_mm", "[[[200, 200], [300, 200], [300, 300]]]", "[[[200, 200], [300, 200], [200, 300]]]"},
    {"pavement[0].stone_preset", "mosaic_sett", "small_sett"},
    {"pavement[0].stone_mm", "[100, 80]", "[90, 70]"},
    {"pavement[0].joint_mm", "5", "9"},
    {"pavement[0].bond", "running", "stack"},
    {"pavement[0].bond_offset", "0.2", "0.4"},
    {"pavement[0].bond_turn_deg", "10", "30"},
    {"pavement[0].bond_span_mm", "600", "900"},
    {"pavement[0].border_course", "soldier", "stretcher"},
    {"pavement[0].border_stone_mm", "[80, 40]", "[60, 50]"},
    {"pavement[0].material", "granite", "brick"},
    {"pavement[0].joint_fill", "sand", "mortar"},
    {"pavement[0].moss", "0.1", "0.9"},
    {"pavement[0].wetness", "0.2", "0.9"},
    {"pavement[0].direction.kind", "constant", "radial"},
    {"pavement[0].direction.angle_deg", "10", "30"},
    {"pavement[0].direction.centre_mm", "[10, -900]", "[900, 40]"},
    {"pavement[0].direction.guides_mm", "[[[0, 100], [600, 120]]]", "[[[0, 100], [300, 300], [600, 320]]]"},
    {"pavement[0].surface.height_mm", "5", "9"},
    {"pavement[0].surface.height_spread", "0.1", "0.9"},
    {"pavement[0].surface.inset", "0.05", "0.2"},
    {"pavement[0].surface.inset_spread", "0.1", "0.9"},
    {"pavement[0].surface.finish", "split", "river_worn"},
    {"pavement[0].surface.arris", "rounded", "chamfered"},
    {"pavement[0].surface.arris_mm", "3", "8"},
    {"pavement[0].surface.crown_mm", "1", "5"},
    {"pavement[0].surface.uneven_mm", "0", "4"},
    {"pavement[0].surface.wear_mm", "0", "4"},
    {"pavement[0].surface.chips_per_m", "1", "9"},
    {"pavement[0].variation.size", "0.1", "0.3"},
    {"pavement[0].variation.rotation_deg", "1", "9"},
    {"pavement[0].variation.offset_mm", "1", "3"},
    {"pavement[0].variation.sink_mm", "1", "4"},
    {"pavement[0].variation.missing", "0.1", "0.5"},
    {"pavement[0].variation.tilt_deg", "1", "4"},
    {"pavement[0].relief.rms_mm", "0.2", "0.9"},
    {"pavement[0].relief.hurst", "0.2", "0.9"},
    {"pavement[0].textures.size_px", "256", "300"},
    {"pavement[0].textures.area_mm", "[[0, 0], [300, 200]]", "[[50, 50], [300, 200]]"},
    {"pavement[0].textures.format", "png", "exr"},
    {"pavement[0].textures.seamless", "false", "true"},
    {"pavement[0].textures.tile_mm", "[900, 500]", "[1000, 600]"},
    {"pavement[0].ground.fall_percent", "1", "5"},
    {"pavement[0].ground.fall_deg", "10", "60"},
    {"pavement[0].ground.level_mm", "10", "60"},
    {"pavement[0].ground.settlement_mm", "10", "60"},
    {"pavement[0].ground.settlement_length_mm", "500", "900"},
    {"pavement[0].ground.kerb_width_mm", "50", "90"},
    {"pavement[0].ground.kerb_length_mm", "200", "500"},
    {"pavement[0].ground.kerb_height_mm", "20", "50"},
    {"pavement[0].steps.riser_mm", "100", "150"},
    {"pavement[0].steps.tread_mm", "150", "200"},
    {"pavement[0].detail.viewer_mm", "[0, -300]", "[0, -9000]"},
    {"pavement[0].detail.close_mm", "0", "150"},
    {"pavement[0].detail.mesh_mm", "8", "20"},
};

const std::string radial = "pavement[0].direction={kind = 'radial', centre_mm = [300, -900]}";
const std::string guided = "pavement[0].direction={kind = 'guides', guides_mm = [[[0, 100], [300, 200], [600, 120]]]}";
const std::string round_about = "pavement[0].direction.kind=boundary";
const std::string split = "pavement[0].surface.finish=split";

const std::vector<Surroundings> pavement_surroundings = {
    {"plain", {}},
    {"running", {"pavement[0].bond=running"}},
    {"stack", {"pavement[0].bond=stack"}},
    {"running, radial", {"pavement[0].bond=running", radial}},
    {"running, guided", {"pavement[0].bond=running", guided}},
    {"stack, boundary", {"pavement[0].bond=stack", round_about}},
    {"packed, radial", {radial}},
    {"packed, boundary", {round_about}},
    {"herringbone", {"pavement[0].bond=herringbone"}},
    {"basket weave, radial", {"pavement[0].bond=basket_weave", radial}},
    {"hexagon, guided", {"pavement[0].bond=hexagon", guided}},
    {"hexagon", {"pavement[0].bond=hexagon"}},
    {"segmental arc", {"pavement[0].bond=segmental_arc"}},
    {"fan", {"pavement[0].bond=fan"}},
    {"ashlar", {"pavement[0].bond=ashlar"}},
    {"crazy", {"pavement[0].bond=crazy"}},
    {"finish", {split}},
    {"sawn", {"pavement[0].surface.finish=flat_sawn"}},
    {"border", {"pavement[0].border_course=soldier"}},
    {"kerb", {"pavement[0].ground.kerb_width_mm=60"}},
    {"given stones", {"pavement[0].stone_mm=[90, 70]", "pavement[0].joint_mm=6"}},
    {"no joints", {"pavement[0].joint_mm=0"}},
    {"all missing", {"pavement[0].variation.missing=1"}},
    {"flat", {"pavement[0].surface.height_mm=0"}},
    {"no inset", {"pavement[0].surface.inset=0"}},
    {"polished", {"pavement[0].relief.rms_mm=0"}},
    {"polished finish", {split, "pavement[0].relief.rms_mm=0"}},
    {"sunk", {"pavement[0].ground.settlement_mm=9"}},
    {"falls", {"pavement[0].ground.fall_percent=3"}},
    {"near", {split, "pavement[0].detail={close_mm = 120, mesh_mm = 9}"}},
    {"far", {"pavement[0].detail.viewer_mm=[0, -2000]"}},
    {"tile", {"pavement[0].textures.seamless=true"}},
    {"steps", {"pavement[0].steps.tread_mm=150"}},
    {"steps, round", {"pavement[0].steps.tread_mm=150", radial}},
    {"steps in stack", {"pavement[0].steps.tread_mm=150", "pavement[0].bond=stack"}},
    {"steps about", {"pavement[0].steps.tread_mm=100", round_about}},
    {"wet", {"pavement[0].wetness=0.9", split}},
};

TEST(SceneKeys, OfAPaneHaveAnEffectOrAreTold) {
  std::set<std::string> alive;
  expect_effect_or_word(one_pane, pane_surroundings, pane_changes, alive);
  for (const Change& change : pane_changes)
    EXPECT_TRUE(alive.contains(change.key)) << change.key << " changes nothing anywhere";
}

TEST(SceneKeys, OfAPavementHaveAnEffectOrAreTold) {
  std::set<std::string> alive;
  expect_effect_or_word(one_pavement, pavement_surroundings, pavement_changes, alive);
  for (const Change& change : pavement_changes) {
    EXPECT_TRUE(alive.contains(change.key)) << change.key << " changes nothing anywhere";
  }
}

}  // namespace
}  // namespace shatterpave::pipeline
