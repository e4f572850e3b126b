// The page and what it loads: files that are part of the program (cmake/plots.cmake, templates/view).
#pragma once

#include <optional>
#include <string_view>

namespace shatterpave::serve {

struct PageFile {
  std::string_view content_type;
  std::string_view text;
};

// The file of that path of an address, "/" or "/view.js"; nothing where there is none. Only these paths lead to a file.
std::optional<PageFile> page_file(std::string_view path);

// Whether the program holds three.js, without which there is no page.
bool has_page();

}  // namespace shatterpave::serve
