#include "relief/out_of_focus.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace shatterpave::relief {

namespace {

// Of a disc's diameter: pixels of the result, and rows in which it is added up at the least. By eye: the rims of discs then
// look round at any size.
constexpr double pixels_a_disc = 12.0;
constexpr double rows_a_disc = 16.0;
constexpr std::size_t widest_px = 4096;
constexpr double most_rows_a_disc = 128.0;
constexpr std::size_t band_rows = 32;  // of the result that share the sums of the rows that they look at

// Rows of a lat-long picture, each divided into `parts` so that narrow discs meet enough of them.
struct Rows {
  double count = 0.0;  // of parts from pole to pole

  Angle elevation(double row) const { return Angle::radians(pi * (0.5 - (row + 0.5) / count)); }
};

// Sums along rows of a picture from the first pixel up to each, from row `first` on.
class RowSums {
 public:
  RowSums(const Raster& picture, std::size_t first, std::size_t end)
      : picture_(picture), first_(first), stride_((picture.width + 1) * picture.channels), sums_((end - first) * stride_) {
    for (std::size_t row = first; row < end; ++row) {
      double* to = sums_.data() + (row - first) * stride_;
      const float* from = picture.values.data() + row * picture.width * picture.channels;
      for (std::size_t i = 0; i < picture.width * picture.channels; ++i)
        to[i + picture.channels] = to[i] + static_cast<double>(from[i]);
    }
  }

  // Adds `weight` times what lies in that row between two places, in pixels; `from` may be below 0 and `to` beyond the width by
  // up to a whole round.
  void add(std::size_t row, double from, double to, double weight, std::vector<double>& sum) const {
    const double* sums = sums_.data() + (row - first_) * stride_;
    const double* all = sums + picture_.width * picture_.channels;
    const Mark low = mark(from);
    const Mark high = mark(to);
    for (std::size_t c = 0; c < picture_.channels; ++c) {
      sum[c] += weight * ((high.rounds - low.rounds) * all[c] + (up_to(sums, high, c) - up_to(sums, low, c)));
    }
  }

 private:
  // A place along a row.
  struct Mark {
    double rounds = 0.0;    // whole ones before it
    std::size_t first = 0;  // of the sums before its pixel
    double part = 0.0;      // of that pixel
  };

  Mark mark(double place) const {
    const auto width = static_cast<double>(picture_.width);
    const double rounds = std::floor(place / width);
    const double within = place - rounds * width;
    const std::size_t pixel = std::min(static_cast<std::size_t>(within), picture_.width - 1);
    return {rounds, pixel * picture_.channels, within - static_cast<double>(pixel)};
  }

  double up_to(const double* sums, const Mark& mark, std::size_t channel) const {
    const double before = sums[mark.first + channel];
    return before + mark.part * (sums[mark.first + picture_.channels + channel] - before);
  }

  const Raster& picture_;
  std::size_t first_;
  std::size_t stride_;
  std::vector<double> sums_;
};

// Half of the part of a row at the elevation `there` that lies within `radius` of a place at the elevation `here`, as an angle
// about the upright: 0 … pi.
double half_chord(vec2 here, vec2 there, double cosine_of_radius) {
  const double crossing = here.x * there.x;
  const double reached = cosine_of_radius - here.y * there.y;
  if (reached >= crossing) return 0.0;
  if (reached <= -crossing) return pi;
  return arccosine(reached / crossing);
}

class Blur {
 public:
  Blur(const Raster& sharp, Angle diameter, Raster& blurred)
      : sharp_(sharp),
        blurred_(blurred),
        radius_(0.5 * diameter),
        cosine_(radius_.direction().x),
        parts_(static_cast<std::size_t>(
            std::ceil(std::max(1.0, rows_a_disc * pi / diameter.radians() / static_cast<double>(sharp.height))))),
        rows_{static_cast<double>(sharp.height * parts_)} {}

  // Rows `begin` … `end` of the result.
  void draw(std::size_t begin, std::size_t end) const {
    const Rows to{static_cast<double>(blurred_.height)};
    const std::size_t first = row_at(to.elevation(static_cast<double>(begin)) + radius_);
    const std::size_t last = row_at(to.elevation(static_cast<double>(end - 1)) - radius_);
    const RowSums sums(sharp_, first / parts_, last / parts_ + 1);
    for (std::size_t row = begin; row < end; ++row) draw_row(sums, row, to.elevation(static_cast<double>(row)));
  }

 private:
  struct Chord {
    std::size_t row = 0;  // of the sharp picture
    double half_px = 0.0;
    double weight = 0.0;
  };

  // The part of a row of the sharp picture at an elevation; beyond a pole the last one.
  std::size_t row_at(Angle elevation) const {
    const double row = std::floor(rows_.count * (0.5 - elevation.radians() / pi));
    return static_cast<std::size_t>(std::clamp(row, 0.0, rows_.count - 1.0));
  }

  std::vector<Chord> chords(Angle elevation) const {
    const std::size_t first = row_at(elevation + radius_);
    const std::size_t last = row_at(elevation - radius_);
    const vec2 here = elevation.direction();
    std::vector<Chord> chords;
    chords.reserve(last + 1 - first);
    for (std::size_t part = first; part <= last; ++part) {
      const vec2 there = rows_.elevation(static_cast<double>(part)).direction();
      const double half = half_chord(here, there, cosine_);
      if (half > 0.0) chords.push_back({part / parts_, half / (2.0 * pi) * static_cast<double>(sharp_.width), there.x});
    }
    return chords;
  }

  void draw_row(const RowSums& sums, std::size_t row, Angle elevation) const {
    const std::vector<Chord> chords = this->chords(elevation);
    double area = 0.0;
    for (const Chord& chord : chords) area += 2.0 * chord.half_px * chord.weight;
    ENSURE(area > 0.0);
    const double step = static_cast<double>(sharp_.width) / static_cast<double>(blurred_.width);
    std::vector<double> sum(sharp_.channels);
    for (std::size_t x = 0; x < blurred_.width; ++x) {
      const double middle = (static_cast<double>(x) + 0.5) * step;
      std::ranges::fill(sum, 0.0);
      for (const Chord& chord : chords) sums.add(chord.row, middle - chord.half_px, middle + chord.half_px, chord.weight, sum);
      float* pixel = blurred_.values.data() + (row * blurred_.width + x) * blurred_.channels;
      for (std::size_t c = 0; c < blurred_.channels; ++c) pixel[c] = static_cast<float>(sum[c] / area);
    }
  }

  const Raster& sharp_;
  Raster& blurred_;
  Angle radius_;
  double cosine_;
  std::size_t parts_;
  Rows rows_;
};

// Of half as many pixels across and down.
Raster halved(const Raster& picture) {
  const std::size_t stride = picture.width * picture.channels;
  Raster half{picture.width / 2, picture.height / 2, picture.channels, std::vector<float>(picture.values.size() / 4)};
  parallel_for(half.height, [&](std::size_t row) {
    for (std::size_t i = 0; i < half.width * half.channels; ++i) {
      const std::size_t from = 2 * row * stride + i / half.channels * 2 * half.channels + i % half.channels;
      const auto& v = picture.values;
      half.values[row * half.width * half.channels + i] =
          0.25F * ((v[from] + v[from + half.channels]) + (v[from + stride] + v[from + stride + half.channels]));
    }
  });
  return half;
}

}  // namespace

Raster out_of_focus(const Raster& sharp, Angle diameter) {
  ENSURE(sharp.width == 2 * sharp.height && sharp.height > 0);
  ENSURE(diameter >= Angle() && diameter <= widest_blur);
  if (diameter == Angle()) return sharp;
  const double wanted = std::ceil(pixels_a_disc * 180.0 / diameter.degrees() - 1e-6);
  const std::size_t most = std::max(widest_px, sharp.width) / 2;
  const auto height = static_cast<std::size_t>(std::min(wanted, static_cast<double>(most)));
  Raster blurred{2 * height, height, sharp.channels, std::vector<float>(2 * height * height * sharp.channels)};
  // Wide discs see nothing of fine pixels, whose sums would fill the memory.
  Raster coarse;
  const Raster* from = &sharp;
  while (static_cast<double>(from->height) * diameter.radians() / pi > most_rows_a_disc && from->height % 2 == 0) {
    coarse = halved(*from);
    from = &coarse;
  }
  const Blur blur(*from, diameter, blurred);
  parallel_for_chunks(height, band_rows, [&](std::size_t begin, std::size_t end) { blur.draw(begin, end); });
  return blurred;
}

}  // namespace shatterpave::relief
