#include "scene/toml/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

// Points of one file, all lists together: 1 million is 20 MB of TOML.
constexpr std::size_t most_points = 1'000'000;

// `form` is what messages call it: "a point [x, y]".
template <typename Point>
Point point_of(const toml::node& node, std::string_view form, const Range& range, const std::string& file,
               const std::string& path) {
  const toml::array* list = node.as_array();
  Point point{};
  if (list == nullptr || list->size() != static_cast<std::size_t>(point.length())) {
    refuse(place_of(node, file, path), form, description(node));
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string key = fmt::format("{}[{}]", path, i);
    point[i] = number_of((*list)[i], range, place_of((*list)[i], file, key));
  }
  return point;
}

vec2 point_of(const toml::node& node, const Range& range, const std::string& file, const std::string& path) {
  return point_of<vec2>(node, "a point [x, y]", range, file, path);
}

// As a double, a number that is whole but is written 3.0 is none.
std::int64_t whole_number_of(const toml::node& node, const WholeRange& range, const Place& place) {
  const std::optional<std::int64_t> value = node.value_exact<std::int64_t>();
  if (!value || *value < range.low || *value > range.high) refuse(place, description(range), description(node));
  return *value;
}

std::vector<vec2> points_of(const toml::node& node, const Range& range, const std::string& file, const std::string& path) {
  const toml::array* list = node.as_array();
  if (list == nullptr) refuse(place_of(node, file, path), "a list of points [[x, y], …]", description(node));
  if (list->size() > most_points) {
    refuse(place_of(node, file, path), fmt::format("at most {} points", most_points), fmt::format("{}", list->size()));
  }
  std::vector<vec2> points;
  points.reserve(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    points.push_back(point_of((*list)[i], range, file, fmt::format("{}[{}]", path, i)));
  }
  return points;
}

}  // namespace

void refuse(const Place& place, std::string_view expected, std::string_view got) {
  throw InputError(place, fmt::format("expected {}, got {}", expected, got));
}

std::string description(const Range& range) {
  if (!range.open_low && !range.open_high) return fmt::format("a number from {} to {}", range.low, range.high);
  return fmt::format("a number {} {} and {} {}", range.open_low ? "above" : "of at least", range.low,
                     range.open_high ? "below" : "of at most", range.high);
}

std::string description(const WholeRange& range) { return fmt::format("a whole number from {} to {}", range.low, range.high); }

std::string description(const toml::node& node) {
  if (const auto* value = node.as_string()) return fmt::format("the text {}", in_quotes(value->get()));
  if (const auto* value = node.as_integer()) return fmt::format("{}", value->get());
  if (const auto* value = node.as_floating_point()) return fmt::format("{}", value->get());
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  if (const auto* array = node.as_array()) {
    return fmt::format("a list of {} value{}", array->size(), array->size() == 1 ? "" : "s");
  }
  return node.is_table() ? "a table" : "a date or time";
}

Place place_of(const toml::node& node, const std::string& file, const std::string& key) {
  const toml::source_region& source = node.source();
  if (source.path && *source.path != file) return {*source.path, 0, 0, key};
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column), key};
}

double number_of(const toml::node& node, const Range& range, const Place& place) {
  if (!node.is_number()) refuse(place, description(range), description(node));
  const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
  const bool within =
      (range.open_low ? value > range.low : value >= range.low) && (range.open_high ? value < range.high : value <= range.high);
  if (!within) refuse(place, description(range), description(node));  // NaN too: it is neither above nor below
  return value;
}

TomlTable::TomlTable(const toml::table& table, const std::string& file, std::string path, Keys keys)
    : table_(table), file_(file), path_(std::move(path)) {
  refuse_unknown(keys);
}

std::string TomlTable::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

// The first unknown key of the file, with the known one that was likely meant.
void TomlTable::refuse_unknown(Keys keys) const {
  std::optional<Place> first;
  std::string_view name;
  for (const auto& [key, value] : table_) {
    if (std::ranges::find(keys, key.str()) != keys.end()) continue;
    // The key stands before its value, except in a table's header, whose place is the whole header's.
    Place place = place_of(value, file_, path_of(in_quotes(key.str()).size() == key.str().size() + 2 ? key.str() : "?"));
    const toml::source_region& source = key.source();
    if (place.file == file_ && source.begin.line > 0) {
      place.line = static_cast<int>(source.begin.line);
      place.column = static_cast<int>(source.begin.column);
    }
    if (first && std::pair(first->line, first->column) <= std::pair(place.line, place.column)) continue;
    first = place;
    name = key.str();
  }
  if (!first) return;
  throw InputError(*first, fmt::format("unknown key; {}", hint(name, {keys.begin(), keys.end()})));
}

Place TomlTable::place(std::string_view key) const {
  const toml::node* node = find(key);
  return place_of(node != nullptr ? *node : table_, file_, path_of(key));
}

std::optional<Place> TomlTable::place_of_given(std::string_view path) const {
  const auto view = table_.at_path(path);
  if (view.node() == nullptr) return std::nullopt;
  return place_of(*view.node(), file_, path_of(path));
}

std::optional<double> TomlTable::number(std::string_view key, const Range& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return number_of(*node, range, place(key));
}

std::optional<std::int64_t> TomlTable::whole_number(std::string_view key, const WholeRange& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return whole_number_of(*node, range, place(key));
}

std::optional<bool> TomlTable::flag(std::string_view key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) refuse(place(key), "true or false", description(*node));
  return node->as_boolean()->get();
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) refuse(place(key), "a text in quotes", description(*node));
  return node->as_string()->get();
}

std::vector<std::variant<std::size_t, std::string>> TomlTable::indices_or_texts(std::string_view key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  std::vector<std::variant<std::size_t, std::string>> result;
  const auto add = [&](const toml::node& value, const Place& place) {
    const auto* index = value.as_integer();
    if (value.is_string()) {
      result.emplace_back(value.as_string()->get());
    } else if (index != nullptr && index->get() >= 0) {
      result.emplace_back(static_cast<std::size_t>(index->get()));
    } else {
      refuse(place, "an id in quotes or an index from 0", description(value));
    }
  };
  const toml::array* list = node->as_array();
  if (list == nullptr) {
    add(*node, place(key));
    return result;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    add((*list)[i], place_of((*list)[i], file_, fmt::format("{}[{}]", path_of(key), i)));
  }
  if (result.empty()) refuse(place(key), "one or more ids or indices", "an empty list");
  return result;
}

std::optional<vec2> TomlTable::point(std::string_view key, const Range& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return point_of(*node, range, file_, path_of(key));
}

std::optional<vec3> TomlTable::place_in_space(std::string_view key, const Range& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return point_of<vec3>(*node, "a place [x, y, z]", range, file_, path_of(key));
}

std::optional<std::array<int, 2>> TomlTable::pixels(std::string_view key, const WholeRange& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* pair = node->as_array();
  if (pair == nullptr || pair->size() != 2) refuse(place(key), "a size [width, height]", description(*node));
  std::array<int, 2> size{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string path = fmt::format("{}[{}]", path_of(key), i);
    size.at(i) = static_cast<int>(whole_number_of((*pair)[i], range, place_of((*pair)[i], file_, path)));
  }
  return size;
}

std::optional<PlacedPoints> TomlTable::points(std::string_view key, const Range& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return PlacedPoints{points_of(*node, range, file_, path_of(key)), place(key)};
}

std::vector<PlacedPoints> TomlTable::point_lists(std::string_view key, const Range& range) const {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* lists = node->as_array();
  if (lists == nullptr) refuse(place(key), "a list of lists of points [[[x, y], …], …]", description(*node));
  std::vector<PlacedPoints> result;
  for (std::size_t i = 0; i < lists->size(); ++i) {
    const std::string path = fmt::format("{}[{}]", path_of(key), i);
    result.push_back({points_of((*lists)[i], range, file_, path), place_of((*lists)[i], file_, path)});
  }
  return result;
}

std::optional<std::size_t> TomlTable::choice(std::string_view key, std::span<const std::string_view> choices) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto* value = node->as_string();
  const auto found = value == nullptr ? choices.end() : std::ranges::find(choices, std::string_view(value->get()));
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  std::string expected;
  for (const std::string_view name : choices) expected += fmt::format("{}\"{}\"", expected.empty() ? "" : " or ", name);
  const std::string_view meant =
      value == nullptr ? std::string_view() : nearest(value->get(), {choices.begin(), choices.end()});
  refuse(place(key), expected,
         description(*node) + (meant.empty() ? std::string() : fmt::format("; did you mean \"{}\"?", meant)));
}

std::optional<TomlTable> TomlTable::table(std::string_view key, Keys keys) const {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) refuse(place(key), fmt::format("a table [{}]", path_of(key)), description(*node));
  return TomlTable(*node->as_table(), file_, path_of(key), keys);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, std::size_t limit, Keys keys) const {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  const std::string expected = fmt::format("tables [[{}]]", path_of(key));
  if (array == nullptr) refuse(place(key), expected, description(*node));
  if (array->size() > limit) {
    refuse(place(key), fmt::format("at most {} {}", limit, expected), fmt::format("{}", array->size()));
  }
  std::vector<TomlTable> result;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const toml::node& element = (*array)[i];
    const std::string path = fmt::format("{}[{}]", path_of(key), i);
    if (!element.is_table()) refuse(place_of(element, file_, path), "a table", description(element));
    result.emplace_back(*element.as_table(), file_, path, keys);
  }
  return result;
}

}  // namespace shatterpave::scene
