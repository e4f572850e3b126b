// A scene as plain values: all that the program can be asked for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/notes.h"
#include "glass/pane.h"
#include "paving/pavement.h"
#include "scene/toml/key_places.h"

namespace shatterpave::scene {

// How the scene is shown as a still: the name of a template of `templates/` (without its ending), or empty for the default,
// which is "window_still" where there is a pane, else "path_still".
struct Still {
  std::string setting;
  bool dispersion = false;  // glass parts colours
  bool caustics = false;    // light that glass bends is thrown on what is behind it
  bool operator==(const Still&) const = default;
};

struct Scene {
  std::string name;  // stem of the scene file; names the output files
  std::uint64_t seed = 1;
  std::vector<glass::Pane> panes;
  std::vector<paving::Pavement> pavements;
  Still still;
  // Where the keys of each pane and pavement stand, one for each; empty where the scene was read from no file.
  std::vector<KeyPlaces> pane_places;
  std::vector<KeyPlaces> pavement_places;
  std::vector<Note> notes;  // what was read otherwise than it was written, or has no effect; each once
  // SHA-256 of all that the scene was read from: the file as it stands with its overrides, but for comments and spaces, and its
  // plans. Two scenes are the same if what they ask for is, whatever this says.
  std::string fingerprint;

  bool operator==(const Scene& other) const {
    return name == other.name && seed == other.seed && panes == other.panes && pavements == other.pavements &&
           still == other.still;
  }
};

}  // namespace shatterpave::scene
