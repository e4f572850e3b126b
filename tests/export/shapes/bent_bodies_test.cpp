// Bent panes: every body closed, turned outwards, of the right volume, and where the flat one is sent.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/error.h"
#include "export/export_panes.h"
#include "export/shapes/bodies.h"
#include "export/shapes/glass_meshes.h"
#include "export/shapes/open_slab.h"

namespace shatterpave::exporting::shapes {
namespace {

using Place = std::array<long long, 3>;

Place place_of(vec3 p) { return {std::llround(p.x * 1e4), std::llround(p.y * 1e4), std::llround(p.z * 1e4)}; }

struct BentFigures {
  bool is_closed = true;
  double volume_mm3 = 0.0;
  double area_mm2 = 0.0;
  double turned_mm2 = 0.0;  // of facets whose normals look into them
};

void add_to(std::map<std::pair<Place, Place>, int>& edges, BentFigures& figures, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    std::array<vec3, 3> c{};
    vec3 normal{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      c.at(k) = mesh.points_mm[mesh.triangles[i + k]];
      normal += mesh.normals[mesh.triangles[i + k]];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{place_of(c.at(k)), place_of(c.at((k + 1) % 3))}];
      --edges[{place_of(c.at((k + 1) % 3)), place_of(c.at(k))}];
    }
    const vec3 across = 0.5 * glm::cross(c[1] - c[0], c[2] - c[0]);
    figures.volume_mm3 += glm::dot(c[0], glm::cross(c[1], c[2])) / 6.0;
    figures.area_mm2 += glm::length(across);
    if (glm::dot(across, normal) < 0.0) figures.turned_mm2 += glm::length(across);
  }
}

BentFigures figures_of(const std::vector<const Mesh*>& meshes) {
  BentFigures figures;
  std::map<std::pair<Place, Place>, int> edges;
  for (const Mesh* mesh : meshes) add_to(edges, figures, *mesh);
  figures.is_closed = std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
  return figures;
}

BentFigures figures_of(const Body& body) {
  std::vector<const Mesh*> meshes;
  for (const Piece& piece : body.pieces) meshes.push_back(&piece.mesh);
  return figures_of(meshes);
}

std::vector<Body> bent_bodies_of(const BrokenPane& broken) {
  Model model;
  model.name = "scene";
  model.panes.push_back(broken);
  std::vector<Body> bodies;
  for_each_body(model, materials_of(model), {}, [&](Body&& body) { bodies.push_back(std::move(body)); });
  return bodies;
}

const vec2 bow{21.0, -12.0};

BrokenPane bent_whole(glass::CrackBody body, double hole_mm) {
  glass::Pane pane = support::pane_with(24);
  pane.crack_body = body;
  pane.thickness_mm = 4.0;
  pane.impacts.front().hole_mm = hole_mm;
  pane.bow_mm = bow;
  return support::broken_pane(pane);
}

BrokenPane bent_shards(bool joined) {
  BrokenPane broken = support::shattered_pane(70, joined);
  broken.pane.bow_mm = bow;
  return broken;
}

// Area of the bent middle plane, by the middles of many small squares; and what the two faces add of the third power.
double bent_slab_mm3(const glass::Pane& pane) {
  const geometry::Bend bend = glass::bend_of(pane);
  constexpr int parts = 500;
  double area = 0.0;
  double curved = 0.0;
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; j < parts; ++j) {
      const vec2 at{300.0 * (i + 0.5) / parts, 300.0 * (j + 0.5) / parts};
      const vec2 slope = bend.slope(at);
      const double steep = 1.0 + glm::dot(slope, slope);
      const vec2 second = -2.0 * bend.bow_mm / (bend.half_mm * bend.half_mm);
      area += std::sqrt(steep);
      curved += second.x * second.y / (steep * std::sqrt(steep));  // Gauss's curvature times the area
    }
  }
  const double square = 300.0 * 300.0 / (parts * parts);
  const double t = pane.thickness_mm;
  return square * (t * area + t * t * t / 12.0 * curved);
}

TEST(BentBodies, OfWholePanesAreClosedAndOfTheRightVolume) {
  for (const auto body : {glass::CrackBody::cylinder, glass::CrackBody::sheet}) {
    const BrokenPane broken = bent_whole(body, body == glass::CrackBody::sheet ? 8.0 : 0.0);
    int count = 0;
    for (const Body& one : bent_bodies_of(broken)) {
      const BentFigures figures = figures_of(one);
      EXPECT_TRUE(figures.is_closed) << one.name;
      EXPECT_EQ(figures.turned_mm2, 0.0) << one.name;
      if (one.kind == "pane") {
        EXPECT_NEAR(figures.volume_mm3, bent_slab_mm3(broken.pane), bent_pane_bound_mm * figures.area_mm2);
        // The flat one is far from it.
        EXPECT_GT(std::abs(figures.volume_mm3 - 300.0 * 300.0 * 4.0), 10.0 * bent_pane_bound_mm * figures.area_mm2);
      } else {
        EXPECT_LT(figures.volume_mm3, 0.0) << one.name;  // a cavity
      }
      ++count;
    }
    EXPECT_GT(count, 20);
  }
}

TEST(BentBodies, OpenSlabsAreClosed) {
  BrokenPane broken = bent_whole(glass::CrackBody::sheet, 8.0);
  broken.pane.bow_mm = {4.0, -3.0};
  const OpenSlab open = open_slab(broken);
  ASSERT_EQ(open.walls.size(), 1U);
  EXPECT_TRUE(figures_of({&open.slab, &open.walls.front()}).is_closed);
  EXPECT_FALSE(figures_of({&open.slab}).is_closed);
}

TEST(BentBodies, OfShardsAreClosedAndAsThickAsFlatOnes) {
  for (const bool joined : {false, true}) {
    const BrokenPane broken = bent_shards(joined);
    const geometry::Bend bend = glass::bend_of(broken.pane);
    std::size_t count = 0;
    for (const glass::Shard& shard : broken.shards) {
      std::vector<Mesh> flat;
      std::vector<Mesh> coarse;
      std::vector<Mesh> fine;
      for (const glass::ShardSurface slot : {glass::ShardSurface::old, glass::ShardSurface::broken}) {
        flat.push_back(shard_mesh(shard, slot, broken.pane.thickness_mm));
        coarse.push_back(bent(flat.back(), bend, bent_shard_bound_mm));
        fine.push_back(bent(flat.back(), bend, bent_shard_bound_mm / 10.0));
      }
      const BentFigures is = figures_of({&coarse[0], &coarse[1]});
      const BentFigures limit = figures_of({&fine[0], &fine[1]});
      EXPECT_TRUE(is.is_closed) << shard.id;
      EXPECT_LT(is.turned_mm2, 1e-3 * is.area_mm2) << shard.id;
      EXPECT_NEAR(is.volume_mm3, limit.volume_mm3, bent_shard_bound_mm * is.area_mm2) << shard.id;
      // As large as it was, but for how steep it stands: between no more and what the steepest corner adds.
      const double was = figures_of({&flat[0], &flat[1]}).volume_mm3;
      const double steepest = glm::length(vec3{2.0 * bend.bow_mm / bend.half_mm, 1.0});
      EXPECT_GE(is.volume_mm3, was - bent_shard_bound_mm * is.area_mm2) << shard.id;
      EXPECT_LE(is.volume_mm3, steepest * was + bent_shard_bound_mm * is.area_mm2) << shard.id;
      ++count;
    }
    EXPECT_GT(count, joined ? 5U : 20U);
  }
}

// The place in the flat pane that is sent to `p`: its nearest place of the bent middle, and how far off it lies.
vec3 flat_place(const geometry::Bend& bend, vec3 p) {
  vec3 flat = p;
  flat.z = 0.0;
  for (int round = 0; round < 30; ++round) {
    const vec3 middle = bend.point({flat.x, flat.y, 0.0});
    const vec3 out = bend.normal({flat.x, flat.y, 0.0}, {0, 0, 1});
    flat.z = glm::dot(p - middle, out);
    const vec3 off = p - bend.point(flat);
    flat.x += off.x;
    flat.y += off.y;
  }
  return flat;
}

TEST(BentBodies, WallsOfShardsStayOnTheirSideOfTheCrack) {
  const BrokenPane broken = bent_shards(false);
  const geometry::Bend bend = glass::bend_of(broken.pane);
  double most = 0.0;
  std::size_t count = 0;
  for (std::size_t s = 0; s < broken.shards.size(); s += 7) {
    const Mesh flat = shard_mesh(broken.shards[s], glass::ShardSurface::broken, broken.pane.thickness_mm);
    for (std::size_t i = 0; i < flat.triangles.size(); i += 3) {
      const vec3 normal = flat.normals[flat.triangles[i]];
      if (normal.z != 0.0) continue;  // a wall
      Mesh wall;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = flat.triangles[i + k];
        wall.points_mm.push_back(flat.points_mm[corner]);
        wall.normals.push_back(normal);
        wall.uv_m.push_back({0, 0});
      }
      wall.triangles = {0, 1, 2};
      const vec3 on_wall = wall.points_mm.front();
      const Mesh made = bent(wall, bend, bent_shard_bound_mm);
      for (std::size_t j = 0; j < made.triangles.size(); j += 3) {
        const vec3 middle = (made.points_mm[made.triangles[j]] + made.points_mm[made.triangles[j + 1]] +
                             made.points_mm[made.triangles[j + 2]]) /
                            3.0;
        most = std::max(most, std::abs(glm::dot(flat_place(bend, middle) - on_wall, normal)));
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100U);
  // Gaps are 0.06 mm wide: walls never come near one another.
  EXPECT_LT(most, 0.005);
}

TEST(BentBodies, FallAsTheyAreBent) {
  BrokenPane broken = bent_shards(false);
  broken.shards = glass::shards(broken.pane, broken.network, 7);
  const geometry::Bend bend = glass::bend_of(broken.pane);
  const double floor_mm = -broken.pane.shards->floor_drop_mm;
  int on_floor = 0;
  int off_when_flat = 0;
  for (const glass::Shard& shard : broken.shards) {
    if (shard.state != glass::ShardState::fallen) continue;
    double lowest = 1e300;
    double lowest_flat = 1e300;
    for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
      const vec3 flat = glass::in_pane_mm(vertex, broken.pane.thickness_mm);
      lowest = std::min(lowest, glass::moved(shard.motion, bend.point(flat)).y);
      lowest_flat = std::min(lowest_flat, glass::moved(shard.motion, flat).y);
    }
    EXPECT_GE(lowest, floor_mm - 0.3) << shard.id;
    if (std::abs(lowest - floor_mm) < 0.5) ++on_floor;
    if (std::abs(lowest_flat - floor_mm) > 3.0 && std::abs(lowest - floor_mm) < 0.5) ++off_when_flat;
  }
  EXPECT_GT(on_floor, 3);
  EXPECT_GT(off_when_flat, 0);  // flat shards would not lie there
}

TEST(BentPanes, AreRefusedWhereTheyAreBentTooFar) {
  glass::Pane pane = support::pane_with(10);
  pane.bow_mm = {30.0, -30.0};
  EXPECT_NO_THROW(glass::require_breakable(pane));
  for (const vec2 most : {vec2{30.1, 0.0}, vec2{0.0, -30.1}}) {
    pane.bow_mm = most;
    EXPECT_THROW(glass::require_breakable(pane), InputError);
  }
  pane.bow_mm = {30.0, 0.0};
  pane.thickness_mm = 250.0;  // folds
  EXPECT_THROW(glass::require_breakable(pane), InputError);
  pane.bow_mm = {0.0, 0.0};
  EXPECT_NO_THROW(glass::require_breakable(pane));
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
