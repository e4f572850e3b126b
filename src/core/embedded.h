// Text files that are part of the binary: the templates, and the report's plotting library if it could be had when the program
// was built (see cmake/embed.cmake and cmake/plots.cmake).
#pragma once

#include <span>
#include <string_view>

namespace shatterpave {

struct EmbeddedFile {
  std::string_view name;
  std::string_view text;
};

std::span<const EmbeddedFile> embedded_files();

// Whether there is a file of that name.
bool is_embedded(std::string_view name);

// The text of the file of that name, which must exist.
std::string_view embedded_text(std::string_view name);

}  // namespace shatterpave
