#include <fmt/format.h>
#include <shatterpave/export.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "core/cancel.h"
#include "core/error.h"
#include "export/raster_targets.h"
#include "export/targets.h"
#include "face/model_access.h"
#include "face/targets.h"
#include "face/work.h"
#include "pipeline/edition.h"
#include "pipeline/write.h"
#include "scene/input_file.h"

namespace shatterpave {

namespace {

namespace fs = std::filesystem;

// A folder of the system's for temporary files, which goes with this.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "shatterpave-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw fs::filesystem_error("cannot make a temporary folder", name, std::error_code(errno, std::generic_category()));
    }
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string content_of(const fs::path& file) {
  std::string content(fs::file_size(file), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(content.data(), static_cast<std::streamsize>(content.size()))) {
    throw fs::filesystem_error("cannot read", file, std::make_error_code(std::errc::io_error));
  }
  return content;
}

Written plain(pipeline::Published published) {
  return {std::move(published.paths), std::move(published.removed), std::move(published.left)};
}

// Own sets stand beside those of the command, and can never be mistaken for them.
constexpr std::string_view own_set = "own: ";
constexpr std::size_t longest_maker = 64;

void require_maker(std::string_view maker) {
  const bool plain = !maker.empty() && maker.size() <= longest_maker &&
                     std::ranges::all_of(maker, [](char c) { return c >= 0x20 && c < 0x7F; });
  if (plain) return;
  throw InputError(Place{{}, 0, 0, "maker"}, fmt::format("expected 1 to {} printable characters of ASCII, got {}",
                                                         longest_maker, scene::in_quotes(maker)));
}

// Files that begin with a point are the library's own notes on the folder.
void require_file_name(const std::string& name) {
  const bool plain = !name.empty() && name.front() != '.' && name.size() < 256 && name.find('/') == std::string::npos &&
                     std::ranges::all_of(name, [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F; });
  if (plain) return;
  throw InputError(Place{{}, 0, 0, "name"},
                   fmt::format("expected the name of a file without a folder, not hidden, got {}", scene::in_quotes(name)));
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = [] {
    std::vector<Target> rows;
    for (const exporting::Target* target : exporting::targets()) rows.push_back({target->name, target->sentence});
    return rows;
  }();
  return all;
}

std::vector<File> export_files(const Model& model, std::string_view target, const WorkOptions& options) {
  const exporting::Target& row = face::target_named(target);
  std::vector<File> files;
  face::work_with(options, [&](const Progress& progress, const Cancelled& /*cancelled*/) {
    exporting::Outputs outputs;
    exporting::append_files(row, ModelAccess::model(model), outputs);
    for (exporting::OutputFile& file : outputs.files) files.push_back({std::move(file.name), std::move(file.content)});
    pipeline::report_sets(outputs, progress);
    for (const exporting::FileSet& set : outputs.sets) {
      const TemporaryFolder folder;
      set.write(folder.path().string());
      for (const std::string& name : set.names) files.push_back({name, content_of(folder.path() / name)});
    }
  });
  return files;
}

Written write_targets(const Model& model, const std::vector<std::string>& targets, const fs::path& folder,
                      const WorkOptions& options) {
  for (const std::string& name : targets) face::target_named(name);
  std::optional<Written> written;
  face::work_with(options, [&](const Progress& progress, const Cancelled& cancelled) {
    const exporting::Model& inner = ModelAccess::model(model);
    exporting::Outputs outputs;
    for (const exporting::Target* target : exporting::targets()) {
      if (std::ranges::find(targets, target->name) != targets.end()) exporting::append_files(*target, inner, outputs);
    }
    pipeline::report_sets(outputs, progress);
    const pipeline::Edition edition = pipeline::edition_of(inner.name, inner.fingerprint, "export");
    written = plain(pipeline::written_outputs(outputs, edition, folder, cancelled));
  });
  return *std::move(written);
}

Written write_files(const Model& model, const std::vector<File>& files, const fs::path& folder, std::string_view maker,
                    const WorkOptions& options) {
  require_maker(maker);
  for (const File& file : files) require_file_name(file.name);
  std::optional<Written> written;
  face::work_with(options, [&](const Progress& /*progress*/, const Cancelled& cancelled) {
    const exporting::Model& inner = ModelAccess::model(model);
    std::vector<exporting::OutputFile> outputs;
    outputs.reserve(files.size());
    for (const File& file : files) outputs.push_back({file.name, file.content});
    const pipeline::Edition edition =
        pipeline::edition_of(inner.name, inner.fingerprint, std::string(own_set) + std::string(maker));
    written = plain(pipeline::written(outputs, edition, folder, cancelled));
  });
  return *std::move(written);
}

}  // namespace shatterpave
