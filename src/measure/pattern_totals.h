// What many panes of pattern "real" measure together, held against what photographs of broken panes measure.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "measure/distribution.h"
#include "measure/finding.h"
#include "measure/pattern_measures.h"

namespace shatterpave::measure {

// Adds panes up, one after another. Counts were taken from 28 photographs of panes of annealed glass after a blunt hit, to
// about a fifth; see docs/measure.md.
class PatternTotals {
 public:
  void add(const PatternMeasures& pane);
  std::size_t count() const { return radial_counts_[0].count(); }
  // The findings of all panes so far.
  std::vector<Finding> findings() const;

 private:
  void add_counts(std::vector<Finding>& findings) const;
  void add_rings(std::vector<Finding>& findings) const;
  void add_pieces(std::vector<Finding>& findings) const;

  std::array<Distribution, 3> radial_counts_;
  Distribution gap_variation_;
  Distribution ring_variation_;
  std::size_t joints_ = 0;
  std::size_t staggered_ = 0;
  std::size_t sectors_ = 0;
  std::size_t gaps_ = 0;
  Distribution log_area_;
  std::vector<double> elongations_;
  std::vector<double> solidities_;
  std::vector<double> kinks_deg_;
  // ln r and ln(area) of pieces that the edge of the pane does not bound, from the first ring outwards.
  std::vector<std::pair<double, double>> sizes_;
};

}  // namespace shatterpave::measure
