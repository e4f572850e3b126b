// Crazy paving: irregular convex polygons. stone_mm = [a, b]: their mean area is a · b.
//
// They are the Voronoi cells of seeds drawn one to a square. Raw, such cells have needles and sides shorter than a joint,
// which no one lays. So seeds first move to the middles of their cells (Lloyd), once: more would make a honeycomb of it. Then
// corners that are too near to each other become one.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.h"
#include "geometry/lattice.h"
#include "geometry/voronoi.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"
#include "paving/tiles/near_points.h"

namespace shatterpave::paving {

namespace {

// Sides shorter than this, in mean pitches, are no sides; by eye.
constexpr double least_side = 0.18;
constexpr int lloyd_steps = 1;

// Takes the corners of each short side together, in its middle; a corner once. Returns whether there were any.
bool join_near_corners(geometry::Voronoi& diagram, double least_mm) {
  std::vector<std::uint32_t> stands(diagram.corners.size());
  std::iota(stands.begin(), stands.end(), 0U);
  std::vector<bool> taken(diagram.corners.size(), false);
  bool found = false;
  for (const auto& cell : diagram.cells) {
    for (std::size_t k = 0; k < cell.size() && cell.size() > 3; ++k) {
      const std::uint32_t a = cell[k];
      const std::uint32_t b = cell[(k + 1) % cell.size()];
      if (taken[a] || taken[b] || glm::length(diagram.corners[b] - diagram.corners[a]) >= least_mm) continue;
      taken[a] = taken[b] = found = true;
      stands[b] = a;
      diagram.corners[a] = 0.5 * (diagram.corners[a] + diagram.corners[b]);
    }
  }
  for (auto& cell : diagram.cells) {
    for (std::uint32_t& corner : cell) corner = stands[corner];
    cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
    while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
  }
  return found;
}

std::vector<Tile> crazy_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t seed) {
  const vec2 pitch = pitch_mm(pavement);
  const Placement placement = anchored(area, pattern_direction(pavement).direction());
  const Grid grid{placement.origin, pitch.x * placement.along, pitch.y * left_of(placement.along)};
  // Beyond the area so far that cells at the rim, and those that moving makes crooked, are not needed.
  constexpr double band_pitches = 5.0;
  const Id owner = Id(pavement.name).child("crazy");
  std::vector<vec2> seeds;
  for (const GridPoint& p : near_points(grid, area, band_pitches * std::max(pitch.x, pitch.y))) {
    const Id id = owner.child(static_cast<std::uint64_t>(p.j)).child(static_cast<std::uint64_t>(p.i));
    const vec2 draw{uniform(seed, {Stream::crazy_seed, id, 0}), uniform(seed, {Stream::crazy_seed, id, 1})};
    const vec2 place = pitch * (vec2{static_cast<double>(p.i), static_cast<double>(p.j)} + draw);
    seeds.push_back(geometry::on_lattice(placement.out_of(place)));
  }
  geometry::sort_distinct(seeds);
  geometry::Voronoi diagram = geometry::voronoi(seeds);
  for (int step = 0; step < lloyd_steps; ++step) {
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      if (diagram.cells[s].empty()) continue;
      // Those at the rim have cells of any size; they stay.
      const vec2 middle = geometry::on_lattice(geometry::centroid(diagram.outline(s)));
      if (glm::length(middle - seeds[s]) < std::max(pitch.x, pitch.y)) seeds[s] = middle;
    }
    diagram = geometry::voronoi(seeds);
  }
  // What was joined may be near to another corner; a few rounds leave nothing.
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    if (!join_near_corners(diagram, least_side * std::sqrt(pitch.x * pitch.y))) break;
  }
  std::vector<Tile> tiles;
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    if (diagram.cells[s].size() < 3) continue;
    Tile tile{diagram.outline(s), placement.along};
    for (vec2& p : tile.outline_mm) p = geometry::on_lattice(p);
    if (is_needed(tile.outline_mm, area)) tiles.push_back(std::move(tile));
  }
  return tiles;
}

Stock crazy_stock(const Pavement& pavement) {
  const vec2 stone = pavement.stone_mm;
  return {2.0 * stone, 2.0 * stone.x * stone.y, {}, {1.0, 0.0}};
}

}  // namespace

extern constinit const BondType crazy_bond{
    .id = Bond::crazy,
    .name = "crazy",
    .sentence = "irregular polygons",
    .stone_words = "a · b is the mean area",
    .stock_words = "twice `stone_mm` each way, and an area of twice theirs",
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::always,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = false,
    .has_stones_of_a_size = false,
    .pattern_turn = Angle(),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = crazy_stock,
    .pattern = nullptr,
    .tiles = crazy_tiles,
};

}  // namespace shatterpave::paving
