#include "scene/draft_values.h"

#include <nlohmann/json.hpp>

#include "scene/schema/idle_keys.h"
#include "scene/schema/scene_keys.h"
#include "scene/table_scene.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_list = 64;

Json json_of(const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = json_of(value);
    return object;
  }
  if (const toml::array* array = node.as_array()) {
    if (array->size() > longest_list) return nullptr;
    Json list = Json::array();
    for (const toml::node& value : *array) list.push_back(json_of(value));
    return list;
  }
  if (const auto* value = node.as_string()) return value->get();
  if (const auto* value = node.as_boolean()) return value->get();
  if (const auto* value = node.as_integer()) return value->get();
  if (const auto* value = node.as_floating_point()) return value->get();
  return nullptr;
}

}  // namespace

std::string draft_values(const Draft& draft, const Scene& scene) {
  const toml::table& table = draft.table().root;
  const std::string file = draft.file().string();
  const TomlTable root(table, file, "", root_keys.names());
  return Json{{"values", json_of(table)}, {"idle", idle_key_paths(root, scene)}}.dump(-1, ' ', false,
                                                                                      Json::error_handler_t::replace);
}

}  // namespace shatterpave::scene
