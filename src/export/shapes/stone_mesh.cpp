// How many parts a border is divided into: opposite borders of a patch must have as many, and so must those that patches share.
// Borders that must agree are united into classes, and the longest of a class decides.
#include "export/shapes/stone_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/disjoint_sets.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::exporting::shapes {

using geometry::BezierPatch;
using geometry::Polygon;

namespace {

// ---- division of borders

// Ends of border b of a patch: v = 0, u = 1, v = 1, u = 0.
std::array<vec3, 2> ends(const BezierPatch& patch, std::size_t border) {
  const auto& p = patch.control_points;
  constexpr std::array<std::array<std::size_t, 2>, 4> corners = {{{0, 12}, {12, 15}, {3, 15}, {0, 3}}};
  return {p[corners[border][0]], p[corners[border][1]]};
}

bool same(const vec3& a, const vec3& b) {
  constexpr double hairline_mm = 1e-6;
  return std::abs(a.x - b.x) < hairline_mm && std::abs(a.y - b.y) < hairline_mm;
}

// Whether all lines of the patch along u, or else along v, are straight and evenly run through.
bool is_straight(const BezierPatch& patch, bool along_u) {
  constexpr double hardly_mm = 0.005;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto point = [&](std::size_t step) { return along_u ? patch.at(step, k) : patch.at(k, step); };
    for (const std::size_t step : {std::size_t{1}, std::size_t{2}}) {
      const double part = static_cast<double>(step) / 3.0;
      if (glm::length(point(step) - (point(0) + part * (point(3) - point(0)))) > hardly_mm) return false;
    }
  }
  return true;
}

struct Fineness {
  double step_mm = 1.0;
  std::size_t least_parts = 1;     // of what is divided
  bool is_straight_whole = false;  // what is straight is not
};

// For each patch the parts along u and along v.
std::vector<std::array<std::size_t, 2>> divisions(const std::vector<BezierPatch>& patches, const Fineness& fineness) {
  const std::size_t border_count = 4 * patches.size();
  DisjointSets classes(border_count);  // of borders that are divided alike
  for (std::size_t i = 0; i < patches.size(); ++i) {
    classes.join(4 * i, 4 * i + 2);
    classes.join(4 * i + 1, 4 * i + 3);
  }
  for (std::size_t a = 0; a < border_count; ++a) {
    const auto first = ends(patches[a / 4], a % 4);
    for (std::size_t b = a + 1; b < border_count; ++b) {
      const auto second = ends(patches[b / 4], b % 4);
      const bool shared =
          (same(first[0], second[0]) && same(first[1], second[1])) || (same(first[0], second[1]) && same(first[1], second[0]));
      if (shared) classes.join(a, b);
    }
  }
  std::vector<double> lengths(border_count, 0.0);
  for (std::size_t a = 0; a < border_count; ++a) {
    const auto [from, to] = ends(patches[a / 4], a % 4);
    double& longest = lengths[classes.of(a)];
    longest = std::max(longest, glm::length(to - from));
  }
  std::vector<bool> divided(border_count, !fineness.is_straight_whole);
  for (std::size_t a = 0; a < border_count; ++a) {
    if (!is_straight(patches[a / 4], a % 2 == 0)) divided[classes.of(a)] = true;
  }
  std::vector<std::array<std::size_t, 2>> counts(patches.size());
  const auto parts = [&](std::size_t border) {
    const std::size_t of_class = classes.of(border);
    if (!divided[of_class]) return std::size_t{1};
    return std::max(fineness.least_parts, static_cast<std::size_t>(std::ceil(lengths[of_class] / fineness.step_mm)));
  };
  for (std::size_t i = 0; i < patches.size(); ++i) counts[i] = {parts(4 * i), parts(4 * i + 1)};
  return counts;
}

// ---- relief

struct Lift {
  double height = 0.0;
  vec2 slope{0.0, 0.0};
};

Lift lift(const ReliefWindow& window, vec2 at) {
  if (window.field == nullptr) return {};
  const relief::HeightField& field = *window.field;
  const auto size = static_cast<double>(field.width);
  // The image of the field has its first row on top.
  const vec2 place = window.place + (at - window.centre) / window.side_mm;
  const vec2 pixel = {place.x * size - 0.5, (1.0 - place.y) * size - 0.5};
  const vec2 cell = {std::floor(pixel.x), std::floor(pixel.y)};
  const vec2 part = pixel - cell;
  const auto wrapped = [&](double c, std::size_t extent) {
    const auto n = static_cast<std::int64_t>(extent);
    return static_cast<std::size_t>((static_cast<std::int64_t>(c) % n + n) % n);
  };
  const std::size_t x0 = wrapped(cell.x, field.width);
  const std::size_t x1 = wrapped(cell.x + 1.0, field.width);
  const std::size_t y0 = wrapped(cell.y, field.height);
  const std::size_t y1 = wrapped(cell.y + 1.0, field.height);
  const double a = field.at(x0, y0);
  const double b = field.at(x1, y0) - a;
  const double c = field.at(x0, y1) - a;
  const double d = field.at(x1, y1) - a - b - c;
  const double per_mm = window.factor * size / window.side_mm;
  return {window.factor * (a + b * part.x + c * part.y + d * part.x * part.y),
          {per_mm * (b + d * part.y), -per_mm * (c + d * part.x)}};
}

void append_patch(StoneMesh& mesh, const BezierPatch& patch, std::array<std::size_t, 2> parts, const ReliefWindow& window) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::size_t i = 0; i <= parts[0]; ++i) {
    for (std::size_t j = 0; j <= parts[1]; ++j) {
      const double u = static_cast<double>(i) / static_cast<double>(parts[0]);
      const double v = static_cast<double>(j) / static_cast<double>(parts[1]);
      vec3 p = geometry::point(patch, u, v);
      const vec3 normal = geometry::unit_normal(patch, u, v);
      mesh.bare.push_back(p);
      mesh.bare_normals.push_back(normal);
      const Lift lifted = lift(window, {p.x, p.y});
      p.z += lifted.height;
      mesh.vertices.push_back(p);
      mesh.normals.push_back(glm::normalize(normal - normal.z * vec3{lifted.slope.x, lifted.slope.y, 0.0}));
    }
  }
  mesh.grids.push_back({first, parts[0], parts[1]});
  const auto at = [&](std::size_t i, std::size_t j) { return first + static_cast<std::uint32_t>(i * (parts[1] + 1) + j); };
  for (std::size_t i = 0; i < parts[0]; ++i) {
    for (std::size_t j = 0; j < parts[1]; ++j) {
      for (const std::uint32_t corner : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        mesh.triangles.push_back(corner);
      }
    }
  }
}

StoneMesh made(const std::vector<BezierPatch>& patches, const ReliefWindow& window, const Fineness& fineness) {
  const auto counts = divisions(patches, fineness);
  StoneMesh mesh;
  for (std::size_t i = 0; i < patches.size(); ++i) append_patch(mesh, patches[i], counts[i], window);
  return mesh;
}

}  // namespace

StoneMesh displaced(const std::vector<BezierPatch>& patches, const ReliefWindow& window, double step_mm,
                    std::size_t least_parts) {
  return made(patches, window, {step_mm, least_parts, false});
}

StoneMesh level_mesh(const std::vector<BezierPatch>& patches, double step_mm, std::size_t least_parts) {
  return made(patches, {}, {step_mm, least_parts, true});
}

StoneMesh prism(const Polygon& outline, const std::vector<BezierPatch>& patches, double arris_mm) {
  const vec2 middle = geometry::centroid(outline);
  const Polygon corners = paving::corners(outline, 0.05 * std::sqrt(geometry::area(outline)));
  const auto count = static_cast<std::uint32_t>(corners.size());
  double base = std::numeric_limits<double>::infinity();
  for (const BezierPatch& patch : patches) {
    for (const vec3& point : patch.control_points) base = std::min(base, point.z);
  }
  StoneMesh mesh;
  for (const vec2& corner : corners) mesh.vertices.push_back({corner.x, corner.y, base});
  const double size = std::sqrt(geometry::area(outline));
  // Towards the middle by as much as moves the sides by half the arris.
  const double part = std::min(0.4, arris_mm / size);
  for (const vec2& corner : corners) {
    const vec2 top = corner + part * (middle - corner);
    mesh.vertices.push_back({top.x, top.y, geometry::height_at(patches, corner + (part + 0.05) * (middle - corner))});
  }
  mesh.vertices.push_back({middle.x, middle.y, geometry::height_at(patches, middle)});
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    for (const std::uint32_t corner : {i, next, count + next, i, count + next, count + i, count + i, count + next, 2 * count}) {
      mesh.triangles.push_back(corner);
    }
  }
  return mesh;
}

}  // namespace shatterpave::exporting::shapes
