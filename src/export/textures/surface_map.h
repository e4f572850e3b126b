// The surface of a pavement as a raster: heights, and which stone it is.
//
// Stones are drawn as they are, patch by patch, with the relief on top and the filling of the joints between; nothing is
// stamped or repeated. Each pixel is the mean of `samples`² samples, so that edges are smooth and fine relief does not glitter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "export/textures/fields.h"
#include "export/textures/pixel_grid.h"
#include "paving/pavement.h"
#include "paving/stones.h"
#include "paving/surface/laid_surface.h"
#include "relief/surface_rows.h"

namespace shatterpave::exporting::textures {

// What is drawn.
struct Surface {
  const paving::Pavement& pavement;
  const std::vector<paving::Stone>& stones;
  const Fields& fields;
  std::uint64_t seed = 1;
  bool periodic = false;  // the stones repeat by the size of the window, in x and y
};

// The stones as they lie, over the window of that grid.
paving::LaidSurface laid_surface(const Surface& surface, const PixelGrid& grid);

// Samples along a side of a pixel that show the joints of the pavement as they are; 2 … 4.
std::size_t samples_for(const paving::Pavement& pavement, const PixelGrid& grid);

struct SurfaceMap {
  PixelGrid grid;
  std::size_t halo = 0;              // so many pixels more on each side, drawn like all others
  std::vector<float> height_mm;      // (width + 2 halo) × (height + 2 halo), row by row from the top
  std::vector<std::uint32_t> stone;  // which has most of the pixel, of stones: its index, plus 1; 0 is none
  std::vector<std::uint8_t> cover;   // how much of the pixel is stone, 0 … 255
  std::optional<float> water_mm;     // where water stands in low spots: heights are at least this

  std::size_t row_length() const { return grid.width + 2 * halo; }
  std::size_t rows() const { return grid.height + 2 * halo; }
  // The stone of a pixel that is at least half stone, as above; 0 is the joint.
  std::uint32_t owner(std::size_t pixel) const { return cover[pixel] >= 128 ? stone[pixel] : 0; }
  bool is_flooded(std::size_t pixel) const { return water_mm && height_mm[pixel] == *water_mm; }
  relief::HeightRows heights() const { return {&height_mm[index(0, 0)], row_length(), grid.pixel_mm}; }
  // Of a pixel of the window.
  std::size_t index(std::size_t column, std::size_t row) const { return (row + halo) * row_length() + column + halo; }
};

// The same to the bit for any number of threads. Memory: 9 bytes a pixel, and some 30 MB a thread.
SurfaceMap surface_map(const Surface& surface, const PixelGrid& grid, std::size_t halo, std::size_t samples);

}  // namespace shatterpave::exporting::textures
