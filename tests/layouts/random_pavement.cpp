#include "layouts/random_pavement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "core/functions.h"
#include "layouts/draws.h"
#include "layouts/random_areas.h"
#include "paving/bonds/table.h"
#include "paving/catalogue/hand_presets.h"
#include "paving/limits.h"

namespace shatterpave::layouts {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;
using paving::BondType;

double rounded(double value, double step) { return std::round(value / step) * step; }

std::string points_text(const std::vector<vec2>& points) {
  std::string text = "[";
  for (const vec2& p : points) text += fmt::format("{}[{:.3f}, {:.3f}]", text.size() > 1 ? ", " : "", p.x, p.y);
  return text + "]";
}

std::string lists_text(const std::vector<std::vector<vec2>>& lists) {
  std::string text = "[";
  for (const auto& list : lists) text += (text.size() > 1 ? ", " : "") + points_text(list);
  return text + "]";
}

struct Sizes {
  vec2 stone_mm{100.0, 100.0};
  double joint_mm = 8.0;
};

Sizes random_sizes(const Draws& draws, const BondType& bond) {
  Sizes sizes;
  const paving::ShapeLimits shapes = bond.shapes;
  const bool setts = shapes.greatest < 3.0;  // which ask for stones at most twice as long as wide
  const double aspect = draws.chance("square", 0.35) ? 1.0 : draws.spread("aspect", setts ? 0.52 : 0.4, setts ? 1.95 : 3.0);
  const double longer = draws.spread("longer", 40.0, 400.0);
  sizes.stone_mm = aspect >= 1.0 ? vec2{longer, longer / aspect} : vec2{longer * aspect, longer};
  for (double* side : {&sizes.stone_mm.x, &sizes.stone_mm.y}) *side = std::max(16.0, rounded(*side, 0.1));
  if (shapes.least >= 1.0) {
    sizes.stone_mm = {std::max(sizes.stone_mm.x, sizes.stone_mm.y), std::min(sizes.stone_mm.x, sizes.stone_mm.y)};
  }
  sizes.joint_mm = draws.chance("tight", 0.15) ? 0.0 : rounded(draws.between("joint", 0.0, 20.0), 0.1);
  return sizes;
}

vec2 within(const Box& box, double x, double y) { return box.low + vec2{x, y} * (box.high - box.low); }

// Polylines of two to five points, which bend as they like and cross.
std::string guides_text(const Draws& draws, const Box& box) {
  std::vector<std::vector<vec2>> guides;
  for (std::size_t g = draws.count("guides", 1, 3); g > 0; --g) {
    const Draws its = draws.of("guide", g);
    std::vector<vec2> guide;
    const std::size_t points = its.count("points", 2, 5);
    for (std::size_t p = 0; p < points; ++p) {
      guide.push_back(within(box, its.between("x", -0.25, 1.25, p), its.between("y", -0.25, 1.25, p)));
    }
    guides.push_back(std::move(guide));
  }
  return lists_text(guides);
}

std::string direction_text(const Draws& draws, const Region& area) {
  const Box box = geometry::bounding_box(area.outline);
  switch (draws.count("field", 0, 3)) {
    case 0: {
      const double angle = draws.chance("quarter", 0.4) ? 45.0 * static_cast<double>(draws.count("eighth", 0, 3))
                                                        : draws.between("angle", 0, 180);
      return fmt::format("kind = \"constant\", angle_deg = {:.4f}", angle);
    }
    case 1:
      return "kind = \"boundary\"";
    case 2: {
      const double reach = draws.chance("inside", 0.5) ? 0.5 : 2.0;
      const vec2 centre = within(box, 0.5 + reach * draws.between("x", -1.0, 1.0), 0.5 + reach * draws.between("y", -1.0, 1.0));
      return fmt::format("kind = \"radial\", centre_mm = [{:.3f}, {:.3f}]", centre.x, centre.y);
    }
    default:
      return fmt::format("kind = \"guides\", guides_mm = {}", guides_text(draws, box));
  }
}

std::string bond_text(const Draws& draws, const BondType& bond, const Sizes& sizes) {
  std::string text = fmt::format("bond = \"{}\"\n", std::string_view(bond.name));
  if (bond.takes_offset && draws.chance("offset", 0.6)) text += fmt::format("bond_offset = {:.3f}\n", draws.unit("by"));
  if (draws.chance("turned", 0.3)) {
    const double angle = draws.chance("eighth turn", 0.5) ? 45.0 : draws.between("turn", 0.0, 180.0);
    text += fmt::format("bond_turn_deg = {:.4f}\n", angle);
  }
  if (bond.takes_span && draws.chance("span", 0.5)) {
    const double pitch = std::max(sizes.stone_mm.x, sizes.stone_mm.y) + sizes.joint_mm;
    text += fmt::format("bond_span_mm = {:.3f}\n", pitch * draws.between("stones", 5.01, 20.0));
  }
  return text;
}

std::string border_text(const Draws& draws) {
  if (draws.chance("no border", 0.55)) return {};
  std::string text = fmt::format("border_course = \"{}\"\n", draws.chance("soldier", 0.5) ? "soldier" : "stretcher");
  if (draws.chance("own stones", 0.4)) {
    const double along = draws.spread("along", 40.0, 400.0);
    const double across = std::clamp(along * draws.spread("aspect", 0.4, 3.0), 40.0, 400.0);
    text += fmt::format("border_stone_mm = [{:.1f}, {:.1f}]\n", along, across);
  }
  return text;
}

// A quarter is laid by hand: as a preset says, or by any amount, with corners as that says or by keys of their own.
std::string hand_text(const Draws& draws) {
  if (draws.chance("by the line", 0.75)) return {};
  if (draws.chance("preset", 0.2)) {
    return fmt::format("hand_preset = \"{}\"\n", paving::hand_presets.at(draws.count("which", 0, 2)).name);
  }
  std::string text =
      fmt::format("laid_by_hand = {:.3f}\n", draws.chance("worn", 0.3) ? 1.0 : draws.between("amount", 0.001, 1.0));
  if (draws.chance("own corners", 0.3)) {
    text += fmt::format("hand = {{rounded = {:.3f}, nibbled = {:.3f}}}\n", draws.between("rounded", 0.0, 0.3),
                        draws.between("nibbled", 0.0, 1.0));
  }
  return text;
}

// Sizes by the distance from the edge or from lines, and what becomes of the cells. (Maps are files.)
std::string sized_text(const Draws& draws, const Region& area) {
  const paving::Bounds bounds = paving::size_bounds;
  const double reach = glm::length(within(geometry::bounding_box(area.outline), 1.0, 1.0) -
                                   within(geometry::bounding_box(area.outline), 0.0, 0.0));
  std::string text =
      fmt::format("near = {:.3f}, far = {:.3f}, distance_mm = {:.1f}", draws.spread("near", bounds.low, bounds.high),
                  draws.spread("far", bounds.low, bounds.high), reach * draws.spread("reach", 0.02, 1.0));
  if (draws.chance("lines", 0.5))
    text += ", kind = \"line\", lines_mm = " + guides_text(draws.of("lines"), geometry::bounding_box(area.outline));
  constexpr std::array forms{"stone", "cobble", "scale"};
  return fmt::format("size = {{{}}}\ncell = {{form = \"{}\", overlap = {:.3f}}}\n", text, forms.at(draws.count("form", 0, 2)),
                     draws.unit("overlap"));
}

// What is rare about a scene: one or two of these.
struct Rarities {
  bool few = false;        // stones are larger than the area
  bool wide = false;       // joints are about as wide as stones, or wider
  bool flat = false;       // corners that are hardly any
  bool far = false;        // from the origin, up to 1 km
  bool extreme = false;    // stones of a few millimetres or several metres, or eight times as long as wide
  bool clustered = false;  // points a few micrometres apart
};

Rarities rarities(const Draws& draws) {
  Rarities r;
  bool* all[] = {&r.few, &r.wide, &r.flat, &r.far, &r.extreme, &r.clustered};
  *all[draws.count("first", 0, 5)] = true;
  *all[draws.count("second", 0, 5)] = true;
  return r;
}

void make_rare(Sizes& sizes, const Rarities& rare, const Draws& draws, const BondType& bond) {
  if (rare.wide) sizes.joint_mm = rounded(std::min(sizes.stone_mm.x, sizes.stone_mm.y) * draws.spread("wide", 0.3, 3.0), 0.1);
  if (!rare.extreme) return;
  const double scale = draws.chance("small", 0.5) ? draws.spread("smaller", 0.01, 0.2) : draws.spread("larger", 4.0, 20.0);
  sizes.stone_mm = glm::max(vec2{1.0, 1.0}, scale * sizes.stone_mm);
  sizes.joint_mm *= draws.chance("joint", 0.5) ? scale : std::min(scale, 1.0);
  const bool oblong = paving::ShapeLimits(bond.shapes).greatest >= 8.0 && draws.chance("oblong", 0.3);
  if (oblong) sizes.stone_mm.x = std::max(sizes.stone_mm.x, 8.0 * sizes.stone_mm.y);
}

// More points on the sides, on the line or up to a few micrometres or a millimetre off it; doubled points; moved far off.
void make_rare(Region& region, const Rarities& rare, const Draws& draws) {
  if (rare.flat || rare.clustered) {
    Polygon more;
    for (std::size_t i = 0; i < region.outline.size(); ++i) {
      const vec2 a = region.outline[i];
      const vec2 b = region.outline[(i + 1) % region.outline.size()];
      more.push_back(a);
      const vec2 d = b - a;
      if (rare.clustered && draws.chance("cluster", 0.5, i)) {
        const double step = draws.spread("step", 0.001, 2.0, i);
        more.push_back(a + step / std::max(step, glm::length(d)) * d);
      }
      if (rare.flat) {
        const double off = draws.chance("on line", 0.3, i) ? 0.0 : draws.spread("off", 0.001, 1.0, i);
        const vec2 across = left_of(d) / std::max(1e-9, glm::length(d));
        more.push_back(a + draws.between("at", 0.1, 0.9, i) * d + (draws.chance("inwards", 0.5, i) ? off : -off) * across);
      }
    }
    region.outline = std::move(more);
  }
  if (!rare.far) return;
  const Box box = geometry::bounding_box(region.outline);
  const auto side = [&](std::uint64_t axis) { return draws.chance("side", 0.5, axis) ? 1.0 : -1.0; };
  const vec2 corner{side(0) * 999'999.0, side(1) * 999'999.0};
  const vec2 from{corner.x > 0.0 ? box.high.x : box.low.x, corner.y > 0.0 ? box.high.y : box.low.y};
  const auto move = [&](Polygon& ring) {
    for (vec2& p : ring) p += corner - from;
  };
  move(region.outline);
  for (Polygon& hole : region.holes) move(hole);
}

}  // namespace

DrawnScene random_scene(std::uint64_t number, std::uint64_t attempt, Kind kind, const std::vector<Region>& places) {
  const Draws draws = Draws(number).of("attempt", attempt);
  const Rarities rare = kind == Kind::rare ? rarities(draws.of("rare")) : Rarities{};
  std::vector<const BondType*> bonds;
  std::ranges::copy_if(paving::bond_types(), std::back_inserter(bonds), [](const BondType* type) -> bool {
    return type->is_for_scenes && !type->takes_module;  // which needs a file: tests/paving/bonds/module_test
  });
  if (kind == Kind::sized) std::erase_if(bonds, [](const BondType* type) { return type->bending != paving::Bending::packed; });
  const BondType& bond = *bonds.at(draws.count("bond", 0, bonds.size() - 1));
  Sizes sizes = random_sizes(draws.of("sizes"), bond);
  make_rare(sizes, rare, draws.of("rare sizes"), bond);
  const vec2 pitch = sizes.stone_mm + vec2{sizes.joint_mm, sizes.joint_mm};
  double stones = draws.chance("few", 0.15) ? draws.spread("stones", 0.2, 5.0) : draws.spread("stones", 5.0, 500.0);
  if (rare.few) stones = draws.spread("fewer", 0.02, 3.0);
  const DrawnArea area = random_area(draws.of("area"), places);
  Region region = placed(area.region, stones * pitch.x * pitch.y, draws.of("place"));
  make_rare(region, rare, draws.of("rare area"));

  std::string toml = fmt::format("seed = {}\n[[pavement]]\nname = \"court\"\n", draws.count("seed", 1, 1000));
  toml += fmt::format("outline_mm = {}\n", points_text(region.outline));
  if (!region.holes.empty()) toml += fmt::format("holes_mm = {}\n", lists_text(region.holes));
  toml += fmt::format("stone_mm = [{:.1f}, {:.1f}]\njoint_mm = {:.1f}\n", sizes.stone_mm.x, sizes.stone_mm.y, sizes.joint_mm);
  toml += bond_text(draws.of("bond"), bond, sizes);
  toml += border_text(draws.of("border"));
  toml += hand_text(draws.of("hand"));
  toml += fmt::format("direction = {{{}}}\n", direction_text(draws.of("direction"), region));
  if (kind == Kind::sized) toml += sized_text(draws.of("sized"), region);
  return {area.shape, std::move(toml)};
}

}  // namespace shatterpave::layouts
