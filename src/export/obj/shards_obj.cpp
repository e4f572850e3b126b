#include "export/obj/shards_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>

#include "core/error.h"
#include "core/vec.h"

namespace shatterpave::exporting::obj {

namespace {

using Buffer = fmt::memory_buffer;
using geometry::LatticePoint3;

// Clear glass, as far as the format can say it. Importers differ in what they make of it; Blender's takes d for how much of a
// thing is there at all, reflection (illum 3 to 9) without Ka for metal, refraction (illum 4, 6, 7, 9) for a blend of layers,
// Tf, which is the light that goes through, for its transmission, and Ns for its roughness, which others take from Pr. So it is
// all white light that goes through, and the slight green of window glass is in Kd; broken faces scatter a little.
constexpr std::string_view materials =
    "# Clear glass that refracts by Ni: all light goes through (Tf), nothing is cut out (d 1), nothing is metal (Ka 0, Pm 0).\n"
    "newmtl glass_old\nKa 0 0 0\nKd 0.97 0.99 0.98\nKs 0.5 0.5 0.5\nNs 1000\nNi 1.52\nd 1\nTf 1 1 1\nPr 0\nPm 0\n"
    "illum 2\n\n"
    "newmtl glass_broken\nKa 0 0 0\nKd 0.94 0.98 0.96\nKs 0.5 0.5 0.5\nNs 900\nNi 1.52\nd 1\nTf 1 1 1\nPr 0.05\nPm 0\n"
    "illum 2\n";

constexpr double mm_per_m = 1000.0;
// Normals are written in parts of this.
constexpr double normal_parts = 1e6;

// Lines of one kind, such as "vt", each written once for a shard and counted through the file.
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

// What stands lies on the lattice; what was moved lies anywhere.
void put_vertex(Buffer& out, vec3 p_mm, bool on_lattice) {
  fmt::format_to(std::back_inserter(out), "v");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double part = on_lattice ? to_m(geometry::to_lattice(p_mm[axis])) : p_mm[axis] / mm_per_m;
    fmt::format_to(std::back_inserter(out), " {}", part + 0.0);
  }
  out.push_back('\n');
}

// Along which axis the facet looks most.
std::size_t axis_of(vec3 normal) {
  const std::array<double, 3> parts{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  return static_cast<std::size_t>(std::ranges::max_element(parts) - parts.begin());
}

class ShardText {
 public:
  ShardText(Buffer& out, const glass::Shard& shard, Counts& counts)
      : out_(out), shard_(shard), first_(counts.vertices), places_(counts.places), normals_(counts.normals) {}

  void put_vertices(double thickness_mm) {
    const bool stands = shard_.motion == glass::Motion{};
    for (const LatticePoint3& vertex : shard_.solid.vertices) {
      put_vertex(out_, glass::moved(shard_.motion, glass::in_pane_mm(vertex, thickness_mm)), stands);
    }
  }
  void put_faces(glass::ShardSurface surface) {
    Buffer faces;
    for (const geometry::SolidTriangle& triangle : shard_.solid.triangles) {
      if (triangle.slot == static_cast<int>(surface)) put_face(faces, triangle);
    }
    if (faces.size() == 0) return;
    fmt::format_to(std::back_inserter(out_), "usemtl {}\n", surface == glass::ShardSurface::old ? "glass_old" : "glass_broken");
    out_.append(faces);
  }

 private:
  void put_face(Buffer& faces, const geometry::SolidTriangle& triangle) {
    const vec3 normal = geometry::normal(shard_.solid, triangle);
    const std::size_t axis = axis_of(normal);
    const std::size_t facing = normal_number(normal);
    fmt::format_to(std::back_inserter(faces), "f");
    for (const std::uint32_t corner : triangle.corners) {
      fmt::format_to(std::back_inserter(faces), " {}/{}/{}", first_ + corner + 1, place_number(corner, axis), facing);
    }
    faces.push_back('\n');
  }
  std::size_t normal_number(vec3 normal) {
    glass::Motion turn = shard_.motion;
    turn.shift_mm = {0.0, 0.0, 0.0};
    const vec3 turned = glass::moved(turn, normal);
    std::array<long long, 3> parts{};
    for (std::size_t i = 0; i < 3; ++i) parts[i] = std::llround(normal_parts * turned[i]);
    return normals_.number(parts, [&] {
      const auto part = [&](std::size_t i) { return static_cast<double>(parts[i]) / normal_parts; };
      fmt::format_to(std::back_inserter(out_), "vn {} {} {}\n", part(0), part(1), part(2));
    });
  }
  std::size_t place_number(std::uint32_t corner, std::size_t axis) {
    const LatticePoint3& p = shard_.solid.vertices[corner];
    const std::array<std::array<std::int64_t, 2>, 3> faced{{{p.y, p.z}, {p.x, p.z}, {p.x, p.y}}};
    return places_.number(faced[axis], [&] {
      const auto [u, v] = faced[axis];
      fmt::format_to(std::back_inserter(out_), "vt {} {}\n", to_m(u), to_m(v));
    });
  }

  Buffer& out_;
  const glass::Shard& shard_;
  std::size_t first_;
  Lines<std::array<std::int64_t, 2>> places_;
  Lines<std::array<long long, 3>> normals_;
};

void put_shard(Buffer& out, const BrokenPane& broken, const glass::Shard& shard, Counts& counts) {
  fmt::format_to(std::back_inserter(out), "o {0}.{1}\ng {0}.{1}\n", broken.pane.name, shard.id);
  ShardText text(out, shard, counts);
  text.put_vertices(broken.pane.thickness_mm);
  text.put_faces(glass::ShardSurface::old);
  text.put_faces(glass::ShardSurface::broken);
  counts.vertices += shard.solid.vertices.size();
}

[[noreturn]] void refuse_empty(const Model& model) {
  std::string names;
  for (const BrokenPane& broken : model.panes) {
    if (broken.pane.shards) names += (names.empty() ? "" : ", ") + broken.pane.name;
  }
  throw InputError(fmt::format(
      "target obj: expected a shard that stands or has fallen, got none: every piece of {} is gone, or is a splinter "
      "(see missing, missing_mm, held, fallen and splinter_mm2 of [pane.shards])",
      names));
}

}  // namespace

void require_shards(const Things& things) {
  if (std::ranges::any_of(things.panes, [](const glass::Pane& pane) { return pane.shards.has_value(); })) return;
  throw InputError(
      fmt::format("target obj: expected a pane with a table [pane.shards], whose pieces are what it writes, got {}",
                  things.panes.empty() ? "no pane" : "none with it"));
}

std::vector<OutputFile> obj_files(const Model& model) {
  std::vector<glass::Pane> panes;
  for (const BrokenPane& broken : model.panes) panes.push_back(broken.pane);
  require_shards({panes, {}});
  Buffer out;
  fmt::format_to(std::back_inserter(out), "# Shards of glass: an object and a group each. 1 unit = 1 m, y up.\nmtllib {}.mtl\n",
                 model.name);
  Counts counts;
  for (const BrokenPane& broken : model.panes) {
    for (const glass::Shard& shard : broken.shards) {
      if (shard.state != glass::ShardState::missing) put_shard(out, broken, shard, counts);
    }
  }
  if (counts.vertices == 0) refuse_empty(model);
  return {{model.name + ".obj", fmt::to_string(out)}, {model.name + ".mtl", std::string(materials)}};
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(obj_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::obj
