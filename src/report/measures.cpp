#include "report/measures.h"

#include <fmt/format.h>

#include <iterator>

#include "report/json_values.h"
#include "report/pavement_tables.h"

namespace shatterpave::reporting {

namespace {

using measure::Distribution;
using measure::ImpactFigures;

// Count, mean, deviation, least and greatest; the last four empty where nothing was counted.
void put_csv(fmt::memory_buffer& out, const Distribution& d) {
  const auto at = std::back_inserter(out);
  if (d.count() == 0) {
    fmt::format_to(at, ",0,,,,");
  } else {
    fmt::format_to(at, ",{},{},{},{},{}", d.count(), d.mean(), d.deviation(), d.least(), d.greatest());
  }
}

constexpr std::string_view csv_head =
    "seed,pane,impact,radial_count,large_count,circular_count,reaching_count,ends_on_edge,ends_on_crack,ends_enclosed,ends_"
    "open,"
    "ring_cracks,ring_cracks_held,ring_points,ring_radius_mean_mm,ring_radius_sd_mm,ring_radius_min_mm,ring_radius_max_mm,"
    "turns,turn_mean_deg,turn_sd_deg,turn_min_deg,turn_max_deg,"
    "edge_angles,edge_angle_mean_deg,edge_angle_sd_deg,edge_angle_min_deg,edge_angle_max_deg,gap_ratio,crossings,"
    "young_turns,young_turn_sd_deg,grown_turns,grown_turn_sd_deg,reaching_gap_variation\n";

void put_csv(fmt::memory_buffer& out, const ImpactFigures& f) {
  const auto at = std::back_inserter(out);
  fmt::format_to(at, ",{},{},{},{}", f.drawn.radial_count, f.drawn.large_count, f.drawn.circular_count, f.reaching_count);
  fmt::format_to(at, ",{},{},{},{}", f.ends.edge, f.ends.crack, f.ends.enclosed, f.ends.open);
  fmt::format_to(at, ",{},{}", f.ring_crack_count, f.held_ring_end_count);
  put_csv(out, f.ring_distance_mm);
  put_csv(out, f.turn_deg);
  put_csv(out, f.edge_angle_deg);
  fmt::format_to(at, ",");
  if (f.gap_ratio) fmt::format_to(at, "{}", *f.gap_ratio);
  fmt::format_to(at, ",{}", f.crossing_count);
  for (const Distribution* turns : {&f.young_turn_deg, &f.grown_turn_deg}) {
    fmt::format_to(at, ",{},", turns->count());
    if (turns->count() > 1) fmt::format_to(at, "{}", turns->deviation());
  }
  fmt::format_to(at, ",");
  if (f.reaching_gap_variation) fmt::format_to(at, "{}", *f.reaching_gap_variation);
  fmt::format_to(at, "\n");
}

Json line_json(const measure::Line& line) {
  return {{"points", line.count},
          {"slope", line.slope},
          {"intercept", line.intercept},
          {"residual_sd", line.residual},
          {"correlation", line.correlation},
          {"slope_error", number(line.slope_error)},
          {"intercept_error", number(line.intercept_error)}};
}

Json turn_bands_json(const measure::Summary& s) {
  Json bands = Json::array();
  for (std::size_t i = 0; i < s.turns_deg_by_distance.size(); ++i) {
    const double from_mm = static_cast<double>(i) * measure::turn_band_mm;
    Json band = {{"from_mm", from_mm}, {"to_mm", from_mm + measure::turn_band_mm}};
    band.update(json_of(s.turns_deg_by_distance[i]));
    bands.push_back(std::move(band));
  }
  return bands;
}

Json summary_json(const measure::Summary& s) {
  Json findings = Json::array();
  for (const measure::Finding& finding : s.findings) findings.push_back(json_of(finding));
  return {{"findings", findings},
          {"radial_count", json_of(s.radial_count)},
          {"reaching_against_radial_count", line_json(s.large_line)},
          {"ring_radius_mm_against_radial_count", line_json(s.ring_line)},
          {"ring_radius_ratio", json_of(s.ring_ratio)},
          {"ring_radius_ratio_histogram", json_of(s.ring_ratios)},
          {"turn_deg", json_of(s.turn_deg)},
          {"turn_deg_histogram", json_of(s.turns_deg)},
          {"turn_deg_by_distance", turn_bands_json(s)},
          {"reaching_gap_variation", json_of(s.reaching_gap_variation)},
          {"edge_angle_deg", json_of(s.edge_angle_deg)},
          {"edge_angle_deg_histogram", json_of(s.edge_angles_deg)},
          {"gap_ratio", json_of(s.gap_ratio)},
          {"ends", {{"edge", s.ends.edge}, {"crack", s.ends.crack}, {"enclosed", s.ends.enclosed}, {"open", s.ends.open}}}};
}

}  // namespace

std::vector<exporting::OutputFile> measures_files(const measure::Survey& survey) {
  std::vector<exporting::OutputFile> files;
  if (!survey.panes.empty()) files.push_back({survey.name + "-measures.csv", measures_csv(survey)});
  files.push_back({survey.name + "-measures.json", measures_json(survey)});
  if (!survey.pavements.empty()) {
    files.push_back({survey.name + "-measures-pavements.csv", pavements_csv(survey)});
    files.push_back({survey.name + "-measures-stones.csv", stones_csv(survey)});
  }
  if (has_plots()) files.push_back({survey.name + "-measures.html", measures_report(survey)});
  return files;
}

std::string measures_csv(const measure::Survey& survey) {
  fmt::memory_buffer out;
  out.append(csv_head);
  for (const measure::SurveyedPane& pane : survey.panes) {
    for (std::size_t impact = 0; impact < pane.impacts.size(); ++impact) {
      fmt::format_to(std::back_inserter(out), "{},{},{}", pane.seed, survey.pane_names[pane.pane], impact);
      put_csv(out, pane.impacts[impact]);
    }
  }
  return fmt::to_string(out);
}

std::string measures_json(const measure::Survey& survey) {
  Json panes = Json::array();
  for (std::size_t i = 0; i < survey.pane_names.size(); ++i) {
    Json pane = {{"name", survey.pane_names[i]}};
    pane.update(summary_json(survey.pane_summaries[i]));
    panes.push_back(std::move(pane));
  }
  Json radials = nullptr;
  if (survey.sweep) radials = {survey.sweep->low, survey.sweep->high};
  Json law = nullptr;
  if (survey.count_law) law = {{"mean", survey.count_law->mean}, {"dispersion", survey.count_law->dispersion}};
  Json other_law = nullptr;
  if (survey.other_law) {
    other_law = {{"law", survey.other_law->name}};
    other_law.update(summary_json(survey.other_law->summary));
  }
  Json pavements = Json::array();
  for (const measure::SurveyedPavement& pavement : survey.pavements) pavements.push_back(pavement_json(pavement));
  const Json document = {{"format", "shatterpave-measures"},
                         {"version", 1},
                         {"scene", survey.name},
                         {"first_seed", survey.first_seed},
                         {"seeds", survey.seed_count},
                         {"radials", radials},
                         {"radial_count_law", law},
                         {"all", survey.panes.empty() ? Json(nullptr) : summary_json(survey.summary)},
                         {"other_law", other_law},
                         {"panes", panes},
                         {"pavements", pavements}};
  return document.dump(1) + "\n";
}

}  // namespace shatterpave::reporting
