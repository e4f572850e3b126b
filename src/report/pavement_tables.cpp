#include "report/pavement_tables.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <iterator>
#include <optional>

namespace shatterpave::reporting {

namespace {

using measure::LayoutFigures;
using measure::StoneMeasures;
using measure::SurveyedPavement;
using paving::StoneKind;

// A column of the table of pavements, and a figure in JSON.
struct Column {
  std::string_view name;
  std::function<std::optional<double>(const LayoutFigures&)> value;
};

std::optional<double> of(std::size_t count, double value) { return count > 0 ? std::optional(value) : std::nullopt; }
std::optional<double> whole(std::size_t count) { return static_cast<double>(count); }

const std::vector<Column>& columns() {
  using F = LayoutFigures;
  static const std::vector<Column> all = {
      {"stones", [](const F& f) { return whole(f.stones); }},
      {"whole", [](const F& f) { return whole(f.whole); }},
      {"missing", [](const F& f) { return whole(f.missing); }},
      {"overlaps", [](const F& f) { return whole(f.faults.overlaps); }},
      {"outside", [](const F& f) { return whole(f.faults.outside); }},
      {"invalid", [](const F& f) { return whole(f.faults.invalid); }},
      {"misaligned_mean_deg", [](const F& f) { return of(f.sides, f.misaligned_mean_deg); }},
      {"misaligned_p95_deg", [](const F& f) { return of(f.sides, f.misaligned_p95_deg); }},
      {"four_sided_percent", [](const F& f) { return of(f.shaped, f.four_sided_percent); }},
      {"covered_percent", [](const F& f) { return of(f.stones, f.covered_percent); }},
      {"holes", [](const F& f) { return whole(f.holes); }},
      {"bare_spot_mm", [](const F& f) { return of(f.stones, f.bare_spot_mm); }},
      {"joints", [](const F& f) { return whole(f.joints); }},
      {"excepted_joints", [](const F& f) { return whole(f.excepted_joints); }},
      {"joint_p5_percent", [](const F& f) { return of(f.joints, f.joint_p5_percent); }},
      {"joint_median_percent", [](const F& f) { return of(f.joints, f.joint_median_percent); }},
      {"joint_p95_percent", [](const F& f) { return of(f.joints, f.joint_p95_percent); }},
      {"area_mean_percent", [](const F& f) { return of(f.sized, f.area_mean_percent); }},
      {"area_spread_percent", [](const F& f) { return of(f.sized, f.area_spread_percent); }},
      {"smallest_percent", [](const F& f) { return of(f.stones, f.smallest_percent); }},
      {"largest_length_percent", [](const F& f) { return of(f.stones, f.largest_length_percent); }},
      {"largest_width_percent", [](const F& f) { return of(f.stones, f.largest_width_percent); }},
      {"largest_area_percent", [](const F& f) { return of(f.stones, f.largest_area_percent); }},
      {"irregular_stones", [](const F& f) { return of(f.counted_stones, static_cast<double>(f.irregular_stones)); }},
      {"irregular_spots", [](const F& f) { return of(f.counted_stones, static_cast<double>(f.irregular_spots)); }},
      {"least_spots", [](const F& f) { return of(f.counted_stones, f.field.least_spots()); }},
      {"column_ends", [](const F& f) { return of(f.counted_stones, f.field.row_bends); }},
      {"row_ends", [](const F& f) { return of(f.counted_stones, f.field.column_bends); }},
      {"singularities", [](const F& f) { return of(f.counted_stones, static_cast<double>(f.field.singularities)); }},
      {"cells", [](const F& f) { return of(f.cells.counted, static_cast<double>(f.cells.counted)); }},
      {"cell_neighbours_mean", [](const F& f) { return of(f.cells.counted, f.cells.neighbours_mean); }},
      {"cell_four_percent", [](const F& f) { return of(f.cells.counted, f.cells.four_percent); }},
      {"cell_five_percent", [](const F& f) { return of(f.cells.counted, f.cells.five_percent); }},
      {"cell_six_percent", [](const F& f) { return of(f.cells.counted, f.cells.six_percent); }},
      {"cell_area_median_mm2", [](const F& f) { return of(f.cells.counted, f.cells.area_median_mm2); }},
      {"cell_area_ln_spread", [](const F& f) { return of(f.cells.counted, f.cells.area_ln_spread); }},
      {"cell_order", [](const F& f) { return of(f.cells.counted, f.cells.order); }},
      {"hand_joint_median_percent", [](const F& f) { return of(f.hand.widths, f.hand.joint_median_percent); }},
      {"hand_joint_ln_spread", [](const F& f) { return of(f.hand.widths, f.hand.joint_ln_spread); }},
      {"hand_side_spread_percent", [](const F& f) { return of(f.hand.stones, f.hand.side_spread_percent); }},
      {"hand_aspect_median", [](const F& f) { return of(f.hand.stones, f.hand.aspect_median); }},
      {"hand_aspect_p90", [](const F& f) { return of(f.hand.stones, f.hand.aspect_p90); }},
  };
  return all;
}

void put_csv(fmt::memory_buffer& out, const StoneMeasures& stone) {
  const auto at = std::back_inserter(out);
  fmt::format_to(at, ",{},{},{},{},{},{}", stone.id, stone.kind == StoneKind::whole ? "whole" : "cut",
                 stone.in_border_course ? 1 : 0, stone.missing ? 1 : 0, stone.middle_mm.x, stone.middle_mm.y);
  fmt::format_to(at, ",{},", stone.corners);
  if (stone.neighbours) fmt::format_to(at, "{}", *stone.neighbours);
  fmt::format_to(at, ",{},{:.4f},", stone.irregular ? 1 : 0, stone.area_ratio);
  if (stone.misaligned_deg) fmt::format_to(at, "{:.4f}", *stone.misaligned_deg);
  const measure::Distribution& joints = stone.joint_ratio;
  fmt::format_to(at, ",{},", joints.count());
  if (joints.count() > 0) {
    fmt::format_to(at, "{:.4f},{:.4f},{:.4f}", joints.mean(), joints.least(), joints.greatest());
  } else {
    out.append(std::string_view(",,"));
  }
  fmt::format_to(at, ",{:.4f},{:.4f},{:.4f}", stone.stock.length, stone.stock.width, stone.stock.area);
  out.push_back('\n');
}

}  // namespace

std::string pavements_csv(const measure::Survey& survey) {
  fmt::memory_buffer out;
  out.append(std::string_view("seed,pavement"));
  for (const Column& column : columns()) fmt::format_to(std::back_inserter(out), ",{}", column.name);
  out.push_back('\n');
  for (const SurveyedPavement& pavement : survey.pavements) {
    for (const measure::SurveyedLayout& layout : pavement.layouts) {
      fmt::format_to(std::back_inserter(out), "{},{}", layout.seed, pavement.pavement.name);
      for (const Column& column : columns()) {
        out.push_back(',');
        if (const auto value = column.value(layout.figures)) fmt::format_to(std::back_inserter(out), "{}", *value);
      }
      out.push_back('\n');
    }
  }
  return fmt::to_string(out);
}

std::string stones_csv(const measure::Survey& survey) {
  fmt::memory_buffer out;
  out.append(std::string_view(
      "pavement,id,kind,border_course,missing,x_mm,y_mm,corners,neighbours,irregular,area_ratio,misaligned_deg,"
      "joints,joint_mean,joint_min,joint_max,stock_length,stock_width,stock_area\n"));
  for (const SurveyedPavement& pavement : survey.pavements) {
    for (const StoneMeasures& stone : pavement.first_measures.stones) {
      out.append(pavement.pavement.name);
      put_csv(out, stone);
    }
  }
  return fmt::to_string(out);
}

Json pavement_json(const SurveyedPavement& pavement) {
  Json findings = Json::array();
  for (const measure::Finding& finding : pavement.findings) findings.push_back(json_of(finding));
  const measure::LayoutMeasures& first = pavement.first_measures;
  Json figures = Json::object();
  Json spread = Json::object();
  for (const Column& column : columns()) {
    const auto value = column.value(first.figures);
    figures[std::string(column.name)] = value ? number(*value) : Json(nullptr);
    measure::Distribution over_seeds;
    for (const measure::SurveyedLayout& layout : pavement.layouts) {
      if (const auto other = column.value(layout.figures)) over_seeds.add(*other);
    }
    spread[std::string(column.name)] = json_of(over_seeds);
  }
  Json holes = Json::array();
  for (const vec2& hole : first.holes_mm) holes.push_back({hole.x, hole.y});
  return {{"name", pavement.pavement.name},
          {"layouts", pavement.layouts.size()},
          {"findings", findings},
          {"first_seed",
           {{"figures", figures},
            {"holes_mm", holes},
            {"bare_spot_mm", {first.bare_spot_mm.x, first.bare_spot_mm.y}},
            {"misaligned_deg_histogram", json_of(first.misaligned_deg)},
            {"joint_percent_histogram", json_of(first.joints_percent)},
            {"area_percent_histogram", json_of(first.areas_percent)}}},
          {"over_seeds", spread}};
}

}  // namespace shatterpave::reporting
