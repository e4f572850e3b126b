// The direction of the rows at every place of a pavement (§3 of Miyata and Itoh: "the vector field that the particles line
// up with").
//
// Of a grid of vectors the direction is theirs, and interpolated between them. Along the outline, the holes or the guides the
// rows follow them; between them the direction is the smoothest that agrees with them (it solves Laplace's equation in the
// multiples of its angle). For square stones rows and columns are alike, so the field is a cross field, of which quarter turns
// mean nothing: rows along the two sides of a square corner then agree. For oblong stones only half turns mean nothing. Where
// their rows, along the border, meet at an angle, the field has a mitre (border_zones.h): it is solved in each zone by itself.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/angle.h"
#include "geometry/region_index.h"
#include "paving/field/border_zones.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

class DirectionField {
 public:
  // `area` is that of the pavement; it is not kept.
  DirectionField(const Pavement& pavement, const geometry::RegionIndex& area);

  // Unit vector along the rows at `place`, which may lie outside the area. Its sign has no meaning; in a cross field quarter
  // turns have none either. Scales stand on their corners: the rows of their cells run at 45° to the direction asked for.
  vec2 axis(vec2 place) const;
  // The axis as an angle, in (−90°, 90°], of a cross field that is not plainly of rows (boundary, guides) in (−45°, 45°].
  Angle angle(vec2 place) const;
  // Where scales point, a unit vector: along the direction asked for, on the side to which a constant direction points, circles
  // run counter-clockwise, the nearest guide runs from its first point to its last, the nearest side of the border with the
  // area to its left, the nearest vector of a grid. Only of a pavement of scales.
  vec2 heading(vec2 place) const;
  // Whether it is a cross field, in which quarter turns have no meaning.
  bool is_cross() const { return fold_ == 4; }

  // What is laid by itself: a part of the area, with a field that goes on beyond it. Empty where all of it is laid at once.
  struct Zone;
  const std::vector<Zone>& zones() const { return zones_; }

 private:
  friend class FieldGrid;

  // Directions on a square grid, as unit vectors at `fold_` times their angle.
  struct Samples {
    vec2 origin{0.0, 0.0};
    double spacing_mm = 1.0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<vec2> values;
  };

  void take(const GridDirection& grid);
  void fill_ring(std::vector<bool>& known);
  void solve(const Pavement& pavement, const geometry::RegionIndex& area);
  void part(const Pavement& pavement, const geometry::RegionIndex& area, const BorderZones& parts);
  vec2 sampled(vec2 place) const;
  vec2 asked_axis(vec2 place) const;
  vec2 sense(vec2 place) const;

  Direction direction_;
  int fold_ = 4;
  Samples samples_;
  bool on_corners_ = false;                       // of scales
  std::vector<std::pair<vec2, vec2>> guides_;     // their sides, for the sense of scales
  std::optional<geometry::RegionIndex> outline_;  // of the area, for the same
  std::vector<Zone> zones_;
  std::optional<geometry::RegionIndex> border_;  // where there are zones
  std::vector<std::uint32_t> zone_of_segment_;   // of the border
};

struct DirectionField::Zone {
  std::vector<geometry::Region> areas;
  Direction direction;  // straight, or along guides
  DirectionField field;
};

}  // namespace shatterpave::paving
