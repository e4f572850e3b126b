// What mesh targets are given: closed, the right way out, of the right size, with places in textures.
#include "export/shapes/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/dynamic_bitset.hpp>
#include <cmath>
#include <map>
#include <tuple>

#include "core/parallel.h"
#include "export/export_panes.h"
#include "export/ply/bodies_ply.h"
#include "export/shapes/meshes_of.h"
#include "paving/laying.h"

namespace shatterpave::exporting::shapes {
namespace {

struct Placed {
  Body body;
  Mesh mesh;  // of all pieces, where they are
};

std::vector<Placed> bodies_of(const Model& model) {
  std::vector<Placed> result;
  SharedPieces shared;
  for_each_body(
      model, materials_of(model), [&](const std::string&, bool) { shared.begin_thing(); },
      [&](Body&& body) {
        Placed placed{std::move(body), {}};
        for (const Piece& piece : shared.of(placed.body)) {
          const auto first = static_cast<std::uint32_t>(placed.mesh.points_mm.size());
          for (const vec3& p : piece.mesh.points_mm) placed.mesh.points_mm.push_back(placed.body.placing(p));
          for (const vec3& n : piece.mesh.normals) placed.mesh.normals.push_back(placed.body.placing.turned(n));
          placed.mesh.uv_m.insert(placed.mesh.uv_m.end(), piece.mesh.uv_m.begin(), piece.mesh.uv_m.end());
          for (const std::uint32_t corner : piece.mesh.triangles) placed.mesh.triangles.push_back(first + corner);
        }
        result.push_back(std::move(placed));
      });
  return result;
}

using Corners = std::array<vec3, 3>;

template <typename Visit>
void for_each_triangle(const Mesh& mesh, Visit visit) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    visit(std::array<std::uint32_t, 3>{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]});
  }
}

Corners corners_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return {mesh.points_mm[t[0]], mesh.points_mm[t[1]], mesh.points_mm[t[2]]};
}

vec3 across(const Corners& c) { return glm::cross(c[1] - c[0], c[2] - c[0]); }

double volume_mm3(const Mesh& mesh) {
  double total = 0.0;
  for_each_triangle(mesh, [&](const auto& t) {
    const Corners c = corners_of(mesh, t);
    total += glm::dot(c[0], glm::cross(c[1], c[2])) / 6.0;
  });
  return total;
}

// Every edge is that of one other triangle the other way round, points in one place being one.
bool is_closed(const Mesh& mesh) {
  using Key = std::tuple<long long, long long, long long>;
  std::map<std::pair<Key, Key>, int> edges;
  const auto key = [](vec3 p) { return Key{std::llround(p.x * 1e4), std::llround(p.y * 1e4), std::llround(p.z * 1e4)}; };
  for_each_triangle(mesh, [&](const auto& t) {
    const Corners c = corners_of(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{key(c[k]), key(c[(k + 1) % 3])}];
      --edges[{key(c[(k + 1) % 3]), key(c[k])}];
    }
  });
  return std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

// The share of triangles whose normals do not look out of them.
double turned_share(const Mesh& mesh) {
  std::size_t count = 0;
  std::size_t turned = 0;
  for_each_triangle(mesh, [&](const auto& t) {
    const vec3 out = across(corners_of(mesh, t));
    ++count;
    if (glm::dot(out, mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]) <= 0.0) ++turned;
  });
  return static_cast<double>(turned) / static_cast<double>(count);
}

Model pane_model(glass::CrackBody body) {
  Model model;
  model.name = "scene";
  glass::Pane pane = support::pane_with(24);
  pane.crack_body = body;
  model.panes = {support::broken_pane(pane)};
  return model;
}

class CracksInASlab : public testing::TestWithParam<glass::CrackBody> {};

// So that a renderer which follows light from face to face finds glass between them, and air in the cracks.
TEST_P(CracksInASlab, AreCavitiesThatLookIntoThemselves) {
  const std::vector<Placed> bodies = bodies_of(pane_model(GetParam()));
  ASSERT_GT(bodies.size(), 20U);
  EXPECT_EQ(bodies[0].body.name, "window.slab");
  EXPECT_NEAR(volume_mm3(bodies[0].mesh), 300.0 * 300.0 * 2.0, 1e-6);
  for (const Placed& placed : bodies) {
    EXPECT_TRUE(is_closed(placed.mesh)) << placed.body.name;
    EXPECT_LT(turned_share(placed.mesh), 0.01) << placed.body.name;
    if (placed.body.kind != "pane") {
      EXPECT_LT(volume_mm3(placed.mesh), 0.0) << placed.body.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, CracksInASlab, testing::Values(glass::CrackBody::cylinder, glass::CrackBody::sheet));

TEST(Bodies, ShardsKeepTheirVolumeWhereTheyAre) {
  Model model;
  model.panes = {support::shattered_pane(40)};
  std::map<std::string, const glass::Shard*> shards;
  for (const glass::Shard& shard : model.panes[0].shards) shards["window." + shard.id] = &shard;
  std::size_t fallen = 0;
  for (const Placed& placed : bodies_of(model)) {
    ASSERT_TRUE(shards.contains(placed.body.name));
    const glass::Shard& shard = *shards[placed.body.name];
    EXPECT_TRUE(is_closed(placed.mesh)) << placed.body.name;
    EXPECT_NEAR(volume_mm3(placed.mesh), static_cast<double>(geometry::sextuple_volume(shard.solid)) / 6e9, 1e-3);
    EXPECT_EQ(placed.body.kind == "shard fallen", shard.state == glass::ShardState::fallen);
    if (shard.state != glass::ShardState::fallen) continue;
    ++fallen;
    const vec3 at = glass::moved(shard.motion, glass::in_pane_mm(shard.solid.vertices[0], 2.0));
    EXPECT_TRUE(std::ranges::any_of(placed.mesh.points_mm, [&](vec3 p) { return glm::length(p - at) < 1e-6; }));
  }
  EXPECT_GT(fallen, 0U);
}

paving::Pavement court(paving::Bond bond, vec2 stone_mm) {
  paving::Pavement pavement;
  pavement.name = "court";
  pavement.area.outline = {{0.0, 0.0}, {4000.0, 0.0}, {4000.0, 3000.0}, {0.0, 3000.0}};
  pavement.stone_mm = stone_mm;
  pavement.bonding.bond = bond;
  pavement.surface.height_mm = 2.0;
  return pavement;
}

Model paved(const paving::Pavement& pavement) {
  Model model;
  model.name = "scene";
  model.seed = 5;
  model.pavements = {{pavement, paving::laid_stones(pavement, 5)}};
  return model;
}

bool is_stone(const Placed& placed) { return placed.body.kind.starts_with("stone"); }

TEST(Bodies, StonesLookUpWithinTheirOutlines) {
  for (const auto finish : {paving::Finish::none, paving::Finish::split}) {
    paving::Pavement pavement = court(paving::Bond::herringbone, {200.0, 100.0});
    pavement.body.finish = finish;
    pavement.body.arris_mm = 5.0;
    const Model model = paved(pavement);
    const auto bodies = bodies_of(model);
    std::size_t at = 0;
    for (const Placed& placed : bodies) {
      if (!is_stone(placed)) continue;
      const geometry::Polygon& outline = model.pavements[0].layout.stones[at++].outline_mm;
      EXPECT_LT(turned_share(placed.mesh), 0.02) << placed.body.name;
      const geometry::Box box = geometry::bounding_box(outline);
      for (const vec3& p : placed.mesh.points_mm) {
        ASSERT_TRUE(p.x > box.low.x - 3.0 && p.x < box.high.x + 3.0 && -p.z > box.low.y - 3.0 && -p.z < box.high.y + 3.0)
            << placed.body.name;
      }
    }
    EXPECT_EQ(at, model.pavements[0].layout.stones.size());
    EXPECT_EQ(bodies.back().body.kind, "joints");
    EXPECT_TRUE(is_closed(bodies.back().mesh));
  }
}

// The filling that has sunk covers the whole of its area, once.
TEST(Bodies, SunkenFillingCoversItsArea) {
  paving::Pavement pavement = court(paving::Bond::running, {200.0, 100.0});
  pavement.ground.settlement_mm = 8.0;
  pavement.area.holes = {{{700, 300}, {700, 500}, {900, 500}, {900, 300}}};
  const auto bodies = bodies_of(paved(pavement));
  const Mesh& mesh = bodies.back().mesh;
  ASSERT_EQ(bodies.back().body.kind, "joints");
  double area = 0.0;
  for_each_triangle(mesh, [&](const auto& t) { area += 0.5 * across(corners_of(mesh, t)).y; });
  EXPECT_NEAR(area, geometry::area(pavement.area), 1e-6 * area);
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  for (const vec3& p : mesh.points_mm) {
    EXPECT_TRUE(p.x >= box.low.x && p.x <= box.high.x && -p.z >= box.low.y && -p.z <= box.high.y);
  }
}

// Of triangles that look up: how u and v change along the stone and across it, metres a metre.
struct Scale {
  double along = 0.0;
  double across = 0.0;
  double skew = 0.0;
};

std::vector<Scale> scales(const Placed& placed, vec3 axis) {
  std::vector<Scale> result;
  const Mesh& mesh = placed.mesh;
  for_each_triangle(mesh, [&](const auto& t) {
    const Corners c = corners_of(mesh, t);
    const vec3 normal = glm::normalize(across(c));
    if (normal.y < 0.999) return;
    const vec3 side = glm::normalize(glm::cross(normal, axis));
    const vec3 e = c[1] - c[0];
    const vec3 f = c[2] - c[0];
    const vec2 a = 1000.0 * (mesh.uv_m[t[1]] - mesh.uv_m[t[0]]);
    const vec2 b = 1000.0 * (mesh.uv_m[t[2]] - mesh.uv_m[t[0]]);
    // u = p·x along the axis, q·x across it.
    const double det = glm::dot(e, axis) * glm::dot(f, side) - glm::dot(e, side) * glm::dot(f, axis);
    result.push_back({(a.x * glm::dot(f, side) - b.x * glm::dot(e, side)) / det,
                      (glm::dot(e, axis) * b.y - glm::dot(f, axis) * a.y) / det,
                      (glm::dot(e, axis) * b.x - glm::dot(f, axis) * a.x) / det});
  });
  return result;
}

TEST(Bodies, TexturesRunAlongEachBrickInMetres) {
  const Model model = paved(court(paving::Bond::herringbone, {200.0, 100.0}));
  const auto bodies = bodies_of(model);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < model.pavements[0].layout.stones.size(); ++i) {
    const vec2 d = model.pavements[0].layout.stones[i].angle.direction();
    for (const Scale& scale : scales(bodies[i], {d.x, 0.0, -d.y})) {
      ++seen;
      ASSERT_NEAR(scale.along, 1.0, 0.01) << bodies[i].body.name;
      ASSERT_NEAR(scale.across, 1.0, 0.01) << bodies[i].body.name;
      ASSERT_NEAR(scale.skew, 0.0, 0.01) << bodies[i].body.name;
    }
    // The twin: a texture that all stones lie in alike runs across half of the bricks.
    if (std::abs(d.y) > 0.9 && !scales(bodies[i], {1.0, 0.0, 0.0}).empty()) {
      EXPECT_GT(std::abs(scales(bodies[i], {1.0, 0.0, 0.0}).front().along - 1.0), 0.5);
    }
  }
  EXPECT_GT(seen, 1000U);
}

// The part of a texture of one metre that a stone shows, by its own places: marked on a grid of 5 mm.
boost::dynamic_bitset<> shown(const Mesh& mesh) {
  constexpr int cells = 200;
  boost::dynamic_bitset<> marks(std::size_t{cells} * cells);
  const auto wrapped = [](int cell) { return static_cast<std::size_t>((cell % cells + cells) % cells); };
  vec2 low{1e9, 1e9};
  vec2 high = -low;
  for (std::size_t i = 0; i < mesh.uv_m.size(); ++i) {
    if (mesh.normals[i].y < 0.95) continue;
    low = glm::min(low, mesh.uv_m[i]);
    high = glm::max(high, mesh.uv_m[i]);
  }
  for (int y = static_cast<int>(std::ceil(low.y * cells)); y < std::floor(high.y * cells); ++y) {
    for (int x = static_cast<int>(std::ceil(low.x * cells)); x < std::floor(high.x * cells); ++x) {
      marks[wrapped(y) * cells + wrapped(x)] = true;
    }
  }
  return marks;
}

TEST(Bodies, NeighboursShowOtherPartsOfATexture) {
  const Model model = paved(court(paving::Bond::running, {210.0, 100.0}));
  const auto bodies = bodies_of(model);
  const auto& stones = model.pavements[0].layout.stones;
  std::vector<boost::dynamic_bitset<>> marks;
  for (std::size_t i = 0; i < stones.size(); ++i) marks.push_back(shown(bodies[i].mesh));
  std::size_t pairs = 0;
  std::size_t far_alike = 0;
  for (std::size_t i = 0; i < stones.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const geometry::Box a = geometry::bounding_box(stones[i].outline_mm);
      const geometry::Box b = geometry::bounding_box(stones[j].outline_mm);
      const bool near =
          a.low.x < b.high.x + 9.0 && b.low.x < a.high.x + 9.0 && a.low.y < b.high.y + 9.0 && b.low.y < a.high.y + 9.0;
      const bool alike = marks[i].intersects(marks[j]);
      if (near) {
        ++pairs;
        EXPECT_FALSE(alike) << i << ' ' << j;
      } else if (alike) {
        ++far_alike;
      }
    }
  }
  EXPECT_GT(pairs, 1000U);
  EXPECT_GT(far_alike, pairs);  // else nothing would be said by the above
}

TEST(Bodies, BricksThatAreAlikeShareAMesh) {
  const Model model = paved(court(paving::Bond::running, {210.0, 100.0}));
  std::size_t made = 0;
  std::size_t whole = 0;
  for_each_body(model, materials_of(model), {}, [&](Body&& body) {
    if (body.kind != "stone whole") return;
    ++whole;
    if (!body.pieces.empty()) ++made;
  });
  EXPECT_GT(whole, 400U);
  EXPECT_LE(made, 64U);
  // Where the ground has sunk none is like another.
  paving::Pavement sunken = court(paving::Bond::running, {210.0, 100.0});
  sunken.ground.settlement_mm = 20.0;
  for_each_body(paved(sunken), materials_of(model), {}, [&](Body&& body) { EXPECT_FALSE(body.pieces.empty()); });
}

TEST(Bodies, LieAsTheGroundFalls) {
  paving::Pavement pavement = court(paving::Bond::stack, {500.0, 500.0});
  pavement.ground.fall_percent = 10.0;
  pavement.ground.level_mm = 50.0;
  const Model model = paved(pavement);
  for (const Placed& placed : bodies_of(model)) {
    if (!is_stone(placed)) continue;
    for (const vec3& p : placed.mesh.points_mm) EXPECT_NEAR(p.y, 50.0 - 0.1 * p.x, 8.0) << placed.body.name;
  }
}

TEST(BodiesInParallel, AreTheSameForAnyNumberOfThreads) {
  const Model model = paved(court(paving::Bond::fan, {100.0, 100.0}));
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    return ply::ply_files(model)[0].content;
  };
  const std::string one = bytes(1);
  EXPECT_EQ(one, bytes(2));
  EXPECT_EQ(one, bytes(7));
}

TEST(Ply, HoldsWhatItsHeaderSays) {
  const std::string text = ply::ply_files(pane_model(glass::CrackBody::cylinder))[0].content;
  const std::size_t end = text.find("end_header\n") + 11;
  const std::string header = text.substr(0, end);
  const auto count_after = [&](const std::string& words) {
    return std::stoul(header.substr(header.find(words) + words.size()));
  };
  EXPECT_EQ(text.size() - end, 32 * count_after("element vertex ") + 21 * count_after("element face "));
  EXPECT_NE(header.find("comment body 0 window.slab pane\n"), std::string::npos);
  EXPECT_NE(header.find("comment material 1 glass_broken\n"), std::string::npos);
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
