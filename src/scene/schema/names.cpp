#include "scene/schema/names.h"

#include <fmt/format.h>

#include <utility>

#include "core/embedded.h"
#include "scene/input_file.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

void Names::add(std::string name, const std::string& owner, const Place& place) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = '_';
  }
  // Include files are named after things; those of materials lie beside them.
  for (const std::string& file : {name + ".inc", name + ".pov"}) {
    if (is_embedded(file)) refuse(place, "a name that no file of materials has", in_quotes(file));
  }
  const auto [at, is_new] = owners_.emplace(std::move(name), owner);
  if (!is_new) refuse(place, "a name of its own", fmt::format("that of {}", at->second));
}

}  // namespace shatterpave::scene
