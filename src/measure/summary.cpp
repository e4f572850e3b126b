#include "measure/summary.h"

#include <cmath>
#include <limits>

#include "measure/experiment.h"

namespace shatterpave::measure {

namespace {

// The numbers that the generator is held to. Those about lines are from a fit to Table 1, with tolerances of about a standard
// error of its own; a single pane of Table 1 lies 1.14 from the line of N, and 1.8 mm from that of d_ave, of which the
// tolerance is twice.
constexpr double slope = 0.0615;
constexpr double slope_tolerance = 0.006;
constexpr double intercept = 3.06;
constexpr double intercept_tolerance = 0.6;
constexpr double greatest_residual = 1.2;
constexpr double ring_tolerance_mm = 3.6;
constexpr double least_turns_in_range = 99.0;  // %
constexpr double mean_turn_tolerance_deg = 0.5;
constexpr double left_turn_tolerance = 3.0;    // % about a half: by eye, since the paper says "symmetric"
constexpr double least_held_ring_ends = 95.0;  // %
constexpr double least_edge_angle_deg = 75.0;
constexpr double least_square_edge_angles = 90.0;  // %

double percentage(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

// Of a mean, or of a share in % where `scale` is 100.
double standard_error(double deviation, std::size_t count, double scale = 1.0) {
  return count == 0 ? unlimited : scale * deviation / std::sqrt(static_cast<double>(count));
}

// How far the fitted line of d_ave is from eq. 2, at most, over the M that were measured.
double greatest_ring_line_offset(const Line& line) {
  const auto offset = [&](double m) { return line.at(m) - experiment_ring_radius_mm(m); };
  const double low = offset(line.low_x);
  const double high = offset(line.high_x);
  return std::abs(low) > std::abs(high) ? low : high;
}

void add_large_findings(const Line& line, std::vector<Finding>& findings) {
  findings.push_back(judged({"large_slope", "Slope of N (reaching the edge) against M", "", slope - slope_tolerance,
                             slope + slope_tolerance, line.slope, line.slope_error, line.count, "panes"}));
  findings.push_back(judged({"large_intercept", "Intercept of N against M", "", intercept - intercept_tolerance,
                             intercept + intercept_tolerance, line.intercept, line.intercept_error, line.count, "panes"}));
  Finding residual{
      "large_residual", "Residual SD of N about its line", "", -unlimited, greatest_residual, line.residual, 0.0, line.count,
      "panes"};
  // A line that cannot be told has no residual either.
  const bool told = findings.back().verdict != Verdict::open;
  findings.push_back(told ? judged(residual) : residual);
}

void add_ring_findings(const Summary& sums, std::vector<Finding>& findings) {
  const Distribution& offset = sums.ring_offset_mm;
  findings.push_back(
      judged({"ring_radius", "Mean ring radius less 0.470 M + 13.90 mm", "mm", -ring_tolerance_mm, ring_tolerance_mm,
              offset.mean(), standard_error(offset.deviation(), offset.count()), offset.count(), "panes with rings"}));
  const Line& line = sums.ring_line;
  // The error of the line at its ends is about twice that of the mean.
  findings.push_back(judged({"ring_radius_line", "Greatest offset of the line of mean ring radii from it", "mm",
                             -ring_tolerance_mm, ring_tolerance_mm, greatest_ring_line_offset(line),
                             2.0 * standard_error(line.residual, line.count), line.count, "panes with rings"}));
}

}  // namespace

void Totals::add(const PaneMeasures& pane) {
  for (const ImpactMeasures& impact : pane.impacts) crossings_ += static_cast<std::size_t>(impact.crossing_count);
  if (pane.impacts.empty()) return;
  const ImpactMeasures& impact = pane.impacts.front();
  ++impacts_;
  for (const double count : pane.fragment_counts) {
    ++squares_;
    if (count < pane.least_fragment_count) ++coarse_squares_;
  }
  if (pane.subject == Subject::dice) return;
  ring_ends_ += static_cast<std::size_t>(impact.ring_crack_count);
  held_ring_ends_ += static_cast<std::size_t>(impact.held_ring_end_count);
  if (pane.subject != Subject::experiment) return;
  sums_.radial_count.add(impact.drawn.radial_count);
  large_points_.emplace_back(impact.drawn.radial_count, impact.reaching_count);
  sums_.ends.edge += impact.ends.edge;
  sums_.ends.crack += impact.ends.crack;
  sums_.ends.enclosed += impact.ends.enclosed;
  sums_.ends.open += impact.ends.open;
  add_rings(impact);
  add_turns(impact);
  for (const Angle angle : impact.edge_angles) {
    sums_.edge_angle_deg.add(angle.degrees());
    sums_.edge_angles_deg.add(angle.degrees());
    if (angle.degrees() >= least_edge_angle_deg) ++square_edge_angles_;
  }
  if (impact.gap_ratio) sums_.gap_ratio.add(*impact.gap_ratio);
}

void Totals::add_rings(const ImpactMeasures& impact) {
  if (impact.ring_distances_mm.empty()) return;
  const double expected = experiment_ring_radius_mm(impact.drawn.radial_count);
  Distribution distances;
  for (const double d : impact.ring_distances_mm) {
    distances.add(d);
    sums_.ring_ratio.add(d / expected);
    sums_.ring_ratios.add(d / expected);
  }
  sums_.ring_offset_mm.add(distances.mean() - expected);
  ring_points_.emplace_back(impact.drawn.radial_count, distances.mean());
}

void Totals::add_turns(const ImpactMeasures& impact) {
  for (const Angle angle : impact.turns) {
    const double turn = angle.degrees();
    sums_.turn_deg.add(turn);
    sums_.turns_deg.add(turn);
    if (turn >= least_turn_deg && turn <= greatest_turn_deg) ++turns_in_range_;
    if (turn > 0.0) ++left_turns_;
  }
}

Summary Totals::summary() const {
  Summary summary = sums_;
  summary.large_line = fitted_line(large_points_);
  summary.ring_line = fitted_line(ring_points_);
  std::vector<Finding>& findings = summary.findings;
  add_large_findings(summary.large_line, findings);
  add_ring_findings(summary, findings);

  const Distribution& turns = summary.turn_deg;
  findings.push_back(judged({"turns_in_range", "Turns along large cracks within −22.5° … 27.5°", "%", least_turns_in_range,
                             unlimited, percentage(turns_in_range_, turns.count()), 0.0, turns.count(), "turns"}));
  findings.push_back(
      judged({"turn_mean", "Mean turn along large cracks", "°", -mean_turn_tolerance_deg, mean_turn_tolerance_deg, turns.mean(),
              standard_error(turns.deviation(), turns.count()), turns.count(), "turns"}));
  findings.push_back(
      judged({"left_turns", "Turns to the left, of all", "%", 50.0 - left_turn_tolerance, 50.0 + left_turn_tolerance,
              percentage(left_turns_, turns.count()), standard_error(0.5, turns.count(), 100.0), turns.count(), "turns"}));
  findings.push_back(
      judged({"crossings", "Crossings of two cracks", "", 0.0, 0.0, static_cast<double>(crossings_), 0.0, impacts_, "panes"}));
  findings.push_back(judged({"ring_ends", "Ring cracks that end on a radial crack or the edge", "%", least_held_ring_ends,
                             unlimited, percentage(held_ring_ends_, ring_ends_), 0.0, ring_ends_, "ring cracks"}));
  const std::size_t edge_ends = summary.edge_angle_deg.count();
  findings.push_back(judged({"edge_angles", "Cracks that meet the edge at 90° ± 15°", "%", least_square_edge_angles, unlimited,
                             percentage(square_edge_angles_, edge_ends), 0.0, edge_ends, "ends on the edge"}));
  findings.push_back(judged({"radial_gaps", "Variance of the gaps between radials beyond the ring, random directions being 1",
                             "", -unlimited, 1.0, summary.gap_ratio.mean(), 0.0, summary.gap_ratio.count(), "panes"}));
  if (squares_ > 0) {
    findings.push_back(judged({"fragments", "Squares of 50 × 50 mm with fewer fragments than EN 12150-1 wants", "", 0.0, 0.0,
                               static_cast<double>(coarse_squares_), 0.0, squares_, "squares"}));
  }
  return summary;
}

const Finding& finding(const Summary& summary, std::string_view id) { return finding_of(summary.findings, id); }

}  // namespace shatterpave::measure
