// Frames by their numbers, and ranges of them as they are written: `1-10`, `1-10:2`, `1,5,9-12`.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace shatterpave::scene {

inline constexpr int largest_frame = 9'999'999;
inline constexpr std::size_t most_frames = 100'000;  // of one range

// First and last frame of a shot, 0 <= first <= last.
struct FrameSpan {
  int first = 1;
  int last = 1;

  bool operator==(const FrameSpan&) const = default;
};

// The frames of a range, ascending, each once: at least one. A step of `a-b:n` counts from a. Throws InputError, at `place`,
// where the text is no range: frames are whole numbers from 0 to `largest_frame`, at most `most_frames` of them.
std::vector<int> frames_of_range(std::string_view range, const Place& place);
// A range without gaps.
FrameSpan frame_span_of(std::string_view range, const Place& place);

// Ascending frames as the shortest range without steps: "1-3,7".
std::string range_text(std::span<const int> frames);

// A frame's number as names of files have it: four digits, more where it needs them.
std::string frame_digits(int frame);

}  // namespace shatterpave::scene
