// Each patch is rolled out from its upper border, or from its middle where it is a dome. A step from vertex to vertex that runs
// h in the plane and falls by z is lengthened along g, the way the surface faces in the plane: √((h·g)² + z²) in place of h·g.
// Level steps along an arris keep their length, so that planes and cylinders are rolled out exactly.
#include "export/shapes/unrolling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shatterpave::exporting::shapes {

namespace {

using Grid = StoneMesh::Grid;

// By eye: a face leans less than this, a flank more.
constexpr double level_lean = 0.02;
constexpr double steep_lean = 0.9;
// A border that is higher than the one across by this part of the patch's rise is the upper one.
constexpr double part_of_rise = 0.35;

class Sheet {
 public:
  explicit Sheet(const StoneMesh& mesh) : mesh_(mesh), more_(mesh.bare.size(), vec2{0.0, 0.0}) {
    std::vector<const Grid*> steep;
    for (const Grid& grid : mesh_.grids) {
      if (is_steep(grid)) {
        steep.push_back(&grid);
      } else {
        roll_out(grid, {0.0, 0.0});
        done_.push_back(&grid);
      }
    }
    for (const Grid* grid : steep) roll_out(*grid, begun(*grid));
  }

  std::vector<vec2> places() && {
    for (std::size_t v = 0; v < more_.size(); ++v) more_[v] += vec2{mesh_.bare[v].x, mesh_.bare[v].y};
    return std::move(more_);
  }

 private:
  static std::size_t index(const Grid& grid, std::size_t i, std::size_t j) { return grid.first + i * (grid.columns + 1) + j; }
  static vec2 in_plane(vec3 v) { return {v.x, v.y}; }

  // Whether it goes down from below an arris.
  bool is_steep(const Grid& grid) const {
    for (const std::size_t i : {std::size_t{0}, grid.rows}) {
      for (const std::size_t j : {std::size_t{0}, grid.columns}) {
        if (glm::length(in_plane(mesh_.bare_normals[index(grid, i, j)])) < steep_lean) return false;
      }
    }
    return true;
  }

  // The row and the column to begin from: of two borders across from one another the upper one, else in the middle.
  std::size_t first_row(const Grid& grid) const {
    return first_line(grid.rows, rise(grid), [&](std::size_t i) {
      double sum = 0.0;
      for (std::size_t j = 0; j <= grid.columns; ++j) sum += mesh_.bare[index(grid, i, j)].z;
      return sum / static_cast<double>(grid.columns + 1);
    });
  }
  std::size_t first_column(const Grid& grid) const {
    return first_line(grid.columns, rise(grid), [&](std::size_t j) {
      double sum = 0.0;
      for (std::size_t i = 0; i <= grid.rows; ++i) sum += mesh_.bare[index(grid, i, j)].z;
      return sum / static_cast<double>(grid.rows + 1);
    });
  }
  template <typename Height>
  static std::size_t first_line(std::size_t last, double rise, const Height& height) {
    const double higher = height(last) - height(0);
    if (std::abs(higher) < part_of_rise * rise) return last / 2;
    return higher > 0.0 ? last : 0;
  }
  double rise(const Grid& grid) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t v = grid.first; v <= index(grid, grid.rows, grid.columns); ++v) {
      low = std::min(low, mesh_.bare[v].z);
      high = std::max(high, mesh_.bare[v].z);
    }
    return high - low;
  }

  // By how much the sheet has been lengthened where a flank begins: there an arris ends.
  vec2 begun(const Grid& grid) const {
    const std::size_t at = index(grid, grid.rows / 2, first_column(grid));
    const vec2 out = in_plane(mesh_.bare_normals[at]);
    double least = std::numeric_limits<double>::infinity();
    vec2 more{0.0, 0.0};
    for (const Grid* other : done_) {
      for (std::size_t v = other->first; v <= index(*other, other->rows, other->columns); ++v) {
        const double far = glm::length(mesh_.bare[v] - mesh_.bare[at]);
        if (far >= least) continue;
        least = far;
        more = std::max(0.0, glm::dot(more_[v], out)) * out;
      }
    }
    return more;
  }

  void roll_out(const Grid& grid, vec2 begun) {
    const std::size_t row = first_row(grid);
    const std::size_t column = first_column(grid);
    more_[index(grid, row, column)] = begun;
    for (std::size_t i = row; i-- > 0;) step(index(grid, i + 1, column), index(grid, i, column));
    for (std::size_t i = row; i < grid.rows; ++i) step(index(grid, i, column), index(grid, i + 1, column));
    for (std::size_t i = 0; i <= grid.rows; ++i) {
      for (std::size_t j = column; j-- > 0;) step(index(grid, i, j + 1), index(grid, i, j));
      for (std::size_t j = column; j < grid.columns; ++j) step(index(grid, i, j), index(grid, i, j + 1));
    }
  }

  void step(std::size_t from, std::size_t to) {
    more_[to] = more_[from];
    const vec2 facing = in_plane(mesh_.bare_normals[from] + mesh_.bare_normals[to]);
    const double lean = glm::length(facing);
    if (lean < level_lean) return;
    const vec2 out = facing / lean;
    const vec3 by = mesh_.bare[to] - mesh_.bare[from];
    const double across = std::abs(glm::dot(in_plane(by), out));
    const double longer = std::sqrt(across * across + by.z * by.z) - across;
    more_[to] += (by.z < 0.0 ? longer : -longer) * out;
  }

  const StoneMesh& mesh_;
  std::vector<vec2> more_;  // of each vertex, by how much its place differs from that in the plane
  std::vector<const Grid*> done_;
};

}  // namespace

std::vector<vec2> unrolled(const StoneMesh& mesh) { return Sheet(mesh).places(); }

}  // namespace shatterpave::exporting::shapes
