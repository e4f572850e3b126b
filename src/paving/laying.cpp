#include "paving/laying.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "paving/cells.h"
#include "paving/cutting.h"
#include "paving/packing.h"
#include "paving/settling.h"

namespace shatterpave::paving {

namespace {

// Memory is about 1.5 kB a stone at the peak; this many fit 4 GiB.
constexpr double most_stones = 2e6;

double border_length(const geometry::RegionIndex& area) {
  double total = 0.0;
  for (const auto& s : area.segments()) total += std::sqrt(glm::dot(s.to - s.from, s.to - s.from));
  return total;
}

// Whole stones by area, and cut ones by the length of the border.
double expected_stones(const Pavement& pavement, const geometry::RegionIndex& area) {
  const vec2 pitch = pitch_mm(pavement);
  return geometry::area(pavement.area) / (pitch.x * pitch.y) + border_length(area) / std::min(pitch.x, pitch.y);
}

Place place_of(const Pavement& pavement) { return {{}, 0, 0, fmt::format("pavement '{}'", pavement.name)}; }

void check(const Pavement& pavement) {
  const Place place = place_of(pavement);
  const auto bad = [](double mm, double least) { return !(mm >= least && mm <= geometry::largest_coordinate_mm); };
  if (bad(pavement.stone_mm.x, 1.0) || bad(pavement.stone_mm.y, 1.0)) {
    throw InputError(place,
                     fmt::format("stone_mm: expected 1 or more, got [{}, {}]", pavement.stone_mm.x, pavement.stone_mm.y));
  }
  if (bad(pavement.joint_mm, 0.0))
    throw InputError(place, fmt::format("joint_mm: expected 0 or more, got {}", pavement.joint_mm));
  if (pavement.area.outline.size() < 3 || geometry::area(pavement.area.outline) == 0.0) {
    throw InputError(place, "outline: expected a polygon with an area");
  }
}

// The faces of a piece that are laid: those large enough, or else the largest.
std::vector<geometry::Polygon> laid_faces(const Piece& piece, const Pavement& pavement) {
  auto faces = faces_of(piece.outline_mm, pavement.joint_mm);
  std::ranges::stable_sort(faces, [](const auto& a, const auto& b) { return geometry::area(a) > geometry::area(b); });
  const double least = least_piece * pavement.stone_mm.x * pavement.stone_mm.y;
  while (faces.size() > 1 && geometry::area(faces.back()) < least) faces.pop_back();
  return faces;
}

}  // namespace

StoneLayout laid_stones(const Pavement& pavement, std::uint64_t seed) {
  check(pavement);
  const geometry::RegionIndex area(pavement.area);
  const double expected = expected_stones(pavement, area);
  if (expected > most_stones) {
    throw InputError(place_of(pavement),
                     fmt::format("expected at most {:.0f} stones, got an area for about {:.0f}", most_stones, expected));
  }
  const DirectionField field(pavement, area);
  const auto particles = packed_particles(pavement, area, field, seed);
  Cells cells = cells_of(particles, pitch_mm(pavement));
  const bool exact = std::holds_alternative<ConstantDirection>(pavement.direction);
  if (!exact) cells = settled_cells(std::move(cells), particles, pitch_mm(pavement), area);
  const auto pieces = pieces_within(cells, pavement, area);

  std::vector<std::vector<geometry::Polygon>> faces(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t p) { faces[p] = laid_faces(pieces[p], pavement); });
  StoneLayout layout;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (auto& face : faces[p]) {
      const auto kind = pieces[p].cut || faces[p].size() > 1 ? StoneKind::cut : StoneKind::whole;
      const Angle angle = field.angle(geometry::centroid(face));
      layout.stones.push_back({static_cast<int>(layout.stones.size()), kind, std::move(face), angle});
    }
  }
  return layout;
}

}  // namespace shatterpave::paving
