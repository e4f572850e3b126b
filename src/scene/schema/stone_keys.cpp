// The keys that say how stones are worked, how they differ, and how the ground lies.
#include <utility>

#include "paving/catalogue/finishes.h"
#include "paving/limits.h"
#include "scene/schema/pavement_keys.h"
#include "scene/schema/ranges.h"

namespace shatterpave::scene {

namespace {

using paving::CellShape;
using paving::Detail;
using paving::Ground;
using paving::HandLaying;
using paving::Kerb;
using paving::Pavement;
using paving::Relief;
using paving::StoneBody;
using paving::StoneSurface;
using paving::Variation;
using rows::in;
using StoneRow = Row<Pavement, PavementFacts>;
using VariationRow = Row<Variation, PavementFacts>;
using ReliefRow = Row<Relief, PavementFacts>;
using CellRow = Row<CellShape, PavementFacts>;
using DetailRow = Row<Detail, PavementFacts>;

constexpr std::string_view beside_finish = "beside finish";
constexpr std::string_view without_cells = "without form = \"cobble\" or \"scale\"";
constexpr std::string_view beside_cells = "beside cell.form";
constexpr std::string_view by_finish = "by finish";

bool with_body(const PavementFacts& f) { return f.has_body(); }
bool of_stones(const PavementFacts& f) { return f.pavement.cell.form == paving::CellForm::stone; }
bool of_cells(const PavementFacts& f) { return !of_stones(f); }
bool without_kerb(const PavementFacts& f) { return f.pavement.kerb.width_mm == 0.0; }
bool without_joints(const PavementFacts& f) { return f.pavement.joint_mm == 0.0; }
bool none_laid(const PavementFacts& f) { return f.pavement.variation.missing == 1.0; }

constexpr std::string_view without_kerb_width = "without kerb_width_mm";
constexpr std::string_view without_a_joint = "beside joint_mm = 0, which leaves stones no room";
constexpr std::string_view beside_none_laid = "beside missing = 1, which leaves no stone";

void apply_finish(Pavement& pavement, std::size_t chosen) {
  const paving::FinishPreset& preset = paving::finish_presets.at(chosen);
  pavement.body = preset.body;
  pavement.surface.height_mm = preset.height_mm;
  pavement.surface.height_spread = preset.height_spread;
  pavement.variation.tilt = Angle::degrees(preset.tilt_deg);
  pavement.relief = preset.relief;
}

// A key that needs a finish.
StoneRow with_finish(const StoneRow& row) { return row.beside("finish", "a finish beside it"); }

VariationRow in_joints(const VariationRow& row) {
  return row.idle(none_laid, beside_none_laid).idle(without_joints, without_a_joint);
}

}  // namespace

// A preset sets all of these.
const Section<Pavement, PavementFacts> hand_keys{
    "pavement[].hand",
    {
        StoneRow::number("rounded", in(&Pavement::hand, &HandLaying::rounded), {0.0, 0.3},
                         "how much is cut off at each corner, as a part of the shorter side beside it; each within ± 50 %")
            .by_default("a tenth of `laid_by_hand`")
            .idle(none_laid, beside_none_laid),
        StoneRow::number("nibbled", in(&Pavement::hand, &HandLaying::nibbled), {0.0, 1.0},
                         "part of the corners that have lost more, on one side")
            .by_default("a quarter of `laid_by_hand`")
            .idle(none_laid, beside_none_laid),
        StoneRow::number("sunk", in(&Pavement::hand, &HandLaying::sunk), {0.0, 1.0},
                         "part of the stones that have sunk into a hollow of their own; JSON tells how deep")
            .by_default("0.015 of `laid_by_hand`")
            .idle(none_laid, beside_none_laid),
        StoneRow::number("sunk_mm", in(&Pavement::hand, &HandLaying::sunk_mm), {0.0, 1000.0},
                         "how deep these lie at the most; from the height of the face on, the filling shows")
            .by_default("one and a half times `surface.height_mm`")
            .idle(none_laid, beside_none_laid)
            .idle([](const PavementFacts& f) { return f.pavement.hand.sunk == 0.0; }, "beside sunk = 0"),
    }};

// A finish comes before the keys that win over it.
const Section<Pavement, PavementFacts> surface_keys{
    "pavement[].surface",
    {
        StoneRow::preset("finish", names_of(paving::finish_presets), apply_finish,
                         "stones with a face, arrises and steep sides. `height_mm` is then the height of the faces above the "
                         "filling of the joints, and the insets have no effect. A key given beside it wins")
            .by_default("none: the patch of the paper"),
        StoneRow::number("height_mm", in(&Pavement::surface, &StoneSurface::height_mm), {0.0, 1000.0},
                         "height of the inner control points of the Bézier patch above its border")
            .meaning("or by finish"),
        StoneRow::number("height_spread", in(&Pavement::surface, &StoneSurface::height_spread), {0.0, 1.0},
                         "each stone's own height is within ± this fraction")
            .meaning("or by finish")
            .idle(in_a_flight, beside_steps)
            .idle([](const PavementFacts& f) { return f.pavement.surface.height_mm == 0.0; }, "beside height_mm = 0"),
        StoneRow::number("inset", in(&Pavement::surface, &StoneSurface::inset), {0.0, 0.5},
                         "distance of the inner control points from the sides, as a fraction of the stone")
            .idle(with_body, beside_finish)
            .idle(of_cells, beside_cells)
            .idle(in_a_flight, beside_steps),
        StoneRow::number("inset_spread", in(&Pavement::surface, &StoneSurface::inset_spread), {0.0, 1.0},
                         "each stone's own inset is within ± this fraction")
            .idle(with_body, beside_finish)
            .idle(of_cells, beside_cells)
            .idle(in_a_flight, beside_steps)
            .idle([](const PavementFacts& f) { return f.pavement.surface.inset == 0.0; }, "beside inset = 0"),
        with_finish(StoneRow::choice("arris", in(&Pavement::body, &StoneBody::arris), arris_words,
                                     "the edge of the face; this and the keys below need a finish")
                        .by_default(by_finish)),
        with_finish(
            StoneRow::number(
                "arris_mm", in(&Pavement::body, &StoneBody::arris_mm), {0.1, 1000.0},
                "width of the arris, each stone's own within ± 25 %. A side that was sawn to fit the border has a sharp "
                "arris of at most 1.5 mm, without chips")
                .by_default(by_finish)),
        with_finish(StoneRow::number("crown_mm", in(&Pavement::body, &StoneBody::crown_mm), {0.0, 1000.0},
                                     "rise of the middle of the face over the middles of its sides, ± 30 %")
                        .by_default(by_finish)),
        with_finish(StoneRow::number("uneven_mm", in(&Pavement::body, &StoneBody::uneven_mm), {0.0, 1000.0},
                                     "how far the face is warped like a saddle, either way")
                        .by_default(by_finish)),
        with_finish(
            StoneRow::number("wear_mm", in(&Pavement::body, &StoneBody::wear_mm), {0.0, 1000.0},
                             "how much lower stones in the middle of the pavement lie than at its border; they are also "
                             "smoother, with rounder arrises and fewer chips")),
        with_finish(StoneRow::number("chips_per_m", in(&Pavement::body, &StoneBody::chips_per_m), {0.0, 1000.0},
                                     "mean number of chips along a metre of arris; at most one a side, on rounded arrises only")
                        .by_default(by_finish)
                        .idle([](const PavementFacts& f) { return f.pavement.body.arris == paving::Arris::chamfered; },
                              "on chamfered arrises")),
    }};

const Section<CellShape, PavementFacts> cell_keys{
    "pavement[].cell",
    {
        CellRow::choice("form", &CellShape::form, cell_form_words,
                        "stones; pebbles, rounded all about; or scales, whose tips lie over the next ones and point along the "
                        "direction (`packed` alone, with square cells, which then stand on their corners). `surface.height_mm` "
                        "is their height; not beside `surface.finish`"),
        CellRow::number("roundness", &CellShape::roundness, {0.0, 1.0},
                        "of the outline: 0 is the cell with its corners rounded, 1 an ellipse")
            .idle(of_stones, without_cells),
        CellRow::number("overlap", &CellShape::overlap, {0.0, 1.0},
                        "scale: how far its tip reaches into the next cells, as a part of its length")
            .idle([](const PavementFacts& f) { return f.pavement.cell.form != paving::CellForm::scale; },
                  "without form = \"scale\""),
    }};

const Section<Variation, PavementFacts> variation_keys{
    "pavement[].variation",
    {
        in_joints(
            VariationRow::number("size", &Variation::size, {0.0, 0.5}, "each stone is larger or smaller by up to this part")),
        in_joints(VariationRow::angle("rotation_deg", &Variation::rotation, {0.0, 45.0},
                                      "each stone is turned by up to this angle, either way")),
        in_joints(VariationRow::number("offset_mm", &Variation::offset_mm, {0.0, 1000.0},
                                       "each stone is moved by up to this, along x and along y")),
        VariationRow::number("sink_mm", &Variation::sink_mm, {0.0, 1000.0}, "each stone lies lower by up to this")
            .idle(none_laid, beside_none_laid),
        VariationRow::angle(
            "tilt_deg", &Variation::tilt, {0.0, 10.0},
            "each face is tilted by up to this along x and along y; stones of more than one and a half times the "
            "size less, so that no corner rises farther")
            .by_default("by finish; without one the crown leans by up to 1°")
            .idle(none_laid, beside_none_laid),
        VariationRow::number("missing", &Variation::missing, {0.0, 1.0},
                             "part of the stones that are not there; their ids are left out"),
    }};

const Section<Relief, PavementFacts> relief_keys{
    "pavement[].relief",
    {
        ReliefRow::number("rms_mm", &Relief::rms_mm, {0.0, 100.0}, "root mean square of the height; 0 leaves the relief out")
            .meaning("or by finish"),
        ReliefRow::number("hurst", &Relief::hurst, {0.0, 1.0}, "Hurst exponent: near 0 gritty, near 1 smooth")
            .meaning("or by finish")
            .idle([](const PavementFacts& f) { return f.pavement.relief.rms_mm == 0.0; }, "beside rms_mm = 0"),
    }};

const Section<Pavement, PavementFacts> ground_keys{
    "pavement[].ground",
    {
        StoneRow::number("fall_percent", in(&Pavement::ground, &Ground::fall_percent), {0.0, 100.0},
                         "fall for drainage, or a slope: 2 is 2 cm a metre"),
        StoneRow::angle("fall_deg", in(&Pavement::ground, &Ground::fall_direction), {-360.0, 360.0},
                        "direction of the fall, downhill, from +x")
            .idle([](const PavementFacts& f) { return f.pavement.ground.fall_percent == 0.0; }, "without fall_percent"),
        StoneRow::number("level_mm", in(&Pavement::ground, &Ground::level_mm), {-100'000.0, 100'000.0},
                         "height of the whole at the origin of the plan"),
        StoneRow::number("settlement_mm", in(&Pavement::ground, &Ground::settlement_mm), {0.0, 1000.0},
                         "how far the ground has sunk in its hollows; stones lie and lean as it does")
            .idle(in_a_flight, beside_steps),
        StoneRow::number("settlement_length_mm", in(&Pavement::ground, &Ground::settlement_length_mm), {100.0, 1'000'000.0},
                         "distance from one hollow of the ground to the next")
            .idle(in_a_flight, beside_steps)
            .idle([](const PavementFacts& f) { return f.pavement.ground.settlement_mm == 0.0; }, "without settlement_mm"),
        StoneRow::number("kerb_width_mm", in(&Pavement::kerb, &Kerb::width_mm), {0.0, paving::kerb_bounds_mm.high},
                         fmt::format("kerb stones along the outline, outside: a pavement of its own, named NAME`_kerb`, a row "
                                     "of stones with chamfered arrises; {} or more",
                                     number_text(paving::kerb_bounds_mm.low)))
            .meaning("none"),
        StoneRow::number("kerb_length_mm", in(&Pavement::kerb, &Kerb::length_mm), range_of(paving::stone_bounds_mm),
                         "length of a kerb stone")
            .idle(without_kerb, without_kerb_width),
        StoneRow::number("kerb_height_mm", in(&Pavement::kerb, &Kerb::height_mm), {0.0, 1000.0},
                         "height of the kerb above the stones")
            .idle(without_kerb, without_kerb_width),
    }};

const Section<Detail, PavementFacts> detail_keys{
    "pavement[].detail",
    {
        DetailRow::point("viewer_mm", &Detail::viewer_mm, {-1e9, 1e9}, "from where the picture is taken, on the plan"),
        DetailRow::number("close_mm", &Detail::close_mm, {0.0, 100'000.0},
                          "stones up to here are meshes with relief and chips as true geometry: some 200 KB each"),
        DetailRow::number("mesh_mm", &Detail::mesh_mm, {0.1, 1000.0}, "length of the sides of the triangles of these meshes")
            .idle([](const PavementFacts& f) { return f.pavement.detail && f.pavement.detail->close_mm == 0.0; },
                  "without close_mm"),
    }};

}  // namespace shatterpave::scene
