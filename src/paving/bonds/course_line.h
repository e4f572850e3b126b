// The line between two courses of stones, with the stops where perpends of either course end on it. Stones of both courses take
// all stops on their side as vertices, so that they share a bent side to the bit.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::paving {

class CourseLine {
 public:
  // `stops` are places along the line in any unit and order; those nearer than `least_gap` to another are taken for one.
  CourseLine(std::vector<double> stops, double least_gap) : stops_(std::move(stops)), least_gap_(least_gap) {
    std::ranges::sort(stops_);
    const auto same = [&](double a, double b) { return b - a < least_gap_; };
    stops_.erase(std::unique(stops_.begin(), stops_.end(), same), stops_.end());
  }

  // Appends point(stop) for the stops strictly between `from` and `to`, in that direction.
  template <typename Point>
  void append_between(double from, double to, Point point, geometry::Polygon& outline) const {
    const double low = std::min(from, to) + least_gap_;
    const double high = std::max(from, to) - least_gap_;
    const auto begin = std::ranges::lower_bound(stops_, low);
    const auto end = std::ranges::upper_bound(stops_, high);
    if (begin >= end) return;
    const auto first = outline.size();
    for (auto stop = begin; stop != end; ++stop) outline.push_back(point(*stop));
    if (from > to) std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(first), outline.end());
  }

 private:
  std::vector<double> stops_;
  double least_gap_;
};

}  // namespace shatterpave::paving
