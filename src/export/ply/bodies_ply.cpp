#include "export/ply/bodies_ply.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <iterator>
#include <limits>

#include "core/error.h"
#include "export/shapes/bodies.h"
#include "export/shapes/meshes_of.h"

namespace shatterpave::exporting::ply {

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

class Writer {
 public:
  explicit Writer(const Model& model) : materials_(shapes::materials_of(model)) {
    for (std::size_t i = 0; i < materials_.all.size(); ++i) {
      names_ += fmt::format("comment material {} {}\n", i, materials_.all[i].name);
    }
    shapes::for_each_body(
        model, materials_, [&](const std::string&, bool) { shared_.begin_thing(); }, [&](shapes::Body&& body) { add(body); });
  }

  std::string text() const {
    return fmt::format(
               "ply\nformat binary_little_endian 1.0\ncomment shatterpave: metres, y up\n{}element vertex {}\n"
               "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
               "property float nz\nproperty float s\nproperty float t\nelement face {}\n"
               "property list uchar int vertex_indices\nproperty int body\nproperty int material\nend_header\n",
               names_, vertex_count_, face_count_) +
           vertices_ + faces_;
  }

 private:
  void add(const shapes::Body& body) {
    names_ += fmt::format("comment body {} {} {}\n", body_count_, body.name, body.kind);
    for (const shapes::Piece& piece : shared_.of(body)) add(piece, body.placing);
    ++body_count_;
  }
  void add(const shapes::Piece& piece, const shapes::Placing& placing) {
    const shapes::Mesh& mesh = piece.mesh;
    if (vertex_count_ + mesh.points_mm.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
      throw InputError("target ply: expected at most 2,147,483,647 vertices, got more");
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
      put(faces_, body_count_);
      put(faces_, static_cast<std::int32_t>(piece.material));
    }
    vertex_count_ += mesh.points_mm.size();
    face_count_ += mesh.triangles.size() / 3;
  }

  shapes::Materials materials_;
  shapes::SharedPieces shared_;
  std::string names_;
  std::string vertices_;
  std::string faces_;
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  std::int32_t body_count_ = 0;
};

}  // namespace

std::vector<OutputFile> ply_files(const Model& model) { return {{model.name + ".ply", Writer(model).text()}}; }

void append(const Model& model, Outputs& outputs) {
  for (OutputFile& file : ply_files(model)) outputs.files.push_back(std::move(file));
}

}  // namespace shatterpave::exporting::ply
