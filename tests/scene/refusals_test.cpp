// Every kind of wrong scene, with its whole message: one line that names the place, what was expected and what was found.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/read_scene.h"

namespace shatterpave::scene {
namespace {

struct Case {
  std::string name;
  std::string text;
  std::string message;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for.
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

// A pane from its third line on, and a pavement.
std::string of_pane(const std::string& lines) {
  return "[[pane]]\nname = \"window\"\n" + lines + "\n[[pane.impact]]\nat_mm = [150, 150]\n";
}
std::string impact(const std::string& lines) {
  return "[[pane]]\nname = \"w\"\nsize_mm = [300, 300]\n[[pane.impact]]\n" + lines + "\n";
}
std::string of_path(const std::string& lines) { return "[[pavement]]\nname = \"path\"\n" + lines + "\n"; }

const std::string sized = "size_mm = [300, 300]\n";

std::string nested(const std::string& open, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += open;
  return text;
}

const std::string pane_key_names =
    "name, size_mm, outline_mm, outline_file, outline_feature, outline_class, outline_units, place_mm, place_turn_deg, "
    "thickness_mm, bow_mm, dirt, "
    "preset, impact, cracks_file, growth, shards, glass, pattern, rings, crater, laminate, tempering, crack_body, crack_sheet, "
    "time_us and crack_speed_m_s";

const std::vector<Case> cases = {
    // The file.
    {"empty", "", "s.toml: expected a [[pane]] or a [[pavement]], got neither"},
    {"only_seed", "seed = 3\n", "s.toml: expected a [[pane]] or a [[pavement]], got neither"},
    {"not_utf8", "seed = 1\nname = \"\xff\"\n", "s.toml:2:9: expected UTF-8 text, got the byte 0xff"},
    {"overlong_utf8", "# \xc0\xaf\n", "s.toml:1:3: expected UTF-8 text, got the byte 0xc0"},
    {"surrogate_utf8", "# \xed\xa0\x80\n", "s.toml:1:3: expected UTF-8 text, got the byte 0xed"},
    {"not_toml", "seed = \n",
     "s.toml:1:8: expected TOML, got an error: Error while parsing key-value pair: expected value, saw '\\n'"},
    {"key_twice", "seed = 1\nseed = 2\n", ""},
    {"deep_arrays", "seed = " + nested("[", 100'000), ""},
    {"deep_tables", nested("a.", 100'000) + "a = 1\n", "s.toml:1:130: expected at most 64 dots in a row of words, got more"},
    // Keys.
    {"unknown_key", "sed = 3\n" + of_pane(sized), "s.toml:1:1: sed: unknown key; did you mean seed?"},
    {"unknown_section", of_pane(sized) + "[[pavment]]\n", "s.toml:7:3: pavment: unknown key; did you mean pavement?"},
    {"unknown_nested_key", of_pane(sized + "  thicknes_mm = 3"),
     "s.toml:4:3: pane[0].thicknes_mm: unknown key; did you mean thickness_mm?"},
    {"unknown_glass", of_pane(sized + "glass = \"float\""),
     "s.toml:4:9: pane[0].glass: expected \"annealed\" or \"laminated\" or \"tempered\", got the text \"float\""},
    {"unknown_far_key", of_pane(sized + "colour = 3"), "s.toml:4:1: pane[0].colour: unknown key; there are " + pane_key_names},
    {"unknown_impact_key", impact("at_mm = [1, 1]\nspeed = 3"),
     "s.toml:6:1: pane[0].impact[0].speed: unknown key; did you mean speed_m_s?"},
    {"unknown_growth_key", of_pane(sized + "growth.sector_radius = 3"),
     "s.toml:4:8: pane[0].growth.sector_radius: unknown key; did you mean sector_radius_px?"},
    {"unknown_shards_key", of_pane(sized + "shards.gap = 3"),
     "s.toml:4:8: pane[0].shards.gap: unknown key; did you mean gap_mm?"},
    {"shards_gap_of_nothing", of_pane(sized + "shards.gap_mm = 0"),
     "s.toml:4:17: pane[0].shards.gap_mm: expected a number from 0.02 to 10, got 0"},
    {"shards_flag", of_pane(sized + "shards.enabled = 1"),
     "s.toml:4:18: pane[0].shards.enabled: expected true or false, got 1"},
    {"shards_joined", of_pane(sized + "shards.joined = \"yes\""),
     "s.toml:4:17: pane[0].shards.joined: expected true or false, got the text \"yes\""},
    {"floor_above_sill", of_pane(sized + "shards.floor_drop_mm = 24"),
     "s.toml:4:24: pane[0].shards.floor_drop_mm: expected a floor not above the sill, so 25 or more, got 24"},
    {"first_unknown_key", "zzz = 1\nyyy = 2\n" + of_pane(sized),
     "s.toml:1:1: zzz: unknown key; there are seed, plan, pane, pavement, still, camera, light and frames"},
    {"strange_key", "\"a\\nb\" = 1\n" + of_pane(sized),
     "s.toml:1:1: ?: unknown key; there are seed, plan, pane, pavement, still, camera, light and frames"},
    // Kinds of values.
    {"seed_text", "seed = \"7\"\n" + of_pane(sized),
     "s.toml:1:8: seed: expected a whole number from 0 to 9223372036854775807, got the text \"7\""},
    {"seed_negative", "seed = -1\n" + of_pane(sized),
     "s.toml:1:8: seed: expected a whole number from 0 to 9223372036854775807, got -1"},
    {"seed_fraction", "seed = 1.5\n" + of_pane(sized),
     "s.toml:1:8: seed: expected a whole number from 0 to 9223372036854775807, got 1.5"},
    {"pane_no_array", "pane = 3\n", "s.toml:1:8: pane: expected tables [[pane]], got 3"},
    {"pane_of_numbers", "pane = [3]\n", "s.toml:1:9: pane[0]: expected a table, got 3"},
    {"growth_no_table", of_pane(sized + "growth = true"),
     "s.toml:4:10: pane[0].growth: expected a table [pane[0].growth], got true"},
    {"name_number", "[[pane]]\nname = 3\n", "s.toml:2:8: pane[0].name: expected a text in quotes, got 3"},
    {"size_number", of_pane("size_mm = 300"), "s.toml:3:11: pane[0].size_mm: expected a point [x, y], got 300"},
    {"size_three", of_pane("size_mm = [1, 2, 3]"),
     "s.toml:3:11: pane[0].size_mm: expected a point [x, y], got a list of 3 values"},
    {"crack_body", of_pane(sized + "crack_body = \"tube\""),
     "s.toml:4:14: pane[0].crack_body: expected \"cylinder\" or \"sheet\", got the text \"tube\""},
    {"crack_sheet_alone", of_pane(sized + "crack_sheet = {tilt_deg = 10}"),
     "s.toml:4:15: pane[0].crack_sheet: expected crack_body = \"sheet\" beside it, got none"},
    {"crack_tilt", of_pane(sized + "crack_body = \"sheet\"\ncrack_sheet = {tilt_deg = 80}"),
     "s.toml:5:27: pane[0].crack_sheet.tilt_deg: expected a number from 0 to 70, got 80"},
    {"crack_depth", of_pane(sized + "crack_body = \"sheet\"\ncrack_sheet = {depth = [0.9, 0.2]}"),
     "s.toml:5:24: pane[0].crack_sheet.depth: expected [least, greatest], got the greater one first"},
    {"thickness_date", of_pane(sized + "thickness_mm = 2024-01-01"),
     "s.toml:4:16: pane[0].thickness_mm: expected a number from 0.1 to 1000, got a date or time"},
    // Numbers.
    {"nan", of_pane(sized + "thickness_mm = nan"),
     "s.toml:4:16: pane[0].thickness_mm: expected a number from 0.1 to 1000, got nan"},
    {"minus_nan", of_pane(sized + "thickness_mm = -nan"),
     "s.toml:4:16: pane[0].thickness_mm: expected a number from 0.1 to 1000, got nan"},
    {"infinity", of_pane(sized + "thickness_mm = inf"),
     "s.toml:4:16: pane[0].thickness_mm: expected a number from 0.1 to 1000, got inf"},
    {"thickness_zero", of_pane(sized + "thickness_mm = 0"),
     "s.toml:4:16: pane[0].thickness_mm: expected a number from 0.1 to 1000, got 0"},
    {"nan_coordinate", of_pane("outline_mm = [[0, 0], [nan, 0], [9, 9]]"),
     "s.toml:3:24: pane[0].outline_mm[1][0]: expected a number from -1000000 to 1000000, got nan"},
    {"far_coordinate", of_pane("outline_mm = [[0, 0], [2e6, 0], [9, 9]]"),
     "s.toml:3:24: pane[0].outline_mm[1][0]: expected a number from -1000000 to 1000000, got 2000000"},
    {"size_zero", of_pane("size_mm = [0, 300]"),
     "s.toml:3:12: pane[0].size_mm[0]: expected a number above 0 and of at most 1000000, got 0"},
    {"spread_limit_one", of_pane(sized + "growth.spread_limit = 1.0"),
     "s.toml:4:23: pane[0].growth.spread_limit: expected a number of at least 0 and below 1, got 1"},
    {"joint_infinite", of_path("size_mm = [9, 9]\njoint_mm = inf"),
     "s.toml:4:12: pavement[0].joint_mm: expected a number from 0 to 1000, got inf"},
    {"stone_tiny", of_path("size_mm = [9, 9]\nstone_mm = [0.5, 9]"),
     "s.toml:4:13: pavement[0].stone_mm[0]: expected a number from 1 to 100000, got 0.5"},
    // Names.
    {"no_name", "[[pane]]\n" + sized, "s.toml:1:1: pane[0].name: expected a name, got none"},
    {"empty_name", "[[pane]]\nname = \"\"\n" + sized,
     "s.toml:2:8: pane[0].name: expected 1 to 64 letters, digits, '_' and '-', the first a letter, got \"\""},
    {"name_with_slash", "[[pane]]\nname = \"a/b\"\n" + sized,
     "s.toml:2:8: pane[0].name: expected 1 to 64 letters, digits, '_' and '-', the first a letter, got \"a/b\""},
    {"name_with_newline", "[[pane]]\nname = \"a\\nb\"\n" + sized,
     "s.toml:2:8: pane[0].name: expected 1 to 64 letters, digits, '_' and '-', the first a letter, got \"a\\x0ab\""},
    {"name_digit_first", "[[pane]]\nname = \"1a\"\n" + sized,
     "s.toml:2:8: pane[0].name: expected 1 to 64 letters, digits, '_' and '-', the first a letter, got \"1a\""},
    {"name_twice", of_pane(sized) + of_pane(sized),
     "s.toml:8:8: pane[1].name: expected a name of its own, got that of pane[0]"},
    {"name_twice_across", of_pane(sized) + "[[pavement]]\nname = \"window\"\nsize_mm = [9, 9]\n",
     "s.toml:8:8: pavement[0].name: expected a name of its own, got that of pane[0]"},
    {"name_twice_but_for_case", of_pane(sized) + "[[pavement]]\nname = \"Window\"\nsize_mm = [9, 9]\n",
     "s.toml:8:8: pavement[0].name: expected a name of its own, got that of pane[0]"},
    // Outlines.
    {"no_outline", of_pane(""),
     "s.toml:1:1: pane[0].outline_mm: expected size_mm, outline_mm or outline_file, got none of them"},
    {"outline_twice", of_pane("size_mm = [9, 9]\noutline_mm = [[0, 0], [9, 0], [9, 9]]"),
     "s.toml:4:14: pane[0].outline_mm: expected one outline, got outline_mm beside size_mm"},
    {"outline_and_file", of_pane("outline_mm = [[0, 0], [9, 0], [9, 9]]\noutline_file = \"a.svg\""),
     "s.toml:4:16: pane[0].outline_file: expected one outline, got outline_file beside outline_mm"},
    {"feature_without_file", of_pane(sized + "outline_feature = 1"),
     "s.toml:4:19: pane[0].outline_feature: expected outline_file beside it, got none"},
    {"two_points", of_pane("outline_mm = [[0, 0], [9, 9], [0, 0]]"),
     "s.toml:3:14: pane[0].outline_mm: expected 3 or more distinct points, got 2"},
    {"points_within_a_micrometre", of_pane("outline_mm = [[0, 0], [0.0001, 0], [0, 0.0002]]"),
     "s.toml:3:14: pane[0].outline_mm: expected 3 or more distinct points, got 1"},
    {"no_area", of_pane("outline_mm = [[0, 0], [9, 9], [5, 5]]"),
     "s.toml:3:14: pane[0].outline_mm: expected a ring with an area, got 3 points that enclose none"},
    {"bow_tie", of_pane("outline_mm = [[0, 0], [10, 10], [10, 0], [0, 10]]"),
     "s.toml:3:14: pane[0].outline_mm: expected edges that do not cross, got edge 0 of the outline and edge 2 of the outline "
     "crossing "
     "at (5, 5)"},
    {"bow_tie_with_repeated_points", of_pane("outline_mm = [[0, 0], [0, 0], [10, 10], [10, 0], [10, 0], [0, 10], [0, 0]]"),
     "s.toml:3:14: pane[0].outline_mm: expected edges that do not cross, got edge 1 of the outline and edge 4 of the outline "
     "crossing "
     "at (5, 5)"},
    {"touches_itself", of_pane("outline_mm = [[0, 0], [10, 0], [10, 10], [5, 0], [0, 10]]"),
     "s.toml:3:14: pane[0].outline_mm: expected a ring that does not touch itself, got edge 0 of the outline and edge 3 of the "
     "outline "
     "meeting at (5, 0)"},
    {"holes_in_pane", of_pane(sized + "holes_mm = []"),
     "s.toml:4:1: pane[0].holes_mm: unknown key; there are " + pane_key_names},
    {"textures_too_large", of_path(sized + "textures = {size_px = 20000}"),
     "s.toml:4:23: pavement[0].textures.size_px: expected a whole number from 256 to 16384, got 20000"},
    {"textures_format", of_path(sized + "textures = {format = \"tga\"}"),
     "s.toml:4:22: pavement[0].textures.format: expected \"png\" or \"exr\" or \"tiled_exr\", got the text \"tga\""},
    {"textures_area", of_path(sized + "textures = {area_mm = [[9, 9], [1, 1]]}"),
     "s.toml:4:23: pavement[0].textures.area_mm: expected the lower left and the upper right corner, got other points"},
    {"textures_area_of_tile", of_path(sized + "textures = {area_mm = [[1, 1], [9, 9]], seamless = true}"),
     "s.toml:4:23: pavement[0].textures.area_mm: expected no area_mm beside seamless, got one"},
    {"textures_tile", of_path(sized + "textures = {tile_mm = [100, 100]}"),
     "s.toml:4:23: pavement[0].textures.tile_mm: expected seamless = true beside it, got none"},
    {"textures_flag", of_path(sized + "textures = {seamless = 1}"),
     "s.toml:4:24: pavement[0].textures.seamless: expected true or false, got 1"},
    {"hole_outside", of_path("size_mm = [9, 9]\nholes_mm = [[[20, 1], [21, 1], [21, 2]]]"),
     "s.toml:4:13: pavement[0].holes_mm[0]: expected holes inside the outline, got hole 0 outside at (20, 1)"},
    {"hole_across", of_path("size_mm = [9, 9]\nholes_mm = [[[1, 1], [2, 1], [2, 2]], [[8, 1], [10, 1], [8, 2]]]"),
     "s.toml:4:39: pavement[0].holes_mm[1]: expected edges that do not cross, got edge 1 of the outline and edge 0 of hole 1 "
     "crossing "
     "at (9, 1)"},
    {"hole_in_hole", of_path("size_mm = [9, 9]\nholes_mm = [[[1, 1], [8, 1], [8, 8]], [[6, 2], [7, 2], [7, 3]]]"),
     "s.toml:4:39: pavement[0].holes_mm[1]: expected holes that do not overlap, got hole 1 inside another at (6, 2)"},
    {"holes_no_list", of_path("size_mm = [9, 9]\nholes_mm = [[1, 1], [2, 1], [2, 2]]"),
     "s.toml:4:14: pavement[0].holes_mm[0][0]: expected a point [x, y], got 1"},
    {"outline_file_missing", of_pane("outline_file = \"none.svg\""),
     "s.toml:3:16: pane[0].outline_file: expected a file, got none of that name: none.svg"},
    {"outline_file_kind", of_pane("outline_file = \"a.dwg\""),
     "s.toml:3:16: pane[0].outline_file: expected a file that ends in .geojson, .json, .svg or .dxf, got \"a.dwg\""},
    // Impacts.
    {"no_impact", "[[pane]]\nname = \"w\"\n" + sized,
     "s.toml:1:1: pane[0].impact: expected one or more tables [[pane.impact]], got none"},
    {"impact_nowhere", impact("radial_count = 9"), "s.toml:4:1: pane[0].impact[0].at_mm: expected a point [x, y], got none"},
    {"impact_outside", impact("at_mm = [301, 5]"),
     "s.toml:5:9: pane[0].impact[0].at_mm: expected a point inside the outline of the pane, got (301, 5)"},
    {"impact_on_edge", impact("at_mm = [300, 5]"),
     "s.toml:5:9: pane[0].impact[0].at_mm: expected a point inside the outline of the pane, got (300, 5)"},
    {"impact_on_corner", impact("at_mm = [0, 0]"),
     "s.toml:5:9: pane[0].impact[0].at_mm: expected a point inside the outline of the pane, got (0, 0)"},
    {"impact_in_notch",
     "[[pane]]\nname = \"w\"\noutline_mm = [[0, 0], [9, 0], [9, 9], [5, 1], [0, 9]]\n[[pane.impact]]\nat_mm = [5, 5]\n",
     "s.toml:5:9: pane[0].impact[0].at_mm: expected a point inside the outline of the pane, got (5, 5)"},
    {"both_counts", impact("at_mm = [5, 5]\nradial_count = 9\nmean_radial_count = 9"),
     "s.toml:7:21: pane[0].impact[0].mean_radial_count: expected either radial_count or mean_radial_count, got both"},
    {"no_radials", impact("at_mm = [5, 5]\nradial_count = 0"),
     "s.toml:6:16: pane[0].impact[0].radial_count: expected a whole number from 1 to 10000, got 0"},
    {"large_above_all", impact("at_mm = [5, 5]\nradial_count = 9\nlarge_count = 10"),
     "s.toml:7:15: pane[0].impact[0].large_count: expected a whole number from 0 to 9, got 10"},
    {"preset_unknown", of_pane(sized + "preset = \"agui1992-fig15\""),
     "s.toml:4:10: pane[0].preset: expected a preset such as \"agui1992-fig15a\", got \"agui1992-fig15\""},
    // Directions.
    {"finish_unknown", of_path("size_mm = [9, 9]\nsurface.finish = \"polished\""),
     "s.toml:4:18: pavement[0].surface.finish: expected \"flat_sawn\" or \"bush_hammered\" or \"split\" or \"river_worn\", got "
     "the "
     "text \"polished\""},
    {"arris_without_finish", of_path("size_mm = [9, 9]\nsurface.arris_mm = 3"),
     "s.toml:4:20: pavement[0].surface.arris_mm: expected a finish beside it, got none"},
    {"tilt_too_far", of_path("size_mm = [9, 9]\nvariation.tilt_deg = 11"),
     "s.toml:4:22: pavement[0].variation.tilt_deg: expected a number from 0 to 10, got 11"},
    {"wetness_beyond", of_path("size_mm = [9, 9]\nwetness = 1.1"),
     "s.toml:4:11: pavement[0].wetness: expected a number from 0 to 1, got 1.1"},
    {"material_unknown", of_path("size_mm = [9, 9]\nmaterial = \"marble\""),
     "s.toml:4:12: pavement[0].material: expected \"setts\" or \"granite\" or \"basalt\" or \"sandstone\" or \"limestone\" or "
     "\"brick\", "
     "got the text \"marble\""},
    {"kerb_thin", of_path("size_mm = [9, 9]\nground.kerb_width_mm = 1"),
     "s.toml:4:24: pavement[0].ground.kerb_width_mm: expected 0, or 2 or more, got 1"},
    {"steps_of_no_height", of_path("size_mm = [9, 9]\nsteps.riser_mm = 0"),
     "s.toml:4:18: pavement[0].steps.riser_mm: expected a height other than 0, got 0"},
    {"steps_too_many", of_path("size_mm = [9000, 9000]\nsteps.tread_mm = 1"),
     "s.toml:4:18: pavement[0].steps.tread_mm: expected treads so deep that there are at most 1000 steps, got up to 12728"},
    {"steps_of_no_rows", of_path("size_mm = [9, 9]\nsteps.tread_mm = 3\nbond = \"herringbone\""),
     "s.toml:5:8: pavement[0].bond: expected running or stack beside steps, got another one"},
    {"steps_turned", of_path("size_mm = [9, 9]\nsteps.tread_mm = 3\nbond_turn_deg = 45"),
     "s.toml:5:17: pavement[0].bond_turn_deg: expected no bond_turn_deg beside steps, got one"},
    {"steps_with_a_kerb", of_path("size_mm = [9, 9]\nsteps.tread_mm = 3\nground.kerb_width_mm = 5"),
     "s.toml:5:1: pavement[0].ground: expected no kerb beside steps, got one"},
    {"steps_about_holes",
     of_path("size_mm = [99, 99]\nholes_mm = [[[40, 40], [60, 40], [60, 60]]]\nsteps.tread_mm = 9\ndirection.kind = "
             "\"boundary\""),
     "s.toml:5:1: pavement[0].steps: expected an area without holes where steps follow its boundary, got one with holes"},
    {"camera_on_its_target", of_path("size_mm = [9, 9]") + "[camera]\nat_mm = [1, 2, 3]\nlook_at_mm = [1, 2, 3]\n",
     "s.toml:6:14: camera.look_at_mm: expected a camera that looks at a place other than its own, got the same place"},
    {"camera_in_glass", of_pane(sized) + "[camera]\nat_mm = [150, -0.9, 150]\n",
     "s.toml:8:9: camera.at_mm: expected a camera outside the glass, got one within that of window"},
    {"camera_in_glass_that_is_placed",
     of_pane(sized + "place_mm = [0, 0, 1000]\nplace_turn_deg = 90") + "[camera]\nat_mm = [0.9, 150, 1150]\n",
     "s.toml:9:9: camera.at_mm: expected a camera outside the glass, got one within that of window"},
    {"f_number_alone", of_path("size_mm = [9, 9]") + "[camera]\nf_number = 4\n",
     "s.toml:5:12: camera.f_number: expected focus_mm beside it, got none"},
    {"focus_alone", of_path("size_mm = [9, 9]") + "[camera]\nfocus_mm = 400\n",
     "s.toml:5:12: camera.focus_mm: expected f_number beside it, got none"},
    {"half_a_sun", of_path("size_mm = [9, 9]") + "[light]\nsun_azimuth_deg = 4\n",
     "s.toml:5:19: light.sun_azimuth_deg: expected sun_elevation_deg beside it, got none"},
    {"still_flag", of_path("size_mm = [9, 9]") + "[still]\ncaustics = 1\n",
     "s.toml:5:12: still.caustics: expected true or false, got 1"},
    {"name_of_materials", "[[pavement]]\nname = \"Shatterpave-Stone\"\nsize_mm = [9, 9]\n",
     "s.toml:2:8: pavement[0].name: expected a name that no file of materials has, got \"shatterpave_stone.inc\""},
    {"fall_uphill", of_path("size_mm = [9, 9]\nground.fall_percent = -1"),
     "s.toml:4:23: pavement[0].ground.fall_percent: expected a number from 0 to 100, got -1"},
    {"detail_mesh_zero", of_path("size_mm = [9, 9]\ndetail.mesh_mm = 0"),
     "s.toml:4:18: pavement[0].detail.mesh_mm: expected a number from 0.1 to 1000, got 0"},
    {"direction_kind", of_path("size_mm = [9, 9]\ndirection.kind = \"spiral\""),
     "s.toml:4:18: pavement[0].direction.kind: expected \"constant\" or \"boundary\" or \"radial\" or \"guides\" or \"grid\", "
     "got the text "
     "\"spiral\""},
    {"guides_missing", of_path("size_mm = [9, 9]\ndirection.kind = \"guides\""),
     "s.toml:4:1: pavement[0].direction.guides_mm: expected one or more polylines, got none"},
    {"guide_of_one_point", of_path("size_mm = [9, 9]\ndirection.guides_mm = [[[1, 1], [1, 1]]]"),
     "s.toml:4:24: pavement[0].direction.guides_mm[0]: expected 2 or more distinct points, got 1"},
    {"angle_nan", of_path("size_mm = [9, 9]\ndirection.angle_deg = nan"),
     "s.toml:4:23: pavement[0].direction.angle_deg: expected a number from -360 to 360, got nan"},
};

class SceneErrors : public testing::TestWithParam<Case> {};

TEST_P(SceneErrors, NamePlaceAndRemedyInOneLine) {
  try {
    scene_of_text(GetParam().text, "s.toml");
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (!GetParam().message.empty()) {
      EXPECT_EQ(message, GetParam().message);
    }
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_TRUE(message.starts_with("s.toml:"));
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, SceneErrors, testing::ValuesIn(cases), [](const auto& test) { return test.param.name; });

struct OverrideCase {
  std::string name;
  std::string set;
  std::string message;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for.
void PrintTo(const OverrideCase& c, std::ostream* out) { *out << c.name; }

class OverrideErrors : public testing::TestWithParam<OverrideCase> {};

TEST_P(OverrideErrors, NameTheOption) {
  const std::string& set = GetParam().set;
  const Override change{"--set " + set, set.substr(0, set.find('=')), set.substr(set.find('=') + 1)};
  try {
    scene_of_text(of_pane(sized) + of_path(sized), "s.toml", {change});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().message);
  }
}

const std::vector<OverrideCase> override_cases = {
    {"nan", "pane[0].thickness_mm=nan",
     "--set pane[0].thickness_mm=nan: pane[0].thickness_mm: expected a number from 0.1 to 1000, got nan"},
    {"text", "pane[0].thickness_mm=3,5",
     "--set pane[0].thickness_mm=3,5: pane[0].thickness_mm: expected a number from 0.1 to 1000, got the text \"3,5\""},
    {"two_values", "seed=1\npane=2",
     "--set seed=1\npane=2: seed: expected a whole number from 0 to 9223372036854775807, got the text \"1\\x0apane=2\""},
    {"unknown", "pane[0].thick=3", "--set pane[0].thick=3: pane[0].thick: unknown key; did you mean thickness_mm?"},
    {"made_table", "pane[0].growht.time_step=1",
     "--set pane[0].growht.time_step=1: pane[0].growht: unknown key; did you mean growth?"},
    {"near_name", "pane.windw.thickness_mm=3",
     "--set pane.windw.thickness_mm=3: expected pane[0] or pane.window, got \"windw\"; did you mean pane.window?"},
    {"swapped_letters", "pavement.paht.joint_mm=3",
     "--set pavement.paht.joint_mm=3: expected pavement[0] or pavement.path, got \"paht\"; did you mean pavement.path?"},
    {"index", "pane[1].thickness_mm=3", "--set pane[1].thickness_mm=3: expected pane[0] or pane.window, got \"pane[1]\""},
    {"name", "pavement.yard.joint_mm=3", "--set pavement.yard.joint_mm=3: expected pavement[0] or pavement.path, got \"yard\""},
    {"no_table", "pane[0].name.x=3",
     "--set pane[0].name.x=3: expected a key that leads to a value, got one that goes on after pane[0].name, which is the "
     "text \"window\""},
    {"double_dot", "pane..x=3",
     "--set pane..x=3: expected a key such as seed, pane[0].thickness_mm or pavement.path.joint_mm, got \"pane..x\""},
    {"open_bracket", "pane[0=3",
     "--set pane[0=3: expected a key such as seed, pane[0].thickness_mm or pavement.path.joint_mm, got \"pane[0\""},
    {"unknown_at_the_root", "sed=5", "--set sed=5: sed: unknown key; did you mean seed?"},
    {"unknown_by_name", "pane.window.thick=3",
     "--set pane.window.thick=3: pane[0].thick: unknown key; did you mean thickness_mm?"},
    {"unknown_in_unknown", "pane[0].growht.speed.x=3",
     "--set pane[0].growht.speed.x=3: pane[0].growht: unknown key; did you mean growth?"},
    {"key_of_element", "pane.thickness_mm=3",
     "--set pane.thickness_mm=3: expected pane[0] or pane.window, got \"thickness_mm\"; did you mean pane[0].thickness_mm?"},
    {"below_number", "seed.x=3",
     "--set seed.x=3: expected a key that leads to a value, got one that goes on after seed, which is a whole number"},
    {"below_text", "light.environment.x=3",
     "--set light.environment.x=3: expected a key that leads to a value, got one that goes on after light.environment, which "
     "is a "
     "text"},
    {"index_of_table", "still[0]=3",
     "--set still[0]=3: expected a key that leads to a value, got one that goes on after still, which is a table"},
    {"list_not_given", "camera.at_mm[1]=3",
     "--set camera.at_mm[1]=3: expected an element of camera.at_mm, got camera.at_mm[1]; there are none"},
    {"name_in_list_not_given", "camera.at_mm.x=3",
     "--set camera.at_mm.x=3: expected a key that leads to a value, got one that goes on after camera.at_mm, which is a list"},
    {"name_in_list", "pane[0].size_mm.x=3",
     "--set pane[0].size_mm.x=3: expected pane[0].size_mm[0] or pane[0].size_mm[1], got \"x\""},
    {"below_number_in_list", "pane[0].size_mm[0][1]=3",
     "--set pane[0].size_mm[0][1]=3: expected a key that leads to a value, got one that goes on after pane[0].size_mm[0], "
     "which is "
     "300"},
    {"tables_not_given", "pavement[0].colour[0].srgb=[1,1,1]",
     "--set pavement[0].colour[0].srgb=[1,1,1]: expected an element of pavement[0].colour, got pavement[0].colour[0]; there "
     "are "
     "none"},
    {"quoted_near_name", "pane.\"windw\".thickness_mm=3",
     "--set pane.\"windw\".thickness_mm=3: expected pane[0] or pane.window, got \"windw\"; did you mean pane.window?"},
    {"open_quote", "pane.'window.thickness_mm=3",
     "--set pane.'window.thickness_mm=3: expected a key such as seed, pane[0].thickness_mm or pavement.path.joint_mm, got "
     "\"pane.'window.thickness_mm\""},
    {"text_for_whole_table", "pane[0].growth=slow",
     "--set pane[0].growth=slow: pane[0].growth: expected a table [pane[0].growth], got the text \"slow\""},
    {"trailing_dot", "pane.=3",
     "--set pane.=3: expected a key such as seed, pane[0].thickness_mm or pavement.path.joint_mm, got \"pane.\""},
};

INSTANTIATE_TEST_SUITE_P(Cases, OverrideErrors, testing::ValuesIn(override_cases),
                         [](const auto& test) { return test.param.name; });

TEST(SceneOfFile, RefusesWhatIsNoFile) {
  const auto message = [](const std::string& file) {
    try {
      scene_of_file(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("no/such.toml"), "no/such.toml: expected a file, got none of that name");
  EXPECT_EQ(message("/"), "/: expected a file, got a folder");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: expected a regular file, got something else");
}

TEST(SceneOfText, RefusesAnUnusableSceneName) { EXPECT_THROW(scene_of_text(of_pane(sized), "a\"b.toml"), InputError); }

}  // namespace
}  // namespace shatterpave::scene
