#include "export/textures/maps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "export/shapes/palette.h"
#include "export/textures/bed.h"
#include "export/textures/occlusion.h"

namespace shatterpave::exporting::textures {

namespace {

using relief::PeriodicField;

constexpr std::size_t looks_at_once = 256;
constexpr std::size_t rows_at_once = 64;

// The lowest and the highest of the window.
HeightRange range_of(const SurfaceMap& map) {
  const std::size_t chunks = (map.grid.height + rows_at_once - 1) / rows_at_once;
  std::vector<std::pair<float, float>> found(chunks);
  parallel_for(chunks, [&](std::size_t chunk) {
    const float* first = &map.height_mm[map.index(0, chunk * rows_at_once)];
    float low = *first;
    float high = *first;
    for (std::size_t row = chunk * rows_at_once; row < std::min(map.grid.height, (chunk + 1) * rows_at_once); ++row) {
      const float* heights = &map.height_mm[map.index(0, row)];
      for (std::size_t x = 0; x < map.grid.width; ++x) {
        low = std::min(low, heights[x]);
        high = std::max(high, heights[x]);
      }
    }
    found[chunk] = {low, high};
  });
  float low = found.front().first;
  float high = found.front().second;
  for (const auto& [least, most] : found) {
    low = std::min(low, least);
    high = std::max(high, most);
  }
  return {static_cast<double>(low), static_cast<double>(high) - static_cast<double>(low)};
}

}  // namespace

std::string_view name_of(Map map) {
  switch (map) {
    case Map::base_color:
      return "BaseColor";
    case Map::roughness:
      return "Roughness";
    case Map::normal:
      return "Normal";
    case Map::height:
      return "Height";
    case Map::ambient_occlusion:
      return "AmbientOcclusion";
    case Map::stone_id:
      return "ID";
    case Map::normal_directx:
      return "NormalDX";
    case Map::occlusion_roughness_metal:
      return "OcclusionRoughnessMetallic";
  }
  ENSURE(false);
  return {};
}

std::size_t channels(Map map) { return map == Map::roughness || map == Map::height || map == Map::ambient_occlusion ? 1 : 3; }

// What colour and roughness need, made once.
struct Maps::Looks {
  struct Stone {
    vec2 centre{0.0, 0.0};
    vec2 relief_place{0.0, 0.0};
    float relief = 1.0F;   // how much is left of it
    float per_top = 1.0F;  // over its height, 1/mm
    shapes::StoneLook look;
  };

  Looks(const Surface& surface, const SurfaceMap& map)
      : grid(map.grid),
        periodic(surface.periodic),
        palette(surface.pavement.look),
        bed(surface.pavement, surface.fields.grain, map.grid, surface.periodic, map.grid.pixel_mm.y),
        minerals(surface.fields.grain, map.grid.pixel_mm.y / palette.mineral_mm()),
        relief_side_mm(surface.fields.relief_side_mm),
        laid(laid_surface(surface, map.grid)),
        stones(surface.stones.size()) {
    const double rms_mm = surface.pavement.relief.rms_mm;
    if (rms_mm > 0.0) {
      relief.emplace(surface.fields.relief, map.grid.pixel_mm.y);
      per_rms = static_cast<float>(1.0 / rms_mm);
    }
    if (palette.cloud_mm() > 0.0) clouds.emplace(surface.fields.grain, map.grid.pixel_mm.y / palette.cloud_mm());
    const paving::StoneSurface& top = surface.pavement.surface;
    // Of the single patch of the highest stone, see paving/surface/stone_surface.h.
    const double highest_mm = 0.5625 * top.height_mm * (1.0 + top.height_spread);
    level = surface.pavement.body.finish == paving::Finish::none && top.height_mm == 0.0;
    parallel_for_chunks(stones.size(), looks_at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const paving::StoneDraws draws = laid.draws(s);
        stones[s] = {geometry::centroid(surface.stones[s].outline_mm), draws.relief_place, static_cast<float>(draws.relief),
                     static_cast<float>(1.0 / std::max(1e-3, draws.body ? draws.body->rise_mm : highest_mm)),
                     palette.stone(draws.colour, surface.stones[s].colour)};
      }
    });
  }

  // What is seen of a stone at a pixel of the window.
  shapes::Place place(const Stone& stone, std::size_t column, std::size_t row, float height) const {
    const vec2 at = grid.centre(static_cast<double>(column), static_cast<double>(row));
    vec2 from_centre = at - stone.centre;
    if (periodic) from_centre -= grid.size_mm() * glm::round(from_centre / grid.size_mm());
    shapes::Place place;
    const vec2 in_relief = stone.relief_place + from_centre / relief_side_mm;
    if (relief)
      place.relief = stone.relief * per_rms * relief->at(PeriodicField::phase(in_relief.x), PeriodicField::phase(in_relief.y));
    const auto seen = [&](const PeriodicField& field, double wide_mm) {
      const vec2 in_field = stone.relief_place + from_centre / (wide_mm * grain_side_mm);
      return field.at(PeriodicField::phase(in_field.x), PeriodicField::phase(in_field.y));
    };
    place.grain = seen(minerals, palette.mineral_mm());
    if (clouds) place.cloud = seen(*clouds, palette.cloud_mm());
    if (palette.has_moss()) place.patch = bed_place(column, row).patch;
    place.from_centre_mm = from_centre;
    if (!laid.is_level()) height -= static_cast<float>(laid.ground(at).height_mm);
    place.rise = level ? 1.0F : height * stone.per_top;
    return place;
  }

  shapes::BedPlace bed_place(std::size_t column, std::size_t row) const {
    const Bed::Phase x = bed.phase_x((static_cast<double>(column) + 0.5) / static_cast<double>(grid.width));
    const Bed::Phase y = bed.phase_y((static_cast<double>(row) + 0.5) / static_cast<double>(grid.height));
    return {bed.grain(x, y), palette.has_moss() ? bed.patch(x, y) : 0.0F};
  }

  struct Pixel {
    const Stone* stone = nullptr;  // none: all of it is joint
    float part = 0.0F;             // of the stone
    shapes::Place place;           // on the stone
    shapes::BedPlace bed;          // where the stone leaves something
  };
  Pixel pixel(const SurfaceMap& map, std::size_t column, std::size_t row) const {
    const std::size_t at = map.index(column, row);
    Pixel pixel;
    if (map.stone[at] != 0) {
      pixel.stone = &stones[map.stone[at] - 1];
      pixel.part = static_cast<float>(map.cover[at]) / 255.0F;
      pixel.place = place(*pixel.stone, column, row, map.height_mm[at]);
    }
    if (pixel.part < 1.0F) pixel.bed = bed_place(column, row);
    return pixel;
  }

  PixelGrid grid;
  bool periodic;
  shapes::Palette palette;
  Bed bed;
  PeriodicField minerals;
  std::optional<PeriodicField> clouds;
  double relief_side_mm;
  paving::LaidSurface laid;
  std::optional<PeriodicField> relief;
  float per_rms = 0.0F;
  bool level = false;
  std::vector<Stone> stones;
};

Maps::Maps(const Surface& surface, const SurfaceMap& map)
    : surface_(surface), map_(map), range_(range_of(map)), looks_(std::make_unique<const Looks>(surface, map)) {}
Maps::~Maps() = default;

HeightRange Maps::height_range() const { return range_; }

void Maps::id_row(std::size_t row, std::span<float> values) const {
  for (std::size_t x = 0; x < map_.grid.width; ++x) {
    const std::uint32_t stone = map_.owner(map_.index(x, row));
    values[x] = stone == 0 ? 0.0F : static_cast<float>(surface_.stones[stone - 1].id + 1);
  }
}

void Maps::height_row(std::size_t row, std::span<float> values) const {
  const float* heights = &map_.height_mm[map_.index(0, row)];
  const auto low = static_cast<float>(range_.low_mm);
  const auto scale = static_cast<float>(range_.range_mm > 0.0 ? 1.0 / range_.range_mm : 0.0);
  for (std::size_t x = 0; x < values.size(); ++x) values[x] = (heights[x] - low) * scale;
}

void Maps::id_colour_row(std::size_t row, std::span<float> values) const {
  for (std::size_t x = 0; x < map_.grid.width; ++x) {
    const std::uint32_t stone = map_.owner(map_.index(x, row));
    const std::uint32_t colour = stone == 0 ? 0 : id_colour(static_cast<std::uint32_t>(surface_.stones[stone - 1].id));
    for (std::size_t c = 0; c < 3; ++c) values[3 * x + c] = static_cast<float>((colour >> (16 - 8 * c)) & 0xFFU) / 255.0F;
  }
}

// Where stones and joints share a pixel, both are mixed.
void Maps::base_color_row(std::size_t row, std::span<float> values) const {
  for (std::size_t x = 0; x < map_.grid.width; ++x) {
    const Looks::Pixel pixel = looks_->pixel(map_, x, row);
    shapes::Colour colour = pixel.part < 1.0F ? looks_->palette.bed_colour(pixel.bed) : shapes::Colour{};
    if (pixel.stone != nullptr)
      colour = shapes::mixed(colour, looks_->palette.stone_colour(pixel.stone->look, pixel.place), pixel.part);
    if (map_.is_flooded(map_.index(x, row))) colour = shapes::Palette::under_water(colour);
    values[3 * x] = colour.red;
    values[3 * x + 1] = colour.green;
    values[3 * x + 2] = colour.blue;
  }
}

void Maps::roughness_row(std::size_t row, std::span<float> values) const {
  for (std::size_t x = 0; x < map_.grid.width; ++x) {
    const Looks::Pixel pixel = looks_->pixel(map_, x, row);
    values[x] = pixel.part < 1.0F ? looks_->palette.bed_roughness(pixel.bed) : 0.0F;
    if (pixel.stone != nullptr)
      values[x] += pixel.part * (looks_->palette.stone_roughness(pixel.stone->look, pixel.place) - values[x]);
    if (map_.is_flooded(map_.index(x, row))) values[x] = shapes::Palette::water_roughness;
  }
}

void Maps::normal_down_row(std::size_t row, std::span<float> values) const {
  relief::normal_row(map_.heights(), row, values);
  for (std::size_t x = 0; x < map_.grid.width; ++x) values[3 * x + 1] = 1.0F - values[3 * x + 1];
}

void Maps::packed_row(std::size_t row, std::span<float> values) const {
  std::vector<float> one(map_.grid.width);
  occlusion_row(map_, row, one);
  for (std::size_t x = 0; x < one.size(); ++x) {
    values[3 * x] = one[x];
    values[3 * x + 2] = 0.0F;
  }
  roughness_row(row, one);
  for (std::size_t x = 0; x < one.size(); ++x) values[3 * x + 1] = one[x];
}

void Maps::row(Map map, std::size_t row, std::span<float> values) const {
  ENSURE(values.size() == map_.grid.width * channels(map) && row < map_.grid.height);
  switch (map) {
    case Map::base_color:
      return base_color_row(row, values);
    case Map::roughness:
      return roughness_row(row, values);
    case Map::normal:
      return relief::normal_row(map_.heights(), row, values);
    case Map::height:
      return height_row(row, values);
    case Map::ambient_occlusion:
      return occlusion_row(map_, row, values);
    case Map::stone_id:
      return id_colour_row(row, values);
    case Map::normal_directx:
      return normal_down_row(row, values);
    case Map::occlusion_roughness_metal:
      return packed_row(row, values);
  }
}

}  // namespace shatterpave::exporting::textures
