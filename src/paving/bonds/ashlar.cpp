// Random ashlar: rectangles of several sizes, mixed. stone_mm is the smallest stone, one module; others take 2 × 1, 2 × 2 and 3
// × 2 modules, along the rows or across them, and the joints between.
//
// Modules are filled row by row: at the first free one a stone is drawn of those that fit there. Two things
// guide the draw. Sizes that are behind their share become likelier, since small ones fit everywhere and would take over. And
// stones that would make a joint run on, past the ends of their neighbours, become less likely: a good paviour leaves no cross
// and no long through joint.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/random.h"
#include "geometry/lattice.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"
#include "paving/tiles/near_points.h"

namespace shatterpave::paving {

namespace {

struct Size {
  std::int64_t columns = 1;
  std::int64_t rows = 1;
  std::size_t kind = 0;  // oblong ones lie both ways, but are one kind
};

// In modules. Packs of flagstones for patios are sold with these: with a module of 300 mm they are 300 × 300, 600 × 300, 600 ×
// 600 and 900 × 600. The shares, of the count, are by eye: half of the area is large stones.
constexpr std::array<Size, 6> sizes{{{1, 1, 0}, {2, 1, 1}, {1, 2, 1}, {2, 2, 2}, {3, 2, 3}, {2, 3, 3}}};
constexpr std::array<double, 4> shares{0.2, 0.35, 0.25, 0.2};
constexpr std::array<double, 4> ways{1.0, 2.0, 1.0, 2.0};

// How many stones a size may be behind its share before it takes every place it fits in; by eye.
constexpr double patience = 6.0;
// Likelihood of a stone, over that of others, for each joint that it makes run on; by eye.
constexpr double joint_runs_on = 0.15;
// And where four corners would meet; by eye, too: hardly ever, but not never, since a small stone must close some gaps.
constexpr double cross_made = 0.01;

constexpr std::uint32_t free_module = UINT32_MAX;

class Filling {
 public:
  Filling(std::vector<GridPoint> modules, std::uint64_t seed, Id pavement)
      : modules_(std::move(modules)), owner_(modules_.size(), free_module), seed_(seed), id_(pavement.child("ashlar")) {}

  struct Block {
    GridPoint low;
    Size size;
  };

  std::vector<Block> blocks() {
    std::vector<Block> result;
    for (std::size_t m = 0; m < modules_.size(); ++m) {
      if (owner_[m] != free_module) continue;
      const Size size = drawn(modules_[m]);
      for (std::int64_t j = 0; j < size.rows; ++j) {
        for (std::int64_t i = 0; i < size.columns; ++i) {
          owner_[*find(modules_[m].j + j, modules_[m].i + i)] = static_cast<std::uint32_t>(result.size());
        }
      }
      counts_[size.kind] += 1.0;
      result.push_back({modules_[m], size});
    }
    return result;
  }

 private:
  std::optional<std::size_t> find(std::int64_t j, std::int64_t i) const {
    const auto at = std::ranges::lower_bound(modules_, GridPoint{j, i});
    if (at == modules_.end() || *at != GridPoint{j, i}) return std::nullopt;
    return static_cast<std::size_t>(at - modules_.begin());
  }

  std::uint32_t owner(std::int64_t j, std::int64_t i) const {
    const auto module = find(j, i);
    return module ? owner_[*module] : free_module;
  }

  bool fits(GridPoint low, Size size) const {
    for (std::int64_t j = 0; j < size.rows; ++j) {
      for (std::int64_t i = 0; i < size.columns; ++i) {
        const auto module = find(low.j + j, low.i + i);
        if (!module || owner_[*module] != free_module) return false;
      }
    }
    return true;
  }

  // Whether stones on both sides of a place end there, so that a joint comes from there.
  bool joint_between(std::int64_t j0, std::int64_t i0, std::int64_t j1, std::int64_t i1) const {
    const std::uint32_t a = owner(j0, i0);
    const std::uint32_t b = owner(j1, i1);
    return a != free_module && b != free_module && a != b;
  }

  int joints_run_on(GridPoint low, Size size) const {
    int count = 0;
    const std::int64_t right = low.i + size.columns;
    const std::int64_t top = low.j + size.rows;
    if (joint_between(low.j - 1, low.i - 1, low.j - 1, low.i)) ++count;
    if (joint_between(low.j - 1, right - 1, low.j - 1, right)) ++count;
    if (joint_between(top - 1, low.i - 1, top, low.i - 1)) ++count;
    return count;
  }

  // Whether a corner of the stone would be one of four: a joint meets it from below or from a side, and no stone spans it. What
  // is still free will be of another stone.
  bool makes_cross(GridPoint low, Size size) const {
    const std::int64_t right = low.i + size.columns;
    const std::int64_t top = low.j + size.rows;
    const bool at_foot =
        joint_between(low.j - 1, right - 1, low.j - 1, right) && owner(low.j - 1, right) != owner(low.j, right);
    const bool at_left = joint_between(top - 1, low.i - 1, top, low.i - 1) && owner(top, low.i - 1) != owner(top, low.i);
    const bool at_right = joint_between(top - 1, right, top, right) && owner(top, right) != owner(top, right - 1);
    return at_foot || at_left || at_right;
  }

  Size drawn(GridPoint low) const {
    double total = 0.0;
    for (const double count : counts_) total += count;
    std::array<double, sizes.size()> weights{};
    double sum = 0.0;
    for (std::size_t s = 0; s < sizes.size(); ++s) {
      if (!fits(low, sizes[s])) continue;
      const double behind = shares[sizes[s].kind] * (total + patience) - counts_[sizes[s].kind];
      weights[s] = std::max(1e-6, behind) / ways[sizes[s].kind];
      for (int joint = joints_run_on(low, sizes[s]); joint > 0; --joint) weights[s] *= joint_runs_on;
      if (makes_cross(low, sizes[s])) weights[s] *= cross_made;
      sum += weights[s];
    }
    const Id id = id_.child(static_cast<std::uint64_t>(low.j)).child(static_cast<std::uint64_t>(low.i));
    double left = sum * uniform(seed_, {Stream::ashlar_size, id});
    for (std::size_t s = sizes.size(); s-- > 0;) {
      if (weights[s] > 0.0 && left < weights[s]) return sizes[s];
      left -= weights[s];
    }
    return sizes[0];
  }

  std::vector<GridPoint> modules_;  // row by row
  std::vector<std::uint32_t> owner_;
  std::uint64_t seed_;
  Id id_;
  std::array<double, shares.size()> counts_{};
};

std::vector<Tile> ashlar_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t seed) {
  const vec2 pitch = pitch_mm(pavement);
  const Placement placement = anchored(area, pattern_direction(pavement).direction());
  constexpr double largest = 3.0;  // modules
  const Grid grid{placement.out_of(0.5 * pitch), pitch.x * placement.along, pitch.y * left_of(placement.along)};
  auto modules = near_points(grid, area, (largest + 1.0) * std::max(pitch.x, pitch.y));
  std::vector<Tile> tiles;
  for (const auto& [low, size] : Filling(std::move(modules), seed, Id(pavement.name)).blocks()) {
    const auto corner = [&](std::int64_t i, std::int64_t j) {
      return geometry::on_lattice(placement.out_of(pitch * vec2{static_cast<double>(i), static_cast<double>(j)}));
    };
    const std::int64_t right = low.i + size.columns;
    const std::int64_t top = low.j + size.rows;
    Tile tile{{corner(low.i, low.j), corner(right, low.j), corner(right, top), corner(low.i, top)}, placement.along};
    if (size.rows > size.columns) tile.axis = left_of(placement.along);
    if (is_needed(tile.outline_mm, area)) tiles.push_back(std::move(tile));
  }
  return tiles;
}

// Three by two modules, of which the three may run along the rows or across them.
Stock ashlar_stock(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  const vec2 joint{pavement.joint_mm, pavement.joint_mm};
  const vec2 size = vec2{3.0, 2.0} * pitch - joint;
  const vec2 turned = vec2{3.0, 2.0} * vec2{pitch.y, pitch.x} - joint;
  return {size, std::max(size.x * size.y, turned.x * turned.y), turned, pattern_direction(pavement).direction()};
}

// Modules that a stone takes in the mean: by counting the stones of scenes/bonds.toml.
constexpr double mean_modules = 2.6;

double ashlar_area_mm2(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  return mean_modules * pitch.x * pitch.y;
}

}  // namespace

extern constinit const BondType ashlar_bond{
    .id = Bond::ashlar,
    .name = "ashlar",
    .sentence = "rectangles of several sizes, mixed at random",
    .stone_words = "the smallest, one module; others take 2 × 1, 2 × 2 and 3 × 2 modules and the joints between",
    .stock_words = "three by two modules",
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::always,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = true,
    .has_stones_of_a_size = false,
    .pattern_turn = Angle(),
    .mean_area_mm2 = ashlar_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = ashlar_stock,
    .pattern = nullptr,
    .tiles = ashlar_tiles,
};

}  // namespace shatterpave::paving
