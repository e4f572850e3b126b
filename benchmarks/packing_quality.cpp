// How well stones are packed on every plan of the design along every kind of field: one table, in which a '*' marks what
// misses its target.
//
//    packing_quality [FILE.geojson …] [--only TEXT] [--seed N]
//
// Of each plan given in a file all parts are measured, paved with stones of 300 mm. `--only` leaves out cases without TEXT; the
// seed is 7 unless told.
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "scene/plans/plan_areas.h"

namespace {

using namespace shatterpave;
using namespace shatterpave::paving;

struct Plan {
  std::string name;
  geometry::Region area;
  vec2 stone_mm{100.0, 100.0};
  double joint_mm = 8.0;
  vec2 centre_mm{0.0, 0.0};  // of the radial field
};

vec2 within(const geometry::Box& box, double x, double y) { return box.low + vec2{x, y} * (box.high - box.low); }

std::vector<std::pair<std::string, Direction>> fields(const Plan& plan) {
  const geometry::Box box = geometry::bounding_box(plan.area.outline);
  // Two guides, both of which end within the area.
  const GuidesDirection guides{{{within(box, -0.1, 0.15), within(box, 0.4, 0.3), within(box, 0.65, 0.7)},
                                {within(box, 0.05, 1.1), within(box, 0.3, 0.75)}}};
  return {{"constant", ConstantDirection{Angle::degrees(20.0)}},
          {"boundary", BoundaryDirection{}},
          {"radial", RadialDirection{plan.centre_mm}},
          {"guides", guides}};
}

// The benchmark of the design, a square, and an outline with a hole and a corner inwards; the same with oblong stones.
std::vector<Plan> drawn_plans() {
  std::vector<Plan> plans;
  for (const double pitch : {256.0, 97.0, 29.65}) {
    plans.push_back(
        {fmt::format("annulus, {:.0f} mm", pitch), quarter_annulus(), {0.92 * pitch, 0.92 * pitch}, 0.08 * pitch, {}});
  }
  const geometry::Region square{{{0, 0}, {5000, 0}, {5000, 5000}, {0, 5000}}, {}};
  for (const vec2 stone_mm : {vec2{100, 100}, vec2{140, 90}}) {
    plans.push_back({fmt::format("square, {:.0f} x {:.0f}", stone_mm.x, stone_mm.y), square, stone_mm, 8.0, {2500, -1000}});
    plans.push_back(
        {fmt::format("concave, {:.0f} x {:.0f}", stone_mm.x, stone_mm.y), concave_area(), stone_mm, 8.0, {1700, 2600}});
  }
  return plans;
}

std::vector<Plan> plans_of_file(const std::string& file) {
  std::vector<Plan> plans;
  for (const geometry::Region& area : scene::areas_of_file(file)) {
    const std::string name =
        fmt::format("{:.16}{}", std::filesystem::path(file).stem().string(), plans.empty() ? "" : " (more)");
    plans.push_back({name, area, {300, 300}, 8.0, within(geometry::bounding_box(area.outline), 0.5, -0.2)});
  }
  return plans;
}

// A number that is to be at least, or at most, something.
std::string figure(double value, double scale, int digits, bool meets) {
  return fmt::format("{:>{}.{}f}{}", scale * value, 7, digits, meets ? ' ' : '*');
}

void print_row(const std::string& name, const Pavement& paved, std::uint64_t seed) {
  const StoneLayout layout = laid_stones(paved, seed);
  const std::size_t wrong = faults(paved, layout).total();
  const LayoutQuality q = quality(paved, layout);
  std::string row =
      fmt::format("{:<34}{:>7}{:>6.1f}%", name, q.stones, 100.0 * static_cast<double>(q.whole) / static_cast<double>(q.stones));
  row += figure(q.mean_misalignment_deg, 1.0, 2, q.mean_misalignment_deg <= 1.5);
  row += figure(q.p95_misalignment_deg, 1.0, 2, q.p95_misalignment_deg <= 5.0);
  row += figure(q.four_sided, 100.0, 1, q.four_sided >= 0.98);
  row += figure(static_cast<double>(wrong), 1.0, 0, wrong == 0);
  row += figure(q.coverage, 100.0, 2, q.coverage >= 0.995);
  row += figure(q.joint_p5, 100.0, 1, q.joint_p5 >= 0.9);
  row += figure(q.joint_p95, 100.0, 1, q.joint_p95 <= 1.1);
  row += figure(q.area_spread, 100.0, 1, q.area_spread <= 0.08);
  row += figure(q.smallest, 100.0, 0, q.smallest >= 0.25);
  fmt::print("{}\n", row);
  std::fflush(stdout);
}

int print_table(std::span<char*> arguments) {
  std::vector<Plan> plans = drawn_plans();
  std::string only;
  std::uint64_t seed = 7;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (std::string_view(arguments[i]) == "--only" && i + 1 < arguments.size()) {
      only = arguments[++i];
      continue;
    }
    if (std::string_view(arguments[i]) == "--seed" && i + 1 < arguments.size()) {
      seed = std::stoull(arguments[++i]);
      continue;
    }
    for (Plan& plan : plans_of_file(arguments[i])) plans.push_back(std::move(plan));
  }
  fmt::print("{:<34}{:>7}{:>7}{:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}\n", "plan, field", "stones", "whole",
             "mean °", "p95 °", "4-sided", "faults", "cover", "joint 5", "95 %", "spread", "least");
  for (const Plan& plan : plans) {
    for (const auto& [field, direction] : fields(plan)) {
      const std::string name = plan.name + ", " + field;
      if (name.find(only) == std::string::npos) continue;
      Pavement paved = pavement(plan.area, plan.stone_mm.x, plan.joint_mm, direction);
      paved.stone_mm = plan.stone_mm;
      print_row(name, paved, seed);
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return print_table(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
  } catch (const std::exception& error) {
    fmt::print(stderr, "packing_quality: {}\n", error.what());
    return 1;
  }
}
