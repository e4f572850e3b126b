// The scene's file while it is shown: its text as it was read last, the values that were set in the page, and its writing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/override.h"

namespace shatterpave::serve {

class SceneFile {
 public:
  // Throws InputError where the file is missing, no file, or too large.
  explicit SceneFile(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return text_; }
  // What was set and is not in the file, a key once, in the order in which they were set first.
  const std::vector<scene::Override>& changes() const { return changes_; }

  // Sets a value in place of the file's. Throws InputError where the key is none of a scene's, or not one that a page may set:
  // those that name files, or things, are for the file's author alone.
  //   value  TOML
  void set(const std::string& key, const std::string& value);
  // Back to what the file says.
  void revert() { changes_.clear(); }

  // The text with all changes (scene/toml/edited_text.h). Throws InputError where that cannot be.
  std::string edited() const;

  // Looks whether the file is another one than the one read, by its number, size and times, and reads it when it has not
  // changed since the last look: an editor that writes it takes a moment. Changes of values that the file now gives otherwise
  // than it did are dropped: of two that changed a value the later one wins. Returns whether the text is another. Throws
  // InputError where the file is gone or cannot be read; the text stays.
  bool reload();

  // Writes the text with all changes in the file's place, as a new file that takes its name, with its mode; where the name is a
  // link, that of what it leads to. Throws InputError where the file is not what was read, or cannot be written.
  void save();

 private:
  struct Stamp {
    std::uint64_t device = 0;
    std::uint64_t number = 0;
    std::int64_t size = -1;
    std::int64_t changed_ns = 0;
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stamp_of(const std::filesystem::path& path);
  std::string read() const;
  void drop_overruled();

  std::filesystem::path path_;
  Stamp stamp_;  // of what was read
  Stamp seen_;   // at the last look
  std::string text_;
  std::string sound_text_;  // the last one that was TOML
  std::vector<scene::Override> changes_;
};

}  // namespace shatterpave::serve
