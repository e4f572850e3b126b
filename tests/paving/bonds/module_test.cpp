// Modules: patterns that a user drew (paving/bonds/module_cells.h).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/functions.h"
#include "core/random.h"
#include "geometry/corners.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "geometry/voronoi.h"
#include "measure/bare_spot.h"
#include "measure/stone_index.h"
#include "measure/stone_stock.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/module_cells.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "paving/seamless.h"

namespace shatterpave::paving {
namespace {

using geometry::Polygon;

DrawnModule drawing(const std::vector<Polygon>& shapes, vec2 first, vec2 second) {
  DrawnModule drawn{{}, first, second, {"scene.toml", 1, 1, "module_file"}, {"scene.toml", 2, 2, "module_mm"}};
  for (Polygon shape : shapes) {
    for (vec2& p : shape) p = geometry::on_lattice(p);
    drawn.stones.push_back({{std::move(shape), {}}, {"tile.svg", static_cast<int>(drawn.stones.size()) + 1, 1, ""}});
  }
  return drawn;
}

Polygon rectangle_at(double x, double y, double width, double height) {
  return geometry::rectangle({{x, y}, {x + width, y + height}});
}

Pavement laid_as(const DrawnModule& drawn, geometry::Region area, double joint_mm, double degrees) {
  Pavement result = pavement(std::move(area), 100, joint_mm, straight(degrees));
  result.bonding.bond = Bond::drawn_module;
  lay_as_drawn(result, drawn);
  return result;
}

// Stones by where they are, since ids follow the order of tiles.
std::vector<Stone> sorted(StoneLayout layout) {
  std::ranges::sort(layout.stones, [](const Stone& a, const Stone& b) {
    const vec2 p = geometry::centroid(a.outline_mm);
    const vec2 q = geometry::centroid(b.outline_mm);
    return std::abs(p.x - q.x) > 0.1 ? p.x < q.x : p.y < q.y;
  });
  return layout.stones;
}

// From each corner of the one to the nearest of the other, the farthest.
double farthest_corner_mm(const Polygon& one, const Polygon& other) {
  double farthest = 0.0;
  for (const vec2& p : one) {
    double nearest = 1e300;
    for (const vec2& q : other) nearest = std::min(nearest, glm::length(p - q));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// A corner is rounded once for each, along x and along y.
constexpr double a_micrometre = 0.0015;

void expect_same(const Pavement& one, const Pavement& other) {
  const std::vector<Stone> a = sorted(laid_stones(one, 3));
  const std::vector<Stone> b = sorted(laid_stones(other, 3));
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 100U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LE(farthest_corner_mm(a[i].outline_mm, b[i].outline_mm), a_micrometre) << i;
    EXPECT_LE(farthest_corner_mm(b[i].outline_mm, a[i].outline_mm), a_micrometre) << i;
    EXPECT_EQ(a[i].kind, b[i].kind) << i;
    EXPECT_NEAR(a[i].angle.radians(), b[i].angle.radians(), 1e-9) << i;
  }
}

TEST(Module, ThatDrawsRunningBondLiesAsRunningBondDoes) {
  for (const double degrees : {0.0, 27.0}) {
    Pavement running = pavement(concave_area(), 100, 8, straight(degrees));
    running.stone_mm = {200, 100};
    running.bonding.bond = Bond::running;
    // With the joint about the stone; the stone alone, with the joint as a gap; two of them, on the way that is not the
    // shortest.
    const auto touching = drawing({rectangle_at(30, -70, 208, 108)}, {208, 0}, {104, 108});
    const auto apart = drawing({rectangle_at(30, -70, 200, 100)}, {104, 108}, {-104, 108});
    const auto two = drawing({rectangle_at(0, 0, 208, 108), rectangle_at(104, 108, 208, 108)}, {0, 216}, {208, 216 * 3});
    for (const DrawnModule& drawn : {touching, apart, two}) {
      const Pavement paved = laid_as(drawn, concave_area(), 8, degrees);
      EXPECT_NEAR(paved.stone_mm.x, 200.0, a_micrometre);
      EXPECT_NEAR(paved.stone_mm.y, 100.0, a_micrometre);
      expect_same(paved, running);
    }
  }
}

// Whole stones; which of the small pieces at the border are joined is decided by the box about a stone, which is not `stone_mm`
// of a hexagon.
TEST(Module, ThatDrawsHexagonsLiesAsHexagonsDo) {
  Pavement hexagons = pavement(concave_area(), 150, 6, straight(12));
  hexagons.bonding.bond = Bond::hexagon;
  hexagons.bonding.start_mm = vec2{700, 900};
  const Polygon shape = periodic_pattern(hexagons)->tiles.front().outline_mm;
  const double width = 156.0;
  Pavement paved = laid_as(drawing({shape}, {width, 0}, {0.5 * width, 0.5 * std::sqrt(3.0) * width}), concave_area(), 6, 12);
  EXPECT_EQ(paved.bonding.module_drawn.stones.front().cell_mm.front(), (vec2{0.0, 0.0}));
  // Both begin with a corner of their first tile, which need not be the same one.
  const auto same = std::ranges::min_element(shape, {}, [](vec2 p) { return std::round(1e3 * (p.x + p.y)) * 1e6 + p.y; });
  const vec2 along = Angle::degrees(12).direction();
  const vec2 from = *same - shape.front();
  paved.bonding.start_mm = *hexagons.bonding.start_mm + from.x * along + from.y * left_of(along);
  const std::vector<Stone> laid = laid_stones(paved, 3).stones;
  std::size_t seen = 0;
  std::size_t found = 0;
  for (const Stone& stone : laid_stones(hexagons, 3).stones) {
    if (stone.kind != StoneKind::whole) continue;
    ++seen;
    found += std::ranges::any_of(laid, [&](const Stone& other) {
      return farthest_corner_mm(stone.outline_mm, other.outline_mm) <= 2.0 * a_micrometre;  // the drawing is rounded, too
    });
  }
  EXPECT_GT(seen, 500U);
  EXPECT_GE(static_cast<double>(found), 0.99 * static_cast<double>(seen));
}

// A hand drew them, on a grid of 0.1 mm: corners that were meant to be one are one.
TEST(Module, IsAsExactAsItWasMeant) {
  const auto meant = drawing({rectangle_at(0, 0, 300, 200), rectangle_at(300, 0, 100, 100), rectangle_at(300, 100, 100, 100)},
                             {400, 0}, {100, 200});
  const auto drawn = drawing({{{0, 0}, {300.1, 0.05}, {300, 200.1}, {-0.05, 199.95}},
                              rectangle_at(300, 0, 100.1, 99.9),
                              {{299.9, 100}, {400, 100}, {400.1, 200}, {300, 200}}},
                             {400, 0}, {100, 200});
  const Pavement exact = laid_as(meant, concave_area(), 5, 0);
  const Pavement paved = laid_as(drawn, concave_area(), 5, 0);
  const StoneLayout layout = laid_stones(paved, 1);
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  EXPECT_EQ(layout.stones.size(), laid_stones(exact, 1).stones.size());
  for (const Module::Stone& stone : paved.bonding.module_drawn.stones) EXPECT_EQ(stone.cell_mm.size(), 4U);
}

// Corners that are rounded where the drawing has joints leave less bare than a joint is wide.
TEST(Module, TakesStonesWithRoundedCorners) {
  Polygon shape;
  for (int i = 0; i < 32; ++i) {
    const double angle = (static_cast<double>(i) + 0.5) / 16.0 * pi;
    const vec2 direction{cosine(angle), sine(angle)};
    shape.push_back(92.0 * vec2{std::copysign(1.0, direction.x), std::copysign(1.0, direction.y)} + 8.0 * direction);
  }
  const Pavement paved = laid_as(drawing({shape}, {210, 0}, {0, 210}), concave_area(), 10, 0);
  EXPECT_EQ(faults(paved, laid_stones(paved, 1)).total(), 0U);
  EXPECT_NEAR(paved.stone_mm.x, 200.0, 0.1);
}

// ---- any module

class ModuleDraws {
 public:
  explicit ModuleDraws(std::uint64_t number) : id_(Id("random module").child(number)) {}
  double between(double low, double high) { return low + (high - low) * uniform(5, {Stream::packing, id_, next_++}); }
  int count(int low, int high) { return low + static_cast<int>(between(0.0, static_cast<double>(high - low + 1))); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  Id id_;
  std::uint32_t next_ = 0;
};

struct RandomModule {
  std::vector<Polygon> shapes;
  vec2 first{1.0, 0.0};
  vec2 second{0.0, 1.0};
};

RandomModule sides_of_random_module(ModuleDraws& draws) {
  RandomModule result;
  const double angle = draws.between(-pi, pi);
  const double between = draws.between(0.2, 0.8) * pi;
  result.first = draws.between(300, 900) * vec2{cosine(angle), sine(angle)};
  result.second = draws.between(300, 900) * vec2{cosine(angle + between), sine(angle + between)};
  result.first = geometry::on_lattice(result.first);
  result.second = geometry::on_lattice(result.second);
  return result;
}

// The Voronoi cells of a few seeds that repeat.
RandomModule random_cells(ModuleDraws& draws) {
  RandomModule result = sides_of_random_module(draws);
  std::vector<vec2> own;
  const int count = draws.count(1, 9);
  for (int i = 0; i < count; ++i) {
    own.push_back(geometry::on_lattice(draws.between(0, 1) * result.first + draws.between(0, 1) * result.second));
  }
  constexpr int around = 5;
  std::vector<vec2> seeds = own;
  for (int j = -around; j <= around; ++j) {
    for (int i = -around; i <= around; ++i) {
      if (i == 0 && j == 0) continue;
      for (const vec2& p : own) seeds.push_back(geometry::on_lattice(p + double(i) * result.first + double(j) * result.second));
    }
  }
  const geometry::Voronoi diagram = geometry::voronoi(seeds);
  for (std::size_t i = 0; i < own.size(); ++i) result.shapes.push_back(diagram.outline(i));
  return result;
}

// A parallelogram that is cut straight across again and again, some parts with a notch that their neighbour fills.
RandomModule random_cuts(ModuleDraws& draws) {
  RandomModule result = sides_of_random_module(draws);
  std::vector<geometry::Box> parts{{{0.0, 0.0}, {1.0, 1.0}}};
  const int cuts = draws.count(0, 8);
  for (int cut = 0; cut < cuts; ++cut) {
    const auto largest =
        std::ranges::max_element(parts, {}, [](const geometry::Box& b) { return (b.high.x - b.low.x) * (b.high.y - b.low.y); });
    geometry::Box rest = *largest;
    const double at = draws.between(0.3, 0.7);
    if (rest.high.x - rest.low.x > rest.high.y - rest.low.y) {
      largest->high.x = rest.low.x = std::lerp(rest.low.x, rest.high.x, at);
    } else {
      largest->high.y = rest.low.y = std::lerp(rest.low.y, rest.high.y, at);
    }
    parts.push_back(rest);
  }
  for (const geometry::Box& part : parts) {
    Polygon shape;
    for (const vec2& p : geometry::corners(part)) shape.push_back(p.x * result.first + p.y * result.second);
    result.shapes.push_back(std::move(shape));
  }
  // A wave in the sides along the second vector, which all that lie on them share: the whole is sheared, not straight.
  if (draws.chance(0.4) && cuts == 0) {
    const vec2 out = 0.15 * result.first + 0.1 * result.second;
    const Polygon straight = result.shapes.front();
    result.shapes.front() = {straight[0], straight[1], straight[1] + 0.5 * result.second + out,
                             straight[2], straight[3], straight[0] + 0.5 * result.second + out};
  }
  return result;
}

TEST(Module, LaysAnyDrawingWithoutFaults) {
  int laid = 0;
  int refused = 0;
  for (std::uint64_t number = 0; laid < 60 && number < 200; ++number) {
    ModuleDraws draws(number);
    const RandomModule any = draws.chance(0.5) ? random_cells(draws) : random_cuts(draws);
    DrawnModule drawn = drawing(any.shapes, any.first, any.second);
    for (DrawnStone& stone : drawn.stones) {
      if (geometry::area(stone.shape_mm.outline) < 0.0) std::ranges::reverse(stone.shape_mm.outline);
    }
    const geometry::Region area = draws.chance(0.5) ? concave_area() : path_area();
    Pavement paved = pavement(area, 100, draws.chance(0.2) ? 0.0 : draws.between(1, 14), straight(draws.between(0, 180)));
    paved.bonding.bond = Bond::drawn_module;
    try {
      lay_as_drawn(paved, drawn);
    } catch (const InputError& error) {
      // Of these drawings, only stones that are too narrow, or bare beside sharp corners.
      EXPECT_NE(error.message().find("mm wide or more beside joint_mm"), std::string::npos) << number << ": " << error.what();
      ++refused;
      continue;
    }
    ++laid;
    if (draws.chance(0.25)) paved.hand.amount = draws.between(0.1, 1.0);
    if (draws.chance(0.25)) paved.border = {BorderCourse::soldier, {200, 100}};
    if (draws.chance(0.3)) paved.bonding.turn = Angle::degrees(draws.between(0, 90));
    if (draws.chance(0.3)) paved.bonding.start_mm = vec2{draws.between(0, 999), draws.between(0, 999)};
    const StoneLayout layout = laid_stones(paved, number);
    EXPECT_EQ(faults(paved, layout).total(), 0U) << number;
    // What rounded corners of stones laid by hand leave bare is no fault.
    if (paved.hand.amount == 0.0) {
      const geometry::RegionIndex index(paved.area);
      const measure::StoneIndex stones(layout, std::max(paved.stone_mm.x, paved.stone_mm.y) + paved.joint_mm);
      EXPECT_LE(2.0 * measure::widest_bare_spot(paved, layout, stones, index).radius, measure::widest_allowed_spot_mm(paved))
          << number;
    }
    const measure::StockLimit limit = measure::stock_limit(paved);
    for (const Stone& stone : layout.stones) {
      if (stone.part != StonePart::field || paved.hand.amount > 0.0) continue;
      const measure::StockShare share = measure::stock_share(stone.outline_mm, limit);
      EXPECT_LE(std::max({share.length, share.width, share.area}), 1.0005) << number << ", " << stone.id;
    }
  }
  EXPECT_EQ(laid, 60);
  EXPECT_LT(refused, 60);
}

// The wrong twin of what is laid without faults: a hundredth off one vector.
TEST(Module, HasFaultsWhereItRepeatsTooSoon) {
  Pavement paved = laid_as(drawing({rectangle_at(0, 0, 300, 200), rectangle_at(300, 0, 100, 200)}, {400, 0}, {100, 200}),
                           concave_area(), 1, 0);
  EXPECT_EQ(faults(paved, laid_stones(paved, 1)).total(), 0U);
  paved.bonding.module_drawn.across_mm *= 0.99;
  EXPECT_GT(faults(paved, laid_stones(paved, 1)).overlaps, 50U);
}

// Whole stones are all as they were drawn, and together with their joints as large as the vectors span.
TEST(Module, HasItsStonesInTheirShares) {
  const auto drawn =
      drawing({rectangle_at(0, 0, 400, 600), rectangle_at(400, 0, 400, 400), rectangle_at(800, 200, 400, 400),
               rectangle_at(400, 400, 400, 200), rectangle_at(400, 600, 200, 200), rectangle_at(1000, 600, 200, 200)},
              {1200, 0}, {200, 600});
  // The shapes of scenes/versailles.svg, upside down: they are refused, those of the file are laid by scripts.module.
  EXPECT_THROW(laid_as(drawn, concave_area(), 8, 0), InputError);
  const auto right =
      drawing({rectangle_at(0, 200, 400, 600), rectangle_at(400, 0, 400, 400), rectangle_at(800, 200, 400, 400),
               rectangle_at(400, 400, 400, 200), rectangle_at(400, 600, 200, 200), rectangle_at(1000, 600, 200, 200)},
              {1200, 0}, {200, 600});
  const Pavement paved = laid_as(right, {{{0, 0}, {12000, 0}, {12000, 12000}, {0, 12000}}, {}}, 8, 0);
  EXPECT_NEAR(paved.stone_mm.x, 192.0, a_micrometre);
  std::size_t small = 0;
  std::size_t whole = 0;
  for (const Stone& stone : laid_stones(paved, 1).stones) {
    if (stone.kind != StoneKind::whole) continue;
    ++whole;
    if (std::abs(geometry::area(stone.outline_mm) - 192.0 * 192.0) < 2.0) ++small;
  }
  EXPECT_NEAR(static_cast<double>(small) / static_cast<double>(whole), 2.0 / 6.0, 0.03);
}

TEST(Module, MakesSeamlessTiles) {
  const auto drawn =
      drawing({rectangle_at(0, 200, 400, 600), rectangle_at(400, 0, 400, 400), rectangle_at(800, 200, 400, 400),
               rectangle_at(400, 400, 400, 200), rectangle_at(400, 600, 200, 200), rectangle_at(1000, 600, 200, 200)},
              {1200, 0}, {200, 600});
  Pavement paved = laid_as(drawn, concave_area(), 8, 0);
  paved.textures.tile_mm = vec2{3600, 3600};
  const SeamlessTile tile = seamless_tile(paved, 1);
  EXPECT_EQ(tile.layout.stones.size(), 108U);  // 18 repeats of six stones
  double area = 0.0;
  for (const Stone& stone : tile.layout.stones) area += geometry::area(stone.outline_mm);
  const double one = 392.0 * 592 + 2 * 392.0 * 392 + 392.0 * 192 + 2 * 192.0 * 192;
  EXPECT_NEAR(area, 18.0 * one, 200.0);
}

// ---- what is no module

std::string refusal(const DrawnModule& drawn, double joint_mm = 8.0) {
  try {
    laid_as(drawn, concave_area(), joint_mm, 0);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Module, RefusesWhatDoesNotPave) {
  const Polygon square = rectangle_at(0, 0, 200, 200);
  EXPECT_EQ(refusal(drawing({square}, {200, 0}, {400, 0})),
            "scene.toml:2:2: module_mm: expected two vectors of 1 mm or more that are not parallel, got [200, 0] and [400, 0]");
  EXPECT_EQ(refusal(drawing({square}, {0, 0}, {0, 200})),
            "scene.toml:2:2: module_mm: expected two vectors of 1 mm or more that are not parallel, got [0, 0] and [0, 200]");
  EXPECT_EQ(refusal(drawing({square}, {100, 0}, {0, 200})),
            "scene.toml:2:2: module_mm: expected vectors that span the area of the shapes, 0.04 m², got a span of 0.02 m²");
  EXPECT_EQ(
      refusal(drawing({square}, {198, 0}, {0, 200})),
      "tile.svg:1:1: expected shapes that do not overlap, got one that lies over its own repeat, by 2.00 mm at (199.0, 100.0)");
  EXPECT_EQ(
      refusal(drawing({square, rectangle_at(190, 0, 110, 200)}, {300, 0}, {0, 200})),
      "tile.svg:2:1: expected shapes that do not overlap, got one that lies over shape 0 or a repeat of it, by 10.00 mm at "
      "(195.0, 100.0)");
  const std::string bare =
      "scene.toml:1:1: module_file: expected shapes that touch, or gaps of one width between all of them up to joint_mm = 8, ";
  EXPECT_EQ(refusal(drawing({square}, {210, 0}, {0, 210})).substr(0, bare.size()), bare);
  EXPECT_EQ(refusal(drawing({square}, {210, 0}, {0, 200})).substr(0, bare.size()), bare);
  EXPECT_EQ(refusal(drawing({square}, {206, 0}, {0, 203})).substr(0, bare.size()), bare) << "two widths";
  EXPECT_EQ(refusal(drawing({square, rectangle_at(200, 0, 100, 100)}, {300, 0}, {0, 200})).substr(0, bare.size()), bare);
  EXPECT_EQ(refusal(drawing({square, rectangle_at(200, 0, 8.5, 200)}, {208.5, 0}, {0, 200})),
            "tile.svg:2:1: expected a stone that is 1 mm wide or more beside joint_mm = 8, got 0.50 mm");
  DrawnModule with_hole = drawing({square}, {200, 0}, {0, 200});
  with_hole.stones.front().shape_mm.holes = {{{50, 50}, {50, 60}, {60, 60}}};
  EXPECT_EQ(refusal(with_hole), "tile.svg:1:1: expected a stone, which has no hole, got a shape with 1");
  EXPECT_EQ(refusal(drawing({{{0, 0},
                              {90, 0},
                              {90, 47},
                              {110, 47},
                              {110, 0},
                              {200, 0},
                              {200, 100},
                              {110, 100},
                              {110, 53},
                              {90, 53},
                              {90, 100},
                              {0, 100}},
                             rectangle_at(90, 53, 20, 94)},
                            {200, 0}, {0, 100})),
            "tile.svg:1:1: expected a stone that is wider than joint_mm = 8 everywhere, got one that falls into 2");
  EXPECT_EQ(refusal(drawing(std::vector<Polygon>(1001, square), {200, 0}, {0, 200})),
            "scene.toml:1:1: module_file: expected a drawing of at most 1000 closed shapes, got 1001");
  EXPECT_EQ(refusal(drawing({{{0, 0}, {60000, 0}, {60000, 1}, {0, 1}}}, {1000, 0}, {0.0, 60.0})),
            "tile.svg:1:1: expected a stone that reaches over at most 50 repeats, got 60");
  EXPECT_EQ(refusal(drawing({square}, {200, 0}, {0, 200})), "none");
}

}  // namespace
}  // namespace shatterpave::paving
