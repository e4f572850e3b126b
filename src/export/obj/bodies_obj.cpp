#include "export/obj/bodies_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/vec.h"
#include "export/shapes/bodies.h"
#include "export/shapes/meshes_of.h"
#include "geometry/lattice.h"

namespace shatterpave::exporting::obj {

namespace {

using Buffer = std::string;
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
constexpr int lattice_digits = 6;  // of metres in lattice steps, which are µm
static_assert(geometry::lattice_per_mm * mm_per_m == 1e6);
// After the point: fewer make triangles of no area in textures, and normals that no longer are what their faces' are.
constexpr int normal_digits = 6;
constexpr int place_digits = 6;

constexpr std::int64_t power_of_ten(int digits) { return digits == 0 ? 1 : 10 * power_of_ten(digits - 1); }

std::int64_t in_parts(double value, int digits) { return std::llround(static_cast<double>(power_of_ten(digits)) * value); }

// A space, and `value` over that power of ten without zeros at its end.
void append_decimal(Buffer& out, std::int64_t value, int digits) {
  std::array<char, 24> text{};
  char* const end = text.data() + text.size();
  char* at = end;
  bool is_needed = false;
  std::uint64_t rest = value < 0 ? 0U - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  for (int k = 0; k < digits; ++k, rest /= 10U) {
    const auto digit = static_cast<char>('0' + static_cast<char>(rest % 10U));
    is_needed = is_needed || digit != '0';
    if (is_needed) *--at = digit;
  }
  if (is_needed) *--at = '.';
  do {
    *--at = static_cast<char>('0' + static_cast<char>(rest % 10U));
    rest /= 10U;
  } while (rest != 0);
  if (value < 0) *--at = '-';
  *--at = ' ';
  out.append(at, end);
}

// Lines of one kind, such as "vt", each written once for a body and counted through the file: a table of hashes with a place
// for each line, at most half full. Numbers are given in the order in which lines come, so that nothing else shows in the file.
template <std::size_t Size>
class Lines {
 public:
  using Key = std::array<std::int64_t, Size>;

  explicit Lines(std::size_t& count) : count_(count), first_(count) {}
  // The number of the line, which `put` writes where it is new.
  template <typename Put>
  std::size_t number(const Key& key, const Put& put) {
    if (2 * (keys_.size() + 1) > slots_.size()) grow();
    std::uint32_t& slot = slots_[slot_of(key)];
    if (slot == 0) {
      keys_.push_back(key);
      slot = static_cast<std::uint32_t>(keys_.size());
      put();
      ++count_;
    }
    return first_ + slot;
  }

 private:
  // The place that holds the key, or else the free one for it.
  std::size_t slot_of(const Key& key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash(key) & mask;
    while (slots_[at] != 0 && keys_[slots_[at] - 1] != key) at = (at + 1) & mask;
    return at;
  }
  // Rounds of the finaliser of MurmurHash3.
  static std::size_t hash(const Key& key) {
    std::uint64_t mixed = 0;
    for (const std::int64_t part : key) {
      mixed ^= static_cast<std::uint64_t>(part);
      mixed = (mixed ^ (mixed >> 33U)) * 0xff51afd7ed558ccdULL;
      mixed ^= mixed >> 33U;
    }
    return mixed;
  }
  void grow() {
    constexpr std::size_t least = 64;
    ENSURE(keys_.size() < std::numeric_limits<std::uint32_t>::max());
    slots_.assign(std::max(least, 2 * slots_.size()), 0);
    for (std::size_t k = 0; k < keys_.size(); ++k) slots_[slot_of(keys_[k])] = static_cast<std::uint32_t>(k + 1);
  }

  std::size_t& count_;
  std::size_t first_;                 // lines before those of the body
  std::vector<std::uint32_t> slots_;  // the number of a line of the body; 0 is free
  std::vector<Key> keys_;             // of its lines
};

// Numbers of lines so far: OBJ counts from 1, through the file.
struct Counts {
  std::size_t vertices = 0;
  std::size_t places = 0;
  std::size_t normals = 0;
};

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
      out_.push_back('v');
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (is_upright_) {
          append_decimal(out_, key.at(axis), lattice_digits);
        } else {
          fmt::format_to(std::back_inserter(out_), " {}", at_mm[axis] / mm_per_m + 0.0);
        }
      }
      out_.push_back('\n');
    });
  }
  std::size_t normal(vec3 own) {
    const vec3 turned = placing_.turned(own);
    const std::array<std::int64_t, 3> key{in_parts(turned.x, normal_digits), in_parts(turned.y, normal_digits),
                                          in_parts(turned.z, normal_digits)};
    return normals_.number(key, [&] { append_line("vn", key, normal_digits); });
  }
  std::size_t place(vec2 uv_m) {
    const std::array<std::int64_t, 2> key{in_parts(uv_m.x, place_digits), in_parts(uv_m.y, place_digits)};
    return places_.number(key, [&] { append_line("vt", key, place_digits); });
  }
  template <std::size_t Size>
  void append_line(std::string_view word, const std::array<std::int64_t, Size>& values, int digits) {
    out_.append(word);
    for (const std::int64_t value : values) append_decimal(out_, value, digits);
    out_.push_back('\n');
  }

  Buffer& out_;
  const shapes::Placing& placing_;
  bool is_upright_;
  Lines<3> vertices_;
  Lines<2> places_;
  Lines<3> normals_;
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
  std::vector<OutputFile> files;
  files.push_back({model.name + ".obj", std::move(out)});
  files.push_back({model.name + ".mtl", std::move(mtl)});
  return files;
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(obj_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::obj
