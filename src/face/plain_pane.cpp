#include "face/plain_pane.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/error.h"
#include "export/shapes/glass_meshes.h"
#include "face/plain.h"
#include "geometry/bend.h"

namespace shatterpave::face {

namespace {

CrackEnd plain(const glass::CrackEnd& end) { return {face::plain(end.at), end.crack}; }

Impact plain(const glass::ImpactCounts& counts) {
  Impact impact{face::plain(counts.at_mm), counts.radial_count, counts.large_count, counts.circular_count, {}};
  if (const auto& crater = counts.crater) {
    impact.crater = Crater{crater->crushed_radius_mm, crater->near_radius_mm, crater->far_radius_mm, crater->milky_radius_mm};
  }
  return impact;
}

Crack plain(const glass::Crack& crack) {
  return {crack.id,         crack.impact, face::plain(crack.kind), face::plain(crack.points_mm), plain(crack.start),
          plain(crack.end), crack.through};
}

Shard plain(const glass::Shard& shard) {
  Shard result{shard.id, shard.joined, face::plain(shard.face), face::plain(shard.state), {}};
  for (std::size_t i = 0; i < 3; ++i) result.transform.rows[i] = face::plain(shard.motion.rows[i]);
  result.transform.shift_mm = face::plain(shard.motion.shift_mm);
  return result;
}

}  // namespace

CrackKind plain(glass::CrackKind kind) {
  switch (kind) {
    case glass::CrackKind::large:
      return CrackKind::large;
    case glass::CrackKind::radial:
      return CrackKind::radial;
    case glass::CrackKind::circular:
      return CrackKind::circular;
    case glass::CrackKind::branch:
      return CrackKind::branch;
    case glass::CrackKind::dice:
      return CrackKind::dice;
    case glass::CrackKind::rung:
      return CrackKind::rung;
    case glass::CrackKind::chip:
      return CrackKind::chip;
  }
  throw_broken_invariant("a kind of crack", __FILE_NAME__, __LINE__);
}

CrackEnd::At plain(glass::CrackEnd::At at) {
  switch (at) {
    case glass::CrackEnd::At::impact:
      return CrackEnd::At::impact;
    case glass::CrackEnd::At::ring:
      return CrackEnd::At::ring;
    case glass::CrackEnd::At::origin:
      return CrackEnd::At::origin;
    case glass::CrackEnd::At::edge:
      return CrackEnd::At::edge;
    case glass::CrackEnd::At::crack:
      return CrackEnd::At::crack;
    case glass::CrackEnd::At::enclosed:
      return CrackEnd::At::enclosed;
    case glass::CrackEnd::At::open:
      return CrackEnd::At::open;
  }
  throw_broken_invariant("an end of a crack", __FILE_NAME__, __LINE__);
}

ShardState plain(glass::ShardState state) {
  switch (state) {
    case glass::ShardState::standing:
      return ShardState::standing;
    case glass::ShardState::fallen:
      return ShardState::fallen;
    case glass::ShardState::missing:
      return ShardState::missing;
  }
  throw_broken_invariant("a state of a shard", __FILE_NAME__, __LINE__);
}

ShardSurface plain(glass::ShardSurface surface) {
  switch (surface) {
    case glass::ShardSurface::old:
      return ShardSurface::old;
    case glass::ShardSurface::broken:
      return ShardSurface::broken;
  }
  throw_broken_invariant("a surface of a shard", __FILE_NAME__, __LINE__);
}

Pane plain(const exporting::BrokenPane& broken) {
  Pane pane{broken.pane.name, plain(broken.pane.outline_mm), broken.pane.thickness_mm, {}, {}, {}, {}};
  for (const glass::ImpactCounts& counts : broken.network.impacts) pane.impacts.push_back(plain(counts));
  pane.cracks.reserve(broken.network.cracks.size());
  for (const glass::Crack& crack : broken.network.cracks) pane.cracks.push_back(plain(crack));
  pane.far_cracks.reserve(broken.far_network.cracks.size());
  for (const glass::Crack& crack : broken.far_network.cracks) pane.far_cracks.push_back(plain(crack));
  pane.shards.reserve(broken.shards.size());
  for (const glass::Shard& shard : broken.shards) pane.shards.push_back(plain(shard));
  return pane;
}

ShardMesh plain_mesh(const glass::Shard& shard, const glass::Pane& pane) {
  const geometry::Bend bend = glass::bend_of(pane);
  std::vector<vec3> points;
  points.reserve(shard.solid.vertices.size());
  for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
    points.push_back(glass::in_pane_mm(vertex, pane.thickness_mm));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(shard.solid.triangles.size());
  for (const geometry::SolidTriangle& triangle : shard.solid.triangles) triangles.push_back(triangle.corners);
  geometry::Refinement parts = geometry::refinement(points, triangles, bend, exporting::shapes::bent_shard_bound_mm);
  for (const auto [a, b] : parts.added) points.push_back(0.5 * (points[a] + points[b]));
  ShardMesh mesh;
  mesh.vertices_mm.reserve(points.size());
  for (const vec3 point : points) mesh.vertices_mm.push_back(plain(bend.point(point)));
  for (std::size_t i = 0; i < parts.triangles.size(); ++i) {
    const auto& corners = parts.triangles[i];
    const geometry::SolidTriangle& whole = shard.solid.triangles[parts.part_of[i]];
    const vec3 middle = (points[corners[0]] + points[corners[1]] + points[corners[2]]) / 3.0;
    mesh.triangles.push_back(corners);
    mesh.normals.push_back(plain(bend.normal(middle, geometry::normal(shard.solid, whole))));
    mesh.surfaces.push_back(plain(static_cast<glass::ShardSurface>(whole.slot)));
  }
  return mesh;
}

}  // namespace shatterpave::face
