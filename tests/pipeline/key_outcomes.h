// What becomes of a key of the scene file: it is given one value and then another, and all that every target writes is
// compared.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/key_changes.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

// Other keys of the scene that the key is tried beside.
struct Surroundings {
  std::string name;
  std::vector<std::string> sets;  // KEY=VALUE
  std::vector<std::string>
      untried{};  // keys (or their beginnings) whose effect hangs on what is drawn: nothing is asked of them here
};

struct KeyOutcome {
  bool refused = false;
  bool has_effect = false;  // some byte of some file is another one
  std::string told;         // the note about it, with the second value
};

scene::Scene scene_with(const std::string& text, const std::vector<std::string>& sets, const std::filesystem::path& file);

// What is told of the key, or of a table that it lies in: that it has no effect.
std::string told_of(const scene::Scene& scene, const std::string& key);

KeyOutcome outcome(const std::string& text, const Surroundings& around, const Change& change,
                   const std::filesystem::path& file = "keys.toml");

// Where the bytes are the same, there must be a note at the key, or the value is refused; where they are not, there must be
// none. The surroundings are tried in parts, so that no test takes long: every part_count-th from `part` on.
inline constexpr std::size_t part_count = 4;
void expect_effect_or_word(const std::string& text, const std::vector<Surroundings>& surroundings,
                           const std::vector<Change>& changes, std::size_t part);

bool is_tried(const Surroundings& around, const Change& change);
void expect_effect_somewhere(const std::string& text, const std::vector<Surroundings>& surroundings,
                             const std::vector<Change>& changes);

}  // namespace shatterpave::pipeline
