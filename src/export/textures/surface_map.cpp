// Bands of rows are drawn in parallel, each into samples of its own, which are then taken together to pixels. A stone that lies
// in two bands is drawn in both, cut to their rows.
#include "export/textures/surface_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/cancel.h"
#include "core/error.h"
#include "core/parallel.h"
#include "export/textures/bed.h"
#include "export/textures/patch_fill.h"
#include "paving/surface/laid_surface.h"

namespace shatterpave::exporting::textures {

namespace {

using relief::PeriodicField;

// Samples to the width of a joint, and to a stone's side.
constexpr double samples_to_joint = 3.0;
constexpr double samples_to_stone = 24.0;
constexpr double fewest_samples = 2.0;
constexpr double most_samples = 4.0;

// Samples of a band, of 8 bytes each.
constexpr std::size_t band_samples = 4'000'000;
constexpr std::size_t most_rows = 256;
constexpr std::size_t fewest_bands = 16;

constexpr std::size_t stones_at_once = 256;

// A stone in one of its places.
struct Placed {
  std::uint32_t stone = 0;
  vec2 by{0.0, 0.0};  // mm
};

geometry::Box box_of(const Surface& surface, std::size_t stone) {
  const geometry::Polygon& outline = surface.stones[stone].outline_mm;
  const geometry::Box box = geometry::bounding_box(outline);
  // Patches may leave the outline by the tolerance of corners, and scales by their tips.
  const double reach = paving::corner_tolerance * std::sqrt(std::abs(geometry::area(outline))) +
                       paving::reach_of_cell_mm(outline, surface.pavement.cell);
  return {box.low - reach, box.high + reach};
}

// The stones that have a point in `window`, once for each of their places there.
std::vector<Placed> placed_stones(const Surface& surface, const geometry::Box& window, vec2 period) {
  std::vector<Placed> placed;
  for (std::size_t s = 0; s < surface.stones.size(); ++s) {
    const geometry::Box box = box_of(surface, s);
    vec2 first{0.0, 0.0};
    vec2 last{0.0, 0.0};
    if (surface.periodic) {
      first = glm::ceil((window.low - box.high) / period);
      last = glm::floor((window.high - box.low) / period);
    }
    for (double j = first.y; j <= last.y; j += 1.0) {
      for (double i = first.x; i <= last.x; i += 1.0) {
        const vec2 by = vec2{i, j} * period;
        if (geometry::boxes_meet({box.low + by, box.high + by}, window)) placed.push_back({static_cast<std::uint32_t>(s), by});
      }
    }
  }
  return placed;
}

// The drawing of one map.
class Drawing {
 public:
  Drawing(const Surface& surface, std::size_t samples, SurfaceMap& map)
      : surface_(surface),
        samples_(samples),
        map_(map),
        bed_(surface.pavement, surface.fields.grain, map.grid, surface.periodic, sample_mm().y),
        laid_(laid_surface(surface, map.grid)) {
    if (surface.pavement.relief.rms_mm > 0.0) relief_.emplace(surface.fields.relief, sample_mm().y);
    map.water_mm = water_level();
    placed_ = placed_stones(surface, window(), map.grid.size_mm());
    list_bands();
  }

  std::size_t bands() const { return bands_; }

  void draw_band(std::size_t band) const {
    Band drawn;
    drawn.first_row = band * band_rows_ * samples_;
    const std::size_t last = std::min(map_.rows(), (band + 1) * band_rows_) * samples_;
    drawn.rows = last - drawn.first_row;
    drawn.height.assign(drawn.rows * columns(), HeightBlock::nothing);
    drawn.stone.assign(drawn.rows * columns(), 0);
    for (std::size_t k = first_[band]; k < first_[band + 1]; ++k) draw_stone(placed_[listed_[k]], drawn);
    fill_joints(drawn);
    for (std::size_t row = 0; row < drawn.rows / samples_; ++row) put_pixels(drawn, row, band * band_rows_ + row);
  }

 private:
  struct Band {
    std::size_t first_row = 0;  // of samples
    std::size_t rows = 0;
    std::vector<float> height;
    std::vector<std::uint32_t> stone;
    HeightBlock block;
  };

  std::size_t columns() const { return map_.row_length() * samples_; }
  vec2 sample_mm() const { return map_.grid.pixel_mm / static_cast<double>(samples_); }
  geometry::Box window() const {
    const vec2 halo = static_cast<double>(map_.halo) * map_.grid.pixel_mm;
    return {map_.grid.low_mm - halo, map_.grid.low_mm + map_.grid.size_mm() + halo};
  }
  // Where a sample of that column and row would be; samples stand on whole numbers.
  vec2 in_samples(vec2 mm) const {
    const geometry::Box box = window();
    return vec2{mm.x - box.low.x, box.high.y - mm.y} / sample_mm() - 0.5;
  }
  vec2 of_sample(vec2 sample) const {
    const geometry::Box box = window();
    const vec2 offset = (sample + 0.5) * sample_mm();
    return {box.low.x + offset.x, box.high.y - offset.y};
  }

  // Of all stones, whether or not they are in the window.
  std::optional<float> water_level() const {
    const paving::Look& look = surface_.pavement.look;
    if (!paving::water_level_mm(look, {0.0})) return std::nullopt;
    std::vector<double> faces(surface_.stones.size());
    parallel_for_chunks(faces.size(), stones_at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const vec2 centre = geometry::centroid(surface_.stones[s].outline_mm);
        faces[s] = geometry::height_at(laid_.patches(s, laid_.draws(s)), centre);
      }
    });
    const std::optional<double> level = paving::water_level_mm(look, std::move(faces));
    return level ? std::optional(static_cast<float>(*level)) : std::nullopt;
  }

  struct Rows {
    std::size_t first = 0;
    std::size_t last = 0;  // inclusive
  };
  // The bands that a stone lies in.
  Rows bands_of(const Placed& placed) const {
    const geometry::Box box = box_of(surface_, placed.stone);
    const double rows = static_cast<double>(band_rows_ * samples_);
    const auto band = [&](double y) {
      return static_cast<std::size_t>(std::clamp(std::floor(y / rows), 0.0, static_cast<double>(bands_ - 1)));
    };
    return {band(in_samples(box.high + placed.by).y - 1.0), band(in_samples(box.low + placed.by).y + 1.0)};
  }

  // Count, offsets, fill: the stones of each band, in their order.
  void list_bands() {
    const std::size_t most = std::min(most_rows, std::max<std::size_t>(8, map_.rows() / fewest_bands));
    band_rows_ = std::clamp<std::size_t>(band_samples / (columns() * samples_), 4, most);
    bands_ = (map_.rows() + band_rows_ - 1) / band_rows_;
    first_.assign(bands_ + 1, 0);
    for (const Placed& placed : placed_) {
      const Rows in = bands_of(placed);
      for (std::size_t band = in.first; band <= in.last; ++band) ++first_[band + 1];
    }
    for (std::size_t band = 0; band < bands_; ++band) first_[band + 1] += first_[band];
    listed_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t p = 0; p < placed_.size(); ++p) {
      const Rows in = bands_of(placed_[p]);
      for (std::size_t band = in.first; band <= in.last; ++band) listed_[next[band]++] = static_cast<std::uint32_t>(p);
    }
  }

  void draw_stone(const Placed& placed, Band& band) const {
    const paving::Stone& stone = surface_.stones[placed.stone];
    const geometry::Box box = box_of(surface_, placed.stone);
    const vec2 low = in_samples(vec2{box.low.x, box.high.y} + placed.by);
    const vec2 high = in_samples(vec2{box.high.x, box.low.y} + placed.by);
    const double band_top = static_cast<double>(band.first_row);
    const double left = std::max(0.0, std::ceil(low.x));
    const double top = std::max(band_top, std::ceil(low.y));
    const double right = std::min(static_cast<double>(columns()) - 1.0, std::floor(high.x));
    const double bottom = std::min(band_top + static_cast<double>(band.rows) - 1.0, std::floor(high.y));
    if (right < left || bottom < top) return;
    band.block.reset(static_cast<std::size_t>(right - left) + 1, static_cast<std::size_t>(bottom - top) + 1);
    const paving::StoneDraws draws = laid_.draws(placed.stone);
    for (geometry::BezierPatch& patch : laid_.patches(placed.stone, draws)) {
      for (vec3& p : patch.control_points) {
        const vec2 at = in_samples(vec2{p.x, p.y} + placed.by) - vec2{left, top};
        p = {at.x, at.y, p.z};
      }
      fill_patch(patch, band.block);
    }
    const vec2 from_centre = of_sample({left, top}) - placed.by - geometry::centroid(stone.outline_mm);
    lay_stone(placed.stone + 1, draws, from_centre, {left, top}, band);
  }

  // Takes the block of a stone over into the band, with its relief, where it stands above the joint. `from_centre` is where the
  // block's first sample lies, in mm; `corner` the same in samples.
  void lay_stone(std::uint32_t stone, const paving::StoneDraws& draws, vec2 from_centre, vec2 corner, Band& band) const {
    const auto relief = static_cast<float>(draws.relief);
    const vec2 place = draws.relief_place + from_centre / surface_.fields.relief_side_mm;
    const vec2 step = sample_mm() / surface_.fields.relief_side_mm;
    const auto left = static_cast<std::size_t>(corner.x);
    const auto top = static_cast<std::size_t>(corner.y);
    const std::uint32_t step_u = PeriodicField::phase_step(step.x);
    for (std::size_t y = 0; y < band.block.height(); ++y) {
      const float* block = band.block.row(y);
      const std::size_t at = (top + y - band.first_row) * columns() + left;
      const std::uint32_t v = PeriodicField::phase(place.y - static_cast<double>(y) * step.y);
      std::uint32_t u = PeriodicField::phase(place.x);
      for (std::size_t x = 0; x < band.block.width(); ++x, u += step_u) {
        if (block[x] == HeightBlock::nothing) continue;
        if (block[x] < bed_.top_mm() && block[x] < bed_height(left + x, top + y)) continue;
        const float height = block[x] + (relief_ ? relief * relief_->at(u, v) : 0.0F);
        if (height <= band.height[at + x]) continue;
        band.height[at + x] = height;
        band.stone[at + x] = stone;
      }
    }
  }

  float bed_height(std::size_t column, std::size_t row) const {
    return bed_.height_mm(bed_.grain(bed_x(column), bed_y(row))) + sunk(column, row);
  }
  // At most 0, as the height of the ground there.
  float sunk(std::size_t column, std::size_t row) const {
    if (laid_.is_level()) return 0.0F;
    return static_cast<float>(laid_.ground(of_sample({static_cast<double>(column), static_cast<double>(row)})).height_mm);
  }
  Bed::Phase bed_x(std::size_t column) const {
    const auto halo = static_cast<double>(map_.halo * samples_);
    return bed_.phase_x((static_cast<double>(column) + 0.5 - halo) / static_cast<double>(map_.grid.width * samples_));
  }
  Bed::Phase bed_y(std::size_t row) const {
    const auto halo = static_cast<double>(map_.halo * samples_);
    return bed_.phase_y((static_cast<double>(row) + 0.5 - halo) / static_cast<double>(map_.grid.height * samples_));
  }

  void fill_joints(Band& band) const {
    std::vector<Bed::Phase> x(columns());
    for (std::size_t column = 0; column < columns(); ++column) x[column] = bed_x(column);
    for (std::size_t row = 0; row < band.rows; ++row) {
      const Bed::Phase y = bed_y(band.first_row + row);
      float* height = &band.height[row * columns()];
      const std::uint32_t* stone = &band.stone[row * columns()];
      for (std::size_t column = 0; column < columns(); ++column) {
        if (stone[column] == 0) height[column] = bed_.height_mm(bed_.grain(x[column], y)) + sunk(column, band.first_row + row);
      }
    }
  }

  void put_pixels(const Band& band, std::size_t row, std::size_t to_row) const {
    const auto count = static_cast<float>(samples_ * samples_);
    std::array<std::uint32_t, 16> found{};
    for (std::size_t column = 0; column < map_.row_length(); ++column) {
      float sum = 0.0F;
      std::size_t stones = 0;
      std::size_t n = 0;
      for (std::size_t j = 0; j < samples_; ++j) {
        const std::size_t at = (row * samples_ + j) * columns() + column * samples_;
        for (std::size_t i = 0; i < samples_; ++i) {
          sum += band.height[at + i];
          found[n++] = band.stone[at + i];
          if (band.stone[at + i] != 0) ++stones;
        }
      }
      const std::size_t pixel = to_row * map_.row_length() + column;
      map_.height_mm[pixel] = std::max(sum / count, map_.water_mm.value_or(HeightBlock::nothing));
      map_.stone[pixel] = most_of(found.data(), n);
      map_.cover[pixel] = static_cast<std::uint8_t>((stones * 255 + n / 2) / n);
    }
  }

  // The stone with the most samples, the first of those with as many; 0 where there is none.
  static std::uint32_t most_of(const std::uint32_t* found, std::size_t count) {
    if (std::all_of(found, found + count, [&](std::uint32_t stone) { return stone == found[0]; })) return found[0];
    std::uint32_t best = 0;
    std::ptrdiff_t most = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (found[k] == 0) continue;
      const std::ptrdiff_t times = std::count(found, found + count, found[k]);
      if (times < most || (times == most && best <= found[k])) continue;
      most = times;
      best = found[k];
    }
    return best;
  }

  const Surface& surface_;
  std::size_t samples_;
  SurfaceMap& map_;
  Bed bed_;
  paving::LaidSurface laid_;
  std::optional<PeriodicField> relief_;
  std::vector<Placed> placed_;
  std::size_t band_rows_ = 1;  // of pixels
  std::size_t bands_ = 0;
  std::vector<std::size_t> first_;  // stones of band b are listed_[first_[b] … first_[b + 1])
  std::vector<std::uint32_t> listed_;
};

}  // namespace

paving::LaidSurface laid_surface(const Surface& surface, const PixelGrid& grid) {
  return {surface.pavement, surface.stones, surface.seed, surface.periodic ? std::optional(grid.size_mm()) : std::nullopt};
}

std::size_t samples_for(const paving::Pavement& pavement, const PixelGrid& grid) {
  const double pixel = std::max(grid.pixel_mm.x, grid.pixel_mm.y);
  const double stone = std::min(pavement.stone_mm.x, pavement.stone_mm.y);
  double wanted = samples_to_stone * pixel / stone;
  if (pavement.joint_mm > 0.0) wanted = std::max(wanted, samples_to_joint * pixel / pavement.joint_mm);
  return static_cast<std::size_t>(std::clamp(std::ceil(wanted), fewest_samples, most_samples));
}

SurfaceMap surface_map(const Surface& surface, const PixelGrid& grid, std::size_t halo, std::size_t samples) {
  ENSURE(grid.width > 0 && grid.height > 0 && samples >= 1 && samples <= 4);
  ENSURE(surface.stones.size() < UINT32_MAX);
  SurfaceMap map;
  map.grid = grid;
  map.halo = halo;
  const std::size_t pixels = map.row_length() * map.rows();
  map.height_mm.resize(pixels);
  stop_if_cancelled();
  map.stone.resize(pixels);
  stop_if_cancelled();
  map.cover.resize(pixels);
  const Drawing drawing(surface, samples, map);
  parallel_for(drawing.bands(), [&](std::size_t band) { drawing.draw_band(band); });
  return map;
}

}  // namespace shatterpave::exporting::textures
