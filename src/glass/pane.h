// What a scene may say of a pane of glass and of what hits it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/angle.h"
#include "geometry/bend.h"
#include "geometry/polygon.h"
#include "glass/network.h"
#include "studio/world.h"

namespace shatterpave::glass {

// The law by which Rand of eq. 8 to 11 draws within [(1 - z) x, (1 + z) x].
enum class Spread { normal, uniform };

// How the bracket of eq. 6 makes a whole number. The printed counts of Figs. 14 and 15 follow from rounding up; of Fig. 16, a
// and d do too, b and c follow from rounding down.
enum class Rounding { down, nearest, up };

// How tips go on.
enum class GrowthLaw {
  fitted,   // as the paper's, but for what was changed so that panes measure as its real ones do (growth/growth.cpp)
  printed,  // by the letter of the paper (growth/printed_law.h)
};

// The local region into which a tip looks (§4.2.2). The paper tried all three, and took the sector.
enum class LocalRegion { sector, rectangle, circle };

// A pixel of the paper's photographs and its lattice: 640 px for a pane of 300 mm (§3.1.2), and as long on a pane of any size.
inline constexpr double px_mm = 300.0 / 640.0;

// The growth model of Agui et al. 1992, §4.2. Lengths are in px of the paper's lattice, one px being 300/640 mm on a pane
// of any size; one unit of time is the paper's dt = 1. Defaults are the paper's where it prints them. The rest was chosen by
// measuring generated panes against the paper's measured ones (§3.1.3, Table 1), as noted beside each.
//
// Figures stand for 100 panes of M = 24 … 195 (300 × 300 mm, seeds 100 …), by the defaults but for what is named; "square ends"
// are the cracks that meet the edge at 75° and more, "merged" the share of radials that end on a radial of their impact.
struct Growth {
  Spread spread = Spread::normal;
  double spread_limit = 0.3;            // z of Rand (§4.3), in [0, 1)
  double spread_deviation = 1.0 / 3.0;  // standard deviation of the normal law before its limits cut it, in units of z x; not
                                        // printed. So the limits are three deviations, and mean radii of rings scatter by 3.0
                                        // mm about eq. 7; 1/2 makes it 3.9 mm, and Table 1 has 1.8 mm
  double large_speed = 40.0;            // V1_ave, px per unit of time (eq. 9). Turns of large cracks have a deviation of 3.8°
                                        // at 30, 3.2° at 40, 2.4° at 60: faster ones are straighter, as §4.3 says
  double radial_speed = 10.0;           // V2_ave (eq. 10)
  double circular_speed = 10.0;         // V3_ave (eq. 11)
  Angle sector_angle = Angle::degrees(100.0);  // phi, the whole opening (§4.3), up to 180°
  double sector_radius = 50.0;                 // B, px (§4.3)
  Angle turn_limit = Angle::degrees(30.0);     // theta_th (eq. 18)
  double weight_time = 10.0;                   // T (eq. 19)
  double step_length = 8.0;   // px that a tip goes on at a time, whatever its speed. The paper steps in time, so that a large
                              // crack sees the edge for one step of 40 px only before it is there. Square ends: 99 % at 4 and
                              // 8, 82 % at 16; the time it takes goes with the number of steps
  double turn_length = 10.0;  // px of growth for which eq. 15 turns a tip once. In the paper that is a step, 10 px for
                              // slow cracks and 40 for large ones; so curves depend on neither steps nor speeds. At 40 square
                              // ends fall to 46 %

  // Counts (eq. 3, 5, 6).
  double reference_radial_count = 95.7;  // M_ave where a scene gives none: mean of Table 1, for the ball and speed of §3.1.1
  double energy_exponent = 0.25;     // M_ave goes with this power of the ball's energy: 1/4 is the square root of the speed of
                                     // Vandenberghe, Vermorel, Villermaux, PRL 110, 174302 (2013); others say 1
  double count_dispersion = 1.0;     // variance / mean of M: 1 is Poisson (eq. 5), above it negative binomial; Table 1: 29.6
  double circular_threshold = 70.0;  // A of eq. 3
  double circular_slope = 0.05;      // a of eq. 3, not printed: with b it gives the twelve printed R
  double circular_offset = 0.5;      // b of eq. 3, not printed: 0.40 … 0.54 give them all
  double large_slope = 0.0606;       // e of eq. 6 (eq. 1 misprints it)
  double large_offset = 3.293;       // f of eq. 6
  double large_deviation = 1.1;      // standard deviation of N about eq. 6, which knows of none: the cracks that reach the edge
                                     // then scatter by 1.1 about their line, as those of Table 1 do by 1.14; at 0 they scatter
                                     // by 0.3, from rounding
  Rounding large_rounding = Rounding::nearest;  // of eq. 6: between the two that the paper's figures show
  double ring_radius_slope_mm = 0.470;          // g of eq. 7
  double ring_radius_offset_mm = 13.90;         // h of eq. 7

  // Forces, of which the paper prints the form only. They are in units of F3, whose magnitude is 1; gains of those that fall
  // with the square of the distance are in px², and each force equals F3 at a distance of sqrt(gain) px.
  double tip_gain = 40.0;     // F1: growing tips push one another off. Radials nearer to the next than a quarter of the mean,
                              // 10 mm beyond the ring: 9 % at 0, 7 % at 40
  double crack_gain = 60.0;   // F2, cracks: more makes tips turn earlier towards a crack they are about to meet. No statistic
                              // shows it: ends of ring cracks at right angles do, by eye
  double sibling_gain = 0.0;  // F2 between radials of one impact; below 0 they push off. Merged are 64 % at 0, but 97 % at
                              // that of other cracks: slow radials bend onto their neighbours and bundle, which real panes do
                              // not show. At -20 they are 40 %, for half as much time again
  double edge_gain = 500.0;   // F2, edge of the pane: more makes cracks meet it more squarely, from farther off. Square ends:
                              // 37 % at 0, 65 % at 125, 99 % at 500
  Angle wander = Angle::degrees(14.0);  // F3: standard deviation of its direction over 10 px of growth, the step by which the
                                        // paper measures turns: their deviation is 1.9° at 7, 3.1° at 14, 5.1° at 28. The range
                                        // of Fig. 5 would follow from more, less what tracking by whole pixels adds; but large
                                        // panes then look like rivers rather than glass
  double radial_pull = 0.4;   // pull of radials away from their impact, in units of F3. The wander of F3 alone forgets its
                              // direction within about a metre, and cracks of large panes would curl. Turns deviate by 4.1° at
                              // 0, where 1.2 % of the large cracks end on others; by 2.6° at 0.8, where square ends are 97 %
  double ring_pull = 0.6;     // rule 5: pull back to the circle of a ring crack; more makes rings rounder. Mean radii stay the
                              // same from 0.15 to 2.4
  double radial_onset = 0.0;  // radials but the large ones start up to so long after the impact, each its own, in units of
                              // time: above 0 their lengths vary. In the paper all start at once
  // Branches of large cracks, of which the paper has none. An angle of 30 to 45° between the two is that of fast cracks: Quinn,
  // "Fractography of Ceramics and Glasses", NIST SP 960-16e2.
  double branch_rate_per_m = 0.0;  // how many leave a metre of a large crack, or of a branch
  Angle least_branch_angle = Angle::degrees(30.0);
  Angle greatest_branch_angle = Angle::degrees(45.0);
  double ring_onset = 1.25;  // a ring crack starts once every large crack of its impact has stopped, or is this many ring
                             // radii out. At 0 rings cut off 42 % of the large cracks, and N no longer goes with M. In real
                             // panes radials run first, and rings follow as the freed strips bend

  bool enclosed_tips_stop = true;  // the second stop rule (§4.2.3): where cracks close a region, tips in it stop

  // The law, and what only the printed one has. Of the other two regions the paper tells no sizes: they reach as far as its
  // sector, and the rectangle is as wide as that is, 2 · 50 px · sin(50°).
  GrowthLaw law = GrowthLaw::fitted;
  double time_step = 1.0;  // dt of eq. 16 and 17, in which a tip turns once
  LocalRegion region = LocalRegion::sector;
  double rectangle_length = 50.0;  // px ahead of the tip
  double rectangle_width = 77.0;   // px
  double circle_radius = 50.0;     // px about the tip

  // The clock of growth: the mean large crack runs at this speed, all others in the proportion that the model gives them. The
  // default is about the limiting speed of cracks in soda-lime glass: Schardin, "Velocity effects in fracture", in Averbach et
  // al., "Fracture" (1959).
  double crack_speed_m_s = 1500.0;

  bool operator==(const Growth&) const = default;
};

// Where something hits the pane, and how hard. Of the counts, those that are given win; the others follow from M. Ball and
// speed count only where neither radial_count nor mean_radial_count is given.
struct Impact {
  vec2 at_mm{0.0, 0.0};                     // strictly inside the outline
  std::optional<double> mean_radial_count;  // M_ave of eq. 5, 1 … 10,000
  std::optional<int> radial_count;          // M, 1 … 10,000
  std::optional<int> large_count;           // N, 0 … M
  std::optional<int> circular_count;        // R, 0 … 1,000
  double ball_diameter_mm = 25.0;           // §3.1.1
  double speed_m_s = 6.26;                  // a fall from 2 m (§3.1.1)
  double hole_mm = 0.0;                     // diameter of the hole on the viewer's side; 0: what hit did not go through
  std::optional<double> spall_mm;           // and on the far side: hole_mm + 4.5 thicknesses, a cone of 66° to either side
  double time_us = 0.0;                     // when it comes, >= 0, and not before the impact before it

  bool operator==(const Impact&) const = default;
};

// Where ring cracks of annealed and of laminated glass come from.
enum class Pattern {
  agui1992,  // a few starting points at about one distance, as Growth says
  real,      // rings of pieces from one radial to the next, as Rings says; starting points of Growth are left out
};

// Ring cracks as in real panes: "mostly straight or slightly bowed segments between radials", on which they end, and which do
// not meet those of the next sector (SWGMAT, "Glass Fractures", 2005). By eye where no source is named.
struct Rings {
  int count = 5;                          // 0 … 100
  std::optional<double> first_radius_mm;  // else from the size of the pane (see ring_radii)
  double ratio = 2.0;                     // of the radius of a ring to that of the one before, > 1: denser towards the impact
  double spread = 0.3;                    // a piece is off its ring by up to this share of the way to the next ring
  double interruption = 0.25;             // part of the sectors that a ring leaves out
  double bow = 0.25;                      // 0: pieces are straight; 1: they follow the circle. Wide sectors have more

  bool operator==(const Rings&) const = default;
};

// Rings of laminated glass: what holds together goes on to break, so there are more, and fewer gaps. By eye.
inline constexpr Rings laminated_rings{12, 7.0, 1.28, 0.4, 0.12, 0.15};

// The kinds of glass: how each is made, and so how it breaks.

// Window glass.
struct Annealed {
  static constexpr std::string_view name = "annealed";

  bool operator==(const Annealed&) const = default;
};

// Two sheets that a film holds together. The film stops cracks, so each sheet breaks by itself, and what is seen of the two
// crosses (glass/sheets.h). By eye but for the film.
struct Laminated {
  static constexpr std::string_view name = "laminated";

  double far_cracks = 0.6;        // of a pane without shards: radials and rings of the sheet away from the impact, as a part of
                                  // those of the sheet that is hit, 0 … 1
  std::optional<double> film_mm;  // how thick the film is; else that of windscreens (see sheet_of)
  double through = 0.35;          // of a pane with shards: part of the cracks that run through both sheets, and so part pieces
  double milky_width_mm = 12.0;   // of the white rim about the crushed zone

  bool operator==(const Laminated&) const = default;
};

// Tempered by heat: the whole pane falls to dice. The fragments of a square of 50 × 50 mm are those that EN 12150-1 counts.
struct Tempered {
  static constexpr std::string_view name = "tempered";

  // Of the surface: EN 12150 glass has 90 MPa and more. The length of cracks that its energy pays for goes with the square of
  // the stress, so the number of fragments goes with its fourth power, as Barsom (J. Am. Ceram. Soc. 51, 1968) measured.
  double surface_stress_mpa = 100.0;
  std::optional<double> count_per_square;  // 1 … 2500; else from the stress and the thickness (see fragment_count)
  std::optional<double> splinter_ratio;    // length to width of fragments near the impact, 1 … 20; else from the thickness
  double splinter_reach_mm = 80.0;         // how far they go: what EN 12150 leaves out about the impact

  bool operator==(const Tempered&) const = default;
};

using Glass = std::variant<Annealed, Laminated, Tempered>;

// What becomes of the pieces between the cracks. Defaults without a source were chosen by eye, see scenes/broken_window.toml.
struct ShardRules {
  bool joined = false;        // pieces that stand side by side are one body, without a gap between them
  bool leaning = false;       // walls lean, twist and bow by tilt, curve and twist_mm of crack_sheet (see lean.h); else upright
  double gap_mm = 0.06;       // opening of cracks between pieces, face to face
  double splinter_mm2 = 4.0;  // pieces with a smaller face are dust
  double bevel_mm = 0.12;     // width and depth of the bevel along broken edges; 0: none
  double chips_per_m = 90.0;  // flakes off broken edges, on each side of the pane
  double chip_mm = 1.6;       // half the length of the largest of them along the edge
  double missing = 0.95;      // of the glass near an impact, the part that leaves the pane: there is one hole, as large as if
                              // every place were gone with this probability, which falls to 1/e at
  std::optional<double> missing_mm;  // this distance, as exp(−x⁴); else from energy and size (see hole_outline.h)
  double held = 0.2;       // a piece that stands has at least this part of its border along the frame and pieces that stand;
                           // in a frame that grips it along a tenth of its border it stands always
  double fallen = 0.6;     // part of the pieces that left the pane that come to lie on sill or floor; others are gone
  double throw_m_s = 0.7;  // with which pieces at an impact leave the pane towards +z
  double sill_drop_mm = 25.0;    // top of the sill below the lowest point of the pane
  double sill_depth_mm = 150.0;  // how far it reaches out, from the middle plane of the pane
  double frame_mm = 18.0;        // how far the frame stands out from that plane
  double reveal_mm = 30.0;       // from the sides of the pane's box to the walls beside it
  double floor_drop_mm = 850.0;  // floor below the lowest point of the pane
  std::optional<double> time_s;  // how long ago the pieces were let go, >= 0; nothing: all have come to rest

  bool operator==(const ShardRules&) const = default;
};

// What a crack is made of for renderers: a thin tube in the middle of the glass, or a gap of air through its thickness.
enum class CrackBody { cylinder, sheet };

// The shape of gaps (see crack_surface.h). Walls of real cracks are never quite upright: where they lean, they mirror what lies
// aside, which is why cracks flash. All by eye, from photographs of broken panes.
struct CrackSheet {
  Angle tilt = Angle::degrees(32.0);   // how far walls lean from upright at the most, to either side; below 80°
  Angle curve = Angle::degrees(14.0);  // by how much they lean otherwise at the faces of the pane than in its middle
  double twist_mm = 18.0;              // length along the crack over which the lean changes to another one
  double opening_mm = 0.05;            // mean width of the gap at the face on which it opens
  double opening_variation = 0.6;      // by which share of that it varies along the crack
  double least_depth = 0.6;            // cracks that stop within the glass reach this share of the thickness …
  double greatest_depth = 1.0;         // … to that one, each its own; all others run through
  double relief = 1.0;                 // how rough the walls are: 0 is polished

  bool operator==(const CrackSheet&) const = default;
};

struct Pane {
  std::string name;               // unique in its scene, an identifier: letters, digits, '_' and '-'
  geometry::Polygon outline_mm;   // simple, counter-clockwise, on the lattice
  double thickness_mm = 2.0;      // > 0
  std::vector<Impact> impacts;    // in the order in which they happened
  std::optional<double> time_us;  // until when cracks have grown, >= 0; nothing: until all have stopped
  Growth growth;
  Glass glass;
  Pattern pattern = Pattern::agui1992;
  Rings rings;                               // of Pattern::real
  Angle crater_cone = Angle::degrees(68.0);  // of spall, from upright: that of Hertz's cone crack in glass; of Pattern::real
  std::optional<ShardRules> shards;          // nothing: cracks only
  CrackBody crack_body = CrackBody::cylinder;
  CrackSheet crack_sheet;
  studio::Placement placement;
  // Cracks that came from elsewhere, traced or drawn, instead of growth: a network as `broken` promises it, for this outline.
  std::optional<CrackNetwork> given_cracks;
  double dirt = 0.0;      // on its faces, for pictures: 0 as it came from the works, 1 as if it had never been cleaned
  vec2 bow_mm{0.0, 0.0};  // sagittas across and along its box, within most_bow of its sides: see bend_of

  bool operator==(const Pane&) const = default;
};

// The most that a pane is bowed: by its side, in mm, and so that half its thickness is this part of its radius at the most. A
// windscreen is bowed by 3 to 8 % of its width (by eye); more than 300 mm would take millions of triangles.
inline constexpr double most_bow = 0.1;
inline constexpr double most_bow_mm = 300.0;
inline constexpr double most_bend_of_thickness = 0.25;

// How the pane is bent: all that is made of it is made flat, and bent where it leaves for renderers. Above 0 the middle comes
// towards the side that is hit; the corners of its bounding box stay where they are.
inline geometry::Bend bend_of(const Pane& pane) {
  if (pane.bow_mm == vec2{0.0, 0.0}) return {};
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  return {0.5 * (box.low + box.high), 0.5 * (box.high - box.low), pane.bow_mm};
}

}  // namespace shatterpave::glass
