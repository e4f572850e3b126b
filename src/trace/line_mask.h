// Which pixels of a picture are part of a line.
#pragma once

#include <optional>

#include "trace/picture.h"

namespace shatterpave::trace {

// Lines brighter than what is beside them, darker, or either.
enum class Polarity { bright, dark, both };

// The paper's way (Agui et al. 1992, §3.1.2): mean of 3 × 3 pixels, then a threshold, the one that is given or else Otsu's
// (IEEE Trans. SMC 9, 1979; by OpenCV). The lines are the side with fewer pixels.
Mask threshold_mask(const Grey& picture, std::optional<int> threshold);

// Lines of one to about eight pixels, and ribbons, against any ground: they stand out from both sides, at one of several widths
// and in one direction over several pixels. What is kept stands out by `least_contrast` levels and from the noise of its
// surroundings at some place, and by half as much all along. The two edges of a ribbon, bright and dark ones beside each other,
// are one line.
inline constexpr double least_contrast = 8.0;
//   ribbon_px  odd: what is narrower, but wider than lines, is a ribbon
Mask line_mask(const Grey& picture, Polarity polarity, int ribbon_px);

}  // namespace shatterpave::trace
