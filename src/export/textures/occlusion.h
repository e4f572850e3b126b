// Ambient occlusion of a surface map (relief/surface_rows.h).
#pragma once

#include <cstddef>
#include <span>

#include "export/textures/surface_map.h"

namespace shatterpave::exporting::textures {

// How far the surface about a pixel matters, in pixels: the halo that the map must have. At least 1, at most 89.
std::size_t occlusion_reach(const paving::Pavement& pavement, const PixelGrid& grid);

// Of a row of the window, 0 (dark) … 1 (open); as many as the window has columns.
void occlusion_row(const SurfaceMap& map, std::size_t row, std::span<float> open);

}  // namespace shatterpave::exporting::textures
