#include "export/gltf/scene_gltf.h"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "export/shapes/bodies.h"

namespace shatterpave::exporting::gltf {

namespace {

using shapes::Substance;

static_assert(std::endian::native == std::endian::little);

constexpr double glass_ior = 1.52;
constexpr double water_ior = 1.333;
// How far white light goes in window glass until a share 1 / e of it is left, and what it is then: 4 mm of float glass let 89
// to 90 % through, of which the two faces take 8 % (EN 572-1); the green is that of its iron. By eye.
constexpr double attenuation_m = 0.25;
constexpr double attenuation_colour[] = {0.62, 0.83, 0.74};

tinygltf::Value number(double value) { return tinygltf::Value(value); }

void make_transparent(tinygltf::Material& material, double ior, double thickness_m) {
  using Object = tinygltf::Value::Object;
  material.pbrMetallicRoughness.baseColorFactor = {1.0, 1.0, 1.0, 1.0};
  material.extensions["KHR_materials_transmission"] = tinygltf::Value(Object{{"transmissionFactor", number(1.0)}});
  material.extensions["KHR_materials_ior"] = tinygltf::Value(Object{{"ior", number(ior)}});
  Object volume{{"thicknessFactor", number(thickness_m)}, {"attenuationDistance", number(attenuation_m)}};
  tinygltf::Value::Array colour;
  for (const double part : attenuation_colour) colour.push_back(number(part));
  volume["attenuationColor"] = tinygltf::Value(std::move(colour));
  material.extensions["KHR_materials_volume"] = tinygltf::Value(std::move(volume));
}

tinygltf::Material material_of(const shapes::Material& look, double thickness_m) {
  tinygltf::Material material;
  material.name = look.name;
  auto& pbr = material.pbrMetallicRoughness;
  pbr.metallicFactor = 0.0;
  pbr.roughnessFactor = static_cast<double>(look.roughness);
  pbr.baseColorFactor = {static_cast<double>(look.colour.red), static_cast<double>(look.colour.green),
                         static_cast<double>(look.colour.blue), 1.0};
  switch (look.substance) {
    case Substance::glass:
    case Substance::broken_glass:
    case Substance::crushed_glass:
      make_transparent(material, glass_ior, thickness_m);
      break;
    case Substance::water:
      make_transparent(material, water_ior, 0.01);
      break;
    case Substance::stone:
    case Substance::joint:
      break;
  }
  return material;
}

class Writer {
 public:
  explicit Writer(const Model& model) : materials_(shapes::materials_of(model)) {
    gltf_.asset.version = "2.0";
    gltf_.asset.generator = "shatterpave";
    gltf_.buffers.emplace_back();
    gltf_.scenes.emplace_back().name = model.name;
    gltf_.defaultScene = 0;
    const double thickness_m = model.panes.empty() ? 0.0 : model.panes.front().pane.thickness_mm / 1000.0;
    for (const shapes::Material& look : materials_.all) looks_.push_back(material_of(look, thickness_m));
    numbers_.assign(looks_.size(), -1);
    shapes::for_each_body(
        model, materials_, [&](const std::string& name, bool) { begin(name); },
        [&](shapes::Body&& body) { add(std::move(body)); });
    for (const char* name : {"KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_volume"}) {
      const auto has = [&](const tinygltf::Material& material) { return material.extensions.contains(name); };
      if (std::ranges::any_of(gltf_.materials, has)) gltf_.extensionsUsed.emplace_back(name);
    }
  }

  std::string bytes() {
    if (gltf_.buffers.front().data.empty()) throw InputError("target gltf: expected a body, got none: every piece is gone");
    std::ostringstream out;
    tinygltf::TinyGLTF writer;
    ENSURE(writer.WriteGltfSceneToStream(&gltf_, out, false, true));
    return std::move(out).str();
  }

 private:
  void begin(const std::string& name) {
    thing_ = static_cast<int>(gltf_.nodes.size());
    gltf_.nodes.emplace_back().name = name;
    gltf_.scenes.front().nodes.push_back(thing_);
    meshes_.clear();
  }

  void add(shapes::Body&& body) {
    tinygltf::Node node;
    node.name = body.name;
    node.mesh = mesh_of(body);
    node.extras = tinygltf::Value(tinygltf::Value::Object{{"kind", tinygltf::Value(body.kind)}});
    place(node, body.placing);
    gltf_.nodes[static_cast<std::size_t>(thing_)].children.push_back(static_cast<int>(gltf_.nodes.size()));
    gltf_.nodes.push_back(std::move(node));
  }

  static void place(tinygltf::Node& node, const shapes::Placing& placing) {
    const vec3 at = placing.at_mm / 1000.0;
    if (at != vec3{0.0, 0.0, 0.0}) node.translation = {at.x, at.y, at.z};
    if (placing.turn == shapes::Placing{}.turn) return;
    node.rotation = quaternion(placing.turn);
  }

  // Of a rotation's rows: x, y, z, w. By the largest of the four, so that nothing small is divided by.
  static std::vector<double> quaternion(const std::array<vec3, 3>& m) {
    const double trace = m[0].x + m[1].y + m[2].z;
    std::array<double, 4> q{};
    if (trace > 0.0) {
      const double s = 2.0 * std::sqrt(1.0 + trace);
      q = {(m[2].y - m[1].z) / s, (m[0].z - m[2].x) / s, (m[1].x - m[0].y) / s, 0.25 * s};
    } else if (m[0].x > m[1].y && m[0].x > m[2].z) {
      const double s = 2.0 * std::sqrt(1.0 + m[0].x - m[1].y - m[2].z);
      q = {0.25 * s, (m[0].y + m[1].x) / s, (m[0].z + m[2].x) / s, (m[2].y - m[1].z) / s};
    } else if (m[1].y > m[2].z) {
      const double s = 2.0 * std::sqrt(1.0 + m[1].y - m[0].x - m[2].z);
      q = {(m[0].y + m[1].x) / s, 0.25 * s, (m[1].z + m[2].y) / s, (m[0].z - m[2].x) / s};
    } else {
      const double s = 2.0 * std::sqrt(1.0 + m[2].z - m[0].x - m[1].y);
      q = {(m[0].z + m[2].x) / s, (m[1].z + m[2].y) / s, 0.25 * s, (m[1].x - m[0].y) / s};
    }
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
  }

  int mesh_of(const shapes::Body& body) {
    if (body.shared) {
      const auto found = meshes_.find(*body.shared);
      if (found != meshes_.end()) return found->second;
    }
    const int number = static_cast<int>(gltf_.meshes.size());
    tinygltf::Mesh& mesh = gltf_.meshes.emplace_back();
    mesh.name = body.name;
    for (const shapes::Piece& piece : body.pieces) mesh.primitives.push_back(primitive_of(piece));
    if (body.shared) meshes_.emplace(*body.shared, number);
    return number;
  }

  tinygltf::Primitive primitive_of(const shapes::Piece& piece) {
    const shapes::Mesh& mesh = piece.mesh;
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = number_of(piece.material);
    std::vector<float> values;
    const auto put = [&](vec3 v) {
      for (std::size_t axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(v[axis]) + 0.0F);
    };
    for (const vec3& p : mesh.points_mm) put(p / 1000.0);
    primitive.attributes["POSITION"] = vectors(values, 3, TINYGLTF_TYPE_VEC3, true);
    values.clear();
    for (const vec3& n : mesh.normals) put(n);
    primitive.attributes["NORMAL"] = vectors(values, 3, TINYGLTF_TYPE_VEC3, false);
    values.clear();
    for (const vec2& uv : mesh.uv_m) {
      values.push_back(static_cast<float>(uv.x));
      values.push_back(1.0F - static_cast<float>(uv.y));  // v of glTF runs down
    }
    primitive.attributes["TEXCOORD_0"] = vectors(values, 2, TINYGLTF_TYPE_VEC2, false);
    primitive.indices = indices(mesh.triangles, mesh.points_mm.size());
    return primitive;
  }

  // Materials that nothing is made of are left out.
  int number_of(std::size_t material) {
    if (numbers_[material] < 0) {
      numbers_[material] = static_cast<int>(gltf_.materials.size());
      gltf_.materials.push_back(looks_[material]);
    }
    return numbers_[material];
  }

  std::size_t view(const void* data, std::size_t bytes, int target) {
    auto& buffer = gltf_.buffers.front().data;
    buffer.resize((buffer.size() + 3) / 4 * 4, 0);
    tinygltf::BufferView& view = gltf_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    const auto* first = static_cast<const unsigned char*>(data);
    buffer.insert(buffer.end(), first, first + bytes);
    return gltf_.bufferViews.size() - 1;
  }

  int vectors(const std::vector<float>& values, std::size_t width, int type, bool with_range) {
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(view(values.data(), values.size() * sizeof(float), TINYGLTF_TARGET_ARRAY_BUFFER));
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = type;
    accessor.count = values.size() / width;
    if (with_range) {
      accessor.minValues.assign(width, std::numeric_limits<double>::infinity());
      accessor.maxValues.assign(width, -std::numeric_limits<double>::infinity());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<double>(values[i]);
        accessor.minValues[i % width] = std::min(accessor.minValues[i % width], value);
        accessor.maxValues[i % width] = std::max(accessor.maxValues[i % width], value);
      }
    }
    gltf_.accessors.push_back(std::move(accessor));
    return static_cast<int>(gltf_.accessors.size()) - 1;
  }

  int indices(const std::vector<std::uint32_t>& triangles, std::size_t points) {
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = triangles.size();
    if (points < 65535) {
      std::vector<std::uint16_t> narrow(triangles.begin(), triangles.end());
      accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
      accessor.bufferView = static_cast<int>(view(narrow.data(), 2 * narrow.size(), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER));
    } else {
      accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
      accessor.bufferView =
          static_cast<int>(view(triangles.data(), 4 * triangles.size(), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER));
    }
    gltf_.accessors.push_back(std::move(accessor));
    return static_cast<int>(gltf_.accessors.size()) - 1;
  }

  shapes::Materials materials_;
  tinygltf::Model gltf_;
  std::vector<tinygltf::Material> looks_;
  std::vector<int> numbers_;           // of each of them in the file; −1 as long as nothing is made of it
  std::map<std::size_t, int> meshes_;  // that bodies of the thing share
  int thing_ = 0;
};

}  // namespace

std::vector<OutputFile> gltf_files(const Model& model) { return {{model.name + ".glb", Writer(model).bytes()}}; }

void append(const Model& model, Outputs& outputs) {
  for (OutputFile& file : gltf_files(model)) outputs.files.push_back(std::move(file));
}

}  // namespace shatterpave::exporting::gltf
