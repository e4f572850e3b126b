#include "export/shapes/open_slab.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "export/shapes/glass_meshes.h"
#include "export/shapes/mesh_parts.h"
#include "glass/gaps/shot_hole.h"

namespace shatterpave::exporting::shapes {

namespace {

// The ring of a hole on the impact's face, or on the far one: clockwise, as holes of regions are.
geometry::Polygon opening(const glass::ShotHole& hole, bool on_impact_face) {
  const std::size_t first = on_impact_face ? 0 : hole.wall_mm.size() - hole.points;
  geometry::Polygon ring;
  for (std::size_t k = 0; k < hole.points; ++k) {
    const vec3& p = hole.wall_mm[first + hole.points - 1 - k];
    ring.emplace_back(p.x, p.y);
  }
  return ring;
}

Mesh wall(const glass::ShotHole& hole, double half_mm) {
  Mesh mesh;
  for (std::size_t i = 0; i < hole.wall_mm.size(); ++i) {
    vec3 p = hole.wall_mm[i];
    if (i < hole.points) p.z = half_mm;
    if (i >= hole.wall_mm.size() - hole.points) p.z = -half_mm;
    const vec2 from = vec2{p.x, p.y} - hole.shape.centre_mm;
    append_point(mesh, p, -hole.normals[i], {metres(Angle::of(from).radians() * glm::length(from)), metres(p.z)});
  }
  const std::vector<std::size_t> triangles = glass::closed_triangles(hole);
  const std::size_t count = hole.wall_mm.size();
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    if (std::max({triangles[i], triangles[i + 1], triangles[i + 2]}) >= count) continue;  // of an end
    append_triangle(mesh, static_cast<std::uint32_t>(triangles[i]), static_cast<std::uint32_t>(triangles[i + 2]),
                    static_cast<std::uint32_t>(triangles[i + 1]));
  }
  return mesh;
}

}  // namespace

OpenSlab open_slab(const BrokenPane& broken) {
  const double half = 0.5 * broken.pane.thickness_mm;
  const geometry::Bend bend = glass::bend_of(broken.pane);
  OpenSlab open;
  geometry::Region front{broken.pane.outline_mm, {}};
  geometry::Region back = front;
  for (const glass::ShotHole& hole : broken.surfaces.shot_holes) {
    front.holes.push_back(opening(hole, true));
    back.holes.push_back(opening(hole, false));
    open.walls.push_back(bent(wall(hole, half), bend, bent_pane_bound_mm));
  }
  open.slab = upright_cap(front, half);
  Mesh far = upright_cap(back, -half);
  for (std::size_t i = 0; i < far.triangles.size(); i += 3) std::swap(far.triangles[i + 1], far.triangles[i + 2]);
  for (vec3& normal : far.normals) normal = -normal;
  append(open.slab, far);
  append(open.slab, upright_sides(broken.pane.outline_mm, -half, half));
  open.slab = bent(std::move(open.slab), bend, bent_pane_bound_mm);
  return open;
}

}  // namespace shatterpave::exporting::shapes
