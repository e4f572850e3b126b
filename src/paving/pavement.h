// What a scene may say of a pavement.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/angle.h"
#include "geometry/polygon.h"
#include "paving/texture_set.h"

namespace shatterpave::paving {

// Rows run along one direction everywhere.
struct ConstantDirection {
  Angle angle;  // axis of the rows, from +x
  bool operator==(const ConstantDirection&) const = default;
};

// Rows follow the nearest side of the outline or of a hole.
struct BoundaryDirection {
  bool operator==(const BoundaryDirection&) const = default;
};

// Rows are circles about a centre.
struct RadialDirection {
  vec2 centre_mm{0.0, 0.0};
  bool operator==(const RadialDirection&) const = default;
};

// Rows follow polylines; between them the direction is interpolated.
struct GuidesDirection {
  std::vector<std::vector<vec2>> guides_mm;  // one or more, each of two or more distinct points
  bool operator==(const GuidesDirection&) const = default;
};

using Direction = std::variant<ConstantDirection, BoundaryDirection, RadialDirection, GuidesDirection>;

// The bond: the rule by which stones are laid. What each makes of `stone_mm` is told in paving/bond.h.
enum class Bond {
  packed,         // square packing along the direction field (Miyata and Itoh §3)
  running,        // rows, each moved on against the last
  stack,          // rows with their perpends in line
  herringbone,    // oblong stones at right angles, in steps
  basket_weave,   // pairs (or more) of oblong stones, turned by turns
  hexagon,        // honeycomb
  segmental_arc,  // rows of setts in flat arcs, side by side
  fan,            // setts in rings about the feet of fans, which overlap like scales
  ashlar,         // rectangles of several sizes, mixed at random
  crazy           // irregular polygons (Voronoi cells, as §5 of Miyata and Itoh suggests for natural stone)
};

struct Bonding {
  Bond bond = Bond::packed;
  double offset = 0.5;   // running: how far each row moves on, as a part of a stone, 0 … 1
  Angle turn;            // of the pattern against the rows; herringbone: 0° or 45° are usual
  double span_mm = 0.0;  // segmental arc, fan: width of an arc or a fan, >= 0; 0: twelve stones
  bool operator==(const Bonding&) const = default;
};

// A course of stones along the outline and holes, within which the bond lies; mitred at corners.
enum class BorderCourse {
  none,
  soldier,   // stones stand with their short side along the border
  stretcher  // or lie with the long one
};

struct Border {
  BorderCourse course = BorderCourse::none;
  vec2 stone_mm{0.0, 0.0};  // along the border, across it; 0, 0: the pavement's own stones
  bool operator==(const Border&) const = default;
};

// The upper surface of a stone: a cubic Bézier patch over its outline (§4 (1) of Miyata and Itoh). Values are means;
// each stone draws its own within ± its spread (a fraction of the mean).
struct StoneSurface {
  double height_mm = 18.0;      // height of the four inner control points above the border, >= 0
  double height_spread = 0.25;  // 0 … 1
  double inset = 0.10;          // D: distance of the inner control points from the sides, as a fraction of the stone, 0 … 0.5
  double inset_spread = 0.3;    // 0 … 1
  bool operator==(const StoneSurface&) const = default;
};

// How stones differ from the places that the bond gives them; each draws its own, evenly within ± the value. A stone moves no
// corner farther than into its half of the joint (three tenths of the joint along bent rows, whose sides are straight),
// whatever is asked: so stones never touch and never leave the area.
struct Variation {
  double size = 0.0;       // larger or smaller by this part, 0 … 0.5
  Angle rotation;          // 0 … 45°
  double offset_mm = 0.0;  // along x and along y, >= 0
  double sink_mm = 0.0;    // lower by up to this, >= 0
  double missing = 0.0;    // part of the stones that are not there, 0 … 1
  bool operator==(const Variation&) const = default;
};

// Micro relief: a fractal surface on top (§4 (2)).
struct Relief {
  double rms_mm = 0.6;  // root mean square of the height, >= 0; 0 leaves it out
  double hurst = 0.7;   // Hurst exponent, 0 … 1: near 0 is gritty, near 1 is smooth
  bool operator==(const Relief&) const = default;
};

struct Pavement {
  std::string name;             // unique in its scene, an identifier: letters, digits, '_' and '-'
  geometry::Region area;        // the paved area, mm
  vec2 stone_mm{100.0, 100.0};  // face of a whole stone: along the rows, across them; > 0
  double joint_mm = 8.0;        // between faces of neighbours, >= 0; half of it stays free along outline and holes
  Direction direction;
  Bonding bonding;
  Border border;
  StoneSurface surface;
  Variation variation;
  Relief relief;
  TextureSet textures;

  bool operator==(const Pavement&) const = default;
};

}  // namespace shatterpave::paving
