#include "export/textures/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/parallel.h"
#include "export/textures/maps.h"
#include "export/textures/occlusion.h"
#include "relief/raster_file.h"
#include "relief/srgb.h"

namespace shatterpave::exporting::textures {

namespace {

using paving::TextureFormat;
using relief::RasterFileFormat;

constexpr std::size_t drawn_rows = 64;

RasterFileFormat file_format(Map map, TextureFormat format) {
  if (format == TextureFormat::png) {
    return map == Map::height || map == Map::normal || map == Map::normal_directx ? RasterFileFormat::png16
                                                                                  : RasterFileFormat::png8;
  }
  return map == Map::height || map == Map::stone_id ? RasterFileFormat::exr_float : RasterFileFormat::exr_half;
}

// The maps that a pavement asks for.
std::vector<Map> maps_of(const paving::TextureSet& textures) {
  std::vector<Map> maps(all_maps.begin(), all_maps.end());
  if (textures.normals_down) maps.push_back(Map::normal_directx);
  if (textures.packed_channels) maps.push_back(Map::occlusion_roughness_metal);
  return maps;
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
  static const relief::SrgbCurve srgb;
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
std::string description(const Surface& surface, const PixelGrid& grid, const HeightRange& heights, TextureFormat format,
                        const std::string& stem) {
  const vec2 size_mm = grid.size_mm();
  nlohmann::ordered_json json = {{"format", "shatterpave-textures"},
                                 {"version", 1},
                                 {"name", surface.pavement.name},
                                 {"seed", surface.seed},
                                 {"size_px", {grid.width, grid.height}},
                                 {"low_mm", {grid.low_mm.x, grid.low_mm.y}},
                                 {"size_mm", {size_mm.x, size_mm.y}},
                                 {"seamless", surface.periodic},
                                 {"height_low_mm", heights.low_mm},
                                 {"height_range_mm", heights.range_mm},
                                 {"normal", "OpenGL"},
                                 {"base_color", format == TextureFormat::png ? "sRGB" : "linear"}};
  for (const Map map : maps_of(surface.pavement.textures))
    json["maps"][std::string(name_of(map))] = file_name(stem, map, format);
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

// `stem`: of the names of the files.
void write_set(const Surface& surface, const PixelGrid& grid, const std::string& stem, const std::string& folder) {
  const paving::Pavement& pavement = surface.pavement;
  const TextureFormat format = pavement.textures.format;
  const SurfaceMap map = surface_map(surface, grid, occlusion_reach(pavement, grid), samples_for(pavement, grid));
  const Maps maps(surface, map);
  const auto path = [&](const std::string& name) { return folder + "/" + name; };
  const std::vector<Map> asked = maps_of(pavement.textures);
  const auto write = [&](std::size_t k) { write_map(maps, grid, asked[k], format, path(file_name(stem, asked[k], format))); };
  if (format == TextureFormat::tiled_exr) {
    // One after the other, for the smaller sizes that each keeps in memory.
    for (std::size_t k = 0; k < asked.size(); ++k) write(k);
  } else {
    parallel_for(asked.size(), write);
  }
  write_text(path(stem + "_textures.json"), description(surface, grid, maps.height_range(), format, stem));
}

FileSet texture_set(const PavedArea& paved, std::uint64_t seed) {
  FileSet set;
  for (const Map map : maps_of(paved.pavement.textures))
    set.names.push_back(file_name(stem_of(paved), map, paved.pavement.textures.format));
  set.names.push_back(stem_of(paved) + "_textures.json");
  set.write = [&paved, seed](const std::string& folder) {
    const Fields fields = fields_of(paved.pavement, seed);
    if (paved.tile) {
      write_set({paved.pavement, paved.tile->layout.stones, fields, seed, true},
                tile_grid(paved.tile->size_mm, paved.pavement.textures.size_px), stem_of(paved), folder);
    } else {
      write_set({paved.pavement, paved.layout.stones, fields, seed, false}, pixel_grid(paved.pavement), stem_of(paved), folder);
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
