#include "export/shapes/glass_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle.h"
#include "core/parallel.h"
#include "export/names.h"
#include "export/shapes/mesh_parts.h"
#include "export/shapes/tubes.h"

namespace shatterpave::exporting::shapes {

namespace {

constexpr std::size_t shards_at_once = 256;
// Sides of tubes, and of the disc of crushed glass.
constexpr std::size_t tube_sides = 6;
constexpr std::size_t disc_sides = 48;
// Of crushed glass, below the faces of the pane.
constexpr double skin_mm = 0.01;

// Along which axis a facet looks most.
std::size_t axis_of(vec3 normal) {
  const std::array<double, 3> parts{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  return static_cast<std::size_t>(std::ranges::max_element(parts) - parts.begin());
}

// Where a point is in a texture that is laid on from the side that the normal faces most squarely.
vec2 faced(vec3 p_mm, vec3 normal) {
  const std::size_t axis = axis_of(normal);
  const vec2 place = axis == 0 ? vec2{p_mm.y, p_mm.z} : (axis == 1 ? vec2{p_mm.x, p_mm.z} : vec2{p_mm.x, p_mm.y});
  return {metres(place.x), metres(place.y)};
}

// A flat facet with points of its own; nothing where it has no area.
void append_facet(Mesh& mesh, const std::array<vec3, 3>& corners) {
  const vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = glm::length(across);
  if (size == 0.0) return;
  const vec3 normal = across / size;
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  for (const vec3& corner : corners) append_point(mesh, corner, normal, faced(corner, normal));
  append_triangle(mesh, first, first + 1, first + 2);
}

// ---- cavities: what bounds them looks into them

// Turns a closed surface inside out.
Mesh inverted(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) std::swap(mesh.triangles[i + 1], mesh.triangles[i + 2]);
  for (vec3& normal : mesh.normals) normal = -normal;
  return mesh;
}

// Flat facets of a closed surface of triangles.
Mesh faceted(const std::vector<vec3>& points, const std::vector<std::size_t>& triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_facet(mesh, {points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]});
  }
  return mesh;
}

Mesh gap(const glass::CrackSurface& surface) {
  Mesh mesh;
  const std::size_t wall = surface.left_mm.size();
  const std::size_t rows = surface.rows;
  for (const bool left : {true, false}) {
    const std::vector<vec3>& points = left ? surface.left_mm : surface.right_mm;
    double along = 0.0;
    for (std::size_t i = 0; i < wall; ++i) {
      if (i >= rows && i % rows == 0) along += glm::length(points[i] - points[i - rows]);
      append_point(mesh, points[i], left ? surface.normals[i] : -surface.normals[i], {metres(along), metres(points[i].z)});
    }
  }
  const std::vector<vec3> points = mesh.points_mm;
  const std::vector<std::size_t> triangles = glass::closed_triangles(surface);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array<std::size_t, 3> c{triangles[i], triangles[i + 1], triangles[i + 2]};
    const auto on_left = std::ranges::count_if(c, [&](std::size_t corner) { return corner < wall; });
    if (on_left == 0 || on_left == 3) {
      append_triangle(mesh, static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]),
                      static_cast<std::uint32_t>(c[2]));
      continue;
    }
    // The rim between the walls is sharp.
    append_facet(mesh, {points[c[0]], points[c[1]], points[c[2]]});
  }
  return inverted(std::move(mesh));
}

// The flat end over a ring of points, which are counter-clockwise about the axis; the normal looks along it or against it.
void append_end(Mesh& mesh, std::uint32_t ring, std::uint32_t count, vec3 normal) {
  const vec3 a = mesh.points_mm[ring];
  const bool along = glm::dot(glm::cross(mesh.points_mm[ring + 1] - a, mesh.points_mm[ring + 2] - a), normal) > 0.0;
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    const vec3 p = mesh.points_mm[ring + k];
    append_point(mesh, p, normal, faced(p, normal));
  }
  for (std::uint32_t k = 1; k + 1 < count; ++k) {
    append_triangle(mesh, first, first + (along ? k : k + 1), first + (along ? k + 1 : k));
  }
}

// Rings about an axis, closed at both ends by fans: a tube, or a disc.
Mesh round_body(vec3 from, vec3 to, vec3 side, double radius_mm, std::size_t sides) {
  const vec3 axis = glm::normalize(to - from);
  const vec3 other = glm::cross(axis, side);
  Mesh mesh;
  for (const double end : {0.0, 1.0}) {
    const vec3 middle = end == 0.0 ? from : to;
    for (std::size_t k = 0; k < sides; ++k) {
      const vec2 at = Angle::degrees(360.0 * static_cast<double>(k) / static_cast<double>(sides)).direction();
      const vec3 out = at.x * side + at.y * other;
      append_point(mesh, middle + radius_mm * out, out,
                   {metres(end * glm::length(to - from)),
                    metres(2.0 * pi * radius_mm * static_cast<double>(k) / static_cast<double>(sides))});
    }
  }
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    append_triangle(mesh, k, next, count + next);
    append_triangle(mesh, k, count + next, count + k);
  }
  append_end(mesh, 0, count, -axis);
  append_end(mesh, count, count, axis);
  return inverted(std::move(mesh));
}

Mesh tube_mesh(const Tube& tube) {
  return round_body({tube.a_mm, 0.0}, {tube.b_mm, 0.0}, {0.0, 0.0, 1.0}, tube.radius_mm, tube_sides);
}

// ---- shards

vec3 shard_point(const glass::Shard& shard, std::uint32_t vertex, double thickness_mm) {
  return glass::in_pane_mm(shard.solid.vertices[vertex], thickness_mm);
}

Body shard_body(const BrokenPane& broken, const glass::Shard& shard, std::size_t first_material) {
  Body body;
  body.name = fmt::format("{}.{}", broken.pane.name, shard.id);
  body.kind = fmt::format("shard {}", name_of(shard.state));
  const vec2 middle = geometry::on_lattice(geometry::centroid(shard.face.outline));
  const vec3 pivot{middle.x, middle.y, 0.0};
  for (const int slot : {0, 1}) {
    Piece piece{first_material + static_cast<std::size_t>(slot), {}};
    for (const geometry::SolidTriangle& triangle : shard.solid.triangles) {
      if (triangle.slot != slot) continue;
      const vec3 normal = geometry::normal(shard.solid, triangle);
      const auto first = static_cast<std::uint32_t>(piece.mesh.points_mm.size());
      for (const std::uint32_t corner : triangle.corners) {
        const vec3 p = shard_point(shard, corner, broken.pane.thickness_mm);
        append_point(piece.mesh, p - pivot, normal, faced(p, normal));
      }
      append_triangle(piece.mesh, first, first + 1, first + 2);
    }
    if (!piece.mesh.triangles.empty()) body.pieces.push_back(std::move(piece));
  }
  body.placing = {shard.motion.rows, glass::moved(shard.motion, pivot)};
  return body;
}

// A body for each crack that has one, of meshes that follow one another.
class CrackBodies {
 public:
  CrackBodies(const BrokenPane& broken, std::size_t material, const TakeBody& take)
      : broken_(broken), material_(material), take_(take) {}
  ~CrackBodies() = default;
  CrackBodies(const CrackBodies&) = delete;
  CrackBodies& operator=(const CrackBodies&) = delete;

  void add(int crack, const Mesh& mesh) {
    if (crack != crack_) end();
    crack_ = crack;
    append(mesh_, mesh);
  }
  void end() {
    if (crack_ >= 0) {
      const glass::CrackKind kind = broken_.network.cracks[static_cast<std::size_t>(crack_)].kind;
      take_({fmt::format("{}.crack-{}", broken_.pane.name, crack_),
             fmt::format("crack {}", name_of(kind)),
             {{material_, std::move(mesh_)}},
             {}});
    }
    mesh_ = {};
    crack_ = -1;
  }

 private:
  const BrokenPane& broken_;
  std::size_t material_;
  const TakeBody& take_;
  int crack_ = -1;
  Mesh mesh_;
};

void append_tubes(const BrokenPane& broken, const std::vector<Tube>& tubes, std::size_t material, const TakeBody& take) {
  CrackBodies cracks(broken, material, take);
  for (const Tube& tube : tubes) cracks.add(tube.crack, tube_mesh(tube));
  cracks.end();
}

void append_crushed(const BrokenPane& broken, const std::vector<glass::ImpactZone>& zones, std::size_t material,
                    const TakeBody& take) {
  const double half = 0.5 * broken.pane.thickness_mm - skin_mm;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const vec2 at = zones[i].centre_mm;
    if (zones[i].radius_mm <= 0.0 || half <= 0.0) continue;
    take({fmt::format("{}.crushed-{}", broken.pane.name, i),
          "crushed",
          {{material, round_body({at.x, at.y, -half}, {at.x, at.y, half}, {1.0, 0.0, 0.0}, zones[i].radius_mm, disc_sides)}},
          {}});
  }
}

void append_gaps(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  CrackBodies cracks(broken, first_material + 1, take);
  for (const glass::CrackSurface& surface : broken.surfaces.surfaces) cracks.add(surface.crack, gap(surface));
  cracks.end();
  append_crushed(broken, crushed_zones(broken.surfaces), first_material + 2, take);
  for (std::size_t i = 0; i < broken.surfaces.shot_holes.size(); ++i) {
    const glass::ShotHole& hole = broken.surfaces.shot_holes[i];
    std::vector<vec3> points = hole.wall_mm;
    for (const vec3& middle : glass::middles_mm(hole)) points.push_back(middle);
    take({fmt::format("{}.hole-{}", broken.pane.name, i),
          "hole",
          {{first_material + 1, inverted(faceted(points, glass::closed_triangles(hole)))}},
          {}});
  }
}

void append_whole(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  const double half = 0.5 * broken.pane.thickness_mm;
  take({broken.pane.name + ".slab", "pane", {{first_material, upright_prism({broken.pane.outline_mm, {}}, -half, half)}}, {}});
  if (broken.pane.crack_body == glass::CrackBody::sheet) {
    append_gaps(broken, first_material, take);
    return;
  }
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  append_tubes(broken, cracks.tubes, first_material + 1, take);
  append_crushed(broken, cracks.zones, first_material + 2, take);
}

void append_shards(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  std::vector<const glass::Shard*> there;
  for (const glass::Shard& shard : broken.shards) {
    if (shard.state != glass::ShardState::missing) there.push_back(&shard);
  }
  std::vector<Body> bodies;
  for (std::size_t begin = 0; begin < there.size(); begin += shards_at_once) {
    bodies.assign(std::min(shards_at_once, there.size() - begin), {});
    parallel_for(bodies.size(), [&](std::size_t i) { bodies[i] = shard_body(broken, *there[begin + i], first_material); });
    for (Body& body : bodies) take(std::move(body));
  }
  append_tubes(broken, joined_tubes(broken), first_material + 1, take);
}

}  // namespace

void append_glass(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  if (broken.pane.shards) {
    append_shards(broken, first_material, take);
  } else {
    append_whole(broken, first_material, take);
  }
}

}  // namespace shatterpave::exporting::shapes
