// Stones as triangles: near ones with their relief as true geometry, far ones as prisms.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/bezier_patch.h"
#include "geometry/polygon.h"
#include "relief/height_field.h"

namespace shatterpave::exporting::shapes {

struct StoneMesh {
  std::vector<vec3> vertices;            // mm
  std::vector<vec3> normals;             // of unit length, one for each vertex; none for flat triangles
  std::vector<std::uint32_t> triangles;  // three indices each, counter-clockwise seen from above

  // A patch's vertices, row by row: the vertex (i, j) is first + i * (columns + 1) + j.
  struct Grid {
    std::uint32_t first = 0;
    std::size_t rows = 0;     // of squares, along u
    std::size_t columns = 0;  // along v
  };
  // Of what is displaced: where its vertices were, and how they faced, before the relief lifted them.
  std::vector<Grid> grids;
  std::vector<vec3> bare;
  std::vector<vec3> bare_normals;
};

// A stone's window in the periodic relief.
struct ReliefWindow {
  const relief::HeightField* field = nullptr;  // null: level
  vec2 place{0.0, 0.0};                        // of the stone's centre, in parts of the field
  vec2 centre{0.0, 0.0};                       // mm
  double side_mm = 1.0;                        // of the field
  double factor = 1.0;                         // on its heights
};

// The patches as one mesh: each is divided into squares of about `step_mm`, and its points are lifted by the relief, which is a
// function of the place alone. Borders that patches share are divided alike, so that the mesh has no crack. No border has fewer
// than `least_parts`: arrises bend through a right angle.
StoneMesh displaced(const std::vector<geometry::BezierPatch>& patches, const ReliefWindow& window, double step_mm,
                    std::size_t least_parts = 4);

// The same without relief, of as few triangles as show it: what is straight is not divided.
StoneMesh level_mesh(const std::vector<geometry::BezierPatch>& patches, double step_mm, std::size_t least_parts);

// A prism over `outline` (simple, counter-clockwise) from the lowest of the patches, whose top, `arris_mm` from the sides, lies
// as the patches do.
StoneMesh prism(const geometry::Polygon& outline, const std::vector<geometry::BezierPatch>& patches, double arris_mm);

}  // namespace shatterpave::exporting::shapes
