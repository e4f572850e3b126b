// A feature is what shapes are chosen by; a geometry outside of features counts as one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "scene/input_file.h"
#include "scene/plan.h"

namespace shatterpave::scene {

namespace {

using nlohmann::json;

constexpr int deepest_nesting = 64;  // a FeatureCollection's coordinates are 8 deep
constexpr std::size_t most_shapes = 100'000;

[[noreturn]] void refuse_json(const std::string& file, const std::string& path, std::string_view expected,
                              std::string_view got) {
  throw InputError(Place{file, 0, 0, path}, fmt::format("expected {}, got {}", expected, got));
}

std::string in_brackets(const json& array) {
  std::string list;
  for (const json& value : array) {
    const bool text = value.is_string();
    list += (list.empty() ? "" : ", ") + (text ? in_quotes(value.get_ref<const std::string&>()) : value.dump());
  }
  return "[" + list + "]";
}

std::string kind_of(const json& value) {
  if (value.is_string()) return fmt::format("the text {}", in_quotes(value.get_ref<const std::string&>()));
  if (value.is_number() || value.is_boolean()) return value.dump();
  constexpr std::size_t short_array = 4;
  if (value.is_array() && value.size() <= short_array && std::ranges::none_of(value, &json::is_structured))
    return in_brackets(value);
  if (value.is_array()) return fmt::format("an array of {} value{}", value.size(), value.size() == 1 ? "" : "s");
  return value.is_null() ? "null" : "an object";
}

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

json parsed_json(std::string_view text, const std::string& file) {
  const auto limit_depth = [&](int depth, json::parse_event_t, json&) {
    if (depth > deepest_nesting) refuse_json(file, "", fmt::format("at most {} levels of nesting", deepest_nesting), "more");
    return true;
  };
  try {
    return json::parse(text, limit_depth);
  } catch (const json::parse_error& error) {
    const TextPosition position = text_position(text, error.byte > 0 ? error.byte - 1 : 0);
    throw InputError(Place{file, position.line, position.column, ""}, "expected JSON, got a syntax error");
  } catch (const json::out_of_range& error) {
    // "… number overflow parsing '1e400'": the number is nowhere before, or it would have been refused there.
    const std::string_view what = error.what();
    const std::size_t quote = std::min(what.find('\''), what.size());
    const std::string_view number = what.substr(quote).substr(std::min<std::size_t>(1, what.size() - quote));
    const std::string_view digits = number.substr(0, number.find('\''));
    const TextPosition position = text_position(text, std::min(text.find(digits), text.size()));
    throw InputError(Place{file, position.line, position.column, ""},
                     fmt::format("expected a number that a double can hold, got {}", in_quotes(digits)));
  } catch (const json::exception& error) {
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected JSON, got {}", in_quotes(error.what())));
  }
}

// Nothing if it is none. Numbers beyond the first two are heights and the like.
std::optional<vec2> position_of(const json& position) {
  if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number()) return std::nullopt;
  return vec2{position[0].get<double>(), position[1].get<double>()};
}

Ring positions_of(const json& positions, const std::string& file, const std::string& path) {
  if (!positions.is_array()) refuse_json(file, path, "an array of positions", kind_of(positions));
  if (positions.empty()) refuse_json(file, path, "an array of positions", "an empty one");
  Ring ring{{}, Place{file, 0, 0, path}};
  ring.points_mm.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto position = position_of(positions[i]);
    if (!position) refuse_json(file, fmt::format("{}[{}]", path, i), "a position [x, y]", kind_of(positions[i]));
    ring.points_mm.push_back(*position);
  }
  return ring;
}

// A text, a number or a boolean as it would be written by hand; nothing for other values.
std::optional<std::string> scalar_text(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number() || value.is_boolean()) return value.dump();
  return std::nullopt;
}

PlanFeature feature_of(const json& object) {
  PlanFeature feature;
  const auto add_id = [&](const json& from, const char* key) {
    const auto at = from.find(key);
    const auto id = at == from.end() ? std::nullopt : scalar_text(*at);
    if (id && !id->empty() && std::ranges::find(feature.ids, *id) == feature.ids.end()) feature.ids.push_back(*id);
  };
  add_id(object, "id");
  const auto properties = object.find("properties");
  if (properties == object.end() || !properties->is_object()) return feature;
  for (const char* key : {"id", "@id", "name"}) add_id(*properties, key);
  for (const auto& [key, value] : properties->items()) {
    const auto text = scalar_text(value);
    if (!text) continue;
    feature.classes.push_back(fmt::format("{}={}", key, *text));
    if (key != "class") continue;
    const std::vector<std::string> words = words_of(*text);
    feature.classes.insert(feature.classes.end(), words.begin(), words.end());
  }
  return feature;
}

// Collects the shapes of a GeoJSON object, in their order.
class ShapeReader {
 public:
  explicit ShapeReader(Plan& plan) : plan_(plan) {}

  void read(const json& root) {
    plan_.features.emplace_back();
    visit(root, "", 0);
  }

 private:
  void visit(const json& object, const std::string& path, std::size_t feature) {
    if (!object.is_object()) refuse_json(plan_.file, path, "a GeoJSON object", kind_of(object));
    const auto type_at = object.find("type");
    if (type_at == object.end() || !type_at->is_string()) refuse_json(plan_.file, path, "an object with a \"type\"", "none");
    const auto& type = type_at->get_ref<const std::string&>();
    if (type == "FeatureCollection") return visit_all(object, "features", path, feature);
    if (type == "GeometryCollection") return visit_all(object, "geometries", path, feature);
    if (type == "Feature") return visit_feature(object, path);
    if (!visit_geometry(object, type, path, feature)) {
      refuse_json(plan_.file, joined(path, "type"), "a type of GeoJSON", in_quotes(type));
    }
  }

  bool visit_geometry(const json& object, std::string_view type, const std::string& path, std::size_t feature) {
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
      add(coordinates, found->kind, place, feature);
      return true;
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      add(coordinates[i], found->kind, fmt::format("{}[{}]", place, i), feature);
    }
    return true;
  }

  const json& member(const json& object, const char* key, const std::string& path) const {
    const auto at = object.find(key);
    if (at == object.end() || !at->is_array()) {
      refuse_json(plan_.file, joined(path, key), "an array", at == object.end() ? "none" : kind_of(*at));
    }
    return *at;
  }

  void visit_all(const json& object, const char* key, const std::string& path, std::size_t feature) {
    const json& list = member(object, key, path);
    for (std::size_t i = 0; i < list.size(); ++i) visit(list[i], fmt::format("{}[{}]", joined(path, key), i), feature);
  }

  void visit_feature(const json& object, const std::string& path) {
    const auto geometry = object.find("geometry");
    if (geometry == object.end()) refuse_json(plan_.file, joined(path, "geometry"), "a geometry", "none");
    if (geometry->is_null()) return;
    plan_.features.push_back(feature_of(object));
    visit(*geometry, joined(path, "geometry"), plan_.features.size() - 1);
  }

  // Without coordinates a geometry is as none (RFC 7946, 3.1).
  void add(const json& coordinates, ShapeKind kind, const std::string& path, std::size_t feature) {
    PlanShape shape{kind, {}, std::nullopt, feature};
    if (kind == ShapeKind::point) {
      if (coordinates.is_array() && coordinates.empty()) return;
      const auto position = position_of(coordinates);
      if (!position) refuse_json(plan_.file, path, "a position [x, y]", kind_of(coordinates));
      shape.rings.push_back({{*position}, Place{plan_.file, 0, 0, path}});
    } else if (kind == ShapeKind::line) {
      if (coordinates.is_array() && coordinates.empty()) return;
      shape.rings.push_back(positions_of(coordinates, plan_.file, path));
    } else {
      if (!coordinates.is_array()) refuse_json(plan_.file, path, "an array of rings", kind_of(coordinates));
      if (coordinates.empty()) return;
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        shape.rings.push_back(positions_of(coordinates[i], plan_.file, fmt::format("{}[{}]", path, i)));
      }
    }
    if (plan_.shapes.size() == most_shapes)
      refuse_json(plan_.file, path, fmt::format("at most {} shapes", most_shapes), "more");
    plan_.shapes.push_back(std::move(shape));
  }

  Plan& plan_;
};

// The name of the coordinate reference system that GeoJSON of 2008 could give; "" without one.
std::string crs_name(const json& root) {
  const json* value = &root;
  for (const char* key : {"crs", "properties", "name"}) {
    if (!value->is_object() || !value->contains(key)) return {};
    value = &value->at(key);
  }
  return value->is_string() ? value->get<std::string>() : std::string();
}

// The number at the end of `urn:ogc:def:crs:EPSG::4326` or `EPSG:4326`, 0 for other names.
int epsg_code(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  if (name.find("EPSG") == std::string_view::npos || colon == std::string_view::npos) return 0;
  int code = 0;
  const std::string_view digits = name.substr(colon + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code);
  return error == std::errc{} && end == digits.data() + digits.size() ? code : 0;
}

std::optional<PlanUnits> units_of_crs(const json& root, const std::string& file) {
  const std::string name = crs_name(root);
  if (name.empty()) return std::nullopt;
  const int code = epsg_code(name);
  if (code == 3857 || code == 900913 || code == 3785) {
    refuse_json(file, "crs", "a reference system that keeps lengths, such as EPSG:4326 or UTM",
                "the web's Mercator projection");
  }
  // The dataset of EPSG keeps 4001 to 4999 for systems in degrees; of them 4978 is of space.
  const bool geographic = name.find("CRS84") != std::string::npos || (code > 4000 && code < 5000 && code != 4978);
  return geographic ? PlanUnits::degrees : PlanUnits::metres;
}

}  // namespace

Plan plan_of_geojson(std::string_view text, const std::string& file) {
  const json root = parsed_json(text, file);
  Plan plan;
  plan.file = file;
  ShapeReader(plan).read(root);
  plan.units = units_of_crs(root, file);
  return plan;
}

}  // namespace shatterpave::scene
