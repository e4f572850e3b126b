#include "paving/layout_quality.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/clip.h"
#include "geometry/predicates.h"
#include "geometry/region_index.h"
#include "paving/direction_field.h"

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

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Percentiles of values with weights.
double percentile(std::vector<std::pair<double, double>> values, double share) {
  std::ranges::sort(values);
  double total = 0.0;
  for (const auto& v : values) total += v.second;
  double sum = 0.0;
  for (const auto& v : values) {
    sum += v.second;
    if (sum >= share * total) return v.first;
  }
  return 0.0;
}

// Least angle between a side and the rows or columns, in degrees.
double misalignment_deg(vec2 side, vec2 axis) {
  const double along = std::abs(glm::dot(side, axis));
  const double across = std::abs(cross(side, axis));
  return Angle::of({std::max(along, across), std::min(along, across)}).degrees();
}

void measure_sides(const Stone& stone, const DirectionField& field, std::vector<std::pair<double, double>>& sides) {
  for (std::size_t i = 0; i < stone.outline_mm.size(); ++i) {
    const vec2 a = stone.outline_mm[i];
    const vec2 d = stone.outline_mm[(i + 1) % stone.outline_mm.size()] - a;
    sides.emplace_back(misalignment_deg(d, field.axis(a + 0.5 * d)), length(d));
  }
}

// From the middle of each side of the stone straight out to the neighbour, if there is one within three joints.
void measure_joints(const StoneLayout& layout, std::size_t s, const Neighbourhood& near, double joint_mm,
                    std::vector<double>& widths) {
  const Polygon& stone = layout.stones[s].outline_mm;
  const auto neighbours = near.near(s, 3.0 * joint_mm);
  for (std::size_t i = 0; i < stone.size(); ++i) {
    const vec2 d = stone[(i + 1) % stone.size()] - stone[i];
    const vec2 out = -left_of(d) / length(d);
    const vec2 middle = stone[i] + 0.4 * d;  // not just where a cross joint may be
    double width = 3.0 * joint_mm;
    for (const std::size_t n : neighbours) {
      const Polygon& other = layout.stones[n].outline_mm;
      for (std::size_t j = 0; j < other.size(); ++j) {
        const vec2 e = other[(j + 1) % other.size()] - other[j];
        const double denominator = cross(out, e);
        if (denominator == 0.0) continue;
        const double t = cross(other[j] - middle, e) / denominator;
        const double along = cross(other[j] - middle, out) / denominator;
        if (t > 0.0 && along >= 0.0 && along <= 1.0) width = std::min(width, t);
      }
    }
    if (width < 3.0 * joint_mm) widths.push_back(width / joint_mm);
  }
}

double coverage(const Pavement& pavement, const StoneLayout& layout) {
  double covered = 0.0;
  for (const Stone& stone : layout.stones) {
    for (const auto& grown : geometry::offset({stone.outline_mm, {}}, 0.5 * pavement.joint_mm)) {
      for (const auto& part : geometry::intersection(grown.outline, pavement.area)) covered += geometry::area(part);
    }
  }
  return covered / geometry::area(pavement.area);
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
  LayoutQuality result;
  const geometry::RegionIndex area(pavement.area);
  const DirectionField field(pavement, area);
  const Neighbourhood near(layout, 2.0 * std::max(pavement.stone_mm.x, pavement.stone_mm.y));
  const double stone_area = pavement.stone_mm.x * pavement.stone_mm.y;
  std::vector<std::pair<double, double>> sides;
  std::vector<double> joints;
  double sum = 0.0;
  double squares = 0.0;
  std::size_t four = 0;
  result.smallest = 1e9;
  for (std::size_t s = 0; s < layout.stones.size(); ++s) {
    const Stone& stone = layout.stones[s];
    const double share = geometry::area(stone.outline_mm) / stone_area;
    result.smallest = std::min(result.smallest, share);
    if (stone.kind != StoneKind::whole) continue;
    ++result.whole;
    four += stone.outline_mm.size() == 4 ? 1U : 0U;
    sum += share;
    squares += share * share;
    measure_sides(stone, field, sides);
    if (pavement.joint_mm > 0.0) measure_joints(layout, s, near, pavement.joint_mm, joints);
  }
  result.stones = layout.stones.size();
  if (result.whole == 0) return result;
  const auto whole = static_cast<double>(result.whole);
  double weighted = 0.0;
  double weight = 0.0;
  for (const auto& [degrees, mm] : sides) {
    weighted += degrees * mm;
    weight += mm;
  }
  result.mean_misalignment_deg = weighted / weight;
  result.p95_misalignment_deg = percentile(sides, 0.95);
  result.four_sided = static_cast<double>(four) / whole;
  result.coverage = coverage(pavement, layout);
  result.joint_p5 = percentile(joints, 0.05);
  result.joint_p95 = percentile(joints, 0.95);
  result.mean_area = sum / whole;
  result.area_spread = std::sqrt(std::max(0.0, squares / whole - result.mean_area * result.mean_area)) / result.mean_area;
  return result;
}

}  // namespace shatterpave::paving
