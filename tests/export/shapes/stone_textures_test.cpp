// Textures on stones: they are nowhere drawn out, and neighbours show other parts of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "export/shapes/bodies.h"
#include "export/shapes/meshes_of.h"
#include "export/shapes/tangents.h"
#include "export/shapes/unrolling.h"
#include "paving/bonds/table.h"
#include "paving/laying.h"

namespace shatterpave::exporting::shapes {
namespace {

paving::Pavement yard(paving::Bond bond, vec2 stone_mm, paving::Finish finish) {
  paving::Pavement pavement;
  pavement.name = "yard";
  pavement.area.outline = {{0.0, 0.0}, {3000.0, 0.0}, {3000.0, 2000.0}, {0.0, 2000.0}};
  pavement.stone_mm = stone_mm;
  pavement.bonding.bond = bond;
  pavement.surface.height_mm = 4.0;
  pavement.body.finish = finish;
  pavement.body.arris_mm = 4.0;
  return pavement;
}

Model laid(const paving::Pavement& pavement) {
  Model model;
  model.name = "scene";
  model.seed = 5;
  model.pavements = {{pavement, paving::laid_stones(pavement, 5)}};
  return model;
}

// The meshes of the stones, in their order.
std::vector<Mesh> stones_of(const Model& model) {
  std::vector<Mesh> meshes;
  SharedPieces shared;
  for_each_body(
      model, materials_of(model), [&](const std::string&, bool) { shared.begin_thing(); },
      [&](Body&& body) {
        if (body.kind.starts_with("stone")) meshes.push_back(shared.of(body).front().mesh);
      });
  return meshes;
}

// How a triangle is drawn out on its texture: the least and the largest of the ratios of lengths, in space over those in the
// texture, and its area.
struct Stretch {
  double least = 0.0;
  double most = 0.0;
  double area_mm2 = 0.0;
};

Stretch stretch_of(const Mesh& mesh, std::size_t first) {
  const std::uint32_t* c = &mesh.triangles[first];
  const vec3 e = mesh.points_mm[c[1]] - mesh.points_mm[c[0]];
  const vec3 f = mesh.points_mm[c[2]] - mesh.points_mm[c[0]];
  const vec2 a = 1000.0 * (mesh.uv_m[c[1]] - mesh.uv_m[c[0]]);
  const vec2 b = 1000.0 * (mesh.uv_m[c[2]] - mesh.uv_m[c[0]]);
  const double det = cross(a, b);
  if (det == 0.0) return {0.0, 1e9, 0.5 * glm::length(glm::cross(e, f))};
  const vec3 u = (b.y * e - a.y * f) / det;
  const vec3 v = (a.x * f - b.x * e) / det;
  // Singular values of the two columns.
  const double p = glm::dot(u, u);
  const double q = glm::dot(v, v);
  const double r = glm::dot(u, v);
  const double root = std::sqrt(0.25 * (p - q) * (p - q) + r * r);
  return {std::sqrt(std::max(0.0, 0.5 * (p + q) - root)), std::sqrt(0.5 * (p + q) + root), 0.5 * glm::length(glm::cross(e, f))};
}

// The part of the area whose texture is drawn out or together by more than `tolerance`.
double drawn_part(const std::vector<Mesh>& meshes, double tolerance = 0.01) {
  double all = 0.0;
  double drawn = 0.0;
  for (const Mesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const Stretch stretch = stretch_of(mesh, i);
      all += stretch.area_mm2;
      if (stretch.least < 1.0 - tolerance || stretch.most > 1.0 + tolerance) drawn += stretch.area_mm2;
    }
  }
  return drawn / all;
}

std::vector<paving::Bond> bonds() {
  std::vector<paving::Bond> all;
  for (const paving::BondType* type : paving::bond_types()) {
    if (type->is_for_scenes) all.push_back(type->id);
  }
  return all;
}

class TexturesOfEveryBond : public testing::TestWithParam<paving::Bond> {};

// A sheet that is laid on from above, and drawn out down the sides.
std::vector<Mesh> seen_from_above(std::vector<Mesh> meshes) {
  for (Mesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.uv_m.size(); ++i)
      mesh.uv_m[i] = {0.001 * mesh.points_mm[i].x, -0.001 * mesh.points_mm[i].z};
  }
  return meshes;
}

TEST_P(TexturesOfEveryBond, AreDrawnOutNowhereButAtRoundedCorners) {
  const auto split = stones_of(laid(yard(GetParam(), {200.0, 100.0}, paving::Finish::split)));
  EXPECT_LT(drawn_part(split), paving::type_of(GetParam()).has_square_stones ? 0.006 : 0.03);
  EXPECT_GT(drawn_part(seen_from_above(split)), 0.03);
  paving::Pavement sawn = yard(GetParam(), {200.0, 100.0}, paving::Finish::flat_sawn);
  sawn.body.arris = paving::Arris::chamfered;
  EXPECT_LT(drawn_part(stones_of(laid(sawn))), 1e-6);
}

// No sheet covers a dome: it is drawn out a little nearly everywhere, but much nowhere.
TEST_P(TexturesOfEveryBond, AreDrawnOutALittleOnDomes) {
  paving::Pavement pavement = yard(GetParam(), {100.0, 100.0}, paving::Finish::none);
  pavement.surface.height_mm = 20.0;
  const auto domes = stones_of(laid(pavement));
  EXPECT_LT(drawn_part(domes, 0.1), 0.07);
  EXPECT_GT(drawn_part(seen_from_above(domes), 0.1), 3.0 * drawn_part(domes, 0.1));
}

// A level face lies on the sheet as it is seen from above.
TEST(Unrolling, LeavesLevelFacesWhereTheyAre) {
  geometry::BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      patch.at(row, column) = {20.0 + 40.0 * static_cast<double>(row), -30.0 + 20.0 * static_cast<double>(column), 7.0};
    }
  }
  const StoneMesh mesh = displaced({patch}, {}, 10.0);
  const std::vector<vec2> places = unrolled(mesh);
  ASSERT_GT(places.size(), 50U);
  ASSERT_EQ(places.size(), mesh.bare.size());
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i], vec2(mesh.bare[i].x, mesh.bare[i].y));
}

// The part of its swatch that a stone shows, as a box of its places, m.
geometry::Box shown_m(const Mesh& mesh) {
  geometry::Box box{{1e9, 1e9}, {-1e9, -1e9}};
  for (std::size_t i = 0; i < mesh.uv_m.size(); ++i) {
    box = {glm::min(box.low, mesh.uv_m[i]), glm::max(box.high, mesh.uv_m[i])};
  }
  return box;
}

// The area that two boxes have in common in a texture that repeats.
double common_m2(const geometry::Box& a, const geometry::Box& b, double side_m) {
  const auto along = [&](double a_low, double a_high, double b_low, double b_high) {
    double sum = 0.0;
    const double nearest = std::floor((a_low - b_low) / side_m);
    for (int k = -3; k <= 3; ++k) {
      const double by = (nearest + k) * side_m;
      sum += std::max(0.0, std::min(a_high, b_high + by) - std::max(a_low, b_low + by));
    }
    return sum;
  };
  return along(a.low.x, a.high.x, b.low.x, b.high.x) * along(a.low.y, a.high.y, b.low.y, b.high.y);
}

// Whether two stones come within the joint of one another, as far as the boxes along their axes tell.
bool are_neighbours(const paving::Stone& a, const paving::Stone& b) {
  constexpr double joint_mm = 9.0;
  const vec2 d = a.angle.direction();
  const vec2 e = b.angle.direction();
  return std::ranges::all_of(std::array{d, left_of(d), e, left_of(e)}, [&](vec2 axis) {
    const auto along = [&](vec2 p) { return glm::dot(p, axis); };
    const auto [a_low, a_high] = std::ranges::minmax(a.outline_mm, {}, along);
    const auto [b_low, b_high] = std::ranges::minmax(b.outline_mm, {}, along);
    return along(a_low) < along(b_high) + joint_mm && along(b_low) < along(a_high) + joint_mm;
  });
}

struct Neighbours {
  std::size_t pairs = 0;
  std::size_t alike = 0;      // pairs of them that show a part of the swatch in common
  std::size_t far_alike = 0;  // others that do
};

Neighbours neighbours_of(const Model& model, const std::vector<Mesh>& meshes) {
  const auto& stones = model.pavements[0].layout.stones;
  const double side_m = swatch_side_m(model.pavements[0]);
  std::vector<geometry::Box> shown;
  for (const Mesh& mesh : meshes) shown.push_back(shown_m(mesh));
  Neighbours found;
  for (std::size_t i = 0; i < stones.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool alike = common_m2(shown[i], shown[j], side_m) > 0.0;
      if (are_neighbours(stones[i], stones[j])) {
        ++found.pairs;
        found.alike += alike ? 1U : 0U;
      } else {
        found.far_alike += alike ? 1U : 0U;
      }
    }
  }
  return found;
}

TEST_P(TexturesOfEveryBond, ShowOtherPartsOnNeighbours) {
  for (const vec2 stone_mm : {vec2{200.0, 100.0}, vec2{97.0, 97.0}, vec2{613.0, 389.0}}) {
    paving::Pavement pavement = yard(GetParam(), stone_mm, paving::Finish::split);
    if (stone_mm.x > 300.0) pavement.area.outline = {{0.0, 0.0}, {6000.0, 0.0}, {6000.0, 4000.0}, {0.0, 4000.0}};
    const Model model = laid(pavement);
    std::vector<Mesh> meshes = stones_of(model);
    const Neighbours found = neighbours_of(model, meshes);
    EXPECT_GT(found.pairs, meshes.size());
    EXPECT_EQ(found.alike, 0U) << stone_mm.x;
    EXPECT_GT(found.far_alike, 0U);  // else nothing would be said by the above
    // The twin: all begin at one place.
    for (Mesh& mesh : meshes) {
      const vec2 low = shown_m(mesh).low;
      for (vec2& uv : mesh.uv_m) uv -= low;
    }
    EXPECT_EQ(neighbours_of(model, meshes).alike, found.pairs);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, TexturesOfEveryBond, testing::ValuesIn(bonds()));

// Kerbs are long and stand free; what stands beside them is seen, too.
TEST(Textures, OfKerbsAreTheirOwnPart) {
  paving::Pavement kerb = yard(paving::Bond::running, {900.0, 120.0}, paving::Finish::split);
  kerb.surface.height_mm = 100.0;
  kerb.area.outline = {{0.0, 0.0}, {9000.0, 0.0}, {9000.0, 1000.0}, {0.0, 1000.0}};
  const Model model = laid(kerb);
  const std::vector<Mesh> meshes = stones_of(model);
  EXPECT_EQ(neighbours_of(model, meshes).alike, 0U);
  EXPECT_LT(drawn_part(meshes), 0.03);
}

TEST(Tangents, RunAsTheTextureDoes) {
  std::size_t level = 0;
  std::size_t along_x = 0;
  for (const Mesh& mesh : stones_of(laid(yard(paving::Bond::herringbone, {200.0, 100.0}, paving::Finish::split)))) {
    const std::vector<Tangent> along = tangents(mesh);
    ASSERT_EQ(along.size(), mesh.points_mm.size());
    const auto lower = [](const vec3& p, const vec3& q) { return p.y < q.y; };
    const double top_mm = std::ranges::max_element(mesh.points_mm, lower)->y;
    for (std::size_t i = 0; i < along.size(); ++i) {
      ASSERT_NEAR(glm::length(along[i].along), 1.0, 1e-9);
      ASSERT_NEAR(glm::dot(along[i].along, mesh.normals[i]), 0.0, 1e-9);
      ASSERT_FALSE(along[i].is_mirrored);
      // Of the face: at the foot of a corner the surface is level, too, but there the sheet is bent twice.
      if (mesh.normals[i].y < 0.999 || mesh.points_mm[i].y < 0.5 * top_mm) continue;
      ++level;
      if (along[i].along.x > 0.99) ++along_x;
    }
  }
  // A stone lies along x in its own frame.
  EXPECT_GT(level, 1000U);
  EXPECT_EQ(along_x, level);
}

TEST(Tangents, TellMirroredTextures) {
  Mesh mesh;
  mesh.points_mm = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  mesh.normals.assign(3, {0.0, 0.0, 1.0});
  mesh.uv_m = {{0.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}};
  mesh.triangles = {0, 1, 2};
  EXPECT_TRUE(tangents(mesh)[0].is_mirrored);
  EXPECT_EQ(tangents(mesh)[0].along, (vec3{-1.0, 0.0, 0.0}));
  // Without an area in the texture there still is one.
  mesh.uv_m.assign(3, {0.5, 0.5});
  EXPECT_NEAR(glm::dot(tangents(mesh)[0].along, mesh.normals[0]), 0.0, 1e-12);
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
