#include "scene/thing_sums.h"

#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>

#include "core/sha256.h"

namespace shatterpave::scene {

namespace {

// Tables whose values show in pictures, but not in panes and pavements.
constexpr std::string_view apart[] = {"camera", "light", "still", "frames"};

template <typename Node>
std::string text_of(const Node& node) {
  std::ostringstream said;
  said.imbue(std::locale::classic());
  said << toml::json_formatter(node);
  return said.str();
}

// Whether it names a file: then what it is made from may depend on all that was taken from files before it.
bool names_file(const toml::node& node) {
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) {
      if (element.is_table() && names_file(element)) return true;
    }
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) return false;
  for (const auto& [key, value] : *table) {
    if (key.str().ends_with("_file") || names_file(value)) return true;
  }
  return false;
}

// Of the tables of one list, each as it is but for where the thing stands.
std::vector<std::string> sums_of(const toml::table& root, std::string_view list, const Scene& scene) {
  std::vector<std::string> sums;
  const toml::array* const array = root.get_as<toml::array>(list);
  if (array == nullptr) return sums;
  std::string all;
  for (const toml::node& node : *array) {
    toml::table own = *node.as_table();
    own.erase("place_mm");
    own.erase("place_turn_deg");
    Sha256 hash;
    hash.add_text(std::to_string(scene.seed));
    hash.add_text(text_of(own));
    if (names_file(node)) {
      if (all.empty()) {
        toml::table rest = root;
        for (const std::string_view name : apart) rest.erase(name);
        all = text_of(rest);
      }
      hash.add_text(all);
      hash.add_text(scene.plan_sums);
    }
    sums.push_back(hash.sum());
  }
  return sums;
}

}  // namespace

void sum_things(const toml::table& table, Scene& scene) {
  scene.pane_sums = sums_of(table, "pane", scene);
  // A table with several areas has made a pavement of each, all with its name.
  const std::vector<std::string> sums = sums_of(table, "pavement", scene);
  std::size_t of_table = 0;
  std::size_t area = 0;
  for (std::size_t i = 0; i < scene.pavements.size(); ++i) {
    const bool is_next = i > 0 && scene.pavements[i].name != scene.pavements[i - 1].name;
    of_table += is_next ? 1 : 0;
    area = is_next ? 0 : area + 1;
    Sha256 hash;
    hash.add_text(sums.at(of_table));
    hash.add_text(std::to_string(area));
    scene.pavement_sums.push_back(hash.sum());
  }
}

}  // namespace shatterpave::scene
