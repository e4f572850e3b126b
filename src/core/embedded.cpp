#include "core/embedded.h"

#include <algorithm>

#include "core/error.h"

namespace shatterpave {

bool is_embedded(std::string_view name) {
  const auto files = embedded_files();
  return std::ranges::find(files, name, &EmbeddedFile::name) != files.end();
}

std::string_view embedded_text(std::string_view name) {
  const auto files = embedded_files();
  const auto found = std::ranges::find(files, name, &EmbeddedFile::name);
  ENSURE(found != files.end());
  return found->text;
}

}  // namespace shatterpave
