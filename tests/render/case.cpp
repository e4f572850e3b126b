#include "render/case.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "support/places.h"

namespace shatterpave::render_tests {

namespace {

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error("expect.toml: " + what); }

template <typename T>
T required(const toml::table& table, std::string_view key) {
  const std::optional<T> value = table[key].value<T>();
  if (!value) fail(fmt::format("{} is missing or of another type", key));
  return *value;
}

std::string reason(const toml::table& table) {
  auto text = required<std::string>(table, "because");
  if (text.size() < 20) fail("a tolerance needs its reason in `because`");
  return text;
}

template <typename T>
std::vector<T> list(const toml::table& table, std::string_view key) {
  std::vector<T> values;
  const toml::array* array = table[key].as_array();
  if (array == nullptr) return values;
  for (const toml::node& node : *array) {
    const auto value = node.value<T>();
    if (!value) fail(fmt::format("{}: an element is of another type", key));
    values.push_back(*value);
  }
  return values;
}

std::array<std::size_t, 2> pair(const toml::table& table, std::string_view key) {
  const auto values = list<std::int64_t>(table, key);
  if (values.size() != 2 || values[0] < 1 || values[1] < 1) fail(fmt::format("{} needs two positive numbers", key));
  return {static_cast<std::size_t>(values[0]), static_cast<std::size_t>(values[1])};
}

const toml::table& subtable(const toml::table& table, std::string_view key) {
  const toml::table* found = table[key].as_table();
  if (found == nullptr) fail(fmt::format("[{}] is missing", key));
  return *found;
}

Tolerance tolerance(const toml::table& table, std::string_view measure) {
  const toml::table& values = subtable(subtable(table, "tolerance"), measure);
  static_cast<void>(reason(values));
  const Tolerance result{values["absolute"].value_or(0.0), values["relative"].value_or(0.0)};
  if (!(result.absolute >= 0.0 && result.relative >= 0.0)) fail("a tolerance is negative");
  return result;
}

Seeds seeds(const toml::table& table) {
  Seeds result;
  for (const std::int64_t seed : list<std::int64_t>(table, "golden")) result.golden.push_back(static_cast<std::uint64_t>(seed));
  for (const std::int64_t seed : list<std::int64_t>(table, "tested")) result.tested.push_back(static_cast<std::uint64_t>(seed));
  if (result.golden.size() < 3 || result.golden.size() != result.tested.size())
    fail("seeds: two lists of one length, 3 or more");
  result.mean_sigmas = required<double>(table, "mean_sigmas");
  result.spread_ratio = required<double>(table, "spread_ratio");
  static_cast<void>(reason(table));
  return result;
}

NearMiss near_miss(const toml::table& table) {
  NearMiss miss;
  miss.name = required<std::string>(table, "name");
  miss.set = list<std::string>(table, "set");
  if (const auto stone = table["without_stone"].value<int>()) miss.without_stone = *stone;
  if (const toml::array* replacements = table["replace"].as_array()) {
    for (const toml::node& node : *replacements) {
      if (!node.is_table()) fail("replace: expected { find = …, by = … }");
      miss.replace.push_back({required<std::string>(*node.as_table(), "find"), required<std::string>(*node.as_table(), "by")});
    }
  }
  if (miss.set.empty() && miss.replace.empty() && !miss.without_stone) fail(miss.name + " changes nothing");
  return miss;
}

std::filesystem::path cases_folder() { return support::source_folder() / "tests" / "render"; }

}  // namespace

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(cases_folder())) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

Case case_named(const std::string& name) {
  Case result;
  result.name = name;
  result.folder = cases_folder() / name;
  const toml::table table = toml::parse_file((result.folder / "expect.toml").string());
  static_cast<void>(required<std::string>(table, "about"));
  const auto scene = table["scene"].value<std::string>();
  result.scene = scene ? support::source_folder() / *scene : result.folder / "scene.toml";
  const auto size = pair(table, "size");
  result.width = size[0];
  result.height = size[1];
  const std::int64_t oversampling = table["oversampling"].value_or(std::int64_t{1});
  if (oversampling < 1 || oversampling > 8) fail("oversampling is 1 to 8");
  result.set = list<std::string>(table, "set");
  result.draft = table["draft"].value_or(false);
  result.oversampling = static_cast<std::size_t>(oversampling);
  const auto grid = pair(table, "grid");
  result.grid = {grid[0], grid[1]};
  if (const toml::table* over_seeds = table["seeds"].as_table()) {
    result.seeds = seeds(*over_seeds);
  } else {
    const Tolerance percentile = tolerance(table, "percentile");
    result.tolerances = {
        tolerance(table, "mean"),    tolerance(table, "deviation"), percentile, percentile, percentile, percentile, percentile,
        tolerance(table, "gradient")};
  }
  if (const toml::array* misses = table["near_miss"].as_array()) {
    for (const toml::node& node : *misses) result.near_misses.push_back(near_miss(*node.as_table()));
  }
  if (result.near_misses.empty()) fail("a case needs a [[near_miss]]");
  return result;
}

}  // namespace shatterpave::render_tests
