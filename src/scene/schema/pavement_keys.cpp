#include "scene/schema/pavement_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <deque>

#include "paving/bonds/table.h"
#include "paving/catalogue/hand_presets.h"
#include "paving/catalogue/stone_sizes.h"
#include "paving/limits.h"
#include "scene/schema/outline_rows.h"
#include "scene/schema/ranges.h"

namespace shatterpave::scene {

namespace {

using paving::Bond;
using paving::Bonding;
using paving::Border;
using paving::HandLaying;
using paving::Look;
using paving::Pavement;
using paving::TextureSet;
using rows::in;
using PavementRow = Row<Pavement, PavementFacts>;
using DirectionRow = Row<DirectionAsked, PavementFacts>;
using TexturesRow = Row<TextureSet, PavementFacts>;
using ColourRow = Row<ColourAsked, PavementFacts>;
using SizeRow = Row<SizeAsked, PavementFacts>;
using StepsRow = Row<paving::Flight, PavementFacts>;

constexpr auto direction_words = std::to_array<Word<DirectionAsked::Kind>>({{"constant", DirectionAsked::Kind::constant},
                                                                            {"boundary", DirectionAsked::Kind::boundary},
                                                                            {"radial", DirectionAsked::Kind::radial},
                                                                            {"guides", DirectionAsked::Kind::guides},
                                                                            {"grid", DirectionAsked::Kind::grid}});

constexpr auto size_words = std::to_array<Word<SizeAsked::Kind>>(
    {{"edge", SizeAsked::Kind::edge}, {"line", SizeAsked::Kind::line}, {"map", SizeAsked::Kind::map}});

// Whether sizes follow a field of another kind.
template <typename Kind>
bool sized_otherwise(const PavementFacts& f) {
  return !std::holds_alternative<Kind>(f.pavement.sizes);
}
bool sized_by_map(const PavementFacts& f) { return std::holds_alternative<paving::SizesOfMap>(f.pavement.sizes); }

constexpr std::string_view without_map = "without kind = \"map\"";
constexpr std::string_view beside_map = "beside kind = \"map\"";
constexpr std::string_view without_lines = "without kind = \"line\"";

constexpr Range turn_range{-360.0, 360.0};

// Of a plan, as of the outline.
constexpr std::string_view as_outline_class = "text, as `outline_class`";
constexpr std::string_view without_guides_kind = "without kind = \"guides\"";

bool without_guides(const PavementFacts& f) { return !f.runs<paving::GuidesDirection>(); }

void apply_stone_preset(Pavement& pavement, std::size_t chosen) {
  const paving::StonePreset& preset = paving::stone_presets.at(chosen);
  pavement.stone_mm = preset.stone_mm;
  pavement.joint_mm = preset.joint_mm;
}

// What a pavement takes from a plan beside its outline.
PavementRow::List plan_rows() {
  return {
      PavementRow::by_code("outline_width_mm", ValueType::number,
                           "lines may be chosen too: they become bands of this width that end square (a footway, a gutter, a "
                           "border), points discs")
          .within(width_range),
      PavementRow::by_code("within_feature", ValueType::features, "only what lies in these areas of the same file is paved"),
      PavementRow::by_code("within_class", ValueType::text, "or in those of this class").written(as_outline_class),
      PavementRow::by_code("holes_mm", ValueType::point_lists, "areas that are left free, beside `size_mm` or `outline_mm`")
          .within(coordinate_range)
          .written("`[[[x, y], …], …]`, up to 10,000")
          .by_default("none"),
      PavementRow::by_code("holes_file", ValueType::text,
                           "a plan with areas that are left free; without feature and class, all areas in it")
          .written("file name")
          .by_default("`outline_file`"),
      PavementRow::by_code("holes_feature", ValueType::features,
                           "which of its areas are left free: trees, fountains, buildings"),
      PavementRow::by_code("holes_class", ValueType::text, "or those of this class").written(as_outline_class),
      PavementRow::by_code("holes_width_mm", ValueType::number,
                           "lines and points may be chosen too, as above: the diameter of a tree pit")
          .within(width_range),
  };
}

// The bonds that a scene may ask for, from their table.
std::vector<Word<Bond>> bond_words() {
  std::vector<Word<Bond>> words;
  for (const paving::BondType* type : paving::bond_types()) {
    if (type->is_for_scenes) words.push_back({type->name, type->id});
  }
  return words;
}

// `word`, and the names of the bonds of which that holds; they live as long as the program.
std::string_view of_bonds(std::string_view word, bool (*is_so)(const paving::BondType&)) {
  static std::deque<std::string> kept;
  return kept.emplace_back(fmt::format("{} bond = \"{}\"", word, fmt::join(paving::names_of_bonds(is_so), "\" or \"")));
}

bool takes_offset(const paving::BondType& type) { return type.takes_offset; }
bool takes_span(const paving::BondType& type) { return type.takes_span; }
bool takes_module(const paving::BondType& type) { return type.takes_module; }
bool is_packed(const paving::BondType& type) { return type.bending == paving::Bending::packed; }

PavementRow::List bond_rows() {
  return {
      PavementRow::choice("bond", in(&Pavement::bonding, &Bonding::bond), bond_words(), "the rule by which stones are laid"),
      PavementRow::number("bond_offset", in(&Pavement::bonding, &Bonding::offset), range_of(paving::offset_bounds),
                          "`running`: how far each row moves on, as a part of a stone")
          .idle([](const PavementFacts& f) { return !takes_offset(f.bond()); }, of_bonds("without", takes_offset)),
      PavementRow::angle("bond_turn_deg", in(&Pavement::bonding, &Bonding::turn), turn_range,
                         "turns the pattern against the rows: 45 for a diagonal herringbone")
          .not_beside("steps")
          .idle([](const PavementFacts& f) { return f.is_packed() && !f.pavement.textures.seamless; },
                of_bonds("beside", is_packed))
          .idle([](const PavementFacts& f) { return !f.is_straight() && f.is_rows(); }, "on rows that follow the direction"),
      PavementRow::point(
          "bond_start_mm", in(&Pavement::bonding, &Bonding::start_mm), coordinate_range,
          "the point where the pattern begins, a landscape architect's point of beginning: a whole stone has its "
          "corner there, with half the joint about it")
          .by_default("the lower left corner of the area's box, turned to the rows")
          .not_beside("steps")
          .idle([](const PavementFacts& f) { return f.is_packed(); }, of_bonds("beside", is_packed))
          .idle([](const PavementFacts& f) { return f.bond().pattern == nullptr; }, "on a bond that does not repeat")
          .idle([](const PavementFacts& f) { return !f.is_straight() && f.is_rows(); }, "on rows that follow the direction"),
      PavementRow::number("bond_span_mm", in(&Pavement::bonding, &Bonding::span_mm), range_of(paving::span_bounds_mm),
                          "`segmental_arc`, `fan`: width of an arc or a fan, five stones or more")
          .meaning("twelve stones")
          .idle([](const PavementFacts& f) { return !takes_span(f.bond()); }, of_bonds("without", takes_span)),
      PavementRow::choice(
          "border_course", in(&Pavement::border, &Border::course), border_course_words,
          "a course of stones along the outline and holes, about the bond; soldiers stand with their short side to "
          "the border, stretchers lie with the long one. Stones are evened out between corners, which are mitred"),
      PavementRow::point("border_stone_mm", in(&Pavement::border, &Border::stone_mm), range_of(paving::stone_bounds_mm),
                         "face of the stones of the border course")
          .written("`[along, across]` the border, each {}")
          .by_default("as `stone_mm`")
          .idle([](const PavementFacts& f) { return f.pavement.border.course == paving::BorderCourse::none; },
                "without border_course"),
  };
}

bool without_module(const PavementFacts& f) { return !takes_module(f.bond()); }

PavementRow::List module_rows() {
  const std::string_view without = of_bonds("without", takes_module);
  return {
      PavementRow::by_code("module_file", ValueType::text,
                           "`module`: an SVG beside the scene with a closed shape for each stone of one repeat; see "
                           "[modules](#modules)")
          .written("file name")
          .by_default("must be given for a module")
          .idle(without_module, without),
      PavementRow::by_code("module_mm", ValueType::points,
                           "the two vectors by which the drawing repeats, x to its right and y up")
          .within(coordinate_range)
          .written("`[[x, y], [x, y]]`")
          .by_default("must be given for a module")
          .idle(without_module, without),
      PavementRow::by_code("module_scale", ValueType::number, "millimetres in the world for one on the page of the drawing")
          .within(svg_scale_range)
          .by_default("1")
          .idle(without_module, without),
      PavementRow::by_code("module_feature", ValueType::features, "which of its shapes are stones")
          .by_default("all")
          .idle(without_module, without),
      PavementRow::by_code("module_class", ValueType::text, "or those of this class")
          .written(as_outline_class)
          .by_default("all")
          .idle(without_module, without),
  };
}

bool is_uncoloured(const PavementFacts& f) { return f.pavement.look.colours.colours.empty(); }
constexpr std::string_view without_colours = "without [[pavement.colour]]";

void apply_hand_preset(Pavement& pavement, std::size_t chosen) {
  const paving::HandPreset& preset = paving::hand_presets.at(chosen);
  pavement.hand = preset.hand;
  pavement.variation.missing = preset.missing;
}

PavementRow::List hand_rows() {
  return {
      PavementRow::preset("hand_preset", names_of(paving::hand_presets), apply_hand_preset,
                          "sets `laid_by_hand`, the keys of `[pavement.hand]` and `variation.missing`; a key given beside it "
                          "wins")
          .by_default("none")
          .idle(in_a_flight, beside_steps),
      PavementRow::number("laid_by_hand", in(&Pavement::hand, &HandLaying::amount), {0.0, 1.0},
                          "how far the hand of a paviour shows: 0 is exact, 1 a worn alley, with rows and lengths that differ, "
                          "corners that lie by themselves and joints that are wedges about `joint_mm`; stones never touch")
          .idle(in_a_flight, beside_steps),
      PavementRow::table("hand", "corners and hollows of stones laid by hand")
          .by_default("as `laid_by_hand` says")
          .idle(in_a_flight, beside_steps)
          .idle([](const PavementFacts& f) { return f.pavement.hand.amount == 0.0; }, "without laid_by_hand"),
  };
}

PavementRow::List colour_rows() {
  return {
      PavementRow::tables("colour", most_colours,
                          "colours of the stones in place of the material's, each with its share of the stones, which is kept "
                          "to within half a per cent of 400 stones or more")
          .by_default("the material's own")
          .idle(in_a_flight, beside_steps),
      PavementRow::by_code("colour_gradient_mm", ValueType::points,
                           "from the first place to the second the colours follow one another, in the order of their tables")
          .within(coordinate_range)
          .written("`[[x, y], [x, y]]`")
          .by_default("mixed evenly")
          .idle(is_uncoloured, without_colours),
      PavementRow::by_code("colour_attractors_mm", ValueType::points,
                           "or away from these places, the first colour about them; not beside `colour_gradient_mm`")
          .within(coordinate_range)
          .written(fmt::format("`[[x, y], …]`, up to {}", most_attractors))
          .by_default("none")
          .idle(is_uncoloured, without_colours),
      PavementRow::number(
          "colour_blur", [](Pavement& p) -> double& { return p.look.colours.blur; }, {0.0, 1.0},
          "how far colours that follow one another reach into each other: 0 are bands")
          .idle(is_uncoloured, without_colours)
          .idle(
              [](const PavementFacts& f) {
                return !f.pavement.look.colours.gradient_mm && f.pavement.look.colours.attractors_mm.empty();
              },
              "without colour_gradient_mm or colour_attractors_mm"),
  };
}

PavementRow::List look_rows() {
  return {
      PavementRow::choice(
          "material", in(&Pavement::look, &Look::material), material_words,
          "what stones look like; `setts` are granites and basalts mixed. Each stone has its own colour and its own "
          "part of grain, beds or veins"),
      PavementRow::choice("joint_fill", in(&Pavement::look, &Look::joint_fill), joint_fill_words,
                          "what the joints are filled with")
          .by_default("sand with some moss"),
      PavementRow::number("moss", in(&Pavement::look, &Look::moss), {0.0, 1.0}, "green in joints, on sides and arrises")
          .by_default("as the filling has it"),
      PavementRow::number(
          "wetness", in(&Pavement::look, &Look::wetness), {0.0, 1.0},
          "to 0.5 stones grow darker and shine; above, water stands in the low spots, over a third of the stones at "
          "1"),
  };
}

PavementRow::List table_rows() {
  return {
      PavementRow::table("surface", "upper face of the stones"),
      PavementRow::table("cell", "cobbles or scales in place of stones: organic textures").by_default("stones"),
      PavementRow::table("variation", "how stones differ from the places that the bond gives them")
          .by_default("none")
          .idle(in_a_flight, beside_steps),
      PavementRow::table("relief", "roughness of the stones")
          .idle([](const PavementFacts& f) { return f.is_flight() && !f.has_body(); },
                "beside [pavement.steps] without a finish"),
      PavementRow::table(
          "textures",
          "what `--target textures` draws: size, window, seamless tile, format; pictures of the material in meshes; see "
          "[textures](textures.md) and [meshes](meshes.md)"),
      PavementRow::table("ground", "how the ground lies, and a kerb").by_default("level"),
      PavementRow::table("steps", "the pavement is a flight of steps, one for each row").by_default("none"),
      PavementRow::table("detail", "fineness by distance, for POV-Ray").by_default("all stones alike"),
  };
}

PavementRow::List stone_rows() {
  return {
      PavementRow::preset("stone_preset", names_of(paving::stone_presets), apply_stone_preset,
                          "sets `stone_mm` and `joint_mm`; a key given beside it wins")
          .by_default("none")
          .idle([](const PavementFacts& f) { return f.has("stone_mm") && f.has("joint_mm"); }, "beside stone_mm and joint_mm")
          .idle([](const PavementFacts& f) { return takes_module(f.bond()) && f.has("joint_mm"); },
                of_bonds("beside joint_mm and", takes_module)),
      PavementRow::point(
          "stone_mm", &Pavement::stone_mm, range_of(paving::stone_bounds_mm),
          fmt::format("face of a whole stone; so large that at most {} are needed", number_text(paving::most_stones)))
          .written("`[along, across]` the rows, each {}")
          .idle([](const PavementFacts& f) { return takes_module(f.bond()); }, of_bonds("beside", takes_module)),
      PavementRow::number("joint_mm", &Pavement::joint_mm, range_of(paving::joint_bounds_mm),
                          "gap between stones; half of it stays free along the outline and holes"),
      PavementRow::table("direction", "how rows run").by_default("constant, 0°"),
      PavementRow::table("size", "sizes of packed stones that follow a field; only beside `bond = \"packed\"`")
          .by_default("all alike"),
  };
}

}  // namespace

// A preset comes before the keys that win over it.
const Section<Pavement, PavementFacts> pavement_keys{
    "pavement[]", joined(joined(joined(joined(outline_rows<Pavement, PavementFacts>(), plan_rows()), stone_rows()),
                                joined(bond_rows(), module_rows())),
                         joined(joined(hand_rows(), look_rows()), joined(colour_rows(), table_rows())))};

const Section<ColourAsked, PavementFacts> colour_keys{
    "pavement[].colour[]",
    {
        ColourRow::place("srgb", &ColourAsked::srgb, {0.0, 1.0}, "the colour, as pictures on a screen have it")
            .written("`[red, green, blue]`, each {}")
            .by_default("must be given"),
        ColourRow::number("share", &ColourAsked::share, {1e-6, 1e6},
                          "how much of the stones it has, beside the shares of the others"),
    }};

const Section<DirectionAsked, PavementFacts> direction_keys{
    "pavement[].direction",
    {
        DirectionRow::choice(
            "kind", &DirectionAsked::kind, direction_words,
            "rows run one way; along the nearest side of the outline or a hole (rows of oblong packed stones are "
            "mitred at corners of more than 50°); in circles; along polylines; along vectors on a grid, stone by stone "
            "(`packed`)"),
        DirectionRow::angle("angle_deg", &DirectionAsked::angle, turn_range, "constant: axis of the rows, from +x")
            .idle([](const PavementFacts& f) { return !f.is_straight(); }, "without kind = \"constant\""),
        DirectionRow::point("centre_mm", &DirectionAsked::centre_mm, coordinate_range, "radial: the centre")
            .idle([](const PavementFacts& f) { return !f.runs<paving::RadialDirection>(); }, "without kind = \"radial\"")
            .idle([](const PavementFacts& f) { return !f.bends(); }, "on a bond that cannot bend"),
        DirectionRow::by_code("guides_mm", ValueType::point_lists, "guides: the polylines")
            .within(coordinate_range)
            .written(fmt::format("`[[[x, y], …], …]`, up to {}, each of 2 or more distinct points",
                                 number_text(static_cast<double>(most_guides))))
            .by_default("must be given for guides, here or from a [plan](#plans)")
            .idle(without_guides, without_guides_kind),
        DirectionRow::by_code("guides_file", ValueType::text,
                              "a plan with the guides; without feature and class, all lines in it")
            .written("file name")
            .by_default("`outline_file`")
            .idle(without_guides, without_guides_kind),
        DirectionRow::by_code(
            "grid_file", ValueType::text,
            "grid: a file of vectors beside the scene, `.json`, `.csv` or `.exr`; see [directions](#a-direction-field)")
            .written("file name")
            .by_default("must be given for a grid")
            .idle([](const PavementFacts& f) { return !f.runs<paving::GridDirection>(); }, "without kind = \"grid\""),
        DirectionRow::by_code("grid_area_mm", ValueType::points,
                              "grid: the rectangle of the plan that a picture of vectors covers")
            .within(coordinate_range)
            .written("`[[x, y], [x, y]]`, lower left and upper right corner")
            .by_default("the pavement's bounding box")
            .idle([](const PavementFacts& f) { return !f.runs<paving::GridDirection>(); }, "without kind = \"grid\""),
        DirectionRow::by_code("guides_feature", ValueType::features,
                              "which of its lines the rows follow, in place of `guides_mm`")
            .idle(without_guides, without_guides_kind),
        DirectionRow::by_code("guides_class", ValueType::text, "or those of this class")
            .written(as_outline_class)
            .idle(without_guides, without_guides_kind),
    }};

const Section<SizeAsked, PavementFacts> size_keys{
    "pavement[].size",
    {
        SizeRow::choice("kind", &SizeAsked::kind, size_words,
                        "sizes follow the distance from the outline and the holes; from polylines; or a grey picture"),
        SizeRow::number(
            "near", [](SizeAsked& s) -> double& { return s.ramp.near; }, range_of(paving::size_bounds),
            "size at the edge or the line, as a part of `stone_mm` each way")
            .idle(sized_by_map, beside_map),
        SizeRow::number(
            "far", [](SizeAsked& s) -> double& { return s.ramp.far; }, range_of(paving::size_bounds),
            "size from `distance_mm` on, evenly between; but no stone is more than a tenth of `stone_mm` larger than the one "
            "before it, so that it may take longer")
            .idle(sized_by_map, beside_map),
        SizeRow::number(
            "distance_mm", [](SizeAsked& s) -> double& { return s.ramp.distance_mm; }, size_range, "where sizes are `far`")
            .idle(sized_by_map, beside_map),
        SizeRow::by_code("lines_mm", ValueType::point_lists, "line: the polylines")
            .within(coordinate_range)
            .written("`[[[x, y], …], …]`, each of 2 or more distinct points")
            .by_default("must be given for lines")
            .idle(sized_otherwise<paving::SizesFromLines>, without_lines),
        SizeRow::by_code("map_file", ValueType::text,
                         "map: a grey picture beside the scene, `.png`; see [sizes](#sizes-that-follow-a-field)")
            .written("file name")
            .by_default("must be given for a map")
            .idle(sized_otherwise<paving::SizesOfMap>, without_map),
        SizeRow::by_code("map_area_mm", ValueType::points, "map: the rectangle of the plan that the picture covers")
            .within(coordinate_range)
            .written("`[[x, y], [x, y]]`, lower left and upper right corner")
            .by_default("the pavement's bounding box")
            .idle(sized_otherwise<paving::SizesOfMap>, without_map),
        SizeRow::number("dark", &SizeAsked::dark, range_of(paving::size_bounds), "map: size where it is black")
            .idle(sized_otherwise<paving::SizesOfMap>, without_map),
        SizeRow::number("light", &SizeAsked::light, range_of(paving::size_bounds), "map: size where it is white")
            .idle(sized_otherwise<paving::SizesOfMap>, without_map),
    }};

const Section<TextureSet, PavementFacts> textures_keys{
    "pavement[].textures",
    {
        TexturesRow::whole<std::size_t>("size_px", &TextureSet::size_px, {256, 16384}, "pixels along the longer side"),
        TexturesRow::by_code("area_mm", ValueType::points, "the part of the plane that textures show; not beside `seamless`")
            .within(coordinate_range)
            .written("`[[x, y], [x, y]]`, lower left and upper right corner")
            .by_default("the pavement's bounding box"),
        TexturesRow::flag("seamless", &TextureSet::seamless,
                          "instead of that part, a tile of the bond that meets itself on all sides"),
        TexturesRow::point("tile_mm", &TextureSet::tile_mm, {1.0, 100'000.0}, "size of that tile; only beside `seamless`")
            .written("`[width, height]`, each {}")
            .by_default("near ten stones"),
        TexturesRow::flag("directx_normals", &TextureSet::normals_down,
                          "also normals for DirectX, whose green is turned over: `NAME_NormalDX`"),
        TexturesRow::flag("packed_channels", &TextureSet::packed_channels,
                          "also one picture with occlusion in red, roughness in green and metal, 0, in blue: "
                          "`NAME_OcclusionRoughnessMetallic`"),
        TexturesRow::choice("format", &TextureSet::format, texture_format_words, "format of the files"),
        TexturesRow::whole<std::uint16_t>("swatch_px", &TextureSet::swatch_px, {0, 4096},
                                          "pixels along a side of the pictures of the material that stones in meshes have "
                                          "(`gltf` and others); 0: colours alone"),
    }};

const Section<paving::Flight, PavementFacts> steps_keys{
    "pavement[].steps",
    {
        StepsRow::number("riser_mm", &paving::Flight::riser_mm, {-1000.0, 1000.0},
                         "how much higher each step is than the last, not 0; below 0 the flight goes down"),
        StepsRow::number("tread_mm", &paving::Flight::tread_mm, {1.0, 100'000.0}, "depth of a step, from front to front"),
    }};

}  // namespace shatterpave::scene
