#include "scene/schema/idle_keys.h"

#include <cstddef>

#include "scene/schema/pane_keys.h"
#include "scene/schema/pavement_keys.h"
#include "scene/schema/scene_keys.h"

namespace shatterpave::scene {

void tell_idle_keys(const TomlTable& table, const glass::Pane& pane, std::vector<Note>& notes) {
  const PaneFacts facts{table, pane};
  IdleKeys<PaneFacts> idle(facts, notes);
  idle.tell(pane_keys);
  idle.tell(growth_keys);
  idle.tell(rings_keys);
  idle.tell(crater_keys);
  idle.tell(laminate_keys);
  idle.tell(tempering_keys);
  idle.tell(crack_sheet_keys);
  idle.tell(shards_keys);
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

void tell_idle_keys(const TomlTable& table, const paving::Pavement& pavement, bool is_flight, std::vector<Note>& notes) {
  const PavementFacts facts{table, pavement, is_flight};
  IdleKeys<PavementFacts> idle(facts, notes);
  idle.tell(pavement_keys);
  idle.tell(direction_keys);
  idle.tell(surface_keys);
  idle.tell(variation_keys);
  idle.tell(relief_keys);
  idle.tell(textures_keys);
  idle.tell(ground_keys);
  idle.tell(steps_keys);
  idle.tell(detail_keys);
}

void tell_idle_keys(const TomlTable& root, std::vector<Note>& notes) {
  const SceneFacts facts{root};
  IdleKeys<SceneFacts> idle(facts, notes);
  idle.tell(root_keys);
  idle.tell(still_keys);
  idle.tell(plan_keys);
}

}  // namespace shatterpave::scene
