// Where a pane was hit, and how many cracks leave from there.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "trace/line_graph.h"
#include "trace/line_mask.h"
#include "trace/picture.h"

namespace shatterpave::trace {

// A short piece of a line.
struct Chord {
  vec2 middle{0.0, 0.0};
  vec2 direction{1.0, 0.0};  // unit
  double length = 0.0;
};

// Chords of about `length_px` along all edges; what is left at an end is none.
std::vector<Chord> chords_of(const LineGraph& graph, double length_px);

// Where most lines look at: the point that chords, prolonged, pass nearest to, a chord far off counting less; found by votes of
// chords for squares, then by iterated weights (Cauchy's). Nothing where no point stands out: where less than 18 % of
// the length looks at it within 10°, less than 1.5 times as much as at other places of the picture, or from too few of twelve
// sides.
std::optional<vec2> impact_of(const std::vector<Chord>& chords, int width, int height);

// The share of the length of chords, but of those nearer than `near_px`, that look at `point` within 10°.
double share_looking_at(const std::vector<Chord>& chords, vec2 point, double near_px);

// The radius within which more than half of each circle about the impact is part of lines: what is crushed, or where lines run
// together.
double merged_radius(const Mask& mask, vec2 impact);

// How many lines leave the impact: the most that stand out on a circle about it, each circle being the mean over a band, in
// which lines that show here and there only are whole.
struct RadialCount {
  int count = 0;
  double radius_px = 0.0;         // of the circle on which they are counted
  double start_px = 0.0;          // from here on at least half as many are there
  std::array<int, 2> interval{};  // from what was counted to what may hide where lines run together
};
RadialCount radial_count(const Grey& picture, Polarity polarity, vec2 impact, double least_radius_px);

}  // namespace shatterpave::trace
