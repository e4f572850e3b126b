// A spelling is taken apart into authority and code, which PROJ looks up; what has no authority is a name or a definition.
// PROJ's own reading of names is not used, since it answers with the nearest one ("foo" with "Amersfoort").
#include "scene/plans/reference_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/functions.h"
#include "scene/input_file.h"
#include "scene/plans/plan_frame.h"
#include "scene/plans/proj_library.h"

namespace shatterpave::scene {

namespace {

constexpr std::size_t longest_definition = 100'000;  // WKT of the longest system of EPSG's dataset: 5,000

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) { return lower(c); });
  return result;
}

// Letters and digits alone: "WGS 84 / UTM zone 33N" and "wgs84_utm_zone_33n" are one name.
std::string bare(std::string_view name) {
  std::string result = lower(name);
  std::erase_if(result, [](char c) { return !is_letter(c) && !is_digit(c) && static_cast<unsigned char>(c) < 0x80; });
  return result;
}

bool all_digits(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_digit); }

using Object = std::unique_ptr<PJ, decltype(&::proj_destroy)>;

// PROJ with its own dataset and no settings of the user.
class Session {
 public:
  Session() : proj_(proj_library()), context_(proj_.context_create(), proj_.context_destroy) {
    if (!context_) throw std::runtime_error("PROJ gives no context");
    proj_.log_level(context_.get(), PJ_LOG_NONE);
    const char* const folder = SHATTERPAVE_PROJ_DATA;
    proj_.context_set_search_paths(context_.get(), 1, &folder);
    proj_.context_set_enable_network(context_.get(), 0);
    // PROJ takes other datasets from that variable, but for where it is given one: an empty one.
    const std::array<const char*, 2> others = {std::getenv("PROJ_AUX_DB") == nullptr ? nullptr : ":memory:", nullptr};
    if (proj_.context_set_database_path(context_.get(), SHATTERPAVE_PROJ_DATA "/proj.db", others.data(), nullptr) == 0) {
      throw std::runtime_error("cannot open PROJ's dataset " SHATTERPAVE_PROJ_DATA "/proj.db");
    }
  }

  const ProjLibrary& proj() const { return proj_; }
  PJ_CONTEXT* context() const { return context_.get(); }
  Object object(PJ* raw) const { return {raw, proj_.destroy}; }
  Object defined(const std::string& text) const { return object(proj_.create(context(), text.c_str())); }
  Object by_code(const std::string& authority, const std::string& code) const {
    return object(proj_.create_from_database(context(), authority.c_str(), code.c_str(), PJ_CATEGORY_CRS, 0, nullptr));
  }

  // An authority as the dataset spells it; "" for what is none.
  std::string authority(std::string_view word) const {
    const std::string wanted = lower(word) == "iau" ? "iau_2015" : lower(word) == "google" ? "epsg" : lower(word);
    std::string result;
    const PROJ_STRING_LIST names = proj_.get_authorities_from_database(context());
    for (PROJ_STRING_LIST name = names; name != nullptr && *name != nullptr; ++name) {
      if (lower(*name) == wanted) result = *name;
    }
    proj_.string_list_destroy(names);
    return result;
  }

 private:
  const ProjLibrary& proj_;
  std::unique_ptr<PJ_CONTEXT, decltype(&::proj_context_destroy)> context_;
};

// One for each thread, since opening the dataset takes longer than most questions to it.
const Session& session_of_thread() {
  thread_local const Session session;
  return session;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view spaces = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(spaces), text.size());
  return text.substr(begin, text.find_last_not_of(spaces) + 1 - begin);
}

std::string_view between(std::string_view text, std::string_view before, std::string_view after) {
  const std::size_t at = text.find(before);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = text.substr(at + before.size());
  return rest.substr(0, rest.find(after));
}

// The part of a compound spelling that is of the plane: the first.
std::string_view first_part(std::string_view text) {
  const std::string_view of_address = between(text, "/crs-compound?1=", "&2=");
  if (!of_address.empty()) return of_address;
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return text.substr(0, text.find('+'));
  const std::string_view head = text.substr(0, comma);
  if (!lower(head).starts_with("urn:") || head.find(':', 4) == std::string_view::npos) return text;
  // "urn:ogc:def:crs,crs:EPSG::4326,crs:EPSG::5773", or without the empty first one.
  return lower(head).ends_with(":crs") ? between(text, ",", ",") : head;
}

std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts;
  constexpr std::string_view marks = ":/#?&=";
  for (std::size_t at = text.find_first_not_of(marks); at < text.size(); at = text.find_first_not_of(marks, at)) {
    const std::size_t end = std::min(text.find_first_of(marks, at), text.size());
    parts.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return parts;
}

struct Code {
  std::string authority;
  std::string code;
};

// "crs84H" as the dataset writes it.
std::string ogc_code(std::string_view code) {
  std::string result = lower(code);
  if (all_digits(result)) return "CRS" + result;
  if (result.starts_with("crs")) result.replace(0, 3, "CRS");
  return result;
}

bool is_ogc_code(std::string_view word) {
  const std::string code = lower(word);
  return code.size() >= 5 && code.starts_with("crs") && all_digits(code.substr(3, 2)) &&
         code.substr(5, 2).find_first_not_of('h') == std::string::npos;
}

// Authority and code of a spelling that has them.
std::optional<Code> code_of(const Session& session, std::string_view text) {
  const std::vector<std::string> parts = parts_of(text);
  if (parts.empty() || text.find(' ') != std::string_view::npos) return std::nullopt;
  if (parts.size() == 1 && all_digits(parts[0])) return Code{"EPSG", parts[0]};
  if (parts.size() == 1 && is_ogc_code(parts[0])) return Code{"OGC", ogc_code(parts[0])};
  if (parts.size() == 2 && lower(parts[0]) == "crs") return Code{"OGC", ogc_code(parts[1])};
  for (std::size_t i = parts.size() - 1; i-- > 0;) {
    // "epsg.io" and "epsg.xml" too.
    const std::string authority = session.authority(std::string_view(parts[i]).substr(0, parts[i].find('.')));
    if (authority.empty()) continue;
    if (authority == "OGC") return Code{authority, ogc_code(parts.back())};
    if (authority != "EPSG" && authority != "ESRI") return Code{authority, parts.back()};
    // What comes before a code is its version; an address may go on behind it. No code has less than four digits.
    const auto from = parts.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const auto code = std::find_if(from, parts.end(), [](const std::string& part) {
      const std::string_view number = std::string_view(part).substr(0, part.find('.'));
      return number.size() >= 4 && all_digits(number);
    });
    if (code == parts.end()) return Code{authority, parts.back()};
    return Code{authority, code->substr(0, code->find('.'))};
  }
  return std::nullopt;
}

// Codes of Esri are often written as if they were of EPSG.
Object by_code(const Session& session, const Code& code) {
  Object found = session.by_code(code.authority, code.code);
  if (!found && code.authority == "EPSG") found = session.by_code("ESRI", code.code);
  return found;
}

bool is_definition(std::string_view text) {
  return text.starts_with('{') || text.starts_with('+') || text.starts_with("proj=") ||
         text.find('[') != std::string_view::npos;
}

Object by_definition(const Session& session, std::string_view text) {
  const std::string_view init = between(text, "init=", " ");
  if (!init.empty()) {
    const auto code = code_of(session, init);
    return code ? by_code(session, *code) : session.object(nullptr);
  }
  std::string definition(text);
  const bool of_proj = text.starts_with('+') || text.starts_with("proj=");
  // A row of operations is none, though PROJ takes it for one if it is told so.
  if (of_proj && text.find("proj=pipeline") != std::string_view::npos) return session.object(nullptr);
  if (of_proj && text.find("type=crs") == std::string_view::npos) definition += " +type=crs";
  return session.defined(definition);
}

bool has_plane(PJ_TYPE type) {
  return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS || type == PJ_TYPE_PROJECTED_CRS ||
         type == PJ_TYPE_COMPOUND_CRS;
}

// Those that have the name, the more exactly the better; of them those with a plane, if there are any.
std::vector<Object> called(const Session& session, std::string_view name, bool nearly) {
  constexpr std::size_t most = 100;
  constexpr std::array types = {PJ_TYPE_CRS};
  const ProjLibrary& proj = session.proj();
  PJ_OBJ_LIST* list = proj.create_from_name(session.context(), nullptr, std::string(name).c_str(), types.data(), types.size(),
                                            nearly ? 1 : 0, most, nullptr);
  if (list == nullptr) return {};
  std::vector<Object> with_plane;
  std::vector<Object> others;
  const int count = proj.list_get_count(list);
  for (int i = 0; i < count; ++i) {
    Object found = session.object(proj.list_get(session.context(), list, i));
    if (!found || (nearly && bare(proj.get_name(found.get())) != bare(name))) continue;
    (has_plane(proj.get_type(found.get())) ? with_plane : others).push_back(std::move(found));
  }
  proj.list_destroy(list);
  return with_plane.empty() ? std::move(others) : std::move(with_plane);
}

std::vector<Object> by_name(const Session& session, std::string_view name) {
  std::vector<Object> found = called(session, name, false);
  if (found.empty()) found = called(session, name, true);
  return found;
}

// What the text may mean: one system, but for names.
std::vector<Object> objects_of(const Session& session, std::string_view given) {
  const std::string_view text = trimmed(given);
  std::vector<Object> found;
  // PROJ reads texts to their first zero.
  if (text.empty() || text.size() > longest_definition || text.find('\0') != std::string_view::npos) return found;
  const auto add = [&](Object object) {
    if (object) found.push_back(std::move(object));
  };
  if (is_definition(text)) {
    add(by_definition(session, text));
    return found;
  }
  const auto code = code_of(session, first_part(text));
  if (code) {
    add(by_code(session, *code));
    return found;
  }
  found = by_name(session, text);
  const std::size_t plus = text.find(" + ");
  if (found.empty() && plus != std::string_view::npos) found = by_name(session, text.substr(0, plus));
  return found;
}

// The part of a system that is of the plane: of one with heights the first, of one bound to another that itself.
Object plane_of(const Session& session, Object system) {
  constexpr int deepest = 8;
  for (int i = 0; i < deepest && system; ++i) {
    const PJ_TYPE type = session.proj().get_type(system.get());
    if (type == PJ_TYPE_BOUND_CRS) {
      system = session.object(session.proj().get_source_crs(session.context(), system.get()));
    } else if (type == PJ_TYPE_COMPOUND_CRS) {
      system = session.object(session.proj().crs_get_sub_crs(session.context(), system.get(), 0));
    } else {
      break;
    }
  }
  return system;
}

// The two axes of the plane: one of each in radians or metres, and where it runs to.
struct Axes {
  double unit = 0.0;
  std::array<std::string, 2> directions;
};

// Nothing where the units differ or the axes are not of that kind.
std::optional<Axes> axes_of(const Session& session, PJ* system, PJ_COORDINATE_SYSTEM_TYPE wanted) {
  const ProjLibrary& proj = session.proj();
  const Object all = session.object(proj.crs_get_coordinate_system(session.context(), system));
  if (!all || proj.cs_get_type(session.context(), all.get()) != wanted) return std::nullopt;
  Axes axes;
  std::array<double, 2> units{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto nothing = nullptr;
    const char* direction = nullptr;
    if (proj.cs_get_axis_info(session.context(), all.get(), static_cast<int>(i), nothing, nothing, &direction, &units[i],
                              nothing, nothing, nothing) == 0) {
      return std::nullopt;
    }
    axes.directions[i] = direction == nullptr ? std::string() : lower(direction);
  }
  axes.unit = units[0];
  const bool usable = units[0] == units[1] && std::isfinite(units[0]) && units[0] > 0.0;
  return usable ? std::optional(std::move(axes)) : std::nullopt;
}

PlanAxes plan_axes(const Axes& axes) {
  const auto along = [&](std::string_view positive, std::string_view negative) {
    const auto part = [&](const std::string& direction) {
      return direction == positive ? 1.0 : direction == negative ? -1.0 : 0.0;
    };
    return vec2{part(axes.directions[0]), part(axes.directions[1])};
  };
  const PlanAxes in_order{along("east", "west"), along("north", "south")};
  const bool north_first = axes.directions[0] == "north" && axes.directions[1] == "east";
  // Axes along meridians, about a pole, have no direction of their own.
  const bool known = in_order.east != vec2(0.0) && in_order.north != vec2(0.0);
  return known && !north_first ? in_order : PlanAxes{};
}

// Degrees, or other angles, on the system's own ellipsoid.
std::optional<PlanUnits> units_of_angles(const Session& session, PJ* system) {
  const auto axes = axes_of(session, system, PJ_CS_TYPE_ELLIPSOIDAL);
  if (!axes) return std::nullopt;
  PlanUnits units = PlanUnits::degrees;
  const double degrees = axes->unit * (180.0 / pi);
  constexpr double rounding = 1e-9;  // the dataset states a degree to 15 digits
  if (std::abs(degrees - 1.0) > rounding) units.size = degrees;
  const Object ellipsoid = session.object(session.proj().get_ellipsoid(session.context(), system));
  double axis_m = 0.0;
  double inverse_flattening = 0.0;
  if (ellipsoid && session.proj().ellipsoid_get_parameters(session.context(), ellipsoid.get(), &axis_m, nullptr, nullptr,
                                                           &inverse_flattening) != 0) {
    units.semi_major_axis_m = axis_m;
    units.flattening = inverse_flattening == 0.0 ? 0.0 : 1.0 / inverse_flattening;
  }
  return units;
}

// Whether lengths on the map grow with latitude: not so for Mercator's projections that lie across or aslant.
bool is_mercator(const Session& session, PJ* system) {
  const Object projection = session.object(session.proj().crs_get_coordoperation(session.context(), system));
  const char* method = nullptr;
  if (projection) {
    session.proj().coordoperation_get_method_info(session.context(), projection.get(), &method, nullptr, nullptr);
  }
  const std::string name = method == nullptr ? std::string() : lower(method);
  const auto has = [&](std::string_view word) { return name.find(word) != std::string::npos; };
  return has("mercator") && !has("transverse") && !has("oblique");
}

ReferenceSystem unusable(std::string is, bool can_be_stated) { return {std::nullopt, false, {}, std::move(is), can_be_stated}; }

ReferenceSystem described_projection(const Session& session, PJ* system) {
  if (is_mercator(session, system)) {
    return unusable(fmt::format("{}, a Mercator projection, in which lengths grow with latitude: twice too long at 60°",
                                in_quotes(session.proj().get_name(system))),
                    false);
  }
  const auto axes = axes_of(session, system, PJ_CS_TYPE_CARTESIAN);
  if (!axes) return unusable("a projection whose axes have no common unit of length", true);
  PlanUnits units = PlanUnits::metres;
  units.size = axes->unit;
  return {units, true, plan_axes(*axes), {}, false};
}

ReferenceSystem described(const Session& session, PJ* system) {
  const std::string name = in_quotes(session.proj().get_name(system));
  switch (session.proj().get_type(system)) {
    case PJ_TYPE_GEOGRAPHIC_2D_CRS:
    case PJ_TYPE_GEOGRAPHIC_3D_CRS: {
      // A turned pole is derived by an operation: longitudes and latitudes of another kind.
      const bool own = !session.object(session.proj().crs_get_coordoperation(session.context(), system));
      const auto units = own ? units_of_angles(session, system) : std::nullopt;
      return units ? ReferenceSystem{units, false, {}, {}, false}
                   : unusable(name + ", which is derived from another one", true);
    }
    case PJ_TYPE_PROJECTED_CRS:
      return described_projection(session, system);
    case PJ_TYPE_GEOCENTRIC_CRS:
      return unusable(name + ", which is geocentric: its x, y and z run from the middle of the Earth", false);
    case PJ_TYPE_VERTICAL_CRS:
      return unusable(name + ", which is of heights alone", false);
    case PJ_TYPE_ENGINEERING_CRS:
      return unusable(name + ", which is of no place on Earth", true);
    default:
      return unusable(name + ", which is neither geographic nor projected", true);
  }
}

}  // namespace

ReferenceSystem reference_system(std::string_view name) {
  const Session& session = session_of_thread();
  std::vector<ReferenceSystem> meanings;
  for (Object& object : objects_of(session, name)) {
    const Object system = plane_of(session, std::move(object));
    if (system) meanings.push_back(described(session, system.get()));
  }
  const std::string quoted = in_quotes(trimmed(name));
  if (meanings.empty()) return unusable(quoted + ", which PROJ does not know", true);
  const bool one = std::ranges::all_of(meanings, [&](const ReferenceSystem& other) {
    return other.units.has_value() == meanings[0].units.has_value() &&
           (!other.units || alike(*other.units, *meanings[0].units));
  });
  return one ? meanings[0] : unusable(quoted + ", the name of several with other units", true);
}

std::optional<MapScale> map_scale(std::string_view name, vec2 at) {
  const Session& session = session_of_thread();
  const ProjLibrary& proj = session.proj();
  std::vector<Object> found = objects_of(session, name);
  if (found.empty()) return std::nullopt;
  const Object map = plane_of(session, std::move(found[0]));
  if (!map || proj.get_type(map.get()) != PJ_TYPE_PROJECTED_CRS) return std::nullopt;
  const Object globe = session.object(proj.crs_get_geodetic_crs(session.context(), map.get()));
  const auto axes = axes_of(session, map.get(), PJ_CS_TYPE_CARTESIAN);
  const auto angles = globe ? units_of_angles(session, globe.get()) : std::nullopt;
  if (!axes || !angles) return std::nullopt;
  const Object as_written =
      session.object(proj.create_crs_to_crs_from_pj(session.context(), map.get(), globe.get(), nullptr, nullptr));
  if (!as_written) return std::nullopt;
  const Object to_globe = session.object(proj.normalize_for_visualization(session.context(), as_written.get()));
  if (!to_globe) return std::nullopt;
  const auto degrees = [&](vec2 p) {
    const PJ_COORD result = proj.trans(to_globe.get(), PJ_FWD, PJ_COORD{{p.x, p.y, 0.0, 0.0}});
    return vec2{result.v[0], result.v[1]} * angles->size;
  };
  constexpr double step_m = 10.0;
  const vec2 middle = degrees(at);
  if (!std::isfinite(middle.x) || !(std::abs(middle.y) < 89.9)) return std::nullopt;
  const vec2 metres = 0.001 * mm_per_degree(middle.y, *angles);
  MapScale scale{1e300, 0.0};
  for (const vec2 way : {vec2{1, 0}, vec2{0, 1}, vec2{std::sqrt(0.5), std::sqrt(0.5)}, vec2{std::sqrt(0.5), -std::sqrt(0.5)}}) {
    vec2 moved = degrees(at + way * (step_m / axes->unit)) - middle;
    moved.x = std::remainder(moved.x, 360.0);
    const double ground_m = glm::length(moved * metres);
    if (!(ground_m > 0.0) || !std::isfinite(ground_m)) return std::nullopt;
    scale = {std::min(scale.least, step_m / ground_m), std::max(scale.most, step_m / ground_m)};
  }
  return scale;
}

}  // namespace shatterpave::scene
