#include "paving/field/size_field.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "core/overloaded.h"
#include "core/parallel.h"

namespace shatterpave::paving {

namespace {

// To the smallest stone; by trial: sizes bend no more than a line between such nodes.
constexpr double nodes_per_stone = 2.0;
// As many as nodes of a direction field (direction_field.cpp).
constexpr double most_size_nodes = 4e6;
// Beyond the box of the area, in the largest stones: as far as particles lie (packing.cpp), and more.
constexpr double size_band = 4.0;

double size_on(const SizeRamp& ramp, double distance_mm) {
  return ramp.near + std::clamp(distance_mm / ramp.distance_mm, 0.0, 1.0) * (ramp.far - ramp.near);
}

// The polylines as borders of a region without an area, which finds the nearest as fast as any border.
geometry::RegionIndex index_of_lines(const std::vector<std::vector<vec2>>& lines) {
  geometry::Region region;
  for (const auto& line : lines) {
    geometry::Polygon ring = line;
    for (std::size_t i = line.size(); i-- > 1;) {
      if (i + 1 < line.size()) ring.push_back(line[i]);
    }
    (region.outline.empty() ? region.outline : region.holes.emplace_back()) = std::move(ring);
  }
  return geometry::RegionIndex(region);
}

double grey_at(const SizesOfMap& map, vec2 place) {
  const std::size_t rows = map.greys.size() / map.columns;
  const vec2 count{static_cast<double>(map.columns), static_cast<double>(rows)};
  const vec2 part = (place - map.low_mm) / (map.high_mm - map.low_mm);
  // Pixels are centred in their squares; their rows begin at the top.
  const vec2 at = glm::clamp(vec2{part.x, 1.0 - part.y} * count - vec2{0.5, 0.5}, vec2{0.0, 0.0}, count - vec2{1.0, 1.0});
  const auto c = static_cast<std::size_t>(at.x);
  const auto r = static_cast<std::size_t>(at.y);
  const vec2 f = at - vec2{static_cast<double>(c), static_cast<double>(r)};
  const auto grey = [&](std::size_t column, std::size_t row) {
    return static_cast<double>(map.greys[std::min(row, rows - 1) * map.columns + std::min(column, map.columns - 1)]);
  };
  const double above = (1.0 - f.x) * grey(c, r) + f.x * grey(c + 1, r);
  const double below = (1.0 - f.x) * grey(c, r + 1) + f.x * grey(c + 1, r + 1);
  return (1.0 - f.y) * above + f.y * below;
}

// What is asked for at a place. `pavement` and `area` must outlive it.
std::function<double(vec2)> size_asked(const Pavement& pavement, const geometry::RegionIndex& area) {
  using Asked = std::function<double(vec2)>;
  return std::visit(Overloaded{[](const EqualSizes&) -> Asked { return [](vec2) { return 1.0; }; },
                               [&](const SizesFromEdge& sizes) -> Asked {
                                 return [&sizes, &area](vec2 place) {
                                   return size_on(sizes.ramp, area.contains(place) ? area.nearest(place).distance_mm : 0.0);
                                 };
                               },
                               [](const SizesFromLines& sizes) -> Asked {
                                 return [&sizes, lines = index_of_lines(sizes.lines_mm)](vec2 place) {
                                   return size_on(sizes.ramp, lines.nearest(place).distance_mm);
                                 };
                               },
                               [](const SizesOfMap& map) -> Asked {
                                 return [&map](vec2 place) { return map.dark + grey_at(map, place) * (map.light - map.dark); };
                               }},
                    pavement.sizes);
}

}  // namespace

SizeField::SizeField(const Pavement& pavement, const geometry::RegionIndex& area) {
  if (!has_sizes(pavement)) return;
  const SizeRange asked = size_range(pavement);
  longer_mm_ = std::max(pitch_mm(pavement).x, pitch_mm(pavement).y);
  const double band = size_band * asked.largest * longer_mm_;
  origin_ = area.box().low - vec2{band, band};
  const vec2 size = area.box().high + vec2{band, band} - origin_;
  const double shorter = std::min(pitch_mm(pavement).x, pitch_mm(pavement).y);
  spacing_mm_ = std::max(asked.smallest * shorter / nodes_per_stone, std::sqrt(size.x * size.y / most_size_nodes));
  columns_ = static_cast<std::size_t>(size.x / spacing_mm_) + 2;
  rows_ = static_cast<std::size_t>(size.y / spacing_mm_) + 2;
  sizes_.resize(columns_ * rows_);
  sample(pavement, area);
  limit_growth();
  const auto [low, high] = std::ranges::minmax(sizes_);
  smallest_ = static_cast<double>(low);
  largest_ = static_cast<double>(high);
}

vec2 SizeField::node(std::size_t column, std::size_t row) const {
  return origin_ + spacing_mm_ * vec2{static_cast<double>(column), static_cast<double>(row)};
}

void SizeField::sample(const Pavement& pavement, const geometry::RegionIndex& area) {
  const auto asked = size_asked(pavement, area);
  parallel_for(rows_, [&](std::size_t r) {
    for (std::size_t c = 0; c < columns_; ++c) sizes_[r * columns_ + c] = static_cast<float>(asked(node(c, r)));
  });
}

// Twice over the grid: from the lower left, then from the upper right, each node heeds the neighbours that came before it.
void SizeField::limit_growth() {
  const auto straight = static_cast<float>(most_growth * spacing_mm_ / longer_mm_);
  const float slanting = straight * std::sqrt(2.0F);
  const auto heed = [&](std::size_t i, bool there, std::size_t j, float growth) {
    if (there) sizes_[i] = std::min(sizes_[i], sizes_[j] + growth);
  };
  for (std::size_t r = 0; r < rows_; ++r) {
    for (std::size_t c = 0; c < columns_; ++c) {
      const std::size_t i = r * columns_ + c;
      heed(i, c > 0, i - 1, straight);
      heed(i, r > 0, i - columns_, straight);
      heed(i, r > 0 && c > 0, i - columns_ - 1, slanting);
      heed(i, r > 0 && c + 1 < columns_, i - columns_ + 1, slanting);
    }
  }
  for (std::size_t r = rows_; r-- > 0;) {
    for (std::size_t c = columns_; c-- > 0;) {
      const std::size_t i = r * columns_ + c;
      heed(i, c + 1 < columns_, i + 1, straight);
      heed(i, r + 1 < rows_, i + columns_, straight);
      heed(i, r + 1 < rows_ && c > 0, i + columns_ - 1, slanting);
      heed(i, r + 1 < rows_ && c + 1 < columns_, i + columns_ + 1, slanting);
    }
  }
}

double SizeField::largest_along(const geometry::RegionIndex& area) const {
  if (is_even()) return 1.0;
  double found = 0.0;
  for (const auto& segment : area.segments()) {
    const vec2 d = segment.to - segment.from;
    const double steps = std::ceil(glm::length(d) / (smallest_ * longer_mm_)) + 1.0;
    for (double step = 0.0; step <= steps; step += 1.0) found = std::max(found, at(segment.from + step / steps * d));
  }
  return std::min(largest_, (1.0 + most_growth) * found);
}

double SizeField::at(vec2 place) const {
  if (sizes_.empty()) return 1.0;
  const vec2 most{static_cast<double>(columns_ - 1), static_cast<double>(rows_ - 1)};
  const vec2 at = glm::clamp((place - origin_) / spacing_mm_, vec2{0.0, 0.0}, most);
  const std::size_t c = std::min(static_cast<std::size_t>(at.x), columns_ - 2);
  const std::size_t r = std::min(static_cast<std::size_t>(at.y), rows_ - 2);
  const vec2 f = at - vec2{static_cast<double>(c), static_cast<double>(r)};
  const auto size = [&](std::size_t i) { return static_cast<double>(sizes_[i]); };
  const std::size_t i = r * columns_ + c;
  const double below = (1.0 - f.x) * size(i) + f.x * size(i + 1);
  const double above = (1.0 - f.x) * size(i + columns_) + f.x * size(i + columns_ + 1);
  return (1.0 - f.y) * below + f.y * above;
}

}  // namespace shatterpave::paving
