#include "pipeline/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/error.h"
#include "geometry/lattice.h"
#include "scene/cracks_file.h"
#include "scene/input_file.h"
#include "trace/impact.h"

namespace shatterpave::pipeline {

namespace {

using scene::FilePane;

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& message) {
  throw InputError(Place{file.string(), 0, 0, ""}, message);
}

geometry::Polygon outline_of(const FilePane& pane, const std::filesystem::path& file) {
  if (pane.outline) return *pane.outline;
  std::vector<vec2> points;
  for (const scene::FileCrack& crack : pane.cracks) {
    points.insert(points.end(), crack.line.points_mm.begin(), crack.line.points_mm.end());
  }
  const geometry::Box box = geometry::bounding_box(points);
  const vec2 low = geometry::on_lattice(box.low);
  const vec2 high = geometry::on_lattice(box.high);
  if (low.x >= high.x || low.y >= high.y) refuse(file, "expected lines that are not all on a straight line, got others");
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

// Chords of a hundredth of the pane's size.
std::vector<trace::Chord> chords_of(const FilePane& pane, double length_mm) {
  std::vector<trace::Chord> chords;
  for (const scene::FileCrack& crack : pane.cracks) {
    vec2 from = crack.line.points_mm.front();
    for (const vec2 to : crack.line.points_mm) {
      const double length = glm::length(to - from);
      if (length < length_mm) continue;
      chords.push_back({0.5 * (from + to), (to - from) / length, length});
      from = to;
    }
  }
  return chords;
}

std::vector<glass::ImpactCounts> impacts_of(const FilePane& pane, const geometry::Polygon& outline,
                                            const std::filesystem::path& file) {
  if (!pane.impacts.empty()) return pane.impacts;
  // Where lines meet is sought as in a picture of 1000 pixels on the longer side.
  const geometry::Box box = geometry::bounding_box(outline);
  const vec2 size = box.high - box.low;
  const double scale = 1000.0 / std::max(size.x, size.y);
  std::vector<trace::Chord> chords = chords_of(pane, 8.0 / scale);
  for (trace::Chord& chord : chords) {
    chord.middle = scale * (chord.middle - box.low);
    chord.length *= scale;
  }
  const auto found = trace::impact_of(chords, static_cast<int>(scale * size.x) + 1, static_cast<int>(scale * size.y) + 1);
  if (!found) refuse(file, "expected lines that leave an impact, got lines that do not meet in one place");
  glass::ImpactCounts impact;
  impact.at_mm = geometry::on_lattice(box.low + *found / scale);
  if (!geometry::contains_strictly(outline, impact.at_mm))
    refuse(file, "expected an impact within the outline, got one outside");
  return {impact};
}

glass::Pane pane_of(const FilePane& from, std::size_t index, const std::filesystem::path& file) {
  glass::Pane pane;
  pane.name = from.name.empty() ? fmt::format("pane{}", index + 1) : from.name;
  pane.outline_mm = outline_of(from, file);
  pane.thickness_mm = from.thickness_mm;
  const std::vector<glass::ImpactCounts> impacts = impacts_of(from, pane.outline_mm, file);
  try {
    pane.given_cracks = scene::network_of(from, pane.outline_mm, impacts);
  } catch (const InputError& error) {
    refuse(file, error.message());
  }
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    glass::count_again(*pane.given_cracks, static_cast<int>(i));
    glass::Impact impact;
    impact.at_mm = impacts[i].at_mm;
    impact.radial_count = pane.given_cracks->impacts[i].radial_count;
    pane.impacts.push_back(impact);
  }
  return pane;
}

}  // namespace

bool is_file_of_lines(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  return ending == ".json" || ending == ".svg";
}

scene::Scene scene_of_lines(const std::filesystem::path& file) {
  const scene::CracksFile cracks = scene::cracks_of_file(file, Place{file.string(), 0, 0, ""});
  scene::Scene scene;
  scene.name = file.stem().string();
  if (scene.name.find_first_of("\"\\") != std::string::npos)
    refuse(file, "expected a file name without quotes and backslashes, got another");
  scene.fingerprint = cracks.sum;
  std::set<std::string> names;
  for (std::size_t i = 0; i < cracks.panes.size(); ++i) {
    scene.panes.push_back(pane_of(cracks.panes[i], i, file));
    if (!names.insert(scene.panes.back().name).second)
      refuse(file, "expected panes of different names, got " + scene.panes.back().name + " twice");
  }
  return scene;
}

}  // namespace shatterpave::pipeline
