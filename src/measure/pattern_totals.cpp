#include "measure/pattern_totals.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "measure/distribution.h"
#include "measure/line.h"

namespace shatterpave::measure {

namespace {

// Counts of radials at 1.2, 4 and 8 radii of the crushed zone in photographs, and to which part they are known.
constexpr std::array<double, 3> photographed_counts = {23.0, 16.5, 13.0};
constexpr double count_tolerance = 0.2;
constexpr double log_area_deviation = 1.5;
constexpr double log_area_tolerance = 0.25;

// Pieces are put together by their distance in so many to a doubling, those with fewer than that left out.
constexpr double bins_to_a_doubling = 2.0;
constexpr std::size_t least_in_bin = 20;
// Nearer to the edge than this share of the way only small pieces are clear of it.
constexpr double nearest_edge = 0.8;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double error_of(const Distribution& values) {
  return values.count() == 0 ? unlimited : values.deviation() / std::sqrt(static_cast<double>(values.count()));
}

// The power of the distance with which the median of the area goes: a line through the medians of bins.
Line size_line(const std::vector<std::pair<double, double>>& sizes) {
  double least = 0.0;
  double greatest = 0.0;
  for (const auto& [log_r, log_area] : sizes) {
    least = std::min(least, log_r);
    greatest = std::max(greatest, log_r);
  }
  const double width = logarithm(2.0) / bins_to_a_doubling;
  std::vector<std::vector<double>> bins(static_cast<std::size_t>((greatest - least) / width) + 1);
  for (const auto& [log_r, log_area] : sizes) bins[static_cast<std::size_t>((log_r - least) / width)].push_back(log_area);
  std::vector<vec2> medians;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].size() >= least_in_bin)
      medians.emplace_back(least + (static_cast<double>(i) + 0.5) * width, median(std::move(bins[i])));
  }
  return fitted_line(medians);
}

}  // namespace

void PatternTotals::add(const PatternMeasures& pane) {
  for (std::size_t k = 0; k < radial_counts_.size(); ++k) radial_counts_[k].add(pane.radial_counts[k]);
  if (pane.gap_variation) gap_variation_.add(*pane.gap_variation);
  for (const double variation : pane.ring_variations) ring_variation_.add(variation);
  joints_ += static_cast<std::size_t>(pane.joint_count);
  staggered_ += static_cast<std::size_t>(pane.staggered_count);
  sectors_ += static_cast<std::size_t>(pane.sector_count);
  gaps_ += static_cast<std::size_t>(pane.gap_count);
  kinks_deg_.insert(kinks_deg_.end(), pane.kinks_deg.begin(), pane.kinks_deg.end());
  for (const PieceMeasures& piece : pane.pieces) {
    log_area_.add(logarithm(piece.area_mm2));
    elongations_.push_back(piece.elongation);
    solidities_.push_back(piece.solidity);
    const bool between = piece.distance_mm >= pane.first_ring_mm && piece.distance_mm <= nearest_edge * pane.room_mm;
    if (pane.first_ring_mm > 0.0 && between && !piece.at_edge) {
      sizes_.emplace_back(logarithm(piece.distance_mm), logarithm(piece.area_mm2));
    }
  }
}

void PatternTotals::add_counts(std::vector<Finding>& findings) const {
  const double first = radial_counts_[0].mean();
  const auto share = [&](std::string_view id, std::string_view quantity, std::size_t k) {
    const double wanted = photographed_counts[k] / photographed_counts[0];
    const bool told = first > 0.0;
    findings.push_back(judged({id, quantity, "", (1.0 - count_tolerance) * wanted, (1.0 + count_tolerance) * wanted,
                               told ? radial_counts_[k].mean() / first : 0.0,
                               told ? error_of(radial_counts_[k]) / first : unlimited, radial_counts_[k].count(), "panes"}));
  };
  share("real_radials_midway", "Radials at 4 radii of the crushed zone, of those at 1.2", 1);
  share("real_radials_outside", "Radials at 8 radii of the crushed zone, of those at 1.2", 2);
  findings.push_back(judged({"real_gaps", "SD over mean of the gaps between neighbouring radials, midway", "", 0.4, unlimited,
                             gap_variation_.mean(), error_of(gap_variation_), gap_variation_.count(), "panes"}));
  findings.push_back(judged({"real_kinks", "Median turn of radials where rings meet them", "°", 3.0, unlimited,
                             median(kinks_deg_), 0.0, kinks_deg_.size(), "junctions"}));
}

void PatternTotals::add_rings(std::vector<Finding>& findings) const {
  findings.push_back(
      judged({"real_ring_radius", "SD over mean of the radius of one ring", "%", 10.0, 16.0, 100.0 * ring_variation_.mean(),
              100.0 * error_of(ring_variation_), ring_variation_.count(), "rings"}));
  const double share = percentage(staggered_, joints_);
  const double error = joints_ == 0 ? unlimited : std::sqrt(share * (100.0 - share) / static_cast<double>(joints_));
  findings.push_back(judged({"real_staggered", "Radials across which a ring is staggered, of those it meets from both sides",
                             "%", 40.0, 60.0, share, error, joints_, "junctions"}));
  findings.push_back(judged({"real_ring_gaps", "Sectors that a ring leaves out", "%", 5.0, unlimited,
                             percentage(gaps_, sectors_), 0.0, sectors_, "sectors"}));
}

void PatternTotals::add_pieces(std::vector<Finding>& findings) const {
  const std::size_t count = log_area_.count();
  const double deviation = log_area_.deviation();
  findings.push_back(
      judged({"real_piece_areas", "SD of ln(area) of pieces above 1 mm²", "", log_area_deviation - log_area_tolerance,
              log_area_deviation + log_area_tolerance, deviation,
              count == 0 ? unlimited : deviation / std::sqrt(2.0 * static_cast<double>(count)), count, "pieces"}));
  const Line line = size_line(sizes_);
  findings.push_back(judged({"real_piece_growth",
                             "Power of the distance with which the median area of pieces goes, from the first ring outwards",
                             "", 2.0, unlimited, line.slope, 0.0, line.count < 3 ? 0 : sizes_.size(), "pieces"}));
  findings.push_back(judged({"real_elongation", "Median elongation of pieces", "", 2.2, 2.8, median(elongations_), 0.0,
                             elongations_.size(), "pieces"}));
  findings.push_back(judged({"real_solidity", "Median solidity of pieces", "", 0.93, unlimited, median(solidities_), 0.0,
                             solidities_.size(), "pieces"}));
}

std::vector<Finding> PatternTotals::findings() const {
  std::vector<Finding> findings;
  add_counts(findings);
  add_rings(findings);
  add_pieces(findings);
  return findings;
}

}  // namespace shatterpave::measure
