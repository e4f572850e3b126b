// What is told of a key of the scene file. Every key stands in one row (scene/schema/row.h), from which its reading, its
// refusals, the tables of docs/scene-file.md and `shatterpave keys` are made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/vec.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

enum class ValueType {
  flag,          // true or false
  number,        // within a range
  whole_number,  // within a range
  text,
  choice,       // one of several texts
  point,        // [x, y]
  place,        // [x, y, z]
  pixels,       // [width, height], whole numbers
  limits,       // [least, greatest]
  points,       // [[x, y], …]
  point_lists,  // [[[x, y], …], …]
  features,     // an id or an index, or a list of them
  table,
  tables  // a list of tables
};

// The value of a key that is left out; nothing where that follows from other keys.
using DefaultValue = std::variant<std::monostate, bool, std::int64_t, double, vec2, vec3, std::string>;

struct Key {
  std::string_view name;
  ValueType type = ValueType::text;
  std::optional<Range> range;             // of a number; of each number of a point and of limits
  std::optional<WholeRange> whole_range;  // of a whole number; of tables, how many there may be
  std::vector<std::string_view> choices;
  std::string form;           // how the value is written, where type, range and choices do not tell; {} stands for the range
  DefaultValue value;         // as the default-constructed struct has it
  std::string default_words;  // what follows from other keys, or is added to the value
  std::string sentence;       // in Markdown, without a full stop
};

// The keys of a table, by its path from the root with [] after lists of tables: "", "pane[]", "pane[].growth".
struct KeyTable {
  std::string_view path;
  std::vector<Key> keys;
};

// The unit in which a key of that name is given, as its ending says it: "mm" of "joint_mm"; "" where it has none.
std::string_view unit_of(std::string_view name);

// A number for readers: with a typographer's minus, commas from five digits on, and six digits of what is not whole.
std::string number_text(double value);

}  // namespace shatterpave::scene
