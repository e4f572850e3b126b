// A feature is what shapes are chosen by; a geometry outside of features counts as one. What is wrong with one shape of a file
// is kept with it, for whoever chooses it; what is wrong with the file as a whole is thrown.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "scene/input_file.h"
#include "scene/plans/geojson_crs.h"
#include "scene/plans/geojson_text.h"
#include "scene/plans/plan.h"
#include "scene/plans/reference_system.h"

namespace shatterpave::scene {

namespace {

using nlohmann::json;

// Nothing if it is none. Numbers beyond the first two are heights and the like.
std::optional<vec2> position_of(const json& position) {
  if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number()) return std::nullopt;
  return vec2{position[0].get<double>(), position[1].get<double>()};
}

Ring positions_of(const json& positions, const Place& record, const std::string& path) {
  if (!positions.is_array()) refuse_json(record, path, "an array of positions", kind_of(positions));
  if (positions.empty()) refuse_json(record, path, "an array of positions", "an empty one");
  Ring ring{{}, record};
  ring.place.key = path;
  ring.points_mm.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto position = position_of(positions[i]);
    if (!position) refuse_json(record, fmt::format("{}[{}]", path, i), "a position [x, y]", kind_of(positions[i]));
    ring.points_mm.push_back(*position);
  }
  return ring;
}

// The rings of one shape; none for a geometry without coordinates, which is as none (RFC 7946, 3.1).
std::vector<Ring> rings_of(const json& coordinates, ShapeKind kind, const Place& record, const std::string& path) {
  const bool empty = coordinates.is_array() && coordinates.empty();
  if (kind == ShapeKind::point) {
    if (empty) return {};
    const auto position = position_of(coordinates);
    if (!position) refuse_json(record, path, "a position [x, y]", kind_of(coordinates));
    Ring ring{{*position}, record};
    ring.place.key = path;
    return {ring};
  }
  if (kind == ShapeKind::line) {
    if (empty) return {};
    return {positions_of(coordinates, record, path)};
  }
  if (!coordinates.is_array()) refuse_json(record, path, "an array of rings", kind_of(coordinates));
  std::vector<Ring> rings;
  const bool without_points =
      std::ranges::all_of(coordinates, [](const json& ring) { return ring.is_array() && ring.empty(); });
  for (std::size_t i = 0; i < coordinates.size() && !without_points; ++i) {
    rings.push_back(positions_of(coordinates[i], record, fmt::format("{}[{}]", path, i)));
  }
  return rings;
}

// A text, a number or a boolean as it would be written by hand; nothing for other values.
std::optional<std::string> scalar_text(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  constexpr double all_whole = 9007199254740992.0;  // 2^53: up to it a double holds every whole number
  if (value.is_number_float() && std::abs(value.get<double>()) < all_whole) {
    // A number of a table that has only one kind of them: 7.0.
    const double number = value.get<double>();
    if (number == std::round(number)) return fmt::format("{:.0f}", number);
  }
  if (value.is_number() || value.is_boolean()) return value.dump();
  return std::nullopt;
}

void add_new(const std::string& name, std::vector<std::string>& names) {
  if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// The texts of an object of languages, or of such objects: {"en": …}, {"primary": …, "common": {"en": …}}.
void add_names(const std::string& key, const json& value, PlanFeature& feature) {
  if (value.is_string()) {
    add_new(value.get<std::string>(), feature.more_ids);
    feature.classes.push_back(fmt::format("{}={}", key, value.get_ref<const std::string&>()));
  }
  if (!value.is_object()) return;
  for (const auto& [language, name] : value.items()) add_names(fmt::format("{}:{}", key, language), name, feature);
}

void add_property(const std::string& key, const json& value, PlanFeature& feature) {
  const auto text = scalar_text(value);
  if (!text) {
    if (key == "name" || key == "names") add_names(key, value, feature);
    return;
  }
  // Numbers as the file writes them, and as one would.
  feature.classes.push_back(fmt::format("{}={}", key, *text));
  if (value.is_number() && value.dump() != *text) feature.classes.push_back(fmt::format("{}={}", key, value.dump()));
  if (key.starts_with("name:")) add_new(*text, feature.more_ids);
  if (key != "class") return;
  const std::vector<std::string> words = words_of(*text);
  feature.classes.insert(feature.classes.end(), words.begin(), words.end());
}

PlanFeature feature_of(const json& object) {
  PlanFeature feature;
  const auto add_id = [&](const json& from, const char* key) {
    const auto at = from.find(key);
    const auto id = at == from.end() ? std::nullopt : scalar_text(*at);
    if (!id) return;
    add_new(*id, feature.ids);
    if (at->is_number()) add_new(at->dump(), feature.ids);
  };
  add_id(object, "id");
  const auto properties = object.find("properties");
  if (properties == object.end() || !properties->is_object()) return feature;
  for (const char* key : {"id", "@id", "name"}) add_id(*properties, key);
  for (const auto& [key, value] : properties->items()) add_property(key, value, feature);
  return feature;
}

// What holds for an object: its feature, and the reference system that it or an object about it names, "" for none.
struct Within {
  std::size_t feature = 0;
  std::string crs;
};

// Collects the shapes of GeoJSON objects, in their order.
class ShapeReader {
 public:
  explicit ShapeReader(Plan& plan) : plan_(plan) {}

  void read(const JsonRecord& record, bool of_several) {
    record_ = record.place;
    plan_.features.emplace_back();
    const Within all{plan_.features.size() - 1, ""};
    if (of_several) return visit_or_fault(record.value, "", all);
    visit(record.value, "", all);
  }

  // The systems that shapes are in, with the first shape of each.
  const std::map<std::string, Place>& systems() const { return systems_; }

 private:
  void visit(const json& object, const std::string& path, Within within) {
    if (!object.is_object()) refuse_json(record_, path, "a GeoJSON object", kind_of(object));
    const auto type_at = object.find("type");
    if (type_at == object.end() || !type_at->is_string()) refuse_json(record_, path, "an object with a \"type\"", "none");
    const auto& type = type_at->get_ref<const std::string&>();
    if (auto crs = crs_name(object, record_, path)) within.crs = *std::move(crs);
    if (type == "FeatureCollection") {
      const json& list = member(object, "features", path);
      for (std::size_t i = 0; i < list.size(); ++i) {
        visit_or_fault(list[i], fmt::format("{}[{}]", joined(path, "features"), i), within);
      }
    } else if (type == "GeometryCollection") {
      const json& list = member(object, "geometries", path);
      for (std::size_t i = 0; i < list.size(); ++i) {
        visit(list[i], fmt::format("{}[{}]", joined(path, "geometries"), i), within);
      }
    } else if (type == "Feature") {
      visit_feature(object, path, within);
    } else if (!visit_geometry(object, type, path, within)) {
      refuse_json(record_, joined(path, "type"), "a type of GeoJSON", in_quotes(type));
    }
  }

  // A feature among several: what is wrong with it concerns it alone.
  void visit_or_fault(const json& object, const std::string& path, const Within& within) {
    std::optional<InputError> fault;
    const std::size_t features = plan_.features.size();
    try {
      visit(object, path, within);
    } catch (const InputError& error) {
      fault = error;
    }
    if (!fault) return;
    // That of the feature, if it came so far.
    const std::size_t feature = plan_.features.size() > features ? plan_.features.size() - 1 : within.feature;
    add({ShapeKind::area, {}, std::nullopt, feature, std::move(fault)}, path, within);
  }

  bool visit_geometry(const json& object, std::string_view type, const std::string& path, const Within& within) {
    struct GeometryType {
      std::string_view name;
      ShapeKind kind;
      bool many;
    };
    constexpr std::array types = {
        GeometryType{"Polygon", ShapeKind::area, false},    GeometryType{"MultiPolygon", ShapeKind::area, true},
        GeometryType{"LineString", ShapeKind::line, false}, GeometryType{"MultiLineString", ShapeKind::line, true},
        GeometryType{"Point", ShapeKind::point, false},     GeometryType{"MultiPoint", ShapeKind::point, true}};
    const auto* found = std::ranges::find(types, type, &GeometryType::name);
    if (found == types.end()) return false;
    const json& coordinates = member(object, "coordinates", path);
    const std::string place = joined(path, "coordinates");
    if (!found->many) {
      read_shape(coordinates, found->kind, place, within);
      return true;
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      read_shape(coordinates[i], found->kind, fmt::format("{}[{}]", place, i), within);
    }
    return true;
  }

  const json& member(const json& object, const char* key, const std::string& path) const {
    const auto at = object.find(key);
    if (at == object.end() || !at->is_array()) {
      refuse_json(record_, joined(path, key), "an array", at == object.end() ? "none" : kind_of(*at));
    }
    return *at;
  }

  void visit_feature(const json& object, const std::string& path, Within within) {
    const auto geometry = object.find("geometry");
    if (geometry != object.end() && geometry->is_null()) return;
    plan_.features.push_back(feature_of(object));
    within.feature = plan_.features.size() - 1;
    if (geometry == object.end()) refuse_json(record_, joined(path, "geometry"), "a geometry", "none");
    visit(*geometry, joined(path, "geometry"), within);
  }

  void read_shape(const json& coordinates, ShapeKind kind, const std::string& path, const Within& within) {
    PlanShape shape{kind, {}, std::nullopt, within.feature, std::nullopt};
    try {
      shape.rings = rings_of(coordinates, kind, record_, path);
    } catch (const InputError& error) {
      shape.fault = error;
    }
    if (shape.fault || !shape.rings.empty()) add(std::move(shape), path, within);
  }

  void add(PlanShape shape, const std::string& path, const Within& within) {
    if (plan_.shapes.size() == most_shapes) refuse_json(record_, path, fmt::format("at most {} shapes", most_shapes), "more");
    if (!shape.fault) {
      Place place = record_;
      place.key = path;
      systems_.emplace(within.crs, std::move(place));
    }
    plan_.shapes.push_back(std::move(shape));
  }

  Plan& plan_;
  Place record_;
  std::map<std::string, Place> systems_;
};

// Shapes of one file lie in one system, or in several whose coordinates are degrees all the same.
void take_systems(const std::map<std::string, Place>& systems, Plan& plan) {
  constexpr std::size_t most_systems = 16;  // each is looked up
  if (systems.size() > most_systems) {
    refuse_json(Place{plan.file, 0, 0, ""}, "crs", fmt::format("at most {} reference systems", most_systems), "more");
  }
  const auto first = std::ranges::find_if(systems, [](const auto& system) { return !system.first.empty(); });
  if (first == systems.end()) return;
  const auto crs = [&](const Place& shape) {
    Place place = shape;
    place.key = "crs";
    return place;
  };
  take_reference_system(first->first, crs(first->second), plan);
  for (const auto& [name, place] : systems) {
    if (name == first->first) continue;
    const bool degrees = plan.units && alike(*plan.units, PlanUnits::degrees);
    const auto other = name.empty() ? PlanUnits::degrees : reference_system(name).units;
    if (degrees && other && alike(*other, PlanUnits::degrees)) continue;
    refuse_json(place, place.key, "one reference system for all shapes",
                fmt::format("{} beside {}", name.empty() ? "none" : in_quotes(name), in_quotes(first->first)));
  }
}

}  // namespace

Plan plan_of_geojson(std::string_view text, const std::string& file) {
  Plan plan;
  plan.file = file;
  ShapeReader reader(plan);
  const std::vector<JsonRecord> records = json_records(text, file);
  for (const JsonRecord& record : records) reader.read(record, records.size() > 1);
  take_systems(reader.systems(), plan);
  return plan;
}

}  // namespace shatterpave::scene
