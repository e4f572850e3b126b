#include "serve/details.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.h"
#include "export/csv/tables_csv.h"
#include "export/names.h"
#include "export/svg/drawing_svg.h"
#include "geometry/polygon.h"
#include "measure/pane_figures.h"

namespace shatterpave::serve {

namespace {

using Json = nlohmann::ordered_json;

Json statistics_of(const exporting::BrokenPane& broken) {
  std::map<std::string_view, int> kinds;
  double length_mm = 0.0;
  for (const glass::Crack& crack : broken.network.cracks) {
    ++kinds[exporting::name_of(crack.kind)];
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      length_mm += glm::length(crack.points_mm[i] - crack.points_mm[i - 1]);
    }
  }
  Json cracks = Json::object();
  for (const auto& [kind, count] : kinds) cracks[std::string(kind)] = count;
  Json impacts = Json::array();
  for (const glass::ImpactCounts& impact : broken.network.impacts) {
    impacts.push_back({{"radials", impact.radial_count}, {"reaching", impact.large_count}, {"rings", impact.circular_count}});
  }
  Json entry{{"name", broken.pane.name}, {"cracks", cracks}, {"length_m", length_mm / 1000.0}, {"impacts", impacts}};
  if (!broken.network.impacts.empty() && !broken.network.cracks.empty()) {
    const measure::PaneFigures figures = measure::pane_figures(broken.network, broken.pane);
    entry["pieces"] = figures.piece_mm2.count();
    entry["median_piece_mm2"] = figures.median_piece_mm2;
  }
  return entry;
}

Json statistics_of(const exporting::PavedArea& paved) {
  std::map<std::string, int> stones;
  double area_mm2 = 0.0;
  for (const paving::Stone& stone : paved.layout.stones) {
    ++stones[fmt::format("{} {}", exporting::name_of(stone.part), exporting::name_of(stone.kind))];
    area_mm2 += geometry::area(stone.outline_mm);
  }
  Json counts = Json::object();
  for (const auto& [kind, count] : stones) counts[kind] = count;
  return {{"name", paved.pavement.name}, {"stones", counts}, {"area_m2", area_mm2 * 1e-6}, {"quantities", Json::array()}};
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

// Adds the rows of the table of quantities to the pavements of their names, which hold no comma.
void add_quantities(std::string_view table, Json& pavements) {
  constexpr std::size_t columns = 5;
  bool is_first = true;
  while (!table.empty()) {
    const std::size_t end = std::min(table.find('\n'), table.size() - 1);
    const std::vector<std::string> fields = fields_of(table.substr(0, end));
    table.remove_prefix(end + 1);
    if (std::exchange(is_first, false) || fields.size() != columns) continue;
    for (Json& pavement : pavements) {
      if (pavement["name"] != fields[0]) continue;
      pavement["quantities"].push_back(
          {{"item", fields[1]}, {"count", fields[2]}, {"area_m2", fields[3]}, {"length_m", fields[4]}});
    }
  }
}

}  // namespace

Details details(const exporting::Model& model) {
  Json panes = Json::array();
  for (const exporting::BrokenPane& broken : model.panes) panes.push_back(statistics_of(broken));
  Json pavements = Json::array();
  for (const exporting::PavedArea& paved : model.pavements) pavements.push_back(statistics_of(paved));
  if (!model.pavements.empty()) {
    for (const exporting::OutputFile& file : exporting::csv::csv_files(model)) {
      if (file.name.ends_with("-quantities.csv")) add_quantities(file.content, pavements);
    }
  }
  Details made;
  made.drawings = exporting::svg::svg_files(model);
  Json drawings = Json::array();
  for (const exporting::BrokenPane& broken : model.panes) drawings.push_back(broken.pane.name);
  for (const exporting::PavedArea& paved : model.pavements) drawings.push_back(paved.pavement.name);
  ENSURE(drawings.size() == made.drawings.size());
  made.statistics = Json{{"panes", panes}, {"pavements", pavements}, {"drawings", drawings}}.dump() + "\n";
  return made;
}

}  // namespace shatterpave::serve
