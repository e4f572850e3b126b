// The map is data, drawn in the browser: corners in whole units of the map, from one to the next, so that a stone takes some 50
// bytes.
#include "report/pavement_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/embedded.h"
#include "paving/pavement.h"
#include "report/html.h"
#include "report/words.h"

namespace shatterpave::reporting {

namespace {

using measure::StoneMeasures;
using measure::SurveyedPavement;

// A browser draws this many within a second; of more stones the map shows a part.
constexpr double most_drawn = 200'000;
// Ids in the section, of the map and three plots, that end in the pavement's number.
constexpr int marks_of_index = 4;
// Units to the longer side of a map: well below a pixel when zoomed in to single stones of a plaza.
constexpr double map_units = 30'000.0;

bool has_part_only(const SurveyedPavement& pavement) {
  return static_cast<double>(pavement.first_layout.stones.size()) > most_drawn;
}

// Where a stone is missing, or else where the stone lies that is farthest off the rows.
vec2 worst_place(const measure::LayoutMeasures& measures) {
  if (!measures.holes_mm.empty()) return measures.holes_mm.front();
  const auto worst =
      std::ranges::max_element(measures.stones, {}, [](const StoneMeasures& s) { return s.misaligned_deg.value_or(-1.0); });
  return worst->middle_mm;
}

// What the map shows: the area, or as much about the worst place as can be drawn.
geometry::Box shown_box(const SurveyedPavement& pavement) {
  const geometry::Box all = geometry::bounding_box(pavement.pavement.area.outline);
  if (!has_part_only(pavement)) return all;
  const vec2 pitch = paving::pitch_mm(pavement.pavement);
  const double half = 0.5 * std::sqrt(most_drawn * pitch.x * pitch.y);
  const vec2 middle = worst_place(pavement.first_measures);
  return {glm::max(all.low, middle - vec2{half, half}), glm::min(all.high, middle + vec2{half, half})};
}

// From millimetres to units of the map.
struct MapScale {
  vec2 origin{0.0, 0.0};
  double unit_mm = 1.0;

  std::int64_t x(vec2 p) const { return std::llround((p.x - origin.x) / unit_mm); }
  std::int64_t y(vec2 p) const { return std::llround((p.y - origin.y) / unit_mm); }
};

Json ring_data(const geometry::Polygon& ring, const MapScale& scale) {
  Json points = Json::array();
  for (const vec2& p : ring) points.push_back({scale.x(p), scale.y(p)});
  return points;
}

std::int64_t told(bool measured, double value, double scale) { return measured ? std::llround(scale * value) : -1; }

// The numbers that templates/report/measures_map.js reads.
void append_stone(const StoneMeasures& stone, const geometry::Polygon& outline, int id_step, const MapScale& scale,
                  Json& numbers) {
  const measure::Distribution& joints = stone.joint_ratio;
  const int flags = (stone.kind == paving::StoneKind::cut ? 1 : 0) + (stone.irregular ? 2 : 0) + (stone.missing ? 4 : 0);
  const double worst_joint = std::max(joints.greatest() - 1.0, 1.0 - joints.least());
  numbers.push_back(id_step);
  numbers.push_back(flags);
  numbers.push_back(told(stone.misaligned_deg.has_value(), stone.misaligned_deg.value_or(0.0), 100.0));
  numbers.push_back(told(joints.count() > 0, worst_joint, 1000.0));
  numbers.push_back(told(stone.kind == paving::StoneKind::whole, stone.area_ratio, 1000.0));
  numbers.push_back(outline.size());
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (const vec2& p : outline) {
    numbers.push_back(scale.x(p) - x);
    numbers.push_back(scale.y(p) - y);
    x = scale.x(p);
    y = scale.y(p);
  }
}

Json map_data(const SurveyedPavement& pavement) {
  const geometry::Box box = shown_box(pavement);
  const vec2 size = box.high - box.low;
  const MapScale scale{box.low, std::max(size.x, size.y) / map_units};
  Json rings = Json::array();
  rings.push_back(ring_data(pavement.pavement.area.outline, scale));
  for (const geometry::Polygon& hole : pavement.pavement.area.holes) rings.push_back(ring_data(hole, scale));
  Json holes = Json::array();
  for (const vec2& hole : pavement.first_measures.holes_mm) holes.push_back({scale.x(hole), scale.y(hole)});
  Json stones = Json::array();
  int last_id = -1;
  for (std::size_t s = 0; s < pavement.first_layout.stones.size(); ++s) {
    const StoneMeasures& stone = pavement.first_measures.stones[s];
    const vec2 at = stone.middle_mm;
    if (at.x < box.low.x || at.y < box.low.y || at.x > box.high.x || at.y > box.high.y) continue;
    append_stone(stone, pavement.first_layout.stones[s].outline_mm, stone.id - last_id, scale, stones);
    last_id = stone.id;
  }
  return {{"size", {scale.x(box.high), scale.y(box.high)}}, {"rings", rings}, {"holes", holes}, {"stones", stones}};
}

std::string seeds_rows(const SurveyedPavement& pavement) {
  using F = measure::LayoutFigures;
  struct Row {
    std::string_view name;
    double (*value)(const F&);
    int decimals;
  };
  static constexpr Row rows[] = {
      {"Stones", [](const F& f) { return static_cast<double>(f.stones); }, 0},
      {"Sides against their rows, mean, °", [](const F& f) { return f.misaligned_mean_deg; }, 2},
      {"Sides against their rows, 95th percentile, °", [](const F& f) { return f.misaligned_p95_deg; }, 2},
      {"Four-sided, %", [](const F& f) { return f.four_sided_percent; }, 2},
      {"Covered, %", [](const F& f) { return f.covered_percent; }, 3},
      {"Widest bare spot, mm", [](const F& f) { return f.bare_spot_mm; }, 1},
      {"Joints, 95th percentile, %", [](const F& f) { return f.joint_p95_percent; }, 1},
      {"Spread of areas, %", [](const F& f) { return f.area_spread_percent; }, 2},
      {"Smallest piece, %", [](const F& f) { return f.smallest_percent; }, 1},
      {"Largest stone, area over its stock's, %", [](const F& f) { return f.largest_area_percent; }, 1},
      {"Irregular spots", [](const F& f) { return static_cast<double>(f.irregular_spots); }, 1},
  };
  Buffer out;
  for (const Row& row : rows) {
    measure::Distribution values;
    for (const measure::SurveyedLayout& layout : pavement.layouts) values.add(row.value(layout.figures));
    put_html(out, "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{:.{}f} … {:.{}f}</td></tr>\n", row.name,
             mean_and_deviation(values, row.decimals), values.least(), row.decimals, values.greatest(), row.decimals);
  }
  return fmt::to_string(out);
}

std::string seeds_table(const SurveyedPavement& pavement) {
  if (pavement.layouts.size() < 2) return "";
  return "<h3>Over the seeds</h3>\n<table>\n<thead><tr><th>Figure</th><th class=\"number\">Mean ± SD</th><th "
         "class=\"number\">Range</th>"
         "</tr></thead>\n<tbody>\n" +
         seeds_rows(pavement) + "</tbody>\n</table>\n";
}

std::string notes(const measure::LayoutFigures& f) {
  std::string words;
  if (f.excepted_joints > 0) {
    words += fmt::format("{} joints beside irregular stones are excepted with the first seed. ", grouped(f.excepted_joints));
  }
  if (f.hand.widths > 0) {
    words += fmt::format(
        "Laid by hand: with the first seed the width of joints has a median of {:.0f} % of the asked one, its logarithm a "
        "standard "
        "deviation of {:.2f}; sides one of {:.0f} % of their mean; one stone in ten is more than {:.2f} times as long as "
        "wide. ",
        f.hand.joint_median_percent, f.hand.joint_ln_spread, f.hand.side_spread_percent, f.hand.aspect_p90);
  }
  if (f.cells.counted > 0) {
    words += fmt::format(
        "Of {} cells with neighbours all round, {:.1f} % have four, {:.1f} % five, {:.1f} % six; their areas have a median of "
        "{:.0f} mm², and their logarithms a standard deviation of {:.2f}; their sides line up with the field to an order of "
        "{:.3f} (1: all do, 0: none). ",
        grouped(f.cells.counted), f.cells.four_percent, f.cells.five_percent, f.cells.six_percent, f.cells.area_median_mm2,
        f.cells.area_ln_spread, f.cells.order);
  }
  if (f.counted_stones > 0) {
    words += fmt::format(
        "The field asks for at least {:.1f} irregular spots: {:.1f} ends of columns, since rows bend, {:.1f} ends of rows, "
        "since "
        "columns do, and {} at singularities.",
        f.field.least_spots(), f.field.row_bends, f.field.column_bends, f.field.singularities);
  }
  return words;
}

}  // namespace

Json pavement_data(const SurveyedPavement& pavement) {
  const measure::LayoutMeasures& first = pavement.first_measures;
  const auto histogram = [](const measure::Histogram& h, double low, double high) {
    return Json{{"cells", histogram_data(h)}, {"range", {low, high}}};
  };
  return {{"alignment", histogram(first.misaligned_deg, 0.0, 5.0)},
          {"joints", histogram(first.joints_percent, 90.0, 110.0)},
          {"areas", histogram(first.areas_percent, 92.0, 108.0)},
          {"map", map_data(pavement)}};
}

std::string pavement_section(const SurveyedPavement& pavement, std::size_t index) {
  const measure::LayoutFigures& first = pavement.layouts.front().figures;
  const std::size_t layouts = pavement.layouts.size();
  const bool varies = pavement.pavement.variation != paving::Variation{};
  std::string section{embedded_text("measures_pavement.html")};
  const std::string number = fmt::format("{}", index);
  for (int place = 0; place < marks_of_index; ++place) fill(section, "index", number);
  fill(section, "name", escaped(pavement.pavement.name));
  fill(section, "verdicts", verdict_words(pavement.findings));
  fill(section, "stones", grouped(first.stones));
  fill(section, "whole", grouped(first.whole));
  fill(section, "layouts", layouts == 1 ? "once" : fmt::format("with each of {} seeds", layouts));
  fill(section, "variation",
       varies ? "The variation that the scene asks for is no fault: all but faults is measured before it. " : "");
  fill(section, "seed", fmt::format("{}", pavement.layouts.front().seed));
  fill(section, "extract", has_part_only(pavement) ? " Of so many stones the map shows those about the worst place." : "");
  fill(section, "findings", findings_rows(pavement.findings, fmt::format("pavement-{}-", index)));
  fill(section, "notes", notes(first));
  fill(section, "seeds_table", seeds_table(pavement));
  return section;
}

}  // namespace shatterpave::reporting
