#include "scene/frames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "core/smooth_step.h"

namespace shatterpave::scene {

namespace {

std::vector<double> between(const FrameKey::Stop& from, const FrameKey::Stop& to, int frame, Ease ease) {
  const double even = static_cast<double>(frame - from.frame) / static_cast<double>(to.frame - from.frame);
  const double t = ease == Ease::smooth ? smooth_step(even) : even;
  std::vector<double> value = from.value;
  for (std::size_t i = 0; i < value.size(); ++i) {
    // Both weights are applied, so that what does not change stays as it is, and large numbers do not overflow.
    if (from.value[i] != to.value[i]) value[i] = (1.0 - t) * from.value[i] + t * to.value[i];
  }
  return value;
}

}  // namespace

std::vector<double> value_at(const FrameKey& key, int frame) {
  const auto after = std::ranges::upper_bound(key.stops, frame, {}, &FrameKey::Stop::frame);
  std::vector<double> value;
  if (after == key.stops.begin()) {
    value = after->value;
  } else if (after == key.stops.end() || std::prev(after)->frame == frame) {
    value = std::prev(after)->value;
  } else {
    value = between(*std::prev(after), *after, frame, key.ease);
  }
  if (key.is_whole) {
    for (double& number : value) number = std::round(number);
  }
  return value;
}

}  // namespace shatterpave::scene
