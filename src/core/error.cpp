#include "core/error.h"

#include <fmt/format.h>

#include "core/notes.h"

namespace shatterpave {

std::string located(const Place& place, const std::string& message) {
  std::string text = place.file;
  if (place.line > 0) text += fmt::format(":{}:{}", place.line, place.column);
  if (!place.key.empty()) text += fmt::format("{}{}", text.empty() ? "" : ": ", place.key);
  return text.empty() ? message : fmt::format("{}: {}", text, message);
}

InputError::InputError(const Place& place, const std::string& message)
    : std::runtime_error(located(place, message)), place_(place), message_(message) {}

void throw_broken_invariant(const char* condition, const char* file, int line) {
  throw BrokenInvariant(fmt::format("{}:{}: broken invariant: {}", file, line, condition));
}

}  // namespace shatterpave
