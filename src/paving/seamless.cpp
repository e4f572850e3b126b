// The points at which a pattern repeats are a lattice. A tile needs two of them that lie (width, 0) and (0, height) from the
// origin; the nearest are taken, and the plane is stretched by the linear map that takes them there. One stone of each class of
// points that differ by those two is laid: the classes are told apart in whole numbers.
#include "paving/seamless.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "geometry/lattice.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/table.h"
#include "paving/limits.h"
#include "paving/packing/packing.h"
#include "paving/tiles/colouring.h"
#include "paving/tiles/cutting.h"
#include "paving/tiles/variation.h"

namespace shatterpave::paving {

namespace {

using Matrix = glm::dmat2;

constexpr double stones_to_a_tile = 10.0;
constexpr std::int64_t most_periods = 400;  // along a side

// Of a member of the textures, for messages.
Place texture_place(const Pavement& pavement, std::string_view member) {
  return {{}, 0, 0, fmt::format("{}.textures.{}", pavement.name, member)};
}

// A point of the lattice: i times its first vector and j times its second.
struct Step {
  std::int64_t i = 0;
  std::int64_t j = 0;
};

// The lattice at which the pattern repeats, in the plane of the scene.
struct Repetition {
  Matrix basis;  // its columns

  vec2 at(Step step) const { return basis * vec2{static_cast<double>(step.i), static_cast<double>(step.j)}; }
  Step nearest(vec2 point) const {
    const vec2 parts = glm::inverse(basis) * point;
    return {std::llround(parts.x), std::llround(parts.y)};
  }
};

Repetition repetition_of(const Pattern& pattern, vec2 along) {
  const vec2 row = Placement{{0.0, 0.0}, along}.direction_of(pattern.row);
  const vec2 first = pattern.period_mm.x * row;
  return {Matrix(first, pattern.shift * first + pattern.period_mm.y * left_of(row))};
}

// Where the lattice repeats along `axis` (a unit vector), but for a slant that stretching takes away: after a length near
// `wanted` and with little slant. A slant of 1 % is as bad as a length that is 20 % off; by eye, for tiles of a usual size.
std::optional<double> fitting_length(const Repetition& repetition, vec2 axis, double wanted) {
  constexpr double cost_of_slant = 20.0;
  std::optional<double> best;
  double least = 0.0;
  for (std::int64_t i = -most_periods; i <= most_periods; ++i) {
    // Of the points with this i, the one nearest to the axis or, where they lie along it, to the length.
    const vec2 start = repetition.at({i, 0});
    const vec2 step = repetition.basis[1];
    const double slope = cross(axis, step);
    const bool along_axis = std::abs(slope) <= 1e-9 * glm::length(step);
    const double steps = along_axis ? (wanted - glm::dot(axis, start)) / glm::dot(axis, step) : -cross(axis, start) / slope;
    const vec2 point = repetition.at({i, std::llround(steps)});
    const double length = glm::dot(axis, point);
    const double slant = std::abs(cross(axis, point));
    if (length <= 0.0 || slant > 0.5 * most_stretch * length) continue;
    const double cost = std::abs(length - wanted) / wanted + cost_of_slant * slant / length;
    if (best && cost >= least) continue;
    best = length;
    least = cost;
  }
  return best;
}

// What a tile is made of.
struct Fit {
  vec2 size_mm{0.0, 0.0};
  Step along_x;
  Step along_y;
  Matrix stretch{1.0};

  std::int64_t classes() const { return along_x.i * along_y.j - along_x.j * along_y.i; }
};

// How far the map is from leaving all as it is.
double distortion(const Matrix& stretch) {
  double most = 0.0;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t r = 0; r < 2; ++r) most = std::max(most, std::abs(stretch[c][r] - (c == r ? 1.0 : 0.0)));
  }
  return most;
}

std::optional<Fit> fit_to(const Repetition& repetition, vec2 size_mm) {
  Fit fit{size_mm, repetition.nearest({size_mm.x, 0.0}), repetition.nearest({0.0, size_mm.y}), Matrix(1.0)};
  if (fit.classes() <= 0) return std::nullopt;
  const Matrix whole(repetition.at(fit.along_x), repetition.at(fit.along_y));
  fit.stretch = Matrix(vec2{size_mm.x, 0.0}, vec2{0.0, size_mm.y}) * glm::inverse(whole);
  if (distortion(fit.stretch) > most_stretch) return std::nullopt;
  return fit;
}

Fit fit_of(const Pavement& pavement, const Repetition& repetition) {
  const double near_mm = stones_to_a_tile * std::max(pitch_mm(pavement).x, pitch_mm(pavement).y);
  const vec2 wanted = pavement.textures.tile_mm.value_or(vec2{near_mm, near_mm});
  // A tile that is too small for any stone says nothing about directions.
  const auto fitting = [&](vec2 axis, double length_mm) {
    const auto found = fitting_length(repetition, axis, length_mm);
    return found ? found : fitting_length(repetition, axis, near_mm);
  };
  const auto width = fitting({1.0, 0.0}, wanted.x);
  const auto height = fitting({0.0, 1.0}, wanted.y);
  if (!width || !height) {
    throw InputError(texture_place(pavement, "seamless"),
                     "expected rows in a direction in which the bond repeats along x and y, such as 0, 45 "
                     "or 90 degrees, got one in which it does not");
  }
  const auto fit = fit_to(repetition, pavement.textures.tile_mm.value_or(vec2{*width, *height}));
  if (!fit) {
    throw InputError(texture_place(pavement, "tile_mm"),
                     fmt::format("expected a tile that whole periods of the bond fit, such as [{:.3f}, {:.3f}], "
                                 "got [{}, {}]",
                                 *width, *height, wanted.x, wanted.y));
  }
  return *fit;
}

// One point of each class, row by row.
std::vector<Step> class_points(const Fit& fit) {
  const Step& x = fit.along_x;
  const Step& y = fit.along_y;
  const auto [low_i, high_i] = std::minmax({std::int64_t{0}, x.i, y.i, x.i + y.i});
  const auto [low_j, high_j] = std::minmax({std::int64_t{0}, x.j, y.j, x.j + y.j});
  const std::int64_t classes = fit.classes();
  std::vector<Step> points;
  for (std::int64_t j = low_j; j <= high_j; ++j) {
    for (std::int64_t i = low_i; i <= high_i; ++i) {
      // Parts of both sides of the tile, times the number of classes.
      const std::int64_t s = y.j * i - y.i * j;
      const std::int64_t t = x.i * j - x.j * i;
      if (s >= 0 && s < classes && t >= 0 && t < classes) points.push_back({i, j});
    }
  }
  ENSURE(points.size() == static_cast<std::size_t>(classes));
  return points;
}

// The pattern of a tile, and how it is fitted in.
struct Plan {
  Pattern pattern;
  vec2 along{1.0, 0.0};
  Repetition repetition;
  Fit fit;
};

Plan plan_of(const Pavement& pavement) {
  std::optional<Pattern> pattern = periodic_pattern(pavement);
  if (!pattern) {
    const auto others = names_of_bonds([](const BondType& type) { return type.pattern == nullptr; });
    throw InputError(texture_place(pavement, "seamless"),
                     fmt::format("expected a bond that repeats (not {}), rows in one direction and stones of one size",
                                 fmt::join(others, " or ")));
  }
  if (pavement.border.course != BorderCourse::none) {
    throw InputError(texture_place(pavement, "seamless"), "expected no border_course, since a tile has no border");
  }
  const vec2 along = pattern_direction(pavement).direction();
  const Repetition repetition = repetition_of(*pattern, along);
  const Fit fit = fit_of(pavement, repetition);
  const double count = static_cast<double>(fit.classes()) * static_cast<double>(pattern->tiles.size());
  if (count > most_tile_stones) {
    throw InputError(texture_place(pavement, "tile_mm"),
                     fmt::format("expected a tile of at most {:.0f} stones, got {:.0f}", most_tile_stones, count));
  }
  return {std::move(*pattern), along, repetition, fit};
}

}  // namespace

void require_seamless(const Pavement& pavement) { static_cast<void>(plan_of(pavement)); }

SeamlessTile seamless_tile(const Pavement& pavement, std::uint64_t seed) {
  const auto [pattern, along, repetition, fit] = plan_of(pavement);
  SeamlessTile tile{fit.size_mm, {}};
  for (const Step& step : class_points(fit)) {
    for (const Tile& stone : pattern.tiles) {
      geometry::Polygon outline;
      for (const vec2& p : stone.outline_mm) {
        const vec2 turned = repetition.at(step) + p.x * along + p.y * left_of(along);
        outline.push_back(geometry::on_lattice(fit.stretch * turned));
      }
      const Angle angle = pavement.cell.form == CellForm::scale
                              ? main_direction(pavement)
                              : axis_angle(stone.axis.x * along + stone.axis.y * left_of(along));
      for (geometry::Polygon& face : faces_of(outline, pavement.joint_mm)) {
        const int id = static_cast<int>(tile.layout.stones.size());
        tile.layout.stones.push_back({id, StoneKind::whole, std::move(face), angle});
      }
    }
  }
  tile.layout = varied(std::move(tile.layout), {}, pavement, side_bulge(pavement), seed);
  colour(tile.layout, pavement, seed);
  return tile;
}

}  // namespace shatterpave::paving
