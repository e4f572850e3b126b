// A direction with n-fold symmetry at angle t is held as the vector at angle n t, which can be averaged. On a square grid
// the nodes beside a line that the rows follow are held to its direction, the others take the mean of their neighbours.
// The grid is solved from coarse to fine: each level starts from the one above it, so that a few sweeps a level suffice.
#include "paving/field/direction_field.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/segment_distance.h"
#include "paving/field/axes.h"

namespace shatterpave::paving {

namespace {

using Segment = geometry::RegionIndex::Segment;

constexpr vec2 along_x{1.0, 0.0};
// Nodes of the finest grid at most; at two million stones it is then about a pitch fine.
constexpr double most_nodes = 4e6;
// Sweeps of Gauss and Seidel on each level; more do not change the picture.
constexpr int sweeps = 12;
// How many times more than its neighbours a node beside a line heeds the line; by eye: the first row is straight.
constexpr double line_weight = 20.0;
// Runs of sides shorter than this have no rows of their own; in pitches, by eye.
constexpr double least_run_pitches = 4.0;
// Lines that meet in a node at odd angles cancel; below this length of their mean they say nothing.
constexpr double least_agreement = 0.3;

vec2 unit(vec2 v, vec2 otherwise) {
  const double l = glm::length(v);
  return l > 0.0 ? v / l : otherwise;
}

// The unit vector at twice the angle of the unit vector v.
vec2 doubled(vec2 v) { return {v.x * v.x - v.y * v.y, 2.0 * v.x * v.y}; }

// The unit vector at half the angle of the unit vector v; the angle is taken in (−180°, 180°].
vec2 halved(vec2 v) {
  const double x = std::sqrt(std::max(0.0, 0.5 * (1.0 + v.x)));
  const double y = std::sqrt(std::max(0.0, 0.5 * (1.0 - v.x)));
  return {x, v.y < 0.0 ? -y : y};
}

}  // namespace

// One level of the grid on which the field is solved.
class FieldGrid {
 public:
  FieldGrid(vec2 origin, double spacing_mm, std::size_t columns, std::size_t rows)
      : origin_(origin),
        spacing_mm_(spacing_mm),
        columns_(columns),
        rows_(rows),
        values_(columns * rows, vec2{0.0, 0.0}),
        lines_(columns * rows, vec2{0.0, 0.0}),
        weights_(columns * rows, 0.0) {}

  // Adds a line's direction to the nodes beside it. `value` is its direction, n-fold.
  void draw(const Segment& line, vec2 value) {
    const vec2 d = line.to - line.from;
    const double steps = std::ceil(2.0 * glm::length(d) / spacing_mm_) + 1.0;
    const double weight = glm::length(d) / (steps * spacing_mm_);
    for (double step = 0.5; step < steps; step += 1.0) splat(line.from + step / steps * d, value, weight);
  }

  // Half as fine, with the same lines.
  FieldGrid coarser() const {
    FieldGrid coarse(origin_ + vec2{0.5, 0.5} * spacing_mm_, 2.0 * spacing_mm_, (columns_ + 1) / 2, (rows_ + 1) / 2);
    for (std::size_t r = 0; r < rows_; ++r) {
      for (std::size_t c = 0; c < columns_; ++c) {
        const std::size_t into = r / 2 * coarse.columns_ + c / 2;
        coarse.lines_[into] += lines_[r * columns_ + c];
        coarse.weights_[into] += weights_[r * columns_ + c];
      }
    }
    return coarse;
  }

  void solve(int depth) {
    if (columns_ > 2 && rows_ > 2) {
      FieldGrid coarse = coarser();
      coarse.solve(depth + 1);
      for (std::size_t r = 0; r < rows_; ++r) {
        for (std::size_t c = 0; c < columns_; ++c) values_[r * columns_ + c] = coarse.values_[r / 2 * coarse.columns_ + c / 2];
      }
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const bool agrees = glm::length(lines_[i]) > least_agreement * weights_[i] && weights_[i] > 0.0;
      lines_[i] = agrees ? lines_[i] / glm::length(lines_[i]) : vec2{0.0, 0.0};
      weights_[i] = agrees ? std::min(1.0, weights_[i]) : 0.0;
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) smooth(sweep % 2 == 1);
  }

  DirectionField::Samples samples() && {
    for (vec2& value : values_) value = unit(value, along_x);
    return {origin_, spacing_mm_, columns_, rows_, std::move(values_)};
  }

 private:
  void splat(vec2 place, vec2 value, double weight) {
    const vec2 at = (place - origin_) / spacing_mm_;
    if (!(at.x >= 0.0 && at.y >= 0.0)) return;
    const auto c = static_cast<std::size_t>(at.x);
    const auto r = static_cast<std::size_t>(at.y);
    if (c + 1 >= columns_ || r + 1 >= rows_) return;
    const vec2 f = at - vec2{static_cast<double>(c), static_cast<double>(r)};
    add(c, r, (1.0 - f.x) * (1.0 - f.y) * weight, value);
    add(c + 1, r, f.x * (1.0 - f.y) * weight, value);
    add(c, r + 1, (1.0 - f.x) * f.y * weight, value);
    add(c + 1, r + 1, f.x * f.y * weight, value);
  }

  void add(std::size_t c, std::size_t r, double weight, vec2 value) {
    lines_[r * columns_ + c] += weight * value;
    weights_[r * columns_ + c] += weight;
  }

  void smooth(bool backwards) {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const std::size_t i = backwards ? values_.size() - 1 - k : k;
      const std::size_t c = i % columns_;
      const std::size_t r = i / columns_;
      vec2 sum = line_weight * weights_[i] * lines_[i];
      double weight = line_weight * weights_[i];
      const auto take = [&](bool there, std::size_t j) {
        if (!there) return;
        sum += values_[j];
        weight += 1.0;
      };
      take(c > 0, i - 1);
      take(c + 1 < columns_, i + 1);
      take(r > 0, i - columns_);
      take(r + 1 < rows_, i + columns_);
      if (weight > 0.0) values_[i] = sum / weight;
    }
  }

  vec2 origin_;
  double spacing_mm_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<vec2> values_;
  std::vector<vec2> lines_;      // of the lines beside a node, their weighted directions, then their mean direction
  std::vector<double> weights_;  // their length beside it, in spacings
};

namespace {

std::vector<Segment> followed_lines(const Direction& direction, const geometry::RegionIndex& area) {
  if (std::holds_alternative<BoundaryDirection>(direction)) return area.segments();
  std::vector<Segment> lines;
  for (const auto& guide : std::get<GuidesDirection>(direction).guides_mm) {
    for (std::size_t i = 0; i + 1 < guide.size(); ++i) {
      if (guide[i] != guide[i + 1]) lines.push_back({guide[i], guide[i + 1]});
    }
  }
  return lines;
}

// The box within which lines count: that of the area, and as much about it again, so that a guide beside it is heeded.
geometry::Box field_box(const geometry::RegionIndex& area, const std::vector<Segment>& lines, double band_mm) {
  geometry::Box box = area.box();
  const vec2 size = box.high - box.low;
  const double reach = 0.5 * std::max(size.x, size.y);
  vec2 low = box.low;
  vec2 high = box.high;
  for (const Segment& line : lines) {
    low = glm::min(low, glm::min(line.from, line.to));
    high = glm::max(high, glm::max(line.from, line.to));
  }
  box.low = glm::max(low, box.low - vec2{reach, reach}) - vec2{band_mm, band_mm};
  box.high = glm::min(high, box.high + vec2{reach, reach}) + vec2{band_mm, band_mm};
  return box;
}

// The direction of a zone: straight rows where all its sides lie on one line, else the sides as guides.
Direction zone_direction(const std::vector<Segment>& sides) {
  const vec2 axis = unit(sides.front().to - sides.front().from, along_x);
  const auto on_line = [&](const Segment& side) {
    constexpr double rounding_mm = 0.01;
    return std::abs(cross(axis, side.from - sides.front().from)) < rounding_mm &&
           std::abs(cross(axis, side.to - sides.front().from)) < rounding_mm;
  };
  if (std::ranges::all_of(sides, on_line)) return ConstantDirection{Angle::of(axis)};
  GuidesDirection guides;
  for (const Segment& side : sides) guides.guides_mm.push_back({side.from, side.to});
  return guides;
}

}  // namespace

DirectionField::DirectionField(const Pavement& pavement, const geometry::RegionIndex& area)
    : direction_(pavement.direction),
      fold_(pavement.stone_mm.x == pavement.stone_mm.y ? 4 : 2),
      on_corners_(pavement.cell.form == CellForm::scale) {
  const bool plain =
      std::holds_alternative<ConstantDirection>(direction_) || std::holds_alternative<RadialDirection>(direction_);
  if (plain) return;
  if (const auto* grid = std::get_if<GridDirection>(&direction_)) {
    take(*grid);
    return;
  }
  if (std::holds_alternative<BoundaryDirection>(direction_) && !is_cross()) {
    const vec2 pitch = pitch_mm(pavement);
    const BorderZones parts = border_zones(pavement.area, area, least_run_pitches * std::max(pitch.x, pitch.y));
    if (parts.areas.size() > 1) {
      part(pavement, area, parts);
      return;
    }
  }
  solve(pavement, area);
}

void DirectionField::part(const Pavement& pavement, const geometry::RegionIndex& area, const BorderZones& parts) {
  std::vector<std::vector<Segment>> sides(parts.areas.size());
  for (std::size_t s = 0; s < area.segments().size(); ++s) sides[parts.of_segment[s]].push_back(area.segments()[s]);
  for (std::size_t z = 0; z < sides.size(); ++z) {
    Pavement zone = pavement;
    zone.direction = zone_direction(sides[z]);
    zones_.push_back({parts.areas[z], zone.direction, DirectionField(zone, area)});
  }
  border_ = area;
  zone_of_segment_ = parts.of_segment;
}

// Places without a vector take the mean of those about them that have one, ring by ring inwards.
void DirectionField::take(const GridDirection& grid) {
  if (grid.pitch_mm <= 0.0 || grid.columns < 2 || grid.vectors.size() < 2 * grid.columns ||
      grid.vectors.size() % grid.columns != 0) {
    throw InputError("direction: expected a grid of two or more rows and columns");
  }
  samples_ = {grid.origin_mm, grid.pitch_mm, grid.columns, grid.vectors.size() / grid.columns, {}};
  std::vector<bool> known;
  for (const vec2& v : grid.vectors) {
    const double length = glm::length(v);
    const vec2 twice = length > 0.0 ? doubled(v / length) : vec2{0.0, 0.0};
    samples_.values.push_back(fold_ == 4 && length > 0.0 ? doubled(twice) : twice);
    known.push_back(length > 0.0);
  }
  if (std::ranges::find(known, true) == known.end()) throw InputError("direction: expected a vector other than 0");
  while (std::ranges::find(known, false) != known.end()) fill_ring(known);
}

void DirectionField::fill_ring(std::vector<bool>& known) {
  const std::vector<bool> before = known;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i]) continue;
    const std::size_t c = i % samples_.columns;
    vec2 sum{0.0, 0.0};
    bool any = false;
    const auto heed = [&](bool there, std::size_t j) {
      if (!there || !before[j]) return;
      sum += samples_.values[j];
      any = true;
    };
    heed(c > 0, i - 1);
    heed(c + 1 < samples_.columns, i + 1);
    heed(i >= samples_.columns, i - samples_.columns);
    heed(i + samples_.columns < before.size(), i + samples_.columns);
    if (!any) continue;
    samples_.values[i] = unit(sum, along_x);  // about a singular place its neighbours cancel: any direction is as good
    known[i] = true;
  }
}

void DirectionField::solve(const Pavement& pavement, const geometry::RegionIndex& area) {
  const auto lines = followed_lines(direction_, area);
  if (on_corners_ && std::holds_alternative<BoundaryDirection>(direction_)) outline_ = area;
  if (on_corners_ && !outline_) {
    guides_.reserve(lines.size());
    for (const Segment& line : lines) guides_.emplace_back(line.from, line.to);
  }
  if (lines.empty()) throw InputError("guides: expected at least one polyline of two distinct points");
  const vec2 pitch = pitch_mm(pavement);
  const geometry::Box box = field_box(area, lines, 4.0 * std::max(pitch.x, pitch.y));
  const vec2 size = box.high - box.low;
  const double spacing = std::max(std::min(pitch.x, pitch.y), std::sqrt(size.x * size.y / most_nodes));
  FieldGrid grid(box.low, spacing, static_cast<std::size_t>(size.x / spacing) + 2,
                 static_cast<std::size_t>(size.y / spacing) + 2);
  for (const Segment& line : lines) {
    const vec2 twice = doubled(unit(line.to - line.from, along_x));
    grid.draw(line, fold_ == 4 ? doubled(twice) : twice);
  }
  grid.solve(0);
  samples_ = std::move(grid).samples();
}

vec2 DirectionField::sampled(vec2 place) const {
  const vec2 most{static_cast<double>(samples_.columns - 1), static_cast<double>(samples_.rows - 1)};
  const vec2 at = glm::clamp((place - samples_.origin) / samples_.spacing_mm, vec2{0.0, 0.0}, most);
  const std::size_t c = std::min(static_cast<std::size_t>(at.x), samples_.columns - 2);
  const std::size_t r = std::min(static_cast<std::size_t>(at.y), samples_.rows - 2);
  const vec2 f = at - vec2{static_cast<double>(c), static_cast<double>(r)};
  const vec2* v = samples_.values.data() + r * samples_.columns + c;
  const vec2 below = (1.0 - f.x) * v[0] + f.x * v[1];
  const vec2 above = (1.0 - f.x) * v[samples_.columns] + f.x * v[samples_.columns + 1];
  return unit((1.0 - f.y) * below + f.y * above, along_x);
}

vec2 DirectionField::axis(vec2 place) const {
  const vec2 along = asked_axis(place);
  constexpr double half_diagonal = 0.70710678118654752;
  return on_corners_ ? half_diagonal * (along + left_of(along)) : along;
}

// Of no meaning but its side.
vec2 DirectionField::sense(vec2 place) const {
  if (outline_) {
    const Segment& side = outline_->segments()[outline_->nearest(place).segment];
    return side.to - side.from;
  }
  if (!guides_.empty()) {
    const auto nearest = std::ranges::min_element(guides_, {}, [&](const std::pair<vec2, vec2>& side) {
      return geometry::distance_to_segment(place, side.first, side.second);
    });
    return nearest->second - nearest->first;
  }
  const auto* grid = std::get_if<GridDirection>(&direction_);
  if (grid == nullptr) return asked_axis(place);
  const vec2 most{static_cast<double>(samples_.columns - 1), static_cast<double>(samples_.rows - 1)};
  const vec2 at = glm::clamp((place - samples_.origin) / samples_.spacing_mm, vec2{0.0, 0.0}, most) + vec2{0.5, 0.5};
  return grid->vectors[static_cast<std::size_t>(at.y) * samples_.columns + static_cast<std::size_t>(at.x)];
}

vec2 DirectionField::heading(vec2 place) const {
  const vec2 side = sense(place);
  const vec2 along = asked_axis(place);
  return side == vec2{0.0, 0.0} ? along : turned_like(along, side, is_cross());
}

vec2 DirectionField::asked_axis(vec2 place) const {
  if (const auto* constant = std::get_if<ConstantDirection>(&direction_)) return constant->angle.direction();
  if (const auto* radial = std::get_if<RadialDirection>(&direction_)) return unit(left_of(place - radial->centre_mm), along_x);
  if (border_) return zones_[zone_of_segment_[border_->nearest(place).segment]].field.axis(place);
  const vec2 half = halved(sampled(place));
  return fold_ == 4 ? halved(half) : half;
}

Angle DirectionField::angle(vec2 place) const {
  vec2 direction = axis(place);
  if (direction.x < 0.0 || (direction.x == 0.0 && direction.y < 0.0)) direction = -direction;
  const Angle angle = Angle::of(direction);
  return angle.degrees() > -90.0 ? angle : Angle::degrees(90.0);  // straight down but for rounding
}

}  // namespace shatterpave::paving
