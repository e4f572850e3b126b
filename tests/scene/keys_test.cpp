// The list of keys (`shatterpave keys`) is what the reader takes: asked of the reader, key by key.
#include "scene/schema/key_tables.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "scene/read_scene.h"

namespace shatterpave::scene {
namespace {

const std::string base =
    "[[pane]]\nname = \"w\"\nsize_mm = [300, 300]\n[[pane.impact]]\nat_mm = [150, 150]\n"
    "[[pavement]]\nname = \"p\"\nsize_mm = [3000, 3000]\n"
    "[[pavement.colour]]\nsrgb = [0.5, 0.5, 0.5]\n"
    "[frames]\nrange = \"1-1\"\n[[frames.key]]\nset = \"light.exposure_ev\"\nat = [[1, 1]]\n";

// What must stand beside a key so that it is taken.
const std::map<std::string, std::vector<std::string>> companions = {
    {"frames.per_second", {"frames.range=1-1"}},
    {"camera.f_number", {"camera.focus_mm=1000"}},
    {"camera.focus_mm", {"camera.f_number=4"}},
    {"light.sun_azimuth_deg", {"light.sun_elevation_deg=10"}},
    {"light.sun_elevation_deg", {"light.sun_azimuth_deg=10"}},
    {"pane[].impact[].hole_mm", {"pane[0].crack_body=sheet"}},
    {"pane[].shards.floor_drop_mm", {"pane[0].shards.sill_drop_mm=0"}},
    {"pane[].shards.sill_drop_mm", {"pane[0].shards.floor_drop_mm=10000"}},
    {"pavement[].textures.tile_mm", {"pavement[0].textures.seamless=true"}},
    {"pavement[].steps.tread_mm", {"pavement[0].size_mm=[9, 9]"}},
    {"pavement[].surface.arris", {"pavement[0].surface.finish=split"}},
    {"pavement[].surface.arris_mm", {"pavement[0].surface.finish=split"}},
    {"pavement[].surface.crown_mm", {"pavement[0].surface.finish=split"}},
    {"pavement[].surface.uneven_mm", {"pavement[0].surface.finish=split"}},
    {"pavement[].surface.wear_mm", {"pavement[0].surface.finish=split"}},
    {"pavement[].surface.chips_per_m", {"pavement[0].surface.finish=split"}},
};

std::string with_indices(std::string path) {
  for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]")) path.replace(at, 2, "[0]");
  return path;
}

// What the reader says to a scene with `path` = `value`; "" where it takes it.
std::string answer(const std::string& path, const std::string& value) {
  std::vector<Override> overrides;
  const auto add = [&](const std::string& key, const std::string& text) { overrides.push_back({"--set", key, text}); };
  if (const auto found = companions.find(path); found != companions.end()) {
    for (const std::string& set : found->second) {
      add(set.substr(0, set.find('=')), set.substr(set.find('=') + 1));
    }
  }
  if (path.starts_with("pane[].crack_sheet")) add("pane[0].crack_body", "sheet");
  add(with_indices(path), value);
  try {
    scene_of_text(base, "s.toml", overrides);
    return "";
  } catch (const InputError& error) {
    return error.message();
  }
}

struct Named {
  std::string path;
  const Key* key;
};

std::vector<Named> all_keys() {
  std::vector<Named> keys;
  for (const KeyTable& table : key_tables()) {
    for (const Key& key : table.keys) {
      keys.push_back({std::string(table.path) + (table.path.empty() ? "" : ".") + std::string(key.name), &key});
    }
  }
  return keys;
}

TEST(Keys, ThatAreListedAreTaken) {
  std::set<std::string> paths;
  for (const Named& named : all_keys()) {
    EXPECT_TRUE(paths.insert(named.path).second) << named.path << " is listed twice";
    // A date is no value of any key; a key that is known is refused for that.
    EXPECT_EQ(answer(named.path, "2024-01-01").find("unknown key"), std::string::npos) << named.path;
  }
  EXPECT_GT(paths.size(), 150U);
}

// Each name in each table: those of other tables are unknown, and so are a name with a letter more or less, and names at
// random.
TEST(Keys, ThatAreNotListedAreUnknown) {
  std::set<std::string> names = {"x", "_", "time_us", "Name", "size", "mm", "preset_", "json"};
  for (const Named& named : all_keys()) {
    const std::string name(named.key->name);
    names.insert(name);
    names.insert(name + "s");
    if (name.size() > 1) names.insert(name.substr(1));
  }
  std::size_t asked = 0;
  for (const KeyTable& table : key_tables()) {
    for (const std::string& name : names) {
      const bool listed = std::ranges::any_of(table.keys, [&](const Key& key) { return key.name == name; });
      const std::string path = std::string(table.path) + (table.path.empty() ? "" : ".") + name;
      const bool unknown = answer(path, "2024-01-01").starts_with("unknown key; ");
      EXPECT_EQ(unknown, !listed) << path;
      ++asked;
    }
  }
  EXPECT_GT(asked, 5000U);
}

// As TOML writes a number that is not whole.
std::string text_of(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

// `number` as a value of the key: alone, or as both of two.
std::string value_of(const Key& key, double number) {
  return key.type == ValueType::number ? text_of(number) : fmt::format("[{0}, {0}]", text_of(number));
}

TEST(Keys, TakeNumbersOfTheirRangeAndNoOther) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::size_t asked = 0;
  for (const auto& [path, key] : all_keys()) {
    const bool is_read = key->type == ValueType::number || key->type == ValueType::point || key->type == ValueType::limits;
    if (!is_read) continue;
    ASSERT_TRUE(key->range.has_value()) << path;
    const Range& range = *key->range;
    const double least = range.open_low ? std::nextafter(range.low, infinity) : range.low;
    const double greatest = range.open_high ? std::nextafter(range.high, -infinity) : range.high;
    const std::string expected = "expected " + description(range) + ", got ";
    // What lies within may be refused for what stands beside it, but not as out of range.
    for (const double inside : {least, greatest}) {
      const std::string said = answer(path, value_of(*key, inside));
      EXPECT_FALSE(said.starts_with(expected)) << path << " = " << inside << ": " << said;
    }
    // Widths of what a plan has are read beside a plan alone.
    if (key->name == "outline_width_mm" || key->name == "holes_width_mm") continue;
    for (const double outside : {std::nextafter(least, -infinity), std::nextafter(greatest, infinity)}) {
      if (!std::isfinite(outside)) continue;
      const std::string said = answer(path, value_of(*key, outside));
      EXPECT_TRUE(said.starts_with(expected)) << path << " = " << outside << ": " << said;
    }
    EXPECT_TRUE(answer(path, "nan").starts_with("expected ")) << path;
    ++asked;
  }
  EXPECT_GT(asked, 90U);
}

// Numbers well within are taken whole, but for keys that depend on the shape of what is there.
TEST(Keys, TakeTheMiddleOfTheirRange) {
  const std::set<std::string> shapes = {"pane[].size_mm", "pane[].impact[].at_mm", "pane[].shards.floor_drop_mm",
                                        "pavement[].outline_width_mm", "pavement[].holes_width_mm"};
  for (const auto& [path, key] : all_keys()) {
    const bool is_read = key->type == ValueType::number || key->type == ValueType::point || key->type == ValueType::limits;
    if (!is_read || shapes.contains(path)) continue;
    // Not 0, where two bounds lie about it.
    const double middle = 0.5 * key->range->low + 0.501 * key->range->high;
    EXPECT_EQ(answer(path, value_of(*key, middle)), "") << path << " = " << middle;
  }
}

TEST(Keys, TakeWholeNumbersOfTheirRangeAndNoOther) {
  std::size_t asked = 0;
  for (const auto& [path, key] : all_keys()) {
    if (key->type != ValueType::whole_number) continue;
    const WholeRange range = key->whole_range.value();
    const std::string expected = "expected " + description(range) + ", got ";
    EXPECT_EQ(answer(path, fmt::format("{}", range.low)), "") << path;
    EXPECT_EQ(answer(path, fmt::format("{}", range.high)), "") << path;
    EXPECT_TRUE(answer(path, fmt::format("{}", range.low - 1)).starts_with(expected)) << path;
    if (range.high < std::numeric_limits<std::int64_t>::max()) {
      EXPECT_TRUE(answer(path, fmt::format("{}", range.high + 1)).starts_with(expected)) << path;
    }
    EXPECT_TRUE(answer(path, "1.5").starts_with(expected)) << path;
    ++asked;
  }
  EXPECT_GE(asked, 6U);
}

TEST(Keys, TakeTheirChoicesAndNoOther) {
  std::size_t asked = 0;
  for (const auto& [path, key] : all_keys()) {
    if (key->type != ValueType::choice) continue;
    EXPECT_GE(key->choices.size(), 2U) << path;
    // Read where a plan is, alone.
    if (key->name == "outline_units") continue;
    for (const std::string_view choice : key->choices) {
      const std::string said = answer(path, fmt::format("\"{}\"", choice));
      // Guides, lines and files must be given beside the kind that takes them.
      if (choice == "guides" || choice == "line") {
        EXPECT_EQ(said, "expected one or more polylines, got none");
      } else if (choice == "grid") {
        EXPECT_EQ(said, "expected grid_file = \"…\", a file of vectors, got none");
      } else if (choice == "map") {
        EXPECT_EQ(said, "expected map_file = \"…\", a grey picture, got none");
      } else if (choice == "module") {
        EXPECT_EQ(said, "expected module_file = \"…\", a drawing of the stones, got none");
      } else {
        EXPECT_EQ(said, "") << path << " = " << choice;
      }
      EXPECT_NE(answer(path, fmt::format("\"{}_\"", choice)), "") << path;
    }
    EXPECT_TRUE(answer(path, "\"other\"").starts_with("expected ")) << path;
    EXPECT_TRUE(answer(path, "3").starts_with("expected ")) << path;
    ++asked;
  }
  EXPECT_GE(asked, 15U);
}

TEST(Keys, TakeFlags) {
  for (const auto& [path, key] : all_keys()) {
    if (key->type != ValueType::flag) continue;
    EXPECT_EQ(answer(path, "true"), "") << path;
    EXPECT_EQ(answer(path, "false"), "") << path;
    EXPECT_EQ(answer(path, "1"), "expected true or false, got 1") << path;
  }
}

// A key that is given its default changes nothing.
TEST(Keys, DefaultsAreThoseOfTheReader) {
  const Scene plain = scene_of_text(base, "s.toml");
  for (const auto& [path, key] : all_keys()) {
    std::string value;
    if (const auto* number = std::get_if<double>(&key->value)) value = fmt::format("{}", *number);
    if (const auto* whole = std::get_if<std::int64_t>(&key->value)) value = fmt::format("{}", *whole);
    if (const auto* flag = std::get_if<bool>(&key->value)) value = *flag ? "true" : "false";
    if (const auto* point = std::get_if<vec2>(&key->value)) value = fmt::format("[{}, {}]", point->x, point->y);
    if (const auto* word = std::get_if<std::string>(&key->value)) value = *word;
    // A table alone makes shards, steps and detail; their own defaults are compared with those of the empty table.
    if (value.empty() || path.starts_with("pane[].crack_sheet") || companions.contains(path)) continue;
    const std::string table = with_indices(path.substr(0, path.rfind('.') == std::string::npos ? 0 : path.rfind('.')));
    Scene expected = plain;
    if (!table.empty() && !table.ends_with(']')) expected = scene_of_text(base, "s.toml", {{"--set", table, "{}"}});
    const Scene given = scene_of_text(base, "s.toml", {{"--set", with_indices(path), value}});
    EXPECT_EQ(given, expected) << path << " = " << value;
  }
}

TEST(Keys, AreToldInJson) {
  const nlohmann::json keys = nlohmann::json::parse(keys_json());
  EXPECT_EQ(keys.at("format"), "shatterpave-keys");
  const auto find = [&](const std::string& path) {
    for (const nlohmann::json& key : keys.at("keys")) {
      if (key.at("path") == path) return key;
    }
    return nlohmann::json();
  };
  EXPECT_EQ(keys.at("keys").size(), all_keys().size());
  const nlohmann::json turn = find("pane[].growth.turn_limit_deg");
  EXPECT_EQ(turn.at("type"), "number");
  EXPECT_EQ(turn.at("unit"), "°");
  EXPECT_EQ(turn.at("low"), 0.0);
  EXPECT_EQ(turn.at("high"), 90.0);
  EXPECT_EQ(turn.at("default"), 30.0);
  EXPECT_EQ(turn.at("sentence"), "largest turn in a step");
  const nlohmann::json limit = find("pane[].growth.spread_limit");
  EXPECT_EQ(limit.at("open_low"), false);
  EXPECT_EQ(limit.at("open_high"), true);
  EXPECT_FALSE(limit.contains("unit"));
  const nlohmann::json arris = find("pavement[].surface.arris");
  EXPECT_EQ(arris.at("choices"), nlohmann::json({"rounded", "chamfered"}));
  EXPECT_EQ(arris.at("default"), nullptr);
  EXPECT_EQ(arris.at("default_words"), "by finish");
  EXPECT_EQ(find("pavement[].stone_mm").at("written"), "`[along, across]` the rows, each 1 … 100,000");
  for (const nlohmann::json& key : keys.at("keys")) {
    EXPECT_FALSE(key.at("sentence").get<std::string>().empty()) << key;
    EXPECT_FALSE(key.at("sentence").get<std::string>().ends_with('.')) << key;
  }
}

TEST(Keys, HaveUnitsByTheirEndings) {
  EXPECT_EQ(unit_of("joint_mm"), "mm");
  EXPECT_EQ(unit_of("splinter_mm2"), "mm²");
  EXPECT_EQ(unit_of("edge_gain_px2"), "px²");
  EXPECT_EQ(unit_of("throw_m_s"), "m/s");
  EXPECT_EQ(unit_of("chips_per_m"), "1/m");
  EXPECT_EQ(unit_of("fall_percent"), "%");
  EXPECT_EQ(unit_of("seed"), "");
  EXPECT_EQ(unit_of("depth"), "");
}

TEST(Keys, NumbersAreToldAsReadersWriteThem) {
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(-360.0), "−360");
  EXPECT_EQ(number_text(1000.0), "1000");
  EXPECT_EQ(number_text(10000.0), "10,000");
  EXPECT_EQ(number_text(-1000000.0), "−1,000,000");
  EXPECT_EQ(number_text(1.0 / 3.0), "0.333333");
  EXPECT_EQ(number_text(0.001), "0.001");
}

}  // namespace
}  // namespace shatterpave::scene
