#include "scene/read_scene.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

#include "core/sha256.h"
#include "scene/draft.h"
#include "scene/input_file.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/pane_section.h"
#include "scene/schema/pavement_section.h"
#include "scene/schema/scene_keys.h"
#include "scene/toml/apply_override.h"
#include "scene/toml/toml_table.h"

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

toml::table parsed(std::string_view text, const std::string& file) {
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

// What the scene says and its plans hold: not how its file is laid out, nor where it lies.
std::string fingerprint_of(const toml::table& table, const Plans& plans) {
  std::ostringstream said;
  said.imbue(std::locale::classic());  // a program that uses the library may have another one
  said << toml::json_formatter(table);
  Sha256 hash;
  hash.add_text(said.str());
  hash.add_text(plans.sums());
  return hash.sum();
}

Scene scene_of_table(const toml::table& table, const std::filesystem::path& file) {
  const std::string file_name = file.string();
  const TomlTable root(table, file_name, "", root_keys.names());
  Scene scene;
  scene.name = scene_name(file);
  root_keys.read(root, scene);
  Plans plans(root, scene.notes);
  Names names;
  read_panes(root, plans, names, scene);
  read_pavements(root, plans, names, scene);
  if (scene.panes.empty() && scene.pavements.empty()) {
    throw InputError(Place{file_name, 0, 0, ""}, "expected a [[pane]] or a [[pavement]], got neither");
  }
  scene.still = still_of(root);
  scene.fingerprint = fingerprint_of(table, plans);
  tell_idle_keys(root, scene.notes);
  return scene;
}

}  // namespace

struct Draft::Table {
  toml::table root;
};

Draft::Draft(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file), table_(made()) {}
Draft::~Draft() = default;
Draft::Draft(const Draft& other) : text_(other.text_), file_(other.file_), changes_(other.changes_), table_(made()) {}
Draft& Draft::operator=(const Draft& other) { return *this = Draft(other); }
Draft::Draft(Draft&& other) noexcept = default;
Draft& Draft::operator=(Draft&& other) noexcept = default;

std::string Draft::name() const { return scene_name(file_); }

std::unique_ptr<Draft::Table> Draft::made() const {
  auto table = std::make_unique<Table>(Table{parsed(text_, file_.string())});
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
