// The filling of the joints: sand, level but for its grain.
#pragma once

#include <cstdint>

#include "export/textures/pixel_grid.h"
#include "paving/pavement.h"
#include "relief/periodic_field.h"

namespace shatterpave::exporting::textures {

class Bed {
 public:
  // For places `sampled_mm` apart. The grain repeats a whole number of times over the window, so that it meets itself.
  Bed(const paving::Pavement& pavement, const relief::HeightField& grains, const PixelGrid& grid, double sampled_mm);

  // Phases for a place of the window, in parts of its size from the upper left corner.
  std::uint32_t phase_x(double part) const { return relief::PeriodicField::phase(part * repeats_.x); }
  std::uint32_t phase_y(double part) const { return relief::PeriodicField::phase(part * repeats_.y); }

  // Of the grain there, about 0, of rms 1 where the pixels are fine enough to show it.
  float grain(std::uint32_t x, std::uint32_t y) const { return grain_.at(x, y); }
  float height_mm(float grain) const { return level_mm_ + grain_mm_ * grain; }
  // No part of it is higher.
  float top_mm() const { return level_mm_ + 8.0F * grain_mm_; }

 private:
  relief::PeriodicField grain_;
  vec2 repeats_;
  float level_mm_;
  float grain_mm_;
};

}  // namespace shatterpave::exporting::textures
