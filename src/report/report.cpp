// The page is templates/report/measures.html with its marks `<!--@name-->` replaced. Plots are drawn in the browser, from a
// block of data and the specifications in templates/report/measures_plots.js; all else is written here, so that it shows
// without scripts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/embedded.h"
#include "measure/experiment.h"
#include "report/html.h"
#include "report/measures.h"
#include "report/pavement_report.h"
#include "report/words.h"

namespace shatterpave::reporting {

namespace {

using measure::Survey;

constexpr std::string_view vega = "vega.min.js";
constexpr std::string_view vega_lite = "vega-lite.min.js";
constexpr std::string_view vega_licence = "vega.licence";
constexpr std::string_view vega_lite_licence = "vega-lite.licence";

// A browser draws this many points without delay, and more would only darken the cloud.
constexpr std::size_t most_points = 2000;

// Of a drawing, mm: vertices nearer than this to the last one drawn are left out, and coordinates rounded to the unit. On the
// page a pane is some 200 px wide, so that both are well below a pixel for a pane of 300 mm; they grow with the pane.
constexpr double drawing_step = 1.0 / 250.0;
constexpr double drawing_unit = 1.0 / 3000.0;

// --- Data of the plots ------------------------------------------------------------------------------------------------

Json line_data(const measure::Line& line, double low, double high) {
  return Json::array({{rounded(low), rounded(line.at(low))}, {rounded(high), rounded(line.at(high))}});
}

Json measured_line(const measure::Line& line) {
  return line.low_x < line.high_x && line.count > 2 ? line_data(line, line.low_x, line.high_x) : Json::array();
}

// The first impacts of the first panes.
std::vector<const measure::ImpactFigures*> first_figures(const Survey& survey) {
  std::vector<const measure::ImpactFigures*> result;
  for (const measure::SurveyedPane& pane : survey.panes) {
    if (result.size() == most_points) break;
    if (!pane.impacts.empty()) result.push_back(&pane.impacts.front());
  }
  return result;
}

Json large_data(const Survey& survey) {
  Json points = Json::array();
  for (const measure::ImpactFigures* f : first_figures(survey)) points.push_back({f->drawn.radial_count, f->reaching_count});
  Json panes = Json::array();
  for (const measure::ExperimentPane& pane : measure::experiment_panes())
    panes.push_back({pane.radial_count, pane.large_count});
  const measure::Line line = measure::experiment_large_line();
  return {{"points", points},
          {"line", measured_line(survey.summary.large_line)},
          {"panes", panes},
          {"panes_line", line_data(line, line.low_x, line.high_x)}};
}

Json ring_data(const Survey& survey) {
  Json points = Json::array();
  for (const measure::ImpactFigures* f : first_figures(survey)) {
    if (f->ring_distance_mm.count() > 0) points.push_back({f->drawn.radial_count, rounded(f->ring_distance_mm.mean())});
  }
  Json panes = Json::array();
  measure::Line printed;
  printed.slope = measure::ring_radius_slope_mm;
  printed.intercept = measure::ring_radius_offset_mm;
  printed.low_x = printed.high_x = measure::experiment_panes().front().radial_count;
  for (const measure::ExperimentPane& pane : measure::experiment_panes()) {
    if (!pane.ring_radius_mm) continue;
    panes.push_back({pane.radial_count, *pane.ring_radius_mm});
    printed.low_x = std::min<double>(printed.low_x, pane.radial_count);
    printed.high_x = std::max<double>(printed.high_x, pane.radial_count);
  }
  return {{"points", points},
          {"line", measured_line(survey.summary.ring_line)},
          {"panes", panes},
          {"panes_line", line_data(printed, printed.low_x, printed.high_x)}};
}

// Cells of M of one width, some thirty over what was drawn and Table 1.
int count_cell_width(int highest) {
  int width = 1;
  for (int next : {2, 5, 10, 20, 50, 100, 200, 500}) {
    if (highest / width > 30) width = next;
  }
  return width;
}

// What the law gives for cells of `width`, in per cent, about each of some 200 M up to `highest`.
Json law_data(const measure::CountLaw& law, int width, int highest) {
  const std::vector<double> probabilities = measure::probabilities(law, highest);
  const int step = std::max(highest / 200, 1);
  Json result = Json::array();
  for (int m = 0; m <= highest; m += step) {
    result.push_back({m, rounded(100.0 * width * probabilities[static_cast<std::size_t>(m)])});
  }
  return result;
}

Json count_data(const Survey& survey) {
  Json panes = Json::array();
  measure::Distribution experiment;
  for (const measure::ExperimentPane& pane : measure::experiment_panes()) {
    panes.push_back(pane.radial_count);
    experiment.add(pane.radial_count);
  }
  const measure::Distribution& drawn = survey.summary.radial_count;
  const int highest = static_cast<int>(std::max(drawn.greatest(), experiment.greatest()));
  const int width = count_cell_width(highest);
  const int cells = highest / width + 1;
  measure::Histogram histogram{-0.5, static_cast<double>(width), std::vector<std::size_t>(static_cast<std::size_t>(cells))};
  for (const measure::SurveyedPane& pane : survey.panes) {
    if (!pane.impacts.empty()) histogram.add(pane.impacts.front().drawn.radial_count);
  }
  Json result = {{"cells", histogram_data(histogram)}, {"panes", panes}};
  // A sweep follows no law.
  const bool drawn_by_law = !survey.sweep && drawn.mean() > 0.0;
  result["poisson"] = drawn_by_law ? law_data({drawn.mean(), 1.0}, width, highest) : Json::array();
  result["dispersed"] = law_data({experiment.mean(), experiment.variance() / experiment.mean()}, width, highest);
  return result;
}

Json pane_data(const Survey& survey) {
  const auto histogram = [](const measure::Histogram& h, double low, double high) {
    return Json{{"cells", histogram_data(h)}, {"range", {low, high}}};
  };
  return {{"large", large_data(survey)},
          {"ring", ring_data(survey)},
          {"turns", histogram(survey.summary.turns_deg, measure::least_turn_deg, measure::greatest_turn_deg)},
          {"ratios", histogram(survey.summary.ring_ratios, measure::least_ring_ratio, measure::greatest_ring_ratio)},
          {"edge_angles", histogram(survey.summary.edge_angles_deg, 75.0, 90.0)},
          {"counts", count_data(survey)}};
}

// --- Tables and drawings ----------------------------------------------------------------------------------------------

std::string pane_rows(const Survey& survey) {
  Buffer out;
  for (std::size_t i = 0; i < survey.pane_names.size(); ++i) {
    const measure::Summary& summary = survey.pane_summaries[i];
    measure::Distribution reaching;
    measure::Distribution ring;
    for (std::size_t k = i; k < survey.panes.size(); k += survey.pane_names.size()) {
      const measure::ImpactFigures& figures = survey.panes[k].impacts.front();
      reaching.add(figures.reaching_count);
      if (figures.ring_distance_mm.count() > 0) ring.add(figures.ring_distance_mm.mean());
    }
    put_html(out, "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>",
             escaped(survey.pane_names[i]), mean_and_deviation(summary.radial_count, 1), mean_and_deviation(reaching, 2),
             mean_and_deviation(ring, 1));
    put_html(out, "<td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n", mean_and_deviation(summary.turn_deg, 2),
             mean_and_deviation(summary.edge_angle_deg, 1));
  }
  return fmt::to_string(out);
}

// A polyline in whole units of the drawing, as a path of relative steps.
void put_path(Buffer& out, const std::vector<vec2>& points, double unit, double step, bool closed) {
  const auto x = [&](vec2 p) { return std::llround(p.x / unit); };
  const auto y = [&](vec2 p) { return -std::llround(p.y / unit); };
  put_html(out, "M{} {}l", x(points.front()), y(points.front()));
  vec2 drawn = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i + 1 < points.size() && glm::length(points[i] - drawn) < step) continue;
    put_html(out, "{} {} ", x(points[i]) - x(drawn), y(points[i]) - y(drawn));
    drawn = points[i];
  }
  if (closed) put_html(out, "z");
}

std::string_view class_of(glass::CrackKind kind) {
  if (kind == glass::CrackKind::large || kind == glass::CrackKind::branch) return "large";
  return kind == glass::CrackKind::circular ? "ring" : "radial";
}

void put_specimen(Buffer& out, const measure::Specimen& specimen, bool named) {
  const geometry::Box box = geometry::bounding_box(specimen.pane.outline_mm);
  const double side = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double unit = side * drawing_unit;
  const double step = side * drawing_step;
  put_html(out, "<figure><svg viewBox=\"{} {} {} {}\" role=\"img\" aria-label=\"Cracks of seed {}\"><path class=\"pane\" d=\"",
           std::llround(box.low.x / unit) - 10, -std::llround(box.high.y / unit) - 10,
           std::llround((box.high.x - box.low.x) / unit) + 20, std::llround((box.high.y - box.low.y) / unit) + 20,
           specimen.seed);
  put_path(out, specimen.pane.outline_mm, unit, 0.0, true);
  put_html(out, "\"/>");
  using Kind = glass::CrackKind;
  for (const Kind kind : {Kind::radial, Kind::circular, Kind::large, Kind::branch, Kind::dice}) {
    const bool beyond_the_paper = kind == Kind::branch || kind == Kind::dice;
    if (beyond_the_paper && std::ranges::count(specimen.network.cracks, kind, &glass::Crack::kind) == 0) continue;
    put_html(out, "<path class=\"{}\" d=\"", class_of(kind));
    for (const glass::Crack& crack : specimen.network.cracks) {
      if (crack.kind == kind) put_path(out, crack.points_mm, unit, step, false);
    }
    put_html(out, "\"/>");
  }
  const glass::ImpactCounts& counts = specimen.network.impacts.front();
  put_html(out, "</svg><figcaption><b>{}</b> {}M {}, N {}</figcaption></figure>\n", specimen.seed,
           named ? escaped(specimen.pane.name) + " · " : "", counts.radial_count, counts.large_count);
}

std::string contact_sheet(const Survey& survey) {
  Buffer out;
  for (const measure::Specimen& specimen : survey.specimens) put_specimen(out, specimen, survey.pane_names.size() > 1);
  return fmt::to_string(out);
}

// Where the values of M come from.
std::string count_words(const Survey& survey) {
  if (survey.sweep) return fmt::format("in even steps from {} to {}", survey.sweep->low, survey.sweep->high);
  if (!survey.count_law) return "as the scene gives it, pane by pane";
  if (survey.count_law->dispersion <= 1.0) return fmt::format("drawn from Poisson with mean {:.4g}", survey.count_law->mean);
  return fmt::format("drawn from a negative binomial law with mean {:.4g} and variance / mean {:.4g}", survey.count_law->mean,
                     survey.count_law->dispersion);
}

// The column of findings by the other law.
std::string other_law_head(const Survey& survey) {
  if (!survey.other_law) return "";
  return fmt::format("<th class=\"number\">By the law “{}”</th>", escaped(survey.other_law->name));
}

// SD of the turns in each band about the impact.
std::string turn_band_rows(const Survey& survey) {
  Buffer out;
  const auto put_cell = [&](const measure::Distribution& turns) {
    if (turns.count() < 2) {
      put_html(out, "<td class=\"number\">–</td>");
    } else {
      put_html(out, "<td class=\"number\">{:.2f}</td>", turns.deviation());
    }
  };
  const auto& bands = survey.summary.turns_deg_by_distance;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (bands[i].count() == 0) continue;
    const double from_mm = static_cast<double>(i) * measure::turn_band_mm;
    put_html(out, "<tr><td>{:g} … {:g} mm</td><td class=\"number\">{}</td>", from_mm, from_mm + measure::turn_band_mm,
             grouped(bands[i].count()));
    put_cell(bands[i]);
    if (survey.other_law) put_cell(survey.other_law->summary.turns_deg_by_distance[i]);
    put_html(out, "</tr>\n");
  }
  return fmt::to_string(out);
}

std::string pane_section(const Survey& survey) {
  const measure::Distribution& counts = survey.summary.radial_count;
  std::string section{embedded_text("measures_panes.html")};
  fill(section, "pane_count", grouped(survey.panes.size()));
  fill(section, "counts",
       fmt::format("{:.0f} … {:.0f}, mean {:.1f}, variance / mean {:.1f}; {}", counts.least(), counts.greatest(), counts.mean(),
                   counts.variance() / std::max(counts.mean(), 1.0), count_words(survey)));
  fill(section, "verdicts", verdict_words(survey.summary.findings));
  fill(section, "other_law", other_law_head(survey));
  fill(section, "findings",
       survey.other_law ? findings_rows(survey.summary.findings, "", survey.other_law->summary.findings)
                        : findings_rows(survey.summary.findings));
  fill(section, "turn_bands_other_law", other_law_head(survey));
  fill(section, "turn_bands", turn_band_rows(survey));
  fill(section, "sample", survey.panes.size() > most_points ? fmt::format(" Points: the first {} panes.", most_points) : "");
  fill(section, "law", survey.sweep ? ", which were set" : ". Thin line: Poisson with their mean (eq. 5)");
  fill(section, "pane_rows", pane_rows(survey));
  fill(section, "specimens_title", survey.sweep ? "Panes along the sweep" : "The first panes");
  fill(section, "specimens", contact_sheet(survey));
  return section;
}

constexpr std::string_view sources =
    "T. Agui, H. Moriyama, T. Nagao, M. Nakajima, “A CG Representation Method of Cracks on a Plate Glass”, Transactions of the "
    "Information Processing Society of Japan, 1992. ";

std::string seeds_words(const Survey& survey) {
  if (survey.seed_count == 1) return fmt::format("{}", survey.first_seed);
  return fmt::format("{} … {}", survey.first_seed, survey.first_seed + (survey.seed_count - 1));
}

// What the page is of, as entries of its head.
std::string contents(const Survey& survey) {
  std::string entries;
  const auto add = [&](std::string_view what, std::size_t count) {
    if (count > 0) entries += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", what, count);
  };
  add("Panes of the scene", survey.pane_names.size());
  add("Pavements", survey.pavements.size());
  return entries;
}

}  // namespace

bool has_plots() { return is_embedded(vega) && is_embedded(vega_lite); }

std::string measures_report(const Survey& survey) {
  std::string page{embedded_text("measures.html")};
  Json pavements = Json::array();
  std::string sections;
  for (std::size_t i = 0; i < survey.pavements.size(); ++i) {
    pavements.push_back(pavement_data(survey.pavements[i]));
    sections += pavement_section(survey.pavements[i], i);
  }
  const bool has_panes = !survey.panes.empty();
  fill(page, "title", escaped(survey.name));
  fill(page, "name", escaped(survey.name));
  fill(page, "seeds", seeds_words(survey));
  fill(page, "contents", contents(survey));
  fill(page, "sources", has_panes ? sources : "");
  fill(page, "vega_licence", escaped(embedded_text(vega_licence)));
  fill(page, "vega_lite_licence", escaped(embedded_text(vega_lite_licence)));
  fill(page, "panes", has_panes ? pane_section(survey) : "");
  fill(page, "pavements", sections);
  // Numbers only, so that nothing in it can end the element that holds it.
  fill(page, "data", Json{{"panes", has_panes ? pane_data(survey) : Json(nullptr)}, {"pavements", pavements}}.dump());
  fill(page, "vega", as_script(embedded_text(vega)));
  fill(page, "vega_lite", as_script(embedded_text(vega_lite)));
  fill(page, "plots", as_script(embedded_text("measures_plots.js")));
  fill(page, "map", as_script(embedded_text("measures_map.js")));
  return page;
}

}  // namespace shatterpave::reporting
