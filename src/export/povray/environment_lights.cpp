#include "export/povray/environment_lights.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "studio/light.h"

namespace shatterpave::exporting::povray {

namespace {

constexpr std::size_t most_columns = 512;
constexpr std::size_t channels = 3;

// Of the picture's parts of this cell.
struct Cell {
  vec3 flux{0.0, 0.0, 0.0};
  vec3 towards{0.0, 0.0, 0.0};  // directions times brightness

  void add(const Cell& other) {
    flux += other.flux;
    towards += other.towards;
  }
};

// As the eye weighs the primaries of sRGB (Rec. 709).
double brightness(vec3 colour) { return glm::dot(colour, vec3{0.2126, 0.7152, 0.0722}); }

class Cells {
 public:
  explicit Cells(const relief::Raster& picture)
      : columns_(std::min(picture.width, most_columns)),
        rows_(std::max<std::size_t>(1, std::min(picture.height, most_columns / 2))),
        cells_(columns_ * rows_) {
    ENSURE(picture.channels == channels && picture.width > 0 && picture.height > 0);
    // Rows of cells, not of pixels, so that each is summed in one order.
    parallel_for(rows_, [&](std::size_t row) {
      const std::size_t end = (row + 1) * picture.height / rows_;
      for (std::size_t y = row * picture.height / rows_; y < end; ++y) add_row(picture, y, row);
    });
  }

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  const Cell& at(std::size_t column, std::size_t row) const { return cells_[row * columns_ + column]; }

 private:
  void add_row(const relief::Raster& picture, std::size_t y, std::size_t row) {
    const auto height = static_cast<double>(picture.height);
    const auto width = static_cast<double>(picture.width);
    const auto upper = pi * static_cast<double>(y) / height;
    // Of a pixel: the exact part of the sphere.
    const double solid_angle = 2.0 * pi / width * (cosine(upper) - cosine(upper + pi / height));
    for (std::size_t x = 0; x < picture.width; ++x) {
      const float* const value = &picture.values[(y * picture.width + x) * channels];
      const vec3 flux =
          solid_angle * vec3{static_cast<double>(value[0]), static_cast<double>(value[1]), static_cast<double>(value[2])};
      const vec3 towards =
          studio::direction_of({(static_cast<double>(x) + 0.5) / width, (static_cast<double>(y) + 0.5) / height}, Angle());
      cells_[row * columns_ + x * columns_ / picture.width].add({flux, brightness(flux) * towards});
    }
  }

  std::size_t columns_;
  std::size_t rows_;
  std::vector<Cell> cells_;
};

struct Part {
  std::size_t left = 0;
  std::size_t top = 0;
  std::size_t right = 0;  // the first that does not belong to it
  std::size_t bottom = 0;
};

Cell sum(const Cells& cells, const Part& part) {
  Cell total;
  for (std::size_t row = part.top; row < part.bottom; ++row) {
    for (std::size_t column = part.left; column < part.right; ++column) total.add(cells.at(column, row));
  }
  return total;
}

bool is_cut_across_columns(const Cells& cells, const Part& part) {
  const double middle = pi * (static_cast<double>(part.top + part.bottom) / 2.0) / static_cast<double>(cells.rows());
  const double wide =
      static_cast<double>(part.right - part.left) * 2.0 * pi / static_cast<double>(cells.columns()) * sine(middle);
  const double high = static_cast<double>(part.bottom - part.top) * pi / static_cast<double>(cells.rows());
  if (part.right - part.left == 1) return false;
  return part.bottom - part.top == 1 || wide >= high;
}

void cut(const Cells& cells, const Part& part, int cuts, std::vector<FarLight>& lights) {
  const Cell whole = sum(cells, part);
  const double all = brightness(whole.flux);
  if (all <= 0.0) return;
  const bool is_single = part.right - part.left == 1 && part.bottom - part.top == 1;
  if (cuts == 0 || is_single) {
    const double length = glm::length(whole.towards);
    // Where all of it cancels out, as of an even sphere, any direction will do.
    lights.push_back({length > 0.0 ? whole.towards / length : vec3{0.0, 0.0, 1.0}, whole.flux});
    return;
  }
  const bool across = is_cut_across_columns(cells, part);
  const std::size_t begin = across ? part.left : part.top;
  const std::size_t end = across ? part.right : part.bottom;
  // The line behind which the sum is nearest to one half.
  std::size_t at = begin + 1;
  double before = 0.0;
  for (std::size_t line = begin; line + 1 < end; ++line) {
    const Part strip = across ? Part{line, part.top, line + 1, part.bottom} : Part{part.left, line, part.right, line + 1};
    const double with = before + brightness(sum(cells, strip).flux);
    at = line + 1;
    if (2.0 * with >= all) {
      if (line > begin && all - 2.0 * before < 2.0 * with - all) at = line;
      break;
    }
    before = with;
  }
  Part first = part;
  Part second = part;
  (across ? first.right : first.bottom) = at;
  (across ? second.left : second.top) = at;
  cut(cells, first, cuts - 1, lights);
  cut(cells, second, cuts - 1, lights);
}

}  // namespace

std::vector<FarLight> far_lights(const relief::Raster& panorama, int cuts) {
  const Cells cells(panorama);
  std::vector<FarLight> lights;
  cut(cells, {0, 0, cells.columns(), cells.rows()}, cuts, lights);
  return lights;
}

}  // namespace shatterpave::exporting::povray
