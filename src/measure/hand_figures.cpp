#include "measure/hand_figures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/functions.h"
#include "core/parallel.h"
#include "measure/distribution.h"
#include "measure/stone_index.h"
#include "paving/tiles/stock.h"

namespace shatterpave::measure {

namespace {

using geometry::Polygon;
using paving::Stone;

// Wider is no joint but the end of what is paved, or a hollow.
constexpr double most_joints = 5.0;
// Of the root of the stone's area: shorter sides are rounded corners.
constexpr double least_side = 0.3;

// From `from` along `out` to the outline, or `most`.
double ray_to(vec2 from, vec2 out, const Polygon& outline, double most) {
  for (std::size_t j = 0; j < outline.size(); ++j) {
    const vec2 e = outline[(j + 1) % outline.size()] - outline[j];
    const double denominator = cross(out, e);
    if (denominator == 0.0) continue;
    const double distance = cross(outline[j] - from, e) / denominator;
    const double place = cross(outline[j] - from, out) / denominator;
    if (distance > 0.0 && place >= 0.0 && place <= 1.0) most = std::min(most, distance);
  }
  return most;
}

std::vector<double> joint_widths(const paving::StoneLayout& lying, const StoneIndex& index, std::size_t s, double widest) {
  const Polygon& stone = lying.stones[s].outline_mm;
  const geometry::Box& box = index.box(s);
  std::vector<std::size_t> near;
  index.near({box.low - vec2{widest, widest}, box.high + vec2{widest, widest}}, near);
  const double least = least_side * std::sqrt(geometry::area(stone));
  std::vector<double> widths;
  for (std::size_t i = 0; i < stone.size(); ++i) {
    const vec2 d = stone[(i + 1) % stone.size()] - stone[i];
    if (glm::length(d) < least) continue;
    const vec2 out = -left_of(d) / glm::length(d);
    for (const double part : {0.2, 0.5, 0.8}) {
      double width = widest;
      for (const std::size_t n : near) {
        if (n != s) width = ray_to(stone[i] + part * d, out, lying.stones[n].outline_mm, width);
      }
      if (width < widest) widths.push_back(width);
    }
  }
  return widths;
}

void add_sizes(const paving::StoneLayout& lying, HandFigures& figures) {
  std::vector<double> lengths;
  std::vector<double> across;
  for (const Stone& stone : lying.stones) {
    if (stone.kind != paving::StoneKind::whole || stone.part != paving::StonePart::field) continue;
    const vec2 size = paving::size_of(paving::extent(stone.outline_mm, stone.angle.direction()));
    lengths.push_back(size.x);
    across.push_back(size.y);
  }
  figures.stones = lengths.size();
  if (lengths.empty()) return;
  Distribution length;
  Distribution width;
  for (const double value : lengths) length.add(value);
  for (const double value : across) width.add(value);
  const double along_part = length.deviation() / length.mean();
  const double across_part = width.deviation() / width.mean();
  figures.side_spread_percent = 100.0 * std::sqrt(0.5 * (along_part * along_part + across_part * across_part));
  std::vector<double> aspects;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double aspect = lengths[i] / length.mean() * width.mean() / across[i];
    aspects.push_back(std::max(aspect, 1.0 / aspect));
  }
  figures.aspect_median = percentile(aspects, 0.5);
  figures.aspect_p90 = percentile(aspects, 0.9);
}

}  // namespace

HandFigures hand_figures(const paving::Pavement& pavement, const paving::StoneLayout& lying) {
  HandFigures figures;
  add_sizes(lying, figures);
  if (pavement.joint_mm == 0.0 || lying.stones.empty()) return figures;
  const double widest = most_joints * pavement.joint_mm;
  const StoneIndex index(lying, std::max(pavement.stone_mm.x, pavement.stone_mm.y) + pavement.joint_mm);
  std::vector<std::vector<double>> of_stone(lying.stones.size());
  parallel_for(lying.stones.size(), [&](std::size_t s) {
    if (lying.stones[s].part == paving::StonePart::field) of_stone[s] = joint_widths(lying, index, s, widest);
  });
  std::vector<double> widths;
  for (const auto& some : of_stone) widths.insert(widths.end(), some.begin(), some.end());
  figures.widths = widths.size();
  if (widths.empty()) return figures;
  Distribution logarithms;
  for (const double width : widths) logarithms.add(logarithm(width));
  figures.joint_ln_spread = logarithms.deviation();
  figures.narrowest_mm = *std::ranges::min_element(widths);
  figures.joint_median_percent = 100.0 * percentile(widths, 0.5) / pavement.joint_mm;
  return figures;
}

}  // namespace shatterpave::measure
