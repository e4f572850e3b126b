#include "scene/cracks_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/sha256.h"
#include "geometry/lattice.h"
#include "scene/input_file.h"
#include "scene/plans/outline.h"
#include "scene/plans/plan.h"

namespace shatterpave::scene {

namespace {

using glass::CrackKind;
using nlohmann::json;

constexpr int deepest_nesting = 16;  // points of cracks are 7 deep
constexpr std::size_t most_cracks = 200'000;
constexpr std::size_t most_file_panes = 1000;
constexpr double snap_mm = 0.02;  // ends that a drawing program left a little short of a line, or beyond it

constexpr auto kind_names = std::to_array<std::pair<std::string_view, CrackKind>>({{"large", CrackKind::large},
                                                                                   {"radial", CrackKind::radial},
                                                                                   {"circular", CrackKind::circular},
                                                                                   {"branch", CrackKind::branch},
                                                                                   {"dice", CrackKind::dice},
                                                                                   {"rung", CrackKind::rung},
                                                                                   {"chip", CrackKind::chip}});

std::optional<CrackKind> kind_named(std::string_view name) {
  const auto found = std::ranges::find(kind_names, name, [](const auto& entry) { return entry.first; });
  return found == kind_names.end() ? std::nullopt : std::optional(found->second);
}

// ---- geometry files

// A value of the file and the way to it, for messages.
class Node {
 public:
  Node(const json& value, const std::string& file, std::string path) : value_(value), file_(file), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& expected) const {
    throw InputError(Place{file_, 0, 0, path_}, "expected " + expected + ", got " + found());
  }

  std::string found() const {
    if (value_.is_null()) return "nothing";
    if (value_.is_string()) return in_quotes(value_.get_ref<const std::string&>());
    return in_quotes(value_.dump(-1, ' ', false, json::error_handler_t::replace));
  }

  Node operator[](const std::string& key) const {
    static const json nothing;
    if (!value_.is_object()) refuse("an object");
    const auto found = value_.find(key);
    return {found == value_.end() ? nothing : *found, file_, path_.empty() ? key : path_ + "." + key};
  }
  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

  std::vector<Node> list(std::size_t most) const {
    if (!value_.is_array() || value_.size() > most) refuse(fmt::format("a list of at most {}", most));
    std::vector<Node> nodes;
    nodes.reserve(value_.size());
    for (std::size_t i = 0; i < value_.size(); ++i) nodes.emplace_back(value_[i], file_, fmt::format("{}[{}]", path_, i));
    return nodes;
  }
  double number(double low, double high) const {
    const double value = value_.is_number() ? value_.get<double>() : std::nan("");
    if (!(value >= low && value <= high)) refuse(fmt::format("a number from {} to {}", low, high));
    return value;
  }
  int whole(int low, int high) const {
    if (!value_.is_number_integer()) refuse(fmt::format("a whole number from {} to {}", low, high));
    return static_cast<int>(number(low, high));
  }
  std::string text() const {
    if (!value_.is_string()) refuse("a text");
    return value_.get<std::string>();
  }
  vec2 point() const {
    if (!value_.is_array() || value_.size() != 2) refuse("a point [x, y]");
    const std::vector<Node> both = list(2);
    const auto coordinate = [](const Node& node) {
      return node.number(-geometry::largest_coordinate_mm, geometry::largest_coordinate_mm);
    };
    return {coordinate(both[0]), coordinate(both[1])};
  }
  std::vector<vec2> points() const {
    std::vector<vec2> result;
    for (const Node& node : list(most_vertices)) result.push_back(node.point());
    return result;
  }
  Place place() const { return {file_, 0, 0, path_}; }

 private:
  const json& value_;
  const std::string& file_;
  std::string path_;
};

FileCrack crack_of(const Node& node, std::size_t impacts) {
  FileCrack crack;
  const std::string kind = node["kind"].text();
  const auto known = kind_named(kind);
  if (!known) node["kind"].refuse("large, radial, circular, branch, dice, rung or chip");
  crack.line.kind = *known;
  if (node.has("impact")) crack.line.impact = node["impact"].whole(0, static_cast<int>(std::max<std::size_t>(impacts, 1)) - 1);
  crack.line.points_mm = node["points_mm"].points();
  if (crack.line.points_mm.size() < 2) node["points_mm"].refuse("two points or more");
  return crack;
}

glass::ImpactCounts impact_of(const Node& node, const geometry::Polygon& outline) {
  constexpr int most = 1'000'000;
  glass::ImpactCounts impact;
  impact.at_mm = geometry::on_lattice(node["at_mm"].point());
  if (!geometry::contains_strictly(outline, impact.at_mm)) node["at_mm"].refuse("a point inside the outline of its pane");
  if (node.has("radial_count")) impact.radial_count = node["radial_count"].whole(0, most);
  if (node.has("large_count")) impact.large_count = node["large_count"].whole(0, most);
  if (node.has("circular_count")) impact.circular_count = node["circular_count"].whole(0, most);
  return impact;
}

FilePane pane_of(const Node& node) {
  FilePane pane;
  if (node.has("name")) pane.name = node["name"].text();
  pane.outline = region_of({node["outline_mm"].points(), node["outline_mm"].place()}, {}).outline;
  if (node.has("thickness_mm")) pane.thickness_mm = node["thickness_mm"].number(0.1, 1000.0);
  if (node.has("impacts")) {
    for (const Node& impact : node["impacts"].list(1000)) pane.impacts.push_back(impact_of(impact, *pane.outline));
  }
  for (const Node& crack : node["cracks"].list(most_cracks)) pane.cracks.push_back(crack_of(crack, pane.impacts.size()));
  if (pane.cracks.empty()) node["cracks"].refuse("one crack or more");
  return pane;
}

json parsed_json(const std::string& text, const std::string& file) {
  const auto limit_depth = [&](int depth, json::parse_event_t, json&) {
    if (depth <= deepest_nesting) return true;
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected at most {} levels of nesting, got more", deepest_nesting));
  };
  try {
    return json::parse(text, limit_depth);
  } catch (const json::parse_error& error) {
    const TextPosition at = text_position(text, std::min(error.byte > 0 ? error.byte - 1 : 0, text.size()));
    throw InputError(Place{file, at.line, at.column, ""}, "expected JSON, got an error");
  } catch (const json::exception&) {
    throw InputError(Place{file, 0, 0, ""}, "expected JSON with numbers in range, got others");
  }
}

std::vector<FilePane> panes_of_geometry(const std::string& text, const std::string& file) {
  const json document = parsed_json(text, file);
  const Node root(document, file, "");
  if (!document.is_object() || root["format"].text() != "shatterpave-geometry") {
    throw InputError(Place{file, 0, 0, "format"}, "expected \"shatterpave-geometry\", got another file");
  }
  root["version"].whole(1, 1);
  std::vector<FilePane> panes;
  for (const Node& node : root["panes"].list(most_file_panes)) panes.push_back(pane_of(node));
  if (panes.empty()) root["panes"].refuse("one pane or more");
  return panes;
}

// ---- drawings

bool has_class(const Plan& plan, const PlanShape& shape, std::string_view name) {
  return std::ranges::any_of(plan.features[shape.feature].classes, [&](const std::string& word) { return word == name; });
}

void add_lines(const Plan& plan, const PlanShape& shape, FilePane& pane) {
  FileCrack crack;
  crack.has_kind = false;
  for (const auto& [name, kind] : kind_names) {
    if (!has_class(plan, shape, name)) continue;
    crack.line.kind = kind;
    crack.has_kind = true;
    break;
  }
  for (const Ring& ring : shape.rings) {
    crack.line.points_mm = ring.points_mm;
    if (shape.kind == ShapeKind::area && !ring.points_mm.empty()) crack.line.points_mm.push_back(ring.points_mm.front());
    if (crack.line.points_mm.size() >= 2) pane.cracks.push_back(crack);
  }
}

void move_by(vec2 shift, FilePane& pane) {
  for (vec2& p : *pane.outline) p = geometry::on_lattice(p + shift);
  for (FileCrack& crack : pane.cracks) {
    for (vec2& p : crack.line.points_mm) p += shift;
  }
}

std::vector<FilePane> panes_of_drawing(const std::filesystem::path& file, const Place& place) {
  const Plan plan = plan_of_file(file, place);
  FilePane pane;
  for (const PlanShape& shape : plan.shapes) {
    if (shape.fault) throw InputError(shape.fault->place(), shape.fault->message());
    const bool is_line = shape.kind == ShapeKind::line;
    if (!is_line && shape.kind != ShapeKind::area) continue;
    if (shape.asked_for != AskedFor::anything && shape.asked_for != AskedFor::areas_beside_lines && !is_line) continue;
    if (!is_line && has_class(plan, shape, "outline")) {
      pane.outline = region_of(shape.rings.front(), {}).outline;
    } else {
      add_lines(plan, shape, pane);
    }
  }
  if (pane.cracks.empty()) throw InputError(Place{file.string(), 0, 0, ""}, "expected lines that are drawn, got none");
  if (pane.cracks.size() > most_cracks) {
    throw InputError(Place{file.string(), 0, 0, ""},
                     fmt::format("expected at most {} lines, got {}", most_cracks, pane.cracks.size()));
  }
  if (pane.outline) move_by(-geometry::bounding_box(*pane.outline).low, pane);
  return {pane};
}

}  // namespace

CracksFile cracks_of_file(const std::filesystem::path& file, const Place& place) {
  const std::string text = input_text(file, largest_outline_bytes, place);
  CracksFile result{file.string(), {}, {}};
  Sha256 hash;
  hash.add_text(text);
  result.sum = hash.sum();
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  result.panes = ending == ".svg" ? panes_of_drawing(file, place) : panes_of_geometry(text, file.string());
  return result;
}

glass::CrackNetwork network_of(const FilePane& pane, const geometry::Polygon& outline,
                               const std::vector<glass::ImpactCounts>& impacts) {
  std::vector<glass::DrawnCrack> lines;
  lines.reserve(pane.cracks.size());
  for (const FileCrack& crack : pane.cracks) {
    glass::DrawnCrack line = crack.line;
    line.impact = std::min(line.impact, static_cast<int>(impacts.size()) - 1);
    if (!crack.has_kind && !impacts.empty()) line.kind = glass::kind_by_direction(line.points_mm, impacts.front().at_mm);
    lines.push_back(std::move(line));
  }
  return glass::proper_network(lines, outline, impacts, snap_mm);
}

}  // namespace shatterpave::scene
