#include "pipeline/key_outcomes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/error.h"
#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "export/povray/povray.h"
#include "export/svg/drawing_svg.h"
#include "export/textures/textures.h"
#include "pipeline/generate.h"
#include "scene/read_scene.h"

namespace shatterpave::pipeline {

namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

Files taken(std::vector<exporting::OutputFile> made) {
  Files files;
  for (exporting::OutputFile& file : made) files[file.name] = std::move(file.content);
  return files;
}

Files textures(const exporting::Model& model) {
  std::string pattern = (fs::temp_directory_path() / "key-outcomes-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder");
  Files files;
  for (const exporting::FileSet& set : exporting::textures::texture_files(model)) {
    set.write(pattern);
    for (const std::string& name : set.names) {
      std::ifstream stream(fs::path(pattern) / name, std::ios::binary);
      std::ostringstream text;
      text << stream.rdbuf();
      files[name] = text.str();
    }
  }
  fs::remove_all(pattern);
  return files;
}

Files shards(const exporting::Model& model) {
  const auto has_shards = [](const exporting::BrokenPane& broken) { return broken.pane.shards.has_value(); };
  return std::ranges::any_of(model.panes, has_shards) ? taken(exporting::obj_files(model)) : Files();
}

// Target by target, the quick ones first: most keys show there. Textures are slow, and draw nothing that others do not show,
// but for what their own keys say.
bool differ(const exporting::Model& one, const exporting::Model& other, bool with_textures) {
  const std::vector<std::function<Files(const exporting::Model&)>> targets = {
      [](const auto& model) { return taken({exporting::json_file(model)}); },
      [](const auto& model) { return taken(exporting::svg_files(model)); },
      [](const auto& model) { return taken(exporting::povray::povray_files(model)); }, shards};
  if (std::ranges::any_of(targets, [&](const auto& target) { return target(one) != target(other); })) return true;
  return with_textures && textures(one) != textures(other);
}

bool begins(const std::string& key, const std::string& table) {
  return key.starts_with(table) && (key.size() == table.size() || key[table.size()] == '.' || key[table.size()] == '[');
}

}  // namespace

scene::Scene scene_with(const std::string& text, const std::vector<std::string>& sets, const fs::path& file) {
  std::vector<scene::Override> overrides;
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    overrides.push_back({"--set " + set, set.substr(0, equals), set.substr(equals + 1)});
  }
  return scene::scene_of_text(text, file, overrides);
}

std::string told_of(const scene::Scene& scene, const std::string& key) {
  for (const Note& note : scene.notes) {
    if (begins(key, note.place.key) && note.what.starts_with("has no effect")) return note.what;
  }
  return {};
}

KeyOutcome outcome(const std::string& text, const Surroundings& around, const Change& change, const fs::path& file) {
  KeyOutcome result;
  std::vector<std::string> sets = around.sets;
  sets.push_back(change.key + "=" + change.one);
  try {
    const scene::Scene first = scene_with(text, sets, file);
    sets.back() = change.key + "=" + change.other;
    const scene::Scene second = scene_with(text, sets, file);
    result.told = told_of(second, change.key);
    const auto is_of_textures = [](const std::string& set) { return set.find(".textures") != std::string::npos; };
    result.has_effect = differ(generated(first), generated(second), std::ranges::any_of(sets, is_of_textures));
  } catch (const InputError&) {
    result.refused = true;
  }
  return result;
}

bool is_tried(const Surroundings& around, const Change& change) {
  const auto is_of_it = [&](const std::string& set) { return set.starts_with(change.key + "="); };
  const auto begins_it = [&](const std::string& key) { return change.key.starts_with(key); };
  return std::ranges::none_of(around.sets, is_of_it) && std::ranges::none_of(around.untried, begins_it);
}

void expect_effect_somewhere(const std::string& text, const std::vector<Surroundings>& surroundings,
                             const std::vector<Change>& changes) {
  for (const Change& change : changes) {
    const auto has_effect = [&](const Surroundings& around) {
      return is_tried(around, change) && outcome(text, around, change).has_effect;
    };
    EXPECT_TRUE(std::ranges::any_of(surroundings, has_effect)) << change.key << " changes nothing anywhere";
  }
}

void expect_effect_or_word(const std::string& text, const std::vector<Surroundings>& surroundings,
                           const std::vector<Change>& changes, std::size_t part) {
  for (std::size_t i = part; i < surroundings.size(); i += part_count) {
    const Surroundings& around = surroundings[i];
    for (const Change& change : changes) {
      if (!is_tried(around, change)) continue;
      const KeyOutcome result = outcome(text, around, change);
      if (result.refused) continue;
      EXPECT_EQ(result.has_effect, result.told.empty())
          << around.name << ": " << change.key << " = " << change.one << " or " << change.other
          << (result.has_effect ? " changes files, but is told: " + result.told : " changes nothing, and nothing is told");
    }
  }
}

}  // namespace shatterpave::pipeline
