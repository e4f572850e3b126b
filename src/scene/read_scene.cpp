#include "scene/read_scene.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "core/sha256.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "scene/draft.h"
#include "scene/environment_file.h"
#include "scene/input_file.h"
#include "scene/schema/frame_keys.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/known_path.h"
#include "scene/schema/pane_section.h"
#include "scene/schema/pavement_section.h"
#include "scene/schema/scene_keys.h"
#include "scene/table_scene.h"
#include "scene/thing_sums.h"
#include "scene/toml/apply_override.h"
#include "scene/toml/toml_table.h"
#include "studio/world.h"

namespace shatterpave::scene {

namespace {

// A key of a.b.c… makes tables in tables, which are then torn down by recursion; arrays are limited by the parser itself.
constexpr int deepest_key = 64;

void limit_dotted_keys(std::string_view text, const std::string& file) {
  constexpr std::string_view breaks = ",=[]{}\n";
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (breaks.find(text[i]) != std::string_view::npos) dots = 0;
    // A run of dots, as in a comment, is no key.
    if (text[i] == '.' && (i == 0 || text[i - 1] != '.')) ++dots;
    if (dots <= deepest_key) continue;
    const TextPosition position = text_position(text, i);
    throw InputError(Place{file, position.line, position.column, ""},
                     fmt::format("expected at most {} dots in a row of words, got more", deepest_key));
  }
}

toml::table parsed_toml(std::string_view text, const std::string& file) {
  require_utf8(text, file);
  limit_dotted_keys(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    std::string what(error.description());
    std::ranges::replace(what, '\n', ' ');
    throw InputError(Place{file, static_cast<int>(begin.line), static_cast<int>(begin.column), ""},
                     fmt::format("expected TOML, got an error: {}", what));
  }
}

// The stem of the file, which names the files that are written; of what a shell hands over, "scene".
std::string scene_name(const std::filesystem::path& file) {
  if (is_nameless(file)) return "scene";
  std::string name = file.stem().string();
  const bool plain = !name.empty() && std::ranges::all_of(name, [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '"' && c != '\\';
  });
  if (!plain)
    throw InputError(Place{file.string(), 0, 0, ""}, "expected a file name without '\"', '\\' and control characters");
  return name;
}

Still still_of(const TomlTable& root) {
  Still still;
  const auto table = still_keys.read_in(root, still);
  const auto setting = table ? table->text("setting") : std::nullopt;
  if (!setting || setting->empty()) return still;
  const std::vector<std::string_view> names = settings();
  if (std::ranges::find(names, *setting) == names.end()) {
    const std::string_view meant = nearest(*setting, names);
    refuse(table->place("setting"), "a setting of " + listed(names, "or"),
           in_quotes(*setting) + (meant.empty() ? std::string() : fmt::format("; did you mean {}?", meant)));
  }
  still.setting = *setting;
  return still;
}

std::optional<studio::Camera> camera_of(const TomlTable& root) {
  studio::Camera camera;
  const auto table = camera_keys.read_in(root, camera);
  if (!table) return std::nullopt;
  if (camera.at_mm == camera.look_at_mm) {
    const std::string_view key = table->has("look_at_mm") ? "look_at_mm" : "at_mm";
    refuse(table->place(key), "a camera that looks at a place other than its own", "the same place");
  }
  return camera;
}

// A camera within glass would see the world as from under water.
void require_outside(const studio::Camera& camera, const std::vector<glass::Pane>& panes, const TomlTable& root) {
  for (const glass::Pane& pane : panes) {
    const vec3 at = studio::upright_of_world(studio::without(camera.at_mm, pane.placement));
    if (std::abs(at.z) > 0.5 * pane.thickness_mm) continue;
    if (!geometry::contains(pane.outline_mm, geometry::on_lattice({at.x, at.y}))) continue;
    refuse(root.place_of_given("camera.at_mm").value_or(root.place("camera")), "a camera outside the glass",
           fmt::format("one within that of {}", pane.name));
  }
}

void read_light(const TomlTable& root, const std::filesystem::path& file, const Scene* kept, Scene& scene) {
  LightAsked asked;
  const auto table = light_keys.read_in(root, asked);
  if (!table) return;
  asked.light.environment = table->text("environment").value_or("");
  if (table->has("sun_elevation_deg")) asked.light.sun = asked.sun;
  scene.light = asked.light;
  scene.environment_place = table->place("environment");
  if (asked.light.environment.empty()) return;
  if (kept != nullptr && kept->light && kept->light->environment == asked.light.environment) {
    scene.environment = kept->environment;
    return;
  }
  scene.environment = environment_named(asked.light.environment, file, scene.environment_place);
}

// Settings other than "own" have their places for things.
template <typename Thing>
void tell_idle_places(const std::vector<Thing>& things, const std::vector<KeyPlaces>& places, std::vector<Note>& notes) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].placement == studio::Placement{}) continue;
    const bool is_moved = things[i].placement.at_mm != studio::Placement{}.at_mm;
    add_note({places[i].place(is_moved ? "place_mm" : "place_turn_deg"),
              fmt::format("has no effect on stills but those of the setting \"{}\"", own_setting)},
             notes);
  }
}

// The table without its frames.
toml::table without_frames(const toml::table& table) {
  toml::table rest = table;
  rest.erase("frames");
  return rest;
}

// What the scene says, its plans and its environment hold: not how its file is laid out, nor where it lies, nor over which
// frames.
std::string fingerprint_of(const toml::table& table, const std::string& plan_sums,
                           const std::optional<studio::Environment>& environment) {
  std::ostringstream said;
  said.imbue(std::locale::classic());  // a program that uses the library may have another one
  if (table.contains("frames")) {
    said << toml::json_formatter(without_frames(table));
  } else {
    said << toml::json_formatter(table);
  }
  Sha256 hash;
  hash.add_text(said.str());
  hash.add_text(plan_sums);
  if (environment) hash.add_text(*environment->content);
  return hash.sum();
}

void read_things(const TomlTable& root, Scene& scene) {
  Plans plans(root, scene.notes);
  Names names;
  read_panes(root, plans, names, scene);
  read_pavements(root, plans, names, scene);
  scene.plan_sums = plans.sums();
}

void keep_things(const Scene& kept, Scene& scene) {
  scene.panes = kept.panes;
  scene.pavements = kept.pavements;
  scene.pane_places = kept.pane_places;
  scene.pavement_places = kept.pavement_places;
  scene.plan_sums = kept.plan_sums;
}

}  // namespace

Scene scene_of_table(const toml::table& table, const std::filesystem::path& file, const Scene* kept) {
  const std::string file_name = file.string();
  const TomlTable root(table, file_name, "", root_keys.names());
  Scene scene;
  scene.name = scene_name(file);
  root_keys.read(root, scene);
  if (kept != nullptr) {
    keep_things(*kept, scene);
  } else {
    read_things(root, scene);
  }
  if (scene.panes.empty() && scene.pavements.empty()) {
    throw InputError(Place{file_name, 0, 0, ""}, "expected a [[pane]] or a [[pavement]], got neither");
  }
  scene.still = still_of(root);
  scene.camera = camera_of(root);
  if (scene.camera) require_outside(*scene.camera, scene.panes, root);
  read_light(root, file, kept, scene);
  scene.frames = frames_of(root);
  scene.fingerprint = fingerprint_of(table, scene.plan_sums, scene.environment);
  if (scene.frames) sum_things(table, scene);
  tell_idle_keys(root, scene.notes);
  if (scene.still.setting != own_setting) {
    tell_idle_places(scene.panes, scene.pane_places, scene.notes);
    tell_idle_places(scene.pavements, scene.pavement_places, scene.notes);
  }
  return scene;
}

Draft::Draft(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file), table_(made()) {}
Draft::~Draft() = default;
Draft::Draft(const Draft& other) : text_(other.text_), file_(other.file_), changes_(other.changes_), table_(made()) {}
Draft& Draft::operator=(const Draft& other) { return *this = Draft(other); }
Draft::Draft(Draft&& other) noexcept = default;
Draft& Draft::operator=(Draft&& other) noexcept = default;

std::string Draft::name() const { return scene_name(file_); }

std::unique_ptr<Draft::Table> Draft::made() const {
  auto table = std::make_unique<Table>(Table{parsed_toml(text_, file_.string())});
  for (const Change& change : changes_) {
    if (change.appends) {
      append_table(change.given, table->root);
    } else {
      scene::apply(change.given, table->root);
    }
  }
  return table;
}

std::string Draft::apply(const Change& change) {
  const Key* const key = require_known(change.given, table_->root);
  if (change.appends && key != nullptr && key->type != ValueType::tables) {
    refuse(Place{change.given.origin, 0, 0, ""}, "a list of tables, such as pane or pane[0].impact",
           in_quotes(change.given.key));
  }
  changes_.push_back(change);
  try {
    if (change.appends) return append_table(change.given, table_->root);
    scene::apply(change.given, table_->root);
    return {};
  } catch (...) {
    // Tables on the way may have been made.
    changes_.pop_back();
    table_ = made();
    throw;
  }
}

void Draft::set(const Override& change) { apply({change, false}); }

std::string Draft::append(const Override& change) { return apply({change, true}); }

Scene Draft::scene() const { return scene_of_table(table_->root, file_); }

Scene scene_of_text(std::string_view text, const std::filesystem::path& file, const std::vector<Override>& overrides) {
  Draft draft(text, file);
  for (const Override& change : overrides) draft.set(change);
  return draft.scene();
}

Scene scene_of_file(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  return scene_of_text(input_text(file, largest_scene_bytes, Place{file.string(), 0, 0, ""}), file, overrides);
}

}  // namespace shatterpave::scene
