// Parts that meshes are put together from.
#pragma once

#include "export/shapes/body.h"
#include "geometry/polygon.h"

namespace shatterpave::exporting::shapes {

constexpr double metres(double mm) { return mm / 1000.0; }

void append_point(Mesh& mesh, vec3 p_mm, vec3 normal, vec2 uv_m);
void append_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);
void append(Mesh& mesh, const Mesh& more);

// The mesh with points that are one but for rounding taken for one: in place, normal and place in textures.
Mesh welded(const Mesh& mesh);

// The region at a height of z, seen from above.
Mesh upright_cap(const geometry::Region& region, double z_mm);

// The sides of what stands upright on an outline that runs counter-clockwise, with sharp edges.
Mesh upright_sides(const geometry::Polygon& outline, double low_mm, double high_mm);

// What stands upright on the region, between two heights of z: closed, with sharp edges. Places in textures are those of the
// plane in metres; of the sides, along them and up.
Mesh upright_prism(const geometry::Region& region, double low_mm, double high_mm);

}  // namespace shatterpave::exporting::shapes
