/// \file
/// A scene: what is asked for.
///
/// A scene is described by its keys, which are the same everywhere: in scene files (TOML), in `--set KEY=VALUE`, and here in
/// Scene::set. docs/scene-file.md has every key with its range, default and effect; there is no struct to be kept in step with
/// it. A path of keys has a '.' between them, and the name or the index of an element after a list:
/// `pane.window.thickness_mm`, `pane[0].impact[1].at_mm`.
///
///     using namespace shatterpave;
///     Scene scene("shop");                                   // or Scene::from_file("shop.toml")
///     scene.add_pane("window", {{0, 0}, {1200, 0}, {1200, 900}, {0, 900}});
///     scene.add_impact("window", {500, 400});
///     scene.set("pane.window.thickness_mm", 6);
///     scene.set("pane.window.impact[0].mean_radial_count", 40);
///     scene.add_pavement("court", {{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}});
///     scene.set("pavement.court.stone_mm", Point{100, 100});
///     scene.set("seed", 7);
///     scene.check();                                         // throws InputError where something is wrong
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <shatterpave/error.h>
#include <shatterpave/geometry.h>

namespace shatterpave {

/// The value of a key. Made from what the key takes by itself, as in `scene.set("seed", 7)`.
class Value {
 public:
  /// `true` or `false`.
  template <std::same_as<bool> Flag>
  Value(Flag flag) : toml_(flag ? "true" : "false") {}
  /// A whole number.
  template <std::integral Number>
  requires(!std::same_as<Number, bool>) Value(Number number) : toml_(std::to_string(number)) {}
  /// A number; its shortest text that reads back to the same bits is taken, so none is lost.
  Value(double number);
  /// A text in UTF-8, also where it looks like a number.
  Value(std::string_view text);
  /// \copydoc Value(std::string_view)
  Value(const std::string& text) : Value(std::string_view(text)) {}
  /// \copydoc Value(std::string_view)
  Value(const char* text) : Value(std::string_view(text)) {}
  /// `[x, y]`: a point, or two lengths such as those of `stone_mm`.
  Value(Point point);
  /// A list of points: an outline, a line.
  Value(const std::vector<Point>& points);
  /// A list of lists of points: holes, guides.
  Value(const std::vector<Polygon>& polygons);

  /// What the command's `--set KEY=VALUE` takes VALUE for: TOML, such as `4`, `[100, 100]` or `{fall_percent = 2}`; what is not
  /// TOML is a text.
  static Value parsed(std::string_view text);

  /// The value as TOML.
  const std::string& toml() const { return toml_; }

 private:
  std::string toml_;
};

/// What is asked for: panes, pavements, their still, and the seed from which all that is left to chance follows.
///
/// A scene is read in two steps. Where it comes from TOML, its syntax is checked at once, and so are the paths of keys that are
/// set. Its keys and values are checked when all of them are there: by check(), or by what needs them first (notes(),
/// pane_names(), pavement_names(), generate). Files that the scene names, such as plans, are read then too, and again only
/// after the scene was changed.
///
/// Threads: functions that are const may be called on one scene by several threads at once; others may not.
class Scene {
 public:
  /// A scene with nothing in it. Its name names files: it may not hold '"', '\', '/' or control characters.
  explicit Scene(std::string_view name = "scene");
  /// The scene of a file. Its stem names the scene; relative names of files in it start at its folder.
  static Scene from_file(const std::filesystem::path& file);
  /// The scene of a text in TOML, as if it stood in the file of that name, which need not exist.
  static Scene from_text(std::string_view toml, const std::filesystem::path& file = "scene.toml");

  /// A copy is independent of its original.
  Scene(const Scene& other);
  /// \copydoc Scene(const Scene&)
  Scene& operator=(const Scene& other);
  /// What was moved from may only be assigned to or destroyed.
  Scene(Scene&& other) noexcept;
  /// \copydoc Scene(Scene&&)
  Scene& operator=(Scene&& other) noexcept;
  ~Scene();

  /// Sets the value of a key, over the one that it had. Throws InputError where the path leads to no key that scenes
  /// have, with the one that was probably meant. Tables on the way are made, elements of lists are not (see add). Returns this
  /// scene.
  Scene& set(std::string_view key, const Value& value);

  /// Adds an empty table to a list of them, `pane` or `pane.window.impact`, which is made where it is missing. Returns the path
  /// of the new table, that of the list with the index after it, to set its keys by: `pane.window.impact[2]`. Throws InputError
  /// where the path leads to no list of tables.
  std::string add(std::string_view list);

  /// Adds a pane with a preset or an outline still to be set. Returns its path.
  std::string add_pane(std::string_view name);
  /// Adds a pane with an outline, mm. Returns its path.
  std::string add_pane(std::string_view name, const Polygon& outline);
  /// Adds an impact to the pane of that name. Returns its path.
  std::string add_impact(std::string_view pane, Point at);
  /// Adds a pavement with an outline still to be set. Returns its path.
  std::string add_pavement(std::string_view name);
  /// Adds a pavement with an outline and holes, mm. Returns its path.
  std::string add_pavement(std::string_view name, const Polygon& outline, const std::vector<Polygon>& holes = {});

  /// Throws InputError, with the place, at the first thing that is wrong with the scene, also where it asks for what cannot be
  /// made, as far as that can be told without making it.
  void check() const;

  /// The name of the scene, which names the files that are made of it.
  const std::string& name() const;
  /// The seed. Throws as check() does.
  std::uint64_t seed() const;
  /// Notes: keys without effect, how a plan was read, things of which nothing will be laid. Throws as
  /// check() does.
  std::vector<Note> notes() const;
  /// Names of the panes, in order. Throws as check() does.
  std::vector<std::string> pane_names() const;
  /// Names of the pavements, in order: a plan may hold several areas, each a pavement of its own, and so is each step of a
  /// flight. Kerbs are pavements of the model only. Throws as check() does.
  std::vector<std::string> pavement_names() const;

 private:
  friend class SceneAccess;
  std::string append(std::string origin, std::string list, std::string table);

  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace shatterpave
