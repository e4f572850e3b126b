#include "pipeline/frame_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace shatterpave::pipeline {

std::vector<std::string> thing_sums(const scene::Scene& scene, const std::vector<PavementPart>& parts) {
  std::vector<std::string> sums = scene.pane_sums;
  for (const PavementPart& part : parts) {
    sums.push_back(
        fmt::format("{} {}{}", scene.pavement_sums.at(part.asked), part.pavement.name, part.is_kerb() ? " kerb" : ""));
  }
  return sums;
}

ChangingThings::ChangingThings(scene::Shot& shot) {
  if (!shot.still().frames) return;
  const scene::FrameSpan range = shot.still().frames->range;
  std::set<int> stops{range.first};
  for (const scene::FrameKey& key : shot.still().frames->keys) {
    // Beyond the range the scene is not asked for, and may be wrong.
    for (const scene::FrameKey::Stop& stop : key.stops) stops.insert(std::clamp(stop.frame, range.first, range.last));
  }
  bool is_first = true;
  if (!shot.changes_things()) stops = {range.first};
  for (const int stop : stops) {
    const scene::Scene scene = shot.at(stop);
    const std::vector<std::string> sums = thing_sums(scene, pavement_parts(scene));
    if (std::exchange(is_first, false)) fixed_ = sums;
    all_change_ = all_change_ || sums.size() != fixed_.size();
    if (all_change_) return;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (fixed_[i] != sums[i]) fixed_[i].clear();
    }
  }
}

exporting::Model& FrameModels::model(const scene::Scene& scene, const Wanted& wanted, const Progress& progress) {
  const std::vector<std::string> sums = thing_sums(scene, pavement_parts(scene));
  const auto is_kept = [&](std::size_t i) { return i < made_.size() && !made_[i].empty() && made_[i] == sums[i]; };
  // Kept things keep their numbers only where there are as many panes.
  if (model_.panes.size() != scene.panes.size()) made_.clear();
  exporting::Model next = generated(
      scene, [&](std::size_t i) { return wanted(i) && !is_kept(i); }, progress);
  const std::size_t panes = next.panes.size();
  std::vector<std::string> made(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (wanted(i) || is_kept(i)) made[i] = sums[i];
    if (!is_kept(i)) continue;
    if (i < panes) {
      std::swap(next.panes[i], model_.panes[i]);
      next.panes[i].pane = model_.panes[i].pane;  // it may stand elsewhere
    } else {
      std::swap(next.pavements[i - panes], model_.pavements[i - panes]);
      next.pavements[i - panes].pavement = model_.pavements[i - panes].pavement;
    }
  }
  model_ = std::move(next);
  made_ = std::move(made);
  return model_;
}

}  // namespace shatterpave::pipeline
