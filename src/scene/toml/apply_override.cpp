#include "scene/toml/apply_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/input_file.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace {

constexpr std::size_t most_steps = 32;  // no key of a scene has more than 6

[[noreturn]] void refuse_key(const Override& change) {
  refuse(Place{change.origin, 0, 0, ""}, "a key such as seed, pane[0].thickness_mm or pavement.path.joint_mm",
         in_quotes(change.key));
}

bool is_key_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// The name at the beginning of `rest`, which loses it; empty where there is none. Quotes may stand around it.
std::string taken_name(std::string_view& rest) {
  const bool is_quoted = rest.starts_with('"') || rest.starts_with('\'');
  const char quote = is_quoted ? rest.front() : '\0';
  if (is_quoted) rest.remove_prefix(1);
  const auto end = std::ranges::find_if_not(rest, is_key_character);
  std::string name(rest.begin(), end);
  rest.remove_prefix(name.size());
  if (!is_quoted) return name;
  if (!rest.starts_with(quote)) return {};
  rest.remove_prefix(1);
  return name;
}

// The same of "[index]".
std::optional<std::size_t> taken_index(std::string_view& rest) {
  std::size_t index = 0;
  const char* const last = rest.data() + rest.size();
  const auto [end, error] = std::from_chars(rest.data() + 1, last, index);
  if (error != std::errc{} || end == last || *end != ']') return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
  return index;
}

}  // namespace

std::optional<std::vector<KeyStep>> steps_of(std::string_view key) {
  std::vector<KeyStep> steps;
  std::string_view rest = key;
  while (!rest.empty() || steps.empty()) {
    if (steps.size() == most_steps) return std::nullopt;
    if (!steps.empty() && rest.starts_with('[')) {
      const auto index = taken_index(rest);
      if (!index) return std::nullopt;
      steps.emplace_back(*index);
      continue;
    }
    if (!steps.empty() && !rest.starts_with('.')) return std::nullopt;
    if (!steps.empty()) rest.remove_prefix(1);
    std::string name = taken_name(rest);
    if (name.empty()) return std::nullopt;
    steps.emplace_back(std::move(name));
  }
  return steps;
}

std::vector<KeyStep> key_steps(const Override& change) {
  auto steps = steps_of(change.key);
  if (!steps) refuse_key(change);
  return std::move(*steps);
}

toml::table parsed_value(const Override& change) {
  try {
    toml::table table = toml::parse("value = " + change.value, change.origin);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
    // Not TOML: a text.
  }
  require_utf8(change.value, change.origin);
  toml::table table = toml::parse("value = \"\"", change.origin);
  **table.get_as<std::string>("value") = change.value;
  return table;
}

namespace {

// The names of the tables of an array.
std::vector<std::string> names_in(const toml::array& array) {
  std::vector<std::string> names;
  for (const toml::node& element : array) {
    const toml::table* table = element.as_table();
    const auto name = table == nullptr ? std::nullopt : table->at_path("name").value<std::string>();
    if (name) names.push_back(*name);
  }
  return names;
}

// Says which elements there are: `path` is that of the array.
[[noreturn]] void refuse_element(const Override& change, const toml::array& array, const std::string& path,
                                 const std::string& got, const std::string& suggested) {
  const Place place{change.origin, 0, 0, ""};
  if (array.empty()) refuse(place, "an element of " + path, fmt::format("{}; there are none", got));
  const std::vector<std::string> names = names_in(array);
  std::vector<std::string> whole;
  for (std::size_t i = 0; i < array.size(); ++i) whole.push_back(fmt::format("{}[{}]", path, i));
  for (const std::string& name : names) whole.push_back(fmt::format("{}.{}", path, name));
  constexpr std::size_t most_listed = 12;
  const bool few = whole.size() <= most_listed;
  const std::string expected = few ? listed({whole.begin(), whole.end()}, "or")
                                   : fmt::format("{} to {}, or one by its name", whole.front(), whole[array.size() - 1]);
  const std::string_view near = nearest(got, {names.begin(), names.end()});
  const std::string meant = near.empty() ? suggested : fmt::format("{}.{}", path, near);
  refuse(place, expected, in_quotes(got) + (meant.empty() ? std::string() : fmt::format("; did you mean {}?", meant)));
}

}  // namespace

std::size_t element_index(const toml::array& array, const KeyStep& step, const Override& change, const std::string& path,
                          const std::string& meant) {
  if (const auto* index = std::get_if<std::size_t>(&step)) {
    if (*index >= array.size()) refuse_element(change, array, path, fmt::format("{}[{}]", path, *index), {});
    return *index;
  }
  const std::string& name = std::get<std::string>(step);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const toml::table* table = array[i].as_table();
    if (table != nullptr && table->at_path("name").value<std::string>() == name) return i;
  }
  refuse_element(change, array, path, name, meant);
}

void refuse_way(const Override& change, const std::string& path, std::string_view what) {
  refuse(Place{change.origin, 0, 0, ""}, "a key that leads to a value",
         fmt::format("one that goes on after {}, which is {}", path.empty() ? "the scene" : path, what));
}

std::string path_of(const std::vector<KeyStep>& steps, std::size_t count) {
  std::string path;
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto* index = std::get_if<std::size_t>(&steps[i])) {
      path += fmt::format("[{}]", *index);
    } else {
      path += (path.empty() ? "" : ".") + std::get<std::string>(steps[i]);
    }
  }
  return path;
}

namespace {

// `path` leads to `node`.
toml::node& next_node(toml::node& node, const KeyStep& step, const Override& change, const std::string& path) {
  if (toml::array* array = node.as_array()) return (*array)[element_index(*array, step, change, path)];
  toml::table* table = node.as_table();
  const auto* key = std::get_if<std::string>(&step);
  if (table == nullptr || key == nullptr) refuse_way(change, path, description(node));
  if (!table->contains(*key)) {
    toml::table made = toml::parse("value = {}", change.origin);  // parsed, so that messages know where it came from
    table->insert(*key, std::move(*made.get_as<toml::table>("value")));
  }
  return *table->get(*key);
}

// Where all steps but the last lead.
toml::node& parent_node(toml::table& scene, const std::vector<KeyStep>& steps, const Override& change) {
  toml::node* parent = &scene;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) parent = &next_node(*parent, steps[i], change, path_of(steps, i));
  return *parent;
}

// A value of TOML that knows where it came from.
toml::table parsed_literal(std::string_view literal, const Override& change) {
  return toml::parse(fmt::format("value = {}", literal), change.origin);
}

}  // namespace

void apply(const Override& change, toml::table& scene) {
  const std::vector<KeyStep> steps = key_steps(change);
  toml::node* const parent = &parent_node(scene, steps, change);
  const std::string path = path_of(steps, steps.size() - 1);
  toml::table value = parsed_value(change);
  // Moved, not copied: a copy forgets where it came from, which messages show.
  std::move(*value.get("value")).visit([&](auto&& node) {
    if (toml::array* array = parent->as_array()) {
      const auto at = static_cast<std::ptrdiff_t>(element_index(*array, steps.back(), change, path));
      array->replace(array->begin() + at, std::forward<decltype(node)>(node));
    } else if (parent->is_table() && std::holds_alternative<std::string>(steps.back())) {
      parent->as_table()->insert_or_assign(std::get<std::string>(steps.back()), std::forward<decltype(node)>(node));
    } else {
      next_node(*parent, steps.back(), change, path);  // says what is wrong
    }
  });
}

std::string append_table(const Override& change, toml::table& scene) {
  const std::vector<KeyStep> steps = key_steps(change);
  toml::node& parent = parent_node(scene, steps, change);
  toml::table* const table = parent.as_table();
  const auto* const key = std::get_if<std::string>(&steps.back());
  if (table != nullptr && key != nullptr && !table->contains(*key)) {
    toml::table made = parsed_literal("[]", change);
    table->insert(*key, std::move(*made.get_as<toml::array>("value")));
  }
  toml::node& node = next_node(parent, steps.back(), change, path_of(steps, steps.size() - 1));
  toml::array* const array = node.as_array();
  if (array == nullptr || !(array->empty() || array->is_array_of_tables())) {
    refuse(Place{change.origin, 0, 0, ""}, "a list of tables, such as pane or pane[0].impact",
           fmt::format("{}, which is {}", in_quotes(change.key), description(node)));
  }
  require_utf8(change.value, change.origin);
  toml::table made = parsed_literal(change.value, change);
  array->push_back(std::move(*made.get_as<toml::table>("value")));
  return fmt::format("{}[{}]", change.key, array->size() - 1);
}

}  // namespace shatterpave::scene
