// What growth costs: milliseconds a pane, steps of tips, and seconds a step of a tip.
//
// To hold: one pane of the paper's size, M = 105, in at most 2 ms; and a step of a tip at M = 100,000 in a large pane of many
// impacts at no more than 1.3 times what it costs at M = 100.
//
// Memory that a process touches for the first time costs it a page fault for every 4 KiB, some microseconds each, a good part
// of all that a pane takes. Left to itself, the C library keeps the memory of small panes from one round to the next, but gives
// that of large ones back, so that only the latter would pay. So both cases are measured, each alike for all sizes: in kept
// memory, as in a process that grows pane after pane, and in fresh memory, as in one that grows a single pane.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <cmath>
#include <limits>

#include "core/random.h"
#include "geometry/lattice.h"
#include "glass/breaking.h"

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

enum class Memory { kept, fresh };

void grow(benchmark::State& state, const glass::Pane& pane, Memory memory) {
  double steps = 0.0;
  std::uint64_t seed = 1;
  if (memory == Memory::kept) benchmark::DoNotOptimize(glass::broken(pane, seed));
  for (auto _ : state) {
    if (memory == Memory::fresh) {
      state.PauseTiming();
      malloc_trim(0);
      state.ResumeTiming();
    }
    const glass::CrackNetwork network = glass::broken(pane, seed++);
    steps += tip_steps(network);
  }
  state.counters["tip_steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
  state.counters["s_per_step"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// One impact in the middle of the paper's pane.
void one_impact(benchmark::State& state) {
  glass::Pane pane = square_pane(300.0);
  pane.impacts = {impact_at({150.0, 150.0}, static_cast<int>(state.range(0)))};
  grow(state, pane, Memory::kept);
}
BENCHMARK(one_impact)->Unit(benchmark::kMillisecond)->Arg(24)->Arg(105)->Arg(1000)->Arg(10000);

// Impacts of 100 radials each, scattered over a pane whose area goes with their number: M = 100 … 100,000 in all.
void many_impacts(benchmark::State& state, Memory memory) {
  const auto count = static_cast<std::uint32_t>(state.range(0) / 100);
  const double side_mm = 300.0 * std::sqrt(static_cast<double>(count));
  glass::Pane pane = square_pane(side_mm);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto place = [&](std::string_view axis) { return uniform(1, {Stream::first_direction, Id(axis), i}); };
    pane.impacts.push_back(impact_at(side_mm * (0.05 + 0.9 * vec2{place("x"), place("y")}), 100));
  }
  grow(state, pane, memory);
}
BENCHMARK_CAPTURE(many_impacts, kept_memory, Memory::kept)
    ->Unit(benchmark::kMillisecond)
    ->RangeMultiplier(10)
    ->Range(100, 100000);
BENCHMARK_CAPTURE(many_impacts, fresh_memory, Memory::fresh)
    ->Unit(benchmark::kMillisecond)
    ->RangeMultiplier(10)
    ->Range(100, 100000);

}  // namespace

int main(int argc, char** argv) {
  // The process gives nothing back but by malloc_trim, whatever the size of a pane.
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_MMAP_MAX, 0);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
