#include "pipeline/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/error.h"
#include "geometry/polygon.h"
#include "measure/scene_fit.h"
#include "pipeline/lines.h"
#include "pipeline/write.h"
#include "scene/input_file.h"

namespace shatterpave::pipeline {

namespace {

using measure::FittedValue;
using Buffer = fmt::memory_buffer;

void put_comments(Buffer& out, const std::vector<std::filesystem::path>& traces, const measure::SceneFit& fit) {
  const auto at = std::back_inserter(out);
  fmt::format_to(at, "# Fitted to {} traced pane{}:\n", traces.size(), traces.size() == 1 ? "" : "s");
  for (const std::filesystem::path& trace : traces) {
    std::string name = trace.filename().string();
    std::ranges::replace_if(
        name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    fmt::format_to(at, "#   {}\n", name);
  }
  fmt::format_to(at, "#\n# {:<20} {:>10} {:>22}\n", "figure", "traced", "panes of this scene");
  for (const measure::FigureFit& figure : fit.figures) {
    fmt::format_to(at, "# {:<20} {:>10.3f} {:>12.3f} ± {:.3f}\n", figure.figure, figure.traced, figure.mean, figure.deviation);
  }
  fmt::format_to(at,
                 "#\n# Of panes of this scene, with other seeds than it was fitted with, {:.0f} % are as far from their mean "
                 "as the traced one, or\n"
                 "# farther{}.\n\n",
                 100.0 * fit.probability, fit.probability < 0.05 ? ": what was traced is hardly of this kind" : "");
}

// The values whose keys begin with `table`, a line each.
void put_values(Buffer& out, const measure::SceneFit& fit, std::string_view table) {
  for (const FittedValue& value : fit.values) {
    if (!value.key.starts_with(table)) continue;
    fmt::format_to(std::back_inserter(out), "{} = {:.6g}  # ± {:.2g}\n", value.key.substr(table.size()), value.value,
                   value.error);
  }
}

std::string scene_text(const std::vector<std::filesystem::path>& traces, const measure::SceneFit& fit) {
  Buffer out;
  const auto at = std::back_inserter(out);
  put_comments(out, traces, fit);
  const glass::Pane& pane = fit.pane;
  fmt::format_to(at, "seed = 1\n\n[[pane]]\nname = \"{}\"\noutline_mm = [", pane.name);
  for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
    fmt::format_to(at, "{}[{}, {}]", i == 0 ? "" : ", ", pane.outline_mm[i].x, pane.outline_mm[i].y);
  }
  const bool real = pane.pattern == glass::Pattern::real;
  fmt::format_to(at, "]\nthickness_mm = {}\npattern = \"{}\"\n", pane.thickness_mm, real ? "real" : "agui1992");
  const vec2 impact = pane.impacts.front().at_mm;
  fmt::format_to(at, "\n[[pane.impact]]\nat_mm = [{}, {}]\n", impact.x, impact.y);
  put_values(out, fit, "impact[0].");
  fmt::format_to(at, "\n[pane.growth]\n");
  put_values(out, fit, "growth.");
  if (real) {
    fmt::format_to(at, "\n[pane.rings]\n");
    put_values(out, fit, "rings.");
  }
  return fmt::to_string(out);
}

}  // namespace

std::string fitted_scene_text(const std::vector<std::filesystem::path>& traces, const Progress& progress) {
  std::vector<measure::PaneFigures> figures;
  std::vector<glass::Pane> panes;
  for (const std::filesystem::path& trace : traces) {
    for (const glass::Pane& pane : scene_of_lines(trace).panes) {
      figures.push_back(measure::pane_figures(*pane.given_cracks, pane));
      panes.push_back(pane);
    }
  }
  return scene_text(traces, measure::fitted_scene(figures, panes.front(), progress));
}

void write_fitted_scene(const std::vector<std::filesystem::path>& traces, const std::filesystem::path& file,
                        const Progress& progress) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(Place{file.string(), 0, 0, ""}, "expected a file to write the scene to, got a folder");
  }
  // Before the work, which takes a while.
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError(
        Place{file.string(), 0, 0, ""},
        fmt::format("expected a file in a folder that is there, got none of the name {}", scene::in_quotes(folder.string())));
  }
  const std::string text = fitted_scene_text(traces, progress);
  // Beside it first, so that what was there stays until the new one is whole.
  const std::filesystem::path beside = file.string() + ".part";
  try {
    write_file(beside, text);
    std::filesystem::rename(beside, file);
  } catch (...) {
    std::filesystem::remove(beside, error);
    throw;
  }
}

}  // namespace shatterpave::pipeline
