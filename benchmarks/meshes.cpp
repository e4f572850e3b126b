// What meshes cost, from a scene to the bytes of its files, and whether twice as many stones take twice as much.
//
// To hold on two cores: 100,000 bricks in running bond as .glb in 3 s and 15 MB; 100,000 setts that all differ, with bodies, in
// 20 s and 2 GiB. The counters: how many bodies, and the size of the file.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "export/gltf/scene_gltf.h"
#include "export/obj/bodies_obj.h"
#include "pipeline/generate.h"
#include "scene/read_scene.h"

namespace {

using namespace shatterpave;
using namespace shatterpave::exporting;

Model model_of(const std::string& toml) { return pipeline::generated(scene::scene_of_text(toml, "bench.toml", {})); }

// Rows of 250 bricks, as many as it takes.
std::string bricks(std::int64_t count) {
  return fmt::format(
      "[[pavement]]\nname = 'court'\nsize_mm = [51000, {}]\nstone_mm = [200, 100]\njoint_mm = 4\nbond = 'running'\n"
      "material = 'brick'\n[pavement.surface]\nfinish = 'flat_sawn'\n",
      count / 250 * 104);
}

// Along circles, so that none is like another.
std::string setts(std::int64_t count) {
  const double side_mm = 108.0 * std::sqrt(static_cast<double>(count));
  return fmt::format(
      "[[pavement]]\nname = 'square'\nsize_mm = [{0:.0f}, {0:.0f}]\n[pavement.surface]\nfinish = 'split'\n"
      "[pavement.direction]\nkind = 'radial'\ncentre_mm = [-5000, -3000]\n",
      side_mm);
}

// About 45 to a square of 100 mm.
std::string dice(std::int64_t count) {
  return fmt::format(
      "[[pane]]\nname = 'door'\nsize_mm = [1000, {:.0f}]\nthickness_mm = 6\nglass = 'tempered'\n"
      "impact = [{{at_mm = [400, 150]}}]\n[pane.shards]\n",
      static_cast<double>(count) / 4.5);
}

std::size_t bodies_of(const Model& model) {
  std::size_t count = 0;
  for (const BrokenPane& pane : model.panes) count += pane.shards.size();
  for (const PavedArea& paved : model.pavements) count += paved.layout.stones.size();
  return count;
}

template <typename Files>
void measure(benchmark::State& state, std::string (*scene)(std::int64_t), const Files& files) {
  for (auto _ : state) {
    const Model model = model_of(scene(state.range(0)));
    const std::vector<OutputFile> made = files(model);
    state.counters["bodies"] = static_cast<double>(bodies_of(model));
    state.counters["megabytes"] = static_cast<double>(made.front().content.size()) / 1e6;
  }
}

void bricks_as_gltf(benchmark::State& state) { measure(state, bricks, gltf::gltf_files); }
void setts_as_gltf(benchmark::State& state) { measure(state, setts, gltf::gltf_files); }
void dice_as_gltf(benchmark::State& state) { measure(state, dice, gltf::gltf_files); }
void setts_as_obj(benchmark::State& state) { measure(state, setts, obj::obj_files); }

BENCHMARK(bricks_as_gltf)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Arg(50'000)->Arg(100'000)->Arg(200'000);
BENCHMARK(setts_as_gltf)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Arg(25'000)->Arg(50'000)->Arg(100'000);
BENCHMARK(dice_as_gltf)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Arg(15'000)->Arg(30'000)->Arg(60'000);
BENCHMARK(setts_as_obj)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Arg(25'000)->Arg(50'000);

}  // namespace

BENCHMARK_MAIN();
