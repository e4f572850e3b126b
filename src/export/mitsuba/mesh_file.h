// Meshes of several bodies as one PLY file that Mitsuba reads without a warning.
#pragma once

#include <cstdint>
#include <string>

#include "export/ply_file/mesh.h"
#include "export/shapes/body.h"

namespace shatterpave::exporting::mitsuba {

// Binary, little endian. Vertices have x, y, z (metres, y up), normals nx, ny, nz, and places in textures u, v (metres). Faces
// are triangles, counter-clockwise from outside, with the number of their body: `body_0`, which Mitsuba takes as the attribute
// `face_body`. Comments of the header name the bodies:
//   comment body 17 window.crack-3 crack large
class MeshFile {
 public:
  MeshFile();
  // What is added after this is of the body. The same again does nothing.
  void begin_body(std::uint32_t number, const shapes::Body& body);
  // Refuses what 32-bit indices cannot hold.
  void add(const shapes::Mesh& mesh, const shapes::Placing& placing);
  // The file; nothing is left here.
  std::string taken();

 private:
  PlyMesh mesh_;
  float body_ = -1.0F;  // of what is added; whole numbers, as floats are what Mitsuba has for attributes
};

}  // namespace shatterpave::exporting::mitsuba
