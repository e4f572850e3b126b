// From a photograph of a broken pane to its cracks: the measuring chain of Agui et al. 1992, §3.1, and what pictures from
// elsewhere need besides. docs/trace.md tells users the steps and how sure they are.
#pragma once

#include <array>
#include <optional>

#include "glass/network.h"
#include "trace/line_mask.h"
#include "trace/picture.h"

namespace shatterpave::trace {

enum class Chain {
  robust,  // lines by how they stand out from what is beside them; gaps bridged, double lines and crumbs seen to
  paper,   // mean of 3 × 3, a threshold, tracking by steps of 10 px of a pane of 640 px, and nothing else
};

struct Options {
  Chain chain = Chain::robust;
  Polarity polarity = Polarity::both;
  std::optional<int> threshold;       // 0 … 255, of the paper's chain; else Otsu's
  std::optional<Corners> corners_px;  // of the pane in the photograph; else it is the photograph
  std::optional<vec2> pane_mm;        // its width and height
  std::optional<double> mm_per_px;    // where the size is not given
  std::optional<vec2> impact_px;      // in the photograph; else it is found
};

// The pane as it was traced. Lengths on it are mm from its lower left corner, y up.
struct Trace {
  vec2 pane_mm{0.0, 0.0};
  bool size_was_assumed = false;         // neither pane_mm nor mm_per_px: the longer side is 300 mm, the paper's
  double mm_per_px = 1.0;                // of the picture that was traced, seen straight
  Corners corners_px{};                  // in the photograph
  vec2 impact_px{0.0, 0.0};              // in the photograph
  std::array<int, 2> radial_interval{};  // M lies between: lines near the impact run together
  double count_radius_mm = 0.0;          // of the circle on which M was counted
  glass::CrackNetwork network;           // one impact; radial_count M, large_count N, circular_count: pieces of rings
  Perspective to_photograph;             // from px of the picture seen straight

  // Where a point of the pane is in the photograph.
  vec2 in_photograph(vec2 mm) const { return to_photograph(vec2{mm.x, pane_mm.y - mm.y} / mm_per_px); }
};

// Throws InputError, without a place, where there are no lines, or where they are not those of a broken pane: it says what was
// expected and what was found, and nothing is made up.
Trace traced(const Grey& photograph, const Options& options);

}  // namespace shatterpave::trace
