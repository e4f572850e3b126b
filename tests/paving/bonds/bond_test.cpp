#include "paving/bonds/bond.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "paving/bonds/table.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "paving/tiles/cutting.h"

namespace shatterpave::paving {
namespace {

const Direction level = ConstantDirection{};

geometry::Region rectangle(double width, double height) { return {{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}; }

Pavement bonded(Bond bond, vec2 stone_mm, double joint_mm, geometry::Region area, Direction direction = level) {
  Pavement result = pavement(std::move(area), 100, joint_mm, std::move(direction));
  result.bonding.bond = bond;
  result.stone_mm = stone_mm;
  return result;
}

struct BondCase {
  const char* name;
  Bond bond;
  vec2 stone_mm;
  double joint_mm;
  double mean_area;  // of whole stones, over stone_mm's
};

class EveryBond : public testing::TestWithParam<BondCase> {};

const std::vector<BondCase> every_bond = {
    {"running", Bond::running, {200, 100}, 6, 1.0},
    {"stack", Bond::stack, {150, 100}, 6, 1.0},
    {"herringbone", Bond::herringbone, {200, 100}, 4, 1.0},
    {"basket_weave", Bond::basket_weave, {200, 65}, 4, 0.985},  // three to a block of 204: 64 wide
    {"hexagon", Bond::hexagon, {150, 150}, 6, 0.866},
    {"segmental_arc", Bond::segmental_arc, {90, 90}, 8, 0.92},
    {"fan", Bond::fan, {90, 90}, 8, 0.98},
    {"ashlar", Bond::ashlar, {140, 140}, 8, 3.2},
    {"crazy", Bond::crazy, {200, 200}, 10, 1.0},
    {"chevron", Bond::chevron, {300, 90}, 4, 1.0},
    {"module", Bond::drawn_module, {180, 110}, 6, 1.0},  // none is drawn: stones of that size; others in module_test.cpp
};

TEST(Bonds, AreAllAmongEveryBond) {
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes || type->bending == Bending::packed) continue;
    EXPECT_EQ(std::ranges::count(every_bond, Bond(type->id), &BondCase::bond), 1) << std::string_view(type->name);
  }
}

// The share of stones below `least_piece`: only where no stone that fits the stock can be made of one and its neighbours.
double share_of_small(const Pavement& paved, const StoneLayout& layout) {
  const auto small = std::ranges::count_if(layout.stones, [&](const Stone& stone) {
    return geometry::area(stone.outline_mm) < least_piece * whole_face_mm2(paved);
  });
  return static_cast<double>(small) / static_cast<double>(layout.stones.size());
}

void expect_good(const Pavement& paved, const StoneLayout& layout, const BondCase& bond) {
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  const LayoutQuality q = quality(paved, layout);
  EXPECT_GT(q.whole, q.stones / 3);
  EXPECT_GE(q.coverage, 0.995);
  EXPECT_GE(q.joint_p5, 0.9);
  EXPECT_LE(q.joint_p95, 1.1);
  EXPECT_LT(share_of_small(paved, layout), 0.02);
  EXPECT_NEAR(q.mean_area, bond.mean_area, 0.08 * bond.mean_area);
}

TEST_P(EveryBond, IsExactOnARectangleAndAConcaveOutlineWithAHole) {
  const BondCase& bond = GetParam();
  for (const geometry::Region& area : {rectangle(3000, 2000), concave_area()}) {
    for (const double degrees : {0.0, 27.0}) {
      const Pavement paved = bonded(bond.bond, bond.stone_mm, bond.joint_mm, area, straight(degrees));
      expect_good(paved, laid_stones(paved, 3), bond);
    }
  }
}

TEST_P(EveryBond, IsExactOnABentPlanAlongEveryField) {
  const BondCase& bond = GetParam();
  const GuidesDirection guides{{{{0, 7000}, {5000, 5000}, {7000, 0}}}};
  for (const Direction& direction : {Direction(RadialDirection{}), Direction(BoundaryDirection{}), Direction(guides)}) {
    const Pavement paved = bonded(bond.bond, 2.0 * bond.stone_mm, bond.joint_mm, quarter_annulus(), direction);
    const StoneLayout layout = laid_stones(paved, 3);
    EXPECT_EQ(faults(paved, layout).total(), 0U);
    EXPECT_GE(quality(paved, layout).coverage, 0.995);
  }
}

TEST_P(EveryBond, IsTheSameWithAnyNumberOfThreads) {
  const BondCase& bond = GetParam();
  const Pavement paved = bonded(bond.bond, bond.stone_mm, bond.joint_mm, path_area());
  std::vector<StoneLayout> layouts;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    layouts.push_back(laid_stones(paved, 7));
  }
  EXPECT_EQ(layouts[0], layouts[1]);
  EXPECT_EQ(layouts[0], layouts[2]);
}

TEST_P(EveryBond, BearsOddAreas) {
  const BondCase& bond = GetParam();
  const std::vector<geometry::Region> areas = {
      {{{0, 0}, {5000, 0}, {5000, 30}, {0, 30}}, {}},
      {{{0, 0}, {0.004, 0}, {0, 0.004}}, {}},
      {{{0, 0}, {8000, 10}, {0, 20}}, {}},
      {{{0, 0}, {900, 0}, {900, 900}, {0, 900}}, {circle({450, 450}, 20, 12)}},
      {{{0, 0}, {900, 0}, {900, 900}, {0, 900}}, {{{450, 450}, {450, 900}, {300, 600}}, {{450, 450}, {600, 300}, {450, 300}}}},
  };
  for (const geometry::Region& area : areas) {
    for (const double joint_mm : {0.0, 8.0, 120.0}) {
      for (const Direction& direction : {straight(10), Direction(RadialDirection{{450, 450}}), Direction(BoundaryDirection{}),
                                         Direction(GuidesDirection{{{{0, 0}, {400, 300}, {900, 300}}}})}) {
        const Pavement paved = bonded(bond.bond, bond.stone_mm, joint_mm, area, direction);
        EXPECT_EQ(faults(paved, laid_stones(paved, 1)).total(), 0U) << &area - areas.data() << ", joint " << joint_mm;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bonds, EveryBond, testing::ValuesIn(every_bond),
                         [](const auto& named) { return std::string(named.param.name); });

// ---- each bond by itself: counts that follow from the sizes, and what makes it that bond

std::size_t whole(const StoneLayout& layout) {
  return static_cast<std::size_t>(std::ranges::count(layout.stones, StoneKind::whole, &Stone::kind));
}

TEST(Bonds, CountsAreExactWhereThePatternFits) {
  // 4 × 6 stones with joints; every second row of the running bond begins and ends with half a stone.
  const geometry::Region area = rectangle(4 * 206, 6 * 106);
  EXPECT_EQ(whole(laid_stones(bonded(Bond::stack, {200, 100}, 6, area), 1)), 24U);
  EXPECT_EQ(laid_stones(bonded(Bond::stack, {200, 100}, 6, area), 1).stones.size(), 24U);
  const StoneLayout running = laid_stones(bonded(Bond::running, {200, 100}, 6, area), 1);
  EXPECT_EQ(whole(running), 3U * 4U + 3U * 3U);
  EXPECT_EQ(running.stones.size(), 3U * 4U + 3U * 5U);
  // Blocks of 204 of two.
  const geometry::Region blocks = rectangle(6 * 204, 4 * 204);
  EXPECT_EQ(whole(laid_stones(bonded(Bond::basket_weave, {200, 98}, 4, blocks), 1)), 48U);
  EXPECT_EQ(laid_stones(bonded(Bond::basket_weave, {200, 98}, 4, blocks), 1).stones.size(), 48U);
  // Ashlar fills whole modules.
  const StoneLayout ashlar = laid_stones(bonded(Bond::ashlar, {90, 90}, 10, rectangle(3000, 3000)), 1);
  double modules = 0.0;
  for (const Stone& stone : ashlar.stones) {
    const geometry::Box box = geometry::bounding_box(stone.outline_mm);
    modules += (box.high.x - box.low.x + 10) * (box.high.y - box.low.y + 10) / 1e4;
  }
  EXPECT_NEAR(modules, 900.0, 1e-6);
}

// Left ends of the whole stones of each row, by the row's lower side.
std::map<double, std::vector<double>> rows_of(const StoneLayout& layout) {
  std::map<double, std::vector<double>> rows;
  for (const Stone& stone : layout.stones) {
    const geometry::Box box = geometry::bounding_box(stone.outline_mm);
    if (stone.kind == StoneKind::whole) rows[box.low.y].push_back(box.low.x);
  }
  return rows;
}

// How far each row has moved on against the one below it, as a part of the pitch.
std::vector<double> staggers(const StoneLayout& layout, double pitch) {
  std::vector<double> result;
  const auto rows = rows_of(layout);
  for (auto row = rows.begin(); std::next(row) != rows.end(); ++row) {
    const double moved = (std::next(row)->second.front() - row->second.front()) / pitch;
    result.push_back(moved - std::floor(moved + 1e-9));
  }
  return result;
}

bool all_staggered_by(const StoneLayout& layout, double pitch, double offset) {
  const auto found = staggers(layout, pitch);
  return found.size() > 5 && std::ranges::all_of(found, [&](double s) { return std::abs(s - offset) < 1e-4; });
}

TEST(Bonds, RunningBondMovesOnByItsOffset) {
  for (const double offset : {0.25, 1.0 / 3.0, 0.5}) {
    Pavement paved = bonded(Bond::running, {200, 65}, 8, rectangle(3000, 1500));
    paved.bonding.offset = offset;
    EXPECT_TRUE(all_staggered_by(laid_stones(paved, 1), 208.0, offset));
    paved.bonding.offset = offset + 0.01;
    EXPECT_FALSE(all_staggered_by(laid_stones(paved, 1), 208.0, offset));
  }
  EXPECT_TRUE(all_staggered_by(laid_stones(bonded(Bond::stack, {200, 65}, 8, rectangle(3000, 1500)), 1), 208.0, 0.0));
}

// Of the whole stones that have a stone within half a length of the middle of one of their short ends, the share to which that
// stone stands at right angles.
double share_at_right_angles(const StoneLayout& layout, vec2 stone_mm) {
  double seen = 0.0;
  double square = 0.0;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    const vec2 along = stone.angle.direction();
    for (const double sign : {-1.0, 1.0}) {
      const vec2 probe = geometry::centroid(stone.outline_mm) + sign * (0.5 * stone_mm.x + 20.0) * along;
      for (const Stone& other : layout.stones) {
        if (other.kind != StoneKind::whole || !geometry::contains(other.outline_mm, geometry::on_lattice(probe))) continue;
        seen += 1.0;
        square += std::abs(glm::dot(along, other.angle.direction())) < 1e-9 ? 1.0 : 0.0;
      }
    }
  }
  return seen < 50.0 ? -1.0 : square / seen;
}

TEST(Bonds, HerringboneEndsOnStonesAtRightAngles) {
  for (const double turn : {0.0, 45.0}) {
    Pavement paved = bonded(Bond::herringbone, {200, 100}, 4, rectangle(2500, 2000));
    paved.bonding.turn = Angle::degrees(turn);
    EXPECT_EQ(share_at_right_angles(laid_stones(paved, 1), {200, 100}), 1.0);
    // By the way the stones lie against the rows.
    const auto stones = laid_stones(paved, 1).stones;
    for (const Stone& stone : stones) {
      if (stone.kind != StoneKind::whole) continue;  // odd pieces lie along their own longest side
      EXPECT_NEAR(std::remainder(stone.angle.degrees() - turn, 90.0), 0.0, 1e-9);
    }
  }
  EXPECT_EQ(share_at_right_angles(laid_stones(bonded(Bond::running, {200, 100}, 4, rectangle(2500, 2000)), 1), {200, 100}),
            0.0);
  EXPECT_LT(share_at_right_angles(laid_stones(bonded(Bond::basket_weave, {200, 98}, 4, rectangle(2500, 2000)), 1), {200, 98}),
            1.01);
}

TEST(Bonds, HexagonsAreRegular) {
  const StoneLayout layout = laid_stones(bonded(Bond::hexagon, {150, 150}, 6, rectangle(2000, 2000)), 1);
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    ASSERT_EQ(stone.outline_mm.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const vec2 side = stone.outline_mm[(i + 1) % 6] - stone.outline_mm[i];
      EXPECT_NEAR(glm::length(side), 150.0 / std::sqrt(3.0), 0.01);
    }
  }
}

// The widths of the joint between two facing sides at both ends: over all pairs of stones, the largest difference as a part of
// the asked joint. A wedge has a wide end.
double worst_wedge(const Pavement& paved, const StoneLayout& layout) {
  double worst = 0.0;
  std::size_t seen = 0;
  for (const Stone& stone : layout.stones) {
    for (const Stone& other : layout.stones) {
      if (&stone == &other || glm::length(stone.outline_mm[0] - other.outline_mm[0]) > 3.0 * paved.stone_mm.x) continue;
      for (std::size_t i = 0; i < stone.outline_mm.size(); ++i) {
        const vec2 a = stone.outline_mm[i];
        const vec2 d = stone.outline_mm[(i + 1) % stone.outline_mm.size()] - a;
        const double length = glm::length(d);
        if (length < 0.6 * paved.stone_mm.y) continue;
        for (std::size_t j = 0; j < other.outline_mm.size(); ++j) {
          const vec2 b = other.outline_mm[j];
          const vec2 e = other.outline_mm[(j + 1) % other.outline_mm.size()] - b;
          if (glm::length(e) < 0.6 * paved.stone_mm.y || glm::dot(d, e) > -0.9 * length * glm::length(e)) continue;
          const double t0 = glm::dot(b - a, d) / (length * length);
          const double t1 = glm::dot(b + e - a, d) / (length * length);
          const double w0 = -cross(d, b - a) / length;
          const double w1 = -cross(d, b + e - a) / length;
          // Facing over most of their length, and neighbours.
          if (std::abs(t1) > 0.2 || std::abs(t0 - 1.0) > 0.2 || std::min(w0, w1) < 0.0 || w0 + w1 > 3.0 * paved.joint_mm)
            continue;
          ++seen;
          worst = std::max(worst, std::abs(w1 - w0) / paved.joint_mm);
        }
      }
    }
  }
  return seen < 100 ? 1e9 : worst;
}

TEST(Bonds, JointsInArcsAreNotWedges) {
  for (const Bond bond : {Bond::segmental_arc, Bond::fan}) {
    const Pavement paved = bonded(bond, {90, 90}, 8, rectangle(2500, 2500));
    StoneLayout layout = laid_stones(paved, 1);
    EXPECT_LT(worst_wedge(paved, layout), 0.01);
    // Square setts in the same places have wedges between them.
    for (Stone& stone : layout.stones) {
      const vec2 middle = geometry::centroid(stone.outline_mm);
      const vec2 along = 45.0 * stone.angle.direction();
      const vec2 across = 45.0 * left_of(stone.angle.direction());
      stone.outline_mm = {middle - along - across, middle + along - across, middle + along + across, middle - along + across};
    }
    EXPECT_GT(worst_wedge(paved, layout), 0.2);
  }
  const Pavement rings = bonded(Bond::running, {100, 100}, 8, rectangle(2500, 2500), RadialDirection{{-500, -300}});
  EXPECT_LT(worst_wedge(rings, laid_stones(rings, 1)), 0.01);
}

// As a paviour lays them: in each course one stone lies across the valley between two arcs, and its perpends are those of no
// next course. The twin: arcs that are cut off at the valley.
TEST(Bonds, ArcsInterlockInTheirValleys) {
  constexpr double span = 1200.0;
  const auto courses_across = [&](const std::vector<Tile>& tiles, double least_mm) {
    std::set<int> courses;
    for (const Tile& tile : tiles) {
      const geometry::Box box = geometry::bounding_box(tile.outline_mm);
      const double valley = span * std::round(0.5 * (box.low.x + box.high.x) / span);
      if (valley - box.low.x < least_mm || box.high.x - valley < least_mm) continue;
      courses.insert(static_cast<int>(std::lround(box.low.y / 98.0)) % 2);
    }
    return courses.size();
  };
  Pavement paved = bonded(Bond::segmental_arc, {90, 90}, 8, rectangle(2500, 2500));
  paved.bonding.span_mm = span;
  std::vector<Tile> tiles = periodic_pattern(paved)->tiles;
  EXPECT_EQ(courses_across(tiles, 15.0), 2U);
  double narrowest = 1e9;
  double middle = 0.0;
  for (const Tile& tile : tiles) {
    const vec2 centre = geometry::centroid(tile.outline_mm);
    const double width = geometry::area(tile.outline_mm) / 98.0;
    narrowest = std::min(narrowest, width);
    if (std::abs(centre.x - 0.5 * span) < 60.0) middle = std::max(middle, width);
  }
  // Those in the valley stand upright.
  int in_valley = 0;
  for (const Tile& tile : tiles) {
    const geometry::Box box = geometry::bounding_box(tile.outline_mm);
    const double valley = span * std::round(0.5 * (box.low.x + box.high.x) / span);
    if (box.low.x > valley - 15.0 || box.high.x < valley + 15.0) continue;
    ++in_valley;
    EXPECT_NEAR(tile.axis.y, 0.0, 1e-12);
  }
  EXPECT_EQ(in_valley, 2);
  EXPECT_GT(middle, 95.0);
  EXPECT_LT(narrowest, 0.85 * middle);
  EXPECT_GT(narrowest, 0.7 * middle);
  for (Tile& tile : tiles) {
    for (vec2& p : tile.outline_mm) p.x = std::clamp(p.x, 0.0, span);
  }
  EXPECT_EQ(courses_across(tiles, 15.0), 0U);
}

// Where the ends of whole planks stand along the lines at which rows meet, mm from the last joint: on the near side of a line
// and on its far side. `depth` is that of a row, `step` what a plank takes of a line.
struct Ends {
  std::vector<double> near;
  std::vector<double> far;
  std::size_t off_line = 0;  // corners that lie on no line but for half the joint
};

Ends ends_of(const StoneLayout& layout, double joint_mm, double step, double depth) {
  Ends ends;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    for (const vec2& p : stone.outline_mm) {
      const double off = p.y - depth * std::round(p.y / depth);
      if (std::abs(std::abs(off) - 0.5 * joint_mm) > 0.005) ++ends.off_line;
      (off < 0.0 ? ends.near : ends.far).push_back(p.x - step * std::floor(p.x / step));
    }
  }
  return ends;
}

// The farthest that any of some places is from the nearest of the others, on a circle of `step`.
double farthest_apart(const std::vector<double>& some, const std::vector<double>& others, double step) {
  double farthest = 0.0;
  for (const double place : some) {
    double nearest = step;
    for (const double other : others) nearest = std::min(nearest, std::abs(std::remainder(place - other, step)));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(Bonds, ChevronsMeetInStraightLinesJointToJoint) {
  const double joint = 4.0;
  const Pavement paved = bonded(Bond::chevron, {300, 90}, joint, rectangle(2500, 2000));
  StoneLayout layout = laid_stones(paved, 1);
  EXPECT_LT(worst_wedge(paved, layout), 0.01);
  std::map<long, int> leaning;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    ++leaning[std::lround(stone.angle.degrees())];
    ASSERT_EQ(stone.outline_mm.size(), 4U);
    const vec2 axis = stone.angle.direction();
    int long_sides = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const vec2 side = stone.outline_mm[(i + 1) % 4] - stone.outline_mm[i];
      const double cosine = std::abs(glm::dot(side, axis)) / glm::length(side);
      if (cosine < 0.999) {
        EXPECT_NEAR(cosine, std::sqrt(0.5), 1e-4) << "ends are cut at 45 degrees";
        EXPECT_NEAR(glm::length(side), 90.0 * std::sqrt(2.0), 0.01);
      } else {
        EXPECT_NEAR(glm::length(side), 300.0, 0.01);
        ++long_sides;
      }
    }
    EXPECT_EQ(long_sides, 2);
    EXPECT_NEAR(geometry::area(stone.outline_mm), 300.0 * 90.0, 5.0);
  }
  EXPECT_GT(leaning[45], 20);
  EXPECT_GT(leaning[-45], 20);
  EXPECT_EQ(leaning.size(), 2U);
  const double step = std::sqrt(2.0) * (90.0 + joint);
  const double depth = 300.0 / std::sqrt(2.0) + joint;
  const Ends ends = ends_of(layout, joint, step, depth);
  EXPECT_EQ(ends.off_line, 0U);
  EXPECT_LT(farthest_apart(ends.near, ends.far, step), 0.005);
  // Every second row moved on a little: its joints meet no others.
  for (Stone& stone : layout.stones) {
    if (stone.angle > Angle()) continue;
    for (vec2& p : stone.outline_mm) p.x += 20.0;
  }
  const Ends moved = ends_of(layout, joint, step, depth);
  EXPECT_GT(farthest_apart(moved.near, moved.far, step), 10.0);
}

TEST(Bonds, ChevronsTurnWithTheirPattern) {
  for (const double turn : {0.0, 30.0, 90.0}) {
    Pavement paved = bonded(Bond::chevron, {300, 90}, 0, rectangle(2500, 2000));
    paved.bonding.turn = Angle::degrees(turn);
    for (const Stone& stone : laid_stones(paved, 1).stones) {
      if (stone.kind != StoneKind::whole) continue;
      EXPECT_NEAR(std::abs(std::remainder(stone.angle.degrees() - turn, 90.0)), 45.0, 1e-9);
    }
  }
}

// Sizes in modules, the longer side first, and how often they occur.
std::map<std::pair<long, long>, double> sizes_of(const StoneLayout& layout, double pitch, double joint) {
  std::map<std::pair<long, long>, double> counts;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    const geometry::Box box = geometry::bounding_box(stone.outline_mm);
    const long w = std::lround((box.high.x - box.low.x + joint) / pitch);
    const long h = std::lround((box.high.y - box.low.y + joint) / pitch);
    counts[{std::max(w, h), std::min(w, h)}] += 1.0;
  }
  return counts;
}

// Places where four stones meet with their corners, over all corners.
double share_of_crosses(const StoneLayout& layout, double joint) {
  std::map<std::pair<long, long>, int> corners;
  for (const Stone& stone : layout.stones) {
    const geometry::Box box = geometry::bounding_box(stone.outline_mm);
    const vec2 low = box.low - vec2(0.5 * joint);
    const vec2 high = box.high + vec2(0.5 * joint);
    for (const vec2 p : {low, vec2{high.x, low.y}, high, vec2{low.x, high.y}}) ++corners[{std::lround(p.x), std::lround(p.y)}];
  }
  const auto crosses = std::ranges::count_if(corners, [](const auto& corner) { return corner.second == 4; });
  return static_cast<double>(crosses) / static_cast<double>(corners.size());
}

TEST(Bonds, AshlarMixesItsSizesInTheirShares) {
  const Pavement paved = bonded(Bond::ashlar, {90, 90}, 10, rectangle(8000, 8000));
  const StoneLayout layout = laid_stones(paved, 5);
  const auto counts = sizes_of(layout, 100, 10);
  ASSERT_EQ(counts.size(), 4U);
  const auto total = static_cast<double>(layout.stones.size());
  EXPECT_NEAR(counts.at({1, 1}) / total, 0.20, 0.05);
  EXPECT_NEAR(counts.at({2, 1}) / total, 0.35, 0.05);
  EXPECT_NEAR(counts.at({2, 2}) / total, 0.25, 0.05);
  EXPECT_NEAR(counts.at({3, 2}) / total, 0.20, 0.05);
  EXPECT_LT(share_of_crosses(layout, 10), 0.03);
  // What it is not: stones of one size, where each corner is a cross.
  const StoneLayout stack = laid_stones(bonded(Bond::stack, {90, 90}, 10, rectangle(8000, 8000)), 5);
  EXPECT_EQ(sizes_of(stack, 100, 10).size(), 1U);
  EXPECT_GT(share_of_crosses(stack, 10), 0.9);
  EXPECT_NE(laid_stones(paved, 5), laid_stones(paved, 6));
}

TEST(Bonds, CrazyPavingIsIrregularAndWithoutNeedles) {
  const Pavement paved = bonded(Bond::crazy, {200, 200}, 10, rectangle(6000, 6000));
  const StoneLayout layout = laid_stones(paved, 5);
  std::map<std::size_t, int> corners;
  double least_side = 1e9;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    ++corners[stone.outline_mm.size()];
    for (std::size_t i = 0; i < stone.outline_mm.size(); ++i) {
      least_side = std::min(least_side, glm::length(stone.outline_mm[(i + 1) % stone.outline_mm.size()] - stone.outline_mm[i]));
    }
  }
  EXPECT_GE(corners.size(), 4U);  // four to seven corners, at least
  EXPECT_GT(least_side, 5.0);
  EXPECT_GT(quality(paved, layout).area_spread, 0.15);
  EXPECT_LT(quality(paved, layout).area_spread, 0.40);
  EXPECT_NE(layout, laid_stones(paved, 6));
}

TEST(Bonds, RingsHaveWholeNumbersOfStones) {
  // A whole disc: the stones of a ring are of one size, and no ring has a piece.
  const Pavement paved = bonded(Bond::running, {100, 100}, 8, {circle({0, 0}, 10 * 108.0, 2000), {}}, RadialDirection{});
  const StoneLayout layout = laid_stones(paved, 1);
  std::map<long, std::vector<double>> rings;
  for (const Stone& stone : layout.stones) {
    const double radius = glm::length(geometry::centroid(stone.outline_mm));
    rings[std::lround(std::floor(radius / 108.0))].push_back(geometry::area(stone.outline_mm));
  }
  EXPECT_EQ(rings.size(), 10U);
  for (const auto& [ring, areas] : rings) {
    if (ring == 0) continue;
    const auto [least, most] = std::ranges::minmax(areas);
    EXPECT_LT(most / least, 1.03) << ring;
    // No longer than the stock along the outer side, and up to a tenth less; the inner side is shorter.
    EXPECT_LT(most, 100.0 * 100.0) << ring;
    EXPECT_GT(least, ring > 2 ? 7400.0 : 5000.0) << ring;
  }
}

// The share of sides of whole stones, nearest to the guide and farthest, that lie half a joint from a whole number of rows off
// it.
double share_in_rows(const Pavement& paved, const StoneLayout& layout, double pitch) {
  const auto& guide = std::get<GuidesDirection>(paved.direction).guides_mm.front();
  double in_rows = 0.0;
  double seen = 0.0;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    double nearest = 1e300;
    double farthest = 0.0;
    for (const vec2& p : stone.outline_mm) {
      double distance = 1e300;
      for (std::size_t i = 0; i + 1 < guide.size(); ++i) {
        distance = std::min(distance, glm::length(geometry::nearest_point({guide[i], guide[i + 1]}, p) - p));
      }
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
    for (const double distance : {nearest, farthest}) {
      // A stone over a bend is trimmed to its stock, by half the rise of the bend on either side.
      const double rest = std::abs(std::remainder(distance, pitch));
      in_rows += std::abs(rest - 0.5 * paved.joint_mm) < 1.0 ? 1.0 : 0.0;
      seen += 1.0;
    }
  }
  return seen < 500.0 ? -1.0 : in_rows / seen;
}

TEST(Bonds, RowsAlongAGuideAreOfOneWidth) {
  std::vector<vec2> guide;
  for (int k = -20; k <= 20; ++k) guide.push_back({250.0 * k + 2000.0, 0.06 * (250.0 * k) * (250.0 * k) / 1000.0});
  Pavement paved = bonded(Bond::running, {200, 100}, 8, rectangle(4000, 2500), GuidesDirection{{guide}});
  EXPECT_GT(share_in_rows(paved, laid_stones(paved, 1), 108.0), 0.97);
  EXPECT_LT(share_in_rows(paved, laid_stones(paved, 1), 109.0), 0.5);
  paved.bonding.bond = Bond::packed;
  EXPECT_LT(share_in_rows(paved, laid_stones(paved, 1), 108.0), 0.5);
}

TEST(Bonds, RowsRoundAnOutlineCoverItWhateverItsShape) {
  // Rows close in on each other in the middle, about a hole, and in a corner that points inwards.
  for (const double joint_mm : {0.0, 8.0}) {
    const Pavement paved = bonded(Bond::running, {200, 100}, joint_mm, concave_area(), BoundaryDirection{});
    const StoneLayout layout = laid_stones(paved, 1);
    EXPECT_EQ(faults(paved, layout).total(), 0U);
    const LayoutQuality q = quality(paved, layout);
    EXPECT_GE(q.coverage, 0.995);
    EXPECT_LT(share_of_small(paved, layout), 0.01);
    EXPECT_GT(q.whole, q.stones * 3 / 4);
  }
}

// Stones of that area.
std::size_t of_size(const StoneLayout& layout, double area_mm2) {
  return static_cast<std::size_t>(std::ranges::count_if(layout.stones, [&](const Stone& stone) {
    return std::abs(geometry::area(stone.outline_mm) - area_mm2) < 1e-4 * area_mm2;
  }));
}

TEST(BorderCourse, IsAWholeNumberOfStonesBetweenMitres) {
  // Sides of 2416 and 1416 mm: 22.37 and 13.1 soldiers of 108 mm along them, so 23 and 14. Two at either end are mitred, and of
  // the 14, which are shorter than half the depth, a corner of the third.
  Pavement paved = bonded(Bond::running, {200, 100}, 8, rectangle(2416, 1416));
  paved.border.course = BorderCourse::soldier;
  const StoneLayout layout = laid_stones(paved, 1);
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  EXPECT_EQ(of_size(layout, (2416.0 / 23.0 - 8.0) * 200.0), 2U * 19U);
  EXPECT_EQ(of_size(layout, (1416.0 / 14.0 - 8.0) * 200.0), 2U * 8U);
  // Stretchers: 2416 / 208 = 11.6, 1416 / 208 = 6.8; one at either end.
  paved.border.course = BorderCourse::stretcher;
  const StoneLayout stretchers = laid_stones(paved, 1);
  EXPECT_EQ(of_size(stretchers, (2416.0 / 12.0 - 8.0) * 100.0), 2U * 10U);
  EXPECT_EQ(of_size(stretchers, (1416.0 / 7.0 - 8.0) * 100.0), 2U * 5U);
  paved.border.course = BorderCourse::none;
  EXPECT_EQ(of_size(laid_stones(paved, 1), (2416.0 / 23.0 - 8.0) * 200.0), 0U);
}

TEST(BorderCourse, IsExactOnEveryAreaAboutEveryBond) {
  for (const BondCase& bond : every_bond) {
    for (const geometry::Region& area : {concave_area(), path_area()}) {
      for (const double joint_mm : {0.0, bond.joint_mm}) {
        Pavement paved = bonded(bond.bond, bond.stone_mm, joint_mm, area);
        paved.border.course = BorderCourse::soldier;
        const StoneLayout layout = laid_stones(paved, 3);
        const LayoutFaults found = faults(paved, layout);
        EXPECT_EQ(found.total(), 0U) << bond.name << ", joint " << joint_mm << ", corners " << area.outline.size() << ": "
                                     << found.invalid << " invalid, " << found.overlaps << " overlaps, " << found.outside
                                     << " outside";
        // Stones of the course about the round hole are trimmed to their stock.
        EXPECT_GE(quality(paved, layout).coverage, 0.993) << bond.name;
      }
    }
  }
  for (const Direction& direction : {Direction(BoundaryDirection{}), Direction(RadialDirection{})}) {
    Pavement paved = bonded(Bond::packed, {100, 100}, 8, concave_area(), direction);
    paved.border = {BorderCourse::stretcher, {240, 120}};
    EXPECT_EQ(faults(paved, laid_stones(paved, 3)).total(), 0U);
  }
}

TEST(BorderCourse, FillsAreasTooNarrowForIt) {
  Pavement paved = bonded(Bond::stack, {100, 100}, 8, {{{0, 0}, {3000, 0}, {3000, 80}, {0, 80}}, {}});
  paved.border.course = BorderCourse::soldier;
  const StoneLayout layout = laid_stones(paved, 1);
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  EXPECT_GE(quality(paved, layout).coverage, 0.995);
}

TEST(Bonds, RefusesShapesThatABondCannotTake) {
  const geometry::Region area = path_area();
  EXPECT_THROW(static_cast<void>(laid_stones(bonded(Bond::herringbone, {100, 200}, 4, area), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(bonded(Bond::basket_weave, {100, 200}, 4, area), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(bonded(Bond::chevron, {80, 90}, 4, area), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(bonded(Bond::fan, {100, 300}, 4, area), 1)), InputError);
  Pavement narrow = bonded(Bond::segmental_arc, {100, 100}, 4, area);
  narrow.bonding.span_mm = 300;
  EXPECT_THROW(static_cast<void>(laid_stones(narrow, 1)), InputError);
  narrow.bonding.span_mm = 600;
  EXPECT_GT(laid_stones(narrow, 1).stones.size(), 300U);
}

}  // namespace
}  // namespace shatterpave::paving
