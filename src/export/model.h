// What every exporter is given: the things that were asked for, and what was made of them.
#pragma once

#include <cstdint>
#include <functional>
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

namespace shatterpave::exporting {

struct BrokenPane {
  glass::Pane pane;
  glass::CrackNetwork network;
  std::vector<glass::Shard> shards{};  // where pane.shards asks for them
  glass::CrackSurfaces surfaces{};     // none unless the pane asks for sheets
};

struct PavedArea {
  paving::Pavement pavement;
  paving::StoneLayout layout;
  std::optional<paving::SeamlessTile> tile{};  // where its textures ask for one
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
};

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
