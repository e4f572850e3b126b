#include "scene/schema/frame_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "scene/input_file.h"
#include "scene/schema/key_tables.h"
#include "scene/schema/words.h"

namespace shatterpave::scene {

namespace {

using FramesRow = Row<Frames, SceneFacts>;
using FrameKeyRow = Row<FrameKey, SceneFacts>;

constexpr std::size_t most_numbers = 64;  // of a list: none that a key of a scene takes is longer, but for lines

constexpr auto ease_words = std::to_array<Word<Ease>>({{"linear", Ease::linear}, {"smooth", Ease::smooth}});

constexpr Range finite{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};

bool is_of_numbers(ValueType type) {
  constexpr auto types = std::to_array({ValueType::number, ValueType::whole_number, ValueType::point, ValueType::place,
                                        ValueType::pixels, ValueType::limits, ValueType::points, ValueType::point_lists});
  return std::ranges::find(types, type) != types.end();
}

// What a path that leads to no number leads to.
std::string what_is(const Key& key) {
  switch (key.type) {
    case ValueType::flag:
      return "true or false";
    case ValueType::choice:
      return "one of several words";
    case ValueType::table:
    case ValueType::tables:
      return "a table";
    default:
      return "a text";
  }
}

void read_path(const TomlTable& table, FrameKey& key) {
  const auto path = table.text("set");
  if (!path) refuse(table.place("set"), "the path of a number of the scene, such as camera.at_mm", "none");
  if (*path == "frames" || path->starts_with("frames.")) {
    refuse(table.place("set"), "the path of a number of the scene", in_quotes(*path) + ", which is of the frames themselves");
  }
  key.set = *path;
  const Key* const known = key_of_path(*path);
  if (known == nullptr) return;  // told with the name that was meant once it is set
  if (!is_of_numbers(known->type)) {
    refuse(table.place("set"), "the path of a number of the scene",
           fmt::format("{}, which is {}", in_quotes(*path), what_is(*known)));
  }
  key.is_whole = known->whole_range.has_value();
}

std::vector<double> numbers_of(const toml::node& node, const std::string& file, const std::string& path, bool& is_list) {
  const toml::array* const list = node.as_array();
  is_list = list != nullptr;
  if (list == nullptr) return {number_of(node, finite, place_of(node, file, path))};
  if (list->empty() || list->size() > most_numbers) {
    refuse(place_of(node, file, path), fmt::format("a number, or a list of 1 to {} numbers", most_numbers), description(node));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string element = fmt::format("{}[{}]", path, i);
    numbers.push_back(number_of((*list)[i], finite, place_of((*list)[i], file, element)));
  }
  return numbers;
}

FrameKey::Stop stop_of(const toml::node& node, const std::string& file, const std::string& path, bool& is_list) {
  const toml::array* const pair = node.as_array();
  if (pair == nullptr || pair->size() != 2) refuse(place_of(node, file, path), "[frame, value]", description(node));
  const toml::node& frame = (*pair)[0];
  const Place place = place_of(frame, file, path + "[0]");
  const WholeRange range{0, largest_frame};
  const auto* const number = frame.as_integer();
  if (number == nullptr || number->get() < range.low || number->get() > range.high) {
    refuse(place, "a frame, " + description(range), description(frame));
  }
  return {static_cast<int>(number->get()), numbers_of((*pair)[1], file, path + "[1]", is_list)};
}

void read_stops(const TomlTable& table, FrameKey& key) {
  const toml::node* const node = table.node().get("at");
  key.place = table.place("at");
  const std::string expected = "stops [[frame, value], …], frames ascending";
  if (node == nullptr) refuse(key.place, expected, "none");
  const toml::array* const list = node->as_array();
  if (list == nullptr || list->empty()) refuse(key.place, expected, description(*node));
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string path = fmt::format("{}.at[{}]", table.path(), i);
    const Place place = place_of((*list)[i], table.file(), path);
    bool is_list = false;
    FrameKey::Stop stop = stop_of((*list)[i], table.file(), path, is_list);
    if (i == 0) key.is_list = is_list;
    if (i > 0 && stop.frame <= key.stops.back().frame) {
      refuse(place, fmt::format("a frame after {}", key.stops.back().frame), fmt::format("{}", stop.frame));
    }
    if (i > 0 && (is_list != key.is_list || stop.value.size() != key.stops.back().value.size())) {
      refuse(place, "values alike at all frames", "a number and a list, or lists of different lengths");
    }
    key.stops.push_back(std::move(stop));
  }
}

}  // namespace

const Section<Frames, SceneFacts> frames_keys{
    "frames",
    {
        FramesRow::by_code("range", ValueType::text, "first and last frame of the shot: `\"1-48\"`")
            .written("`\"FIRST-LAST\"`, each 0 … 9,999,999, at most 100,000 frames")
            .by_default("must be given"),
        FramesRow::number("per_second", &Frames::per_second, {1.0, 1000.0},
                          "frames of a second, told to targets that hold motion"),
        FramesRow::tables("key", most_frame_keys, "a number of the scene each, over the frames").by_default("none"),
    }};

const Section<FrameKey, SceneFacts> frame_key_keys{
    "frames.key[]",
    {
        FrameKeyRow::by_code("set", ValueType::text,
                             "which number: a path as `--set` takes it, such as `camera.at_mm` or `pavement.path.joint_mm`")
            .by_default("must be given"),
        FrameKeyRow::by_code(
            "at", ValueType::points,
            "its value at some frames, a number or a list such as a place. Before the first and after the last it "
            "stays; whole numbers are rounded between")
            .written("`[[frame, value], …]`, frames ascending")
            .by_default("must be given"),
        FrameKeyRow::choice("ease", &FrameKey::ease, ease_words,
                            "how it goes from one to the next: evenly, or at rest at each"),
    }};

std::optional<Frames> frames_of(const TomlTable& root) {
  Frames frames;
  const auto table = frames_keys.read_in(root, frames);
  if (!table) return std::nullopt;
  const auto range = table->text("range");
  if (!range) refuse(table->place("range"), "the range of the shot, such as \"1-48\"", "none");
  frames.range = frame_span_of(*range, table->place("range"));
  for (const TomlTable& asked : frame_key_keys.tables_in(*table, most_frame_keys)) {
    FrameKey key;
    frame_key_keys.read(asked, key);
    read_path(asked, key);
    if (std::ranges::find(frames.keys, key.set, &FrameKey::set) != frames.keys.end()) {
      refuse(asked.place("set"), "one [[frames.key]] of a path", "another of " + in_quotes(key.set));
    }
    read_stops(asked, key);
    frames.keys.push_back(std::move(key));
  }
  return frames;
}

}  // namespace shatterpave::scene
