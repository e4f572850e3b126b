#include "scene/read_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <variant>

#include "core/error.h"
#include "glass/presets.h"
#include "paving/bonds/table.h"
#include "paving/catalogue/finishes.h"
#include "paving/catalogue/stone_sizes.h"
#include "scene/draft.h"

namespace shatterpave::scene {
namespace {

// The example of the contract with users, word for word.
constexpr std::string_view contract_scene = R"(seed = 7

[[pane]]
name         = "window"
size_mm      = [300, 300]            # or outline_mm = [[x, y], …], any simple polygon
thickness_mm = 2.0
preset       = "agui1992-fig15a"     # optional; a key given beside it wins

[[pane.impact]]                      # one or more
at_mm             = [150, 150]
mean_radial_count = 105              # M_ave, drawn from Poisson; or radial_count = 113 for M itself

[[pavement]]
name       = "path"
outline_mm = [[0, 0], [4000, 0], [4000, 1200], [0, 1200]]
holes_mm   = [[[500, 500], [700, 500], [700, 700]]]
stone_mm   = [100, 100]              # the face of a whole stone; pitch = stone + joint
joint_mm   = 8
[pavement.direction]
kind      = "constant"               # constant | boundary | radial | guides
angle_deg = 0                        # constant: the axis of the rows, from +x
centre_mm = [0, 0]                   # radial: rows are circles about it
)";

Scene read(std::string_view text, const std::vector<Override>& overrides = {}) {
  return scene_of_text(text, "dir/s.toml", overrides);
}

std::string pane(const std::string& lines) { return "[[pane]]\nname = \"w\"\n" + lines; }
std::string path(const std::string& lines) { return "[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n" + lines; }

// Five lines are a window that a stone went through; what is given beside the preset wins.
TEST(ReadScene, APresetBreaksAWindow) {
  const std::string lines = "seed = 4\n[[pane]]\nname = \"window\"\nsize_mm = [500, 700]\npreset = \"stone-through-window\"\n";
  const glass::Pane window = read(lines).panes.at(0);
  EXPECT_EQ(window.pattern, glass::Pattern::real);
  EXPECT_EQ(window.thickness_mm, 4.0);
  ASSERT_TRUE(window.shards.has_value());
  EXPECT_TRUE(window.shards->leaning);
  EXPECT_EQ(window.crack_sheet.twist_mm, 40.0);
  ASSERT_EQ(window.impacts.size(), 1U);
  EXPECT_EQ(window.impacts[0].at_mm, (vec2{250.0, 350.0}));
  EXPECT_EQ(window.impacts[0].mean_radial_count, 30.0);
  EXPECT_EQ(window.impacts[0].large_count, 12);
  EXPECT_EQ(window.impacts[0].speed_m_s, 8.0);
  const glass::Pane other =
      read(lines + "thickness_mm = 6\nshards = {enabled = false}\nimpact = [{at_mm = [9, 9], radial_count = 12}]\n")
          .panes.at(0);
  EXPECT_EQ(other.thickness_mm, 6.0);
  EXPECT_FALSE(other.shards.has_value());
  EXPECT_EQ(other.impacts[0].radial_count, 12);
  EXPECT_FALSE(other.impacts[0].mean_radial_count.has_value());
  EXPECT_FALSE(other.impacts[0].large_count.has_value());
  EXPECT_EQ(other.impacts[0].ball_diameter_mm, 40.0);
}

TEST(ReadScene, UnderstandsTheContract) {
  const Scene scene = read(contract_scene);
  EXPECT_EQ(scene.name, "s");
  EXPECT_EQ(scene.seed, 7U);
  ASSERT_EQ(scene.panes.size(), 1U);
  const glass::Pane& window = scene.panes[0];
  EXPECT_EQ(window.name, "window");
  EXPECT_EQ(window.outline_mm, (geometry::Polygon{{0, 0}, {300, 0}, {300, 300}, {0, 300}}));
  EXPECT_EQ(window.thickness_mm, 2.0);
  ASSERT_EQ(window.impacts.size(), 1U);
  EXPECT_EQ(window.impacts[0].at_mm, vec2(150, 150));
  EXPECT_EQ(window.impacts[0].mean_radial_count, 105.0);
  EXPECT_EQ(window.growth, glass::preset("agui1992-fig15a")->growth);
  ASSERT_EQ(scene.pavements.size(), 1U);
  const paving::Pavement& paved = scene.pavements[0];
  EXPECT_EQ(paved.area.outline.size(), 4U);
  ASSERT_EQ(paved.area.holes.size(), 1U);
  EXPECT_EQ(paved.area.holes[0], (geometry::Polygon{{500, 500}, {700, 700}, {700, 500}}));  // clockwise
  EXPECT_EQ(paved.stone_mm, vec2(100, 100));
  EXPECT_EQ(paved.joint_mm, 8.0);
  EXPECT_EQ(paved.direction, paving::Direction(paving::ConstantDirection{}));
}

TEST(ReadScene, AnotherCountLeavesThePresetsOtherCountsToFollow) {
  const glass::Impact impact = read(contract_scene).panes[0].impacts[0];
  EXPECT_FALSE(impact.radial_count);
  EXPECT_FALSE(impact.large_count);
  EXPECT_FALSE(impact.circular_count);
}

TEST(ReadScene, PresetAloneIsThePapersExperiment) {
  const Scene scene = read(pane("preset = \"agui1992-fig15a\"\n"));
  const glass::Pane& window = scene.panes[0];
  EXPECT_EQ(window.outline_mm, (geometry::Polygon{{0, 0}, {300, 0}, {300, 300}, {0, 300}}));
  ASSERT_EQ(window.impacts.size(), 1U);
  EXPECT_EQ(window.impacts[0].at_mm, vec2(150, 150));
  EXPECT_EQ(window.impacts[0].radial_count, 114);
  EXPECT_EQ(window.impacts[0].large_count, 11);
  EXPECT_EQ(window.impacts[0].circular_count, 6);
}

TEST(ReadScene, KeyBesideThePresetWins) {
  const std::string text =
      "preset = \"agui1992-fig14a\"\ngrowth.large_speed_px = 55\n[[pane.impact]]\nat_mm = [10, 10]\nlarge_count = 3\n";
  const glass::Pane window = read(pane(text)).panes[0];
  EXPECT_EQ(window.growth.large_speed, 55.0);
  EXPECT_EQ(window.growth.radial_speed, glass::preset("agui1992-fig14a")->growth.radial_speed);
  EXPECT_EQ(window.impacts[0].radial_count, 113);
  EXPECT_EQ(window.impacts[0].large_count, 3);
  EXPECT_EQ(window.impacts[0].circular_count, 6);
}

TEST(ReadScene, DefaultsAreThoseOfTheTypes) {
  const Scene scene = read(path("") + pane("size_mm = [100, 50]\n[[pane.impact]]\nat_mm = [1, 2]\n"));
  EXPECT_EQ(scene.seed, 1U);
  EXPECT_EQ(scene.still, Still{});
  EXPECT_FALSE(scene.still.dispersion || scene.still.caustics);
  paving::Pavement pavement;
  pavement.name = "p";
  pavement.area = scene.pavements[0].area;
  EXPECT_EQ(scene.pavements[0], pavement);
  glass::Pane window;
  window.name = "w";
  window.outline_mm = scene.panes[0].outline_mm;
  window.impacts.resize(1);
  window.impacts[0].at_mm = {1, 2};
  EXPECT_EQ(scene.panes[0], window);
}

TEST(ReadScene, WindingClosingAndRepeatedPointsDoNotMatter) {
  const std::string impact = "[[pane.impact]]\nat_mm = [5, 2]\n";
  const auto outline = [&](const std::string& list) {
    return read(pane("outline_mm = " + list + "\n" + impact)).panes[0].outline_mm;
  };
  const geometry::Polygon expected = {{0, 0}, {9, 0}, {9, 9}};
  EXPECT_EQ(outline("[[0, 0], [9, 0], [9, 9]]"), expected);
  EXPECT_EQ(outline("[[0, 0], [9, 9], [9, 0]]"), expected);
  EXPECT_EQ(outline("[[0, 0], [9, 0], [9, 9], [0, 0]]"), expected);
  EXPECT_EQ(outline("[[0, 0], [0, 0.0004], [9, 0], [9, 0], [9.0003, 9], [0, 0], [0, 0]]"), expected);
}

TEST(ReadScene, EveryGrowthKeyReachesItsValue) {
  // Each key in turn, set to a value that is not its default: the result must differ from the default.
  const std::vector<std::string> keys = {
      "spread = \"uniform\"",    "spread_limit = 0.25",       "spread_deviation = 0.31",    "large_speed_px = 41",
      "radial_speed_px = 11",    "circular_speed_px = 12",    "sector_angle_deg = 90",      "sector_radius_px = 51",
      "turn_limit_deg = 29",     "weight_time = 11",          "step_length_px = 3",         "reference_radial_count = 90",
      "energy_exponent = 1",     "count_dispersion = 2",      "count_law = \"table1\"",     "circular_threshold = 71",
      "circular_slope = 0.06",   "circular_offset = 0.6",     "large_slope = 0.07",         "large_offset = 3.5",
      "large_deviation = 1",     "large_rounding = \"down\"", "ring_radius_slope_mm = 0.5", "ring_radius_offset_mm = 14",
      "tip_gain_px2 = 41",       "crack_gain_px2 = 61",       "sibling_gain_px2 = 1",       "edge_gain_px2 = 1501",
      "wander_deg = 8",          "ring_pull = 1.1",           "ring_onset = 2.1",           "law = \"printed\"",
      "time_step = 0.5",         "region = \"rectangle\"",    "region = \"circle\"",        "rectangle_length_px = 40",
      "rectangle_width_px = 40", "circle_radius_px = 40",     "enclosed_tips_stop = false"};
  const std::string base = "size_mm = [9, 9]\n[[pane.impact]]\nat_mm = [1, 1]\n[pane.growth]\n";
  std::vector<glass::Growth> seen = {glass::Growth{}};
  for (const std::string& key : keys) {
    const glass::Growth growth = read(pane(base + key + "\n")).panes[0].growth;
    for (const glass::Growth& other : seen) EXPECT_NE(growth, other) << key;
    seen.push_back(growth);
  }
  EXPECT_EQ(read(pane(base + "turn_limit_deg = 29\n")).panes[0].growth.turn_limit, Angle::degrees(29));
}

TEST(ReadScene, EveryShardsKeyReachesItsValue) {
  const std::vector<std::string> keys = {"gap_mm = 0.1",  "splinter_mm2 = 9", "bevel_mm = 0",        "chips_per_m = 1",
                                         "chip_mm = 2",   "missing = 0.5",    "missing_mm = 10",     "held = 0.4",
                                         "fallen = 0.1",  "throw_m_s = 1",    "sill_drop_mm = 20",   "sill_depth_mm = 90",
                                         "frame_mm = 20", "reveal_mm = 10",   "floor_drop_mm = 700", "joined = true"};
  const std::string base = "size_mm = [9, 9]\n[[pane.impact]]\nat_mm = [1, 1]\n";
  EXPECT_FALSE(read(pane(base)).panes[0].shards.has_value());
  EXPECT_FALSE(read(pane(base + "[pane.shards]\nenabled = false\n")).panes[0].shards.has_value());
  std::vector<glass::ShardRules> seen = {read(pane(base + "[pane.shards]\n")).panes[0].shards.value()};
  EXPECT_EQ(seen.front(), glass::ShardRules{});
  for (const std::string& key : keys) {
    const glass::ShardRules rules = read(pane(fmt::format("{}[pane.shards]\n{}\n", base, key))).panes[0].shards.value();
    for (const glass::ShardRules& other : seen) EXPECT_NE(rules, other) << key;
    seen.push_back(rules);
  }
}

TEST(ReadScene, EveryPavementKeyReachesItsValue) {
  const paving::Pavement p =
      read(path("stone_mm = [120, 80]\njoint_mm = 4\n[pavement.surface]\nheight_mm = 9\nheight_spread = 0.1\n"
                "inset = 0.2\ninset_spread = 0.4\n[pavement.relief]\nrms_mm = 0.3\nhurst = 0.5\n"
                "[pavement.textures]\nsize_px = 512\narea_mm = [[1, 2], [3, 5]]\nformat = \"tiled_exr\"\n"))
          .pavements[0];
  EXPECT_EQ(p.stone_mm, vec2(120, 80));
  EXPECT_EQ(p.joint_mm, 4.0);
  EXPECT_EQ(p.surface, (paving::StoneSurface{9, 0.1, 0.2, 0.4}));
  EXPECT_EQ(p.relief, (paving::Relief{0.3, 0.5}));
  paving::TextureSet textures;
  textures.size_px = 512;
  textures.area = geometry::Box{{1.0, 2.0}, {3.0, 5.0}};
  textures.format = paving::TextureFormat::tiled_exr;
  EXPECT_EQ(p.textures, textures);
}

TEST(ReadScene, StonePresetIsASizeThatKeysBesideItOverrule) {
  const auto preset = [](const std::string& lines) { return read(path(lines)).pavements[0]; };
  for (const paving::StonePreset& known : paving::stone_presets) {
    const paving::Pavement p = preset("stone_preset = \"" + std::string(known.name) + "\"\n");
    EXPECT_EQ(p.stone_mm, known.stone_mm) << known.name;
    EXPECT_EQ(p.joint_mm, known.joint_mm) << known.name;
  }
  const paving::Pavement wider = preset("stone_preset = \"brick\"\njoint_mm = 5\n");
  EXPECT_EQ(wider.stone_mm, vec2(200, 100));
  EXPECT_EQ(wider.joint_mm, 5.0);
}

TEST(ReadScene, ReadsTheVariation) {
  const paving::Pavement p = read(path("[pavement.variation]\nsize = 0.1\nrotation_deg = 3\noffset_mm = 2\nsink_mm = 4\n"
                                       "missing = 0.01\n"))
                                 .pavements[0];
  EXPECT_EQ(p.variation, (paving::Variation{0.1, Angle::degrees(3), 2, 4, 0.01, std::nullopt}));
}

TEST(ReadScene, FinishIsABodyThatKeysBesideItOverrule) {
  const auto finished = [](const std::string& lines) { return read(path("[pavement.surface]\n" + lines)).pavements[0]; };
  for (const paving::FinishPreset& known : paving::finish_presets) {
    const paving::Pavement p = finished("finish = \"" + std::string(known.name) + "\"\n");
    EXPECT_EQ(p.body, known.body) << known.name;
    EXPECT_EQ(p.surface.height_mm, known.height_mm) << known.name;
    EXPECT_EQ(p.surface.height_spread, known.height_spread) << known.name;
    EXPECT_EQ(p.variation.tilt, Angle::degrees(known.tilt_deg)) << known.name;
    EXPECT_EQ(p.relief, known.relief) << known.name;
  }
  const paving::Pavement p = finished(
      "finish = \"split\"\nheight_mm = 4\narris = \"chamfered\"\narris_mm = 3\ncrown_mm = 1\nuneven_mm = 0.5\nwear_mm = 6\n"
      "chips_per_m = 2\n[pavement.variation]\ntilt_deg = 2\n[pavement.relief]\nrms_mm = 0.4\n");
  EXPECT_EQ(p.body, (paving::StoneBody{paving::Finish::split, paving::Arris::chamfered, 3, 1, 0.5, 6, 2}));
  EXPECT_EQ(p.surface.height_mm, 4.0);
  EXPECT_EQ(p.variation.tilt, Angle::degrees(2));
  EXPECT_EQ(p.relief, (paving::Relief{0.4, 0.75}));
  EXPECT_EQ(read(path("")).pavements[0].body, paving::StoneBody{});
}

TEST(ReadScene, ReadsLookGroundAndDetail) {
  const paving::Pavement p =
      read(path("material = \"basalt\"\njoint_fill = \"mortar\"\nmoss = 0.2\nwetness = 0.7\n[pavement.ground]\n"
                "fall_percent = 2\nfall_deg = 90\nlevel_mm = 50\nsettlement_mm = 9\nsettlement_length_mm = 800\n"
                "kerb_width_mm = 120\nkerb_length_mm = 700\nkerb_height_mm = 80\n[pavement.detail]\nviewer_mm = [5, 6]\n"
                "close_mm = 700\nmesh_mm = 2\n"))
          .pavements[0];
  EXPECT_EQ(p.look, (paving::Look{paving::Material::basalt, paving::JointFill::mortar, 0.2, 0.7, {}}));
  EXPECT_EQ(p.ground, (paving::Ground{2, Angle::degrees(90), 50, 9, 800}));
  EXPECT_EQ(p.kerb, (paving::Kerb{120, 700, 80}));
  EXPECT_EQ(p.detail, (paving::Detail{{5, 6}, 700, 2}));
  const paving::Pavement plain = read(path("")).pavements[0];
  EXPECT_EQ(plain.look, paving::Look{});
  EXPECT_EQ(plain.ground, paving::Ground{});
  EXPECT_EQ(plain.kerb, paving::Kerb{});
  EXPECT_FALSE(plain.detail.has_value());
}

TEST(ReadScene, ReadsAFlightOfSteps) {
  const auto flight = [](const std::string& lines) { return read(path(lines)).pavements.at(0).flight; };
  EXPECT_EQ(flight("[pavement.steps]\nriser_mm = 160\ntread_mm = 400\n"), (paving::Flight{160, 400}));
  EXPECT_EQ(flight("[pavement.steps]\n"), (paving::Flight{150, 350})) << "if nothing is said";
  EXPECT_FALSE(flight("").has_value());
}

TEST(ReadScene, ReadsTheBorderCourse) {
  const auto border = [](const std::string& lines) { return read(path(lines)).pavements[0].border; };
  EXPECT_EQ(border(""), paving::Border{});
  EXPECT_EQ(border("border_course = \"soldier\"\n").course, paving::BorderCourse::soldier);
  EXPECT_EQ(border("border_course = \"stretcher\"\nborder_stone_mm = [240, 60]\n"),
            (paving::Border{paving::BorderCourse::stretcher, {240, 60}}));
}

TEST(ReadScene, ReadsEveryBond) {
  const auto bonding = [](const std::string& lines) { return read(path(lines)).pavements[0].bonding; };
  EXPECT_EQ(bonding(""), paving::Bonding{});
  EXPECT_EQ(bonding("bond = \"running\"\nbond_offset = 0.25\nbond_turn_deg = 45\nbond_span_mm = 900\n"),
            (paving::Bonding{paving::Bond::running, 0.25, Angle::degrees(45), 900.0}));
  for (const paving::BondType* type : paving::bond_types()) {
    const std::string line = fmt::format("bond = \"{}\"\n", std::string_view(type->name));
    if (type->is_for_scenes && !type->takes_module) {  // that needs a file (module_section_test.cpp)
      EXPECT_EQ(bonding(line).bond, type->id) << line;
    } else {
      EXPECT_THROW(bonding(line), InputError) << line;
    }
  }
}

TEST(ReadScene, ReadsEveryKindOfDirection) {
  const auto direction = [](const std::string& lines) {
    return read(path("[pavement.direction]\n" + lines)).pavements[0].direction;
  };
  EXPECT_EQ(direction("angle_deg = 30\n"), paving::Direction(paving::ConstantDirection{Angle::degrees(30)}));
  EXPECT_EQ(direction("kind = \"boundary\"\n"), paving::Direction(paving::BoundaryDirection{}));
  EXPECT_EQ(direction("kind = \"radial\"\ncentre_mm = [5, 6]\n"), paving::Direction(paving::RadialDirection{{5, 6}}));
  EXPECT_EQ(direction("kind = \"guides\"\nguides_mm = [[[0, 0], [9, 0], [9, 9]]]\n"),
            paving::Direction(paving::GuidesDirection{{{{0, 0}, {9, 0}, {9, 9}}}}));
}

TEST(ReadScene, OverridesWinWhateverTheirPath) {
  const std::vector<Override> overrides = {
      {"--set", "seed", "9"},
      {"--set", "pane[0].thickness_mm", "3"},
      {"--set", "pane.\"window\".time_us", "40"},
      {"--set", "'camera'.at_mm", "[0, -500, 0]"},
      {"--set", "pane.window.size_mm[1]", "250"},
      {"--set", "pavement.path.joint_mm", "4"},
      {"--set", "pavement[0].relief.hurst", "0.5"},
      {"--set", "pane[0].preset", "agui1992-fig16b"},
      {"--set", "pane[0].impact[0].at_mm", "[20, 30]"},
  };
  const Scene scene = read(contract_scene, overrides);
  EXPECT_EQ(scene.seed, 9U);
  EXPECT_EQ(scene.panes[0].thickness_mm, 3.0);
  EXPECT_EQ(scene.panes[0].time_us, 40.0);
  EXPECT_EQ(scene.camera->at_mm, vec3(0, -500, 0));
  EXPECT_EQ(scene.panes[0].outline_mm[2], vec2(300, 250));
  EXPECT_EQ(scene.pavements[0].joint_mm, 4.0);
  EXPECT_EQ(scene.pavements[0].relief.hurst, 0.5);
  EXPECT_EQ(scene.panes[0].growth, glass::preset("agui1992-fig16b")->growth);
  EXPECT_EQ(scene.panes[0].impacts[0].at_mm, vec2(20, 30));
}

TEST(ReadScene, ADraftTakesNoKeyThatScenesHaveNot) {
  Draft draft(contract_scene, "s.toml");
  EXPECT_THROW(draft.set({"set", "pane[0].growth.speed_mm", "3"}), InputError);
  EXPECT_THROW(draft.append({"add", "panes", "{name = \"x\"}"}), InputError);
  EXPECT_THROW(draft.append({"add", "still", "{setting = \"own\"}"}), InputError);
  EXPECT_THROW(draft.append({"add", "pane[0].size_mm", "{x = 1}"}), InputError);
  EXPECT_EQ(draft.append({"add", "pane.window.impact", "{at_mm = [1, 2]}"}), "pane.window.impact[1]");
  EXPECT_EQ(draft.scene().panes[0].impacts.size(), 2U);
}

TEST(ReadScene, TakesTheShapeOfCracks) {
  const Scene scene = scene_of_text(R"(
[[pane]]
name = "plain"
size_mm = [300, 300]
impact = [{ at_mm = [150, 150] }]
[[pane]]
name = "sheets"
size_mm = [300, 300]
impact = [{ at_mm = [150, 150] }]
crack_body = "sheet"
crack_sheet = { tilt_deg = 20, twist_mm = 5, depth = [0.2, 0.4], relief = 0 }
)",
                                    "s.toml");
  EXPECT_EQ(scene.panes[0].crack_body, glass::CrackBody::cylinder);
  const glass::Pane& pane = scene.panes[1];
  EXPECT_EQ(pane.crack_body, glass::CrackBody::sheet);
  EXPECT_NEAR(pane.crack_sheet.tilt.degrees(), 20.0, 1e-12);
  EXPECT_EQ(pane.crack_sheet.twist_mm, 5.0);
  EXPECT_EQ(pane.crack_sheet.least_depth, 0.2);
  EXPECT_EQ(pane.crack_sheet.greatest_depth, 0.4);
  EXPECT_EQ(pane.crack_sheet.relief, 0.0);
  EXPECT_EQ(pane.crack_sheet.opening_mm, glass::CrackSheet().opening_mm);
}

TEST(ReadScene, ACameraBesideGlassIsTaken) {
  const std::string pane = "pane = [{name = \"w\", size_mm = [300, 300], thickness_mm = 2.0, impact = [{at_mm = [9, 9]}]}]\n";
  for (const char* at : {"[150, -1.1, 150]", "[150, 0, 301]", "[-1, 0, 150]", "[150, 1.1, 150]"}) {
    EXPECT_NO_THROW(scene_of_text(pane + "camera.at_mm = " + at, "s.toml")) << at;
  }
}

TEST(ReadScene, APlaceIsToldToHaveNoEffectOnStillsOfOtherSettings) {
  const std::string placed =
      "pane = [{name = \"w\", size_mm = [300, 300], place_turn_deg = 30, impact = [{at_mm = [9, 9]}]}]\n";
  const Scene other = scene_of_text(placed, "s.toml");
  ASSERT_EQ(other.notes.size(), 1U);
  EXPECT_EQ(located(other.notes[0]),
            "s.toml:1:61: pane[0].place_turn_deg: note: has no effect on stills but those of the setting \"own\"");
  EXPECT_TRUE(scene_of_text(placed + "still.setting = \"own\"", "s.toml").notes.empty());
}

// Each law of growth has keys that are nothing to the other.
TEST(ReadScene, KeysOfTheOtherLawAreToldToHaveNoEffect) {
  const auto notes = [](const std::string& keys, const std::string& more = "") {
    const std::string pane = "[[pane]]\nname = \"w\"\nsize_mm = [300, 300]\nimpact = [{at_mm = [9, 9]}]\n" + more;
    std::string told;
    for (const Note& note : scene_of_text(pane + "[pane.growth]\n" + keys, "s.toml").notes) told += located(note) + "\n";
    return told;
  };
  const std::string printed = "law = \"printed\"\n";
  for (const std::string key : {"step_length_px = 9", "turn_length_px = 9", "sibling_gain_px2 = 1", "radial_pull = 1",
                                "ring_onset = 1", "branch_rate_per_m = 1"}) {
    EXPECT_EQ(notes(key), "");
    const std::string name = key.substr(0, key.find(' '));
    EXPECT_NE(notes(printed + key).find("growth." + name + ": note: has no effect beside law = \"printed\""), std::string::npos)
        << name;
  }
  for (const std::string key : {"time_step = 2", "region = \"circle\"", "circle_radius_px = 9"}) {
    EXPECT_NE(notes(key).find("has no effect without law = \"printed\""), std::string::npos) << key;
    EXPECT_NE(notes(printed + key, "pattern = \"real\"\n").find("has no effect beside pattern = \"real\""), std::string::npos);
  }
  EXPECT_EQ(notes(printed + "region = \"circle\"\ncircle_radius_px = 9\ntime_step = 2"), "");
  EXPECT_EQ(notes(printed + "region = \"rectangle\"\nrectangle_length_px = 9\nrectangle_width_px = 9"), "");
  EXPECT_NE(notes(printed + "circle_radius_px = 9").find("has no effect without region = \"circle\""), std::string::npos);
  EXPECT_NE(notes(printed + "region = \"circle\"\nsector_radius_px = 9").find("has no effect beside another region"),
            std::string::npos);
  EXPECT_NE(notes(printed, "glass = \"tempered\"\n").find("has no effect beside glass = \"tempered\""), std::string::npos);
}

}  // namespace
}  // namespace shatterpave::scene
