#include "measure/fragments.h"

#include <algorithm>
#include <cmath>

#include "geometry/region_index.h"

namespace shatterpave::measure {

namespace {

using glass::CrackEnd;

// What an end of a crack adds to twice the number of fragments about it.
int added_by(const CrackEnd& end) {
  if (end.at == CrackEnd::At::crack) return 1;
  return end.at == CrackEnd::At::open || end.at == CrackEnd::At::enclosed ? -1 : 0;
}

// From the point to the box of the square, whose lower left corner is `low`.
double distance_to_square(vec2 point, vec2 low) {
  const vec2 nearest = glm::clamp(point, low, low + vec2{counting_square_mm, counting_square_mm});
  return glm::length(point - nearest);
}

class Grid {
 public:
  explicit Grid(const geometry::Polygon& outline) : box_(geometry::bounding_box(outline)) {
    const vec2 size = box_.high - box_.low - 2.0 * vec2{left_out_at_edge_mm, left_out_at_edge_mm};
    columns_ = size.x < counting_square_mm ? 0 : static_cast<int>(size.x / counting_square_mm);
    rows_ = size.y < counting_square_mm ? 0 : static_cast<int>(size.y / counting_square_mm);
    const vec2 used = counting_square_mm * vec2{static_cast<double>(columns_), static_cast<double>(rows_)};
    low_ = 0.5 * (box_.low + box_.high - used);
    twice_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 2);
  }

  void add(vec2 point, int twice) {
    const vec2 cell = glm::floor((point - low_) / counting_square_mm);
    if (cell.x < 0.0 || cell.y < 0.0 || cell.x >= columns_ || cell.y >= rows_) return;
    twice_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(cell.x)] += twice;
  }

  // Calls visit(lower left corner, count) for each square.
  template <typename Visit>
  void visit(Visit visit) const {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
        const vec2 low = low_ + counting_square_mm * vec2{static_cast<double>(column), static_cast<double>(row)};
        visit(low, 0.5 * twice_[at]);
      }
    }
  }

 private:
  geometry::Box box_;
  vec2 low_{0.0, 0.0};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> twice_;
};

}  // namespace

std::vector<double> fragment_counts(const glass::CrackNetwork& network, const glass::Pane& pane) {
  Grid grid(pane.outline_mm);
  for (const glass::Crack& crack : network.cracks) {
    grid.add(crack.points_mm.front(), added_by(crack.start));
    grid.add(crack.points_mm.back(), added_by(crack.end));
  }
  const geometry::RegionIndex inside({pane.outline_mm, {}});
  const vec2 half = 0.5 * vec2{counting_square_mm, counting_square_mm};
  std::vector<double> counts;
  grid.visit([&](vec2 low, double count) {
    const auto near_impact = [&](const glass::ImpactCounts& impact) {
      return distance_to_square(impact.at_mm, low) < left_out_at_impact_mm;
    };
    if (std::ranges::any_of(network.impacts, near_impact)) return;
    const vec2 margin = half + vec2{left_out_at_edge_mm, left_out_at_edge_mm};
    const vec2 middle = low + half;
    // A hair less, since squares may lie just as far from the edge as they have to.
    constexpr double hair_mm = 1e-3;
    const geometry::Box around{middle - margin + hair_mm, middle + margin - hair_mm};
    if (inside.contains(middle) && !inside.border_meets(around)) counts.push_back(count);
  });
  return counts;
}

double radiality(const glass::CrackNetwork& network, double from_mm, double to_mm) {
  if (network.impacts.empty()) return 0.0;
  const vec2 impact = network.impacts.front().at_mm;
  double length = 0.0;
  double sum = 0.0;
  for (const glass::Crack& crack : network.cracks) {
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const vec2 way = crack.points_mm[i] - crack.points_mm[i - 1];
      const vec2 out = 0.5 * (crack.points_mm[i] + crack.points_mm[i - 1]) - impact;
      const double distance = glm::length(out);
      if (distance < from_mm || distance >= to_mm || distance == 0.0) continue;
      const double cosine = glm::dot(way, out) / (glm::length(way) * distance);
      length += glm::length(way);
      sum += glm::length(way) * (2.0 * cosine * cosine - 1.0);
    }
  }
  return length == 0.0 ? 0.0 : sum / length;
}

}  // namespace shatterpave::measure
