#include "serve/draft_render.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "pipeline/subprocess.h"
#include "pipeline/workplace.h"

namespace shatterpave::serve {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_message_bytes = 4000;

// Lines of Open Job Description tell how much is done; the others are messages.
class RenderLines {
 public:
  explicit RenderLines(const std::function<void(double)>& progress) : progress_(progress) {}

  void take(std::string_view text) {
    for (const char c : text) {
      if (c != '\n') {
        if (line_.size() < most_message_bytes) line_ += c;
      } else {
        end_line();
      }
    }
  }
  std::string message() {
    end_line();
    return message_.empty() ? "the renderer failed without a message" : message_;
  }

 private:
  void end_line() {
    constexpr std::string_view told = "openjd_progress: ";
    if (line_.starts_with(told)) {
      try {
        progress_(std::stod(line_.substr(told.size())) / 100.0);
      } catch (const std::logic_error&) {
        // No number: nothing is told.
      }
    } else if (!line_.empty() && !line_.starts_with("openjd_") && message_.size() < most_message_bytes) {
      message_ += (message_.empty() ? "" : "\n") + line_;
    }
    line_.clear();
  }

  const std::function<void(double)>& progress_;
  std::string line_;
  std::string message_;
};

std::string content_of(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return std::move(content).str();
}

std::optional<fs::path> picture_in(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") return entry.path();
  }
  return std::nullopt;
}

}  // namespace

fs::path own_temporary_folder() {
  fs::path folder = fs::temp_directory_path() / fmt::format("shatterpave-serve-{}", ::getuid());
  ::mkdir(folder.c_str(), S_IRWXU);
  struct stat found {};
  const bool is_own = ::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::getuid() &&
                      (found.st_mode & (S_IRWXG | S_IRWXO)) == 0;
  if (!is_own) {
    throw InputError(Place{folder.string(), 0, 0, ""}, "expected a folder of this user alone, got something else");
  }
  return folder;
}

void clear_temporary_folder() {
  const fs::path folder = own_temporary_folder();
  { const pipeline::Workplace workplace(folder); }
  ::rmdir(folder.c_str());  // if nobody else is at work in it
}

std::string draft_picture(const DraftJob& job, const std::function<void(double)>& progress, const Cancelled& cancelled) {
  const fs::path temporary = own_temporary_folder();
  std::string picture;
  {
    const pipeline::Workplace workplace(temporary, cancelled);
    const fs::path folder = workplace.folder() / "draft";
    pipeline::Subprocess render;
    render.arguments = {job.program.string(),
                        "render",
                        fs::absolute(job.scene).string(),
                        "-o",
                        folder.string(),
                        "--quality",
                        "draft",
                        "--size",
                        fmt::format("{}x{}", job.width, job.height),
                        "--progress",
                        "openjd"};
    for (const scene::Override& change : job.changes) {
      render.arguments.insert(render.arguments.end(), {"--set", fmt::format("{}={}", change.key, change.value)});
    }
    render.folder = fs::current_path();
    RenderLines lines(progress);
    const pipeline::Ending ending = pipeline::run(
        render, [&](std::string_view text) { lines.take(text); }, cancelled);
    if (!ending.found || ending.status != 0 || ending.signal != 0) throw std::runtime_error(lines.message());
    const auto file = picture_in(folder);
    if (!file) throw std::runtime_error("the renderer has left no picture");
    picture = content_of(*file);
  }
  ::rmdir(temporary.c_str());
  return picture;
}

}  // namespace shatterpave::serve
