// What growth costs: milliseconds a pane, steps of tips, and nanoseconds a step of a tip.
//
// To hold: one pane of the paper's size, M = 105, in at most 2 ms; and a step of a tip at M = 100,000 in a large pane of many
// impacts at no more than 1.3 times what it costs at M = 100.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/random.h"
#include "geometry/lattice.h"
#include "glass/growth.h"

namespace {

using namespace shatterpave;

glass::Pane square_pane(double side_mm) {
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {side_mm, 0.0}, {side_mm, side_mm}, {0.0, side_mm}};
  return pane;
}

glass::Impact impact_at(vec2 at_mm, int radial_count) {
  glass::Impact impact;
  impact.at_mm = geometry::on_lattice(at_mm);
  impact.radial_count = radial_count;
  return impact;
}

// Every piece of a polyline is a step of its tip, but for the few that other cracks divide by ending on them.
double tip_steps(const glass::CrackNetwork& network) {
  std::size_t pieces = 0;
  for (const glass::Crack& crack : network.cracks) pieces += crack.points_mm.size() - 1;
  return static_cast<double>(pieces);
}

void grow(benchmark::State& state, const glass::Pane& pane) {
  double steps = 0.0;
  std::uint64_t seed = 1;
  for (auto _ : state) {
    const glass::CrackNetwork network = glass::grown_cracks(pane, seed++);
    steps += tip_steps(network);
  }
  state.counters["tip_steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
  state.counters["s_per_step"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// One impact in the middle of the paper's pane.
void one_impact(benchmark::State& state) {
  glass::Pane pane = square_pane(300.0);
  pane.impacts = {impact_at({150.0, 150.0}, static_cast<int>(state.range(0)))};
  grow(state, pane);
}
BENCHMARK(one_impact)->Unit(benchmark::kMillisecond)->Arg(24)->Arg(105)->Arg(1000)->Arg(10000);

// Impacts of 100 radials each, scattered over a pane whose area goes with their number: M = 100 … 100,000 in all. Small panes
// are grown over and over in memory that the process has by then, so large ones get a first round that does not count.
void many_impacts(benchmark::State& state) {
  const auto count = static_cast<std::uint32_t>(state.range(0) / 100);
  const double side_mm = 300.0 * std::sqrt(static_cast<double>(count));
  glass::Pane pane = square_pane(side_mm);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto place = [&](std::string_view axis) { return uniform(1, {Stream::first_direction, Id(axis), i}); };
    pane.impacts.push_back(impact_at(side_mm * (0.05 + 0.9 * vec2{place("x"), place("y")}), 100));
  }
  grow(state, pane);
}
BENCHMARK(many_impacts)->Unit(benchmark::kMillisecond)->MinWarmUpTime(0.1)->RangeMultiplier(10)->Range(100, 100000);

}  // namespace
