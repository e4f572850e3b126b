// The cracks of a pane as they were at a time, out of the cracks at the end: nothing is drawn anew, so what is there stays.
#pragma once

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Where tips are shown: points of the lattice beside points that divide each segment evenly, so far apart. Frames in which a
// large crack goes 0.05 mm are 33 ns apart.
inline constexpr double tip_step_mm = 0.05;

// Puts the times of a network in order: no crack starts on another, or ends on it, before that one was there. A crack that
// would be too early waits: at its start for where it starts, on its last segment for where it ends.
//   REQUIRES a sound network with times, each crack's never falling
void settle_times(CrackNetwork& network);

// Gives times to cracks of which none are known: of a front that runs from the impact of each at the pane's crack speed.
void time_by_front(const Pane& pane, CrackNetwork& network);

// The network as it was at a time of the pane's clock: what had happened before it.
//   1. Cracks keep their ids. Those that start then or later are left out, and so is one of which less than tip_step_mm, or
//      no point clear of its neighbours, would show.
//   2. The points of a crack are the first of its points in `network`; one that has not come to its end has one more, its tip,
//      which lies within 1 µm of its next segment there, and ends `open`, with `rest`.
//   3. At a later time no crack is shorter, and none is missing.
//   4. No two cracks cross, nor do they leave the pane: a tip keeps 2 µm off all that it does not start from, though two cracks
//      of `network` were nearer. Where one starts or ends on another, that one has its vertex.
//   5. Impacts that come then or later are left out, with their craters. They are the last.
//   6. When all have grown, the result is the network, but without its times.
//   REQUIRES the network of the pane, with times in order
CrackNetwork network_at(const Pane& pane, const CrackNetwork& network, double time_us);

}  // namespace shatterpave::glass
