// The filling of the joints: sand, level but for its grain.
#pragma once

#include <cstdint>

#include "export/textures/pixel_grid.h"
#include "paving/pavement.h"
#include "relief/periodic_field.h"

namespace shatterpave::exporting::textures {

class Bed {
 public:
  // A coordinate, as phases of the grains and of what lies in patches.
  struct Phase {
    std::uint32_t grain = 0;
    std::uint32_t patch = 0;
  };

  // For places `sampled_mm` apart. Over a window that is a tile, grains and patches repeat a whole number of times, so that
  // they meet themselves.
  Bed(const paving::Pavement& pavement, const relief::HeightField& grains, const PixelGrid& grid, bool periodic,
      double sampled_mm);

  // For a place of the window, in parts of its size from the upper left corner.
  Phase phase_x(double part) const { return phase(part, grain_repeats_.x, patch_repeats_.x); }
  Phase phase_y(double part) const { return phase(part, grain_repeats_.y, patch_repeats_.y); }

  // What lies there, about 0, of rms 1 where pixels are fine enough to show it: high are light, coarse grains.
  float grain(const Phase& x, const Phase& y) const {
    return 0.8F * grains_.at(x.grain, y.grain) + 0.6F * patches_.at(x.patch, y.patch);
  }
  // Patches alone: where something grows.
  float patch(const Phase& x, const Phase& y) const { return patches_.at(x.patch, y.patch); }
  float height_mm(float grain) const { return level_mm_ + grain_mm_ * grain; }
  // No part of it is higher.
  float top_mm() const { return level_mm_ + 8.0F * grain_mm_; }

 private:
  static Phase phase(double part, double grain_repeats, double patch_repeats) {
    return {relief::PeriodicField::phase(part * grain_repeats), relief::PeriodicField::phase(part * patch_repeats)};
  }

  relief::PeriodicField grains_;
  relief::PeriodicField patches_;
  vec2 grain_repeats_;
  vec2 patch_repeats_;
  float level_mm_;
  float grain_mm_;
};

}  // namespace shatterpave::exporting::textures
