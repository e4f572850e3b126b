#include "glass/sheets.h"

#include <algorithm>

namespace shatterpave::glass {

bool has_two_sheets(const Pane& pane) {
  return std::holds_alternative<Laminated>(pane.glass) && !pane.shards && !pane.given_cracks;
}

double film_mm(const Pane& pane) {
  constexpr double of_windscreens_mm = 0.76;
  constexpr double most_share = 0.25;
  const auto* laminated = std::get_if<Laminated>(&pane.glass);
  const double usual = std::min(of_windscreens_mm, most_share * pane.thickness_mm);
  return laminated == nullptr ? 0.0 : laminated->film_mm.value_or(usual);
}

Sheet sheet_of(const Pane& pane, Ply ply) {
  if (!has_two_sheets(pane)) return {pane.thickness_mm, 0.0};
  const double thickness = 0.5 * (pane.thickness_mm - film_mm(pane));
  const double middle = 0.5 * (pane.thickness_mm - thickness);
  return {thickness, ply == Ply::near ? middle : -middle};
}

}  // namespace shatterpave::glass
