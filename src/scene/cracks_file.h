// Files with cracks: traced, exported or drawn.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "geometry/polygon.h"
#include "glass/map/proper_network.h"
#include "glass/network.h"

namespace shatterpave::scene {

// A crack of a file. A drawing may not say what kind it is of.
struct FileCrack {
  glass::DrawnCrack line;
  bool has_kind = true;
};

// A pane of a file, as far as the file says.
struct FilePane {
  std::string name;                          // empty in a drawing
  std::optional<geometry::Polygon> outline;  // simple, counter-clockwise, on the lattice; mm
  double thickness_mm = 2.0;
  std::vector<glass::ImpactCounts> impacts;  // strictly inside the outline
  std::vector<FileCrack> cracks;             // one or more
};

struct CracksFile {
  std::string file;
  std::vector<FilePane> panes;  // one or more
  std::string sum;              // SHA-256 of its content
};

// The panes of a geometry file (docs/scene-file.md: `--target json`), or the lines of a drawing: an SVG, in millimetres, y up,
// from the lower left corner of its page, or of its shape of the class `outline`, where there is one. Lines of a drawing go by
// the classes that our own drawings have: `large`, `radial`, `circular`, `branch`, `dice`, `rung`, `chip`. Throws InputError
// with the place in the file, or at `place` where there is no such file.
CracksFile cracks_of_file(const std::filesystem::path& file, const Place& place);

// The network of that pane's cracks within `outline`. Cracks without a kind are radial where they go along the way to the
// impact, else circular (glass/map/proper_network.h: `radiality`).
glass::CrackNetwork network_of(const FilePane& pane, const geometry::Polygon& outline,
                               const std::vector<glass::ImpactCounts>& impacts);

}  // namespace shatterpave::scene
