// The text of a drawing as it grows.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace shatterpave::exporting::svg {

using Buffer = fmt::memory_buffer;

template <typename... Arguments>
void put(Buffer& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
}

}  // namespace shatterpave::exporting::svg
