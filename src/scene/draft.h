// A scene that is being written: its values as they are given, of which only paths and syntax are checked yet.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/override.h"
#include "scene/scene.h"

namespace shatterpave::scene {

class Draft {
 public:
  // Of a text in TOML; `file` names it in messages, its stem names the scene, and outline files are sought from its folder.
  // Throws InputError where the text is no TOML.
  Draft(std::string_view text, const std::filesystem::path& file);
  ~Draft();
  Draft(const Draft& other);
  Draft& operator=(const Draft& other);
  Draft(Draft&& other) noexcept;
  Draft& operator=(Draft&& other) noexcept;

  // Of the scene. Throws InputError where files cannot be named by it.
  std::string name() const;

  // Each throws InputError where the key leads nowhere; the draft is then as it was.
  void set(const Override& change);
  // Adds a table, the value of the change as an inline table of TOML, to the list of tables that is its key. Returns the path
  // of the new table: the key with the index after it.
  std::string append(const Override& change);

  // Throws InputError with the place of the first thing that is wrong.
  Scene scene() const;

 private:
  struct Change {
    Override given;
    bool appends = false;
  };
  struct Table;

  // The table that text and changes make: a copy of it would have forgotten where its values stand.
  std::unique_ptr<Table> made() const;
  std::string apply(const Change& change);

  std::string text_;
  std::filesystem::path file_;
  std::vector<Change> changes_;
  std::unique_ptr<Table> table_;
};

}  // namespace shatterpave::scene
