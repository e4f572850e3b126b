// The words of a scene file for values that are chosen from a list, each with its value.
#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "glass/pane.h"
#include "glass/presets.h"
#include "paving/pavement.h"
#include "scene/plans/plan.h"

namespace shatterpave::scene {

template <typename Value>
struct Word {
  std::string_view name;
  Value value;
};

template <typename Words>
std::vector<std::string_view> names_of(const Words& words) {
  std::vector<std::string_view> names;
  names.reserve(words.size());
  for (const auto& word : words) names.push_back(word.name);
  return names;
}

// The kinds of glass, each as it is by default.
template <typename... Kinds>
constexpr std::array<Word<glass::Glass>, sizeof...(Kinds)> words_of_kinds(const std::variant<Kinds...>& /*any*/) {
  return {{{Kinds::name, Kinds{}}...}};
}
inline constexpr auto glass_words = words_of_kinds(glass::Glass());

inline constexpr auto pattern_words =
    std::to_array<Word<glass::Pattern>>({{"agui1992", glass::Pattern::agui1992}, {"real", glass::Pattern::real}});
inline constexpr auto crack_body_words =
    std::to_array<Word<glass::CrackBody>>({{"cylinder", glass::CrackBody::cylinder}, {"sheet", glass::CrackBody::sheet}});
inline constexpr auto spread_words =
    std::to_array<Word<glass::Spread>>({{"normal", glass::Spread::normal}, {"uniform", glass::Spread::uniform}});
inline constexpr auto growth_law_words =
    std::to_array<Word<glass::GrowthLaw>>({{"fitted", glass::GrowthLaw::fitted}, {"printed", glass::GrowthLaw::printed}});
inline constexpr auto local_region_words =
    std::to_array<Word<glass::LocalRegion>>({{"sector", glass::LocalRegion::sector},
                                             {"rectangle", glass::LocalRegion::rectangle},
                                             {"circle", glass::LocalRegion::circle}});
inline constexpr auto rounding_words = std::to_array<Word<glass::Rounding>>(
    {{"down", glass::Rounding::down}, {"nearest", glass::Rounding::nearest}, {"up", glass::Rounding::up}});
// Laws for the number of radial cracks, by the variance over the mean.
inline constexpr auto count_law_words = std::to_array<Word<double>>({{"poisson", 1.0}, {"table1", glass::table_1_dispersion}});

inline constexpr auto border_course_words =
    std::to_array<Word<paving::BorderCourse>>({{"none", paving::BorderCourse::none},
                                               {"soldier", paving::BorderCourse::soldier},
                                               {"stretcher", paving::BorderCourse::stretcher}});
inline constexpr auto arris_words =
    std::to_array<Word<paving::Arris>>({{"rounded", paving::Arris::rounded}, {"chamfered", paving::Arris::chamfered}});
inline constexpr auto cell_form_words = std::to_array<Word<paving::CellForm>>(
    {{"stone", paving::CellForm::stone}, {"cobble", paving::CellForm::cobble}, {"scale", paving::CellForm::scale}});
inline constexpr auto material_words = std::to_array<Word<paving::Material>>({{"setts", paving::Material::setts},
                                                                              {"granite", paving::Material::granite},
                                                                              {"basalt", paving::Material::basalt},
                                                                              {"sandstone", paving::Material::sandstone},
                                                                              {"limestone", paving::Material::limestone},
                                                                              {"brick", paving::Material::brick}});
inline constexpr auto joint_fill_words =
    std::to_array<Word<paving::JointFill>>({{"sand", paving::JointFill::sand}, {"mortar", paving::JointFill::mortar}});
inline constexpr auto texture_format_words =
    std::to_array<Word<paving::TextureFormat>>({{"png", paving::TextureFormat::png},
                                                {"exr", paving::TextureFormat::exr},
                                                {"tiled_exr", paving::TextureFormat::tiled_exr}});

inline constexpr auto plan_unit_words = std::to_array<Word<PlanUnits>>({{"degrees", PlanUnits::degrees},
                                                                        {"metres", PlanUnits::metres},
                                                                        {"millimetres", PlanUnits::millimetres},
                                                                        {"feet", PlanUnits::feet},
                                                                        {"us_survey_feet", PlanUnits::us_survey_feet}});

}  // namespace shatterpave::scene
