#include "export/obj/bodies_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/vec.h"
#include "export/shapes/bodies.h"
#include "export/shapes/meshes_of.h"
#include "geometry/lattice.h"

namespace shatterpave::exporting::obj {

namespace {

using Buffer = fmt::memory_buffer;
using shapes::Substance;

// Glass as far as the format can say it. Importers differ in what they make of it; Blender's takes d for how much of a thing is
// there at all, reflection (illum 3 to 9) without Ka for metal, refraction (illum 4, 6, 7, 9) for a blend of layers, Tf, which
// is the light that goes through, for its transmission, and Ns for its roughness, which others take from Pr. So it is all white
// light that goes through, and the slight green of window glass is in Kd; broken faces scatter a little.
constexpr std::string_view glass_pattern =
    "newmtl {}\nKa 0 0 0\nKd {}\nKs 0.5 0.5 0.5\nNs {}\nNi {}\nd 1\nTf 1 1 1\nPr {}\nPm 0\nillum 2\n\n";

// Blender takes the roughness for 1 − √(Ns / 1000).
double exponent(double roughness) { return 1000.0 * (1.0 - roughness) * (1.0 - roughness); }

std::string text_of(const shapes::Material& material) {
  switch (material.substance) {
    case Substance::glass:
      return fmt::format(fmt::runtime(glass_pattern), material.name, "0.97 0.99 0.98", 1000, 1.52, 0);
    case Substance::broken_glass:
      return fmt::format(fmt::runtime(glass_pattern), material.name, "0.94 0.98 0.96", 900, 1.52, 0.05);
    case Substance::crushed_glass:
      return fmt::format(fmt::runtime(glass_pattern), material.name, "0.95 0.97 0.96", 10, 1.52, 0.9);
    case Substance::water:
      return fmt::format(fmt::runtime(glass_pattern), material.name, "0.98 0.99 0.99", 960, 1.33, 0.02);
    case Substance::stone:
    case Substance::joint:
      break;
  }
  const shapes::Colour& c = material.colour;
  const auto roughness = static_cast<double>(material.roughness);
  return fmt::format(
      "newmtl {}\nKa 0 0 0\nKd {:.4f} {:.4f} {:.4f}\nKs 0.5 0.5 0.5\nNs {:.1f}\nd 1\nPr {:.3f}\nPm 0\nillum 2\n\n",
      material.name, c.red, c.green, c.blue, exponent(roughness), roughness);
}

constexpr double mm_per_m = 1000.0;
// Normals, and places in textures in metres, are written in parts of this.
constexpr double parts = 1e6;

// Lines of one kind, such as "vt", each written once for a body and counted through the file.
template <typename Key>
class Lines {
 public:
  explicit Lines(std::size_t& count) : count_(count) {}
  // The number of the line, which `put` writes where it is new.
  template <typename Put>
  std::size_t number(const Key& key, const Put& put) {
    const auto [line, is_new] = numbers_.try_emplace(key, count_ + 1);
    if (is_new) {
      put();
      ++count_;
    }
    return line->second;
  }

 private:
  std::size_t& count_;
  std::map<Key, std::size_t> numbers_;
};

// Numbers of lines so far: OBJ counts from 1, through the file.
struct Counts {
  std::size_t vertices = 0;
  std::size_t places = 0;
  std::size_t normals = 0;
};

// One division, so that the shortest number that reads back is the one with whole µm.
double to_m(std::int64_t coordinate) { return static_cast<double>(coordinate) / (geometry::lattice_per_mm * mm_per_m); }

long long in_parts(double value) { return std::llround(parts * value); }
double of_parts(long long value) { return static_cast<double>(value) / parts; }

class BodyText {
 public:
  BodyText(Buffer& out, const shapes::Placing& placing, Counts& counts)
      : out_(out),
        placing_(placing),
        is_upright_(placing.turn == shapes::Placing{}.turn),
        vertices_(counts.vertices),
        places_(counts.places),
        normals_(counts.normals) {}

  void put(const shapes::Piece& piece, std::string_view material) {
    const shapes::Mesh& mesh = piece.mesh;
    std::vector<std::array<std::size_t, 3>> numbers(mesh.points_mm.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = {vertex(mesh.points_mm[i]), place(mesh.uv_m[i]), normal(mesh.normals[i])};
    }
    fmt::format_to(std::back_inserter(out_), "usemtl {}\n", material);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const auto& a = numbers[mesh.triangles[i]];
      const auto& b = numbers[mesh.triangles[i + 1]];
      const auto& c = numbers[mesh.triangles[i + 2]];
      // Two corners that rounding brought together are one: the facet has no area.
      if (a[0] == b[0] || b[0] == c[0] || c[0] == a[0]) continue;
      fmt::format_to(std::back_inserter(out_), "f {}/{}/{} {}/{}/{} {}/{}/{}\n", a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1],
                     c[2]);
    }
  }

 private:
  std::size_t vertex(vec3 own_mm) {
    std::array<std::int64_t, 3> key{};
    const vec3 at_mm = placing_(own_mm);
    // What is turned lies anywhere: it is told apart where it was before that.
    for (std::size_t axis = 0; axis < 3; ++axis) key.at(axis) = geometry::to_lattice((is_upright_ ? at_mm : own_mm)[axis]);
    return vertices_.number(key, [&] {
      fmt::format_to(std::back_inserter(out_), "v");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double part = is_upright_ ? to_m(key.at(axis)) : at_mm[axis] / mm_per_m;
        fmt::format_to(std::back_inserter(out_), " {}", part + 0.0);
      }
      out_.push_back('\n');
    });
  }
  std::size_t normal(vec3 own) {
    const vec3 turned = placing_.turned(own);
    const std::array<long long, 3> key{in_parts(turned.x), in_parts(turned.y), in_parts(turned.z)};
    return normals_.number(key, [&] {
      fmt::format_to(std::back_inserter(out_), "vn {} {} {}\n", of_parts(key[0]), of_parts(key[1]), of_parts(key[2]));
    });
  }
  std::size_t place(vec2 uv_m) {
    const std::array<long long, 2> key{in_parts(uv_m.x), in_parts(uv_m.y)};
    return places_.number(key,
                          [&] { fmt::format_to(std::back_inserter(out_), "vt {} {}\n", of_parts(key[0]), of_parts(key[1])); });
  }

  Buffer& out_;
  const shapes::Placing& placing_;
  bool is_upright_;
  Lines<std::array<std::int64_t, 3>> vertices_;
  Lines<std::array<long long, 2>> places_;
  Lines<std::array<long long, 3>> normals_;
};

[[noreturn]] void refuse_empty(const Model& model) {
  std::string names;
  for (const BrokenPane& broken : model.panes) names += (names.empty() ? "" : ", ") + broken.pane.name;
  throw InputError(fmt::format(
      "target obj: expected a shard that stands or has fallen, got none: every piece of {} is gone, or is a splinter "
      "(see missing, missing_mm, held, fallen and splinter_mm2 of [pane.shards])",
      names));
}

}  // namespace

std::vector<OutputFile> obj_files(const Model& model) {
  const shapes::Materials materials = shapes::materials_of(model);
  Buffer out;
  fmt::format_to(std::back_inserter(out), "# An object and a group for each body. 1 unit = 1 m, y up.\nmtllib {}.mtl\n",
                 model.name);
  Counts counts;
  shapes::SharedPieces shared;
  shapes::for_each_body(
      model, materials, [&](const std::string&, bool) { shared.begin_thing(); },
      [&](shapes::Body&& body) {
        fmt::format_to(std::back_inserter(out), "o {0}\ng {0}\n", body.name);
        BodyText text(out, body.placing, counts);
        for (const shapes::Piece& piece : shared.of(body)) text.put(piece, materials.all[piece.material].name);
      });
  if (counts.vertices == 0) refuse_empty(model);
  std::string mtl =
      "# Clear glass that refracts by Ni: all light goes through (Tf), nothing is cut out (d 1), nothing is metal (Ka 0, Pm "
      "0).\n";
  for (const shapes::Material& material : materials.all) mtl += text_of(material);
  return {{model.name + ".obj", fmt::to_string(out)}, {model.name + ".mtl", std::move(mtl)}};
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(obj_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::obj
