#include "measure/pane_figures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/polygon.h"
#include "glass/shards/shard_faces.h"
#include "measure/pane_measures.h"
#include "measure/pattern_measures.h"
#include "measure/tracking.h"

namespace shatterpave::measure {

namespace {

using glass::Crack;
using glass::CrackKind;

constexpr std::size_t least_pairs = 10;

void add_turns(const glass::CrackNetwork& network, PaneFigures& figures) {
  double products = 0.0;
  double squares = 0.0;
  std::size_t pairs = 0;
  double length_mm = 0.0;
  int branches = 0;
  for (const Crack& crack : network.cracks) {
    if (crack.impact != 0) continue;
    branches += crack.kind == CrackKind::branch ? 1 : 0;
    const bool leaves = crack.kind == CrackKind::large || crack.kind == CrackKind::radial;
    if (!leaves || crack.end.at != glass::CrackEnd::At::edge) continue;
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i)
      length_mm += glm::length(crack.points_mm[i] - crack.points_mm[i - 1]);
    const std::vector<Angle> angles = turns(tracked(crack.points_mm));
    for (std::size_t i = 0; i < angles.size(); ++i) {
      figures.turn_deg.add(angles[i].degrees());
      squares += angles[i].degrees() * angles[i].degrees();
      if (i == 0) continue;
      products += angles[i].degrees() * angles[i - 1].degrees();
      ++pairs;
    }
  }
  if (pairs >= least_pairs && squares > 0.0) {
    const double mean_square = squares / static_cast<double>(figures.turn_deg.count());
    figures.turn_correlation = products / static_cast<double>(pairs) / mean_square;
  }
  if (length_mm > 0.0) figures.branches_per_m = 1000.0 * branches / length_mm;
}

void add_rings(const glass::CrackNetwork& network, PaneFigures& figures) {
  std::set<std::pair<double, double>> starts;
  for (const Crack& crack : network.cracks) {
    if (crack.impact != 0 || crack.kind != CrackKind::circular) continue;
    const bool second_arm = !starts.insert({crack.points_mm.front().x, crack.points_mm.front().y}).second;
    figures.ring_count += second_arm ? 0 : 1;
    for (const vec2 p : tracked(crack.points_mm)) figures.ring_mm.add(glm::length(p - network.impacts.front().at_mm));
  }
}

std::optional<double> gap_variation_of(const glass::CrackNetwork& network, const glass::Pane& pane) {
  const double radius = 0.2 * std::sqrt(std::abs(geometry::area(pane.outline_mm)));
  std::vector<Angle> directions = radial_directions(network, 0, radius);
  if (directions.size() < 3) return std::nullopt;
  return gap_variation(std::move(directions));
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void add_pieces(const glass::CrackNetwork& network, const glass::Pane& pane, PaneFigures& figures) {
  constexpr double least_shaped_mm2 = 10.0;
  std::vector<double> areas;
  std::vector<double> elongations;
  for (const PieceMeasures& piece : pattern_measures(network, pane).pieces) {
    figures.piece_mm2.add(piece.area_mm2);
    areas.push_back(piece.area_mm2);
    if (!piece.at_edge && piece.area_mm2 >= least_shaped_mm2) elongations.push_back(piece.elongation);
  }
  figures.median_piece_mm2 = median_of(std::move(areas));
  figures.median_elongation = median_of(std::move(elongations));
}

}  // namespace

PaneFigures pane_figures(const glass::CrackNetwork& network, const glass::Pane& pane) {
  PaneFigures figures;
  figures.radial_count = network.impacts.front().radial_count;
  for (const Crack& crack : network.cracks) {
    const bool leaves = crack.kind == CrackKind::large || crack.kind == CrackKind::radial;
    if (crack.impact == 0 && leaves && crack.end.at == glass::CrackEnd::At::edge) ++figures.reaching_count;
  }
  add_rings(network, figures);
  add_turns(network, figures);
  figures.gap_variation = gap_variation_of(network, pane);
  add_pieces(network, pane, figures);
  return figures;
}

std::vector<double> pieces_per_square(const glass::CrackNetwork& network, const glass::Pane& pane) {
  constexpr double side_mm = 50.0;
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const auto columns = static_cast<std::size_t>((box.high.x - box.low.x) / side_mm);
  const auto rows = static_cast<std::size_t>((box.high.y - box.low.y) / side_mm);
  std::vector<double> counts(columns * rows, 0.0);
  const glass::FacedPane faced = glass::faced_pane(pane, network);
  for (const glass::ShardFace& face : faced.faces) {
    const geometry::Region region = glass::region(face.face);
    if (geometry::area(region) < least_piece_mm2) continue;
    // Squares that the piece's own vertices lie in: pieces are smaller than squares, or reach into all that they cover.
    std::set<std::size_t> squares;
    bool outside = false;
    for (const vec2 p : region.outline) {
      const vec2 at = (p - box.low) / side_mm;
      if (at.x < 0.0 || at.y < 0.0 || at.x >= static_cast<double>(columns) || at.y >= static_cast<double>(rows)) {
        outside = true;
      } else {
        squares.insert(static_cast<std::size_t>(at.y) * columns + static_cast<std::size_t>(at.x));
      }
    }
    const double share = squares.size() == 1 && !outside ? 1.0 : 0.5;
    for (const std::size_t square : squares) counts[square] += share;
  }
  return counts;
}

std::array<double, figure_count> numbers_of(const PaneFigures& f) {
  return {static_cast<double>(f.radial_count),
          static_cast<double>(f.reaching_count),
          static_cast<double>(f.ring_count),
          f.ring_mm.mean(),
          f.ring_mm.deviation(),
          f.turn_deg.deviation(),
          f.turn_correlation,
          f.gap_variation.value_or(0.0),
          f.branches_per_m};
}

}  // namespace shatterpave::measure
