// Keys of the scene file, one row each. A row says what the key is called, which values it takes, which member of a struct it
// is read into, when it has no effect, and what it does. A new key is a new row.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/angle.h"
#include "core/error.h"
#include "core/notes.h"
#include "scene/schema/key.h"
#include "scene/schema/words.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace rows {

// A member of a member, as a pointer to it.
template <typename Whole, typename Part, typename Value>
auto in(Part Whole::*part, Value Part::*value) {
  return [part, value](Whole& whole) -> Value& { return (whole.*part).*value; };
}

template <typename Value>
inline constexpr bool is_optional = false;
template <typename Value>
inline constexpr bool is_optional<std::optional<Value>> = true;

// The value of a member as a scene file gives it.
template <typename Value>
DefaultValue default_value(const Value& value) {
  if constexpr (is_optional<Value>) {
    return value ? default_value(*value) : DefaultValue();
  } else if constexpr (std::is_same_v<Value, Angle>) {
    constexpr double digits = 1e9;  // more are rounding, of radians
    return std::round(value.degrees() * digits) / digits;
  } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
    return static_cast<std::int64_t>(value);
  } else {
    return value;
  }
}

}  // namespace rows

// A row of a table that is read into a `Thing`. `Facts` is what decides whether its keys have an effect. `Member`s below are
// pointers to members of a Thing, or functions that return a reference to a part of one; a part may be optional.
template <typename Thing, typename Facts>
class Row {
 public:
  using List = std::vector<Row>;

  template <typename Member>
  static Row number(std::string_view name, Member member, const Range& range, std::string_view sentence) {
    Row row(name, ValueType::number, sentence);
    row.key_.range = range;
    row.takes_default_of(member);
    row.read_ = [name, member, range](const TomlTable& table, Thing& thing) {
      if (const auto value = table.number(name, range)) std::invoke(member, thing) = *value;
    };
    return row;
  }

  // In degrees, of an Angle.
  template <typename Member>
  static Row angle(std::string_view name, Member member, const Range& range, std::string_view sentence) {
    Row row(name, ValueType::number, sentence);
    row.key_.range = range;
    row.takes_default_of(member);
    row.read_ = [name, member, range](const TomlTable& table, Thing& thing) {
      if (const auto value = table.number(name, range)) std::invoke(member, thing) = Angle::degrees(*value);
    };
    return row;
  }

  // `Value` is the type of the member.
  template <typename Value = int, typename Member>
  static Row whole(std::string_view name, Member member, const WholeRange& range, std::string_view sentence) {
    Row row(name, ValueType::whole_number, sentence);
    row.key_.whole_range = range;
    row.takes_default_of(member);
    row.read_ = [name, member, range](const TomlTable& table, Thing& thing) {
      if (const auto value = table.whole_number(name, range)) std::invoke(member, thing) = static_cast<Value>(*value);
    };
    return row;
  }

  template <typename Member>
  static Row flag(std::string_view name, Member member, std::string_view sentence) {
    Row row(name, ValueType::flag, sentence);
    row.takes_default_of(member);
    row.read_ = [name, member](const TomlTable& table, Thing& thing) {
      if (const auto value = table.flag(name)) std::invoke(member, thing) = *value;
    };
    return row;
  }

  template <typename Member>
  static Row point(std::string_view name, Member member, const Range& range, std::string_view sentence) {
    Row row(name, ValueType::point, sentence);
    row.key_.range = range;
    row.takes_default_of(member);
    row.read_ = [name, member, range](const TomlTable& table, Thing& thing) {
      if (const auto value = table.point(name, range)) std::invoke(member, thing) = *value;
    };
    return row;
  }

  // In space.
  template <typename Member>
  static Row place(std::string_view name, Member member, const Range& range, std::string_view sentence) {
    Row row(name, ValueType::place, sentence);
    row.key_.range = range;
    row.takes_default_of(member);
    row.read_ = [name, member, range](const TomlTable& table, Thing& thing) {
      if (const auto value = table.place_in_space(name, range)) std::invoke(member, thing) = *value;
    };
    return row;
  }

  // The size of a picture, of an optional array of two.
  template <typename Member>
  static Row pixels(std::string_view name, Member member, const WholeRange& range, std::string_view sentence) {
    Row row(name, ValueType::pixels, sentence);
    row.key_.whole_range = range;
    row.read_ = [name, member, range](const TomlTable& table, Thing& thing) {
      if (const auto value = table.pixels(name, range)) std::invoke(member, thing) = *value;
    };
    return row;
  }

  // [least, greatest], of two numbers or two angles.
  template <typename Member>
  static Row limits(std::string_view name, Member least, Member greatest, const Range& range, std::string_view sentence) {
    Row row(name, ValueType::limits, sentence);
    row.key_.range = range;
    Thing thing;
    row.key_.value = vec2{std::get<double>(rows::default_value(std::invoke(least, thing))),
                          std::get<double>(rows::default_value(std::invoke(greatest, thing)))};
    row.read_ = [name, least, greatest, range](const TomlTable& table, Thing& read) {
      const auto value = table.point(name, range);
      if (!value) return;
      if (value->x > value->y) refuse(table.place(name), "[least, greatest]", "the greater one first");
      if constexpr (std::is_same_v<std::remove_reference_t<std::invoke_result_t<Member, Thing&>>, Angle>) {
        std::invoke(least, read) = Angle::degrees(value->x);
        std::invoke(greatest, read) = Angle::degrees(value->y);
      } else {
        std::invoke(least, read) = value->x;
        std::invoke(greatest, read) = value->y;
      }
    };
    return row;
  }

  // One of `words` (scene/schema/words.h), whose value the member takes.
  template <typename Member, typename Words>
  static Row choice(std::string_view name, Member member, const Words& words, std::string_view sentence) {
    Row row(name, ValueType::choice, sentence);
    row.key_.choices = names_of(words);
    Thing thing;
    for (const auto& word : words) {
      if (std::invoke(member, thing) == word.value) row.key_.value = std::string(word.name);
    }
    row.read_ = [name, member, words, choices = row.key_.choices](const TomlTable& table, Thing& read) {
      if (const auto chosen = table.choice(name, choices)) std::invoke(member, read) = words[*chosen].value;
    };
    return row;
  }

  // One of `choices`, which sets several members.
  static Row preset(std::string_view name, std::vector<std::string_view> choices, void (*apply)(Thing&, std::size_t chosen),
                    std::string_view sentence) {
    Row row(name, ValueType::choice, sentence);
    row.key_.choices = choices;
    row.read_ = [name, apply, choices = std::move(choices)](const TomlTable& table, Thing& thing) {
      if (const auto chosen = table.choice(name, choices)) apply(thing, *chosen);
    };
    return row;
  }

  // A key that code reads by itself, since more than a member follows from it.
  static Row by_code(std::string_view name, ValueType type, std::string_view sentence) { return Row(name, type, sentence); }
  // A table, whose keys are a section of their own.
  static Row table(std::string_view name, std::string_view sentence) { return Row(name, ValueType::table, sentence); }
  static Row tables(std::string_view name, std::size_t most, std::string_view sentence) {
    Row row(name, ValueType::tables, sentence);
    row.key_.whole_range = WholeRange{0, static_cast<std::int64_t>(most)};
    return row;
  }

  // What is told of keys that code reads: the numbers and the texts that it takes.
  Row within(const Range& range) const {
    return with([&](Row& row) { row.key_.range = range; });
  }
  Row within(const WholeRange& range) const {
    return with([&](Row& row) { row.key_.whole_range = range; });
  }
  Row one_of(const std::vector<std::string_view>& choices) const {
    return with([&](Row& row) { row.key_.choices = choices; });
  }
  // How the value is written.
  Row written(std::string_view form) const {
    return with([&](Row& row) { row.key_.form = form; });
  }
  // The default follows from other keys.
  Row by_default(std::string_view words) const {
    return with([&](Row& row) {
      row.key_.value = {};
      row.key_.default_words = words;
    });
  }
  // The default is the struct's, and what that means.
  Row meaning(std::string_view words) const {
    return with([&](Row& row) { row.key_.default_words = words; });
  }

  // The key has no effect where `holds`: `why` ends the sentence "has no effect …". Of several the first that holds is told.
  Row idle(bool (*holds)(const Facts&), std::string_view why) const {
    return with([&](Row& row) { row.idle_.push_back({holds, why}); });
  }
  // The key is refused without the key `other` beside it, as something without `what`.
  Row beside(std::string_view other, std::string_view what) const {
    return with([&](Row& row) { row.beside_ = std::pair(other, what); });
  }
  // The key is refused beside the key `other`.
  Row not_beside(std::string_view other) const {
    return with([&](Row& row) { row.not_beside_ = other; });
  }
  // What else follows from the key where it is given.
  Row then(void (*follow)(Thing&)) const {
    return with([&](Row& row) { row.follow_ = follow; });
  }

  const Key& key() const { return key_; }

  // Reads the key into `thing` if `table` has it. Throws InputError where its value is not as it should be.
  void read(const TomlTable& table, Thing& thing) const {
    if (!table.has(key_.name)) return;
    if (beside_ && !table.has(beside_->first)) refuse(table.place(key_.name), beside_->second, "none");
    if (!not_beside_.empty() && table.has(not_beside_)) {
      refuse(table.place(key_.name), fmt::format("no {} beside {}", key_.name, not_beside_), "one");
    }
    if (read_) read_(table, thing);
    if (follow_ != nullptr) follow_(thing);
  }

  // Why it has no effect; nothing where it has one.
  std::optional<std::string_view> idleness(const Facts& facts) const {
    for (const Rule& rule : idle_) {
      if (rule.holds(facts)) return rule.why;
    }
    return std::nullopt;
  }

 private:
  struct Rule {
    bool (*holds)(const Facts&);
    std::string_view why;
  };

  Row(std::string_view name, ValueType type, std::string_view sentence) {
    key_.name = name;
    key_.type = type;
    key_.sentence = sentence;
  }

  template <typename Member>
  void takes_default_of(Member member) {
    Thing thing;
    key_.value = rows::default_value(std::invoke(member, thing));
  }

  template <typename Change>
  Row with(Change change) const {
    Row row = *this;
    change(row);
    return row;
  }

  Key key_;
  std::function<void(const TomlTable&, Thing&)> read_;
  std::vector<Rule> idle_;
  std::optional<std::pair<std::string_view, std::string_view>> beside_;
  std::string_view not_beside_;
  void (*follow_)(Thing&) = nullptr;
};

// The keys of one table. `Facts::path` is the path of the thing that the table belongs to, `Facts::table` that thing's own
// table.
template <typename Thing, typename Facts>
class Section {
 public:
  using Rows = typename Row<Thing, Facts>::List;

  // `path` as of KeyTable.
  Section(std::string_view path, Rows rows) : path_(path), rows_(std::move(rows)) {
    for (const auto& row : rows_) names_.push_back(row.key().name);
    name_ = path_.substr(path_.rfind('.') + 1);
    if (name_.ends_with("[]")) name_.remove_suffix(2);
  }

  Keys names() const { return names_; }

  KeyTable key_table() const {
    KeyTable table{path_, {}};
    for (const auto& row : rows_) table.keys.push_back(row.key());
    return table;
  }

  // Reads all keys of `table` that have a member into `thing`, in the order of the rows.
  void read(const TomlTable& table, Thing& thing) const {
    for (const auto& row : rows_) row.read(table, thing);
  }

  // The section's table within that of its parent; nothing where there is none.
  std::optional<TomlTable> table_in(const TomlTable& parent) const { return parent.table(name_, names_); }
  // The same for a list of tables.
  std::vector<TomlTable> tables_in(const TomlTable& parent, std::size_t most) const {
    return parent.tables(name_, most, names_);
  }
  // Reads that table, if there is one, into `thing`, and returns it.
  std::optional<TomlTable> read_in(const TomlTable& parent, Thing& thing) const {
    auto table = table_in(parent);
    if (table) read(*table, thing);
    return table;
  }

  std::string_view path() const { return path_; }
  const Rows& rows() const { return rows_; }

 private:
  std::string_view path_;
  std::string_view name_;
  Rows rows_;
  std::vector<std::string_view> names_;
};

// The paths, from `Facts::path` on, of all keys of a section that have no effect, given or not.
template <typename Thing, typename Facts>
std::vector<std::string> idle_paths(const Section<Thing, Facts>& section, const Facts& facts) {
  std::string_view within = section.path().substr(Facts::path.size());
  if (within.starts_with('.')) within.remove_prefix(1);
  std::vector<std::string> paths;
  for (const auto& row : section.rows()) {
    if (row.idleness(facts)) paths.push_back(fmt::format("{}{}{}", within, within.empty() ? "" : ".", row.key().name));
  }
  return paths;
}

// Tells the keys that a thing gives but that have no effect. Where a whole table has none, its keys are not told.
template <typename Facts>
class IdleKeys {
 public:
  // Both must outlive this.
  IdleKeys(const Facts& facts, std::vector<Note>& notes) : facts_(facts), notes_(notes) {}

  // Of sections of one thing, those of outer tables go first.
  template <typename Thing>
  void tell(const Section<Thing, Facts>& section) {
    std::string_view within = section.path().substr(Facts::path.size());
    if (within.starts_with('.')) within.remove_prefix(1);
    if (is_told(within)) return;
    for (const auto& row : section.rows()) {
      std::string key = fmt::format("{}{}{}", within, within.empty() ? "" : ".", row.key().name);
      const std::optional<Place> place = facts_.table.place_of_given(key);
      if (!place) continue;
      const auto why = row.idleness(facts_);
      if (!why) continue;
      add_note({*place, fmt::format("has no effect {}", *why)}, notes_);
      told_.push_back(std::move(key));
    }
  }

 private:
  // Whether it is a table that was told, or lies in one.
  bool is_told(std::string_view table) const {
    for (const std::string& told : told_) {
      if (table.starts_with(told) && (table.size() == told.size() || table[told.size()] == '.')) return true;
    }
    return false;
  }

  const Facts& facts_;
  std::vector<Note>& notes_;
  std::vector<std::string> told_;
};

}  // namespace shatterpave::scene
