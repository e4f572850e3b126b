#include "scene/schema/known_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/words.h"
#include "scene/schema/key_tables.h"

namespace shatterpave::scene {

namespace {

// What a value of the type is called where a key goes on after it.
std::string_view name_of_value(ValueType type) {
  switch (type) {
    case ValueType::flag:
      return "true or false";
    case ValueType::number:
      return "a number";
    case ValueType::whole_number:
      return "a whole number";
    case ValueType::choice:
      return "one of several words";
    case ValueType::text:
    case ValueType::features:
      return "a text";
    case ValueType::point:
    case ValueType::place:
    case ValueType::pixels:
    case ValueType::limits:
    case ValueType::points:
    case ValueType::point_lists:
      return "a list";
    case ValueType::table:
    case ValueType::tables:
      break;
  }
  return "a table";
}

bool is_table(const Key& key) { return key.type == ValueType::table || key.type == ValueType::tables; }

// The way of a key through a scene, step by step, beside the way through the tables of keys.
class Way {
 public:
  Way(const Override& change, const toml::table& scene) : change_(change), steps_(key_steps(change)), node_(&scene) {}

  const Key* end() {
    for (; done_ < steps_.size(); ++done_) {
      if (key_ != nullptr && !is_table(*key_)) {
        go_on_after_value();
        return nullptr;
      }
      if (is_list_) {
        take_element();
      } else {
        take_key();
      }
    }
    return key_;
  }

 private:
  std::string path(std::size_t count) const { return path_of(steps_, count); }

  void take_key() {
    const auto* const name = std::get_if<std::string>(&steps_[done_]);
    if (name == nullptr) refuse_way(change_, path(done_), "a table");
    const KeyTable& known = known_keys();
    const auto found = std::ranges::find(known.keys, *name, &Key::name);
    if (found == known.keys.end()) refuse_unknown(known, *name);
    key_ = &*found;
    is_list_ = key_->type == ValueType::tables;
    table_ += fmt::format("{}{}{}", table_.empty() ? "" : ".", *name, is_list_ ? "[]" : "");
    const toml::table* const given = node_ == nullptr ? nullptr : node_->as_table();
    node_ = given == nullptr ? nullptr : given->get(*name);
  }

  // An element of a list of tables, which the scene must have. What is no list there is refused when the scene is read.
  void take_element() {
    const toml::array none;
    const toml::array* const given = node_ == nullptr ? &none : node_->as_array();
    key_ = nullptr;
    is_list_ = false;
    node_ = nullptr;
    if (given == nullptr) return;
    const auto* const name = std::get_if<std::string>(&steps_[done_]);
    const bool is_key = name != nullptr && std::ranges::find(known_keys().keys, *name, &Key::name) != known_keys().keys.end();
    const std::string meant = is_key ? fmt::format("{}[0].{}", path(done_), *name) : std::string();
    const std::size_t index = element_index(*given, steps_[done_], change_, path(done_), meant);
    node_ = &(*given)[index];
    steps_[done_] = index;  // as places tell elements
  }

  // What lies below a value that the scene gives is told where it is set.
  void go_on_after_value() const {
    if (node_ != nullptr) return;
    const std::string_view what = name_of_value(key_->type);
    if (what != "a list" || std::holds_alternative<std::string>(steps_[done_])) refuse_way(change_, path(done_), what);
    element_index({}, steps_[done_], change_, path(done_));  // says that there are none
  }

  const KeyTable& known_keys() const { return *std::ranges::find(key_tables(), table_, &KeyTable::path); }

  [[noreturn]] void refuse_unknown(const KeyTable& known, std::string_view name) const {
    std::vector<std::string_view> names;
    names.reserve(known.keys.size());
    for (const Key& key : known.keys) names.push_back(key.name);
    throw InputError(Place{change_.origin, 0, 0, path(done_ + 1)}, fmt::format("unknown key; {}", hint(name, names)));
  }

  const Override& change_;
  std::vector<KeyStep> steps_;
  std::size_t done_ = 0;
  const toml::node* node_;    // where the steps that are done lead; null where the scene has nothing there
  std::string table_;         // the path of the table of keys, "pane[].growth"
  const Key* key_ = nullptr;  // the last step's; null at the root and at elements
  bool is_list_ = false;      // whether it is a list of tables
};

}  // namespace

const Key* require_known(const Override& change, const toml::table& scene) { return Way(change, scene).end(); }

}  // namespace shatterpave::scene
