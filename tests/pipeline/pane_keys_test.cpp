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

const std::vector<Surroundings> pane_surroundings = {
    {"ball", {"pane[0].growth.reference_radial_count=30", "pane[0].growth.circular_threshold=0"}},
    {"another ball",
     {"pane[0].growth.reference_radial_count=30", "pane[0].growth.circular_threshold=0", "pane[0].impact[0].speed_m_s=9"}},
    {"counted", {counted, ringed}},
    {"fully counted", {counted, ringed, "pane[0].impact[0].large_count=6"}},
    {"many", {"pane[0].impact[0].radial_count=90"}},
    {"mean", {"pane[0].impact[0].mean_radial_count=24"}},
    {"preset", {"pane[0].preset=agui1992-fig14a"}},
    {"no rings", {counted, "pane[0].impact[0].circular_count=0"}},
    {"no spread", {counted, ringed, "pane[0].growth.spread_limit=0"}},
    {"uniform", {counted, ringed, "pane[0].growth.spread=uniform"}},
    {"branches", {counted, "pane[0].growth.branch_rate_per_m=60"}},
    {"dispersed", {"pane[0].growth.reference_radial_count=30", "pane[0].growth.count_dispersion=10"}},
    {"real", {counted, real}},
    {"real, no rings", {counted, real, "pane[0].rings.count=0"}},
    {"real, one ring", {counted, real, "pane[0].rings.count=1"}},
    {"real, interrupted", {counted, real, "pane[0].rings.interruption=1"}},
    {"real sheets", {counted, real, sheet}},
    {"laminated", {counted, laminated}},
    {"laminated, the paper's", {counted, ringed, laminated, "pane[0].pattern=agui1992"}},
    {"laminated sheets", {counted, laminated, sheet}},
    {"tempered", {tempered}},
    {"tempered, counted", {tempered, "pane[0].tempering.count_per_square=50"}},
    {"tempered, no splinters", {tempered, "pane[0].tempering.splinter_ratio=1"}},
    {"tempered sheets", {tempered, sheet}},
    {"sheets", {counted, ringed, sheet}},
    {"sheets, upright", {counted, sheet, "pane[0].crack_sheet.tilt_deg=0"}},
    {"sheets, upright and straight", {counted, sheet, "pane[0].crack_sheet.tilt_deg=0", "pane[0].crack_sheet.curve_deg=0"}},
    {"sheets with a hole", {counted, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"real sheets with a hole", {counted, real, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"laminated sheets with a hole", {counted, laminated, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"tempered sheets with a hole", {tempered, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"shards", {counted, ringed, shards}},
    {"shards, whole", {counted, ringed, shards, "pane[0].shards.missing=0"}},
    {"shards, whole and joined", {counted, shards, "pane[0].shards.missing=0", "pane[0].shards.joined=true"}},
    {"shards, none fallen", {counted, shards, "pane[0].shards.fallen=0"}},
    {"shards, joined", {counted, shards, "pane[0].shards.joined=true"}},
    {"shards without chips", {counted, shards, "pane[0].shards.chips_per_m=0"}},
    {"shards with chips of no size", {counted, shards, "pane[0].shards.chip_mm=0"}},
    {"shards without bevels", {counted, shards, "pane[0].shards.bevel_mm=0"}},
    {"shards, sheets", {counted, shards, sheet}},
    {"shards, a hole", {counted, shards, sheet, "pane[0].impact[0].hole_mm=4"}},
    {"shards, real", {counted, shards, real}},
    {"shards, laminated", {counted, shards, laminated}},
    {"shards, tempered", {shards, tempered}},
};

TEST(PaneKeys, HaveAnEffectOrAreTold) {
  std::set<std::string> alive;
  expect_effect_or_word(one_pane, pane_surroundings, pane_changes, alive);
  for (const Change& change : pane_changes)
    EXPECT_TRUE(alive.contains(change.key)) << change.key << " changes nothing anywhere";
}

}  // namespace
}  // namespace shatterpave::pipeline
