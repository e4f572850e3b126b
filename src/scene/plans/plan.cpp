#include "scene/plans/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>

#include "core/sha256.h"
#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// Shapes of the kinds that are asked for.
class Candidates {
 public:
  Candidates(const Plan& plan, const std::vector<ShapeKind>& kinds, const ShapeChoice& choice)
      : plan_(plan), choice_(choice), what_(name_of(plan, kinds)) {
    const bool areas = std::ranges::find(kinds, ShapeKind::area) != kinds.end();
    const bool lines = std::ranges::find(kinds, ShapeKind::line) != kinds.end();
    for (std::size_t i = 0; i < plan.shapes.size(); ++i) {
      const PlanShape& shape = plan.shapes[i];
      if (shape.kind == ShapeKind::unread && areas) unread_.push_back(i);
      if (std::ranges::find(kinds, shape.kind) == kinds.end() || !answers(shape.asked_for, areas, lines)) continue;
      named_.push_back(i);
      if (!shape.open) shapes_.push_back(i);
    }
    if (shapes_.empty()) shapes_ = without_parts(named_);
    if (shapes_.empty()) throw InputError(Place{plan.file, 0, 0, ""}, fmt::format("expected a {}, got none", what_));
  }

  std::vector<std::size_t> all() const {
    return with_unread(without_parts(named_), [](std::size_t) { return true; });
  }

  std::vector<std::size_t> with_class(const std::string& class_name) const {
    std::vector<std::size_t> found;
    const auto of_class = [&](std::size_t shape) { return has_class(plan_.shapes[shape].feature, class_name); };
    std::ranges::copy_if(named_, std::back_inserter(found), of_class);
    if (!found.empty()) return with_unread(without_parts(found), of_class);
    throw InputError(choice_.place,
                     fmt::format("expected a class that a {} of {} has, got {}, which none has", what_,
                                 in_quotes(std::filesystem::path(plan_.file).filename().string()), in_quotes(class_name)));
  }

  std::size_t at(std::size_t index) const {
    if (index < shapes_.size()) return shapes_[index];
    throw InputError(choice_.place,
                     fmt::format("expected an index below {}, the number {}; got {}", shapes_.size(), of_file(), index));
  }

  std::vector<std::size_t> with_id(const std::string& id) const {
    std::vector<std::size_t> own;
    std::vector<std::size_t> in_group;
    for (const std::size_t shape : named_) {
      const std::size_t feature = plan_.shapes[shape].feature;
      if (holds(plan_.features[feature].ids, id)) {
        own.push_back(shape);
      } else if (in_group_with_id(feature, id)) {
        in_group.push_back(shape);
      }
    }
    if (own.empty() && !in_group.empty()) {
      return with_unread(without_parts(in_group),
                         [&](std::size_t shape) { return in_group_with_id(plan_.shapes[shape].feature, id); });
    }
    if (own.empty()) own = also_called(id);
    if (!own.empty() && of_one_feature(own)) return own;
    refuse_ids(fmt::format("{}, the id of {}", in_quotes(id), own.size()));
  }

  std::vector<std::size_t> of_the_only_feature() const {
    if (!of_one_feature(shapes_)) refuse_ids("none");
    return shapes_;
  }

 private:
  std::vector<std::size_t> also_called(const std::string& name) const {
    std::vector<std::size_t> found;
    std::ranges::copy_if(shapes_, std::back_inserter(found),
                         [&](std::size_t shape) { return holds(plan_.features[plan_.shapes[shape].feature].more_ids, name); });
    return found;
  }

  static bool answers(AskedFor asked_for, bool areas, bool lines) {
    switch (asked_for) {
      case AskedFor::areas_alone:
        return areas && !lines;
      case AskedFor::areas_beside_lines:
        return areas && lines;
      case AskedFor::lines_alone:
        return lines && !areas;
      case AskedFor::anything:
        break;
    }
    return true;
  }

  // Without those that an outline among them is joined of.
  std::vector<std::size_t> without_parts(std::vector<std::size_t> shapes) const {
    std::vector<std::size_t> parts;
    for (const std::size_t shape : shapes) {
      parts.insert(parts.end(), plan_.shapes[shape].parts.begin(), plan_.shapes[shape].parts.end());
    }
    std::ranges::sort(parts);
    std::erase_if(shapes, [&](std::size_t shape) { return std::ranges::binary_search(parts, shape); });
    return shapes;
  }

  template <typename Chosen>
  std::vector<std::size_t> with_unread(std::vector<std::size_t> shapes, Chosen is_chosen) const {
    std::ranges::copy_if(unread_, std::back_inserter(shapes), is_chosen);
    std::ranges::sort(shapes);
    return shapes;
  }

  static std::string_view name_of(const Plan& plan, const std::vector<ShapeKind>& kinds) {
    if (kinds.size() > 1) return "shape";
    if (kinds.front() == ShapeKind::line) return "line";
    return plan.svg ? "closed shape" : "polygon";
  }

  bool of_one_feature(const std::vector<std::size_t>& shapes) const {
    return std::ranges::all_of(
        shapes, [&](std::size_t shape) { return plan_.shapes[shape].feature == plan_.shapes[shapes.front()].feature; });
  }

  bool in_group_with_id(std::size_t feature, const std::string& id) const {
    for (auto group = plan_.features[feature].group; group; group = plan_.features[*group].group) {
      if (holds(plan_.features[*group].ids, id)) return true;
    }
    return false;
  }

  bool has_class(std::size_t feature, const std::string& class_name) const {
    for (std::optional<std::size_t> at = feature; at; at = plan_.features[*at].group) {
      if (holds(plan_.features[*at].classes, class_name)) return true;
    }
    return false;
  }

  std::string of_file() const {
    return fmt::format("of the {} {}s of {}", shapes_.size(), what_,
                       in_quotes(std::filesystem::path(plan_.file).filename().string()));
  }

  [[noreturn]] void refuse_ids(const std::string& got) const {
    constexpr std::size_t most_listed = 10;
    std::string list;
    for (std::size_t i = 0; i < std::min(shapes_.size(), most_listed); ++i) {
      const PlanFeature& feature = plan_.features[plan_.shapes[shapes_[i]].feature];
      list += fmt::format("{}{}", list.empty() ? "" : ", ", i);
      if (!feature.ids.empty()) list += fmt::format(" (id {})", in_quotes(feature.ids.front()));
    }
    if (shapes_.size() > most_listed) list += ", …";
    throw InputError(choice_.place, fmt::format("expected the id or the index of one {}: {}; got {}", of_file(), list, got));
  }

  const Plan& plan_;
  const ShapeChoice& choice_;
  std::string_view what_;
  std::vector<std::size_t> shapes_;  // those that are counted
  std::vector<std::size_t> named_;   // those that may be asked for by name
  std::vector<std::size_t> unread_;
};

}  // namespace

std::vector<std::size_t> chosen_shapes(const Plan& plan, const std::vector<ShapeKind>& kinds, const ShapeChoice& choice,
                                       ByDefault by_default) {
  const Candidates candidates(plan, kinds, choice);
  if (choice.class_name) return candidates.with_class(*choice.class_name);
  if (choice.shapes.empty()) return by_default == ByDefault::all ? candidates.all() : candidates.of_the_only_feature();
  std::vector<std::size_t> chosen;
  for (const auto& wanted : choice.shapes) {
    if (const auto* index = std::get_if<std::size_t>(&wanted)) {
      chosen.push_back(candidates.at(*index));
      continue;
    }
    const std::vector<std::size_t> found = candidates.with_id(std::get<std::string>(wanted));
    chosen.insert(chosen.end(), found.begin(), found.end());
  }
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

namespace {

// Of GeoJSON; those on the second line are in use for one feature a line (or record).
constexpr std::array<std::string_view, 10> geojson_endings = {".geojson",   ".json",  //
                                                              ".geojsonl",  ".geojsonld", ".geojsons", ".geojsonseq",
                                                              ".ndgeojson", ".ndjson",    ".jsonl",    ".jsonlines"};

enum class PlanFormat { geojson, svg, dxf };

std::optional<PlanFormat> format_of_name(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".svg") return PlanFormat::svg;
  if (ending == ".dxf") return PlanFormat::dxf;
  if (std::ranges::find(geojson_endings, ending) != geojson_endings.end()) return PlanFormat::geojson;
  return std::nullopt;
}

// By what every text of XML begins with, and every DXF but for its comments.
PlanFormat format_of_text(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF\xFF\xFE");
  if (first == std::string_view::npos) return PlanFormat::geojson;
  if (text[first] == '<') return PlanFormat::svg;
  const std::string_view code = text.substr(first, text.find_first_of("\r\n", first) - first);
  return code == "0" || code == "999" ? PlanFormat::dxf : PlanFormat::geojson;
}

Plan read_as(PlanFormat format, const std::string& text, const std::string& file, double svg_scale) {
  switch (format) {
    case PlanFormat::svg:
      return plan_of_svg(text, file, svg_scale);
    case PlanFormat::dxf:
      return plan_of_dxf(text, file);
    case PlanFormat::geojson:
      break;
  }
  return plan_of_geojson(text, file);
}

}  // namespace

Plan plan_of_file(const std::filesystem::path& file, const Place& place, double svg_scale) {
  const std::optional<PlanFormat> named = format_of_name(file);
  std::error_code error;
  if (!named && !is_nameless(file) && !std::filesystem::is_fifo(file, error)) {
    throw InputError(place,
                     "expected a file that ends in .geojson, .json, .svg or .dxf, got " + in_quotes(file.filename().string()));
  }
  const std::string text = input_text(file, largest_outline_bytes, place);
  const PlanFormat format = named ? *named : format_of_text(text);
  if (format == PlanFormat::geojson) require_utf8(text, file.string());
  Plan plan = read_as(format, text, file.string(), svg_scale);
  plan.sum = sha256(text);
  return plan;
}

}  // namespace shatterpave::scene
