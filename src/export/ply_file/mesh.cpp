#include "export/ply_file/mesh.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <iterator>
#include <limits>

#include "core/error.h"

namespace shatterpave::exporting {

namespace {

static_assert(std::endian::native == std::endian::little);

template <typename Value>
void put(std::string& bytes, Value value) {
  char buffer[sizeof(Value)];
  std::memcpy(buffer, &value, sizeof(Value));
  bytes.append(buffer, sizeof(Value));
}

void put_vector(std::string& bytes, vec3 v) {
  for (std::size_t axis = 0; axis < 3; ++axis) put(bytes, static_cast<float>(v[axis]) + 0.0F);
}

}  // namespace

void PlyMesh::comment(std::string_view text) { fmt::format_to(std::back_inserter(comments_), "comment {}\n", text); }

void PlyMesh::add(const shapes::Mesh& mesh, const shapes::Placing& placing, std::string_view numbers) {
  if (vertex_count_ + mesh.points_mm.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw InputError(fmt::format("target {}: expected at most 2,147,483,647 vertices in a file, got more", form_.target));
  }
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    put_vector(vertices_, placing(mesh.points_mm[i]) / 1000.0);
    put_vector(vertices_, placing.turned(mesh.normals[i]));
    put(vertices_, static_cast<float>(mesh.uv_m[i].x));
    put(vertices_, static_cast<float>(mesh.uv_m[i].y));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    put(faces_, static_cast<std::uint8_t>(3));
    for (std::size_t k = 0; k < 3; ++k) put(faces_, static_cast<std::int32_t>(vertex_count_ + mesh.triangles[i + k]));
    faces_ += numbers;
  }
  vertex_count_ += mesh.points_mm.size();
  face_count_ += mesh.triangles.size() / 3;
}

std::string PlyMesh::taken() {
  std::string file = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment shatterpave: metres, y up\n{}element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty float {}\nproperty float {}\nelement face {}\n"
      "property list uchar int vertex_indices\n{}end_header\n",
      comments_, vertex_count_, form_.uv[0], form_.uv[1], face_count_, form_.faces);
  file.reserve(file.size() + vertices_.size() + faces_.size());
  file += vertices_;
  vertices_ = {};
  file += faces_;
  *this = PlyMesh(form_);
  return file;
}

}  // namespace shatterpave::exporting
