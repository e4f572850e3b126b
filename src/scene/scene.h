// A scene as plain values: all that the program can be asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/notes.h"
#include "glass/pane.h"
#include "paving/pavement.h"
#include "scene/frames.h"
#include "scene/toml/key_places.h"
#include "studio/camera.h"
#include "studio/environment.h"
#include "studio/light.h"

namespace shatterpave::scene {

// How the scene is shown as a still: the name of a template of `templates/` (without its ending), or empty for the default,
// which is "window_still" where there is a pane, else "path_still"; or `own_setting`.
inline constexpr std::string_view own_setting = "own";

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
  std::vector<paving::Pavement> pavements;  // as asked for: areas of one table have one name (pipeline/parts.h numbers them)
  Still still;
  std::optional<studio::Camera> camera;            // not given: that of the still's setting
  std::optional<studio::Light> light;              // the same
  std::optional<studio::Environment> environment;  // that `light` names
  std::optional<Frames> frames;                    // the shot; its keys have no effect on what stands here (scene/shot.h)
  // Where the keys of each pane and pavement stand, one for each; empty where the scene was read from no file.
  std::vector<KeyPlaces> pane_places;
  std::vector<KeyPlaces> pavement_places;
  Place environment_place;  // of the key that names it
  std::vector<Note> notes;  // what was read otherwise than it was written, or has no effect; each once
  // SHA-256 of all that the scene was read from: the file as it stands with its overrides, but for comments, spaces and
  // [frames], and its plans. Two scenes are the same if what they ask for is, whatever this says.
  std::string fingerprint;
  // The same of what each pane and pavement is made from, wherever it stands; of a scene with frames alone. Of one version of
  // the program, equal sums make equal things.
  std::vector<std::string> pane_sums;
  std::vector<std::string> pavement_sums;
  std::string plan_sums;  // of the plans and other files of panes and pavements, for that

  bool operator==(const Scene& other) const {
    return name == other.name && seed == other.seed && panes == other.panes && pavements == other.pavements &&
           still == other.still && camera == other.camera && light == other.light && environment == other.environment &&
           frames == other.frames;
  }
};

}  // namespace shatterpave::scene
