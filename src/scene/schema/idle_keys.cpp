#include "scene/schema/idle_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "paving/limits.h"
#include "scene/schema/pane_keys.h"
#include "scene/schema/pavement_keys.h"
#include "scene/schema/scene_keys.h"

namespace shatterpave::scene {

namespace {

// Of sections with the same facts, from `table` on, "" or "pane[0]".
template <typename Facts, typename... Sections>
void add_idle(const std::string& table, const Facts& facts, std::vector<std::string>& paths, const Sections&... sections) {
  const auto add = [&](const auto& section) {
    for (const std::string& path : idle_paths(section, facts)) {
      paths.push_back(fmt::format("{}{}{}", table, table.empty() ? "" : ".", path));
    }
  };
  (add(sections), ...);
}

// Calls act(section …) with all sections of a thing's own facts, so that what is told of given keys and what is listed of all
// agree.
template <typename Act>
auto with_pane_sections(Act act) {
  return act(pane_keys, growth_keys, rings_keys, crater_keys, laminate_keys, tempering_keys, crack_sheet_keys, shards_keys);
}
template <typename Act>
auto with_pavement_sections(Act act) {
  return act(pavement_keys, direction_keys, size_keys, surface_keys, cell_keys, variation_keys, hand_keys, relief_keys,
             textures_keys, ground_keys, steps_keys, detail_keys);
}
template <typename Act>
auto with_scene_sections(Act act) {
  return act(root_keys, still_keys, camera_keys, light_keys, plan_keys);
}

void add_idle_of_pane(const TomlTable& table, const glass::Pane& pane, std::vector<std::string>& paths) {
  const PaneFacts facts{table, pane};
  with_pane_sections([&](const auto&... sections) { add_idle(table.path(), facts, paths, sections...); });
  const std::vector<TomlTable> impacts = impact_keys.tables_in(table, most_impacts);
  for (std::size_t i = 0; i < std::min(impacts.size(), pane.impacts.size()); ++i) {
    add_idle(impacts[i].path(), ImpactFacts{impacts[i], facts, pane.impacts[i]}, paths, impact_keys);
  }
}

// Of the things of one table the first stands for all.
template <typename Thing>
const Thing* thing_of(const std::string& path, const std::vector<Thing>& things, const std::vector<KeyPlaces>& places) {
  for (std::size_t i = 0; i < std::min(things.size(), places.size()); ++i) {
    if (places[i].place("").key == path) return &things[i];
  }
  return nullptr;
}

}  // namespace

void tell_idle_keys(const TomlTable& table, const glass::Pane& pane, std::vector<Note>& notes) {
  const PaneFacts facts{table, pane};
  IdleKeys<PaneFacts> idle(facts, notes);
  with_pane_sections([&](const auto&... sections) { (idle.tell(sections), ...); });
  const std::vector<TomlTable> impacts = impact_keys.tables_in(table, pane.impacts.size());
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    if (i > 0 && facts.is_tempered()) {
      add_note({impacts[i].place(), "has no effect on tempered glass, which breaks at its first impact"}, notes);
      continue;
    }
    const ImpactFacts of_impact{impacts[i], facts, pane.impacts[i]};
    IdleKeys<ImpactFacts>(of_impact, notes).tell(impact_keys);
  }
}

void tell_idle_keys(const TomlTable& table, const paving::Pavement& pavement, std::vector<Note>& notes) {
  const PavementFacts facts{table, pavement};
  IdleKeys<PavementFacts> idle(facts, notes);
  with_pavement_sections([&](const auto&... sections) { (idle.tell(sections), ...); });
}

void tell_idle_keys(const TomlTable& root, std::vector<Note>& notes) {
  const SceneFacts facts{root};
  IdleKeys<SceneFacts> idle(facts, notes);
  with_scene_sections([&](const auto&... sections) { (idle.tell(sections), ...); });
}

std::vector<std::string> idle_key_paths(const TomlTable& root, const Scene& scene) {
  std::vector<std::string> paths;
  with_scene_sections([&](const auto&... sections) { add_idle("", SceneFacts{root}, paths, sections...); });
  for (const TomlTable& table : pane_keys.tables_in(root, most_panes)) {
    const glass::Pane* pane = thing_of(table.path(), scene.panes, scene.pane_places);
    if (pane != nullptr) add_idle_of_pane(table, *pane, paths);
  }
  for (const TomlTable& table : pavement_keys.tables_in(root, paving::most_pavements)) {
    const paving::Pavement* pavement = thing_of(table.path(), scene.pavements, scene.pavement_places);
    if (pavement == nullptr) continue;
    const PavementFacts facts{table, *pavement};
    with_pavement_sections([&](const auto&... sections) { add_idle(table.path(), facts, paths, sections...); });
  }
  return paths;
}

}  // namespace shatterpave::scene
