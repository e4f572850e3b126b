#include "serve/page.h"

#include <algorithm>
#include <array>

#include "core/embedded.h"

namespace shatterpave::serve {

namespace {

struct Entry {
  std::string_view path;
  std::string_view name;  // among the embedded files
  std::string_view content_type;
};

constexpr std::string_view html = "text/html; charset=utf-8";
constexpr std::string_view css = "text/css; charset=utf-8";
constexpr std::string_view script = "text/javascript; charset=utf-8";

constexpr std::array entries = {Entry{"/", "view.html", html},
                                Entry{"/view.css", "view.css", css},
                                Entry{"/view.js", "view.js", script},
                                Entry{"/stage.js", "view_stage.js", script},
                                Entry{"/bodies.js", "view_bodies.js", script},
                                Entry{"/knobs.js", "view_knobs.js", script},
                                Entry{"/numbers.js", "view_numbers.js", script},
                                Entry{"/three.js", "three.module.min.js", script},
                                Entry{"/OrbitControls.js", "OrbitControls.js", script},
                                Entry{"/RoomEnvironment.js", "RoomEnvironment.js", script},
                                Entry{"/three.licence", "three.licence", "text/plain; charset=utf-8"}};

}  // namespace

bool has_page() {
  return std::ranges::all_of(entries, [](const Entry& entry) { return is_embedded(entry.name); });
}

std::optional<PageFile> page_file(std::string_view path) {
  const auto* found = std::ranges::find(entries, path, &Entry::path);
  if (found == entries.end() || !is_embedded(found->name)) return std::nullopt;
  return PageFile{found->content_type, embedded_text(found->name)};
}

}  // namespace shatterpave::serve
