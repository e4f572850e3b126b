#include "scene/schema/stone_keys.h"

#include <fmt/format.h>

#include <array>

#include "paving/catalogue/finishes.h"
#include "scene/schema/keys.h"

namespace shatterpave::scene {

namespace {

// Half of it is joint at the most, and stones are at least a millimetre wide.
constexpr double least_kerb_mm = 2.0;

void read_finish(const TomlTable& surface, paving::Pavement& pavement) {
  const auto chosen = surface.choice("finish", {"flat_sawn", "bush_hammered", "split", "river_worn"});
  if (!chosen) {
    for (const std::string_view key : {"arris", "arris_mm", "crown_mm", "uneven_mm", "wear_mm", "chips_per_m"}) {
      if (surface.has(key)) refuse(surface.place(key), "a finish beside it", "none");
    }
    return;
  }
  const paving::FinishPreset& preset = paving::finish_presets.at(*chosen);
  pavement.body = preset.body;
  pavement.surface.height_mm = preset.height_mm;
  pavement.surface.height_spread = preset.height_spread;
  pavement.variation.tilt = Angle::degrees(preset.tilt_deg);
  pavement.relief = preset.relief;
}

void read_surface(const TomlTable& pavement, paving::Pavement& result) {
  const auto table = pavement.table("surface", surface_keys);
  if (!table) return;
  read_finish(*table, result);
  table->read("height_mm", {0.0, 1000.0}, result.surface.height_mm);
  table->read("height_spread", {0.0, 1.0}, result.surface.height_spread);
  table->read("inset", {0.0, 0.5}, result.surface.inset);
  table->read("inset_spread", {0.0, 1.0}, result.surface.inset_spread);
  paving::StoneBody& body = result.body;
  constexpr std::array arrises = {paving::Arris::rounded, paving::Arris::chamfered};
  if (const auto arris = table->choice("arris", {"rounded", "chamfered"})) body.arris = arrises.at(*arris);
  table->read("arris_mm", {0.1, 1000.0}, body.arris_mm);
  table->read("crown_mm", {0.0, 1000.0}, body.crown_mm);
  table->read("uneven_mm", {0.0, 1000.0}, body.uneven_mm);
  table->read("wear_mm", {0.0, 1000.0}, body.wear_mm);
  table->read("chips_per_m", {0.0, 1000.0}, body.chips_per_m);
}

void read_variation(const TomlTable& pavement, paving::Variation& variation) {
  const auto table = pavement.table("variation", variation_keys);
  if (!table) return;
  table->read("size", {0.0, 0.5}, variation.size);
  variation.rotation = Angle::degrees(table->number("rotation_deg", {0.0, 45.0}).value_or(0.0));
  table->read("offset_mm", {0.0, 1000.0}, variation.offset_mm);
  table->read("sink_mm", {0.0, 1000.0}, variation.sink_mm);
  table->read("missing", {0.0, 1.0}, variation.missing);
  if (const auto tilt = table->number("tilt_deg", {0.0, 10.0})) variation.tilt = Angle::degrees(*tilt);
}

void read_relief(const TomlTable& pavement, paving::Relief& relief) {
  const auto table = pavement.table("relief", relief_keys);
  if (!table) return;
  table->read("rms_mm", {0.0, 100.0}, relief.rms_mm);
  table->read("hurst", {0.0, 1.0}, relief.hurst);
}

std::optional<TomlTable> ground_table(const TomlTable& pavement) { return pavement.table("ground", ground_keys); }

}  // namespace

void read_stones(const TomlTable& pavement, paving::Pavement& result) {
  read_surface(pavement, result);
  read_variation(pavement, result.variation);
  read_relief(pavement, result.relief);
}

paving::Look look_of(const TomlTable& pavement) {
  using paving::Material;
  constexpr std::array materials = {Material::setts,     Material::granite,   Material::basalt,
                                    Material::sandstone, Material::limestone, Material::brick};
  constexpr std::array fills = {paving::JointFill::sand, paving::JointFill::mortar};
  paving::Look look;
  const auto material = pavement.choice("material", {"setts", "granite", "basalt", "sandstone", "limestone", "brick"});
  look.material = materials.at(material.value_or(0));
  if (const auto fill = pavement.choice("joint_fill", {"sand", "mortar"})) look.joint_fill = fills.at(*fill);
  look.moss = pavement.number("moss", {0.0, 1.0});
  pavement.read("wetness", {0.0, 1.0}, look.wetness);
  return look;
}

paving::Ground ground_of(const TomlTable& pavement) {
  paving::Ground ground;
  const auto table = ground_table(pavement);
  if (!table) return ground;
  table->read("fall_percent", {0.0, 100.0}, ground.fall_percent);
  ground.fall_direction = Angle::degrees(table->number("fall_deg", {-360.0, 360.0}).value_or(0.0));
  table->read("level_mm", {-100'000.0, 100'000.0}, ground.level_mm);
  table->read("settlement_mm", {0.0, 1000.0}, ground.settlement_mm);
  table->read("settlement_length_mm", {100.0, 1'000'000.0}, ground.settlement_length_mm);
  return ground;
}

std::optional<paving::Detail> detail_of(const TomlTable& pavement) {
  const auto table = pavement.table("detail", detail_keys);
  if (!table) return std::nullopt;
  paving::Detail detail;
  constexpr Range place{-1e9, 1e9};
  detail.viewer_mm = table->point("viewer_mm", place).value_or(detail.viewer_mm);
  table->read("close_mm", {0.0, 100'000.0}, detail.close_mm);
  table->read("mesh_mm", {0.1, 1000.0}, detail.mesh_mm);
  return detail;
}

paving::Kerb kerb_of(const TomlTable& pavement) {
  paving::Kerb kerb;
  const auto table = ground_table(pavement);
  if (!table) return kerb;
  table->read("kerb_width_mm", {0.0, 10'000.0}, kerb.width_mm);
  if (kerb.width_mm > 0.0 && kerb.width_mm < least_kerb_mm) {
    refuse(table->place("kerb_width_mm"), fmt::format("0, or {} or more", least_kerb_mm), fmt::format("{}", kerb.width_mm));
  }
  table->read("kerb_length_mm", {1.0, 100'000.0}, kerb.length_mm);
  table->read("kerb_height_mm", {0.0, 1000.0}, kerb.height_mm);
  return kerb;
}

}  // namespace shatterpave::scene
