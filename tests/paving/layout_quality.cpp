#include "paving/layout_quality.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/clip.h"
#include "geometry/predicates.h"
#include "geometry/region_index.h"
#include "measure/pavement_measures.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::LatticePoint;
using geometry::Polygon;
using geometry::Side;
using geometry::to_lattice;

double length(vec2 v) { return std::sqrt(glm::dot(v, v)); }

// Boxes sorted into squares, so that only neighbours are compared.
class Neighbourhood {
 public:
  Neighbourhood(const StoneLayout& layout, double square_mm) : square_mm_(square_mm) {
    for (std::size_t s = 0; s < layout.stones.size(); ++s) {
      boxes_.push_back(geometry::bounding_box(layout.stones[s].outline_mm));
      for_each_square(boxes_.back(), 0.0, [&](std::pair<long, long> square) { squares_[square].push_back(s); });
    }
  }

  // Stones whose boxes come within `margin` of that of stone s.
  std::vector<std::size_t> near(std::size_t s, double margin) const {
    std::vector<std::size_t> found;
    for_each_square(boxes_[s], margin, [&](std::pair<long, long> square) {
      const auto stones = squares_.find(square);
      if (stones == squares_.end()) return;
      for (const std::size_t t : stones->second) {
        const Box& a = boxes_[s];
        const Box& b = boxes_[t];
        if (t != s && a.low.x - margin <= b.high.x && b.low.x <= a.high.x + margin && a.low.y - margin <= b.high.y &&
            b.low.y <= a.high.y + margin) {
          found.push_back(t);
        }
      }
    });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  template <typename Visit>
  void for_each_square(const Box& box, double margin, Visit visit) const {
    const auto index = [&](double mm) { return std::lround(std::floor(mm / square_mm_)); };
    for (long x = index(box.low.x - margin); x <= index(box.high.x + margin); ++x) {
      for (long y = index(box.low.y - margin); y <= index(box.high.y + margin); ++y) visit({x, y});
    }
  }

  double square_mm_;
  std::vector<Box> boxes_;
  std::map<std::pair<long, long>, std::vector<std::size_t>> squares_;
};

bool valid(const Polygon& polygon) {
  if (polygon.size() < 3 || geometry::area(polygon) <= 0.0 || !geometry::is_simple(polygon)) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (geometry::on_lattice(polygon[i]) != polygon[i]) return false;
    const LatticePoint a = to_lattice(polygon[i]);
    const LatticePoint b = to_lattice(polygon[(i + 1) % polygon.size()]);
    if (geometry::side(a, b, to_lattice(polygon[(i + 2) % polygon.size()])) == Side::on) return false;
  }
  return true;
}

bool overlap(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (geometry::segments_meet(to_lattice(a[i]), to_lattice(a[(i + 1) % a.size()]), to_lattice(b[j]),
                                  to_lattice(b[(j + 1) % b.size()]))) {
        return true;
      }
    }
  }
  return geometry::contains(a, b.front()) || geometry::contains(b, a.front());
}

bool leaves(const Polygon& stone, const geometry::RegionIndex& area, std::vector<std::size_t>& scratch) {
  if (!std::ranges::all_of(stone, [&](vec2 p) { return area.contains(p); })) return true;
  const Box box = geometry::bounding_box(stone);
  scratch.clear();
  area.near(0.5 * (box.low + box.high), length(box.high - box.low), scratch);
  return std::ranges::any_of(scratch, [&](std::size_t s) {
    const auto& border = area.segments()[s];
    // A corner of the border inside the stone, or a border that crosses its side.
    if (geometry::contains(stone, border.from)) return true;
    for (std::size_t i = 0; i < stone.size(); ++i) {
      if (geometry::segments_cross(to_lattice(stone[i]), to_lattice(stone[(i + 1) % stone.size()]), to_lattice(border.from),
                                   to_lattice(border.to))) {
        return true;
      }
    }
    return false;
  });
}

}  // namespace

LayoutFaults faults(const Pavement& pavement, const StoneLayout& layout) {
  LayoutFaults result;
  const geometry::RegionIndex area(pavement.area);
  const Neighbourhood near(layout, 2.0 * std::max(pavement.stone_mm.x, pavement.stone_mm.y));
  std::vector<std::size_t> scratch;
  for (std::size_t s = 0; s < layout.stones.size(); ++s) {
    const Polygon& stone = layout.stones[s].outline_mm;
    if (!valid(stone)) ++result.invalid;
    if (leaves(stone, area, scratch)) ++result.outside;
    for (const std::size_t t : near.near(s, 0.0)) {
      if (t > s && overlap(stone, layout.stones[t].outline_mm)) ++result.overlaps;
    }
  }
  return result;
}

LayoutQuality quality(const Pavement& pavement, const StoneLayout& layout) {
  const measure::LayoutFigures figures = measure::measured(pavement, layout, layout).figures;
  LayoutQuality result;
  result.stones = figures.stones;
  result.whole = figures.whole;
  result.mean_misalignment_deg = figures.misaligned_mean_deg;
  result.p95_misalignment_deg = figures.misaligned_p95_deg;
  result.four_sided = 0.01 * figures.four_sided_percent;
  result.coverage = 0.01 * figures.covered_percent;
  result.joint_p5 = 0.01 * figures.joint_p5_percent;
  result.joint_p95 = 0.01 * figures.joint_p95_percent;
  // By itself: the figures leave out bonds whose stones differ by design, and are over the face that the bond gives a stone.
  measure::Distribution areas;
  for (const Stone& stone : layout.stones) {
    if (stone.kind == StoneKind::whole)
      areas.add(geometry::area(stone.outline_mm) / (pavement.stone_mm.x * pavement.stone_mm.y));
  }
  result.area_spread = areas.mean() > 0.0 ? areas.deviation() / areas.mean() : 0.0;
  result.mean_area = areas.mean();
  result.smallest = 0.01 * figures.smallest_percent;
  return result;
}

}  // namespace shatterpave::paving
