// What every exporter is given: the things that were asked for, and what was made of them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "glass/crack_surface.h"
#include "glass/network.h"
#include "glass/pane.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::exporting {

struct BrokenPane {
  glass::Pane pane;
  glass::CrackNetwork network;
  glass::CrackSurfaces surfaces{};  // none unless the pane asks for sheets
};

struct PavedArea {
  paving::Pavement pavement;
  paving::StoneLayout layout;
};

struct Model {
  std::string name;        // of the scene: stem of the file names
  std::string setting;     // template of the still
  std::uint64_t seed = 1;  // for draws that only an exporter needs, such as a stone's place in the relief
  std::vector<BrokenPane> panes;
  std::vector<PavedArea> pavements;
};

// A file as it shall be, in memory.
struct OutputFile {
  std::string name;     // relative to the output folder, no folders
  std::string content;  // bytes
};

}  // namespace shatterpave::exporting
