#include "trace/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/functions.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "glass/map/proper_network.h"
#include "trace/cracks.h"
#include "trace/impact.h"
#include "trace/line_graph.h"
#include "trace/skeleton.h"
#include "trace/two_point.h"

namespace shatterpave::trace {

namespace {

constexpr double paper_side_mm = 300.0;
constexpr double paper_side_px = 640.0;
constexpr double paper_step_px = 10.0;  // a of §3.1.2
// Larger pictures are made smaller: lines of photographs of that size are several pixels wide.
constexpr int longest_side_px = 2800;

// Shares of the longer side of the picture, but for small ones; by eye, on rendered panes and on photographs.
struct Lengths {
  double spur_px, crumb_px, gap_px, landing_px, double_px, edge_px;
};

Lengths lengths_of(const Grey& picture) {
  const double side = std::max(picture.width, picture.height);
  return {std::max(6.0, 0.006 * side), std::max(12.0, 0.015 * side), std::max(16.0, 0.03 * side),
          std::max(5.0, 0.006 * side), std::max(4.0, 0.006 * side),  std::max(5.0, 0.01 * side)};
}

void require_area(const Corners& corners) {
  double least = 1e300;
  for (std::size_t i = 0; i < 4; ++i) {
    const vec2 one = corners[(i + 1) % 4] - corners[i];
    const vec2 two = corners[(i + 2) % 4] - corners[(i + 1) % 4];
    least = std::min(least, cross(one, two));
  }
  if (least > 0.0) return;
  throw InputError("expected corners of a pane in the order upper left, upper right, lower right, lower left, got others");
}

Corners corners_of(const Grey& photograph, const Options& options) {
  const double width = photograph.width;
  const double height = photograph.height;
  if (!options.corners_px) return {vec2{0.0, 0.0}, vec2{width, 0.0}, vec2{width, height}, vec2{0.0, height}};
  require_area(*options.corners_px);
  return *options.corners_px;
}

// The size of the pane: as given, or from the scale, or as if its longer side were the paper's.
vec2 size_of(const Corners& corners, const Options& options, bool& assumed) {
  if (options.pane_mm) return *options.pane_mm;
  const vec2 size_px{0.5 * (glm::length(corners[1] - corners[0]) + glm::length(corners[2] - corners[3])),
                     0.5 * (glm::length(corners[3] - corners[0]) + glm::length(corners[2] - corners[1]))};
  if (options.mm_per_px) return *options.mm_per_px * size_px;
  assumed = true;
  return paper_side_mm / std::max(size_px.x, size_px.y) * size_px;
}

LineGraph graph_of(const Mask& mask, const Lengths& lengths, Chain chain) {
  LineGraph graph(skeleton(mask));
  graph.join_passed_nodes();
  take_off_spurs(graph, lengths.spur_px);
  if (chain == Chain::paper) return graph;
  take_off_crumbs(graph, lengths.spur_px);
  join_double_lines(graph, lengths.double_px);
  bridge_gaps(graph, lengths.gap_px, 25.0, lengths.landing_px);
  join_double_lines(graph, lengths.double_px);
  take_off_spurs(graph, lengths.spur_px);
  take_off_crumbs(graph, lengths.crumb_px);
  return graph;
}

double total_length(const LineGraph& graph) {
  double sum = 0.0;
  for (const GraphEdge& edge : graph.edges()) sum += edge.alive ? edge.length() : 0.0;
  return sum;
}

// The point of the picture seen straight whose place in the photograph is `wanted`: the inverse map's.
vec2 seen_at(const Corners& corners, const Grey& picture, vec2 wanted) {
  // A perspective of the plane is undone by the one that takes the corners back: found by Newton's way from the middle.
  const Perspective map = perspective_to(corners, picture.width, picture.height);
  vec2 at{0.5 * picture.width, 0.5 * picture.height};
  for (int i = 0; i < 30; ++i) {
    const vec2 here = map(at);
    const vec2 along_x = map(at + vec2{0.5, 0.0}) - map(at - vec2{0.5, 0.0});
    const vec2 along_y = map(at + vec2{0.0, 0.5}) - map(at - vec2{0.0, 0.5});
    const double determinant = cross(along_x, along_y);
    if (determinant == 0.0) break;
    const vec2 off = wanted - here;
    at += vec2{cross(off, along_y), cross(along_x, off)} / determinant;
  }
  return at;
}

vec2 impact_in(const Sight& sight, const Corners& corners, const LineGraph& graph, const Options& options) {
  const Grey& picture = sight.picture;
  const std::vector<Chord> chords = chords_of(graph, 12.0);
  if (options.impact_px) {
    const vec2 at = seen_at(corners, picture, *options.impact_px);
    if (at.x > 0.0 && at.y > 0.0 && at.x < picture.width && at.y < picture.height) return at;
    throw InputError(
        fmt::format("expected an impact within the pane, got ({}, {}) px", options.impact_px->x, options.impact_px->y));
  }
  if (const auto found = impact_of(chords, picture.width, picture.height)) return *found;
  throw InputError(
      "expected cracks that leave an impact, got lines that do not meet in one place (give it with --impact X,Y where there is "
      "one)");
}

std::vector<glass::DrawnCrack> drawn_on_pane(std::vector<glass::DrawnCrack> cracks, vec2 pane_mm, double mm_per_px) {
  for (glass::DrawnCrack& crack : cracks) {
    for (vec2& p : crack.points_mm) p = {p.x * mm_per_px, pane_mm.y - p.y * mm_per_px};
  }
  return cracks;
}

void count_cracks(Trace& trace) {
  glass::count_again(trace.network, 0);
  const int count = trace.network.impacts.front().radial_count;
  trace.radial_interval[1] = std::max(trace.radial_interval[1], count);
}

}  // namespace

Trace traced(const Grey& photograph, const Options& options) {
  const Corners corners = corners_of(photograph, options);
  Trace trace;
  trace.corners_px = corners;
  trace.pane_mm = size_of(corners, options, trace.size_was_assumed);
  const Sight sight = seen_straight(photograph, corners, trace.pane_mm, longest_side_px);
  const Grey& picture = sight.picture;
  trace.mm_per_px = sight.mm_per_px;
  trace.to_photograph = sight.to_photograph;
  trace.pane_mm = sight.mm_per_px * vec2{picture.width, picture.height};
  const Mask mask =
      options.chain == Chain::paper
          ? threshold_mask(picture, options.threshold)
          : line_mask(picture, options.polarity, 2 * (static_cast<int>(std::max(picture.width, picture.height)) / 160) + 1);
  const Lengths lengths = lengths_of(picture);
  const LineGraph graph = graph_of(mask, lengths, options.chain);
  const double side = std::max(picture.width, picture.height);
  if (const double total = total_length(graph); total < 0.5 * side) {
    throw InputError(fmt::format("expected lines of half the picture's length at least, got {:.0f} px of them", total));
  }
  const vec2 impact = impact_in(sight, corners, graph, options);
  const double merged = merged_radius(mask, impact);
  const RadialCount count = radial_count(picture, options.polarity, impact, merged);
  trace.impact_px = sight.to_photograph(impact);
  trace.radial_interval = count.interval;
  trace.count_radius_mm = count.radius_px * sight.mm_per_px;
  // Beyond that, lines are few near the impact because they branch, as in tempered glass.
  const double hub = std::max({4.0, merged + 1.0, std::min(count.start_px, 0.035 * side)});
  const CrackRules rules{impact, hub, std::max(1.5 * hub, std::min(0.2 * side, 8.0 * count.count / (2.0 * pi))),
                         std::max(8.0, 0.01 * side), lengths.edge_px};
  const double step = options.chain == Chain::paper ? paper_step_px * side / paper_side_px : 3.0;
  const auto features = [&](const std::vector<vec2>& line) {
    return feature_points(mask, line, step, 1.5 * lengths.double_px);
  };
  glass::ImpactCounts counts;
  counts.at_mm = geometry::on_lattice(vec2{impact.x, picture.height - impact.y} * sight.mm_per_px);
  counts.radial_count = count.count;
  const vec2 size = geometry::on_lattice(trace.pane_mm);
  const geometry::Polygon outline = {{0.0, 0.0}, {size.x, 0.0}, size, {0.0, size.y}};
  const auto drawn =
      drawn_on_pane(cracks_of(graph, rules, features, picture.width, picture.height), trace.pane_mm, sight.mm_per_px);
  trace.pane_mm = size;
  trace.network = glass::proper_network(drawn, outline, {counts}, 1.5 * sight.mm_per_px);
  count_cracks(trace);
  return trace;
}

}  // namespace shatterpave::trace
