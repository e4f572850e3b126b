#include "paving/quantities/quantities.h"

#include <algorithm>

#include "geometry/region_index.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"
#include "paving/quantities/cutting_plan.h"
#include "paving/tiles/hand_setting.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;

constexpr std::array parts_in_order = {StonePart::field, StonePart::border, StonePart::kerb, StonePart::step};

// The sides of a stone that lie along outline or holes, from which half a joint stays free: their length, and that of all.
struct Sides {
  double all_mm = 0.0;
  double along_border_mm = 0.0;
};

Sides sides(const Polygon& stone, const geometry::RegionIndex& area, double joint_mm) {
  // Corners of stones that differ from their places lie up to half a joint farther in. By eye: a little more for rounding.
  const double near_mm = joint_mm + 0.01;
  std::vector<bool> near(stone.size());
  for (std::size_t i = 0; i < stone.size(); ++i) near[i] = area.border_within(stone[i], near_mm);
  Sides result;
  for (std::size_t i = 0; i < stone.size(); ++i) {
    const std::size_t next = (i + 1) % stone.size();
    const double length = glm::length(stone[next] - stone[i]);
    result.all_mm += length;
    if (near[i] && near[next] && area.border_within(0.5 * (stone[i] + stone[next]), near_mm)) result.along_border_mm += length;
  }
  return result;
}

Stock stock_of_part(const Pavement& pavement, StonePart part) {
  return part == StonePart::border ? hand_stock(stock_of(border_stone_mm(pavement)), pavement.joint_mm, pavement.hand.amount)
                                   : stock(pavement);
}

bool has_rectangles(const Pavement& pavement, StonePart part) {
  const BondType& bond = type_of(pavement);
  // Packed along a bend no two are alike.
  const bool packed_along_bend = bond.bending == Bending::packed && is_bent(pavement);
  return part == StonePart::border || (bond.has_square_stones && bond.has_stones_of_a_size && !packed_along_bend);
}

// Numbers stock stones: whole ones first, in the order of the layout, then those that are cut.
void order_stones(const Pavement& pavement, const StoneLayout& layout, PartQuantities& part,
                  std::vector<std::size_t>& stock_of_stone) {
  std::vector<std::size_t> cut;
  std::size_t number = 0;
  for (std::size_t i = 0; i < layout.stones.size(); ++i) {
    const Stone& stone = layout.stones[i];
    if (stone.part != part.part) continue;
    Tally& tally = stone.kind == StoneKind::cut ? part.cut : part.whole;
    ++tally.count;
    tally.area_mm2 += geometry::area(stone.outline_mm);
    if (stone.kind == StoneKind::cut) {
      cut.push_back(i);
    } else {
      stock_of_stone[i] = number++;
    }
  }
  part.order = part.whole.count + part.cut.count;
  part.order_reusing = part.order;
  if (!has_rectangles(pavement, part.part)) {
    for (const std::size_t i : cut) stock_of_stone[i] = number++;
    return;
  }
  const Stock stock = stock_of_part(pavement, part.part);
  // One that stands at right angles to stock of two sizes is measured as it stands; what a hair's breadth is too large is taken
  // as it is.
  std::vector<vec2> sizes;
  sizes.reserve(cut.size());
  for (const std::size_t i : cut) sizes.push_back(glm::min(stone_size_mm(layout.stones[i]), stock.size_mm));
  const std::vector<Cut> plan = cutting_plan(sizes, stock.size_mm);
  std::size_t used = 0;
  for (std::size_t k = 0; k < cut.size(); ++k) {
    stock_of_stone[cut[k]] = number + plan[k].stock;
    used = std::max(used, plan[k].stock + 1);
  }
  part.order_reusing = number + used;
}

}  // namespace

vec2 stone_size_mm(const Stone& stone) { return size_of(extent(stone.outline_mm, stone.angle.direction())); }

Quantities quantities(const Pavement& pavement, const StoneLayout& layout) {
  Quantities result;
  result.paved_mm2 = geometry::area(pavement.area);
  result.stock_of_stone.resize(layout.stones.size());
  double faces_mm2 = 0.0;
  for (const StonePart name : parts_in_order) {
    PartQuantities part{.part = name};
    const Stock stock = stock_of_part(pavement, name);
    part.stock_mm = stock.size_mm;
    part.stock_area_mm2 = stock.area_mm2;
    order_stones(pavement, layout, part, result.stock_of_stone);
    faces_mm2 += part.whole.area_mm2 + part.cut.area_mm2;
    if (part.order > 0) result.parts.push_back(part);
  }
  result.joint_mm2 = result.paved_mm2 - faces_mm2;
  const geometry::RegionIndex area(pavement.area);
  double between_mm = 0.0;
  for (const Stone& stone : layout.stones) {
    const Sides of_stone = sides(stone.outline_mm, area, pavement.joint_mm);
    between_mm += of_stone.all_mm - of_stone.along_border_mm;
  }
  result.joint_mm = 0.5 * between_mm;
  return result;
}

}  // namespace shatterpave::paving
