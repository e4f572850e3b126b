#include "export/obj/shards_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.h"

namespace shatterpave::exporting {

namespace {

using Buffer = fmt::memory_buffer;

// Window glass: its edges are greener than its faces, and broken ones scatter a little.
constexpr std::string_view materials =
    "newmtl glass_old\nKd 0.80 0.92 0.86\nKs 0.5 0.5 0.5\nNs 900\nNi 1.52\nd 0.1\nTf 0.94 0.98 0.96\nillum 7\n\n"
    "newmtl glass_broken\nKd 0.78 0.92 0.85\nKs 0.5 0.5 0.5\nNs 200\nNi 1.52\nd 0.2\nTf 0.90 0.97 0.93\nillum 7\n";

void put_vertex(Buffer& out, vec3 p_mm) {
  const vec3 p{geometry::to_mm(geometry::to_lattice(p_mm.x)), geometry::to_mm(geometry::to_lattice(p_mm.y)),
               geometry::to_mm(geometry::to_lattice(p_mm.z))};
  fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p.x + 0.0, p.y + 0.0, p.z + 0.0);
}

void put_faces(Buffer& out, const geometry::Solid& solid, glass::ShardSurface surface, std::size_t first) {
  fmt::format_to(std::back_inserter(out), "usemtl {}\n", surface == glass::ShardSurface::old ? "glass_old" : "glass_broken");
  for (const geometry::SolidTriangle& triangle : solid.triangles) {
    if (triangle.slot != static_cast<int>(surface)) continue;
    fmt::format_to(std::back_inserter(out), "f {} {} {}\n", first + triangle.corners[0], first + triangle.corners[1],
                   first + triangle.corners[2]);
  }
}

void put_shard(Buffer& out, const BrokenPane& broken, const glass::Shard& shard, std::size_t first) {
  fmt::format_to(std::back_inserter(out), "o {0}.{1}\ng {0}.{1}\n", broken.pane.name, shard.id);
  for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
    put_vertex(out, glass::moved(shard.motion, glass::in_pane_mm(vertex, broken.pane.thickness_mm)));
  }
  put_faces(out, shard.solid, glass::ShardSurface::old, first);
  put_faces(out, shard.solid, glass::ShardSurface::broken, first);
}

}  // namespace

std::vector<OutputFile> obj_files(const Model& model) {
  if (std::ranges::none_of(model.panes, [](const BrokenPane& broken) { return broken.pane.shards.has_value(); })) {
    throw InputError("target obj: expected a pane with a table [pane.shards], got none");
  }
  Buffer out;
  fmt::format_to(std::back_inserter(out),
                 "# Shards of glass: an object and a group each. 1 unit = 1 mm, y up.\nmtllib {}.mtl\n", model.name);
  std::size_t first = 1;  // OBJ counts from 1, through the file
  for (const BrokenPane& broken : model.panes) {
    for (const glass::Shard& shard : broken.shards) {
      if (shard.state == glass::ShardState::missing) continue;
      put_shard(out, broken, shard, first);
      first += shard.solid.vertices.size();
    }
  }
  return {{model.name + ".obj", fmt::to_string(out)}, {model.name + ".mtl", std::string(materials)}};
}

}  // namespace shatterpave::exporting
