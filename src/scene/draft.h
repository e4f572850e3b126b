// A scene that is being written: values as they were given. Only their syntax, and that scenes have such keys, has been checked
// so far.
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
  // A draft of a text in TOML; `file` names it in messages, its stem the scene, and outline files are sought from its folder.
  // Throws InputError where the text is no TOML.
  Draft(std::string_view text, const std::filesystem::path& file);
  ~Draft();
  Draft(const Draft& other);
  Draft& operator=(const Draft& other);
  Draft(Draft&& other) noexcept;
  Draft& operator=(Draft&& other) noexcept;

  // The name of the scene. Throws InputError if it cannot name files.
  std::string name() const;

  // Each throws InputError where the key leads to none that scenes have; the draft is then as it was.
  void set(const Override& change);
  // Adds a table, the value of the change as an inline table of TOML, to the list of tables that is its key. Returns the path
  // of the new table: the key with the index after it.
  std::string append(const Override& change);

  // Throws InputError with the place of the first thing that is wrong.
  Scene scene() const;

  struct Table;  // scene/table_scene.h
  // What text and changes make: for the room itself.
  const Table& table() const { return *table_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  friend class Shot;

  struct Change {
    Override given;
    bool appends = false;
  };

  // The table that text and changes make. It is made anew for each copy, since a copied table forgets where its values stand.
  std::unique_ptr<Table> made() const;
  std::string apply(const Change& change);

  std::string text_;
  std::filesystem::path file_;
  std::vector<Change> changes_;
  std::unique_ptr<Table> table_;
};

}  // namespace shatterpave::scene
