// Plans: files of their own (GeoJSON, SVG) with areas, lines and points, which a scene takes outlines, holes and guides from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"
#include "scene/outline.h"

namespace shatterpave::scene {

enum class PlanUnits { degrees, metres, millimetres };

// What shapes are chosen by: a feature of GeoJSON, an element or a group of SVG.
struct PlanFeature {
  std::vector<std::string> ids;      // its id and other names of its own
  std::vector<std::string> classes;  // in GeoJSON also `key=value` of each property
  std::optional<std::size_t> group;  // the feature that holds it
};

enum class ShapeKind { area, line, point };

struct PlanShape {
  ShapeKind kind = ShapeKind::area;
  std::vector<Ring> rings;          // in the plan's units. Area: its rings; line and point: one
  std::optional<FillRule> filling;  // by which the rings of an area fill it; without: outline first, then its holes
  std::size_t feature = 0;
};

struct Plan {
  std::string file;
  std::string sum;  // SHA-256 of its content, if it was read from a file
  bool svg = false;
  std::optional<PlanUnits> units;  // if the file says so
  std::vector<PlanFeature> features;
  std::vector<PlanShape> shapes;  // in their order in the file
};

// The plan of a file, which must end in .geojson, .json or .svg. `place` is that of the file's name in the scene; `svg_scale`
// is the number of millimetres in the world for one on an SVG page. Throws InputError with the place in that file.
Plan plan_of_file(const std::filesystem::path& file, const Place& place, double svg_scale = 1.0);

// GeoJSON (RFC 7946). Each polygon of a MultiPolygon is a shape, as is each line of a MultiLineString; they share a feature.
// A feature goes by its `id` and its properties `id`, `@id` and `name`; by the words of its property `class`; and by
// `key=value` of every property that is a text, a number or a boolean.
Plan plan_of_geojson(std::string_view text, const std::string& file);

// SVG 1.1 in millimetres, y up, the lower left corner of the page as the origin: path, polygon, polyline, rect, circle,
// ellipse, line, in groups, nested svg, switch and use. Transforms, viewBox and units are followed. Curves become lines that
// are at most `svg_tolerance_mm` off (after scaling). Closed subpaths of an element are one area, each open one is a line. An
// element or group goes by its `id`, `inkscape:label` and `data-name`, and by the words of its `class`. Style sheets are not
// followed.
inline constexpr double svg_tolerance_mm = 0.1;
Plan plan_of_svg(std::string_view text, const std::string& file, double scale = 1.0);

// Which shapes of a plan the scene wants: those with the ids or indices, or those of the class.
struct ShapeChoice {
  std::vector<std::variant<std::size_t, std::string>> shapes;
  std::optional<std::string> class_name;
  Place place;  // of the choice in the scene
};

enum class ByDefault { the_only_feature, all };

// The indices of the shapes chosen among those of the given kinds, in the order of the plan, each once. An index counts shapes
// of these kinds; an id is that of one feature or else of a group; a class may stand at a shape or at any group about it.
// Without a choice: all, or those of the only feature. Throws InputError, which lists the shapes, if a choice fits none.
std::vector<std::size_t> chosen_shapes(const Plan& plan, const std::vector<ShapeKind>& kinds, const ShapeChoice& choice,
                                       ByDefault by_default);

}  // namespace shatterpave::scene
