#include "scene/schema/pane_keys.h"

#include <variant>

#include "glass/growth/counts.h"
#include "glass/presets.h"
#include "scene/schema/outline_rows.h"

namespace shatterpave::scene {

namespace {

using glass::CrackSheet;
using glass::Growth;
using glass::Impact;
using glass::Laminated;
using glass::Pane;
using glass::Rings;
using glass::ShardRules;
using glass::Tempered;
using rows::in;
using PaneRow = Row<Pane, PaneFacts>;
using ImpactRow = Row<Impact, ImpactFacts>;
using RingsRow = Row<Rings, PaneFacts>;
using LaminateRow = Row<Laminated, PaneFacts>;
using TemperingRow = Row<Tempered, PaneFacts>;
using SheetRow = Row<CrackSheet, PaneFacts>;
using ShardsRow = Row<ShardsAsked, PaneFacts>;

constexpr std::string_view beside_cracks_file = "beside cracks_file";
constexpr std::string_view without_real = "without pattern = \"real\"";

bool with_shards(const PaneFacts& f) { return f.pane.shards.has_value(); }
bool without_shards(const PaneFacts& f) { return !with_shards(f); }
bool with_upright_shards(const PaneFacts& f) { return f.pane.shards && !f.pane.shards->leaning; }
bool with_cracks_file(const PaneFacts& f) { return f.pane.given_cracks.has_value(); }
bool without_pattern_real(const PaneFacts& f) { return !f.is_real(); }
bool on_laminated(const PaneFacts& f) { return f.is_laminated(); }
bool unless_laminated(const PaneFacts& f) { return !f.is_laminated(); }
bool unless_tempered(const PaneFacts& f) { return !f.is_tempered(); }
bool without_rings(const PaneFacts& f) { return f.pane.rings.count == 0; }
bool all_interrupted(const PaneFacts& f) { return f.pane.rings.interruption == 1.0; }
bool without_bevels(const PaneFacts& f) { return f.pane.shards && f.pane.shards->bevel_mm == 0.0; }
// A window's preset says more than what is not read of tempered glass.
bool without_preset(const PaneFacts& f) {
  return f.table.text("preset") != glass::stone_through_window.name && f.is_tempered() && f.has("impact") &&
         (f.has("size_mm") || f.has("outline_mm") || f.has("outline_file"));
}

bool with_a_count(const PaneFacts& f) {
  const auto* tempered = std::get_if<Tempered>(&f.pane.glass);
  return tempered != nullptr && tempered->count_per_square.has_value();
}

bool struck_tempered(const ImpactFacts& f) { return f.pane.is_tempered(); }
bool by_count(const ImpactFacts& f) { return !f.has_crater() && (f.impact.radial_count || f.impact.mean_radial_count); }
bool on_shards(const ImpactFacts& f) { return f.pane.pane.shards.has_value(); }

std::vector<std::string_view> preset_names() {
  std::vector<std::string_view> names;
  for (const glass::Preset& preset : glass::presets()) names.push_back(preset.name);
  names.push_back(glass::stone_through_window.name);
  return names;
}

// A key of rings, whose default is another one in laminated glass.
template <typename Member>
RingsRow of_rings_too(const RingsRow& row, Member member) {
  const std::optional<double> laminated = std::invoke(member, glass::laminated_rings);
  return row.meaning(fmt::format("in laminated glass {:.6g}", *laminated));
}

void apply_kind(Pane& pane) {
  if (!std::holds_alternative<Laminated>(pane.glass)) return;
  pane.pattern = glass::Pattern::real;
  pane.rings = glass::laminated_rings;
}

constexpr std::string_view beside_no_bevels = "beside bevel_mm = 0, which leaves edges sharp";

}  // namespace

// Keys of other kinds of glass are checked, so that kinds can be tried in turn.
const Section<Pane, PaneFacts> pane_keys{
    "pane[]",
    joined(
        outline_rows<Pane, PaneFacts>(),
        {
            PaneRow::number("thickness_mm", &Pane::thickness_mm, {0.1, 1000.0}, "thickness of the glass"),
            PaneRow::point("bow_mm", &Pane::bow_mm, {-glass::most_bow_mm, glass::most_bow_mm},
                           "sagittas of a bent pane, across its width and along its height, each at most a tenth of that side: "
                           "above 0 it bulges towards the side that is hit; see [Bent panes](meshes.md#bent-panes)"),
            PaneRow::number("dirt", &Pane::dirt, {0.0, 1.0},
                            "in POV-Ray: dust, tracks of rain, smears and what gathers along the frame, on both faces; 1 as if "
                            "the pane had never been cleaned"),
            PaneRow::by_code(
                "preset", ValueType::choice,
                "an experiment of Agui et al. 1992, or a stone that goes through a window; a key given beside it wins")
                .one_of(preset_names())
                .written("one of thirteen, below")
                .by_default("none")
                .idle(without_preset, beside_tempered),
            PaneRow::tables("impact", most_impacts, "where the pane is hit, in the order in which it happened")
                .by_default("with a preset one, in the middle of the bounding box; without one they must be given"),
            PaneRow::by_code(
                "cracks_file", ValueType::text,
                "the cracks are in a file, a geometry file (JSON) or a drawing (SVG), instead of grown: see [Cracks "
                "from elsewhere](#cracks-from-elsewhere); a relative name starts at the scene file's folder")
                .written("file name")
                .by_default("none: cracks grow"),
            PaneRow::table("growth", "how cracks grow")
                .by_default("the preset's, or the model's")
                .idle(with_cracks_file, beside_cracks_file)
                .idle(on_tempered, beside_tempered),
            PaneRow::table("shards", "the pieces between the cracks as solids, some of them fallen")
                .by_default("none: cracks only"),
            PaneRow::choice("glass", &Pane::glass, glass_words,
                            "how the glass was made, and so how it breaks: window glass; two sheets held together by a film; "
                            "glass that falls to dice")
                .then(apply_kind),
            PaneRow::choice("pattern", &Pane::pattern, pattern_words,
                            "ring cracks as the paper grows them, or as rings of pieces from radial to radial")
                .meaning("for laminated glass `\"real\"`")
                .idle(on_tempered, beside_tempered),
            PaneRow::table("rings", "the rings of pattern `\"real\"`")
                .idle(with_cracks_file, beside_cracks_file)
                .idle(on_tempered, beside_tempered)
                .idle(without_pattern_real, without_real),
            PaneRow::table("crater", "the spall on the far side, of pattern `\"real\"`")
                .idle(on_tempered, beside_tempered)
                .idle(on_laminated, "beside glass = \"laminated\"")
                .idle(without_pattern_real, without_real),
            PaneRow::table("laminate", "what only laminated glass has").idle(unless_laminated, "without glass = \"laminated\""),
            PaneRow::table("tempering", "what only tempered glass has").idle(unless_tempered, "without glass = \"tempered\""),
            PaneRow::choice(
                "crack_body", &Pane::crack_body, crack_body_words,
                "what POV-Ray gets of a crack: a thin tube of air in the middle of the glass, or a gap of air through "
                "its thickness, which flashes as real cracks do")
                .idle(with_shards, beside_shards),
            PaneRow::table("crack_sheet", "shape of the gaps; needs `crack_body = \"sheet\"`, or shards that are `leaning`")
                .idle(with_upright_shards, beside_shards),
            PaneRow::number("time_us", &Pane::time_us, time_us_range,
                            "until when the cracks have grown, in µs: what a later time shows goes on from there, and nothing "
                            "that is there moves")
                .by_default("all have stopped"),
            PaneRow::number(
                "crack_speed_m_s", in(&Pane::growth, &Growth::crack_speed_m_s), {1.0, 10'000.0},
                "for `time_us`: speed of the mean large crack, and of the front in tempered glass; all other cracks "
                "in the proportion of their speeds"),
        })};

const Section<Impact, ImpactFacts> impact_keys{
    "pane[].impact[]",
    {
        ImpactRow::by_code("at_mm", ValueType::point, "where the pane is hit")
            .within(coordinate_range)
            .written("`[x, y]`, strictly inside the outline")
            .by_default("must be given"),
        ImpactRow::number("mean_radial_count", &Impact::mean_radial_count, {1.0, glass::largest_radial_count},
                          "mean from which the number of radial cracks is drawn; not beside `radial_count`")
            .idle(struck_tempered, beside_tempered),
        ImpactRow::whole("radial_count", &Impact::radial_count, {1, glass::largest_radial_count}, "number of radial cracks, M")
            .idle(struck_tempered, beside_tempered),
        ImpactRow::whole("large_count", &Impact::large_count, {0, glass::largest_radial_count},
                         "number of radials that are meant to reach the edge, N; up to M where that is given")
            .by_default("from M")
            .idle(struck_tempered, beside_tempered),
        ImpactRow::whole("circular_count", &Impact::circular_count, {0, 1000}, "number of places where ring cracks start, R")
            .by_default("from M")
            .idle(struck_tempered, beside_tempered)
            .idle([](const ImpactFacts& f) { return f.pane.is_real(); }, beside_real),
        ImpactRow::number(
            "ball_diameter_mm", &Impact::ball_diameter_mm, {0.0, 1000.0, true},
            "where no count of radials is given: size of a steel ball, which with the speed gives the energy, and "
            "so the mean of M")
            .idle(struck_tempered, beside_tempered)
            .idle(by_count, beside_counts),
        ImpactRow::number("speed_m_s", &Impact::speed_m_s, {0.0, 2000.0, true}, "speed of that ball")
            .idle(struck_tempered, beside_tempered)
            .idle(by_count, beside_counts),
        ImpactRow::number("hole_mm", &Impact::hole_mm, {0.0, 1000.0},
                          "diameter of the hole on the viewer's side, where the impact went through, as a shot does; needs "
                          "`crack_body = \"sheet\"`, or shards, of which it is the width of the hole in place of `missing_mm`"),
        ImpactRow::number("spall_mm", &Impact::spall_mm, {0.0, largest_spall_mm},
                          "diameter of the cone that broke off on the far side, at least `hole_mm`; flakes reach a third "
                          "farther. Hole and cone are made smaller where the edge or another impact leaves no room")
            .by_default("`hole_mm` + 4.5 thicknesses")
            .idle(on_shards, beside_shards)
            .idle([](const ImpactFacts& f) { return f.impact.hole_mm == 0.0; }, "without hole_mm"),
        ImpactRow::number("time_us", &Impact::time_us, time_us_range,
                          "when it comes, for the `time_us` of the pane; not before the impact before it"),
    }};

const Section<Rings, PaneFacts> rings_keys{
    "pane[].rings",
    {
        of_rings_too(RingsRow::whole("count", &Rings::count, {0, 100}, "number of rings"), &Rings::count)
            .idle(all_interrupted, "beside interruption = 1"),
        of_rings_too(RingsRow::number("first_radius_mm", &Rings::first_radius_mm, {0.1, 100'000.0}, "radius of the first ring"),
                     &Rings::first_radius_mm)
            .by_default("a tenth of the root of the pane's area; in laminated glass 7")
            .idle(without_rings, "beside count = 0")
            .idle(all_interrupted, "beside interruption = 1"),
        of_rings_too(RingsRow::number("ratio", &Rings::ratio, {1.01, 100.0},
                                      "radius of a ring over that of the one before: rings are denser towards the impact"),
                     &Rings::ratio)
            .idle(without_rings, "beside count = 0")
            .idle(all_interrupted, "beside interruption = 1"),
        of_rings_too(RingsRow::number("spread", &Rings::spread, {0.0, 0.5},
                                      "a piece is off its ring by up to this part of the way to the next"),
                     &Rings::spread)
            .idle(without_rings, "beside count = 0")
            .idle(all_interrupted, "beside interruption = 1"),
        of_rings_too(
            RingsRow::number("interruption", &Rings::interruption, {0.0, 1.0}, "part of the sectors that a ring leaves out"),
            &Rings::interruption)
            .idle(without_rings, "beside count = 0"),
        of_rings_too(
            RingsRow::number("bow", &Rings::bow, {0.0, 1.0}, "how bowed the pieces are: 0 straight, 1 along the circle"),
            &Rings::bow)
            .idle(without_rings, "beside count = 0")
            .idle(all_interrupted, "beside interruption = 1"),
    }};

const Section<Pane, PaneFacts> crater_keys{
    "pane[].crater",
    {
        PaneRow::angle("cone_deg", &Pane::crater_cone, {0.0, 85.0}, "how wide the spall opens through the glass, from upright"),
    }};

const Section<Laminated, PaneFacts> laminate_keys{
    "pane[].laminate",
    {
        LaminateRow::number(
            "far_cracks", &Laminated::far_cracks, {0.0, 1.0},
            "cracks of the sheet away from the impact, as a part of those of the sheet that is hit: they grow by "
            "themselves, so that the two cross")
            .idle(with_shards, beside_shards)
            .idle(with_cracks_file, beside_cracks_file),
        LaminateRow::number("film_mm", &Laminated::film_mm, {0.01, 100.0},
                            "thickness of the film between the sheets, at most half that of the pane")
            .by_default("0.76, at most a quarter of the thickness")
            .idle(with_shards, beside_shards)
            .idle(with_cracks_file, beside_cracks_file),
        LaminateRow::number("through", &Laminated::through, {0.0, 1.0},
                            "of a pane with shards: part of the cracks that run through both sheets")
            .idle(without_shards, "without shards"),
        LaminateRow::number("milky_width_mm", &Laminated::milky_width_mm, {0.0, 1000.0},
                            "width of the white rim about the crushed zone"),
    }};

const Section<Tempered, PaneFacts> tempering_keys{
    "pane[].tempering",
    {
        TemperingRow::number("surface_stress_mpa", &Tempered::surface_stress_mpa, {20.0, 1000.0},
                             "how strongly the glass is tempered: the number of fragments goes with its fourth power")
            .idle(with_a_count, "beside count_per_square"),
        TemperingRow::number("count_per_square", &Tempered::count_per_square, {1.0, 2500.0},
                             "fragments in 50 × 50 mm, as EN 12150-1 counts them, away from the impact")
            .by_default("from stress and thickness"),
        TemperingRow::number("splinter_ratio", &Tempered::splinter_ratio, {1.0, 20.0},
                             "length over width of the fragments near the impact; 1: no splinters")
            .by_default("from the thickness: 7 at 3 mm, 4 at 6 mm"),
        TemperingRow::number("splinter_reach_mm", &Tempered::splinter_reach_mm, {1.0, 10'000.0},
                             "how far from the impact splinters are found"),
    }};

// Leans and bows are limited so that a wall reaches no farther aside than three thicknesses of the pane.
const Section<CrackSheet, PaneFacts> crack_sheet_keys{
    "pane[].crack_sheet",
    {
        SheetRow::angle("tilt_deg", &CrackSheet::tilt, {0.0, 70.0},
                        "how far the walls lean from upright at the most, to either side: more makes cracks broader and "
                        "brighter"),
        SheetRow::angle("curve_deg", &CrackSheet::curve, {0.0, 70.0},
                        "by how much they lean otherwise at the faces of the pane than in its middle"),
        SheetRow::number("twist_mm", &CrackSheet::twist_mm, {1.0, 1000.0},
                         "length along a crack over which the lean changes to another one"),
        SheetRow::number("opening_mm", &CrackSheet::opening_mm, {0.001, 10.0},
                         "mean width of a gap on the face on which it opens"),
        SheetRow::number("opening_variation", &CrackSheet::opening_variation, {0.0, 1.0},
                         "by which share of its mean the width of a gap varies along the crack"),
        SheetRow::limits("depth", &CrackSheet::least_depth, &CrackSheet::greatest_depth, {0.05, 1.0},
                         "cracks that stop within the glass reach a share of the thickness between these, each its own; all "
                         "others run through")
            .idle(on_tempered, beside_tempered),
        SheetRow::number("relief", &CrackSheet::relief, {0.0, 10.0},
                         "how rough the walls are (Wallner lines, mist and hackle, growing with the distance from the impact); "
                         "0 is polished"),
    }};

const Section<ShardsAsked, PaneFacts> shards_keys{
    "pane[].shards",
    {
        ShardsRow::flag("enabled", &ShardsAsked::enabled, "whether there are shards; `false`: as if the table were not there"),
        ShardsRow::flag(
            "joined", in(&ShardsAsked::rules, &ShardRules::joined),
            "`true`: pieces that stand side by side are one body, without gaps, bevels, chips and walls between them"),
        ShardsRow::flag(
            "leaning", in(&ShardsAsked::rules, &ShardRules::leaning),
            "`true`: broken walls lean, bow and twist by `tilt_deg`, `curve_deg` and `twist_mm` of `[pane.crack_sheet]`, "
            "those on both sides of a crack alike; else they stand upright"),
        ShardsRow::number("gap_mm", in(&ShardsAsked::rules, &ShardRules::gap_mm), {0.02, 10.0},
                          "opening of the cracks, face to face"),
        ShardsRow::number("splinter_mm2", in(&ShardsAsked::rules, &ShardRules::splinter_mm2), {0.01, 1e6},
                          "pieces with a smaller face are left out"),
        ShardsRow::number(
            "bevel_mm", in(&ShardsAsked::rules, &ShardRules::bevel_mm), {0.0, 10.0},
            "width and depth of the bevel along the edges; at most 0.3 of the thickness. Where a piece is narrower "
            "than two of them they meet in a ridge"),
        ShardsRow::number("chips_per_m", in(&ShardsAsked::rules, &ShardRules::chips_per_m), {0.0, 1000.0},
                          "flakes off the broken edges, on each side of the pane")
            .idle([](const PaneFacts& f) { return f.pane.shards && f.pane.shards->chip_mm == 0.0; }, "beside chip_mm = 0")
            .idle(without_bevels, beside_no_bevels),
        ShardsRow::number("chip_mm", in(&ShardsAsked::rules, &ShardRules::chip_mm), {0.0, 100.0},
                          "half the length of the largest flakes; most are much smaller")
            .idle([](const PaneFacts& f) { return f.pane.shards && f.pane.shards->chips_per_m == 0.0; },
                  "beside chips_per_m = 0")
            .idle(without_bevels, beside_no_bevels),
        ShardsRow::number("missing", in(&ShardsAsked::rules, &ShardRules::missing), {0.0, 1.0},
                          "part of the glass near an impact that leaves the pane, in one hole; 0: none"),
        ShardsRow::number("missing_mm", in(&ShardsAsked::rules, &ShardRules::missing_mm), {0.0, 100000.0, true},
                          "distance at which that part has fallen to 1/e: about the radius of the hole")
            .by_default("from the size of the pane, and from ball and speed")
            .idle([](const PaneFacts& f) { return f.pane.shards && f.pane.shards->missing == 0.0; }, "beside missing = 0"),
        ShardsRow::number(
            "held", in(&ShardsAsked::rules, &ShardRules::held), {0.0, 1.0},
            "a piece stands while this part of its border lies in the frame or along pieces that stand, or a tenth "
            "of it in the frame"),
        ShardsRow::number(
            "fallen", in(&ShardsAsked::rules, &ShardRules::fallen), {0.0, 1.0},
            "part of the pieces that left the pane that lie on sill and floor; the others are gone. At most 4,000 "
            "may lie there: 1,000 take some 30 s, more in proportion"),
        ShardsRow::number("throw_m_s", in(&ShardsAsked::rules, &ShardRules::throw_m_s), {0.0, 20.0},
                          "speed with which pieces near an impact leave, towards the viewer (+z)")
            .idle([](const PaneFacts& f) { return f.pane.shards && f.pane.shards->fallen == 0.0; }, "beside fallen = 0"),
        ShardsRow::number("sill_drop_mm", in(&ShardsAsked::rules, &ShardRules::sill_drop_mm), {0.0, 10000.0},
                          "top of the sill below the lowest point of the pane"),
        ShardsRow::number("sill_depth_mm", in(&ShardsAsked::rules, &ShardRules::sill_depth_mm), {0.0, 10000.0},
                          "how far the sill reaches out from the pane's middle plane"),
        ShardsRow::number("frame_mm", in(&ShardsAsked::rules, &ShardRules::frame_mm), {0.0, 1000.0},
                          "how far the frame stands out from the pane's middle plane"),
        ShardsRow::number("reveal_mm", in(&ShardsAsked::rules, &ShardRules::reveal_mm), {0.0, 10000.0},
                          "from the sides of the pane's bounding box to the walls beside it"),
        ShardsRow::number("floor_drop_mm", in(&ShardsAsked::rules, &ShardRules::floor_drop_mm), {0.0, 10000.0},
                          "floor below the lowest point of the pane; not above the sill"),
        ShardsRow::number(
            "time_s", in(&ShardsAsked::rules, &ShardRules::time_s), {0.0, 1e6},
            "how far loose pieces have fallen, in s after the first of them is let go; 0: all are in the pane yet")
            .by_default("all lie where they come to rest"),
    }};

}  // namespace shatterpave::scene
