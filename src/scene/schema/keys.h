// Every key that a scene file may have, table by table: what the readers take, and what messages may name.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace shatterpave::scene {

using Keys = std::span<const std::string_view>;

inline constexpr auto root_keys = std::to_array<std::string_view>({"seed", "plan", "pane", "pavement", "still"});
inline constexpr auto still_keys = std::to_array<std::string_view>({"setting", "dispersion", "caustics"});
inline constexpr auto plan_keys = std::to_array<std::string_view>({"origin", "svg_scale"});

inline constexpr auto pane_keys = std::to_array<std::string_view>(
    {"name",         "size_mm", "outline_mm", "outline_file", "outline_feature", "outline_class", "outline_units",
     "thickness_mm", "preset",  "impact",     "growth",       "shards",          "glass",         "pattern",
     "rings",        "crater",  "laminate",   "tempering",    "crack_body",      "crack_sheet"});
inline constexpr auto impact_keys =
    std::to_array<std::string_view>({"at_mm", "mean_radial_count", "radial_count", "large_count", "circular_count",
                                     "ball_diameter_mm", "speed_m_s", "hole_mm", "spall_mm"});
inline constexpr auto growth_keys =
    std::to_array<std::string_view>({"spread",          "spread_limit",      "spread_deviation",     "large_speed_px",
                                     "radial_speed_px", "circular_speed_px", "sector_angle_deg",     "sector_radius_px",
                                     "turn_limit_deg",  "weight_time",       "step_length_px",       "reference_radial_count",
                                     "energy_exponent", "count_law",         "count_dispersion",     "circular_threshold",
                                     "circular_slope",  "circular_offset",   "large_slope",          "large_offset",
                                     "large_deviation", "large_rounding",    "ring_radius_slope_mm", "ring_radius_offset_mm",
                                     "tip_gain_px2",    "crack_gain_px2",    "sibling_gain_px2",     "edge_gain_px2",
                                     "wander_deg",      "turn_length_px",    "radial_pull",          "ring_pull",
                                     "ring_onset",      "radial_onset",      "branch_rate_per_m",    "branch_angle_deg"});
inline constexpr auto rings_keys =
    std::to_array<std::string_view>({"count", "first_radius_mm", "ratio", "spread", "interruption", "bow"});
inline constexpr auto crater_keys = std::to_array<std::string_view>({"cone_deg"});
inline constexpr auto laminate_keys = std::to_array<std::string_view>({"through", "milky_width_mm"});
inline constexpr auto tempering_keys =
    std::to_array<std::string_view>({"surface_stress_mpa", "count_per_square", "splinter_ratio", "splinter_reach_mm"});
inline constexpr auto crack_sheet_keys = std::to_array<std::string_view>(
    {"tilt_deg", "curve_deg", "twist_mm", "opening_mm", "opening_variation", "depth", "relief"});
inline constexpr auto shards_keys = std::to_array<std::string_view>(
    {"enabled", "joined", "gap_mm", "splinter_mm2", "bevel_mm", "chips_per_m", "chip_mm", "missing", "missing_mm", "held",
     "fallen", "throw_m_s", "sill_drop_mm", "sill_depth_mm", "frame_mm", "reveal_mm", "floor_drop_mm"});

inline constexpr auto pavement_keys =
    std::to_array<std::string_view>({"name",          "size_mm",          "outline_mm",     "outline_file",   "outline_feature",
                                     "outline_class", "outline_width_mm", "outline_units",  "holes_mm",       "holes_file",
                                     "holes_feature", "holes_class",      "holes_width_mm", "within_feature", "within_class",
                                     "stone_preset",  "stone_mm",         "joint_mm",       "direction",      "bond",
                                     "bond_offset",   "bond_turn_deg",    "bond_span_mm",   "border_course",  "border_stone_mm",
                                     "surface",       "variation",        "relief",         "material",       "joint_fill",
                                     "moss",          "wetness",          "ground",         "steps",          "detail",
                                     "textures"});
inline constexpr auto direction_keys = std::to_array<std::string_view>(
    {"kind", "angle_deg", "centre_mm", "guides_mm", "guides_file", "guides_feature", "guides_class"});
inline constexpr auto surface_keys =
    std::to_array<std::string_view>({"height_mm", "height_spread", "inset", "inset_spread", "finish", "arris", "arris_mm",
                                     "crown_mm", "uneven_mm", "wear_mm", "chips_per_m"});
inline constexpr auto variation_keys =
    std::to_array<std::string_view>({"size", "rotation_deg", "offset_mm", "sink_mm", "missing", "tilt_deg"});
inline constexpr auto relief_keys = std::to_array<std::string_view>({"rms_mm", "hurst"});
inline constexpr auto textures_keys = std::to_array<std::string_view>({"size_px", "area_mm", "format", "seamless", "tile_mm"});
inline constexpr auto ground_keys =
    std::to_array<std::string_view>({"fall_percent", "fall_deg", "level_mm", "settlement_mm", "settlement_length_mm",
                                     "kerb_width_mm", "kerb_length_mm", "kerb_height_mm"});
inline constexpr auto steps_keys = std::to_array<std::string_view>({"riser_mm", "tread_mm"});
inline constexpr auto detail_keys = std::to_array<std::string_view>({"viewer_mm", "close_mm", "mesh_mm"});

// A table of the scene by its path, with [] after lists of tables.
struct KeyTable {
  std::string_view path;
  Keys keys;
};

inline constexpr std::array<KeyTable, 21> key_tables = {{{"", root_keys},
                                                         {"still", still_keys},
                                                         {"plan", plan_keys},
                                                         {"pane[]", pane_keys},
                                                         {"pane[].impact[]", impact_keys},
                                                         {"pane[].growth", growth_keys},
                                                         {"pane[].rings", rings_keys},
                                                         {"pane[].crater", crater_keys},
                                                         {"pane[].laminate", laminate_keys},
                                                         {"pane[].tempering", tempering_keys},
                                                         {"pane[].crack_sheet", crack_sheet_keys},
                                                         {"pane[].shards", shards_keys},
                                                         {"pavement[]", pavement_keys},
                                                         {"pavement[].direction", direction_keys},
                                                         {"pavement[].surface", surface_keys},
                                                         {"pavement[].variation", variation_keys},
                                                         {"pavement[].relief", relief_keys},
                                                         {"pavement[].textures", textures_keys},
                                                         {"pavement[].ground", ground_keys},
                                                         {"pavement[].steps", steps_keys},
                                                         {"pavement[].detail", detail_keys}}};

}  // namespace shatterpave::scene
