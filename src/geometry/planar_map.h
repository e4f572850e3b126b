// The faces into which segments of the lattice divide the plane. Exact: nothing is rounded, and every decision is made in
// integers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/segment_index.h"

namespace shatterpave::geometry {

// A segment on the border of a face.
struct FaceSide {
  std::size_t segment = 0;  // index into the segments that the map was made of
  bool forward = true;      // from its a to its b; the face lies on the left
  LatticePoint from;

  bool operator==(const FaceSide&) const = default;
};

// Sides in succession: each ends where the next one begins, the last where the first begins. No vertex comes twice.
using FaceRing = std::vector<FaceSide>;

struct Face {
  FaceRing outline;                // counter-clockwise
  std::vector<FaceRing> holes;     // clockwise; they may touch the outline and one another in single points
  std::vector<std::size_t> spurs;  // segments with this face on both sides: they end inside it, or lead to a hole

  bool operator==(const Face&) const = default;
};

// The bounded faces, in an order that depends on that of the segments only.
//   segments  no two share more than an end of both; none is a single point; none is given twice
// Every segment that is not a spur, and that has bounded faces on both sides, is on the border of two; else of one.
//
// Where the first segments are a rim, a ring counter-clockwise about all others, `outward` holds for each of them a direction
// that points out of the ring at its a. At vertices of the rim all else then counts as inside, whichever way it goes: so lines
// may end beside the rim, on a vertex that bends it to them, and run along it within the width of that bend. Faces that such
// lines enclose may be without area; those count as holes of their neighbours.
std::vector<Face> faces(std::span<const Segment> segments, std::span<const LatticePoint> outward = {});

// Twice the signed area: positive for counter-clockwise; in µm².
std::int64_t doubled_area(const FaceRing& ring);
std::int64_t doubled_area(const Face& face);
std::int64_t doubled_area(std::span<const LatticePoint> ring);

}  // namespace shatterpave::geometry
