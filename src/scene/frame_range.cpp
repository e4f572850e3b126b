#include "scene/frame_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "scene/input_file.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace {

// Digits alone.
std::optional<int> frame_of(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = !text.empty() && text.front() != '-' && error == std::errc{} && end == text.data() + text.size();
  return whole && value <= largest_frame ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse_range(std::string_view range, std::string_view part, const Place& place) {
  const bool is_negative = part.starts_with('-') || part.find("--") != std::string_view::npos;
  refuse(place, fmt::format("frames such as 1-10, 1-10:2 or 1,5,9-12, each from 0 to {}", largest_frame),
         in_quotes(std::string(range)) + (is_negative ? ", with a negative frame" : ""));
}

// One of the parts between commas.
struct Part {
  int first;
  int last;
  int step;
};

std::optional<Part> part_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto step = colon == std::string_view::npos ? std::optional(1) : frame_of(text.substr(colon + 1));
  const std::string_view span = text.substr(0, colon);
  const std::size_t dash = span.find('-');
  const auto first = frame_of(span.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : frame_of(span.substr(dash + 1));
  const bool stepped_alone = colon != std::string_view::npos && dash == std::string_view::npos;
  if (!first || !last || !step || *step == 0 || stepped_alone) return std::nullopt;
  return Part{*first, *last, *step};
}

}  // namespace

std::vector<int> frames_of_range(std::string_view range, const Place& place) {
  std::set<int> frames;
  for (std::string_view rest = range;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view text = rest.substr(0, comma);
    const auto part = part_of(text);
    if (!part) refuse_range(range, text, place);
    if (part->first > part->last) {
      refuse(place, "the first frame of a range before its last",
             fmt::format("{}; did you mean {}-{}?", in_quotes(std::string(text)), part->last, part->first));
    }
    if (static_cast<std::size_t>((part->last - part->first) / part->step) >= most_frames - frames.size()) {
      refuse(place, fmt::format("at most {} frames", most_frames), "more: " + in_quotes(std::string(range)));
    }
    for (int frame = part->first; frame <= part->last; frame += part->step) frames.insert(frame);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  return {frames.begin(), frames.end()};
}

FrameSpan frame_span_of(std::string_view range, const Place& place) {
  const std::vector<int> frames = frames_of_range(range, place);
  const FrameSpan span{frames.front(), frames.back()};
  if (static_cast<std::size_t>(span.last - span.first) + 1 != frames.size()) {
    refuse(place, "a range without gaps, such as 1-48", in_quotes(std::string(range)));
  }
  return span;
}

std::string range_text(std::span<const int> frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t end = i + 1;
    while (end < frames.size() && frames[end] == frames[end - 1] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", frames[i]);
    if (end - i > 1) text += fmt::format("-{}", frames[end - 1]);
    i = end;
  }
  return text;
}

std::string frame_digits(int frame) { return fmt::format("{:04}", frame); }

}  // namespace shatterpave::scene
