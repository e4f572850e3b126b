// The upper surfaces of the stones of a pavement as they lie there: what each draws for itself (stone_surface.h), worn by those
// who walk over it, sharp where it was sawn to fit the border, sunk and leaning with the ground (wear.h, ground.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/stones.h"
#include "paving/surface/ground.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::paving {

class LaidSurface {
 public:
  // With a period in x and y the stones are those of a tile that meets itself: there is no border, all of it is worn as the
  // middle of a pavement is, and the ground meets itself too. The pavement and the stones must outlive this.
  LaidSurface(const Pavement& pavement, const std::vector<Stone>& stones, std::uint64_t seed,
              std::optional<vec2> period_mm = {});

  // The traffic over a stone, by its index: from 0, where nothing wears, to 1.
  double traffic(std::size_t index) const { return traffic_.empty() ? 0.0 : traffic_[index]; }
  StoneDraws draws(std::size_t index) const;
  // The patches of a stone with these draws: its own, or what its maker left out of them.
  std::vector<geometry::BezierPatch> patches(std::size_t index, const StoneDraws& draws) const;

  bool is_level() const { return pavement_.ground.settlement_mm == 0.0; }
  GroundPoint ground(vec2 place) const { return settlement(pavement_.ground, seed_, place, period_mm_); }

 private:
  const Pavement& pavement_;
  const std::vector<Stone>& stones_;
  std::uint64_t seed_;
  std::optional<vec2> period_mm_;
  geometry::RegionIndex area_;
  std::vector<double> traffic_;  // empty without wear
};

}  // namespace shatterpave::paving
