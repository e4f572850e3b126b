// The keys of a [[pane]], one row each.
#pragma once

#include <cstddef>

#include "glass/pane.h"
#include "scene/schema/pane_facts.h"
#include "scene/schema/row.h"

namespace shatterpave::scene {

inline constexpr std::size_t most_panes = 1000;
inline constexpr std::size_t most_impacts = 1000;

// [pane.shards] as it stands in the file.
struct ShardsAsked {
  glass::ShardRules rules;
  bool enabled = true;  // false: as if the table were not there
};

extern const Section<glass::Pane, PaneFacts> pane_keys;
extern const Section<glass::Impact, ImpactFacts> impact_keys;
extern const Section<glass::Growth, PaneFacts> growth_keys;
extern const Section<glass::Rings, PaneFacts> rings_keys;
extern const Section<glass::Pane, PaneFacts> crater_keys;
extern const Section<glass::Laminated, PaneFacts> laminate_keys;
extern const Section<glass::Tempered, PaneFacts> tempering_keys;
extern const Section<glass::CrackSheet, PaneFacts> crack_sheet_keys;
extern const Section<ShardsAsked, PaneFacts> shards_keys;

}  // namespace shatterpave::scene
