// Heights, minerals and clouds are fractal surfaces whose period is the swatch, as those of the pavement's textures are;
// colours and roughness follow from them by the same palette. Pixels are samples, not means: minerals have sharp edges.
#include "export/swatches/swatches.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "relief/fractal_surface.h"
#include "relief/periodic_field.h"
#include "relief/srgb.h"
#include "relief/surface_rows.h"

namespace shatterpave::exporting::swatches {

namespace {

using relief::PeriodicField;
using relief::Raster;
using shapes::Swatch;
using shapes::SwatchOf;

constexpr double mm_per_m = 1000.0;

// Of the surfaces: near one to a pixel.
constexpr std::size_t least_points = 64;
constexpr std::size_t most_points = 2048;
constexpr std::size_t points_of_clouds = 256;

// Minerals are wrinkled, clouds less (by eye, as the pavement's textures have them).
constexpr double mineral_hurst = 0.3;
constexpr double cloud_hurst = 0.7;
constexpr double warp_hurst = 0.8;
// Waves of minerals and clouds are no longer than two of their widths.
constexpr double waves_of_width = 2.0;
// What bends beds, and parts rusty veins from white ones; by eye.
constexpr double warp_mm = 400.0;
constexpr float warp_of_beds = 0.8F;

// Of sand in joints (by eye, see export/textures/bed.cpp): its grains, and patches of damp and moss.
constexpr double sand_mm = 1.0;
constexpr double sand_patch_mm = 12.0;
constexpr double sand_rms_mm = 0.3;

// Occlusion looks this far, by eye: what is farther off on a face is no higher.
constexpr double occlusion_mm = 30.0;

class Surfaces {
 public:
  Surfaces(const Swatch& swatch, std::uint64_t seed)
      : side_mm_(swatch.side_m * mm_per_m),
        sampled_mm_(side_mm_ / static_cast<double>(swatch.size_px)),
        points_(std::clamp(std::bit_ceil(swatch.size_px), least_points, most_points)),
        seed_(seed),
        id_(Id("swatch").child(static_cast<std::uint64_t>(swatch.of)).child(static_cast<std::uint64_t>(swatch.look.material))) {
  }

  // One that a swatch has once: `name` tells it from the others. Waves are at most `longest_mm` long, or the swatch's side.
  PeriodicField field(std::string_view name, double rms, double hurst, double longest_mm, std::size_t points) const {
    const relief::FractalSurface surface{points, side_mm_ / static_cast<double>(points), rms, hurst,
                                         std::min(longest_mm, side_mm_)};
    return PeriodicField(relief::fractal_surface(surface, seed_, id_.child(name)), sampled_mm_);
  }
  PeriodicField fine(std::string_view name, double rms, double hurst, double longest_mm) const {
    return field(name, rms, hurst, longest_mm, points_);
  }
  PeriodicField coarse(std::string_view name, double rms, double hurst, double longest_mm) const {
    return field(name, rms, hurst, longest_mm, std::min(points_, points_of_clouds));
  }

 private:
  double side_mm_;
  double sampled_mm_;
  std::size_t points_;
  std::uint64_t seed_;
  Id id_;
};

// What a row or a column of pixels has in common.
std::vector<std::uint32_t> phases(std::size_t size_px, bool of_rows) {
  std::vector<std::uint32_t> result(size_px);
  for (std::size_t k = 0; k < size_px; ++k) {
    const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(size_px);
    result[k] = PeriodicField::phase(of_rows ? 1.0 - part : part);
  }
  return result;
}

struct Pixel {
  shapes::Colour colour;
  float roughness = 1.0F;
  float height_mm = 0.0F;
};

// A pixel of stone or joint, by its phases.
class StonePixels {
 public:
  StonePixels(const Swatch& swatch, std::uint64_t seed)
      : palette_(swatch.look),
        stone_(palette_.swatch_stone(swatch.side_m * mm_per_m)),
        side_mm_(swatch.side_m * mm_per_m),
        rms_mm_(static_cast<float>(swatch.relief.rms_mm)) {
    const Surfaces surfaces(swatch, seed);
    if (rms_mm_ > 0.0F) relief_.emplace(surfaces.fine("relief", 1.0, swatch.relief.hurst, swatch.longest_mm));
    minerals_.emplace(surfaces.fine("minerals", 1.0, mineral_hurst, waves_of_width * palette_.mineral_mm()));
    if (palette_.cloud_mm() == 0.0) return;
    clouds_.emplace(surfaces.coarse("clouds", 1.0, cloud_hurst, waves_of_width * palette_.cloud_mm()));
    warp_.emplace(surfaces.coarse("warp", 1.0, warp_hurst, warp_mm));
  }

  Pixel operator()(std::uint32_t u, std::uint32_t v) const {
    shapes::Place place;
    shapes::StoneLook stone = stone_;
    if (relief_) place.relief = relief_->at(u, v);
    place.grain = minerals_->at(u, v);
    if (clouds_) {
      const float warp = warp_->at(u, v);
      place.cloud = clouds_->at(u, v);
      place.bend = warp_of_beds * warp;
      stone.vein = shapes::Palette::vein(stone.colour, std::clamp(0.5F + warp, 0.0F, 1.0F));
    }
    constexpr double turn = 1.0 / 4294967296.0;
    place.from_centre_mm = vec2{static_cast<double>(u), static_cast<double>(v)} * (side_mm_ * turn);
    return {palette_.stone_colour(stone, place), palette_.stone_roughness(stone, place), rms_mm_ * place.relief};
  }

 private:
  shapes::Palette palette_;
  shapes::StoneLook stone_;
  double side_mm_;
  float rms_mm_;
  std::optional<PeriodicField> relief_;
  std::optional<PeriodicField> minerals_;
  std::optional<PeriodicField> clouds_;
  std::optional<PeriodicField> warp_;
};

class JointPixels {
 public:
  JointPixels(const Swatch& swatch, std::uint64_t seed)
      : palette_(swatch.look),
        grains_(Surfaces(swatch, seed).fine("grains", 1.0, mineral_hurst, waves_of_width * sand_mm)),
        patches_(Surfaces(swatch, seed).coarse("patches", 1.0, mineral_hurst, waves_of_width * sand_patch_mm)) {}

  Pixel operator()(std::uint32_t u, std::uint32_t v) const {
    const float patch = patches_.at(u, v);
    const shapes::BedPlace place{0.8F * grains_.at(u, v) + 0.6F * patch, patch};
    return {palette_.bed_colour(place) * (1.0F / shapes::Palette::joint_tint), palette_.bed_roughness(place),
            static_cast<float>(sand_rms_mm) * place.grain};
  }

 private:
  shapes::Palette palette_;
  PeriodicField grains_;
  PeriodicField patches_;
};

Raster blank(std::size_t size_px) { return {size_px, size_px, 3, std::vector<float>(size_px * size_px * 3)}; }

// Heights with so many more on each side, from the other side.
class WrappedHeights {
 public:
  WrappedHeights(std::size_t size_px, std::size_t halo, double pixel_mm)
      : size_(size_px), halo_(halo), pixel_mm_(pixel_mm), values_((size_px + 2 * halo) * (size_px + 2 * halo)) {}

  float* row(std::size_t row) { return &values_[(row + halo_) * length() + halo_]; }
  void wrap() {
    for (std::size_t r = 0; r < size_; ++r) {
      float* first = row(r);
      for (std::size_t k = 1; k <= halo_; ++k) {
        *(first - k) = first[(size_ - k % size_) % size_];
        first[size_ - 1 + k] = first[(k - 1) % size_];
      }
    }
    for (std::size_t k = 1; k <= halo_; ++k) {
      copy((size_ - k % size_) % size_ + halo_, halo_ - k);
      copy((k - 1) % size_ + halo_, halo_ + size_ - 1 + k);
    }
  }
  relief::HeightRows rows() const { return {&values_[halo_ * length() + halo_], length(), {pixel_mm_, pixel_mm_}}; }

 private:
  std::size_t length() const { return size_ + 2 * halo_; }
  void copy(std::size_t from, std::size_t to) {
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(from * length()), length(),
                values_.begin() + static_cast<std::ptrdiff_t>(to * length()));
  }

  std::size_t size_;
  std::size_t halo_;
  double pixel_mm_;
  std::vector<float> values_;
};

template <typename Pixels>
Pictures drawn_of(const Swatch& swatch, const Pixels& pixel) {
  const std::size_t size = swatch.size_px;
  const double pixel_mm = swatch.side_m * mm_per_m / static_cast<double>(size);
  const std::size_t reach = relief::horizon_reach(occlusion_mm / pixel_mm);
  Pictures pictures{blank(size), blank(size), blank(size)};
  WrappedHeights heights(size, reach, pixel_mm);
  const std::vector<std::uint32_t> columns = phases(size, false);
  const std::vector<std::uint32_t> rows = phases(size, true);
  parallel_for(size, [&](std::size_t row) {
    float* height = heights.row(row);
    float* colour = &pictures.base_color.values[3 * row * size];
    float* surface = &pictures.occlusion_roughness_metallic.values[3 * row * size];
    for (std::size_t x = 0; x < size; ++x) {
      const Pixel seen = pixel(columns[x], rows[row]);
      height[x] = seen.height_mm;
      colour[3 * x] = std::min(1.0F, seen.colour.red);
      colour[3 * x + 1] = std::min(1.0F, seen.colour.green);
      colour[3 * x + 2] = std::min(1.0F, seen.colour.blue);
      surface[3 * x + 1] = seen.roughness;
    }
  });
  heights.wrap();
  parallel_for(size, [&](std::size_t row) {
    relief::normal_row(heights.rows(), row, std::span(pictures.normal.values).subspan(3 * row * size, 3 * size));
    std::vector<float> open(size);
    relief::occlusion_row(heights.rows(), reach, row, open);
    for (std::size_t x = 0; x < size; ++x) pictures.occlusion_roughness_metallic.values[3 * (row * size + x)] = open[x];
  });
  return pictures;
}

}  // namespace

Pictures drawn(const Swatch& swatch, std::uint64_t seed) {
  ENSURE(swatch.size_px >= 1 && swatch.size_px <= 4096 && swatch.side_m > 0.0);
  if (swatch.of == SwatchOf::joint) return drawn_of(swatch, JointPixels(swatch, seed));
  return drawn_of(swatch, StonePixels(swatch, seed));
}

Raster tinted(const Raster& base_color, const shapes::Colour& tint) {
  ENSURE(base_color.channels == 3);
  Raster result = base_color;
  for (std::size_t i = 0; i < result.values.size(); i += 3) {
    result.values[i] *= tint.red;
    result.values[i + 1] *= tint.green;
    result.values[i + 2] *= tint.blue;
  }
  return result;
}

PictureFile colour_file(const Raster& linear, const std::string& stem) {
  static const relief::SrgbCurve srgb;
  Raster shown = linear;
  std::ranges::transform(shown.values, shown.values.begin(), srgb);
  return data_file(shown, stem);
}

PictureFile data_file(const Raster& raster, const std::string& stem) {
  return {stem + ".jpg", "image/jpeg", relief::encoded(raster, relief::RasterFormat::jpeg)};
}

Files files(const Pictures& pictures, const std::string& name) {
  Files made;
  const std::array<std::function<void()>, 3> jobs = {
      [&] { made.base_color = colour_file(pictures.base_color, name + "_BaseColor"); },
      [&] { made.normal = data_file(pictures.normal, name + "_Normal"); },
      [&] {
        made.occlusion_roughness_metallic =
            data_file(pictures.occlusion_roughness_metallic, name + "_OcclusionRoughnessMetallic");
      }};
  parallel_for(jobs.size(), [&](std::size_t i) { jobs.at(i)(); });
  return made;
}

}  // namespace shatterpave::exporting::swatches
