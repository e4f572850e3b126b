#include "export/shapes/tangents.h"

#include <cmath>
#include <cstddef>

namespace shatterpave::exporting::shapes {

namespace {

// Any direction at right angles to a unit vector: for points of which no triangle has an area in the texture.
vec3 beside(vec3 normal) {
  const vec3 axis = std::abs(normal.x) < 0.5 ? vec3{1.0, 0.0, 0.0} : vec3{0.0, 1.0, 0.0};
  return glm::normalize(glm::cross(glm::cross(normal, axis), normal));
}

}  // namespace

std::vector<Tangent> tangents(const Mesh& mesh) {
  std::vector<vec3> sums(mesh.points_mm.size(), vec3{0.0, 0.0, 0.0});
  std::vector<double> turns(mesh.points_mm.size(), 0.0);
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::uint32_t* corners = &mesh.triangles[i];
    const vec3 e = mesh.points_mm[corners[1]] - mesh.points_mm[corners[0]];
    const vec3 f = mesh.points_mm[corners[2]] - mesh.points_mm[corners[0]];
    const vec2 a = mesh.uv_m[corners[1]] - mesh.uv_m[corners[0]];
    const vec2 b = mesh.uv_m[corners[2]] - mesh.uv_m[corners[0]];
    const double turn = cross(a, b);
    const vec3 along = (turn < 0.0 ? -1.0 : 1.0) * (b.y * e - a.y * f);
    for (std::size_t k = 0; k < 3; ++k) {
      sums[corners[k]] += along;
      turns[corners[k]] += turn;
    }
  }
  std::vector<Tangent> result(sums.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const vec3& normal = mesh.normals[i];
    const vec3 flat = sums[i] - glm::dot(sums[i], normal) * normal;
    const double length = glm::length(flat);
    result[i] = {length > 0.0 ? flat / length : beside(normal), turns[i] < 0.0};
  }
  return result;
}

}  // namespace shatterpave::exporting::shapes
