// Every key of the scene file with two values that ought to make a difference, and the smallest scenes to try them in.
#pragma once

#include <string>
#include <vector>

namespace shatterpave::pipeline {

struct Change {
  std::string key;  // as --set takes it
  std::string one;
  std::string other;
};

inline const std::string one_pane = R"(seed = 3
[[pane]]
name = "w"
size_mm = [90, 70]
[[pane.impact]]
at_mm = [40, 33]
[pane.growth]
step_length_px = 8
)";

inline const std::vector<Change> pane_changes = {
    {"pane[0].thickness_mm", "3", "4"},
    {"pane[0].preset", "agui1992-fig14a", "agui1992-fig16d"},
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

inline const std::string one_pavement = R"(seed = 3
[[pavement]]
name = "p"
outline_mm = [[0, 0], [620, 0], [650, 430], [80, 470]]
textures.size_px = 256
)";

inline const std::vector<Change> pavement_changes = {
    {"pavement[0].holes_mm", "[[[200, 200], [300, 200], [300, 300]]]", "[[[200, 200], [300, 200], [200, 300]]]"},
    {"pavement[0].stone_preset", "mosaic_sett", "small_sett"},
    {"pavement[0].stone_mm", "[100, 80]", "[90, 70]"},
    {"pavement[0].joint_mm", "5", "9"},
    {"pavement[0].bond", "running", "stack"},
    {"pavement[0].bond_offset", "0.2", "0.4"},
    {"pavement[0].bond_turn_deg", "10", "30"},
    {"pavement[0].bond_span_mm", "600", "900"},
    {"pavement[0].border_course", "none", "soldier"},
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

// Keys of outlines and plans, of the still and of the whole scene: each with the rest of a scene in which it has an effect.
struct PlacedChange {
  std::string rest;  // TOML
  Change change;
};

inline const std::string plan_a = R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "id": "yard", "properties": {"class": "paved"}, "geometry":
 {"type": "Polygon", "coordinates": [[[0, 0], [1.6, 0], [1.6, 1.5], [0, 1.5], [0, 0]]]}},
{"type": "Feature", "id": "lawn", "properties": {"class": "green"}, "geometry":
 {"type": "Polygon", "coordinates": [[[1.2, 0], [2.4, 0], [2.4, 1.7], [1.2, 1.5], [1.2, 0]]]}},
{"type": "Feature", "id": "bed", "properties": {"class": "round"}, "geometry":
 {"type": "Polygon", "coordinates": [[[0.3, 0.3], [0.6, 0.3], [0.6, 0.6], [0.3, 0.3]]]}},
{"type": "Feature", "id": "pond", "properties": {"class": "wet"}, "geometry":
 {"type": "Polygon", "coordinates": [[[0.8, 0.7], [1.1, 0.7], [1.1, 1.1], [0.8, 0.7]]]}},
{"type": "Feature", "id": "path", "properties": {"class": "walk"}, "geometry":
 {"type": "LineString", "coordinates": [[-0.2, 0.4], [2.6, 0.9]]}},
{"type": "Feature", "id": "drive", "properties": {"class": "wide"}, "geometry":
 {"type": "LineString", "coordinates": [[-0.2, 1.2], [2.6, 0.3]]}},
{"type": "Feature", "id": "tree", "properties": {"class": "oak"}, "geometry": {"type": "Point", "coordinates": [0.8, 0.9]}}
]})";
inline const std::string drawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="600mm" height="500mm" viewBox="0 0 600 500">
<rect id="yard" width="600" height="500"/></svg>)";

inline const std::string planned =
    "[[pavement]]\nname = \"p\"\ntextures.size_px = 256\noutline_units = \"metres\"\noutline_file = \"a.geojson\"\n";
inline const std::string yard = planned + "outline_feature = \"yard\"\n";
inline const std::string running_guides = "bond = \"running\"\ndirection.kind = \"guides\"\n";

inline const std::vector<PlacedChange> placed_changes = {
    {one_pane, {"seed", "3", "4"}},
    {one_pane, {"pane[0].name", "w", "v"}},
    {one_pane, {"pane[0].size_mm", "[90, 70]", "[95, 75]"}},
    {"[[pane]]\nname = \"w\"\nimpact = [{at_mm = [30, 20], radial_count = 9}]\n",
     {"pane[0].outline_mm", "[[0, 0], [90, 0], [50, 80]]", "[[0, 0], [90, 0], [55, 85]]"}},
    {one_pane, {"still.setting", "window_still", "studio_glass_still"}},
    {one_pane, {"still.dispersion", "false", "true"}},
    {one_pane, {"still.caustics", "false", "true"}},
    {one_pavement, {"pavement[0].name", "p", "q"}},
    {one_pavement, {"pavement[0].outline_mm", "[[0, 0], [600, 0], [600, 400]]", "[[0, 0], [600, 0], [700, 400]]"}},
    {"[[pavement]]\nname = \"p\"\ntextures.size_px = 256\n", {"pavement[0].size_mm", "[600, 500]", "[700, 500]"}},
    {yard, {"pavement[0].outline_file", "a.geojson", "b.geojson"}},
    {planned, {"pavement[0].outline_feature", "yard", "lawn"}},
    {planned, {"pavement[0].outline_class", "paved", "green"}},
    {planned + "outline_feature = \"path\"\n", {"pavement[0].outline_width_mm", "300", "400"}},
    {yard, {"pavement[0].outline_units", "metres", "millimetres"}},
    {yard + "holes_feature = \"bed\"\n", {"pavement[0].holes_file", "a.geojson", "b.geojson"}},
    {yard, {"pavement[0].holes_feature", "bed", "pond"}},
    {yard, {"pavement[0].holes_class", "round", "wet"}},
    {yard + "holes_feature = \"tree\"\n", {"pavement[0].holes_width_mm", "300", "400"}},
    {planned + "outline_feature = \"path\"\noutline_width_mm = 300\n", {"pavement[0].within_feature", "yard", "lawn"}},
    {planned + "outline_feature = \"path\"\noutline_width_mm = 300\n", {"pavement[0].within_class", "paved", "green"}},
    {yard + running_guides + "direction.guides_feature = \"drive\"\n",
     {"pavement[0].direction.guides_file", "a.geojson", "b.geojson"}},
    {yard + running_guides, {"pavement[0].direction.guides_feature", "path", "drive"}},
    {yard + running_guides, {"pavement[0].direction.guides_class", "walk", "wide"}},
    {yard, {"plan.origin", "[0, 0]", "[1, 1]"}},
    {"[[pavement]]\nname = \"p\"\ntextures.size_px = 256\noutline_file = \"a.svg\"\n", {"plan.svg_scale", "1", "2"}},
    {"[[pane]]\nname = \"w\"\noutline_units = \"metres\"\noutline_feature = \"yard\"\nimpact = [{at_mm = [800, 700], "
     "radial_count "
     "= 9}]\n",
     {"pane[0].outline_file", "a.geojson", "b.geojson"}},
    {"[[pane]]\nname = \"w\"\noutline_units = \"metres\"\noutline_file = \"a.geojson\"\nimpact = [{at_mm = [1300, 700], "
     "radial_count = 9}]\n",
     {"pane[0].outline_feature", "yard", "lawn"}},
    {"[[pane]]\nname = \"w\"\noutline_units = \"metres\"\noutline_file = \"a.geojson\"\nimpact = [{at_mm = [1300, 700], "
     "radial_count = 9}]\n",
     {"pane[0].outline_class", "paved", "green"}},
    {"[[pane]]\nname = \"w\"\noutline_file = \"a.geojson\"\noutline_feature = \"yard\"\nimpact = [{at_mm = [0.8, 0.7], "
     "radial_count = 9}]\n",
     {"pane[0].outline_units", "metres", "millimetres"}},
};

}  // namespace shatterpave::pipeline
