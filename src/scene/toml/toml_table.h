// A table of a TOML file as it is read: values by key, checked, with their places for messages.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/vec.h"
#include "core/words.h"

namespace shatterpave::scene {

// The keys that a table may have.
using Keys = std::span<const std::string_view>;

// The numbers that a key takes; a bound belongs to them unless it is open.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool open_low = false;
  bool open_high = false;
};

// The same of whole numbers.
struct WholeRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

// Points with the place of the list that they come from.
struct PlacedPoints {
  std::vector<vec2> points;
  Place place;
};

// Throws InputError: "expected …, got …".
[[noreturn]] void refuse(const Place& place, std::string_view expected, std::string_view got);

// "a number from 0 to 40", "a whole number from 1 to 10".
std::string description(const Range& range);
std::string description(const WholeRange& range);
// What a value is, for "got …".
std::string description(const toml::node& node);

// Where a value stands: line and column of the file, or the option that set it (see scene/override.h).
Place place_of(const toml::node& node, const std::string& file, const std::string& key);

// A value as a number of the range.
double number_of(const toml::node& node, const Range& range, const Place& place);

class TomlTable {
 public:
  // `path` is the table's own key, "" for the root; `keys` are all keys that it may have: any other is refused here. The
  // table and `file` must outlive this.
  TomlTable(const toml::table& table, const std::string& file, std::string path, Keys keys);

  bool has(std::string_view key) const { return table_.contains(key); }
  const std::string& file() const { return file_; }
  const std::string& path() const { return path_; }
  const toml::table& node() const { return table_; }
  // The place of the value of `key`; without one, that of the table.
  Place place(std::string_view key) const;
  // The place of the value at a path of keys, `surface.inset` or `impact[1]`; nothing if there is none.
  std::optional<Place> place_of_given(std::string_view path) const;
  // The place of the table.
  Place place() const { return place_of(table_, file_, path_); }

  // Each returns nothing where the key is missing, and throws InputError where its value is not as it should be.
  std::optional<double> number(std::string_view key, const Range& range) const;
  std::optional<std::int64_t> whole_number(std::string_view key, const WholeRange& range) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<std::string> text(std::string_view key) const;
  // A whole number from 0 or a text, or a list of them; empty where the key is missing.
  std::vector<std::variant<std::size_t, std::string>> indices_or_texts(std::string_view key) const;
  std::optional<vec2> point(std::string_view key, const Range& range) const;
  std::optional<vec3> place_in_space(std::string_view key, const Range& range) const;
  // [width, height].
  std::optional<std::array<int, 2>> pixels(std::string_view key, const WholeRange& range) const;
  std::optional<PlacedPoints> points(std::string_view key, const Range& range) const;
  // A list of lists of points.
  std::vector<PlacedPoints> point_lists(std::string_view key, const Range& range) const;
  // One of `choices`: its index.
  std::optional<std::size_t> choice(std::string_view key, std::span<const std::string_view> choices) const;

  // The table of that key; nothing where it is missing.
  std::optional<TomlTable> table(std::string_view key, Keys keys) const;
  // The tables of an array of tables, each with its path; empty where the key is missing. At most `limit` of them.
  std::vector<TomlTable> tables(std::string_view key, std::size_t limit, Keys keys) const;

 private:
  const toml::node* find(std::string_view key) const { return table_.get(key); }
  std::string path_of(std::string_view key) const;
  void refuse_unknown(Keys keys) const;

  const toml::table& table_;
  const std::string& file_;
  std::string path_;
};

}  // namespace shatterpave::scene
