#include "cli/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "cli/terminal.h"
#include "pipeline/edition.h"

namespace shatterpave::cli {

pipeline::Edition edition_of(const scene::Scene& scene, const std::string& kind) {
  return pipeline::edition_of(scene.name, scene.fingerprint, kind);
}

void report(const pipeline::Published& published, const pipeline::Edition& edition, const std::filesystem::path& output) {
  const auto tell_of = [&](const std::vector<std::string>& names, std::string_view what) {
    if (names.empty()) return;
    tell(fmt::format("shatterpave: {}: {} files of another state of the scene '{}': {}\n", output.string(), what, edition.scene,
                     fmt::join(names, ", ")));
  };
  tell_of(published.removed, "removed");
  tell_of(published.left, "left, since they were changed by hand,");
  print_paths(published.paths);
}

}  // namespace shatterpave::cli
