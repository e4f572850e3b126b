#include "export/povray/sheets.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "export/povray/sdl.h"

namespace shatterpave::exporting::povray {

namespace {

constexpr double normal_steps = 1000.0;
constexpr std::size_t per_line = 6;

vec3 rounded(vec3 normal) {
  const auto to_step = [](double value) { return std::round(value * normal_steps) / normal_steps; };
  return {to_step(normal.x), to_step(normal.y), to_step(normal.z)};
}

void append_separator(std::string& text, std::size_t number) {
  if (number > 0) text += number % per_line == 0 ? ",\n" : ",";
}

// Of millions, each space is a megabyte, and so is each zero before a point.
void append_short_number(std::string& text, double value) {
  const std::size_t begin = text.size();
  append_number(text, value);
  const std::size_t digits = begin + (text[begin] == '-' ? 1 : 0);
  if (text.compare(digits, 2, "0.") == 0) text.erase(digits, 1);
}

// As append_standing_point has it.
void append_corner(std::string& text, vec3 at) {
  text += '<';
  append_short_number(text, at.x);
  text += ',';
  append_short_number(text, at.y);
  text += ',';
  append_short_number(text, -at.z);
  text += '>';
}

struct GapMesh {
  std::vector<vec3> points;
  std::vector<vec3> normals;  // as many
};

// All of a mesh but its faces, and those as they are given.
std::string mesh_text(const GapMesh& mesh, std::string_view faces) {
  std::string text = fmt::format("   mesh2 {{\n      vertex_vectors {{ {},\n", mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    append_separator(text, i);
    append_corner(text, mesh.points[i]);
  }
  text += fmt::format(" }}\n      normal_vectors {{ {},\n", mesh.normals.size());
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    append_separator(text, i);
    append_corner(text, rounded(mesh.normals[i]));
  }
  return text + fmt::format(" }}\n      {}\n      inside_vector z\n   }}\n", faces);
}

std::string faces_text(const std::vector<std::size_t>& triangles) {
  std::string text = fmt::format("face_indices {{ {},\n", triangles.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_separator(text, i / 3);
    fmt::format_to(std::back_inserter(text), "<{},{},{}>", triangles[i], triangles[i + 1], triangles[i + 2]);
  }
  return text + " }";
}

}  // namespace

std::string sheet_mesh(const glass::CrackSurface& surface) {
  GapMesh mesh{surface.left_mm, surface.normals};
  mesh.points.insert(mesh.points.end(), surface.right_mm.begin(), surface.right_mm.end());
  for (const vec3 normal : surface.normals) mesh.normals.push_back(-normal);
  // The same faces as glass::closed_triangles, but for which way round they are: POV-Ray takes either.
  return mesh_text(mesh, fmt::format("Shatterpave_Gap_Faces({}, {})", surface.columns(), surface.rows));
}

std::string shot_hole_mesh(const glass::ShotHole& shot_hole) {
  GapMesh mesh{shot_hole.wall_mm, shot_hole.normals};
  std::vector<std::size_t> triangles = glass::closed_triangles(shot_hole);
  const std::vector<vec3> middles = glass::middles_mm(shot_hole);
  // The ends are flat: rings of their own, with the normals of the faces of the pane.
  const std::size_t wall = shot_hole.wall_mm.size();
  for (std::size_t end = 0; end < 2; ++end) {
    const vec3 normal{0.0, 0.0, end == 0 ? 1.0 : -1.0};
    mesh.points.push_back(middles[end]);
    mesh.normals.push_back(normal);
  }
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t from = end == 0 ? 0 : wall - shot_hole.points;
    for (std::size_t k = 0; k < shot_hole.points; ++k) {
      mesh.points.push_back(shot_hole.wall_mm[from + k]);
      mesh.normals.push_back(mesh.normals[wall + end]);
    }
  }
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    if (triangles[i] < wall) continue;
    const bool far = triangles[i] == wall + 1;
    for (std::size_t k = 1; k < 3; ++k) {
      triangles[i + k] = wall + 2 + (far ? triangles[i + k] - (wall - shot_hole.points) + shot_hole.points : triangles[i + k]);
    }
  }
  return mesh_text(mesh, faces_text(triangles));
}

}  // namespace shatterpave::exporting::povray
