// The maps of a texture set, row by row, from the surface map.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "export/textures/surface_map.h"

namespace shatterpave::exporting::textures {

enum class Map {
  base_color,
  roughness,
  normal,
  height,
  ambient_occlusion,
  stone_id,
  normal_directx,            // on request
  occlusion_roughness_metal  // on request, packed as glTF and game engines read it
};
// Of every set.
inline constexpr std::array<Map, 6> all_maps = {Map::base_color, Map::roughness,         Map::normal,
                                                Map::height,     Map::ambient_occlusion, Map::stone_id};

// What files end in, before the dot: as Blender's Node Wrangler, Substance and game engines look for it. Promised to users.
std::string_view name_of(Map map);

// 1 or 3.
std::size_t channels(Map map);

// The number that a stone id map holds where a stone with this id takes most of a pixel. Its colours are these 24 bits from red
// to blue: far apart for ids that follow on each other, different for all below 2^24 − 1, and never black, which is the joint.
inline constexpr std::uint32_t id_factor = 0x9E3779;
constexpr std::uint32_t id_colour(std::uint32_t id) { return ((id + 1) * id_factor) & 0xFFFFFFU; }

// How heights become values of the height map: (height − low) / range.
struct HeightRange {
  double low_mm = 0.0;
  double range_mm = 0.0;  // 0 where the surface is level
};

class Maps {
 public:
  // Both must outlive this.
  Maps(const Surface& surface, const SurfaceMap& map);
  ~Maps();
  Maps(const Maps&) = delete;
  Maps& operator=(const Maps&) = delete;

  HeightRange height_range() const;

  // A row of the window, channels together, 0 … 1 unless told otherwise:
  //   base_color         linear
  //   normal             tangent space, (n + 1) / 2; x to the right, y up in the picture (OpenGL), z out of the ground
  //   normal_directx     the same with y down
  //   occlusion_roughness_metal  ambient occlusion, roughness, and 0: stones are no metal
  //   height             by `height_range`
  //   stone_id           `id_colour` over 255, channel by channel; 0 in the joint
  void row(Map map, std::size_t row, std::span<float> values) const;
  // The id of the stone in each pixel, plus 1; 0 in the joint.
  void id_row(std::size_t row, std::span<float> values) const;

 private:
  struct Looks;

  void base_color_row(std::size_t row, std::span<float> values) const;
  void roughness_row(std::size_t row, std::span<float> values) const;
  void normal_down_row(std::size_t row, std::span<float> values) const;
  void packed_row(std::size_t row, std::span<float> values) const;
  void height_row(std::size_t row, std::span<float> values) const;
  void id_colour_row(std::size_t row, std::span<float> values) const;

  const Surface& surface_;
  const SurfaceMap& map_;
  HeightRange range_;
  std::unique_ptr<const Looks> looks_;
};

}  // namespace shatterpave::exporting::textures
