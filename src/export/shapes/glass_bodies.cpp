#include "export/shapes/glass_bodies.h"

#include <fmt/format.h>

#include <utility>

#include "core/parallel.h"
#include "export/names.h"
#include "export/shapes/glass_meshes.h"
#include "export/shapes/mesh_parts.h"
#include "export/shapes/tubes.h"
#include "geometry/bend.h"

namespace shatterpave::exporting::shapes {

namespace {

constexpr std::size_t shards_at_once = 256;

// ---- shards

Body shard_body(const BrokenPane& broken, const glass::Shard& shard, std::size_t first_material) {
  const geometry::Bend bend = glass::bend_of(broken.pane);
  Body body;
  body.name = fmt::format("{}.{}", broken.pane.name, shard.id);
  body.kind = fmt::format("shard {}", name_of(shard.state));
  const vec2 middle = geometry::on_lattice(geometry::centroid(shard.face.outline));
  const vec3 pivot = bend.point({middle.x, middle.y, 0.0});
  for (const glass::ShardSurface slot : {glass::ShardSurface::old, glass::ShardSurface::broken}) {
    Piece piece{first_material + static_cast<std::size_t>(slot),
                bent(shard_mesh(shard, slot, broken.pane.thickness_mm), bend, bent_shard_bound_mm)};
    for (vec3& p : piece.mesh.points_mm) p -= pivot;
    if (!piece.mesh.triangles.empty()) body.pieces.push_back(std::move(piece));
  }
  const auto placing = [&](const glass::Motion& motion) { return Placing{motion.rows, glass::moved(motion, pivot)}; };
  body.placing = placing(shard.motion);
  body.is_seen = shard.state != glass::ShardState::missing;
  if (const auto found = broken.paths.find(shard.id); found != broken.paths.end()) {
    for (const glass::ShardPlace& place : found->second) {
      const bool is_seen = place.state != glass::ShardState::missing;
      body.path.push_back(is_seen ? std::optional(placing(place.motion)) : std::nullopt);
    }
  }
  return body;
}

// Whether the shard is to be seen, now or on its way.
bool is_there(const BrokenPane& broken, const glass::Shard& shard) {
  if (shard.state != glass::ShardState::missing) return true;
  const auto found = broken.paths.find(shard.id);
  const auto is_seen = [](const glass::ShardPlace& place) { return place.state != glass::ShardState::missing; };
  return found != broken.paths.end() && std::ranges::any_of(found->second, is_seen);
}

// A body for each crack that has one, of meshes that follow one another.
class CrackBodies {
 public:
  CrackBodies(const BrokenPane& broken, std::size_t material, const TakeBody& take)
      : broken_(broken), bend_(glass::bend_of(broken.pane)), material_(material), take_(take) {}
  ~CrackBodies() = default;
  CrackBodies(const CrackBodies&) = delete;
  CrackBodies& operator=(const CrackBodies&) = delete;

  void add(int crack, Mesh mesh) {
    if (crack != crack_) end();
    crack_ = crack;
    append(mesh_, bent(std::move(mesh), bend_, bent_pane_bound_mm));
  }
  void end() {
    if (crack_ >= 0) {
      const glass::CrackKind kind = broken_.crack(crack_).kind;
      take_({fmt::format("{}.crack-{}", broken_.pane.name, crack_),
             fmt::format("crack {}", name_of(kind)),
             {{material_, std::move(mesh_)}},
             {}});
    }
    mesh_ = {};
    crack_ = -1;
  }

 private:
  const BrokenPane& broken_;
  geometry::Bend bend_;
  std::size_t material_;
  const TakeBody& take_;
  int crack_ = -1;
  Mesh mesh_;
};

void append_tubes(const BrokenPane& broken, const std::vector<Tube>& tubes, std::size_t material, const TakeBody& take) {
  CrackBodies cracks(broken, material, take);
  for (const Tube& tube : tubes) cracks.add(tube.crack, tube_mesh(tube));
  cracks.end();
}

void append_crushed(const BrokenPane& broken, const std::vector<glass::ImpactZone>& zones, std::size_t material,
                    const TakeBody& take) {
  const double half = 0.5 * broken.pane.thickness_mm - crushed_skin_mm;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (zones[i].radius_mm <= 0.0 || half <= 0.0) continue;
    take({fmt::format("{}.crushed-{}", broken.pane.name, i),
          "crushed",
          {{material, bent(crushed_mesh(zones[i], half), glass::bend_of(broken.pane), bent_pane_bound_mm)}},
          {}});
  }
}

void append_gaps(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  CrackBodies cracks(broken, first_material + 1, take);
  for (const glass::CrackSurface& surface : broken.surfaces.surfaces) cracks.add(surface.crack, gap_mesh(surface));
  cracks.end();
  append_crushed(broken, crushed_zones(broken.surfaces), first_material + 2, take);
  for (std::size_t i = 0; i < broken.surfaces.shot_holes.size(); ++i) {
    take({fmt::format("{}.hole-{}", broken.pane.name, i),
          "hole",
          {{first_material + 1,
            bent(hole_mesh(broken.surfaces.shot_holes[i]), glass::bend_of(broken.pane), bent_pane_bound_mm)}},
          {}});
  }
}

void append_whole(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  take({broken.pane.name + ".slab",
        "pane",
        {{first_material, bent(slab_mesh(broken.pane), glass::bend_of(broken.pane), bent_pane_bound_mm)}},
        {}});
  if (broken.pane.crack_body == glass::CrackBody::sheet) {
    append_gaps(broken, first_material, take);
    return;
  }
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network, broken.far_network);
  append_tubes(broken, cracks.tubes, first_material + 1, take);
  append_crushed(broken, cracks.zones, first_material + 2, take);
}

void append_shards(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  std::vector<const glass::Shard*> there;
  for (const glass::Shard& shard : broken.shards) {
    if (is_there(broken, shard)) there.push_back(&shard);
  }
  std::vector<Body> bodies;
  for (std::size_t begin = 0; begin < there.size(); begin += shards_at_once) {
    bodies.assign(std::min(shards_at_once, there.size() - begin), {});
    parallel_for(bodies.size(), [&](std::size_t i) { bodies[i] = shard_body(broken, *there[begin + i], first_material); });
    for (Body& body : bodies) take(std::move(body));
  }
  append_tubes(broken, joined_tubes(broken), first_material + 1, take);
}

}  // namespace

void append_glass(const BrokenPane& broken, std::size_t first_material, const TakeBody& take) {
  if (broken.pane.shards) {
    append_shards(broken, first_material, take);
  } else {
    append_whole(broken, first_material, take);
  }
}

}  // namespace shatterpave::exporting::shapes
