#include "geometry/delaunay.h"

#include <boost/polygon/voronoi.hpp>

#include "core/error.h"
#include "geometry/lattice.h"

namespace shatterpave::geometry {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Site = boost::polygon::point_data<std::int32_t>;

// Calls `visit(neighbour, face)` for each spoke of the cell, counter-clockwise. A Voronoi vertex is a Delaunay face.
template <typename Visit>
void for_each_spoke(const Diagram& diagram, const Diagram::cell_type& cell, Visit visit) {
  const Diagram::edge_type* edge = cell.incident_edge();
  if (edge == nullptr) return;
  do {
    const auto neighbour = static_cast<std::uint32_t>(edge->twin()->cell()->source_index());
    const Diagram::vertex_type* end = edge->vertex1();
    visit(neighbour, end == nullptr ? Delaunay::none : static_cast<std::uint32_t>(end - diagram.vertices().data()));
    edge = edge->next();
  } while (edge != cell.incident_edge());
}

}  // namespace

Delaunay delaunay(std::span<const vec2> points) {
  std::vector<Site> sites;
  sites.reserve(points.size());
  for (const vec2& p : points) {
    const LatticePoint site = to_lattice(p);
    sites.emplace_back(static_cast<std::int32_t>(site.x), static_cast<std::int32_t>(site.y));
  }
  Diagram diagram;
  boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  ENSURE(diagram.num_cells() == points.size());

  Delaunay result;
  result.face_count = diagram.num_vertices();
  result.first.assign(points.size() + 1, 0);
  for (const Diagram::cell_type& cell : diagram.cells()) {
    for_each_spoke(diagram, cell, [&](std::uint32_t, std::uint32_t) { ++result.first[cell.source_index() + 1]; });
  }
  for (std::size_t i = 0; i < points.size(); ++i) result.first[i + 1] += result.first[i];
  result.spokes.resize(result.first.back());
  for (const Diagram::cell_type& cell : diagram.cells()) {
    std::size_t at = result.first[cell.source_index()];
    for_each_spoke(diagram, cell, [&](std::uint32_t neighbour, std::uint32_t face) {
      result.spokes[at++] = {neighbour, face};
    });
  }
  return result;
}

}  // namespace shatterpave::geometry
