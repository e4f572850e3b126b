#include "export/shapes/bodies.h"

#include <fmt/format.h>

#include <algorithm>

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

void append_stone_materials(const paving::Pavement& pavement, const std::string& name, std::vector<Material>& all) {
  const Palette palette(pavement.look);
  for (int tone = 0; tone < stone_tones; ++tone) {
    const StoneLook look = palette.stone(colour_of(tone));
    all.push_back({fmt::format("{}_stone_{}", name, tone), Substance::stone, palette.stone_colour(look, {}),
                   palette.stone_roughness(look, {})});
  }
  all.push_back({name + "_joint", Substance::joint, palette.bed_colour({}), palette.bed_roughness({})});
  all.push_back({name + "_water", Substance::water, white, Palette::water_roughness});
}

}  // namespace

Materials materials_of(const Model& model) {
  Materials materials;
  if (!model.panes.empty()) append_glass_materials(materials.all);
  for (const PavedArea& paved : model.pavements) {
    materials.of_pavement.push_back(materials.all.size());
    append_stone_materials(paved.pavement, identifier(paved.pavement.name), materials.all);
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
  for (std::size_t i = 0; i < model.panes.size(); ++i) {
    if (begin) begin(model.panes[i].pane.name, true);
    append_glass(model.panes[i], Materials::of_glass, take);
  }
  for (std::size_t i = 0; i < model.pavements.size(); ++i) {
    if (begin) begin(model.pavements[i].pavement.name, false);
    append_stones(model.pavements[i], materials.of_pavement[i], model.seed, take);
  }
}

}  // namespace shatterpave::exporting::shapes
