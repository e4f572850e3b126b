#include "export/ply/bodies_ply.h"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "export/ply_file/mesh.h"
#include "export/shapes/bodies.h"
#include "export/shapes/meshes_of.h"

namespace shatterpave::exporting::ply {

namespace {

class Writer {
 public:
  explicit Writer(const Model& model) : materials_(shapes::materials_of(model)) {
    for (std::size_t i = 0; i < materials_.all.size(); ++i) {
      mesh_.comment(fmt::format("material {} {}", i, materials_.all[i].name));
    }
    shapes::for_each_body(
        model, materials_, [&](const std::string&, bool) { shared_.begin_thing(); }, [&](shapes::Body&& body) { add(body); });
  }

  std::string taken() { return mesh_.taken(); }

 private:
  void add(const shapes::Body& body) {
    mesh_.comment(fmt::format("body {} {} {}", body_count_, body.name, body.kind));
    for (const shapes::Piece& piece : shared_.of(body)) {
      using Numbers = std::array<std::int32_t, 2>;
      const auto bytes =
          std::bit_cast<std::array<char, sizeof(Numbers)>>(Numbers{body_count_, static_cast<std::int32_t>(piece.material)});
      mesh_.add(piece.mesh, body.placing, {bytes.data(), bytes.size()});
    }
    ++body_count_;
  }

  shapes::Materials materials_;
  shapes::SharedPieces shared_;
  PlyMesh mesh_{{.target = "ply", .uv = {"s", "t"}, .faces = "property int body\nproperty int material\n"}};
  std::int32_t body_count_ = 0;
};

}  // namespace

std::vector<OutputFile> ply_files(const Model& model) { return {{model.name + ".ply", Writer(model).taken()}}; }

void append(const Model& model, Outputs& outputs) {
  for (OutputFile& file : ply_files(model)) outputs.files.push_back(std::move(file));
}

}  // namespace shatterpave::exporting::ply
