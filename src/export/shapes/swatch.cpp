#include "export/shapes/swatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/functions.h"
#include "export/shapes/mesh_parts.h"
#include "export/shapes/stone_relief.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::exporting::shapes {

namespace {

constexpr double largest_side_m = 8.0;

// Of the places where a stone may begin, those that a neighbour of the same size leaves no room at. With nine of 64, seven
// neighbours leave one free.
constexpr double most_places_taken = 9.0;

double places_taken(vec2 stone_mm, double side_m) {
  const double step_mm = side_m * 1000.0 / places_aside;
  const vec2 steps = glm::max(glm::ceil(stone_mm / step_mm), vec2{1.0, 1.0});
  return (2.0 * steps.x - 1.0) * (2.0 * steps.y - 1.0);
}

// Sand and mortar are alike everywhere: half the square with half the pixels shows as much of them.
constexpr double joint_side_m = 0.5;

std::string_view word_of(paving::Material material) {
  switch (material) {
    case paving::Material::setts:
      return "setts";
    case paving::Material::granite:
      return "granite";
    case paving::Material::basalt:
      return "basalt";
    case paving::Material::sandstone:
      return "sandstone";
    case paving::Material::limestone:
      return "limestone";
    case paving::Material::brick:
      return "brick";
  }
  ENSURE(false);
  return {};
}

std::string_view word_of(const Swatch& swatch) {
  if (swatch.of == SwatchOf::stone) return word_of(swatch.look.material);
  return swatch.look.joint_fill == paving::JointFill::mortar ? "mortar" : "sand";
}

}  // namespace

double folded_mm(const paving::Pavement& pavement) { return paving::top_mm(pavement); }

double swatch_side_m(const PavedArea& paved) {
  vec2 largest_mm{0.0, 0.0};
  for (const paving::Stone& stone : paved.layout.stones) {
    const vec2 along = stone.angle.direction();
    geometry::Box box{{0.0, 0.0}, {0.0, 0.0}};
    for (const vec2& p : stone.outline_mm) {
      const vec2 from = p - stone.outline_mm.front();
      const vec2 own{glm::dot(from, along), cross(along, from)};
      box = {glm::min(box.low, own), glm::max(box.high, own)};
    }
    largest_mm = glm::max(largest_mm, box.high - box.low);
  }
  largest_mm += 2.0 * folded_mm(paved.pavement);
  double side_m = 1.0;
  while (side_m < largest_side_m && places_taken(largest_mm, side_m) > most_places_taken) side_m += 1.0;
  return side_m;
}

std::optional<Swatch> stone_swatch(const PavedArea& paved) {
  const paving::Pavement& pavement = paved.pavement;
  if (pavement.textures.swatch_px == 0) return std::nullopt;
  Swatch swatch;
  // What lies in the joints does not show on stones.
  swatch.look = {pavement.look.material, {}, {}, pavement.look.wetness, pavement.look.colours};
  swatch.relief = pavement.relief;
  // In steps of 2, so that pavements of about the same stones share one.
  constexpr double step_mm = 100.0;
  swatch.longest_mm = step_mm * power(2.0, std::round(logarithm(mean_size_mm(pavement) / step_mm) / logarithm(2.0)));
  swatch.side_m = swatch_side_m(paved);
  swatch.size_px = pavement.textures.swatch_px;
  return swatch;
}

std::optional<Swatch> joint_swatch(const PavedArea& paved) {
  const paving::Pavement& pavement = paved.pavement;
  if (pavement.textures.swatch_px == 0) return std::nullopt;
  Swatch swatch;
  swatch.of = SwatchOf::joint;
  swatch.look = {paving::Material::setts, pavement.look.joint_fill, pavement.look.moss, pavement.look.wetness, {}};
  swatch.side_m = joint_side_m;
  swatch.size_px = std::max<std::size_t>(1, pavement.textures.swatch_px / 2);
  return swatch;
}

bool are_alike(const Swatch& a, const Swatch& b) {
  return a.of == b.of && a.look == b.look && a.relief == b.relief && a.longest_mm == b.longest_mm && a.side_m == b.side_m &&
         a.size_px == b.size_px;
}

std::size_t number_in(std::vector<Swatch>& list, Swatch swatch) {
  std::size_t same_word = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (are_alike(list[i], swatch)) return i;
    if (word_of(list[i]) == word_of(swatch)) ++same_word;
  }
  swatch.name = word_of(swatch);
  if (same_word > 0) swatch.name += fmt::format("_{}", same_word + 1);
  list.push_back(std::move(swatch));
  return list.size() - 1;
}

}  // namespace shatterpave::exporting::shapes
