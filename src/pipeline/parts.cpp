#include "pipeline/parts.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "paving/derived/parts.h"
#include "paving/limits.h"
#include "pipeline/placed.h"
#include "scene/schema/names.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::pipeline {

namespace {

constexpr std::string_view kerb_key = "ground.kerb_width_mm";

const scene::KeyPlaces& places_of(const scene::Scene& scene, std::size_t asked) {
  return places_at(scene.pavement_places, asked);
}

scene::Names names_of_panes(const scene::Scene& scene) {
  scene::Names names;
  for (std::size_t i = 0; i < scene.panes.size(); ++i) {
    const scene::KeyPlaces& places = places_at(scene.pane_places, i);
    const std::string& name = scene.panes[i].name;
    names.add(name, known_place(places, name, "").key, known_place(places, name, "name"));
  }
  return names;
}

}  // namespace

std::vector<PavementPart> pavement_parts(const scene::Scene& scene) {
  std::vector<PavementPart> result;
  scene::Names names = names_of_panes(scene);
  std::size_t count = 0;   // without kerbs
  std::size_t number = 1;  // of the next part of the same name
  for (std::size_t i = 0; i < scene.pavements.size(); ++i) {
    const std::string& name = scene.pavements[i].name;
    const Place table = known_place(places_of(scene, i), name, "");
    if (i > 0 && scene.pavements[i - 1].name != name) number = 1;
    for (paving::Part& part : paving::parts(scene.pavements[i], number)) {
      if (!part.is_kerb() && ++count > paving::most_pavements) {
        scene::refuse(table, fmt::format("at most {} areas in all", paving::most_pavements), "more");
      }
      const bool is_first = part.is_kerb() || number == 1;
      names.add(part.pavement.name, is_first ? table.key : fmt::format("part {} of {}", number, table.key),
                known_place(places_of(scene, i), name, "name"));
      if (!part.is_kerb()) ++number;
      result.push_back({std::move(part.pavement), i, part.stones});
    }
  }
  return result;
}

Place place_of(const scene::Scene& scene, const PavementPart& part, std::string_view member) {
  const std::string& name = part.is_kerb() ? scene.pavements[part.asked].name : part.pavement.name;
  return known_place(places_of(scene, part.asked), name, part.is_kerb() ? kerb_key : member);
}

void with_places(const scene::Scene& scene, const PavementPart& part, const std::function<void()>& work) {
  const scene::KeyPlaces& places = places_of(scene, part.asked);
  if (!part.is_kerb()) {
    with_places(part.pavement.name, places, work);
    return;
  }
  try {
    work();
  } catch (const InputError& error) {
    const Place place = places.place(kerb_key);
    if (!error.place().file.empty() || place.file.empty()) throw;
    throw InputError(place, "kerb: " + error.message());
  }
}

}  // namespace shatterpave::pipeline
