// How a pane of tempered glass breaks: all of it, into dice.
#pragma once

#include <cstdint>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// A pane with more fragments than this is refused.
inline constexpr double most_fragments = 1e6;

// Throws InputError where a pane of tempered glass would fall into more.
void require_few_fragments(const Pane& pane, const Tempered& glass);

// The borders of the fragments as cracks of kind `dice`, with the guarantees of glass/breaking.h. They spread from the first
// impact; at later ones there is nothing left to break. Each runs on through the corners of fragments, in each as straight as
// it can, until it meets the edge or a crack; it starts at the impact, or on a crack; or, in a part of the pane that none of
// these came to, at a corner of its own (`origin`). So cracks enclose all fragments but for those that the edge bounds.
// Their times are those of a front that runs from the impact at growth.crack_speed_m_s: cracks are where it has been.
//
// Throws InputError as `require_few_fragments` does.
CrackNetwork diced_pane(const Pane& pane, const Tempered& glass, std::uint64_t seed);

}  // namespace shatterpave::glass
