#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/functions.h"
#include "geometry/lattice.h"
#include "scene/input_file.h"
#include "scene/outline.h"
#include "scene/outline_file.h"
#include "scene/shape_choice.h"

namespace shatterpave::scene {

namespace {

using nlohmann::json;

constexpr int deepest_nesting = 64;  // a FeatureCollection's coordinates are 8 deep
constexpr std::size_t most_polygons = 100'000;

// WGS 84 (EPSG dataset, ellipsoid 7030).
constexpr double semi_major_axis_m = 6378137.0;
constexpr double flattening = 1.0 / 298.257223563;

struct FoundPolygon {
  const json* rings = nullptr;  // the coordinates of a Polygon
  std::string path;
  std::string id;  // of its feature
};

[[noreturn]] void refuse_json(const std::string& file, const std::string& path, std::string_view expected,
                              std::string_view got) {
  throw InputError(Place{file, 0, 0, path}, fmt::format("expected {}, got {}", expected, got));
}

std::string kind_of(const json& value) {
  if (value.is_string()) return fmt::format("the text {}", in_quotes(value.get_ref<const std::string&>()));
  if (value.is_number() || value.is_boolean()) return value.dump();
  if (value.is_array()) return fmt::format("an array of {} value{}", value.size(), value.size() == 1 ? "" : "s");
  return value.is_null() ? "null" : "an object";
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
  } catch (const json::exception& error) {
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected JSON, got {}", in_quotes(error.what())));
  }
}

// Collects the polygons of a GeoJSON object, in their order.
class PolygonSearch {
 public:
  explicit PolygonSearch(const std::string& file) : file_(file) {}

  void visit(const json& object, const std::string& path, const std::string& id) {
    if (!object.is_object()) refuse_json(file_, path, "a GeoJSON object", kind_of(object));
    const auto type_at = object.find("type");
    if (type_at == object.end() || !type_at->is_string()) refuse_json(file_, path, "an object with a \"type\"", "none");
    const auto& type = type_at->get_ref<const std::string&>();
    if (type == "FeatureCollection") return visit_all(object, "features", path, id);
    if (type == "GeometryCollection") return visit_all(object, "geometries", path, id);
    if (type == "Feature") return visit_feature(object, path);
    if (type == "Polygon") return add(member(object, "coordinates", path), joined(path, "coordinates"), id);
    if (type == "MultiPolygon") return add_all(object, path, id);
    constexpr std::array without_area = {"Point", "MultiPoint", "LineString", "MultiLineString"};
    if (std::ranges::find(without_area, type) == without_area.end()) {
      refuse_json(file_, joined(path, "type"), "a type of GeoJSON", in_quotes(type));
    }
  }

  const std::vector<FoundPolygon>& found() const { return found_; }

 private:
  static std::string joined(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
  }

  const json& member(const json& object, const char* key, const std::string& path) const {
    const auto at = object.find(key);
    if (at == object.end() || !at->is_array()) {
      refuse_json(file_, joined(path, key), "an array", at == object.end() ? "none" : kind_of(*at));
    }
    return *at;
  }

  void visit_all(const json& object, const char* key, const std::string& path, const std::string& id) {
    const json& list = member(object, key, path);
    for (std::size_t i = 0; i < list.size(); ++i) visit(list[i], fmt::format("{}[{}]", joined(path, key), i), id);
  }

  void visit_feature(const json& feature, const std::string& path) {
    std::string id;
    if (const auto at = feature.find("id"); at != feature.end()) {
      if (at->is_string()) id = at->get_ref<const std::string&>();
      if (at->is_number()) id = at->dump();
    }
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end()) refuse_json(file_, joined(path, "geometry"), "a geometry", "none");
    if (!geometry->is_null()) visit(*geometry, joined(path, "geometry"), id);
  }

  void add_all(const json& object, const std::string& path, const std::string& id) {
    const json& polygons = member(object, "coordinates", path);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      add(polygons[i], fmt::format("{}[{}]", joined(path, "coordinates"), i), id);
    }
  }

  void add(const json& rings, const std::string& path, const std::string& id) {
    if (!rings.is_array() || rings.empty()) refuse_json(file_, path, "an array of rings", kind_of(rings));
    if (found_.size() == most_polygons) refuse_json(file_, path, fmt::format("at most {} polygons", most_polygons), "more");
    found_.push_back({&rings, path, id});
  }

  const std::string& file_;
  std::vector<FoundPolygon> found_;
};

vec2 position_of(const json& position, const std::string& file, const std::string& path) {
  if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number()) {
    refuse_json(file, path, "a position [x, y]", kind_of(position));
  }
  return {position[0].get<double>(), position[1].get<double>()};
}

// The rings of the polygon in the units of the file.
std::vector<Ring> rings_of(const FoundPolygon& polygon, const std::string& file) {
  std::vector<Ring> rings;
  for (std::size_t r = 0; r < polygon.rings->size(); ++r) {
    const json& positions = (*polygon.rings)[r];
    const std::string path = fmt::format("{}[{}]", polygon.path, r);
    if (!positions.is_array()) refuse_json(file, path, "an array of positions", kind_of(positions));
    Ring ring{{}, Place{file, 0, 0, path}};
    for (std::size_t i = 0; i < positions.size(); ++i) {
      ring.points_mm.push_back(position_of(positions[i], file, fmt::format("{}[{}]", path, i)));
    }
    if (ring.points_mm.empty()) refuse_json(file, path, "an array of positions", "an empty one");
    rings.push_back(std::move(ring));
  }
  return rings;
}

geometry::Box box_of(const std::vector<Ring>& rings) {
  geometry::Polygon all;
  for (const Ring& ring : rings) all.insert(all.end(), ring.points_mm.begin(), ring.points_mm.end());
  return geometry::bounding_box(all);
}

bool could_be_degrees(const geometry::Box& box) {
  return box.low.x >= -180.0 && box.high.x <= 180.0 && box.low.y >= -90.0 && box.high.y <= 90.0;
}

// The name of the coordinate reference system that GeoJSON of 2008 could give; "" without one.
std::string crs_name(const json& root) {
  const json* value = &root;
  for (const char* key : {"crs", "properties", "name"}) {
    if (!value->is_object() || !value->contains(key)) return {};
    value = &value->at(key);
  }
  return value->is_string() ? value->get<std::string>() : std::string();
}

OutlineUnits units_of(const json& root, const geometry::Box& box, const OutlineChoice& choice) {
  if (choice.units) return *choice.units;
  const std::string name = crs_name(root);
  if (name.empty()) return could_be_degrees(box) ? OutlineUnits::degrees : OutlineUnits::metres;
  const bool geographic = name.find("CRS84") != std::string::npos || name.ends_with(":4326");
  return geographic ? OutlineUnits::degrees : OutlineUnits::metres;
}

// Millimetres for one degree of longitude and of latitude.
vec2 mm_per_degree(double latitude_deg) {
  constexpr double squared_eccentricity = flattening * (2.0 - flattening);
  const double latitude = latitude_deg * (pi / 180.0);
  const double s = sine(latitude);
  const double w = 1.0 - squared_eccentricity * s * s;
  const double prime_vertical_m = semi_major_axis_m / std::sqrt(w);
  const double meridian_m = semi_major_axis_m * (1.0 - squared_eccentricity) / (w * std::sqrt(w));
  return vec2{prime_vertical_m * cosine(latitude), meridian_m} * (1000.0 * pi / 180.0);
}

void project_degrees(std::vector<Ring>& rings, const geometry::Box& box) {
  const Place& place = rings.front().place;
  if (!could_be_degrees(box))
    throw InputError(place, "expected longitudes from -180 to 180 and latitudes from -90 to 90, got others");
  const vec2 middle = 0.5 * (box.low + box.high);
  const vec2 scale = mm_per_degree(middle.y);
  const vec2 size = (box.high - box.low) * scale;
  if (std::max(size.x, size.y) > 2.0 * geometry::largest_coordinate_mm) {
    throw InputError(place, fmt::format("expected an area of at most 2 km, got {:.0f} km × {:.0f} km; if these are no degrees, "
                                        "set outline_units",
                                        size.x * 1e-6, size.y * 1e-6));
  }
  for (Ring& ring : rings) {
    for (vec2& p : ring.points_mm) p = (p - middle) * scale;
  }
}

void scale_lengths(std::vector<Ring>& rings, const geometry::Box& box, double mm) {
  const double limit = geometry::largest_coordinate_mm / mm;
  const double metre = 1000.0 / mm;
  const bool near = box.low.x >= -limit && box.low.y >= -limit && box.high.x <= limit && box.high.y <= limit;
  const vec2 middle = 0.5 * (box.low + box.high);
  const vec2 origin = near ? vec2{0.0, 0.0} : vec2{std::round(middle.x / metre) * metre, std::round(middle.y / metre) * metre};
  for (Ring& ring : rings) {
    for (vec2& p : ring.points_mm) p = (p - origin) * mm;
  }
}

}  // namespace

geometry::Region outline_of_geojson(std::string_view text, const std::string& file, const OutlineChoice& choice) {
  const json root = parsed_json(text, file);
  PolygonSearch search(file);
  search.visit(root, "", "");
  std::vector<std::string> ids;
  for (const FoundPolygon& polygon : search.found()) ids.push_back(polygon.id);
  const FoundPolygon& polygon = search.found()[chosen_shape(ids, "polygon", choice, file)];

  std::vector<Ring> rings = rings_of(polygon, file);
  const geometry::Box box = box_of(rings);
  switch (units_of(root, box, choice)) {
    case OutlineUnits::degrees:
      project_degrees(rings, box);
      break;
    case OutlineUnits::metres:
      scale_lengths(rings, box, 1000.0);
      break;
    case OutlineUnits::millimetres:
      scale_lengths(rings, box, 1.0);
      break;
  }
  const Ring outline = std::move(rings.front());
  rings.erase(rings.begin());
  return region_of(outline, rings);
}

}  // namespace shatterpave::scene
