// What every exporter is given: the things that were asked for, and what was made of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "glass/gaps/crack_surface.h"
#include "glass/network.h"
#include "glass/pane.h"
#include "glass/shards/shards.h"
#include "paving/pavement.h"
#include "paving/seamless.h"
#include "paving/stones.h"
#include "studio/camera.h"
#include "studio/environment.h"
#include "studio/light.h"

namespace shatterpave::exporting {

// The photograph that a pane was traced on. Pixels count from the upper left corner, x right and y down; the middle of the
// first pixel is (0.5, 0.5).
struct Photograph {
  int width_px = 0;
  int height_px = 0;
  double mm_per_px = 1.0;                // of the picture once it is seen from straight ahead
  vec2 impact_px{0.0, 0.0};              // in the photograph
  std::array<vec2, 4> corners_px{};      // of the pane in the photograph: upper left, upper right, lower right, lower left
  std::array<int, 2> radial_interval{};  // M lies between these: lines near the impact run together
};

struct BrokenPane {
  glass::Pane pane;
  glass::CrackNetwork network;
  glass::CrackNetwork far_network{};   // of the far sheet of laminated glass, with numbers that follow on; empty: there is none
  std::vector<glass::Shard> shards{};  // where pane.shards asks for them
  glass::CrackSurfaces surfaces{};     // none unless the pane asks for sheets; of both networks
  std::optional<Photograph> photograph{};
  // Where the shards that leave the pane are at each frame of the model's shot, by id; empty: nothing moves.
  std::map<std::string, std::vector<glass::ShardPlace>> paths{};
  std::string stem{};  // of the names of its files; empty: its name

  // Of either network.
  const glass::Crack& crack(int id) const {
    const bool is_far = !far_network.cracks.empty() && id >= far_network.cracks.front().id;
    return (is_far ? far_network : network).crack(id);
  }
};

struct PavedArea {
  paving::Pavement pavement;
  paving::StoneLayout layout;
  std::optional<paving::SeamlessTile> tile{};  // where its textures ask for one
  std::string stem{};                          // as that of a pane
};

// What the names of files of the thing alone begin with.
inline const std::string& stem_of(const BrokenPane& broken) { return broken.stem.empty() ? broken.pane.name : broken.stem; }
inline const std::string& stem_of(const PavedArea& paved) { return paved.stem.empty() ? paved.pavement.name : paved.stem; }

// The frames of what moves.
struct ShotSpan {
  int first_frame = 1;
  int last_frame = 1;
  double per_second = 24.0;
};

struct Model {
  std::string name;         // of the scene: stem of the file names
  std::string setting;      // template of the still
  std::string fingerprint;  // of what it was made from, as in the scene
  std::uint64_t seed = 1;   // for draws that only an exporter needs, such as a stone's place in the relief
  std::vector<BrokenPane> panes;
  std::vector<PavedArea> pavements;
  // Of the still: whether glass parts colours, and whether light that it bends is thrown on what is behind it.
  bool dispersion = false;
  bool caustics = false;
  std::optional<studio::Camera> camera{};            // not given: the setting's own
  std::vector<studio::Camera> camera_path{};         // at each frame of the shot; empty: it stays as it is
  std::optional<studio::Light> light{};              // the same
  std::optional<studio::Environment> environment{};  // that `light` names
  std::optional<ShotSpan> shot{};                    // where something moves, for targets that hold it
  std::string shared_stem{};                         // of files that it has in common with other frames; empty: the name
};

inline const std::string& shared_stem_of(const Model& model) {
  return model.shared_stem.empty() ? model.name : model.shared_stem;
}

// The things of a scene, before anything is made of them.
struct Things {
  const std::vector<glass::Pane>& panes;
  const std::vector<paving::Pavement>& pavements;
};

// A file as it shall be, in memory.
struct OutputFile {
  std::string name;     // relative to the output folder, no folders
  std::string content;  // bytes
};

// Files that are too large for memory, and are written together.
struct FileSet {
  std::vector<std::string> names;                        // as those of `OutputFile`
  std::function<void(const std::string& folder)> write;  // writes all of them into the folder; the model must still be there
};

// What exporters make of a model.
struct Outputs {
  std::vector<OutputFile> files;
  std::vector<FileSet> sets;
};

}  // namespace shatterpave::exporting
