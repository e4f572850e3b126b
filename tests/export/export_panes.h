// Panes for the tests of exporters.
#pragma once

#include <vector>

#include "export/model.h"
#include "glass/breaking.h"
#include "glass/gaps/crack_surface.h"
#include "glass/shards/shards.h"

namespace shatterpave::support {

// 300 × 300 × 2 mm, hit in the middle, with that many radial cracks.
inline glass::Pane pane_with(int radial_count) {
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0, 0}, {300, 0}, {300, 300}, {0, 300}};
  glass::Impact impact;
  impact.at_mm = {150, 150};
  impact.radial_count = radial_count;
  pane.impacts = {impact};
  return pane;
}

inline exporting::BrokenPane broken_pane(const glass::Pane& pane) {
  exporting::BrokenPane broken{pane, glass::broken(pane, 7)};
  if (pane.crack_body == glass::CrackBody::sheet) broken.surfaces = glass::crack_surfaces(pane, broken.network, 7);
  return broken;
}

// The same in shards, of which some have fallen.
inline exporting::BrokenPane shattered_pane(int radial_count, bool joined = false) {
  exporting::BrokenPane broken;
  broken.pane = pane_with(radial_count);
  broken.pane.shards = glass::ShardRules{};
  broken.pane.shards->chips_per_m = 20.0;
  broken.pane.shards->missing_mm = 80.0;
  broken.pane.shards->fallen = 0.5;
  broken.pane.shards->joined = joined;
  broken.network = glass::broken(broken.pane, 7);
  broken.shards = glass::shards(broken.pane, broken.network, 7);
  return broken;
}

// Hand-made cracks from edge to edge, without an impact; the one at `ending` ends on the one before it.
inline glass::CrackNetwork network_of(const std::vector<std::vector<vec2>>& cracks, int ending) {
  glass::CrackNetwork network;
  network.impacts = {{{250, 250}, 0, 0, 0}};
  for (const std::vector<vec2>& points : cracks) {
    const int id = static_cast<int>(network.cracks.size());
    glass::Crack crack{id, 0, glass::CrackKind::large, points, {}, {}};
    crack.start.at = glass::CrackEnd::At::edge;
    crack.end.at = id == ending ? glass::CrackEnd::At::crack : glass::CrackEnd::At::edge;
    if (id == ending) crack.end.crack = id - 1;
    network.cracks.push_back(crack);
  }
  return network;
}

}  // namespace shatterpave::support
