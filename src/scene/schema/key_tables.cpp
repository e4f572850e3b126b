#include "scene/schema/key_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "scene/schema/frame_keys.h"
#include "scene/schema/outline_rows.h"
#include "scene/schema/pane_keys.h"
#include "scene/schema/pavement_keys.h"
#include "scene/schema/scene_keys.h"
#include "scene/toml/apply_override.h"

namespace shatterpave::scene {

namespace {

using Json = nlohmann::ordered_json;

// In the order of ValueType.
constexpr std::array<std::string_view, 14> type_names = {"flag",        "number",   "whole_number", "text",   "choice",
                                                         "point",       "place",    "pixels",       "limits", "points",
                                                         "point_lists", "features", "table",        "tables"};

std::string_view type_name(ValueType type) { return type_names.at(static_cast<std::size_t>(type)); }

std::string key_path(const KeyTable& table, const Key& key) {
  return fmt::format("{}{}{}", table.path, table.path.empty() ? "" : ".", key.name);
}

std::string range_text(const Range& range) {
  if (range.low == -range.high && !range.open_low) return "±" + number_text(range.high);
  if (range.open_low)
    return fmt::format("above {}, {} {}", number_text(range.low), range.open_high ? "below" : "up to", number_text(range.high));
  return fmt::format("{} … {}{}", number_text(range.low), range.open_high ? "below " : "", number_text(range.high));
}

std::string range_text(const WholeRange& range) {
  // A double holds no whole number of 19 digits.
  if (range.high > 1'000'000'000) return fmt::format("{} … {}", range.low, range.high);
  return fmt::format("{} … {}", number_text(static_cast<double>(range.low)), number_text(static_cast<double>(range.high)));
}

// Type and range, in Markdown.
std::string form_text(const Key& key) {
  if (!key.form.empty()) return fmt::format(fmt::runtime(key.form), key.range ? range_text(*key.range) : "");
  switch (key.type) {
    case ValueType::flag:
      return "`true`, `false`";
    case ValueType::number:
      return range_text(key.range.value());
    case ValueType::whole_number:
      return "whole number, " + range_text(key.whole_range.value());
    case ValueType::text:
      return "text";
    case ValueType::choice: {
      std::string text;
      for (const std::string_view name : key.choices) text += fmt::format("{}`\"{}\"`", text.empty() ? "" : ", ", name);
      return text;
    }
    case ValueType::point:
      return fmt::format("`[x, y]`, each {}", range_text(key.range.value()));
    case ValueType::place:
      return fmt::format("`[x, y, z]`, each {}", range_text(key.range.value()));
    case ValueType::pixels:
      return fmt::format("`[width, height]`, whole numbers, each {}", range_text(key.whole_range.value()));
    case ValueType::limits:
      return fmt::format("`[least, greatest]`, each {}", range_text(key.range.value()));
    case ValueType::points:
      return "`[[x, y], …]`";
    case ValueType::point_lists:
      return "`[[[x, y], …], …]`";
    case ValueType::features:
      return "text, whole number from 0, or a list of them";
    case ValueType::table:
      return "table, below";
    case ValueType::tables:
      return fmt::format("up to {} tables, below", number_text(static_cast<double>(key.whole_range.value().high)));
  }
  return {};
}

struct ValueText {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(bool value) const { return value ? "`true`" : "`false`"; }
  std::string operator()(std::int64_t value) const { return number_text(static_cast<double>(value)); }
  std::string operator()(double value) const { return number_text(value); }
  std::string operator()(vec2 value) const { return fmt::format("`[{:.6g}, {:.6g}]`", value.x, value.y); }
  std::string operator()(vec3 value) const { return fmt::format("`[{:.6g}, {:.6g}, {:.6g}]`", value.x, value.y, value.z); }
  std::string operator()(const std::string& value) const { return fmt::format("`\"{}\"`", value); }
};

std::string default_text(const Key& key) {
  const std::string value = std::visit(ValueText{}, key.value);
  if (value.empty()) return key.default_words.empty() ? "–" : key.default_words;
  return key.default_words.empty() ? value : fmt::format("{}; {}", value, key.default_words);
}

struct ValueJson {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(vec2 value) const { return Json::array({value.x, value.y}); }
  Json operator()(vec3 value) const { return Json::array({value.x, value.y, value.z}); }
  template <typename Value>
  Json operator()(const Value& value) const {
    return value;
  }
};

Json json_of(const KeyTable& table, const Key& key) {
  Json entry{{"path", key_path(table, key)}, {"type", type_name(key.type)}};
  if (const std::string_view unit = unit_of(key.name); !unit.empty()) entry["unit"] = unit;
  if (key.range) {
    entry["low"] = key.range->low;
    entry["high"] = key.range->high;
    entry["open_low"] = key.range->open_low;
    entry["open_high"] = key.range->open_high;
  } else if (key.whole_range) {
    entry["low"] = key.whole_range->low;
    entry["high"] = key.whole_range->high;
    entry["open_low"] = false;
    entry["open_high"] = false;
  }
  if (!key.choices.empty()) entry["choices"] = key.choices;
  if (!key.form.empty()) entry["written"] = form_text(key);
  entry["default"] = std::visit(ValueJson{}, key.value);
  if (!key.default_words.empty()) entry["default_words"] = key.default_words;
  entry["sentence"] = key.sentence;
  return entry;
}

// How a table's header is written in a scene file: [[pane]], [pane.growth].
std::string header_of(std::string_view path) {
  std::string name(path);
  const bool is_list = name.ends_with("[]");
  while (name.find("[]") != std::string::npos) name.erase(name.find("[]"), 2);
  return is_list ? fmt::format("[[{}]]", name) : fmt::format("[{}]", name);
}

// How many keys panes and pavements have in common: the first of both.
std::size_t common_count() {
  static const std::size_t count = outline_rows<glass::Pane, PaneFacts>().size();
  return count;
}

bool begins_with_common(const KeyTable& table) { return table.path == pane_keys.path() || table.path == pavement_keys.path(); }

std::string markdown(std::string_view path, std::string_view what, std::span<const Key> keys) {
  std::string text =
      fmt::format("<!-- keys {} -->\n| {} | type, range | default | effect |\n| --- | --- | --- | --- |\n", path, what);
  for (const Key& key : keys) {
    std::string name(key.name);
    if (key.type == ValueType::table || key.type == ValueType::tables) {
      const std::string within = path == "scene" ? "" : fmt::format("{}.", path);
      name = header_of(fmt::format("{}{}{}", within, key.name, key.type == ValueType::tables ? "[]" : ""));
    }
    text += fmt::format("| `{}` | {} | {} | {} |\n", name, form_text(key), default_text(key), key.sentence);
  }
  return text + "<!-- end of keys -->\n";
}

}  // namespace

std::span<const KeyTable> key_tables() {
  static const std::array tables = {
      root_keys.key_table(),     still_keys.key_table(),       camera_keys.key_table(),   light_keys.key_table(),
      frames_keys.key_table(),   frame_key_keys.key_table(),   plan_keys.key_table(),     pane_keys.key_table(),
      impact_keys.key_table(),   crack_sheet_keys.key_table(), shards_keys.key_table(),   growth_keys.key_table(),
      rings_keys.key_table(),    crater_keys.key_table(),      laminate_keys.key_table(), tempering_keys.key_table(),
      pavement_keys.key_table(), direction_keys.key_table(),   size_keys.key_table(),     surface_keys.key_table(),
      cell_keys.key_table(),     variation_keys.key_table(),   hand_keys.key_table(),     colour_keys.key_table(),
      relief_keys.key_table(),   textures_keys.key_table(),    ground_keys.key_table(),   steps_keys.key_table(),
      detail_keys.key_table()};
  return tables;
}

const Key* key_of_path(std::string_view path) {
  const auto steps = steps_of(path);
  if (!steps) return nullptr;
  std::string table;
  const Key* key = nullptr;
  bool is_element_next = false;  // an index, or a name, in a list of tables
  for (const KeyStep& step : *steps) {
    if (std::exchange(is_element_next, false)) continue;
    const auto* const name = std::get_if<std::string>(&step);
    const bool is_value = key != nullptr && key->type != ValueType::table && key->type != ValueType::tables;
    if (is_value || name == nullptr) return is_value && name == nullptr ? key : nullptr;
    const auto tables = key_tables();
    const auto known = std::ranges::find(tables, table, &KeyTable::path);
    if (known == tables.end()) return nullptr;
    const auto found = std::ranges::find(known->keys, *name, &Key::name);
    if (found == known->keys.end()) return nullptr;
    key = &*found;
    is_element_next = key->type == ValueType::tables;
    table += fmt::format("{}{}{}", table.empty() ? "" : ".", *name, is_element_next ? "[]" : "");
  }
  return key;
}

std::string keys_text() {
  std::string text;
  for (const KeyTable& table : key_tables()) {
    for (const Key& key : table.keys) {
      std::string line =
          fmt::format("{}: {}; default {}: {}\n", key_path(table, key), form_text(key), default_text(key), key.sentence);
      std::erase(line, '`');
      text += line;
    }
  }
  return text;
}

std::string keys_json() {
  Json keys = Json::array();
  for (const KeyTable& table : key_tables()) {
    for (const Key& key : table.keys) keys.push_back(json_of(table, key));
  }
  return Json{{"format", "shatterpave-keys"}, {"version", 1}, {"keys", keys}}.dump(1) + "\n";
}

std::string keys_markdown() {
  std::string text;
  for (const KeyTable& table : key_tables()) {
    const std::span<const Key> keys = table.keys;
    if (table.path.empty()) {
      text += markdown("scene", "key", keys);
      continue;
    }
    std::span<const Key> own = keys;
    if (begins_with_common(table)) {
      own = keys.subspan(common_count());
      if (table.path == pane_keys.path()) {
        text += "\n" + markdown("pane[], pavement[]", "key of `[[pane]]` and `[[pavement]]`", keys.first(common_count()));
      }
    }
    text += "\n" + markdown(table.path, fmt::format("key of `{}`", header_of(table.path)), own);
  }
  return text;
}

}  // namespace shatterpave::scene
