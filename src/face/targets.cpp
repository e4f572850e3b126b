#include "face/targets.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "core/words.h"
#include "export/targets.h"
#include "scene/input_file.h"

namespace shatterpave::face {

const exporting::Target& target_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const exporting::Target* target : exporting::targets()) {
    if (target->name == name) return *target;
    names.push_back(target->name);
  }
  const std::string_view meant = nearest(name, names);
  throw InputError(Place{{}, 0, 0, "target"},
                   fmt::format("expected {}, got {}{}", listed(names, "or"), scene::in_quotes(name),
                               meant.empty() ? std::string() : fmt::format("; did you mean {}?", meant)));
}

}  // namespace shatterpave::face
