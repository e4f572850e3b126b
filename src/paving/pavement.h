// A pavement as it is asked for: by a scene, or by a room that makes one of another, as kerbs and steps are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/angle.h"
#include "core/overloaded.h"
#include "geometry/polygon.h"
#include "paving/texture_set.h"
#include "studio/world.h"

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
  double first_mm = 0.0;  // radius of the first circle, >= 0: nothing is laid within it
  bool operator==(const RadialDirection&) const = default;
};

// Rows follow polylines; between them the direction is interpolated.
struct GuidesDirection {
  std::vector<std::vector<vec2>> guides_mm;  // one or more, each of two or more distinct points
  bool operator==(const GuidesDirection&) const = default;
};

// Rows follow vectors that are given on a square grid (Fig. 1(a) of Miyata and Itoh), in rows from the lowest; between them the
// direction is interpolated, beyond them it is that of the nearest. Lengths and signs have no meaning; a vector of length 0
// says nothing, and its place takes what its neighbours say.
struct GridDirection {
  vec2 origin_mm{0.0, 0.0};   // of the first vector
  double pitch_mm = 1000.0;   // from one to the next, along x and along y, > 0
  std::size_t columns = 0;    // >= 2
  std::vector<vec2> vectors;  // whole rows, two or more; finite, not all 0
  bool operator==(const GridDirection&) const = default;
};

using Direction = std::variant<ConstantDirection, BoundaryDirection, RadialDirection, GuidesDirection, GridDirection>;

// How large packed stones are, as a part of `Pavement::stone_mm` each way (paving/field/size_field.h). Factors are > 0.
//
// All alike.
struct EqualSizes {
  bool operator==(const EqualSizes&) const = default;
};

// From `near` at a line to `far` from `distance_mm` on, evenly between.
struct SizeRamp {
  double near = 1.0;
  double far = 1.0;
  double distance_mm = 1000.0;  // > 0
  bool operator==(const SizeRamp&) const = default;
};

// By the distance from the outline and the holes.
struct SizesFromEdge {
  SizeRamp ramp;
  bool operator==(const SizesFromEdge&) const = default;
};

// By the distance from polylines.
struct SizesFromLines {
  SizeRamp ramp;
  std::vector<std::vector<vec2>> lines_mm;  // one or more, each of two or more distinct points
  bool operator==(const SizesFromLines&) const = default;
};

// By a grey picture that lies over the plan: `dark` where it is 0, `light` where it is 1, evenly between. Beyond it sizes are
// those of its nearest pixel.
struct SizesOfMap {
  double dark = 1.0;
  double light = 1.0;
  vec2 low_mm{0.0, 0.0};  // of the rectangle that it covers, whose upper corner is higher on both axes
  vec2 high_mm{1.0, 1.0};
  std::size_t columns = 0;   // >= 1
  std::vector<float> greys;  // 0 … 1, whole rows from the top, one or more
  bool operator==(const SizesOfMap&) const = default;
};

using Sizes = std::variant<EqualSizes, SizesFromEdge, SizesFromLines, SizesOfMap>;

// The bond: the rule by which stones are laid. What each is, and makes of `stone_mm`, is told in its file of paving/bonds.
// Ordered as the table there; `course` is the last.
enum class Bond {
  packed,         // square packing along the direction field (Miyata and Itoh §3)
  running,        // rows, each shifted against the one before
  stack,          // rows with their perpends in line
  herringbone,    // oblong stones at right angles, in steps
  basket_weave,   // blocks of two or more oblong stones, along and across by turns
  hexagon,        // honeycomb
  segmental_arc,  // rows of setts in flat arcs, side by side
  fan,            // setts in rings about the feet of fans, which overlap like scales
  ashlar,         // rectangles of several sizes, mixed at random
  crazy,          // irregular polygons (Voronoi cells, as §5 of Miyata and Itoh suggests for natural stone)
  chevron,        // planks with slanted ends, which meet in straight lines
  drawn_module,   // stones that a user drew, one repeat of them, and the two vectors by which it repeats
  course          // one row along the outline of a ring, mitred at its corners: kerbs, which no scene asks for by this name
};

// One repeat of a pattern that a user drew, as paving/bonds/module_cells.h makes it.
struct Module {
  struct Stone {
    geometry::Polygon cell_mm;  // half a joint wider all round than its face; counter-clockwise, simple
    vec2 axis{1.0, 0.0};        // unit vector along the stone
    bool operator==(const Stone&) const = default;
  };
  // Moved by all whole multiples of both vectors they pave the plane. None: one of `Pavement::stone_mm`, in rows whose perpends
  // are in line.
  std::vector<Stone> stones;
  vec2 along_mm{1.0, 0.0};      // the shortest way from a stone to the same one again
  vec2 across_mm{0.0, 1.0};     // the shortest to one side of that, its left
  double least_face_mm2 = 0.0;  // of the smallest stone; its length and width are `Pavement::stone_mm`
  bool operator==(const Module&) const = default;
};

struct Bonding {
  Bond bond = Bond::packed;
  double offset = 0.5;   // running: how far each row is shifted, as a part of a stone, 0 … 1
  Angle turn;            // of the pattern against the rows; herringbone: 0° or 45° are usual
  double span_mm = 0.0;  // segmental arc, fan: width of an arc or a fan, >= 0; 0: twelve stones
  double start = 0.0;    // running, stack: how far the first row has moved on, as a part of a stone, 0 … 1
  // Where a pattern that repeats, laid in one direction, has the corner of a whole stone, with half the joint about it: the
  // point of beginning of landscape architects. Not given: in the lower left corner of the area's box turned to the rows.
  std::optional<vec2> start_mm{};
  Module module_drawn{};  // of a drawn module
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

// How the faces of stones are worked, as the trade names it (paving/catalogue/finishes.h).
enum class Finish {
  none,  // the paper's patch, as StoneSurface says
  flat_sawn,
  bush_hammered,
  split,
  river_worn
};

// The edge between face and side.
enum class Arris { rounded, chamfered };

// What becomes of the cells of a packing in organic textures, for which Miyata and Itoh's §5 hopes to use it: bodies of their
// own, without straight sides (paving/surface/cell_body.h). `StoneSurface::height_mm` and its spread are their height.
enum class CellForm {
  stone,   // none: stones as all else here says
  cobble,  // a pebble, as round below as above
  scale    // the scale of a reptile, whose tip lies over the next ones
};

struct CellShape {
  CellForm form = CellForm::stone;
  double roundness = 0.5;  // of the outline: from 0, the cell with its corners rounded, to 1, an ellipse
  double overlap = 0.4;    // scale: how far its tip reaches into the next cells, as a part of its length, 0 … 1
  bool operator==(const CellShape&) const = default;
};

// The body of a stone with a finish: a face with a crown, arrises of one width and steep sides. `StoneSurface::height_mm` and
// its spread are then the height of the face above the filling of the joints, and the insets have no effect.
struct StoneBody {
  Finish finish = Finish::none;  // with none, nothing below has an effect
  Arris arris = Arris::rounded;
  double arris_mm = 0.0;     // width of the arris, seen from above, >= 0
  double crown_mm = 0.0;     // rise of the middle of the face over the middles of its sides, >= 0
  double uneven_mm = 0.0;    // how far the face is warped, either way, >= 0
  double wear_mm = 0.0;      // how much lower stones in the middle of the pavement are than at its border, >= 0
  double chips_per_m = 0.0;  // chips along the arrises, in the mean, >= 0; rounded ones only
  bool operator==(const StoneBody&) const = default;
};

// How stones differ from the places that the bond gives them; each draws its own, evenly within ± the value. A stone moves no
// corner farther than into its own part of the joint, whatever is asked: so stones never touch and never leave the area.
struct Variation {
  double size = 0.0;          // larger or smaller by this part, 0 … 0.5
  Angle rotation;             // 0 … 45°
  double offset_mm = 0.0;     // along x and along y, >= 0
  double sink_mm = 0.0;       // lower by up to this, >= 0
  double missing = 0.0;       // part of the stones that are not there, 0 … 1
  std::optional<Angle> tilt;  // of the face along x and along y, 0 … 10°; not given: as the surface has it
  bool operator==(const Variation&) const = default;
};

// How far the hand of a paviour shows, where stones were not sawn and lines not drawn (paving/tiles/hand_laying.h). Rows and
// lengths differ first, then each corner lies by itself, so that joints are wedges about `joint_mm`. What is not given follows
// from `amount`.
struct HandLaying {
  double amount = 0.0;            // 0: as exact as can be, to 1: a worn alley
  std::optional<double> rounded;  // cut off at each corner, as a part of the shorter side beside it, 0 … 0.3
  std::optional<double> nibbled;  // part of the corners of which more has gone, 0 … 1
  std::optional<double> sunk;     // part of the stones that lie in a hollow, 0 … 1
  std::optional<double> sunk_mm;  // how deep these lie at the most, >= 0
  bool operator==(const HandLaying&) const = default;
};

// Micro relief: a fractal surface on top (§4 (2)).
struct Relief {
  double rms_mm = 0.6;  // root mean square of the height, >= 0; 0 leaves it out
  double hurst = 0.7;   // Hurst exponent, 0 … 1: near 0 is gritty, near 1 is smooth
  bool operator==(const Relief&) const = default;
};

// What the stones are made of, in pictures.
enum class Material {
  setts,  // granite and basalt mixed, as old setts are
  granite,
  basalt,
  sandstone,
  limestone,
  brick
};

enum class JointFill { sand, mortar };

// Colours of the user's own, in place of those of the material, each of its share of the stones (paving/tiles/colouring.h).
struct ColourMix {
  std::vector<vec3> colours;   // sRGB, each 0 … 1; none: the material's own
  std::vector<double> shares;  // as many, each > 0, 1 together
  // From here to there the colours follow one another in their order; without it they are mixed evenly.
  std::optional<std::pair<vec2, vec2>> gradient_mm;
  std::vector<vec2> attractors_mm;  // or outwards from the nearest of these
  double blur = 0.5;                // 0: they follow in bands, to 1: they hardly do
  bool operator==(const ColourMix&) const = default;
};

// How a pavement looks.
struct Look {
  Material material = Material::setts;
  std::optional<JointFill> joint_fill;  // not given: sand with moss here and there
  std::optional<double> moss;           // in joints and on arrises, 0 … 1; not given: as the filling has it
  double wetness = 0.0;                 // 0 … 1: to 0.5 wet stone, above it water stands in the low spots
  ColourMix colours;
  bool operator==(const Look&) const = default;
};

// How the ground lies. The plan stays a plan: these are heights over it.
struct Ground {
  double fall_percent = 0.0;             // for drainage, >= 0
  Angle fall_direction;                  // downhill, from +x
  double level_mm = 0.0;                 // of the whole, at the origin of the plan
  double settlement_mm = 0.0;            // how far the ground has sunk at its lowest, >= 0: hollows that water stands in
  double settlement_length_mm = 2500.0;  // from hollow to hollow, > 0
  double depth_mm = 50.0;                // of what stands below the outlines of the stones; by eye: a bed of sand
  bool operator==(const Ground&) const = default;
};

// Kerb stones along the outline of a pavement, outside (paving/derived/kerb.h).
struct Kerb {
  double width_mm = 0.0;     // >= 0; 0: none
  double length_mm = 900.0;  // of a stone, > 0
  double height_mm = 0.0;    // above the stones, >= 0
  bool operator==(const Kerb&) const = default;
};

// A pavement laid as a flight of steps, one for each row along its direction (paving/derived/steps.h).
struct Flight {
  double riser_mm = 150.0;  // how much higher each step is than the last, not 0; below 0: lower
  double tread_mm = 350.0;  // from front to front, > 0

  bool operator==(const Flight&) const = default;
};

// How finely stones are made, by their distance from where the picture is taken.
struct Detail {
  vec2 viewer_mm{0.0, 0.0};  // on the plan
  double close_mm = 0.0;     // stones up to here are meshes with the relief and chips as true geometry, >= 0
  double mesh_mm = 1.5;      // sides of their triangles, > 0
  bool operator==(const Detail&) const = default;
};

struct Pavement {
  std::string name;             // an identifier: letters, digits, '_' and '-'
  geometry::Region area;        // the paved area, mm
  vec2 stone_mm{100.0, 100.0};  // face of a whole stone: along the rows, across them; > 0
  double joint_mm = 8.0;        // between faces of neighbours, >= 0; half of it stays free along outline and holes
  Direction direction;
  Sizes sizes;  // of packed stones; others are alike
  Bonding bonding;
  Border border;
  StoneSurface surface;
  StoneBody body;
  CellShape cell;  // of another form than `stone`, the body has no effect
  Variation variation;
  HandLaying hand;
  Relief relief;
  TextureSet textures;
  Look look;
  Ground ground;
  Kerb kerb;
  std::optional<Flight> flight;  // given: laid as steps
  std::optional<Detail> detail;  // not given: all stones alike
  studio::Placement placement;

  bool operator==(const Pavement&) const = default;
};

// From one stone to the next: along the rows, across them (mm). A stone and a joint.
inline vec2 pitch_mm(const Pavement& pavement) { return pavement.stone_mm + vec2{pavement.joint_mm, pavement.joint_mm}; }

// Whether the sizes of stones follow a field.
inline bool has_sizes(const Pavement& pavement) { return !std::holds_alternative<EqualSizes>(pavement.sizes); }

// The least and the greatest of the sizes that are asked for.
struct SizeRange {
  double smallest = 1.0;
  double largest = 1.0;
};
inline SizeRange size_range(const Pavement& pavement) {
  const auto range = [](double a, double b) { return SizeRange{std::min(a, b), std::max(a, b)}; };
  return std::visit(Overloaded{[](const EqualSizes&) { return SizeRange{}; },
                               [&](const SizesFromEdge& sizes) { return range(sizes.ramp.near, sizes.ramp.far); },
                               [&](const SizesFromLines& sizes) { return range(sizes.ramp.near, sizes.ramp.far); },
                               [&](const SizesOfMap& map) { return range(map.dark, map.light); }},
                    pavement.sizes);
}

// Of the pavement that the kerb stones of `pavement` are.
inline std::string kerb_name(const Pavement& pavement) { return pavement.name + "_kerb"; }

}  // namespace shatterpave::paving
