#include "paving/laying.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/needles.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "paving/field/size_field.h"
#include "paving/limits.h"
#include "paving/packing/packing.h"
#include "paving/packing/particle_cells.h"
#include "paving/packing/settling.h"
#include "paving/tiles/cells.h"
#include "paving/tiles/colouring.h"
#include "paving/tiles/cutting.h"
#include "paving/tiles/hand_setting.h"
#include "paving/tiles/variation.h"

namespace shatterpave::paving {

namespace {

double border_length(const geometry::RegionIndex& area) {
  double total = 0.0;
  for (const auto& s : area.segments()) total += std::sqrt(glm::dot(s.to - s.from, s.to - s.from));
  return total;
}

// Whole stones by area, and cut ones by the length of the border; where sizes vary, all as small as the smallest.
double expected_stones(const Pavement& pavement, const geometry::RegionIndex& area) {
  const double smallest = size_range(pavement).smallest;
  const vec2 pitch = smallest * pitch_mm(pavement);
  const double place = smallest * smallest * type_of(pavement).mean_area_mm2(pavement);
  const double border = pavement.border.course == BorderCourse::none ? 0.0 : 1.0 / border_stone_mm(pavement).x;
  return geometry::area(pavement.area) / place + border_length(area) * (1.0 / std::min(pitch.x, pitch.y) + border);
}

// Of a member, for messages: NAME.MEMBER.
Place place_of(const Pavement& pavement, std::string_view member) {
  return {{}, 0, 0, fmt::format("{}.{}", pavement.name, member)};
}

// Refuses stones of a shape that the bond cannot use.
void check_shape(const Pavement& pavement) {
  const vec2 stone = pavement.stone_mm;
  const BondType& type = type_of(pavement);
  const ShapeLimits shapes = type.shapes;
  if (stone.x < shapes.least * stone.y || stone.x > shapes.greatest * stone.y) {
    throw InputError(place_of(pavement, "stone_mm"),
                     fmt::format("expected stones {} for this bond, got [{}, {}]", shapes.expected, stone.x, stone.y));
  }
  if (!type.takes_span) return;
  const double least = least_stones_to_a_span * (std::max(stone.x, stone.y) + pavement.joint_mm);
  if (pavement.bonding.span_mm != 0.0 && pavement.bonding.span_mm < least) {
    throw InputError(place_of(pavement, "bond_span_mm"),
                     fmt::format("expected 0, or at least {} (five stones), got {}", least, pavement.bonding.span_mm));
  }
}

// Only stones that are packed one by one differ in size as a field has it.
void check_sizes(const Pavement& pavement) {
  if (!has_sizes(pavement)) return;
  if (type_of(pavement).bending != Bending::packed) {
    throw InputError(place_of(pavement, "bond"), "expected bond = \"packed\" beside size, got another one");
  }
  const SizeRange sizes = size_range(pavement);
  if (sizes.smallest < size_bounds.low || sizes.largest > size_bounds.high) {
    throw InputError(place_of(pavement, "size"), fmt::format("expected sizes from {} to {}, got {} to {}", size_bounds.low,
                                                             size_bounds.high, sizes.smallest, sizes.largest));
  }
  const vec2 smallest = sizes.smallest * pavement.stone_mm;
  if (std::min(smallest.x, smallest.y) < stone_bounds_mm.low) {
    throw InputError(place_of(pavement, "size"), fmt::format("expected stones of {} mm or more, got [{}, {}]",
                                                             stone_bounds_mm.low, smallest.x, smallest.y));
  }
}

// Scales stand on the corners of square cells, which only packing lays.
void check_cells(const Pavement& pavement) {
  if (pavement.cell.form != CellForm::scale) return;
  if (type_of(pavement).bending != Bending::packed) {
    throw InputError(place_of(pavement, "bond"), "expected bond = \"packed\" beside cell.form = \"scale\", got another one");
  }
  if (pavement.stone_mm.x != pavement.stone_mm.y) {
    throw InputError(place_of(pavement, "stone_mm"), "expected square stones beside cell.form = \"scale\", got oblong ones");
  }
}

void check(const Pavement& pavement) {
  const auto require = [&](std::string_view member, double mm, double least) {
    if (mm >= least && mm <= geometry::largest_coordinate_mm) return;
    throw InputError(place_of(pavement, member), fmt::format("expected {} or more, got {}", least, mm));
  };
  require("stone_mm", pavement.stone_mm.x, stone_bounds_mm.low);
  require("stone_mm", pavement.stone_mm.y, stone_bounds_mm.low);
  require("joint_mm", pavement.joint_mm, joint_bounds_mm.low);
  const Bonding& bonding = pavement.bonding;
  if (!(bonding.offset >= offset_bounds.low && bonding.offset <= offset_bounds.high)) {
    throw InputError(place_of(pavement, "bond_offset"),
                     fmt::format("expected {} to {}, got {}", offset_bounds.low, offset_bounds.high, bonding.offset));
  }
  require("bond_span_mm", bonding.span_mm, span_bounds_mm.low);
  check_shape(pavement);
  check_sizes(pavement);
  check_cells(pavement);
  const vec2 border = border_stone_mm(pavement);
  require("border_stone_mm", border.x, stone_bounds_mm.low);
  require("border_stone_mm", border.y, stone_bounds_mm.low);
  if (pavement.area.outline.size() < 3 || geometry::area(pavement.area.outline) == 0.0) {
    throw InputError(place_of(pavement, "outline_mm"), "expected a polygon with an area");
  }
}

// What is to be laid: cells over all of the area, and the direction of each cell's stone.
struct Setting {
  Cells cells;
  std::function<Angle(const Piece&, const geometry::Polygon& face)> angle;
};

// `field` must outlive what is returned.
Setting packed_setting(const Pavement& pavement, const geometry::RegionIndex& area, const DirectionField& field,
                       const SizeField& sizes, std::uint64_t seed) {
  const auto particles = packed_particles(pavement, area, field, sizes, seed);
  Cells cells = cells_of(particles, pavement);
  if (is_bent(pavement)) cells = settled_cells(std::move(cells), particles, pavement, area);
  if (pavement.hand.amount > 0.0) cells = hand_set(cells, pavement.hand.amount, seed, Id(pavement.name));
  return {std::move(cells),
          [&field, heads = pavement.cell.form == CellForm::scale](const Piece&, const geometry::Polygon& face) {
            const vec2 middle = geometry::centroid(face);
            return heads ? Angle::of(field.heading(middle)) : field.angle(middle);
          }};
}

Setting bonded_setting(std::vector<Tile> tiles, const Pavement& pavement, std::uint64_t seed) {
  return {cells_of(hand_set(std::move(tiles), pavement.hand.amount, seed, Id(pavement.name))),
          [](const Piece& piece, const geometry::Polygon&) { return axis_angle(piece.axis); }};
}

// What stones are set out to fit. Those laid by hand move into their half of the joint on all sides after that, and must then
// fit the stock.
Stock set_out_stock(Stock stock, const Pavement& pavement) {
  if (pavement.hand.amount == 0.0) return stock;
  const vec2 joint{pavement.joint_mm, pavement.joint_mm};
  stock.size_mm -= joint;
  if (stock.turned_size_mm != vec2{0.0, 0.0}) stock.turned_size_mm -= joint;
  stock.area_mm2 = stock.size_mm.x * stock.size_mm.y;
  return stock;
}

double longer_side(vec2 stone_mm) { return std::max(stone_mm.x, stone_mm.y); }

// What rounding takes off a stone whose sides lie on the border.
double rounding_mm2(vec2 stone_mm) {
  constexpr double width_mm = 0.005;
  return width_mm * (stone_mm.x + stone_mm.y);
}

// The stones as they are set out, and which of them must not move: a piece that is as narrow as the joint somewhere falls apart
// into stones that may nearly touch there.
struct SetOut {
  StoneLayout layout;
  std::vector<bool> held;
};

// Appends the stones of what is set within `region`.
void append_stones(const Setting& setting, const geometry::Region& region, const geometry::RegionIndex& index,
                   const StoneSize& size, StonePart part, SetOut& set_out) {
  const auto pieces = pieces_within(setting.cells, region, index, size);
  std::vector<std::vector<geometry::Polygon>> faces(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t p) { faces[p] = laid_faces(pieces[p], size); });
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (auto& face : faces[p]) {
      const auto kind = pieces[p].cut || faces[p].size() > 1 ? StoneKind::cut : StoneKind::whole;
      const Angle angle = setting.angle(pieces[p], face);
      set_out.layout.stones.push_back({static_cast<int>(set_out.layout.stones.size()), kind, std::move(face), angle, part});
      set_out.held.push_back(faces[p].size() > 1);
    }
  }
}

// The square packing, zone by zone where rows are mitred.
void append_packing(const Pavement& pavement, const geometry::RegionIndex& area, const SizeField& sizes, std::uint64_t seed,
                    SetOut& set_out) {
  const DirectionField field(pavement, area);
  const StoneSize size{whole_face_mm2(pavement), longer_side(pavement.stone_mm), pavement.joint_mm,
                       set_out_stock(stock(pavement).times(1.0 / size_range(pavement).largest), pavement), -1.0};
  if (field.zones().empty()) {
    append_stones(packed_setting(pavement, area, field, sizes, seed), pavement.area, area, size, StonePart::field, set_out);
    return;
  }
  for (const DirectionField::Zone& zone : field.zones()) {
    Pavement zoned = pavement;
    zoned.direction = zone.direction;
    for (const geometry::Region& part : zone.areas) {
      const geometry::RegionIndex index(part);
      append_stones(packed_setting(zoned, index, zone.field, sizes, seed), part, index, size, StonePart::field, set_out);
    }
  }
}

// The bond, within the border course if there is one. `sizes` are those of the whole pavement.
void append_bond(const Pavement& pavement, const geometry::RegionIndex& area, const SizeField& sizes, std::uint64_t seed,
                 SetOut& set_out) {
  if (type_of(pavement).bending == Bending::packed) {
    append_packing(pavement, area, sizes, seed, set_out);
    return;
  }
  append_stones(bonded_setting(bond_tiles(pavement, area, seed), pavement, seed), pavement.area, area,
                {whole_face_mm2(pavement), longer_side(pavement.stone_mm), pavement.joint_mm,
                 set_out_stock(stock(pavement), pavement), rounding_mm2(pavement.stone_mm)},
                StonePart::field, set_out);
}

// The border course, and the bond within it.
void append_bordered_bond(const Pavement& pavement, const SizeField& sizes, std::uint64_t seed, SetOut& set_out) {
  BorderedArea parts = bordered_area(pavement);
  const Setting course = bonded_setting(border_tiles(pavement, parts.course), pavement, seed);
  const vec2 stone = border_stone_mm(pavement);
  for (const geometry::Region& region : parts.course) {
    const StoneSize size{
        stone.x * stone.y, longer_side(stone), pavement.joint_mm,
        set_out_stock(hand_stock({stone, stone.x * stone.y, {}, {1.0, 0.0}}, pavement.joint_mm, pavement.hand.amount),
                      pavement),
        rounding_mm2(stone)};
    append_stones(course, region, geometry::RegionIndex(region), size, StonePart::border, set_out);
  }
  Pavement within = pavement;
  for (geometry::Region& region : parts.within) {
    within.area = std::move(region);
    append_bond(within, geometry::RegionIndex(within.area), sizes, seed, set_out);
  }
}

}  // namespace

void require_layable(const Pavement& pavement) {
  check(pavement);
  const double expected = expected_stones(pavement, geometry::RegionIndex(pavement.area));
  if (expected > most_stones) {
    throw InputError(place_of(pavement, "stone_mm"),
                     fmt::format("expected at most {:.0f} stones, got an area for about {:.0f}", most_stones, expected));
  }
}

StoneLayout laid_stones(const Pavement& asked, std::uint64_t seed) {
  require_layable(asked);
  Pavement pavement = asked;
  pavement.area = geometry::without_needles(asked.area);
  const geometry::RegionIndex area(pavement.area);
  const SizeField sizes(pavement, area);
  SetOut set_out;
  if (pavement.border.course == BorderCourse::none) {
    append_bond(pavement, area, sizes, seed, set_out);
  } else {
    append_bordered_bond(pavement, sizes, seed, set_out);
  }
  StoneLayout layout = varied(std::move(set_out.layout), set_out.held, pavement, side_bulge(pavement), seed);
  colour(layout, pavement, seed);
  return layout;
}

}  // namespace shatterpave::paving
