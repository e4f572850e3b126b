// Values given on the command line instead of in the scene file.
#pragma once

#include <string>

namespace shatterpave::scene {

// One value. `key` is a path of keys with '.', and '[index]' or the name of an element after an array of tables:
// `pane[0].thickness_mm`, `pavement.path.joint_mm`; names may stand in quotes, as in TOML. `value` is TOML; what is not TOML is
// taken as a text, so that quotes, which a shell eats, may be left out. `origin` is how a message names it: `--set
// pane[0].thickness_mm=3`.
struct Override {
  std::string origin;
  std::string key;
  std::string value;

  bool operator==(const Override&) const = default;
};

}  // namespace shatterpave::scene
