#include "serve/scene_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "scene/input_file.h"
#include "scene/schema/key_tables.h"
#include "scene/toml/edited_text.h"

namespace shatterpave::serve {

namespace fs = std::filesystem;

namespace {

constexpr std::array settable = {scene::ValueType::flag,   scene::ValueType::number, scene::ValueType::whole_number,
                                 scene::ValueType::choice, scene::ValueType::point,  scene::ValueType::place,
                                 scene::ValueType::pixels, scene::ValueType::limits};

void require_settable(const std::string& path) {
  const scene::Key* key = scene::key_of_path(path);
  if (key == nullptr) throw InputError(Place{"the page", 0, 0, path}, "expected a key of scene files, got none");
  if (std::ranges::find(settable, key->type) != settable.end()) return;
  throw InputError(Place{"the page", 0, 0, path}, "expected a number, a choice or a switch, got what only the file can say");
}

// Of the file in the making; hidden, and beside the scene, so that it can take its name.
fs::path draft_of(const fs::path& file) {
  return file.parent_path() / fmt::format(".{}.shatterpave-save", file.filename().string());
}

[[noreturn]] void refuse_writing(const fs::path& path, int error) {
  throw InputError(Place{path.string(), 0, 0, ""},
                   fmt::format("expected a file that can be written, got: {}", std::generic_category().message(error)));
}

// A file in the making; taken away again unless it has got its name.
class NewFile {
 public:
  explicit NewFile(const fs::path& path) : path_(path) {
    ::unlink(path_.c_str());  // that of a run that was killed
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (descriptor_ < 0) refuse_writing(path_, errno);
  }
  ~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view text, mode_t mode) {
    while (!text.empty()) {
      const ssize_t count = ::write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) refuse_writing(path_, errno);
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    if (::fchmod(descriptor_, mode) != 0 || ::fsync(descriptor_) != 0) refuse_writing(path_, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) refuse_writing(path_, errno);
  }
  void take_name(const fs::path& file) {
    if (::rename(path_.c_str(), file.c_str()) != 0) refuse_writing(file, errno);
    path_.clear();
  }

 private:
  fs::path path_;
  int descriptor_ = -1;
};

}  // namespace

SceneFile::SceneFile(const fs::path& path) : path_(path) {
  if (scene::is_nameless(path)) {
    throw InputError(Place{path.string(), 0, 0, ""}, "expected a file, which can be watched, got what can be read only once");
  }
  if (std::error_code error; fs::exists(path, error)) {
    const fs::path draft = draft_of(fs::canonical(path));
    ::unlink(draft.c_str());
  }
  seen_ = stamp_ = stamp_of(path_);
  text_ = read();
  drop_overruled();
}

SceneFile::Stamp SceneFile::stamp_of(const fs::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return {};
  constexpr std::int64_t billion = 1'000'000'000;
  return {found.st_dev, found.st_ino, found.st_size, found.st_mtim.tv_sec * billion + found.st_mtim.tv_nsec};
}

std::string SceneFile::read() const {
  return scene::input_text(path_, scene::largest_scene_bytes, Place{path_.string(), 0, 0, ""});
}

void SceneFile::set(const std::string& key, const std::string& value) {
  require_settable(key);
  const auto found = std::ranges::find(changes_, key, &scene::Override::key);
  scene::Override change{"the page: " + key, key, value};
  if (found != changes_.end()) {
    *found = std::move(change);
  } else {
    changes_.push_back(std::move(change));
  }
}

std::string SceneFile::edited() const { return scene::edited_text(text_, path_.string(), changes_); }

void SceneFile::drop_overruled() {
  try {
    const auto is_overruled = [&](const scene::Override& change) {
      return scene::written_value(sound_text_, "", change) != scene::written_value(text_, "", change);
    };
    std::erase_if(changes_, is_overruled);
    static_cast<void>(scene::written_value(text_, "", {"", "seed", ""}));  // throws where it is no TOML
    sound_text_ = text_;
  } catch (const InputError&) {
    // No TOML at the moment: what it gives will be seen when it is.
  }
}

bool SceneFile::reload() {
  const Stamp now = stamp_of(path_);
  if (std::exchange(seen_, now) != now || now == stamp_) return false;
  std::string text = read();
  stamp_ = now;
  if (text == text_) return false;
  text_ = std::move(text);
  drop_overruled();
  return true;
}

void SceneFile::save() {
  if (changes_.empty()) return;
  const std::string text = edited();
  if (read() != text_) {
    throw InputError(Place{path_.string(), 0, 0, ""}, "expected the file as it was read, got one that has changed meanwhile");
  }
  const fs::path file = fs::canonical(path_);
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) refuse_writing(file, errno);
  if (::access(file.c_str(), W_OK) != 0) refuse_writing(file, errno);
  NewFile made(draft_of(file));
  made.write(text, found.st_mode & 07777U);
  made.take_name(file);
  text_ = text;
  sound_text_ = text;
  changes_.clear();
  seen_ = stamp_ = stamp_of(path_);
}

}  // namespace shatterpave::serve
