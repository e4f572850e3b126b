#include "pipeline/shot_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "glass/breaking.h"
#include "glass/shards/shards.h"

namespace shatterpave::pipeline {

namespace {

// 28 bytes each in a file, a few hundred in memory: 4 GB.
constexpr std::size_t most_places = 10'000'000;

using Paths = std::map<std::string, std::vector<glass::ShardPlace>>;

// Where they are at times that may come in any order.
Paths paths_at(const exporting::BrokenPane& broken, const std::vector<double>& times_s, std::uint64_t seed) {
  std::vector<double> sorted = times_s;
  std::ranges::sort(sorted);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  // The network of the still may be one that grows yet.
  glass::Pane pane = broken.pane;
  pane.time_us.reset();
  const Paths in_order = glass::shard_paths(pane, glass::broken(pane, seed), seed, sorted);
  if (in_order.size() * times_s.size() > most_places) {
    throw InputError(Place{"", 0, 0, "frames.range"},
                     fmt::format("expected at most {} places of pieces over the frames, got {} pieces in {} frames",
                                 most_places, in_order.size(), times_s.size()));
  }
  Paths paths;
  for (const auto& [id, places] : in_order) {
    std::vector<glass::ShardPlace>& path = paths[id];
    path.reserve(times_s.size());
    for (const double time_s : times_s) {
      path.push_back(places[static_cast<std::size_t>(std::ranges::lower_bound(sorted, time_s) - sorted.begin())]);
    }
  }
  return paths;
}

}  // namespace

void add_paths(exporting::Model& model, scene::Shot& shot) {
  const auto& frames = shot.still().frames;
  if (!frames || !std::ranges::any_of(frames->keys, [](const scene::FrameKey& key) { return key.set.ends_with(".time_s"); })) {
    return;
  }
  const scene::FrameSpan range = frames->range;
  std::vector<std::vector<double>> times_s(model.panes.size());
  for (int frame = range.first; frame <= range.last; ++frame) {
    const scene::Scene scene = shot.at(frame);
    for (std::size_t i = 0; i < scene.panes.size() && i < times_s.size(); ++i) {
      const auto& shards = scene.panes[i].shards;
      if (shards && shards->time_s) times_s[i].push_back(*shards->time_s);
    }
  }
  const auto count = static_cast<std::size_t>(range.last - range.first) + 1;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const bool moves =
        times_s[i].size() == count && std::ranges::adjacent_find(times_s[i], std::ranges::not_equal_to{}) != times_s[i].end();
    if (!moves) continue;
    model.panes[i].paths = paths_at(model.panes[i], times_s[i], model.seed);
    model.shot = exporting::ShotSpan{range.first, range.last, frames->per_second};
  }
}

}  // namespace shatterpave::pipeline
