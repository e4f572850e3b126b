// Text files that are part of the binary: the templates (see cmake/embed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace shatterpave {

struct EmbeddedFile {
  std::string_view name;
  std::string_view text;
};

std::span<const EmbeddedFile> embedded_files();

// The text of the file of that name, which must exist.
std::string_view embedded_text(std::string_view name);

}  // namespace shatterpave
