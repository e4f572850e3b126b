#include "measure/pavement_findings.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "measure/bare_spot.h"

namespace shatterpave::measure {

namespace {

constexpr double most_misaligned_mean_deg = 1.5;
constexpr double most_misaligned_p95_deg = 5.0;
constexpr double least_four_sided = 98.0;  // %
constexpr double least_covered = 99.5;     // %
constexpr double joint_tolerance = 10.0;   // % of the asked width, from the 5th to the 95th percentile
// Half of a change by 5 %, which must be told; half of all joints lie on either side of the median, so that it stays where it
// is when some are off.
constexpr double joint_median_tolerance = 2.5;
constexpr double most_area_spread = 8.0;  // %
constexpr double least_smallest = 25.0;   // %
// Of the stock; what lies above the whole is for the rounding of corners to the lattice.
constexpr double most_of_stock = 100.1;  // %
// Irregular spots over the least number that the field allows; by eye: with twice as many one still sees rows.
constexpr double most_spots_to_least = 2.0;
// Missing stones are drawn one by one: within four standard deviations of the binomial law.
constexpr double missing_deviations = 4.0;

using FindingOf = std::function<Finding(const LayoutFigures&)>;

// How far a figure is beyond its range, or how near to its end: the larger, the worse.
double badness(const Finding& f) {
  if (f.count == 0) return -unlimited;
  return std::max(f.low - f.figure, f.figure - f.high);
}

Finding worst(std::span<const LayoutFigures> layouts, const FindingOf& of) {
  Finding found = of(layouts.front());
  for (const LayoutFigures& figures : layouts.subspan(1)) {
    const Finding other = of(figures);
    if (badness(other) > badness(found)) found = other;
  }
  return judged(found);
}

Finding at_most(std::string_view id, std::string_view quantity, std::string_view unit, double high, double figure,
                std::size_t count, std::string_view counted) {
  return {id, quantity, unit, -unlimited, high, figure, 0.0, count, counted};
}

Finding at_least(std::string_view id, std::string_view quantity, double low, double figure, std::size_t count,
                 std::string_view counted) {
  return {id, quantity, "%", low, unlimited, figure, 0.0, count, counted};
}

Finding none(std::string_view id, std::string_view quantity, std::size_t figure, std::size_t count) {
  return {id, quantity, "", 0.0, 0.0, static_cast<double>(figure), 0.0, count, "stones"};
}

Finding missing(const paving::Pavement& pavement, const LayoutFigures& f) {
  const double share = pavement.variation.missing;
  const auto count = static_cast<double>(std::max<std::size_t>(f.stones, 1));
  const double tolerance = 100.0 * missing_deviations * std::sqrt(share * (1.0 - share) / count);
  return {"missing_stones",
          "Stones left out, of all, as the variation asks",
          "%",
          100.0 * share - tolerance,
          100.0 * share + tolerance,
          100.0 * static_cast<double>(f.missing) / count,
          0.0,
          f.stones,
          "stones"};
}

Finding joint_median(const LayoutFigures& f) {
  return {"joint_median",
          "Width of joints over the asked one, median",
          "%",
          100.0 - joint_median_tolerance,
          100.0 + joint_median_tolerance,
          f.joint_median_percent,
          0.0,
          f.joints,
          "joints"};
}

Finding bare_spot(const paving::Pavement& pavement, const LayoutFigures& f) {
  return at_most("bare_spot", "Widest bare spot between stones grown by half a joint", "mm", widest_allowed_spot_mm(pavement),
                 f.bare_spot_mm, f.stones, "stones");
}

Finding largest_stone(const LayoutFigures& f) {
  return at_most("largest_stone", "Largest stone over its stock, in length, width or area", "%", most_of_stock,
                 f.largest_limited_percent, f.limited, "stones");
}

// A finding, and whether it is one of cobbles and scales too: what only a paviour's stones are held to, they are not.
struct Held {
  FindingOf of;
  bool cells_too = false;
};

std::vector<Held> all_findings(const paving::Pavement& pavement) {
  using F = LayoutFigures;
  constexpr bool cells_too = true;
  return {
      {[](const F& f) {
        return at_most("alignment_mean", "Sides of whole stones against their rows, mean", "°", most_misaligned_mean_deg,
                       f.misaligned_mean_deg, f.sides, "sides");
      }},
      {[](const F& f) {
        return at_most("alignment_p95", "Sides of whole stones against their rows, 95th percentile", "°",
                       most_misaligned_p95_deg, f.misaligned_p95_deg, f.sides, "sides");
      }},
      {[](const F& f) {
        return at_least("four_sided", "Four-sided among whole stones", least_four_sided, f.four_sided_percent, f.shaped,
                        "whole stones");
      }},
      {[](const F& f) { return none("overlaps", "Pairs of stones that overlap or touch", f.faults.overlaps, f.stones); },
       cells_too},
      {[](const F& f) { return none("outside", "Stones outside the area or in a hole", f.faults.outside, f.stones); },
       cells_too},
      {[](const F& f) { return none("invalid", "Stones whose outline is no plain polygon", f.faults.invalid, f.stones); },
       cells_too},
      {[](const F& f) {
         return at_least("coverage", "Area under stones grown by half a joint", least_covered, f.covered_percent, f.stones,
                         "stones");
       },
       cells_too},
      {[](const F& f) { return none("holes", "Places where a stone is missing", f.holes, f.stones); }, cells_too},
      {[&pavement](const F& f) { return bare_spot(pavement, f); }, cells_too},
      {[&pavement](const F& f) { return missing(pavement, f); }, cells_too},
      {[](const F& f) {
        return at_least("joint_p5", "Width of joints over the asked one, 5th percentile", 100.0 - joint_tolerance,
                        f.joint_p5_percent, f.joints, "joints");
      }},
      {joint_median},
      {[](const F& f) {
        return at_most("joint_p95", "Width of joints over the asked one, 95th percentile", "%", 100.0 + joint_tolerance,
                       f.joint_p95_percent, f.joints, "joints");
      }},
      {[](const F& f) {
        return at_most("area_spread", "Spread of whole stones' areas, SD over mean", "%", most_area_spread,
                       f.area_spread_percent, f.sized, "whole stones");
      }},
      {[](const F& f) {
        return at_least("smallest_piece", "Smallest piece over a whole stone", least_smallest, f.smallest_percent, f.stones,
                        "stones");
      }},
      {largest_stone},
      {[](const F& f) {
        return at_most("irregular_spots", "Spots of irregular stones, against twice the least that the field allows", "",
                       most_spots_to_least * f.field.least_spots(), static_cast<double>(f.irregular_spots), f.counted_stones,
                       "inner stones");
      }},
  };
}

}  // namespace

std::vector<Finding> pavement_findings(const paving::Pavement& pavement, std::span<const LayoutFigures> layouts) {
  ENSURE(!layouts.empty());
  std::vector<Finding> findings;
  const bool is_of_cells = pavement.cell.form != paving::CellForm::stone;
  for (const Held& held : all_findings(pavement)) {
    if (held.cells_too || !is_of_cells) findings.push_back(worst(layouts, held.of));
  }
  return findings;
}

}  // namespace shatterpave::measure
