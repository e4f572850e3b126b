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

}  // namespace

std::vector<KeyStep> key_steps(const Override& change) {
  std::vector<KeyStep> steps;
  const std::string& key = change.key;
  std::size_t at = 0;
  while (at < key.size() || steps.empty()) {
    if (steps.size() == most_steps) refuse_key(change);
    if (at < key.size() && key[at] == '[' && !steps.empty()) {
      std::size_t index = 0;
      const auto [end, error] = std::from_chars(key.data() + at + 1, key.data() + key.size(), index);
      if (error != std::errc{} || end == key.data() + key.size() || *end != ']') refuse_key(change);
      steps.emplace_back(index);
      at = static_cast<std::size_t>(end - key.data()) + 1;
      continue;
    }
    if (!steps.empty() && (key[at] != '.' || ++at == key.size())) refuse_key(change);
    const std::size_t start = at;
    while (at < key.size() && is_key_character(key[at])) ++at;
    if (at == start) refuse_key(change);
    steps.emplace_back(key.substr(start, at - start));
  }
  return steps;
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
                                 const std::string& got) {
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
  const std::string_view meant = nearest(got, {names.begin(), names.end()});
  refuse(place, expected, in_quotes(got) + (meant.empty() ? std::string() : fmt::format("; did you mean {}.{}?", path, meant)));
}

}  // namespace

toml::node& element_of(toml::array& array, const KeyStep& step, const Override& change, const std::string& path) {
  if (const auto* index = std::get_if<std::size_t>(&step)) {
    if (*index >= array.size()) refuse_element(change, array, path, fmt::format("{}[{}]", path, *index));
    return array[*index];
  }
  const std::string& name = std::get<std::string>(step);
  for (toml::node& element : array) {
    const toml::table* table = element.as_table();
    if (table != nullptr && table->at_path("name").value<std::string>() == name) return element;
  }
  refuse_element(change, array, path, name);
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
  if (toml::array* array = node.as_array()) return element_of(*array, step, change, path);
  toml::table* table = node.as_table();
  const auto* key = std::get_if<std::string>(&step);
  if (table == nullptr || key == nullptr) {
    refuse(Place{change.origin, 0, 0, ""}, "a key that leads to a value",
           fmt::format("one that goes on after {}, which is {}", path.empty() ? "the scene" : path, description(node)));
  }
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
      const toml::node& old = element_of(*array, steps.back(), change, path);
      const auto at = std::ranges::find_if(*array, [&](const toml::node& element) { return &element == &old; });
      array->replace(at, std::forward<decltype(node)>(node));
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
