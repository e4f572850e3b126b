#include "export/shapes/bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.h"
#include "export/shapes/glass_bodies.h"
#include "export/shapes/stone_bodies.h"
#include "export/shapes/tones.h"

namespace shatterpave::exporting::shapes {

namespace {

constexpr Colour white{1.0F, 1.0F, 1.0F};

std::string identifier(std::string name) {
  std::ranges::replace(name, '-', '_');
  return name;
}

// Broken faces scatter a little; what is ground up, all. By eye.
void append_glass_materials(std::vector<Material>& all) {
  all.push_back({"glass_old", Substance::glass, white, 0.0F});
  all.push_back({"glass_broken", Substance::broken_glass, white, 0.05F});
  all.push_back({"glass_crushed", Substance::crushed_glass, white, 0.9F});
}

void append_stone_materials(const PavedArea& paved, Materials& materials) {
  const paving::Pavement& pavement = paved.pavement;
  const std::string name = identifier(pavement.name);
  const Palette palette(pavement.look);
  const auto number = [&](std::optional<Swatch> swatch) -> std::optional<std::size_t> {
    if (!swatch) return std::nullopt;
    return number_in(materials.swatches, std::move(*swatch));
  };
  const auto of_stone = number(stone_swatch(paved));
  const bool own = !pavement.look.colours.colours.empty();
  for (int k = 0; k < static_cast<int>(stone_materials(pavement)); ++k) {
    const StoneLook look = palette.stone(colour_of(k % stone_tones), own ? k : -1);
    Material& material =
        materials.all.emplace_back(Material{fmt::format("{}_stone_{}", name, k), Substance::stone,
                                            palette.stone_colour(look, {}), palette.stone_roughness(look, {})});
    if (of_stone) material.swatch = SwatchUse{*of_stone, palette.tint(look), palette.roughness_part(look)};
  }
  Material& joint = materials.all.emplace_back(
      Material{name + "_joint", Substance::joint, palette.bed_colour({}), palette.bed_roughness({})});
  const auto of_joint = number(joint_swatch(paved));
  constexpr float grey = Palette::joint_tint;
  if (of_joint) joint.swatch = SwatchUse{*of_joint, {grey, grey, grey}, 1.0F};
  materials.all.push_back({name + "_water", Substance::water, white, Palette::water_roughness});
}

// Takes bodies to where their thing stands.
TakeBody taken_to(const studio::Placement& placement, const TakeBody& take) {
  if (placement == studio::Placement{}) return take;
  return [place = placing_of(placement), &take](Body&& body) {
    body.placing = combined(place, body.placing);
    for (std::optional<Placing>& placing : body.path) {
      if (placing) placing = combined(place, *placing);
    }
    take(std::move(body));
  };
}

}  // namespace

Placing combined(const Placing& outer, const Placing& inner) {
  Placing result;
  for (std::size_t row = 0; row < 3; ++row) {
    const vec3& r = outer.turn.at(row);
    result.turn.at(row) = r.x * inner.turn[0] + r.y * inner.turn[1] + r.z * inner.turn[2];
  }
  result.at_mm = outer(inner.at_mm);
  return result;
}

Placing placing_of(const studio::Placement& placement) {
  const vec3 at = studio::upright_of_world(placement.at_mm);
  if (placement.turn == Angle()) return {Placing{}.turn, at};
  const vec2 d = placement.turn.direction();
  return {{vec3{d.x, 0.0, d.y}, vec3{0.0, 1.0, 0.0}, vec3{-d.y, 0.0, d.x}}, at};
}

Materials materials_of(const Model& model) {
  Materials materials;
  if (!model.panes.empty()) append_glass_materials(materials.all);
  for (const PavedArea& paved : model.pavements) {
    materials.of_pavement.push_back(materials.all.size());
    append_stone_materials(paved, materials);
  }
  return materials;
}

void require_few_stones(const Things& things) {
  double count = 0.0;
  for (const paving::Pavement& pavement : things.pavements) {
    const vec2 pitch = paving::pitch_mm(pavement);
    count += geometry::area(pavement.area) / (pitch.x * pitch.y);
    if (count <= most_stones) continue;
    throw InputError(
        shatterpave::Place{"", 0, 0, pavement.name + ".stone_mm"},
        fmt::format("expected at most {:.0f} stones for meshes, got an area for about {:.0f}", most_stones, count));
  }
}

void for_each_body(const Model& model, const Materials& materials, const BeginThing& begin, const TakeBody& take) {
  std::size_t stones = 0;
  for (const PavedArea& paved : model.pavements) stones += paved.layout.stones.size();
  if (static_cast<double>(stones) > most_stones) {
    throw InputError(fmt::format("meshes: expected at most {:.0f} stones, got {}", most_stones, stones));
  }
  for (const BrokenPane& broken : model.panes) {
    if (begin) begin(broken.pane.name, true);
    append_glass(broken, Materials::of_glass, taken_to(broken.pane.placement, take));
  }
  for (std::size_t i = 0; i < model.pavements.size(); ++i) {
    const PavedArea& paved = model.pavements[i];
    if (begin) begin(paved.pavement.name, false);
    append_stones(paved, materials.of_pavement[i], model.seed, taken_to(paved.pavement.placement, take));
  }
}

}  // namespace shatterpave::exporting::shapes
