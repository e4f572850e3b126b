#include "pipeline/shot_frames.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <shatterpave/version.h>

#include <algorithm>
#include <iterator>

#include "core/cancel.h"
#include "core/error.h"
#include "core/sha256.h"
#include "pipeline/generate.h"
#include "scene/frame_range.h"

namespace shatterpave::pipeline {

std::string shot_state(const scene::Scene& still) {
  ENSURE(still.frames.has_value());
  Sha256 hash;
  hash.add_text(SHATTERPAVE_VERSION);
  hash.add_text(still.fingerprint);
  for (const scene::FrameKey& key : still.frames->keys) {
    hash.add_text(fmt::format("{} {} {}", key.set, static_cast<int>(key.ease), key.is_list));
    for (const scene::FrameKey::Stop& stop : key.stops)
      hash.add_text(fmt::format("{}: {}", stop.frame, fmt::join(stop.value, " ")));
  }
  return hash.sum();
}

std::vector<int> frames_within(const scene::Scene& still, const std::vector<int>& frames, const Place& place) {
  if (!still.frames)
    throw InputError(place, fmt::format("expected a scene with a table [frames], got none in '{}'", still.name));
  const scene::FrameSpan& range = still.frames->range;
  std::vector<int> within;
  std::ranges::copy_if(frames, std::back_inserter(within),
                       [&](int frame) { return frame >= range.first && frame <= range.last; });
  if (within.empty()) {
    throw InputError(place, fmt::format("expected frames of the scene's range {}-{}, got {}", range.first, range.last,
                                        scene::range_text(frames)));
  }
  return within;
}

void require_frames(scene::Shot& shot, std::span<const int> frames) {
  for (const int frame : frames) {
    stop_if_cancelled();
    const scene::Scene scene = shot.at(frame);
    if (shot.changes_things()) require_possible(scene);
  }
}

}  // namespace shatterpave::pipeline
