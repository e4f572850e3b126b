#include "scene/environment_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/words.h"
#include "scene/input_file.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace {

namespace fs = std::filesystem;

// Folders that hold the data of programs, as the XDG Base Directory Specification has it, and the two that are meant where the
// variable says nothing.
std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  const char* const variable = std::getenv("XDG_DATA_DIRS");
  std::string_view rest = variable != nullptr ? variable : "";
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path folder(rest.substr(0, end));
    if (folder.is_absolute()) folders.push_back(folder);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  for (const char* usual : {"/usr/local/share", "/usr/share"}) folders.emplace_back(usual);
  return folders;
}

void add_folder(const fs::path& folder, std::map<std::string, fs::path>& found) {
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    if (file->path().extension() == ".exr") found.try_emplace(file->path().stem().string(), file->path());
  }
}

// Files by name. Debian's Blender has its data in one folder, others in one for each version: there the name is taken from
// the newest.
std::map<std::string, fs::path> installed_environments() {
  std::map<std::string, fs::path> found;
  const fs::path world = fs::path("studiolights") / "world";
  for (const fs::path& data : data_folders()) {
    const fs::path blender = data / "blender";
    add_folder(blender / "datafiles" / world, found);
    std::vector<fs::path> versions;
    std::error_code error;
    for (fs::directory_iterator folder(blender, error), end; !error && folder != end; folder.increment(error)) {
      versions.push_back(folder->path());
    }
    std::ranges::sort(versions, std::ranges::greater());
    for (const fs::path& version : versions) add_folder(version / "datafiles" / world, found);
  }
  return found;
}

fs::path installed_environment(const std::string& asked, const Place& place) {
  const std::map<std::string, fs::path> installed = installed_environments();
  const auto found = installed.find(asked);
  if (found != installed.end()) return found->second;
  if (installed.empty()) {
    refuse(
        place,
        "the name of a lat-long picture (EXR, HDR or PNG), since there are no environments of Blender's data (Debian package "
        "blender-data)",
        in_quotes(asked));
  }
  std::vector<std::string_view> names;
  names.reserve(installed.size());
  for (const auto& [name, file] : installed) names.emplace_back(name);
  const std::string_view meant = nearest(asked, names);
  refuse(place, "the name of a lat-long picture (EXR, HDR or PNG), or " + listed(names, "or"),
         in_quotes(asked) + (meant.empty() ? std::string() : fmt::format("; did you mean {}?", meant)));
}

std::string_view ending_of(std::string_view content) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, std::string_view> beginnings[] = {
      {"\x76\x2f\x31\x01"sv, "exr"}, {"#?RADIANCE"sv, "hdr"}, {"#?RGBE"sv, "hdr"}, {"\x89PNG\r\n\x1a\n"sv, "png"}};
  for (const auto& [beginning, ending] : beginnings) {
    if (content.starts_with(beginning)) return ending;
  }
  return "";
}

}  // namespace

studio::Environment environment_named(const std::string& asked, const fs::path& scene_file, const Place& place) {
  const bool is_file = asked.find_first_of("./") != std::string::npos;
  const fs::path folder = is_nameless(scene_file) ? fs::path() : scene_file.parent_path();
  const fs::path file = is_file ? folder / asked : installed_environment(asked, place);
  auto content = std::make_shared<const std::string>(input_text(file, largest_environment_bytes, place));
  const std::string_view ending = ending_of(*content);
  if (ending.empty()) refuse(place, "an EXR, HDR or PNG picture", "another file: " + file.string());
  return {std::string(ending), std::move(content)};
}

}  // namespace shatterpave::scene
