// Where gaps meet although they are to keep apart: the last look at what is made, exact on the lattice.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "glass/gaps/crack_surface.h"
#include "glass/gaps/crack_walls.h"

namespace shatterpave::glass {

// A stretch of a gap: from a column to the next.
struct GapStretch {
  std::size_t surface = 0;
  std::size_t column = 0;

  bool operator==(const GapStretch&) const = default;
};

// Of each two stretches whose triangles (`closed_triangles`) pass through one another that of the later surface, ascending,
// each once. Surfaces of one crack are not held against each other. Time goes with the number of stretches.
std::vector<GapStretch> meeting_stretches(const std::vector<CrackSurface>& surfaces);

// The walls of all paths, of whose surfaces no two meet: stretches that do are left out of the later one, with one more to
// either side. Walls that meet none stay as they are. `surface_of` gives the surface of walls of a path.
using SurfaceOf = std::function<CrackSurface(std::size_t path, const Walls& walls)>;
std::vector<std::vector<Walls>> without_meetings(std::vector<std::vector<Walls>> of_paths, const SurfaceOf& surface_of);

}  // namespace shatterpave::glass
