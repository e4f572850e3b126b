// Meshes as a PLY file, for every target that writes such.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "export/shapes/body.h"

namespace shatterpave::exporting {

// Binary, little endian. Vertices have x, y, z (metres, y up), normals nx, ny, nz and places in textures (metres). Faces are
// triangles, counter-clockwise from outside, with numbers that the target chooses: each of four bytes.
class PlyMesh {
 public:
  struct Form {
    std::string_view target;  // as messages name it
    std::string_view uv[2];   // names of the places in textures
    std::string_view faces;   // lines that declare the numbers of a face: "property int body\n"
  };
  explicit PlyMesh(const Form& form) : form_(form) {}

  void comment(std::string_view text);
  // Throws InputError for what indices of 31 bits cannot hold. `numbers` are the bytes of the numbers of each face.
  void add(const shapes::Mesh& mesh, const shapes::Placing& placing, std::string_view numbers);
  // The file; nothing is left here.
  std::string taken();

 private:
  Form form_;
  std::string comments_;
  std::string vertices_;
  std::string faces_;
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
};

}  // namespace shatterpave::exporting
