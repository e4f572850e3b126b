#include "render/povray.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "support/places.h"

namespace shatterpave::render_tests {

namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// Runs the command in `folder` with all that it says going to `log`. Returns what waitpid says.
int status_of(std::vector<std::string> words, const std::filesystem::path& folder, const std::filesystem::path& log) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("povray cannot be started: is it installed?");
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("povray was lost");
  }
  return status;
}

}  // namespace

std::filesystem::path output_folder() { return support::source_folder() / "tests" / "out"; }

relief::Raster rendered(const std::filesystem::path& folder, const std::string& scene, std::size_t width, std::size_t height) {
  const std::filesystem::path picture = folder / "picture.exr";
  const std::filesystem::path log = folder / "povray.log";
  std::filesystem::remove(picture);
  const int status = status_of({"povray", "+I" + scene, "+Opicture.exr", "+FE", fmt::format("+W{}", width),
                                fmt::format("+H{}", height), "+WT1", "-A", "-J", "-D", "-P", "-V"},
                               folder, log);
  const std::string said = text_of(log);
  const bool warned = said.find("Warning:") != std::string::npos;
  if (status != 0 || warned || !std::filesystem::exists(picture)) {
    const std::size_t shown = 3000;
    throw std::runtime_error(fmt::format("povray {} (wait status {}), see {}:\n{}", warned ? "warned" : "failed", status,
                                         log.string(), said.substr(said.size() - std::min(said.size(), shown))));
  }
  relief::Raster raster = relief::read_raster(picture.string());
  if (raster.channels != 3) throw std::runtime_error("the picture does not have three channels");
  return raster;
}

}  // namespace shatterpave::render_tests
