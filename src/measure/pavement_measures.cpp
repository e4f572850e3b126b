#include "measure/pavement_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/parallel.h"
#include "geometry/lattice.h"
#include "measure/bare_spot.h"
#include "measure/coverage.h"
#include "measure/distribution.h"
#include "measure/stone_index.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "paving/field/direction_field.h"
#include "paving/field/size_field.h"
#include "paving/packing/packing.h"
#include "paving/packing/particle_cells.h"

namespace shatterpave::measure {

namespace {

using geometry::Polygon;
using paving::Pavement;
using paving::Stone;
using paving::StoneKind;
using paving::StoneLayout;

// Joints wider than this many of the asked ones are no joints, but the ends of the paved area.
constexpr double widest_joint = 3.0;
// Where along a side its joint is measured: beside the middle, where a perpend of the next row may be.
constexpr double joint_at = 0.4;

bool is_packed(const Pavement& pavement) { return paving::type_of(pavement).bending == paving::Bending::packed; }

struct Weighted {
  double value = 0.0;
  double weight = 0.0;

  auto operator<=>(const Weighted&) const = default;
};

double weighted_mean(const std::vector<Weighted>& values) {
  double sum = 0.0;
  double weight = 0.0;
  for (const Weighted& v : values) {
    sum += v.value * v.weight;
    weight += v.weight;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

// The least value below which `share` of all weight lies.
double weighted_percentile(std::vector<Weighted> values, double share) {
  std::ranges::sort(values);
  const double total =
      std::accumulate(values.begin(), values.end(), 0.0, [](double t, const Weighted& v) { return t + v.weight; });
  double sum = 0.0;
  for (const Weighted& v : values) {
    sum += v.weight;
    if (sum >= share * total) return v.value;
  }
  return 0.0;
}

// Least angle between a side and an axis, or the line across it.
double misaligned_deg(vec2 side, vec2 axis) {
  const double along = std::abs(glm::dot(side, axis));
  const double across = std::abs(cross(side, axis));
  return Angle::of({std::max(along, across), std::min(along, across)}).degrees();
}

// What is measured of a stone besides StoneMeasures.
struct StoneSamples {
  std::vector<Weighted> sides;  // misalignment, degrees, by length
  std::vector<double> joints;   // over the asked width
};

class StoneMeter {
 public:
  StoneMeter(const Pavement& pavement, const StoneLayout& layout, const StoneIndex& index, const geometry::RegionIndex& area,
             const paving::DirectionField& field, const paving::SizeField& sizes)
      : pavement_(pavement), layout_(layout), index_(index), area_(area), field_(field), sizes_(sizes) {
    pattern_axis_ = (paving::main_direction(pavement) + pavement.bonding.turn).direction();
    border_mm_ = paving::border_stone_mm(pavement);
    stock_ = stock_limit(pavement);
    border_stock_ = border_stock_limit(pavement);
  }

  const StockLimit& stock_of(const StoneMeasures& stone) const { return stone.in_border_course ? border_stock_ : stock_; }

  StoneMeasures measures(std::size_t s, StoneSamples& samples) const {
    const Stone& stone = layout_.stones[s];
    StoneMeasures result;
    result.id = stone.id;
    result.kind = stone.kind;
    result.middle_mm = geometry::on_lattice(geometry::centroid(stone.outline_mm));
    result.in_border_course = stone.part == paving::StonePart::border;
    result.corners = stone.outline_mm.size();
    const double size = sizes_.at(result.middle_mm);
    const double asked =
        result.in_border_course ? border_mm_.x * border_mm_.y : size * size * paving::whole_face_mm2(pavement_);
    result.area_ratio = geometry::area(stone.outline_mm) / asked;
    result.stock = stock_share(stone.outline_mm, stock_of(result));
    if (stone.kind != StoneKind::whole) return result;
    if (result.in_border_course || paving::type_of(pavement_).has_square_stones) {
      add_sides(stone, result.in_border_course, samples.sides);
      result.misaligned_deg = weighted_mean(samples.sides);
    }
    if (pavement_.joint_mm > 0.0) add_joints(s, samples.joints);
    for (const double joint : samples.joints) result.joint_ratio.add(joint);
    return result;
  }

 private:
  // The axis that the bond asks of the stone at `place`.
  vec2 asked_axis(const Stone& stone, bool in_border_course, vec2 place) const {
    if (in_border_course) return stone.angle.direction();
    if (is_packed(pavement_)) return field_.axis(place);
    if (!paving::is_bent(pavement_)) return pattern_axis_;
    const bool circles = std::holds_alternative<paving::RadialDirection>(pavement_.direction);
    return circles ? field_.axis(place) : stone.angle.direction();
  }

  void add_sides(const Stone& stone, bool in_border_course, std::vector<Weighted>& sides) const {
    const Polygon& outline = stone.outline_mm;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const vec2 d = outline[(i + 1) % outline.size()] - outline[i];
      sides.push_back({misaligned_deg(d, asked_axis(stone, in_border_course, outline[i] + 0.5 * d)), glm::length(d)});
    }
  }

  void add_joints(std::size_t s, std::vector<double>& widths) const {
    const Polygon& stone = layout_.stones[s].outline_mm;
    const double widest = widest_joint * pavement_.joint_mm;
    const geometry::Box& box = index_.box(s);
    std::vector<std::size_t> near;
    index_.near({box.low - vec2{widest, widest}, box.high + vec2{widest, widest}}, near);
    for (std::size_t i = 0; i < stone.size(); ++i) {
      const vec2 d = stone[(i + 1) % stone.size()] - stone[i];
      const vec2 from = stone[i] + joint_at * d;
      const vec2 out = -left_of(d) / glm::length(d);
      double width = widest;
      for (const std::size_t n : near) {
        if (n != s) width = std::min(width, distance_along(from, out, layout_.stones[n].outline_mm, width));
      }
      if (width < widest) widths.push_back(width / pavement_.joint_mm);
    }
  }

  // To the nearest side that the ray meets, or `most`.
  static double distance_along(vec2 from, vec2 out, const Polygon& outline, double most) {
    for (std::size_t j = 0; j < outline.size(); ++j) {
      const vec2 e = outline[(j + 1) % outline.size()] - outline[j];
      const double denominator = cross(out, e);
      if (denominator == 0.0) continue;
      const double distance = cross(outline[j] - from, e) / denominator;
      const double along = cross(outline[j] - from, out) / denominator;
      if (distance > 0.0 && along >= 0.0 && along <= 1.0) most = std::min(most, distance);
    }
    return most;
  }

  const Pavement& pavement_;
  const StoneLayout& layout_;
  const StoneIndex& index_;
  const geometry::RegionIndex& area_;
  const paving::DirectionField& field_;
  const paving::SizeField& sizes_;
  vec2 pattern_axis_{1.0, 0.0};
  StockLimit stock_;
  StockLimit border_stock_;
  vec2 border_mm_{0.0, 0.0};
};

// Moves particles that are in one place apart, by 1 µm each: stones that overlap may have one middle.
void part(std::vector<paving::Particle>& particles) {
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t i) { return geometry::to_lattice(particles[i].at); };
  std::ranges::sort(order, [&](std::size_t i, std::size_t k) { return std::pair(place(i), i) < std::pair(place(k), k); });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const geometry::LatticePoint before = place(order[i - 1]);
    geometry::LatticePoint here = place(order[i]);
    if (here > before) continue;
    here.y = before.y + 1;
    particles[order[i]].at = geometry::to_mm(here);
  }
}

// The neighbourhood of the stones of a packing, from their middles, as regions are made from particles (paving/tiles/cells.h).
paving::Cells neighbourhood(const Pavement& pavement, const std::vector<StoneMeasures>& stones,
                            const paving::DirectionField& field, const paving::SizeField& sizes) {
  std::vector<paving::Particle> particles(stones.size());
  parallel_for_chunks(stones.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const vec2 at = stones[s].middle_mm;
      particles[s] = {at, field.axis(at), sizes.at(at)};
    }
  });
  part(particles);
  return paving::cells_of(particles, pavement);
}

// Marks the irregular stones. Those that have a cut stone or the border beside them are not looked at.
void mark_irregular(const Pavement& pavement, const paving::Cells& cells, const paving::SizeField& sizes,
                    const geometry::RegionIndex& area, LayoutMeasures& measures) {
  std::vector<StoneMeasures>& stones = measures.stones;
  const vec2 pitch = paving::pitch_mm(pavement);
  const auto beside_border_mm = [&](std::size_t s) { return sizes.at(stones[s].middle_mm) * std::max(pitch.x, pitch.y); };
  const auto is_inner = [&](std::size_t s) { return stones[s].kind == StoneKind::whole && !stones[s].in_border_course; };
  for (std::size_t s = 0; s < stones.size(); ++s) {
    const auto beside = cells.neighbours(s);
    // The first row has no neighbours towards the border.
    if (!is_inner(s) || beside.empty() || area.border_within(stones[s].middle_mm, beside_border_mm(s))) continue;
    stones[s].neighbours = static_cast<int>(beside.size());
    if (!std::ranges::all_of(beside, is_inner)) continue;
    ++measures.figures.counted_stones;
    stones[s].irregular = beside.size() != 4;
    if (stones[s].irregular) ++measures.figures.irregular_stones;
  }
}

// Of the irregular stones, those side by side are one.
std::size_t irregular_spots(const paving::Cells& cells, const std::vector<StoneMeasures>& stones) {
  DisjointSets spots(stones.size());
  for (std::size_t s = 0; s < stones.size(); ++s) {
    if (!stones[s].irregular) continue;
    for (const std::uint32_t n : cells.neighbours(s)) {
      if (stones[n].irregular) spots.join(s, n);
    }
  }
  std::size_t count = 0;
  for (std::size_t s = 0; s < stones.size(); ++s) {
    if (stones[s].irregular && spots.of(s) == s) ++count;
  }
  return count;
}

void count_irregular(const Pavement& pavement, const paving::DirectionField& field, const paving::SizeField& sizes,
                     const geometry::RegionIndex& area, LayoutMeasures& measures) {
  const paving::Cells cells = neighbourhood(pavement, measures.stones, field, sizes);
  mark_irregular(pavement, cells, sizes, area, measures);
  measures.figures.irregular_spots = irregular_spots(cells, measures.stones);
}

// Those that are looked at for regularity, or would be but for a cut stone beside them.
std::vector<InnerCell> inner_cells(const StoneLayout& layout, const std::vector<StoneMeasures>& stones) {
  std::vector<InnerCell> cells;
  for (std::size_t s = 0; s < stones.size(); ++s) {
    if (stones[s].neighbours) cells.push_back({&layout.stones[s].outline_mm, *stones[s].neighbours});
  }
  return cells;
}

void sum_up(const Pavement& pavement, const std::vector<StoneSamples>& samples, LayoutMeasures& measures) {
  LayoutFigures& figures = measures.figures;
  std::vector<Weighted> sides;
  std::vector<double> joints;
  Distribution areas;
  std::size_t four_sided = 0;
  const bool has_one_size = paving::type_of(pavement).has_stones_of_a_size;
  double smallest = measures.stones.empty() ? 0.0 : measures.stones.front().area_ratio;
  for (std::size_t s = 0; s < measures.stones.size(); ++s) {
    const StoneMeasures& stone = measures.stones[s];
    smallest = std::min(smallest, stone.area_ratio);
    if (stone.kind != StoneKind::whole) continue;
    ++figures.whole;
    if (stone.misaligned_deg) {
      ++figures.shaped;
      if (stone.corners == 4) ++four_sided;
    }
    sides.insert(sides.end(), samples[s].sides.begin(), samples[s].sides.end());
    if (stone.irregular) {
      figures.excepted_joints += samples[s].joints.size();
    } else {
      joints.insert(joints.end(), samples[s].joints.begin(), samples[s].joints.end());
    }
    if (stone.in_border_course || !has_one_size) continue;
    areas.add(stone.area_ratio);
    measures.areas_percent.add(100.0 * stone.area_ratio);
  }
  for (const Weighted& side : sides) measures.misaligned_deg.add(side.value);
  for (const double joint : joints) measures.joints_percent.add(100.0 * joint);
  figures.sides = sides.size();
  figures.misaligned_mean_deg = weighted_mean(sides);
  figures.misaligned_p95_deg = weighted_percentile(std::move(sides), 0.95);
  figures.four_sided_percent = percentage(four_sided, figures.shaped);
  figures.joints = joints.size();
  figures.joint_p5_percent = 100.0 * percentile(joints, 0.05);
  figures.joint_median_percent = 100.0 * percentile(joints, 0.5);
  figures.joint_p95_percent = 100.0 * percentile(joints, 0.95);
  figures.sized = areas.count();
  figures.area_mean_percent = 100.0 * areas.mean();
  figures.area_spread_percent = areas.mean() > 0.0 ? 100.0 * areas.deviation() / areas.mean() : 0.0;
  figures.smallest_percent = 100.0 * smallest;
}

// The largest stones beside their stock.
void note_largest(const StoneMeter& meter, LayoutMeasures& measures) {
  LayoutFigures& f = measures.figures;
  const auto raise = [](double& percent, double share) { percent = std::max(percent, 100.0 * share); };
  for (const StoneMeasures& stone : measures.stones) {
    raise(f.largest_length_percent, stone.stock.length);
    raise(f.largest_width_percent, stone.stock.width);
    raise(f.largest_area_percent, stone.stock.area);
    const std::optional<double> most = meter.stock_of(stone).most;
    if (!most) continue;
    ++f.limited;
    raise(f.largest_limited_percent, std::max({stone.stock.length, stone.stock.width, stone.stock.area}) / *most);
  }
}

// Both layouts are in the order of ids.
void note_missing(const StoneLayout& lying, LayoutMeasures& measures) {
  auto next = lying.stones.begin();
  for (StoneMeasures& stone : measures.stones) {
    while (next != lying.stones.end() && next->id < stone.id) ++next;
    stone.missing = next == lying.stones.end() || next->id != stone.id;
    if (stone.missing) ++measures.figures.missing;
  }
}

double index_square_mm(const Pavement& pavement) {
  return std::max(pavement.stone_mm.x, pavement.stone_mm.y) + pavement.joint_mm;
}

}  // namespace

LayoutMeasures measured(const Pavement& pavement, const StoneLayout& set_out, const StoneLayout& lying) {
  LayoutMeasures measures;
  const geometry::RegionIndex area(pavement.area);
  const paving::DirectionField field(pavement, area);
  const paving::SizeField sizes(pavement, area);
  const StoneIndex index(set_out, index_square_mm(pavement));
  LayoutFigures& figures = measures.figures;
  figures.stones = set_out.stones.size();
  figures.faults = &lying == &set_out ? layout_faults(set_out, index, area)
                                      : layout_faults(lying, StoneIndex(lying, index_square_mm(pavement)), area);

  const StoneMeter meter(pavement, set_out, index, area, field, sizes);
  std::vector<StoneSamples> samples(set_out.stones.size());
  measures.stones.resize(set_out.stones.size());
  parallel_for_chunks(set_out.stones.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) measures.stones[s] = meter.measures(s, samples[s]);
  });
  if (is_packed(pavement)) {
    figures.field = field_defects(pavement, field, sizes, area);
    count_irregular(pavement, field, sizes, area, measures);
    figures.cells = cell_figures(inner_cells(set_out, measures.stones), field);
  }
  sum_up(pavement, samples, measures);
  note_largest(meter, measures);
  const geometry::Circle spot = widest_bare_spot(pavement, set_out, index, area);
  figures.bare_spot_mm = 2.0 * spot.radius;
  measures.bare_spot_mm = spot.middle;
  Coverage coverage = coverage_of(pavement, set_out, index, area);
  figures.covered_percent = 100.0 * coverage.share;
  figures.holes = coverage.holes.size();
  measures.holes_mm = std::move(coverage.holes);
  if (pavement.hand.amount > 0.0) {
    // Set out by hand there are other stones than by the line, with ids of their own.
    figures.missing = lying.missing.size();
    figures.hand = hand_figures(pavement, lying);
  } else {
    note_missing(lying, measures);
  }
  return measures;
}

}  // namespace shatterpave::measure
