#include "scene/plans/geojson_crs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/polygon.h"
#include "scene/input_file.h"
#include "scene/plans/geojson_text.h"
#include "scene/plans/reference_system.h"

namespace shatterpave::scene {

namespace {

using nlohmann::json;

const json* find(const json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

// A text, or a code as a number.
std::optional<std::string> text_of(const json* value) {
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) return value->get<std::string>();
  if (value->is_number_integer()) return value->dump();
  if (value->is_number_float() && std::abs(value->get<double>()) < 1e9) return fmt::format("{:.0f}", value->get<double>());
  return std::nullopt;
}

// As ArcGIS writes them; the newer code is of EPSG where there is one.
std::optional<std::string> wkid(const json& object) {
  for (const char* key : {"latestWkid", "wkid", "wkt"}) {
    if (auto text = text_of(find(object, key))) return text;
  }
  return std::nullopt;
}

bool is_projjson(const json& crs) {
  const json* type = find(crs, "type");
  return type != nullptr && type->is_string() && type->get_ref<const std::string&>().ends_with("CRS");
}

// Of {"type": "EPSG", "properties": {"code": 3857}} or {"type": "name", "properties": {"name": …}}.
std::optional<std::string> name_in(const json& crs) {
  const json* properties = find(crs, "properties");
  const json& where = properties == nullptr ? crs : *properties;
  for (const char* key : {"name", "href"}) {
    if (auto text = text_of(find(where, key))) return text;
  }
  const auto code = text_of(find(where, "code"));
  if (!code) return wkid(where);
  const auto type = text_of(find(crs, "type"));
  const bool has_authority = code->find(':') != std::string::npos || !type || type == "name";
  return has_authority ? code : fmt::format("{}:{}", *type, *code);
}

}  // namespace

std::optional<std::string> crs_name(const json& object, const Place& record, const std::string& path) {
  const json* crs = find(object, "crs");
  if (crs == nullptr) {
    const json* reference = find(object, "spatialReference");
    return reference == nullptr ? std::nullopt : wkid(*reference);
  }
  if (is_projjson(*crs)) return crs->dump();
  auto name = crs->is_object() ? name_in(*crs) : text_of(crs);
  if (!name) refuse_json(record, joined(path, "crs"), "a reference system by name, code or link", kind_of(*crs));
  return name;
}

namespace {

InputError refusal(const Place& place, const std::string& is, bool can_be_stated) {
  return {place, fmt::format("expected a reference system that keeps lengths, such as EPSG:4326 or UTM, got {}{}", is,
                             can_be_stated ? "; set outline_units to say what its numbers are" : "")};
}

// Of all positions; nothing without any.
std::optional<vec2> middle_of(const Plan& plan) {
  std::optional<geometry::Box> box;
  for (const PlanShape& shape : plan.shapes) {
    for (const Ring& ring : shape.rings) {
      for (const vec2& p : ring.points_mm) {
        if (!box) box = geometry::Box{p, p};
        box = geometry::Box{glm::min(box->low, p), glm::max(box->high, p)};
      }
    }
  }
  return box ? std::optional(0.5 * (box->low + box->high)) : std::nullopt;
}

// Other maps than Mercator's draw lengths too long or too short as well, far from where they are meant for.
void judge_scale(const std::string& name, const Place& place, Plan& plan) {
  constexpr double most_wrong = 0.1;   // more is refused: even maps of whole continents are off by 5 % at the most
  constexpr double most_quiet = 0.01;  // less is not told: the grids of surveys are off by less than 0.1 %
  const auto middle = middle_of(plan);
  const auto scale = middle ? map_scale(name, *middle) : std::nullopt;
  if (!scale) return;
  const double wrong = std::max(scale->most - 1.0, 1.0 - scale->least);
  const std::string what =
      fmt::format("{}, a map on which lengths are {:.2f} to {:.2f} times those on the ground at this place", in_quotes(name),
                  scale->least, scale->most);
  if (wrong > most_wrong) {
    plan.units.reset();
    plan.no_units = refusal(place, what, true);
  } else if (wrong > most_quiet) {
    add_note({place, "the file names " + what}, plan.notes);
  }
}

}  // namespace

void take_reference_system(const std::string& name, const Place& place, Plan& plan) {
  const ReferenceSystem system = reference_system(name);
  plan.units = system.units;
  if (system.projected) judge_scale(name, place, plan);
  plan.axes = system.axes;
  for (PlanShape& shape : plan.shapes) {
    for (Ring& ring : shape.rings) std::ranges::transform(ring.points_mm, ring.points_mm.begin(), plan.axes);
  }
  if (system.units) return;
  if (!system.can_be_stated) throw InputError(refusal(place, system.is, false));
  plan.no_units = refusal(place, system.is, true);
}

}  // namespace shatterpave::scene
