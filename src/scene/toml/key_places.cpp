#include "scene/toml/key_places.h"

#include <fmt/format.h>

#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace {

// Tables, and tables in lists; lists of other things, such as a million points, count as one value.
void collect(const toml::node& node, const std::string& file, const std::string& path, const std::string& member,
             std::map<std::string, Place, std::less<>>& places) {
  places.emplace(member, place_of(node, file, path));
  const std::string dot = member.empty() ? "" : ".";
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      collect(value, file, fmt::format("{}.{}", path, key.str()), fmt::format("{}{}{}", member, dot, key.str()), places);
    }
  }
  const toml::array* array = node.as_array();
  if (array == nullptr || !array->is_homogeneous<toml::table>()) return;
  for (std::size_t i = 0; i < array->size(); ++i) {
    collect((*array)[i], file, fmt::format("{}[{}]", path, i), fmt::format("{}[{}]", member, i), places);
  }
}

}  // namespace

KeyPlaces::KeyPlaces(const TomlTable& table) : path_(table.path()) {
  collect(table.node(), table.file(), table.path(), "", places_);
}

Place KeyPlaces::place(std::string_view member) const {
  std::string_view known = member;
  while (!places_.contains(known) && !known.empty()) {
    const std::size_t end = known.find_last_of(".[");
    known = known.substr(0, end == std::string_view::npos ? 0 : end);
  }
  const auto at = places_.find(known);
  Place place = at == places_.end() ? Place{} : at->second;
  place.key = member.empty() ? path_ : fmt::format("{}{}{}", path_, path_.empty() ? "" : ".", member);
  return place;
}

}  // namespace shatterpave::scene
