#include "paving/surface/cell_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/segment_distance.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/patch_seams.h"
#include "paving/paved_areas.h"
#include "paving/surface/laid_surface.h"

namespace shatterpave::paving {
namespace {

const geometry::Polygon square_cell = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
const geometry::Polygon odd_cell = {{0, 0}, {90, 10}, {120, 70}, {60, 110}, {-10, 60}};

Pavement of_cells(CellForm form) {
  Pavement result = pavement(path_area(), 100, 8, straight(0));
  result.cell.form = form;
  return result;
}

CellDraws draws_of(const Pavement& pavement, std::uint64_t stone) { return cell_draws(pavement, 1, Id("p").child(stone)); }

// How far a point lies outside of a convex polygon, mm; below 0 inside.
double outside_mm(const geometry::Polygon& outline, vec2 p) {
  double most = -1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 side = outline[(i + 1) % outline.size()] - outline[i];
    most = std::max(most, -cross(side, p - outline[i]) / glm::length(side));
  }
  return most;
}

template <typename Visit>
void for_each_point(const std::vector<geometry::BezierPatch>& patches, Visit visit) {
  for (const geometry::BezierPatch& patch : patches) {
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; j <= 8; ++j) visit(patch, i / 8.0, j / 8.0);
    }
  }
}

TEST(CellBody, CobblesStayWithinTheirOutlineAndFaceUp) {
  const Pavement pavement = of_cells(CellForm::cobble);
  for (const geometry::Polygon& outline : {square_cell, odd_cell}) {
    for (std::uint64_t stone = 0; stone < 50; ++stone) {
      const auto patches = cell_patches(outline, draws_of(pavement, stone));
      double highest = 0.0;
      for_each_point(patches, [&](const geometry::BezierPatch& patch, double u, double v) {
        const vec3 p = geometry::point(patch, u, v);
        EXPECT_LT(outside_mm(outline, {p.x, p.y}), 0.0);
        EXPECT_GT(p.z, -0.5);
        // At the rim, which the filling hides, it is upright, to the precision of its patches.
        const vec3 normal = glm::cross(geometry::derivative_u(patch, u, v), geometry::derivative_v(patch, u, v));
        if (p.z > cell_bed_mm(pavement)) {
          EXPECT_GT(normal.z, 0.0);
        }
        highest = std::max(highest, p.z);
      });
      EXPECT_GT(highest, cell_bed_mm(pavement) + 0.7 * pavement.surface.height_mm);
      EXPECT_LT(highest, cell_top_mm(pavement));
    }
  }
}

TEST(CellBody, AnEllipseAndALamesCurveAreWhatRoundnessSays) {
  Pavement pavement = of_cells(CellForm::scale);
  pavement.cell.overlap = 0.0;
  for (const auto& [roundness, at_the_diagonal] : {std::pair(1.0, std::sqrt(0.5)), std::pair(0.0, std::pow(2.0, -1.0 / 9.0))}) {
    pavement.cell.roundness = roundness;
    double farthest = 0.0;
    for_each_point(cell_patches(square_cell, draws_of(pavement, 1)),
                   [&](const geometry::BezierPatch& patch, double u, double v) {
                     const vec3 p = geometry::point(patch, u, v);
                     const vec2 from = vec2{p.x, p.y} - vec2{50, 50};
                     if (std::abs(std::abs(from.x) - std::abs(from.y)) < 1.0) farthest = std::max(farthest, std::abs(from.x));
                   });
    EXPECT_NEAR(farthest / 50.0, at_the_diagonal, 0.03) << roundness;
  }
}

TEST(CellBody, NeighbouringPatchesMeetSmoothly) {
  for (const CellForm form : {CellForm::cobble, CellForm::scale}) {
    const auto patches = cell_patches(odd_cell, draws_of(of_cells(form), 3));
    ASSERT_EQ(patches.size(), 16U);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        const geometry::BezierPatch& one = patches[4 * row + column];
        const geometry::BezierPatch& next = patches[4 * (row + 1) + column];
        for (const double v : {0.0, 0.3, 0.5, 1.0}) {
          EXPECT_LT(glm::length(geometry::point(one, 1.0, v) - geometry::point(next, 0.0, v)), 1e-9);
          EXPECT_LT(glm::length(geometry::derivative_u(one, 1.0, v) - geometry::derivative_u(next, 0.0, v)), 1e-6);
        }
      }
    }
  }
}

// Also in the corners of patches at the rim, which is smooth, so that both ways through them run alike.
TEST(CellBody, HasANormalEverywhere) {
  const auto length_at = [](const geometry::BezierPatch& patch, double u, double v) {
    return glm::length(geometry::unit_normal(patch, u, v));
  };
  for (const CellForm form : {CellForm::cobble, CellForm::scale}) {
    for (std::uint64_t stone = 0; stone < 50; ++stone) {
      const auto patches = cell_patches(uneven(3 + static_cast<int>(stone) % 5, stone), draws_of(of_cells(form), stone));
      for_each_point(patches, [&](const geometry::BezierPatch& patch, double u, double v) {
        EXPECT_NEAR(length_at(patch, u, v), 1.0, 1e-9) << stone << ' ' << u << ' ' << v;
      });
      // At the rim it faces outwards: the corner of the first patch lies at the lower left of its cell.
      const vec3 normal = geometry::unit_normal(patches.front(), 0.0, 0.0);
      const vec3 beside = geometry::unit_normal(patches.front(), 0.1, 0.1);
      EXPECT_GT(glm::dot(normal, beside), 0.8) << stone;
    }
  }
}

// Where the tip of a scale ends, beyond its outline along the heading, mm.
double tip_mm(const Pavement& pavement, vec2 heading) {
  CellDraws draws = draws_of(pavement, 1);
  draws.heading = heading;
  double farthest = 0.0;
  for_each_point(cell_patches(square_cell, draws), [&](const geometry::BezierPatch& patch, double u, double v) {
    const vec3 p = geometry::point(patch, u, v);
    farthest = std::max(farthest, glm::dot(vec2{p.x, p.y} - vec2{50, 50}, heading));
  });
  return farthest;
}

TEST(CellBody, TheTipOfAScaleLiesOverTheNext) {
  Pavement pavement = of_cells(CellForm::scale);
  const vec2 heading{std::sqrt(0.5), std::sqrt(0.5)};
  pavement.cell.overlap = 0.0;
  const double without = tip_mm(pavement, heading);
  pavement.cell.overlap = 0.4;
  // By 0.4 of its length, and by what the whole of it is larger for that.
  EXPECT_NEAR(tip_mm(pavement, heading), (1.0 + 0.35 * 0.4) * without + 0.4 * 2.0 * without, 1.0);
  EXPECT_LT(tip_mm(pavement, heading) - 50.0 * std::sqrt(2.0), reach_of_cell_mm(square_cell, pavement.cell));
  // Of two scales one behind the other, what is over both is seen of the one behind: its tip is higher there.
  CellDraws draws = draws_of(pavement, 1);
  draws.heading = heading;
  geometry::Polygon ahead = square_cell;
  for (vec2& p : ahead) p += vec2{104, 104};
  const vec2 shared = vec2{50, 50} + 1.5 * without * heading;
  EXPECT_GT(geometry::height_at(cell_patches(square_cell, draws), shared),
            geometry::height_at(cell_patches(ahead, draws), shared));
}

TEST(CellBody, ScalesPointAlongTheDirectionAndStandOnTheirCorners) {
  for (const double degrees : {0.0, 90.0, -135.0}) {
    Pavement pavement = of_cells(CellForm::scale);
    pavement.direction = straight(degrees);
    const StoneLayout layout = laid_stones(pavement, 1);
    EXPECT_EQ(faults(pavement, layout).total(), 0U);
    for (const Stone& stone : layout.stones) {
      EXPECT_NEAR(glm::dot(stone.angle.direction(), Angle::degrees(degrees).direction()), 1.0, 1e-9);
      if (stone.kind != StoneKind::whole) continue;
      const vec2 side = glm::normalize(stone.outline_mm[1] - stone.outline_mm[0]);
      EXPECT_NEAR(std::abs(glm::dot(side, stone.angle.direction())), std::sqrt(0.5), 1e-4);
    }
  }
  // Round a circle they follow one another.
  Pavement round = of_cells(CellForm::scale);
  round.area = quarter_annulus();
  round.stone_mm = {200, 200};
  round.direction = RadialDirection{{0, 0}, 0.0};
  const StoneLayout layout = laid_stones(round, 1);
  EXPECT_EQ(faults(round, layout).total(), 0U);
  for (const Stone& stone : layout.stones) {
    const vec2 middle = geometry::centroid(stone.outline_mm);
    EXPECT_GT(glm::dot(stone.angle.direction(), left_of(middle / glm::length(middle))), 0.999);
  }
}

}  // namespace
}  // namespace shatterpave::paving
