// A position field, after Jakob, Tarini, Panozzo and Sorkine-Hornung, "Instant Field-Aligned Meshes" (2015), §4, in the
// plane. At each sample of a fine grid stands a lattice of squares, turned to the direction field; what is sought are its
// offsets, so that the lattices of neighbouring samples agree but for whole steps. The offset of a sample is replaced by the
// mean of what its neighbours suggest; this is done on grids from coarse to fine, so that large areas agree first. Then each
// sample votes for the point of its lattice nearest to it, and the votes are gathered into particles.
//
// Departing from there, neighbours do not count alike. Where the field bends, lattices cannot agree everywhere. What differs
// along the row in the places of its stones makes these longer or shorter; what differs across, only shifts one row against the
// next, which perpends that end in Ts bear (cells.h). So the former weighs more; and of rows, in columns, likewise.
//
// Beside borders that run along or across the rows the lattice is held so that a row ends there: stones at such a border
// are whole.
#include "paving/packing/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/random.h"
#include "geometry/lattice.h"
#include "paving/packing/near_index.h"
#include "paving/tiles/near_points.h"
#include "paving/tiles/pattern.h"

namespace shatterpave::paving {

namespace {

// Samples to a pitch; two are too few where the field bends, more only cost time. By trial on the quarter annulus.
constexpr double samples_per_pitch = 2.2;
// Sweeps of Gauss and Seidel on each level. By trial: the number of irregular spots no longer falls.
constexpr int sweeps = 10;
// How much more a neighbour counts for places along the line to it than for those across. By trial on all plans of
// benchmarks/packing_quality: up to 4 areas spread less and less, by a tenth to a fifth.
constexpr double along_weight = 4.0;
// Samples this near to a border, in pitches, are held to it.
constexpr double held_pitches = 1.0;

// The nearest whole number, halves to even, for |x| < 2^51: adding 1.5 · 2^52 leaves no room for a fraction. It is where most
// of the time would go if it were a call.
double rounded(double x) {
  constexpr double no_fractions = 6755399441055744.0;
  return (x + no_fractions) - no_fractions;
}
vec2 rounded(vec2 q) { return {rounded(q.x), rounded(q.y)}; }

// A border that a sample is held to: a point of it and its unit normal, along the sample's axis or across it.
struct Wall {
  vec2 point{0.0, 0.0};
  vec2 normal{0.0, 0.0};
  double pitch = 0.0;
};

struct Sample {
  vec2 at{0.0, 0.0};
  vec2 axis{1.0, 0.0};
  vec2 pitch{1.0, 1.0};    // of its lattice, mm
  vec2 lattice{0.0, 0.0};  // the point of its lattice nearest to `at`

  Frame frame() const { return {axis, pitch}; }
};

struct Level {
  std::vector<GridPoint> points;
  std::vector<Sample> samples;
  std::vector<std::array<std::uint32_t, 4>> neighbours;
  std::vector<std::pair<std::uint32_t, Wall>> walls;  // by sample, ascending
};

constexpr std::uint32_t none = UINT32_MAX;

class PositionField {
 public:
  PositionField(const DirectionField& field, const SizeField& sizes, const geometry::RegionIndex& area, vec2 pitch,
                double band_mm, std::uint64_t seed)
      : field_(field),
        sizes_(sizes),
        area_(area),
        pitch_(pitch),
        seed_(seed),
        spacing_(sizes.smallest() * std::min(pitch.x, pitch.y) / samples_per_pitch) {
    levels_.emplace_back();
    levels_.front().points = near_points(grid(0), area, band_mm);
    while (levels_.back().points.size() > 8) {
      Level coarse;
      for (const GridPoint& p : levels_.back().points) coarse.points.push_back({p.j >> 1, p.i >> 1});
      std::ranges::sort(coarse.points);
      coarse.points.erase(std::unique(coarse.points.begin(), coarse.points.end()), coarse.points.end());
      if (coarse.points.size() == levels_.back().points.size()) break;
      levels_.push_back(std::move(coarse));
    }
  }

  std::vector<Sample> solved() {
    for (std::size_t level = levels_.size(); level-- > 0;) {
      prepare(level);
      start(level);
      for (int sweep = 0; sweep < sweeps; ++sweep) smooth(levels_[level], sweep % 2 == 1);
      if (level + 1 < levels_.size()) levels_.pop_back();
    }
    return std::move(levels_.front().samples);
  }

 private:
  Grid grid(std::size_t level) const {
    const double step = spacing_ * std::ldexp(1.0, static_cast<int>(level));
    const vec2 origin = area_.box().low + (0.5 * (step - spacing_)) * vec2{1.0, 1.0};
    return {origin, {step, 0.0}, {0.0, step}};
  }

  static std::uint32_t find(const Level& level, GridPoint p) {
    const auto at = std::ranges::lower_bound(level.points, p);
    return at != level.points.end() && *at == p ? static_cast<std::uint32_t>(at - level.points.begin()) : none;
  }

  void prepare(std::size_t number) {
    Level& level = levels_[number];
    const Grid g = grid(number);
    level.samples.resize(level.points.size());
    level.neighbours.resize(level.points.size());
    for (std::size_t s = 0; s < level.points.size(); ++s) {
      const GridPoint p = level.points[s];
      Sample& sample = level.samples[s];
      sample.at = g.at(p.i, p.j);
      sample.axis = field_.axis(sample.at);
      sample.pitch = sizes_.at(sample.at) * pitch_;
      const auto before = s > 0 && level.points[s - 1] == GridPoint{p.j, p.i - 1} ? static_cast<std::uint32_t>(s - 1) : none;
      const auto after = s + 1 < level.points.size() && level.points[s + 1] == GridPoint{p.j, p.i + 1}
                             ? static_cast<std::uint32_t>(s + 1)
                             : none;
      level.neighbours[s] = {before, after, find(level, {p.j - 1, p.i}), find(level, {p.j + 1, p.i})};
      if (const auto wall = wall_at(sample, g.along.x)) level.walls.emplace_back(static_cast<std::uint32_t>(s), *wall);
    }
  }

  std::optional<Wall> wall_at(const Sample& sample, double step) const {
    const double reach = std::max(held_pitches * std::max(sample.pitch.x, sample.pitch.y), 0.75 * step);
    if (!area_.border_within(sample.at, reach)) return std::nullopt;
    const auto nearest = area_.nearest(sample.at);
    const auto& segment = area_.segments()[nearest.segment];
    const vec2 tangent = (segment.to - segment.from) / glm::length(segment.to - segment.from);
    const bool along = std::abs(cross(sample.axis, tangent)) < along_sine;
    const bool across = std::abs(glm::dot(sample.axis, tangent)) < along_sine;
    if (!along && !across) return std::nullopt;
    return Wall{nearest.point, left_of(tangent), along ? sample.pitch.y : sample.pitch.x};
  }

  // The first guess: what the level above found, or a draw.
  void start(std::size_t number) {
    Level& level = levels_[number];
    for (std::size_t s = 0; s < level.samples.size(); ++s) {
      Sample& sample = level.samples[s];
      if (number + 1 < levels_.size()) {
        const Level& above = levels_[number + 1];
        const GridPoint p = level.points[s];
        sample.lattice = above.samples[find(above, {p.j >> 1, p.i >> 1})].lattice;
      } else {
        const Id id = Id("position field").child(s);
        const vec2 draw{uniform(seed_, {Stream::stone_seed, id, 0}), uniform(seed_, {Stream::stone_seed, id, 1})};
        sample.lattice = sample.at + sample.frame().out_of(draw);
      }
      settle(sample);
    }
  }

  // Takes the point of the sample's lattice that is nearest to it.
  void settle(Sample& sample) const {
    const Frame frame = sample.frame();
    sample.lattice -= frame.out_of(rounded(frame.into(sample.lattice - sample.at)));
  }

  void smooth(Level& level, bool backwards) const {
    for (std::size_t step = 0; step < level.samples.size(); ++step) {
      const std::size_t s = backwards ? level.samples.size() - 1 - step : step;
      Sample& sample = level.samples[s];
      vec2 sum{0.0, 0.0};
      vec2 count{0.0, 0.0};
      // The first two neighbours lie along x, the others along y.
      const vec2 squares = sample.axis * sample.axis;
      const std::array<vec2, 2> weights{vec2{1.0, 1.0} + (along_weight - 1.0) * squares,
                                        vec2{1.0, 1.0} + (along_weight - 1.0) * vec2{squares.y, squares.x}};
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t n = level.neighbours[s][k];
        if (n == none) continue;
        const Sample& other = level.samples[n];
        const Frame frame = mean_frame(sample.axis, other.axis, field_.is_cross(), 0.5 * (sample.pitch + other.pitch));
        const vec2 q = frame.into(other.lattice - sample.lattice);
        sum += frame.out_of(weights[k / 2] * (q - rounded(q)));
        count += weights[k / 2];
      }
      const Frame own = sample.frame();
      if (count.x > 0.0) sample.lattice += own.out_of(own.into(sum) / count);
      hold(level, s);
      settle(sample);
    }
  }

  // Moves the lattice of a sample beside a border so that the border runs in the middle between two of its rows.
  static void hold(Level& level, std::size_t s) {
    const auto at =
        std::ranges::lower_bound(level.walls, static_cast<std::uint32_t>(s), {}, &std::pair<std::uint32_t, Wall>::first);
    if (at == level.walls.end() || at->first != s) return;
    const Wall& wall = at->second;
    vec2& lattice = level.samples[s].lattice;
    const double height = glm::dot(lattice - wall.point, wall.normal) / wall.pitch;
    lattice += (std::floor(height) + 0.5 - height) * wall.pitch * wall.normal;
  }

  const DirectionField& field_;
  const SizeField& sizes_;
  const geometry::RegionIndex& area_;
  vec2 pitch_;
  std::uint64_t seed_;
  double spacing_;
  std::vector<Level> levels_;
};

// A place that samples vote for.
struct Vote {
  vec2 sum{0.0, 0.0};
  double count = 0.0;
  vec2 axis{1.0, 0.0};

  vec2 mean() const { return sum / count; }
};

// `smallest_mm` is the longer pitch of the smallest stone.
std::vector<Vote> gathered(const std::vector<Sample>& samples, double smallest_mm) {
  constexpr double reach = 0.5;  // pitches
  NearIndex near(reach * smallest_mm, samples.size() / 4);
  std::vector<Vote> votes;
  for (const Sample& sample : samples) {
    const Frame frame = sample.frame();
    std::uint32_t best = none;
    double best_distance = 0.4;  // pitches; nearer than half, so that a vote belongs to one place
    near.for_each_near(sample.lattice, reach * std::max(frame.pitch.x, frame.pitch.y), [&](std::uint32_t v) {
      const double distance = largest(frame.into(votes[v].mean() - sample.lattice));
      if (distance < best_distance) {
        best_distance = distance;
        best = v;
      }
    });
    if (best == none) {
      near.add(sample.lattice);
      votes.push_back({sample.lattice, 1.0, sample.axis});
    } else {
      votes[best].sum += sample.lattice;
      votes[best].count += 1.0;
    }
  }
  return votes;
}

}  // namespace

std::vector<Particle> straight_rows(const geometry::RegionIndex& area, vec2 along, vec2 pitch, double band_mm) {
  const vec2 across = left_of(along);
  const vec2 first = lowest_corner(area, along) + 0.5 * pitch;
  const Grid grid{first.x * along + first.y * across, pitch.x * along, pitch.y * across};
  std::vector<Particle> particles;
  for (const GridPoint& p : near_points(grid, area, band_mm)) {
    particles.push_back({geometry::on_lattice(grid.at(p.i, p.j)), along});
  }
  return particles;
}

std::vector<Particle> rows_along(const DirectionField& field, const SizeField& sizes, const geometry::RegionIndex& area,
                                 vec2 pitch, double band_mm, std::uint64_t seed) {
  const auto samples = PositionField(field, sizes, area, pitch, band_mm, seed).solved();
  const double smallest_mm = sizes.smallest() * std::max(pitch.x, pitch.y);
  const auto votes = gathered(samples, smallest_mm);
  std::vector<std::size_t> order(votes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return votes[a].count > votes[b].count; });
  // Those with most votes first; others only where there is room.
  constexpr double room = 0.62;  // pitches; by trial: below it the packing pushes particles out again
  NearIndex near(smallest_mm, votes.size());
  std::vector<vec2> placed;
  std::vector<std::size_t> taken;
  for (const std::size_t v : order) {
    const vec2 here = votes[v].mean();
    const Frame frame{votes[v].axis, sizes.at(here) * pitch};
    bool free = true;
    near.for_each_near(here, std::max(frame.pitch.x, frame.pitch.y),
                       [&](std::uint32_t p) { free = free && largest(frame.into(placed[p] - here)) >= room; });
    if (!free) continue;
    near.add(here);
    placed.push_back(here);
    taken.push_back(v);
  }
  std::ranges::sort(taken);
  std::vector<Particle> particles;
  particles.reserve(taken.size());
  for (const std::size_t v : taken) {
    particles.push_back({votes[v].mean(), field.axis(votes[v].mean()), sizes.at(votes[v].mean())});
  }
  return particles;
}

}  // namespace shatterpave::paving
