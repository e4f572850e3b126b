// Every key of the scene file has an effect somewhere, and where one that is given has none, it is told.
#include <gtest/gtest.h>

#include "pipeline/key_outcomes.h"

namespace shatterpave::pipeline {
namespace {

const std::string counted = "pane[0].impact[0].radial_count=24";
const std::string ringed = "pane[0].impact[0].circular_count=4";
const std::string real = "pane[0].pattern=real";
const std::string laminated = "pane[0].glass=laminated";
const std::string tempered = "pane[0].glass=tempered";
const std::string sheet = "pane[0].crack_body=sheet";
const std::string shards = "pane[0].shards={missing_mm = 18}";

// Shards take long to fall: their keys are tried with few others, and not without them.
const std::vector<std::string> no_shards = {"pane[0].shards.gap", "pane[0].shards.s", "pane[0].shards.b", "pane[0].shards.c",
                                            "pane[0].shards.m",   "pane[0].shards.h", "pane[0].shards.f", "pane[0].shards.t",
                                            "pane[0].shards.r",   "pane[0].shards.j"};
const std::vector<std::string> no_growth = {"pane[0].growth",    "pane[0].rings",           "pane[0].laminate",
                                            "pane[0].tempering", "pane[0].impact[0].at_mm", "pane[0].impact[0].large_count"};

std::vector<std::string> with(std::vector<std::string> keys, const std::vector<std::string>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

// Rings of 113 radials have a mean radius of 67 mm: on this pane they would lie outside, but for a few.
const std::vector<std::string> of_rings_outside =
    with(no_shards, {"pane[0].growth.circular_speed_px", "pane[0].growth.crack_gain_px2", "pane[0].growth.ring_pull"});
// Where no piece is struck out, all the same those fall that splinters leave without hold, if there are any.
const std::vector<std::string> of_the_fallen =
    with(no_growth, {"pane[0].shards.held", "pane[0].shards.fallen", "pane[0].shards.throw_m_s"});
// And a body of all pieces has walls and edges where splinters have left it only.
const std::vector<std::string> of_edges_within =
    with(of_the_fallen, {"pane[0].shards.gap_mm", "pane[0].shards.splinter_mm2", "pane[0].shards.chip"});

const std::vector<Surroundings> pane_surroundings = {
    {"ball", {"pane[0].growth.reference_radial_count=30", "pane[0].growth.circular_threshold=0"}, no_shards},
    {"another ball",
     {"pane[0].growth.reference_radial_count=30", "pane[0].growth.circular_threshold=0", "pane[0].impact[0].speed_m_s=9"},
     no_shards},
    {"counted", {counted, ringed}, no_shards},
    {"fully counted", {counted, ringed, "pane[0].impact[0].large_count=6"}, no_shards},
    {"many", {"pane[0].impact[0].radial_count=90"}, no_shards},
    {"mean", {"pane[0].impact[0].mean_radial_count=24", "pane[0].growth.circular_threshold=0"}, no_shards},
    {"preset", {"pane[0].preset=agui1992-fig14a"}, of_rings_outside},
    {"no rings", {counted, "pane[0].impact[0].circular_count=0"}, no_shards},
    {"no spread", {counted, ringed, "pane[0].growth.spread_limit=0"}, no_shards},
    {"uniform", {counted, ringed, "pane[0].growth.spread=uniform"}, no_shards},
    {"branches", {counted, "pane[0].growth.branch_rate_per_m=60"}, no_shards},
    {"dispersed",
     {"pane[0].growth.reference_radial_count=30", "pane[0].growth.count_dispersion=2", "pane[0].growth.circular_threshold=0"},
     no_shards},
    {"real", {counted, real}, no_shards},
    {"real, no rings", {counted, real, "pane[0].rings.count=0"}, no_shards},
    {"real, one ring", {counted, real, "pane[0].rings.count=1"}, no_shards},
    {"real, interrupted", {counted, real, "pane[0].rings.interruption=1"}, no_shards},
    {"real sheets", {counted, real, sheet}, no_shards},
    {"laminated", {counted, laminated}, no_shards},
    {"laminated, the paper's", {counted, ringed, laminated, "pane[0].pattern=agui1992"}, no_shards},
    {"laminated sheets", {counted, laminated, sheet}, no_shards},
    {"tempered", {tempered}, no_shards},
    {"tempered, counted", {tempered, "pane[0].tempering.count_per_square=50"}, no_shards},
    {"tempered, no splinters", {tempered, "pane[0].tempering.splinter_ratio=1"}, no_shards},
    {"tempered sheets", {tempered, sheet}, no_shards},
    {"sheets", {counted, ringed, sheet}, no_shards},
    {"sheets, upright", {counted, sheet, "pane[0].crack_sheet.tilt_deg=0"}, no_shards},
    {"sheets, upright and straight",
     {counted, sheet, "pane[0].crack_sheet.tilt_deg=0", "pane[0].crack_sheet.curve_deg=0"},
     no_shards},
    {"sheets with a hole", {counted, sheet, "pane[0].impact[0].hole_mm=4"}, no_shards},
    {"real sheets with a hole", {counted, real, sheet, "pane[0].impact[0].hole_mm=4"}, no_shards},
    {"laminated sheets with a hole", {counted, laminated, sheet, "pane[0].impact[0].hole_mm=4"}, no_shards},
    {"tempered sheets with a hole", {tempered, sheet, "pane[0].impact[0].hole_mm=4"}, no_shards},
    {"shards", {counted, ringed, shards}, no_growth},
    {"shards, whole", {counted, ringed, shards, "pane[0].shards.missing=0"}, of_the_fallen},
    {"shards, whole and joined",
     {counted, ringed, shards, "pane[0].shards.missing=0", "pane[0].shards.joined=true"},
     of_edges_within},
    {"shards, none fallen", {counted, ringed, shards, "pane[0].shards.fallen=0"}, no_growth},
    {"shards, joined", {counted, ringed, shards, "pane[0].shards.joined=true"}, no_growth},
    {"shards without chips", {counted, ringed, shards, "pane[0].shards.chips_per_m=0"}, no_growth},
    {"shards with chips of no size", {counted, ringed, shards, "pane[0].shards.chip_mm=0"}, no_growth},
    {"shards without bevels", {counted, ringed, shards, "pane[0].shards.bevel_mm=0"}, no_growth},
    {"shards, sheets", {counted, ringed, shards, sheet}, no_growth},
    {"shards, a hole", {counted, ringed, shards, sheet, "pane[0].impact[0].hole_mm=4"}, no_growth},
    {"shards, real", {counted, ringed, shards, real}, no_growth},
    {"shards, laminated", {counted, ringed, shards, laminated, "pane[0].laminate.through=1"}, no_growth},
    {"shards, tempered", {shards, tempered}, no_growth},
};

class PaneKeys : public testing::TestWithParam<std::size_t> {};

TEST_P(PaneKeys, HaveAnEffectOrAreTold) { expect_effect_or_word(one_pane, pane_surroundings, pane_changes, GetParam()); }

INSTANTIATE_TEST_SUITE_P(Parts, PaneKeys, testing::Range(std::size_t{0}, part_count));

TEST(PaneKeysSomewhere, HaveAnEffect) { expect_effect_somewhere(one_pane, pane_surroundings, pane_changes); }

}  // namespace
}  // namespace shatterpave::pipeline
