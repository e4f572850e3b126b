#include "pipeline/shot_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
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

// Whether a value is another at another frame. One that some of the frames do not have is none.
template <typename Value>
bool changes(const std::vector<Value>& values, std::size_t frames) {
  return values.size() == frames && std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) != values.end();
}

bool may_move(const scene::FrameKey& key) { return key.set.starts_with("camera.") || key.set.ends_with(".time_s"); }

}  // namespace

void add_paths(exporting::Model& model, scene::Shot& shot) {
  const auto& frames = shot.still().frames;
  if (!frames || !std::ranges::any_of(frames->keys, may_move)) return;
  const scene::FrameSpan range = frames->range;
  std::vector<std::vector<double>> times_s(model.panes.size());
  std::vector<studio::Camera> cameras;
  for (int frame = range.first; frame <= range.last; ++frame) {
    const scene::Scene scene = shot.at(frame);
    if (scene.camera) cameras.push_back(*scene.camera);
    for (std::size_t i = 0; i < scene.panes.size() && i < times_s.size(); ++i) {
      const auto& shards = scene.panes[i].shards;
      if (shards && shards->time_s) times_s[i].push_back(*shards->time_s);
    }
  }
  const auto count = static_cast<std::size_t>(range.last - range.first) + 1;
  const exporting::ShotSpan span{range.first, range.last, frames->per_second};
  if (changes(cameras, count)) {
    model.camera_path = std::move(cameras);
    model.shot = span;
  }
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (!changes(times_s[i], count)) continue;
    model.panes[i].paths = paths_at(model.panes[i], times_s[i], model.seed);
    model.shot = span;
  }
}

}  // namespace shatterpave::pipeline
