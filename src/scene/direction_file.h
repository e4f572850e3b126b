// Files with a field of vectors that rows follow.
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "geometry/polygon.h"
#include "paving/pavement.h"

namespace shatterpave::scene {

struct DirectionFile {
  paving::GridDirection grid;
  std::string sum;  // SHA-256 of its content
};

// The vectors of a file, by its ending:
//   .json  {"origin_mm": [x, y], "pitch_mm": p, "columns": n, "vectors": [[u, v], …]}: rows from the lowest, each along +x
//   .csv   a line `x_mm,y_mm,u,v`, then a vector a line in any order, on all points of a square grid
//   .exr   two channels of a picture that covers `area`, whose pixels must be square there: u and v, x and y, X and Y or R and
//   G.
//          The top of the picture is the top of the area, and v points there
// [0, 0] says nothing of its place. Throws InputError with the place in the file where a number is not finite, vectors are
// missing, too few or too many, or all are 0; at `place` where there is no such file.
DirectionFile direction_of_file(const std::filesystem::path& file, const Place& place, const geometry::Box& area);

// Whether a file of this name lies over an area.
bool covers_area(const std::filesystem::path& file);

}  // namespace shatterpave::scene
