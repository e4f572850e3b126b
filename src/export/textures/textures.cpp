#include "export/textures/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/functions.h"
#include "core/parallel.h"
#include "export/textures/maps.h"
#include "export/textures/occlusion.h"
#include "relief/raster_file.h"

namespace shatterpave::exporting::textures {

namespace {

using paving::TextureFormat;
using relief::RasterFileFormat;

constexpr std::size_t drawn_rows = 64;

// The curve of sRGB (IEC 61966-2-1) over 0 … 1, as a table with straight lines between: off by less than a tenth of a step of 8
// bits.
class SrgbCurve {
 public:
  SrgbCurve() {
    for (std::size_t k = 0; k <= steps; ++k) {
      const double linear = static_cast<double>(k) / steps;
      table_[k] = static_cast<float>(linear <= 0.0031308 ? 12.92 * linear : 1.055 * power(linear, 1.0 / 2.4) - 0.055);
    }
    table_[steps + 1] = table_[steps];
  }

  float operator()(float linear) const {
    const float at = std::clamp(linear, 0.0F, 1.0F) * static_cast<float>(steps);
    const auto k = static_cast<std::size_t>(at);
    return table_[k] + (at - static_cast<float>(k)) * (table_[k + 1] - table_[k]);
  }

 private:
  static constexpr std::size_t steps = 4096;
  std::array<float, steps + 2> table_{};
};

RasterFileFormat file_format(Map map, TextureFormat format) {
  if (format == TextureFormat::png) {
    return map == Map::height || map == Map::normal ? RasterFileFormat::png16 : RasterFileFormat::png8;
  }
  return map == Map::height || map == Map::stone_id ? RasterFileFormat::exr_float : RasterFileFormat::exr_half;
}

std::string file_name(const std::string& pavement, Map map, TextureFormat format) {
  return fmt::format("{}_{}.{}", pavement, name_of(map), format == TextureFormat::png ? "png" : "exr");
}

// Writes one map of `maps` to `path`.
void write_map(const Maps& maps, const PixelGrid& grid, Map map, TextureFormat format, const std::string& path) {
  const bool png = format == TextureFormat::png;
  const bool plain_id = map == Map::stone_id && !png;
  const relief::RasterFileShape shape{grid.width, grid.height, plain_id ? 1 : channels(map)};
  const RasterFileFormat written = file_format(map, format);
  const auto smaller = map == Map::stone_id ? relief::Smaller::first : relief::Smaller::mean;
  const auto file = format == TextureFormat::tiled_exr ? std::make_unique<relief::RasterFile>(path, shape, written, smaller)
                                                       : std::make_unique<relief::RasterFile>(path, shape, written);
  static const SrgbCurve srgb;
  const std::size_t length = shape.width * shape.channels;
  std::vector<float> rows;
  for (std::size_t begin = 0; begin < grid.height; begin += drawn_rows) {
    const std::size_t count = std::min(drawn_rows, grid.height - begin);
    rows.resize(count * length);
    parallel_for(count, [&](std::size_t k) {
      const std::span<float> row(&rows[k * length], length);
      if (plain_id) {
        maps.id_row(begin + k, row);
        return;
      }
      maps.row(map, begin + k, row);
      if (map == Map::base_color && png) std::ranges::transform(row, row.begin(), srgb);
    });
    file->append(rows);
  }
  file->close();
}

// What the files do not say themselves.
std::string description(const Surface& surface, const PixelGrid& grid, const HeightRange& heights, TextureFormat format) {
  const std::string& name = surface.pavement.name;
  const vec2 size_mm = grid.size_mm();
  nlohmann::ordered_json json = {{"format", "shatterpave-textures"},
                                 {"version", 1},
                                 {"name", name},
                                 {"seed", surface.seed},
                                 {"size_px", {grid.width, grid.height}},
                                 {"low_mm", {grid.low_mm.x, grid.low_mm.y}},
                                 {"size_mm", {size_mm.x, size_mm.y}},
                                 {"seamless", surface.periodic},
                                 {"height_low_mm", heights.low_mm},
                                 {"height_range_mm", heights.range_mm},
                                 {"normal", "OpenGL"},
                                 {"base_color", format == TextureFormat::png ? "sRGB" : "linear"}};
  for (const Map map : all_maps) json["maps"][std::string(name_of(map))] = file_name(name, map, format);
  return json.dump(1) + "\n";
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

// Over a tile, which they fill exactly.
PixelGrid tile_grid(vec2 size_mm, std::size_t size_px) {
  const double pixel = std::max(size_mm.x, size_mm.y) / static_cast<double>(size_px);
  const vec2 count = glm::max(vec2{1.0, 1.0}, glm::round(size_mm / pixel));
  return {{0.0, 0.0}, size_mm / count, static_cast<std::size_t>(count.x), static_cast<std::size_t>(count.y)};
}

// Square pixels over the window, which grows in its shorter side by less than a pixel.
PixelGrid pixel_grid(const paving::Pavement& pavement) {
  const geometry::Box box = pavement.textures.area.value_or(geometry::bounding_box(pavement.area.outline));
  const vec2 size = box.high - box.low;
  const double pixel = std::max(size.x, size.y) / static_cast<double>(pavement.textures.size_px);
  // A last pixel of which less than a thousandth is wanted is rounding.
  const auto count = [&](double mm) { return static_cast<std::size_t>(std::max(1.0, std::ceil(mm / pixel - 1e-3))); };
  return {box.low, {pixel, pixel}, count(size.x), count(size.y)};
}

void write_set(const Surface& surface, const PixelGrid& grid, const std::string& folder) {
  const paving::Pavement& pavement = surface.pavement;
  const TextureFormat format = pavement.textures.format;
  const SurfaceMap map = surface_map(surface, grid, occlusion_reach(pavement, grid), samples_for(pavement, grid));
  const Maps maps(surface, map);
  const auto path = [&](const std::string& name) { return folder + "/" + name; };
  const auto write = [&](std::size_t k) {
    write_map(maps, grid, all_maps.at(k), format, path(file_name(pavement.name, all_maps.at(k), format)));
  };
  if (format == TextureFormat::tiled_exr) {
    // One after the other, for the smaller sizes that each keeps in memory.
    for (std::size_t k = 0; k < all_maps.size(); ++k) write(k);
  } else {
    parallel_for(all_maps.size(), write);
  }
  write_text(path(pavement.name + "_textures.json"), description(surface, grid, maps.height_range(), format));
}

FileSet texture_set(const PavedArea& paved, std::uint64_t seed) {
  FileSet set;
  for (const Map map : all_maps) set.names.push_back(file_name(paved.pavement.name, map, paved.pavement.textures.format));
  set.names.push_back(paved.pavement.name + "_textures.json");
  set.write = [&paved, seed](const std::string& folder) {
    const Fields fields = fields_of(paved.pavement, seed);
    if (paved.tile) {
      write_set({paved.pavement, paved.tile->layout.stones, fields, seed, true},
                tile_grid(paved.tile->size_mm, paved.pavement.textures.size_px), folder);
    } else {
      write_set({paved.pavement, paved.layout.stones, fields, seed, false}, pixel_grid(paved.pavement), folder);
    }
  };
  return set;
}

}  // namespace

std::vector<FileSet> texture_files(const Model& model) {
  std::vector<FileSet> sets;
  for (const PavedArea& paved : model.pavements) sets.push_back(texture_set(paved, model.seed));
  return sets;
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(texture_files(model), std::back_inserter(outputs.sets)); }

}  // namespace shatterpave::exporting::textures
