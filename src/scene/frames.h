// A shot: the frames of a scene, and the numbers of it that change over them.
#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/frame_range.h"

namespace shatterpave::scene {

enum class Ease {
  linear,  // evenly from one stop to the next
  smooth   // at rest at each stop, 3 t² − 2 t³ between two
};

// One number of the scene, or a list of numbers such as a place, over the frames.
struct FrameKey {
  struct Stop {
    int frame = 1;
    std::vector<double> value;  // finite; of all stops as many
    bool operator==(const Stop&) const = default;
  };

  std::string set;          // a path as --set takes it (scene/override.h)
  std::vector<Stop> stops;  // ascending, at least one
  Ease ease = Ease::linear;
  bool is_list = false;   // the value is written as a list
  bool is_whole = false;  // the scene takes whole numbers alone: values are rounded to the nearest
  Place place;            // of the stops

  bool operator==(const FrameKey& other) const {
    return set == other.set && stops == other.stops && ease == other.ease && is_list == other.is_list;
  }
};

struct Frames {
  FrameSpan range;
  double per_second = 24.0;  // the cinema's
  std::vector<FrameKey> keys;

  bool operator==(const Frames&) const = default;
};

// The value of the key at a frame: that of the first stop before it, of the last after it. At a stop it is the stop's, to the
// bit.
std::vector<double> value_at(const FrameKey& key, int frame);

}  // namespace shatterpave::scene
