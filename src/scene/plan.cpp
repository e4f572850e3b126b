#include "scene/plan.h"

#include <fmt/format.h>

#include <algorithm>

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
    for (std::size_t i = 0; i < plan.shapes.size(); ++i) {
      if (std::ranges::find(kinds, plan.shapes[i].kind) != kinds.end()) shapes_.push_back(i);
    }
    if (shapes_.empty()) throw InputError(Place{plan.file, 0, 0, ""}, fmt::format("expected a {}, got none", what_));
  }

  const std::vector<std::size_t>& all() const { return shapes_; }

  std::vector<std::size_t> with_class(const std::string& class_name) const {
    std::vector<std::size_t> found;
    for (const std::size_t shape : shapes_) {
      if (has_class(plan_.shapes[shape].feature, class_name)) found.push_back(shape);
    }
    if (!found.empty()) return found;
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
    for (const std::size_t shape : shapes_) {
      const std::size_t feature = plan_.shapes[shape].feature;
      if (holds(plan_.features[feature].ids, id)) {
        own.push_back(shape);
      } else if (in_group_with_id(feature, id)) {
        in_group.push_back(shape);
      }
    }
    if (own.empty() && !in_group.empty()) return in_group;
    if (!own.empty() && of_one_feature(own)) return own;
    refuse_ids(fmt::format("{}, the id of {}", in_quotes(id), own.size()));
  }

  std::vector<std::size_t> of_the_only_feature() const {
    if (!of_one_feature(shapes_)) refuse_ids("none");
    return shapes_;
  }

 private:
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
  std::vector<std::size_t> shapes_;
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

Plan plan_of_file(const std::filesystem::path& file, const Place& place, double svg_scale) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool svg = ending == ".svg";
  if (!svg && ending != ".geojson" && ending != ".json") {
    throw InputError(place, "expected a file that ends in .geojson, .json or .svg, got " + in_quotes(file.filename().string()));
  }
  const std::string text = input_text(file, largest_outline_bytes, place);
  require_utf8(text, file.string());
  Plan plan = svg ? plan_of_svg(text, file.string(), svg_scale) : plan_of_geojson(text, file.string());
  plan.sum = sha256(text);
  return plan;
}

}  // namespace shatterpave::scene
