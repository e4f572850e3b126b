#include "report/trace_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/embedded.h"
#include "export/json/geometry_json.h"
#include "export/names.h"
#include "measure/experiment.h"
#include "measure/pane_figures.h"
#include "measure/pattern_measures.h"
#include "measure/tracking.h"
#include "report/html.h"

namespace shatterpave::reporting {

namespace {

glass::Pane pane_of(const TracedPane& traced) {
  glass::Pane pane;
  pane.name = "pane";
  const vec2 size = traced.trace.pane_mm;
  pane.outline_mm = {{0.0, 0.0}, {size.x, 0.0}, size, {0.0, size.y}};
  glass::Impact impact;
  impact.at_mm = traced.trace.network.impacts.front().at_mm;
  impact.radial_count = traced.trace.network.impacts.front().radial_count;
  pane.impacts = {impact};
  pane.given_cracks = traced.trace.network;
  return pane;
}

std::string plus_minus(const measure::Distribution& values) {
  return values.count() == 0 ? "–" : fmt::format("{:.1f} ± {:.1f}", values.mean(), values.deviation());
}

void put_row(Buffer& out, std::string_view quantity, const std::string& here, const std::string& paper) {
  put_html(out, "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n", quantity, here, paper);
}

void put_figures(Buffer& out, const TracedPane& traced) {
  const measure::PaneFigures figures = measure::pane_figures(traced.trace.network, pane_of(traced));
  const measure::Line large = measure::experiment_large_line();
  const double m = figures.radial_count;
  put_html(out,
           "<table><thead><tr><th>Quantity</th><th class=\"number\">This photograph</th><th class=\"number\">The paper's "
           "panes</th></tr></thead>\n");
  put_row(out, "M, radial cracks near the impact",
          fmt::format("{} ({} … {})", figures.radial_count, traced.trace.radial_interval[0], traced.trace.radial_interval[1]),
          "24 … 195");
  put_row(out, "N, radials that reach the edge", fmt::format("{}", figures.reaching_count),
          fmt::format("{:.1f} ± {:.1f}", large.at(m), large.residual));
  put_row(out, "Pieces of rings", fmt::format("{}", figures.ring_count), m > 70.0 ? "some" : "none");
  put_row(out, "d, distance of rings from the impact, mm", plus_minus(figures.ring_mm),
          m > 70.0 ? fmt::format("{:.1f}", measure::experiment_ring_radius_mm(m)) : "–");
  put_row(out, "θ, turns along cracks that reach the edge, °", plus_minus(figures.turn_deg), "−22.5 … 27.5");
  put_row(out, "Correlation of neighbouring turns", fmt::format("{:.2f}", figures.turn_correlation), "–");
  put_row(out, "Gaps between radials, SD / mean",
          figures.gap_variation ? fmt::format("{:.2f}", *figures.gap_variation) : std::string("–"), "–");
  put_row(out, "Branches per metre of those cracks", fmt::format("{:.1f}", figures.branches_per_m), "–");
  put_row(out, "Pieces, median area, mm²", fmt::format("{}, {:.0f}", figures.piece_mm2.count(), figures.median_piece_mm2), "–");
  put_row(out, "Elongation of pieces, median", fmt::format("{:.2f}", figures.median_elongation), "–");
  put_html(out, "</table>\n");
}

void put_section(Buffer& out, const TracedPane& traced) {
  const trace::Trace& trace = traced.trace;
  const std::string name = escaped(traced.name);
  put_html(out,
           "<section><h2>{}</h2>\n<p class=\"soft\">{} × {} px; the pane {:.1f} × {:.1f} mm{}, {:.4g} mm a px; impact at "
           "({:.1f}, {:.1f}) px.</p>\n",
           name, traced.width_px, traced.height_px, trace.pane_mm.x, trace.pane_mm.y,
           trace.size_was_assumed ? " (assumed: its longer side is that of the paper's panes)" : "", trace.mm_per_px,
           trace.impact_px.x, trace.impact_px.y);
  put_html(out, "<figure><img src=\"{0}-traced.png\" alt=\"The photograph {0} and the traced cracks\"></figure>\n", name);
  put_figures(out, traced);
  put_html(out, "</section>\n");
}

}  // namespace

exporting::OutputFile trace_json(const TracedPane& traced) {
  const trace::Trace& trace = traced.trace;
  exporting::Model model;
  model.name = traced.name;
  exporting::BrokenPane broken{pane_of(traced), trace.network, {}, {}, {}};
  broken.photograph = exporting::Photograph{traced.width_px, traced.height_px, trace.mm_per_px,
                                            trace.impact_px, trace.corners_px, trace.radial_interval};
  model.panes.push_back(std::move(broken));
  return exporting::json::json_file(model);
}

exporting::OutputFile trace_csv(const TracedPane& traced) {
  Buffer out;
  const auto at = std::back_inserter(out);
  fmt::format_to(at, "quantity,crack,kind,index,x_mm,y_mm,value\n");
  const glass::CrackNetwork& network = traced.trace.network;
  const vec2 impact = network.impacts.front().at_mm;
  for (const glass::Crack& crack : network.cracks) {
    const std::vector<vec2> points = measure::tracked(crack.points_mm);
    const std::string_view kind = exporting::name_of(crack.kind);
    if (crack.kind == glass::CrackKind::circular) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        fmt::format_to(at, "ring_distance_mm,{},{},{},{:.3f},{:.3f},{:.3f}\n", crack.id, kind, i, points[i].x, points[i].y,
                       glm::length(points[i] - impact));
      }
    } else if (crack.end.at == glass::CrackEnd::At::edge) {
      const std::vector<Angle> turns = measure::turns(points);
      for (std::size_t i = 0; i < turns.size(); ++i) {
        fmt::format_to(at, "turn_deg,{},{},{},{:.3f},{:.3f},{:.3f}\n", crack.id, kind, i, points[i + 1].x, points[i + 1].y,
                       turns[i].degrees());
      }
    }
  }
  const glass::Pane pane = pane_of(traced);
  std::size_t index = 0;
  for (const measure::PieceMeasures& piece : measure::pattern_measures(network, pane).pieces) {
    fmt::format_to(at, "piece_mm2,,piece,{},,,{:.3f}\npiece_elongation,,piece,{},,,{:.3f}\n", index, piece.area_mm2, index,
                   piece.elongation);
    ++index;
  }
  const std::vector<double> squares = measure::pieces_per_square(network, pane);
  for (std::size_t i = 0; i < squares.size(); ++i)
    fmt::format_to(at, "pieces_per_50mm_square,,square,{},,,{:.1f}\n", i, squares[i]);
  return {traced.name + ".csv", fmt::to_string(out)};
}

exporting::OutputFile trace_report(const std::vector<TracedPane>& panes) {
  std::string page{embedded_text("trace.html")};
  Buffer sections;
  for (const TracedPane& traced : panes) put_section(sections, traced);
  fill(page, "title", escaped(panes.front().name));
  fill(page, "panes", fmt::to_string(sections));
  return {panes.front().name + "-trace.html", page};
}

exporting::OutputFile figures_csv(const std::string& name, const std::vector<glass::Pane>& panes) {
  Buffer out;
  const auto at = std::back_inserter(out);
  fmt::format_to(at, "pane,quantity,value\n");
  for (const glass::Pane& pane : panes) {
    const auto numbers = measure::numbers_of(measure::pane_figures(*pane.given_cracks, pane));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      fmt::format_to(at, "{},{},{}\n", pane.name, measure::figure_names[i], numbers[i]);
    }
  }
  return {name + "-figures.csv", fmt::to_string(out)};
}

exporting::OutputFile experiment_csv() {
  Buffer out;
  fmt::format_to(std::back_inserter(out), "pane,radial_count,large_count,ring_radius_mean_mm\n");
  std::size_t number = 0;
  for (const measure::ExperimentPane& pane : measure::experiment_panes()) {
    fmt::format_to(std::back_inserter(out), "cr_{},{},{},{}\n", ++number, pane.radial_count, pane.large_count,
                   pane.ring_radius_mm ? fmt::format("{}", *pane.ring_radius_mm) : std::string());
  }
  return {"paper-table1.csv", fmt::to_string(out)};
}

}  // namespace shatterpave::reporting
