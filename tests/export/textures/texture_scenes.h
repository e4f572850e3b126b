// Pavements for the tests of textures, and what is drawn of them.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "export/textures/maps.h"
#include "export/textures/occlusion.h"
#include "export/textures/surface_map.h"
#include "paving/laying.h"
#include "paving/seamless.h"

namespace shatterpave::exporting::textures {

inline paving::Pavement square_pavement(double side_mm) {
  paving::Pavement pavement;
  pavement.name = "yard";
  pavement.area.outline = {{0.0, 0.0}, {side_mm, 0.0}, {side_mm, side_mm}, {0.0, side_mm}};
  return pavement;
}

// With the seed 7; made once for each relief, since they are most of the work.
inline const Fields& fields_for(const paving::Pavement& pavement) {
  static std::map<std::tuple<double, double, double>, Fields> known;
  const std::tuple key(pavement.relief.rms_mm, pavement.relief.hurst, pavement.stone_mm.x * pavement.stone_mm.y);
  const auto at = known.find(key);
  return at != known.end() ? at->second : known.emplace(key, fields_of(pavement, 7)).first->second;
}

// A pavement's stones, and their surface.
struct Drawn {
  Drawn(paving::Pavement asked, std::vector<paving::Stone> laid, const PixelGrid& grid, std::size_t samples,
        bool periodic = false, std::size_t halo = 1)
      : pavement(std::move(asked)),
        stones(std::move(laid)),
        fields(fields_for(pavement)),
        surface{pavement, stones, fields, 7, periodic},
        map(surface_map(surface, grid, halo, samples)),
        maps(surface, map) {}
  Drawn(const Drawn&) = delete;
  Drawn& operator=(const Drawn&) = delete;

  // Of the whole window.
  std::vector<float> values(Map which) const {
    const std::size_t length = map.grid.width * channels(which);
    std::vector<float> all(length * map.grid.height);
    for (std::size_t row = 0; row < map.grid.height; ++row) {
      maps.row(which, row, std::span<float>(all).subspan(row * length, length));
    }
    return all;
  }

  paving::Pavement pavement;
  std::vector<paving::Stone> stones;
  const Fields& fields;
  Surface surface;
  SurfaceMap map;
  Maps maps;
};

}  // namespace shatterpave::exporting::textures
