// Ranges are wide: they keep numbers where the model has a meaning and ends, not where it looks good.
#include <algorithm>

#include "core/random.h"
#include "glass/growth/counts.h"
#include "scene/schema/pane_keys.h"

namespace shatterpave::scene {

namespace {

using glass::Growth;
using glass::Impact;
using GrowthRow = Row<Growth, PaneFacts>;

constexpr std::string_view without_ring_cracks = "without ring cracks: circular_count is 0, or radial_count too low for them";
constexpr std::string_view beside_few_radials = "beside a radial_count up to circular_threshold";
constexpr std::string_view beside_ring_counts = "beside circular_count or preset";
constexpr std::string_view beside_large_counts = "beside large_count or preset";
constexpr std::string_view beside_no_spread = "beside spread_limit = 0";
constexpr std::string_view beside_printed = "beside law = \"printed\"";
constexpr std::string_view without_rectangle = "without region = \"rectangle\"";
constexpr std::string_view beside_other_region = "beside another region";
constexpr std::string_view without_printed = "without law = \"printed\"";

bool with_counts(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.radial_count.has_value(); });
}
bool with_counts_or_means(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.radial_count || i.mean_radial_count; });
}
bool with_large_counts(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.large_count.has_value(); });
}
bool with_ring_counts(const PaneFacts& f) {
  return f.all_impacts([](const Impact& i) { return i.circular_count.has_value(); });
}
// By what the scene says of counts. Where M is drawn, rings may start.
bool without_ring_starts(const PaneFacts& f) {
  return std::ranges::all_of(f.pane.impacts, [&](const Impact& i) {
    const bool is_known = i.circular_count || i.radial_count;
    return is_known && glass::drawn_counts(i, f.pane.growth, 0, Id("impact")).circular_count == 0;
  });
}
bool within_threshold(const PaneFacts& f) {
  return std::ranges::all_of(f.pane.impacts, [&](const Impact& i) {
    return i.circular_count || (i.radial_count && *i.radial_count <= f.pane.growth.circular_threshold);
  });
}
bool is_hit_by_default(const PaneFacts& f) {
  return f.all_impacts(
      [](const Impact& i) { return i.ball_diameter_mm == Impact{}.ball_diameter_mm && i.speed_m_s == Impact{}.speed_m_s; });
}
bool is_hit_once(const PaneFacts& f) { return f.pane.impacts.size() == 1; }
bool without_spread(const PaneFacts& f) { return f.pane.growth.spread_limit == 0.0; }

bool is_printed(const PaneFacts& f) { return f.pane.growth.law == glass::GrowthLaw::printed && !f.is_real(); }
bool looks_elsewhere(const PaneFacts& f) { return is_printed(f) && f.pane.growth.region != glass::LocalRegion::sector; }
bool is_fitted(const PaneFacts& f) { return f.pane.growth.law == glass::GrowthLaw::fitted; }

// Rows of the printed law, and rows of what it does not know.
GrowthRow of_printed(const GrowthRow& row) { return row.idle(on_real, beside_real).idle(is_fitted, without_printed); }
GrowthRow of_fitted(const GrowthRow& row) { return row.idle(is_printed, beside_printed); }

// Rows of what only ring cracks of the paper's pattern have.
GrowthRow of_rings(const GrowthRow& row) {
  return row.idle(on_real, beside_real).idle(without_ring_starts, without_ring_cracks);
}
// Rows of the law for their number.
GrowthRow of_ring_counts(const GrowthRow& row) {
  return row.idle(on_real, beside_real).idle(with_ring_counts, beside_ring_counts);
}
GrowthRow of_large_counts(const GrowthRow& row) { return row.idle(with_large_counts, beside_large_counts); }

}  // namespace

const Section<Growth, PaneFacts> growth_keys{
    "pane[].growth",
    {
        GrowthRow::choice("law", &Growth::law, growth_law_words,
                          "how cracks grow: fitted to the paper's measured panes, or by the letter of its equations")
            .idle(on_real, beside_real),
        of_printed(GrowthRow::number("time_step", &Growth::time_step, {0.01, 100.0},
                                     "dt of the printed law: all tips go on at once for so long, and turn once")),
        of_printed(GrowthRow::choice("region", &Growth::region, local_region_words,
                                     "what a tip looks into by the printed law: a fan or a rectangle before it, or a circle "
                                     "about it")),
        of_printed(GrowthRow::number("rectangle_length_px", &Growth::rectangle_length, {1.0, 1000.0},
                                     "how far that rectangle reaches ahead"))
            .idle([](const PaneFacts& f) { return f.pane.growth.region != glass::LocalRegion::rectangle; }, without_rectangle),
        of_printed(GrowthRow::number("rectangle_width_px", &Growth::rectangle_width, {1.0, 1000.0}, "how wide it is"))
            .idle([](const PaneFacts& f) { return f.pane.growth.region != glass::LocalRegion::rectangle; }, without_rectangle),
        of_printed(GrowthRow::number("circle_radius_px", &Growth::circle_radius, {1.0, 1000.0}, "radius of that circle"))
            .idle([](const PaneFacts& f) { return f.pane.growth.region != glass::LocalRegion::circle; },
                  "without region = \"circle\""),
        GrowthRow::flag("enclosed_tips_stop", &Growth::enclosed_tips_stop, "tips stop where cracks close a region about them")
            .idle([](const PaneFacts& f) { return f.is_real() && f.pane.growth.branch_rate_per_m == 0.0; },
                  "on pattern = \"real\" without branch_rate_per_m"),
        GrowthRow::choice("spread", &Growth::spread, spread_words, "law by which speeds and radii vary")
            .idle(without_spread, beside_no_spread),
        GrowthRow::number("spread_limit", &Growth::spread_limit, {0.0, 1.0, false, true},
                          "speeds and radii stay within this fraction of their mean (z)"),
        GrowthRow::number("spread_deviation", &Growth::spread_deviation, {0.0, 10.0},
                          "standard deviation of the normal law, in units of that limit")
            .idle(without_spread, beside_no_spread)
            .idle([](const PaneFacts& f) { return f.pane.growth.spread == glass::Spread::uniform; },
                  "beside spread = \"uniform\""),
        GrowthRow::number("large_speed_px", &Growth::large_speed, {0.1, 1000.0},
                          "mean speed of large cracks, px a unit of time: faster ones are straighter"),
        GrowthRow::number("radial_speed_px", &Growth::radial_speed, {0.1, 1000.0}, "mean speed of the other radial cracks"),
        of_rings(GrowthRow::number("circular_speed_px", &Growth::circular_speed, {0.1, 1000.0}, "mean speed of ring cracks")),
        GrowthRow::angle("sector_angle_deg", &Growth::sector_angle, {1.0, 180.0}, "opening of the fan that a tip looks into")
            .idle(looks_elsewhere, beside_other_region),
        GrowthRow::number("sector_radius_px", &Growth::sector_radius, {1.0, 1000.0}, "radius of that fan")
            .idle(looks_elsewhere, beside_other_region),
        GrowthRow::angle("turn_limit_deg", &Growth::turn_limit, {0.0, 90.0}, "largest turn in a step"),
        GrowthRow::number("weight_time", &Growth::weight_time, {0.01, 1000.0},
                          "units of time after which a young crack turns freely"),
        of_fitted(GrowthRow::number("step_length_px", &Growth::step_length, {0.1, 100.0},
                                    "length of a step of growth: shorter ones are slower, and meet edges more squarely")),
        GrowthRow::number("reference_radial_count", &Growth::reference_radial_count, {1.0, 10000.0},
                          "mean of M for the ball and speed by default")
            .idle(with_counts_or_means, beside_counts),
        GrowthRow::number("energy_exponent", &Growth::energy_exponent, {0.0, 2.0},
                          "the mean of M goes with this power of the energy")
            .idle(with_counts_or_means, beside_counts)
            .idle(is_hit_by_default, "without another ball_diameter_mm or speed_m_s"),
        GrowthRow::choice("count_law", &Growth::count_dispersion, count_law_words,
                          "law by which M is drawn about its mean: as the paper draws it, or as spread as its nineteen real "
                          "panes are")
            .idle(with_counts, "beside radial_count or preset")
            .idle([](const PaneFacts& f) { return f.has("growth.count_dispersion"); }, "beside count_dispersion"),
        GrowthRow::number("count_dispersion", &Growth::count_dispersion, {1.0, 1000.0},
                          "the same as a number, which wins: variance of M over its mean. 1 is Poisson, 29.6 is `\"table1\"`, "
                          "between and beyond a negative binomial law. M is never below 1, which makes means far below the "
                          "dispersion come out larger")
            .idle(with_counts, "beside radial_count or preset"),
        of_ring_counts(GrowthRow::number("circular_threshold", &Growth::circular_threshold, {0.0, 10000.0},
                                         "up to this M no ring cracks start; above, R = slope M + offset")),
        of_ring_counts(GrowthRow::number("circular_slope", &Growth::circular_slope, {0.0, 1.0}, "slope of that R"))
            .idle(within_threshold, beside_few_radials),
        of_ring_counts(GrowthRow::number("circular_offset", &Growth::circular_offset, {-1000.0, 1000.0}, "offset of that R"))
            .idle(within_threshold, beside_few_radials),
        of_large_counts(GrowthRow::number("large_slope", &Growth::large_slope, {0.0, 1.0},
                                          "slope of the number of large cracks, N = slope M + offset")),
        of_large_counts(GrowthRow::number("large_offset", &Growth::large_offset, {-1000.0, 1000.0}, "offset of that N")),
        of_large_counts(GrowthRow::number("large_deviation", &Growth::large_deviation, {0.0, 1000.0},
                                          "standard deviation of N about that line")),
        of_large_counts(
            GrowthRow::choice("large_rounding", &Growth::large_rounding, rounding_words, "how N becomes a whole number")),
        of_rings(GrowthRow::number("ring_radius_slope_mm", &Growth::ring_radius_slope_mm, {0.0, 100.0},
                                   "slope of the mean radius of rings, slope M + offset")),
        of_rings(GrowthRow::number("ring_radius_offset_mm", &Growth::ring_radius_offset_mm, {0.0, 10000.0},
                                   "offset of that radius")),
        GrowthRow::number("tip_gain_px2", &Growth::tip_gain, {0.0, 1e6}, "how much growing tips push each other off"),
        // By the fitted law radials do not see those of their own impact (see crack_before of growth.cpp).
        GrowthRow::number("crack_gain_px2", &Growth::crack_gain, {0.0, 1e6}, "how much tips are pulled towards other cracks")
            .idle([](const PaneFacts& f) { return is_hit_once(f) && f.is_real(); },
                  "beside pattern = \"real\" and a single impact")
            .idle([](const PaneFacts& f) { return is_hit_once(f) && without_ring_starts(f) && !is_printed(f); },
                  "on the radial cracks of a single impact"),
        of_fitted(GrowthRow::number(
            "sibling_gain_px2", &Growth::sibling_gain, {-1e6, 1e6},
            "pull between radials of one impact; below 0 they push each other off, and more of them grow long")),
        GrowthRow::number("edge_gain_px2", &Growth::edge_gain, {0.0, 1e6}, "how much tips are pulled towards the edge"),
        GrowthRow::angle("wander_deg", &Growth::wander, {0.0, 90.0},
                         "crookedness: spread of the direction over 10 px, by the printed law in a step"),
        of_fitted(GrowthRow::number("turn_length_px", &Growth::turn_length, {0.1, 1000.0},
                                    "length over which a tip turns to where it is drawn: longer ones make lazier curves")),
        of_fitted(GrowthRow::number("radial_pull", &Growth::radial_pull, {0.0, 1000.0},
                                    "how firmly radials keep away from their impact: more makes them straighter")),
        of_rings(GrowthRow::number("ring_pull", &Growth::ring_pull, {0.0, 1000.0}, "how firmly rings keep to their circle")),
        of_rings(GrowthRow::number("ring_onset", &Growth::ring_onset, {0.0, 1000.0},
                                   "rings start when the large cracks are this many ring radii out"))
            .idle(is_printed, beside_printed),
        GrowthRow::number("radial_onset", &Growth::radial_onset, {0.0, 1000.0},
                          "radials but the large ones start up to so long after the impact, each its own: above 0 their "
                          "lengths vary"),
        of_fitted(GrowthRow::number("branch_rate_per_m", &Growth::branch_rate_per_m, {0.0, 1000.0},
                                    "branches that leave a metre of a large crack, or of a branch")),
        of_fitted(GrowthRow::limits("branch_angle_deg", &Growth::least_branch_angle, &Growth::greatest_branch_angle,
                                    {0.0, 90.0}, "angle between a branch and what it leaves"))
            .idle([](const PaneFacts& f) { return f.pane.growth.branch_rate_per_m == 0.0; }, "without branch_rate_per_m"),
    }};

}  // namespace shatterpave::scene
