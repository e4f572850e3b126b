#include "export/gltf/scene_gltf.h"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/sha256.h"
#include "export/gltf/container.h"
#include "export/shapes/bodies.h"
#include "export/shapes/optics.h"
#include "export/shapes/quaternion.h"
#include "export/shapes/stage.h"
#include "export/shapes/tangents.h"
#include "export/swatches/swatches.h"

namespace shatterpave::exporting::gltf {

namespace {

using shapes::Substance;

static_assert(std::endian::native == std::endian::little);

// Lengths in a .glb are of 32 bits; what is left is for its JSON.
constexpr std::size_t most_bytes = 3'800'000'000;

using shapes::attenuation_colour;
using shapes::attenuation_m;
using shapes::glass_ior;
using shapes::water_ior;

// Light of radiance 1 is 1 W/(m² sr), and a watt is so many lumens, as Blender and others have it who have no photometry: with
// the format's own unit, the sun is then as bright as it is in the other targets.
constexpr double lux_per_irradiance = 683.0;
constexpr double nearest_m = 0.001;
constexpr double farthest_m = 10'000.0;  // by eye: beyond all that a scene holds

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

// Lengths of places: whole µm, so that they are short.
double in_m(double mm) { return std::round(mm * 1000.0) / 1e6 + 0.0; }

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

bool is_glass(Substance substance) {
  return substance == Substance::glass || substance == Substance::broken_glass || substance == Substance::crushed_glass;
}

class Writer {
 public:
  Writer(const Model& model, const SwatchFiles& pictures)
      : model_(model), pictures_(pictures), materials_(shapes::materials_of(model)), textures_(materials_.swatches.size()) {
    gltf_.asset.version = "2.0";
    gltf_.asset.generator = "shatterpave";
    gltf_.buffers.emplace_back();
    gltf_.scenes.emplace_back().name = model.name;
    gltf_.defaultScene = 0;
    std::size_t panes = 0;
    shapes::for_each_body(
        model, materials_,
        [&](const std::string& name, bool is_pane) {
          begin(name);
          thickness_mm_ = is_pane ? model.panes[panes++].pane.thickness_mm : 0.0;
        },
        [&](shapes::Body&& body) { add(std::move(body)); });
    add_stage(shapes::stage_of(model));
    for (const char* name : {"KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_volume"}) {
      const auto has = [&](const tinygltf::Material& material) { return material.extensions.contains(name); };
      if (std::ranges::any_of(gltf_.materials, has)) gltf_.extensionsUsed.emplace_back(name);
    }
  }

  std::string bytes() {
    if (data_.size() == 0) throw InputError("target gltf: expected a body, got none: every piece is gone");
    const std::string json = json_text();
    gltf_ = {};
    return container(json, data_);
  }

 private:
  // What the library makes of the scene, with the length of the data, which it does not hold.
  std::string json_text() {
    std::ostringstream out;
    tinygltf::TinyGLTF writer;
    ENSURE(writer.WriteGltfSceneToStream(&gltf_, out, false, true));
    const std::string text = std::move(out).str();
    constexpr std::size_t head = 20;  // of the container and of its JSON
    std::string json = text.substr(head);
    constexpr std::string_view empty = R"("buffers":[{"byteLength":0}])";
    const std::size_t at = json.find(empty);
    ENSURE(at != std::string::npos);
    return json.replace(at, empty.size(), fmt::format(R"("buffers":[{{"byteLength":{}}}])", data_.size()));
  }

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
    if (!body.is_seen) node.scale = {0.0, 0.0, 0.0};
    if (!body.path.empty()) animate("fall", static_cast<int>(gltf_.nodes.size()), body.placing, body.path);
    gltf_.nodes[static_cast<std::size_t>(thing_)].children.push_back(static_cast<int>(gltf_.nodes.size()));
    gltf_.nodes.push_back(std::move(node));
  }

  // Keys of the node at each frame of the shot, in the animation of that name. One that is not to be seen is as small as
  // nothing, where it was last.
  void animate(const std::string& name, int node, const shapes::Placing& first,
               const std::vector<std::optional<shapes::Placing>>& path) {
    std::vector<float> shifts;
    std::vector<float> turns;
    std::vector<float> sizes;
    shapes::Placing last = first;
    std::vector<double> last_turn = rotation(last);
    for (const std::optional<shapes::Placing>& placing : path) {
      last = placing.value_or(last);
      for (std::size_t axis = 0; axis < 3; ++axis) shifts.push_back(static_cast<float>(in_m(last.at_mm[axis])));
      std::vector<double> turn = rotation(last);
      // A turn has two quaternions: the one that is nearer to that before, so that what is between two keys is too.
      double along = 0.0;
      for (std::size_t i = 0; i < turn.size(); ++i) along += turn[i] * last_turn[i];
      for (double& part : turn) turns.push_back(static_cast<float>(part = along < 0.0 ? -part : part) + 0.0F);
      last_turn = std::move(turn);
      sizes.insert(sizes.end(), 3, placing ? 1.0F : 0.0F);
    }
    if (gltf_.animations.empty()) {
      std::vector<float> times;
      for (std::size_t i = 0; i < path.size(); ++i) {
        times.push_back(static_cast<float>(static_cast<double>(i) / model_.shot->per_second));
      }
      times_ = vectors(times, 1, TINYGLTF_TYPE_SCALAR, true, 0);
    }
    if (gltf_.animations.empty() || gltf_.animations.back().name != name) gltf_.animations.emplace_back().name = name;
    add_channel(node, "translation", "LINEAR", vectors(shifts, 3, TINYGLTF_TYPE_VEC3, false, 0));
    add_channel(node, "rotation", "LINEAR", vectors(turns, 4, TINYGLTF_TYPE_VEC4, false, 0));
    const bool is_always_seen = std::ranges::all_of(path, [](const auto& placing) { return placing.has_value(); });
    if (!is_always_seen) add_channel(node, "scale", "STEP", vectors(sizes, 3, TINYGLTF_TYPE_VEC3, false, 0));
  }

  // To the animation that was begun last.
  void add_channel(int node, const char* path, const char* between, int values) {
    tinygltf::Animation& animation = gltf_.animations.back();
    tinygltf::AnimationSampler sampler;
    sampler.input = times_;
    sampler.output = values;
    sampler.interpolation = between;
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size());
    channel.target_node = node;
    channel.target_path = path;
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  }

  void add_stage(const shapes::Stage& stage) {
    tinygltf::Camera& camera = gltf_.cameras.emplace_back();
    camera.name = "camera";
    camera.type = "perspective";
    camera.perspective.aspectRatio = studio::aspect_of(stage.camera);
    camera.perspective.yfov =
        studio::upright_field_of_view(stage.camera.field_of_view, camera.perspective.aspectRatio).radians();
    camera.perspective.znear = nearest_m;
    camera.perspective.zfar = farthest_m;  // the library writes it in any case
    tinygltf::Node seen_from;
    seen_from.name = camera.name;
    seen_from.camera = 0;
    place(seen_from, shapes::placing_of(stage.camera));
    if (!stage.camera_path.empty()) {
      const shapes::Placing still = shapes::placing_of(stage.camera);
      animate("camera", static_cast<int>(gltf_.nodes.size()), still, shapes::camera_placings(stage));
    }
    add_to_scene(std::move(seen_from));

    if (!stage.light.sun) return;
    tinygltf::Light& sun = gltf_.lights.emplace_back();
    sun.name = "sun";
    sun.type = "directional";
    sun.color = {1.0, 1.0, 1.0};
    sun.intensity = lux_per_irradiance * studio::noon_irradiance * stage.light.sun->gain * studio::exposure_factor(stage.light);
    tinygltf::Node shines;
    shines.name = sun.name;
    shines.extensions["KHR_lights_punctual"] = tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(0)}});
    place(shines, shapes::placing_of(*stage.light.sun));
    add_to_scene(std::move(shines));
  }

  void add_to_scene(tinygltf::Node&& node) {
    gltf_.scenes.front().nodes.push_back(static_cast<int>(gltf_.nodes.size()));
    gltf_.nodes.push_back(std::move(node));
  }

  static void place(tinygltf::Node& node, const shapes::Placing& placing) {
    const vec3 at{in_m(placing.at_mm.x), in_m(placing.at_mm.y), in_m(placing.at_mm.z)};
    if (at != vec3{0.0, 0.0, 0.0}) node.translation = {at.x, at.y, at.z};
    if (placing.turn == shapes::Placing{}.turn) return;
    node.rotation = rotation(placing);
  }

  // Of a turn: x, y, z, w. To nine digits, so that they are short: 100 m away that is a tenth of a µm.
  static std::vector<double> rotation(const shapes::Placing& placing) {
    std::vector<double> parts;
    for (const double part : shapes::quaternion(placing)) parts.push_back(std::round(part * 1e9) / 1e9 + 0.0);
    return parts;
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
    const auto& swatch = materials_.all[piece.material].swatch;
    const double side_m = swatch ? materials_.swatches[swatch->swatch].side_m : 1.0;
    for (const vec2& uv : mesh.uv_m) {
      values.push_back(static_cast<float>(uv.x / side_m));
      values.push_back(static_cast<float>(1.0 - uv.y / side_m));  // v of glTF runs down
    }
    primitive.attributes["TEXCOORD_0"] = vectors(values, 2, TINYGLTF_TYPE_VEC2, false);
    if (swatch) {
      values.clear();
      for (const shapes::Tangent& tangent : shapes::tangents(mesh)) {
        put(tangent.along);
        values.push_back(tangent.is_mirrored ? -1.0F : 1.0F);
      }
      primitive.attributes["TANGENT"] = vectors(values, 4, TINYGLTF_TYPE_VEC4, false);
    }
    primitive.indices = indices(mesh.triangles, mesh.points_mm.size());
    return primitive;
  }

  // Of a material of the model in the file; one that nothing is made of is left out. Glass is as thick as the pane: of panes
  // that differ in that each has its own.
  int number_of(std::size_t material) {
    const shapes::Material& look = materials_.all[material];
    const double thickness_mm = is_glass(look.substance) ? thickness_mm_ : 0.0;
    const auto [found, is_new] = numbers_.try_emplace({material, thickness_mm}, static_cast<int>(gltf_.materials.size()));
    if (!is_new) return found->second;
    tinygltf::Material made = material_of(look, thickness_mm / 1000.0);
    const auto same = std::ranges::count_if(numbers_, [&](const auto& entry) { return entry.first.first == material; });
    if (same > 1) made.name += "_" + std::to_string(same);
    if (look.swatch) put_textures(made, *look.swatch);
    gltf_.materials.push_back(std::move(made));
    return found->second;
  }

  // Numbers of the textures of a swatch.
  struct Textures {
    int base_color = -1;
    int normal = -1;
    int surface = -1;  // occlusion, roughness, metallic
  };

  void put_textures(tinygltf::Material& material, const shapes::SwatchUse& use) {
    const Textures& textures = textures_of(use.swatch);
    auto& pbr = material.pbrMetallicRoughness;
    pbr.baseColorFactor = {static_cast<double>(use.tint.red), static_cast<double>(use.tint.green),
                           static_cast<double>(use.tint.blue), 1.0};
    pbr.roughnessFactor = static_cast<double>(use.roughness);
    pbr.baseColorTexture.index = textures.base_color;
    pbr.metallicRoughnessTexture.index = textures.surface;
    material.occlusionTexture.index = textures.surface;
    material.normalTexture.index = textures.normal;
  }

  const Textures& textures_of(std::size_t swatch) {
    std::optional<Textures>& textures = textures_[swatch];
    if (textures) return *textures;
    const shapes::Swatch& asked = materials_.swatches[swatch];
    const swatches::Files files = pictures_(asked, model_.seed);
    textures = {texture_of(files.base_color), texture_of(files.normal), texture_of(files.occlusion_roughness_metallic)};
    return *textures;
  }

  int texture_of(const swatches::PictureFile& file) {
    tinygltf::Image image;
    image.name = file.name.substr(0, file.name.rfind('.'));
    image.mimeType = file.media_type;
    image.bufferView = static_cast<int>(view(file.bytes.data(), file.bytes.size(), 0));
    tinygltf::Texture texture;
    texture.source = static_cast<int>(gltf_.images.size());
    texture.sampler = sampler();
    gltf_.images.push_back(std::move(image));
    gltf_.textures.push_back(std::move(texture));
    return static_cast<int>(gltf_.textures.size()) - 1;
  }

  int sampler() {
    if (gltf_.samplers.empty()) {
      tinygltf::Sampler& sampler = gltf_.samplers.emplace_back();
      sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
      sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
      sampler.wrapS = TINYGLTF_TEXTURE_WRAP_REPEAT;
      sampler.wrapT = TINYGLTF_TEXTURE_WRAP_REPEAT;
    }
    return 0;
  }

  std::size_t view(const void* data, std::size_t bytes, int target) {
    data_.align();
    if (data_.size() + bytes > most_bytes) {
      throw InputError("target gltf: expected at most 4 GB, which its format holds, got more");
    }
    tinygltf::BufferView& view = gltf_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = data_.size();
    view.byteLength = bytes;
    if (target != 0) view.target = target;
    data_.append(data, bytes);
    return gltf_.bufferViews.size() - 1;
  }

  int vectors(const std::vector<float>& values, std::size_t width, int type, bool with_range,
              int target = TINYGLTF_TARGET_ARRAY_BUFFER) {
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(view(values.data(), values.size() * sizeof(float), target));
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

  // Meshes whose points are connected alike, as those of many stones are, have it once in the file.
  int indices(const std::vector<std::uint32_t>& triangles, std::size_t points) {
    std::string bytes;
    const bool is_narrow = points < 65535;
    if (is_narrow) {
      const std::vector<std::uint16_t> narrow(triangles.begin(), triangles.end());
      bytes.assign(reinterpret_cast<const char*>(narrow.data()), 2 * narrow.size());
    } else {
      bytes.assign(reinterpret_cast<const char*>(triangles.data()), 4 * triangles.size());
    }
    const auto [found, is_new] = indices_.try_emplace(sha256(bytes), static_cast<int>(gltf_.accessors.size()));
    if (!is_new) return found->second;
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = triangles.size();
    accessor.componentType = is_narrow ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.bufferView = static_cast<int>(view(bytes.data(), bytes.size(), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER));
    gltf_.accessors.push_back(std::move(accessor));
    return found->second;
  }

  const Model& model_;
  const SwatchFiles& pictures_;
  shapes::Materials materials_;
  tinygltf::Model gltf_;
  Data data_;                                              // of its only buffer
  std::map<std::pair<std::size_t, double>, int> numbers_;  // in the file, of materials and thicknesses
  std::vector<std::optional<Textures>> textures_;          // of each swatch, where something is made of it
  std::map<std::string, int> indices_;                     // accessors, by the sum of what they hold
  double thickness_mm_ = 0.0;                              // of the pane that is being written
  std::map<std::size_t, int> meshes_;                      // that bodies of the thing share
  int thing_ = 0;
  int times_ = 0;  // accessor of the frames of the shot, in s
};

}  // namespace

OutputFile gltf_file(const Model& model, const SwatchFiles& pictures) {
  return {model.name + ".glb", Writer(model, pictures).bytes()};
}

std::vector<OutputFile> gltf_files(const Model& model) {
  const auto drawn = [](const shapes::Swatch& swatch, std::uint64_t seed) {
    return swatches::files(swatches::drawn(swatch, seed), swatch.name);
  };
  return {gltf_file(model, drawn)};
}

void append(const Model& model, Outputs& outputs) {
  for (OutputFile& file : gltf_files(model)) outputs.files.push_back(std::move(file));
}

}  // namespace shatterpave::exporting::gltf
