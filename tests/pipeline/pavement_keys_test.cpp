// Every key of the scene file has an effect somewhere, and where one that is given has none, it is told.
#include <gtest/gtest.h>

#include "pipeline/key_outcomes.h"

namespace shatterpave::pipeline {
namespace {

const std::string radial = "pavement[0].direction={kind = 'radial', centre_mm = [300, -900]}";
const std::string guided = "pavement[0].direction={kind = 'guides', guides_mm = [[[0, 100], [300, 200], [600, 120]]]}";
const std::string round_about = "pavement[0].direction.kind=boundary";
const std::string split = "pavement[0].surface.finish=split";

const std::vector<Surroundings> pavement_surroundings = {
    {"plain", {}},
    {"running", {"pavement[0].bond=running"}},
    {"stack", {"pavement[0].bond=stack"}},
    {"running, radial", {"pavement[0].bond=running", radial}},
    {"running, guided", {"pavement[0].bond=running", guided}},
    {"stack, boundary", {"pavement[0].bond=stack", round_about}},
    {"packed, radial", {radial}},
    {"packed, boundary", {round_about}},
    {"herringbone", {"pavement[0].bond=herringbone"}},
    {"basket weave, radial", {"pavement[0].bond=basket_weave", radial}},
    {"hexagon, guided", {"pavement[0].bond=hexagon", guided}},
    {"hexagon", {"pavement[0].bond=hexagon"}},
    {"segmental arc", {"pavement[0].bond=segmental_arc"}},
    {"fan", {"pavement[0].bond=fan"}},
    {"ashlar", {"pavement[0].bond=ashlar"}},
    {"crazy", {"pavement[0].bond=crazy"}},
    {"finish", {split}},
    {"sawn", {"pavement[0].surface.finish=flat_sawn"}},
    {"border", {"pavement[0].border_course=soldier"}},
    {"kerb", {"pavement[0].ground.kerb_width_mm=60"}},
    {"given stones", {"pavement[0].stone_mm=[90, 70]", "pavement[0].joint_mm=6"}},
    {"no joints", {"pavement[0].joint_mm=0"}},
    {"all missing", {"pavement[0].variation.missing=1"}},
    {"flat", {"pavement[0].surface.height_mm=0"}},
    {"no inset", {"pavement[0].surface.inset=0"}},
    {"polished", {"pavement[0].relief.rms_mm=0"}},
    {"polished finish", {split, "pavement[0].relief.rms_mm=0"}},
    {"sunk", {"pavement[0].ground.settlement_mm=9"}},
    {"falls", {"pavement[0].ground.fall_percent=3"}},
    {"near", {split, "pavement[0].detail={close_mm = 120, mesh_mm = 9}"}},
    {"far", {"pavement[0].detail.viewer_mm=[0, -2000]"}},
    {"tile", {"pavement[0].textures.seamless=true"}},
    {"steps", {"pavement[0].steps.tread_mm=150"}},
    {"steps, round", {"pavement[0].steps.tread_mm=150", radial}},
    {"steps in stack", {"pavement[0].steps.tread_mm=150", "pavement[0].bond=stack"}},
    {"steps about", {"pavement[0].steps.tread_mm=100", round_about}},
    {"wet", {"pavement[0].wetness=0.9", split}},
};

class PavementKeys : public testing::TestWithParam<std::size_t> {};

TEST_P(PavementKeys, HaveAnEffectOrAreTold) {
  expect_effect_or_word(one_pavement, pavement_surroundings, pavement_changes, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Parts, PavementKeys, testing::Range(std::size_t{0}, part_count));

TEST(PavementKeysSomewhere, HaveAnEffect) { expect_effect_somewhere(one_pavement, pavement_surroundings, pavement_changes); }

}  // namespace
}  // namespace shatterpave::pipeline
