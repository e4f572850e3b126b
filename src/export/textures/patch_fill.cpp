// A patch is cut into small four-sided pieces along lines of constant u and v, and each of those into two triangles with linear
// heights. Pieces are about `piece` samples wide, so that the slope jumps from one triangle to the next by less than a normal
// map of 8 bits can tell; on small patches they are smaller, so that nothing lies more than a tenth of a sample beside its
// place.
#include "export/textures/patch_fill.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shatterpave::exporting::textures {

namespace {

using geometry::BezierPatch;

constexpr double piece = 4.0;
constexpr double most_pieces = 1024.0;

// Of the paper's patch with D = 0.1 the place on a line of length L goes as L times a cubic whose second derivative is at most
// 5, so that n pieces err by 5/8 L / n²: a tenth of a sample for n = 2.5 √L.
constexpr double pieces_of_root = 2.5;

// Triangles are this much larger than they are (in samples), so that rounding leaves no gap between two: coordinates in a block
// are below 2^17 at worst, so that floats, of 24 bits, err by 2^-8 there and by 2^-11 in blocks of up to 2^13 samples.
constexpr float margin = 1.0F / 512.0F;

struct Vertex {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
};

struct Bernstein {
  float b0 = 1.0F;
  float b1 = 0.0F;
  float b2 = 0.0F;
  float b3 = 0.0F;
};

Bernstein bernstein(float t) {
  const float s = 1.0F - t;
  return {s * s * s, 3.0F * s * s * t, 3.0F * s * t * t, t * t * t};
}

Vertex mixed(const Bernstein& b, const Vertex& p0, const Vertex& p1, const Vertex& p2, const Vertex& p3) {
  return {b.b0 * p0.x + b.b1 * p1.x + b.b2 * p2.x + b.b3 * p3.x, b.b0 * p0.y + b.b1 * p1.y + b.b2 * p2.y + b.b3 * p3.y,
          b.b0 * p0.z + b.b1 * p1.z + b.b2 * p2.z + b.b3 * p3.z};
}

// The pieces along u, or along v: by the longest control polygon that way.
std::size_t pieces(const BezierPatch& patch, bool along_u) {
  double longest = 0.0;
  for (std::size_t line = 0; line < 4; ++line) {
    double length = 0.0;
    for (std::size_t k = 1; k < 4; ++k) {
      const vec3 d = along_u ? patch.at(k, line) - patch.at(k - 1, line) : patch.at(line, k) - patch.at(line, k - 1);
      length += std::sqrt(d.x * d.x + d.y * d.y);
    }
    longest = std::max(longest, length);
  }
  const double wanted = std::max(longest / piece, pieces_of_root * std::sqrt(longest));
  return static_cast<std::size_t>(std::clamp(std::ceil(wanted), 1.0, most_pieces));
}

// Raises `count` samples from `first` on to heights that start at `z` and rise by `slope`, within `low` and `high`.
void raise(float* row, int first, int last, float z, float slope, float low, float high) {
  for (int k = first; k <= last; ++k) {
    const float height = std::min(high, std::max(low, z + slope * static_cast<float>(k)));
    row[k] = std::max(row[k], height);
  }
}

// Where the line from a to b, a.y <= b.y, is at height y.
float crossing(const Vertex& a, const Vertex& b, float y) {
  const float rise = b.y - a.y;
  return rise > 0.0F ? a.x + (b.x - a.x) * ((y - a.y) / rise) : a.x;
}

void fill_triangle(Vertex a, Vertex b, Vertex c, HeightBlock& block) {
  const float twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (twice == 0.0F) return;
  const float slope_x = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / twice;
  const float slope_y = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / twice;
  const float low = std::min({a.z, b.z, c.z});
  const float high = std::max({a.z, b.z, c.z});
  if (b.y < a.y) std::swap(a, b);
  if (c.y < b.y) std::swap(b, c);
  if (b.y < a.y) std::swap(a, b);
  const float top = std::max(0.0F, std::ceil(a.y - margin));
  const float bottom = std::min(static_cast<float>(block.height()) - 1.0F, std::floor(c.y + margin));
  for (float y = top; y <= bottom; y += 1.0F) {
    const float at = std::clamp(y, a.y, c.y);
    const float one = crossing(a, c, at);
    const float other = at < b.y ? crossing(a, b, at) : crossing(b, c, at);
    const float left = std::max(0.0F, std::ceil(std::min(one, other) - margin));
    const float right = std::min(static_cast<float>(block.width()) - 1.0F, std::floor(std::max(one, other) + margin));
    if (right < left) continue;
    raise(block.row(static_cast<std::size_t>(y)), static_cast<int>(left), static_cast<int>(right),
          a.z + slope_y * (y - a.y) - slope_x * a.x, slope_x, low, high);
  }
}

// Whether a row of vertices and the next lie above the block, below it, or beside it.
bool outside(const std::vector<Vertex>& line, const std::vector<Vertex>& next, const HeightBlock& block) {
  float low = line.front().y;
  float high = low;
  for (const auto* vertices : {&line, &next}) {
    for (const Vertex& v : *vertices) {
      low = std::min(low, v.y);
      high = std::max(high, v.y);
    }
  }
  return high < -1.0F || low > static_cast<float>(block.height());
}

}  // namespace

void fill_patch(const BezierPatch& patch, HeightBlock& block) {
  std::array<Vertex, 16> control;
  for (std::size_t i = 0; i < control.size(); ++i) {
    const vec3& p = patch.control_points[i];
    control[i] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }
  const std::size_t rows = pieces(patch, true);
  const std::size_t columns = pieces(patch, false);
  std::vector<Bernstein> across(columns + 1);
  for (std::size_t k = 0; k <= columns; ++k) across[k] = bernstein(static_cast<float>(k) / static_cast<float>(columns));
  std::vector<Vertex> line(columns + 1);
  std::vector<Vertex> next(columns + 1);
  for (std::size_t i = 0; i <= rows; ++i) {
    const Bernstein b = bernstein(static_cast<float>(i) / static_cast<float>(rows));
    std::array<Vertex, 4> curve;
    for (std::size_t j = 0; j < 4; ++j) curve[j] = mixed(b, control[j], control[4 + j], control[8 + j], control[12 + j]);
    std::swap(line, next);
    for (std::size_t k = 0; k <= columns; ++k) next[k] = mixed(across[k], curve[0], curve[1], curve[2], curve[3]);
    if (i == 0 || outside(line, next, block)) continue;
    for (std::size_t k = 0; k < columns; ++k) {
      fill_triangle(line[k], line[k + 1], next[k + 1], block);
      fill_triangle(line[k], next[k + 1], next[k], block);
    }
  }
}

}  // namespace shatterpave::exporting::textures
