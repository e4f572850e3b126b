// Questions about the bond of a pavement. The bonds and their traits stand in paving/bonds/table.h.
//
// A bond is a division of the plane into tiles, half a joint wider all round than its stones; cutting at the outline, joining
// of small pieces and taking off the joint are the same as for packed stones (paving/tiles/cutting.h). What is needed is a map
// from the plane of the bond to the area, along the direction of the rows:
//   - one direction: exact for every bond;
//   - circles: rows (running, stack) become rings with a whole number of stones each. Stones take what the circle demands, in
//     sides that converge a little; joints stay parallel;
//   - curves (boundary, guides): rows keep their distance to the line that they follow, with perpends across; where rows from
//     different lines meet they are mitred.
// No pattern that is more than rows can be bent without wedges or steps. A good paviour then lays it straight, in the main
// direction, and cuts it at the borders; so does this: patterns on circles and curves lie along `main_direction`.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/tiles/pattern.h"
#include "paving/tiles/stock.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// The one direction of a pattern that does not bend: the constant direction; +x for a radial one; for a boundary the outline's
// longest side; for guides the way from the first to the last point of the
// longest; for a grid the mean axis of its vectors.
Angle main_direction(const Pavement& pavement);

// The angle of an axis, whose sign means nothing, in (−90°, 90°].
Angle axis_angle(vec2 axis);

// Whether the rows of the pavement bend: its bond can, and its direction, or the size of its stones, is not the same
// everywhere.
bool is_bent(const Pavement& pavement);
// Whether the seed decides where stones are set out.
bool is_drawn(const Pavement& pavement);
// How far a straight side may stray into its joint, as a part of the joint: where stones are packed along a bend.
double side_bulge(const Pavement& pavement);

// The pattern of a bond that repeats, packed stones in one direction among them, with u along the rows; nothing where rows bend
// or stones are mixed at random.
std::optional<Pattern> periodic_pattern(const Pavement& pavement);
// The direction of its u.
Angle pattern_direction(const Pavement& pavement);

// The tiles of the pavement's bond, which is not `packed`, over all of the area: they may reach beyond its border.
std::vector<Tile> bond_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t seed);

// The stock that the stones of the bond are cut from, along their axis and across it. None that is laid is larger, whole or
// cut. Each bond's row says what it is.
Stock stock(const Pavement& pavement);

// The face of a usual whole stone of the bond, mm²: what a small piece is measured by.
double whole_face_mm2(const Pavement& pavement);

}  // namespace shatterpave::paving
