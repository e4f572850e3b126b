// What texture sets cost: the paper's example, packing and all maps at 512 × 512; and megapixels a second at large sizes,
// beside OpenImageIO's own noise fill of as many pixels with as many channels.
//
// To hold: the paper's example, files and all, in less than 0.4 s (Miyata and Itoh: 13 s on a Pentium II of 300 MHz).
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "export/textures/maps.h"
#include "export/textures/occlusion.h"
#include "export/textures/textures.h"
#include "paving/laying.h"
#include "pipeline/write.h"

namespace {

using namespace shatterpave;
using namespace shatterpave::exporting;

// Rows on circles, as in the paper's pictures, some 19 stones on a side.
paving::Pavement plaza() {
  paving::Pavement pavement;
  pavement.name = "plaza";
  pavement.area.outline = {{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 2000.0}, {0.0, 2000.0}};
  pavement.direction = paving::RadialDirection{{-800.0, -600.0}};
  return pavement;
}

// All values of all maps: 1 + 1 + 1 of one channel, 3 of three.
constexpr int all_channels = 12;

void set_rate(benchmark::State& state, std::size_t side) {
  const double pixels = static_cast<double>(side * side) * static_cast<double>(state.iterations());
  state.counters["megapixels_per_s"] = benchmark::Counter(pixels / 1e6, benchmark::Counter::kIsRate);
}

// From nothing to files.
void paper_example(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / ("textures-benchmark-" + std::to_string(::getpid()));
  for (auto _ : state) {
    Model model;
    model.name = "s";
    model.seed = 7;
    paving::Pavement pavement = plaza();
    pavement.textures.size_px = static_cast<std::size_t>(state.range(0));
    paving::StoneLayout layout = paving::laid_stones(pavement, model.seed);
    model.pavements.push_back({std::move(pavement), std::move(layout)});
    pipeline::written_outputs({{}, textures::texture_files(model)}, {"s", "export", ""}, folder);
  }
  std::filesystem::remove_all(folder);
  set_rate(state, static_cast<std::size_t>(state.range(0)));
}
BENCHMARK(paper_example)->Unit(benchmark::kMillisecond)->UseRealTime()->Arg(512)->Arg(2048)->Arg(8192);

// All maps in memory, band by band, without files.
void all_maps_without_files(benchmark::State& state) {
  const auto side = static_cast<std::size_t>(state.range(0));
  const paving::Pavement pavement = plaza();
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const double pixel = 2000.0 / static_cast<double>(side);
  const textures::PixelGrid grid{{0.0, 0.0}, {pixel, pixel}, side, side};
  for (auto _ : state) {
    const textures::Fields fields = textures::fields_of(pavement, 7);
    const textures::Surface surface{pavement, stones, fields, 7, false};
    const textures::SurfaceMap map =
        surface_map(surface, grid, textures::occlusion_reach(pavement, grid), textures::samples_for(pavement, grid));
    const textures::Maps maps(surface, map);
    parallel_for_chunks(side, 16, [&](std::size_t begin, std::size_t end) {
      std::vector<float> row(3 * side);
      for (const textures::Map which : textures::all_maps) {
        for (std::size_t y = begin; y < end; ++y) {
          maps.row(which, y, std::span<float>(row).first(side * textures::channels(which)));
          benchmark::DoNotOptimize(row.data());
        }
      }
    });
  }
  set_rate(state, side);
}
BENCHMARK(all_maps_without_files)->Unit(benchmark::kMillisecond)->UseRealTime()->Arg(512)->Arg(2048)->Arg(8192);

// The peer: gaussian noise into each channel of as many pixels, which knows nothing of stones. Three channels at a time, so
// that memory is that of one map.
void openimageio_noise(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  OIIO::ImageBuf image(OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::FLOAT));
  for (auto _ : state) {
    for (int done = 0; done < all_channels; done += 3) OIIO::ImageBufAlgo::noise(image, "gaussian", 0.0F, 0.1F, false, done);
  }
  set_rate(state, static_cast<std::size_t>(side));
}
BENCHMARK(openimageio_noise)->Unit(benchmark::kMillisecond)->UseRealTime()->Arg(512)->Arg(2048)->Arg(8192);

}  // namespace

BENCHMARK_MAIN();
