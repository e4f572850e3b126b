// Plans: files of their own (GeoJSON, SVG, DXF) with areas, lines and points, which a scene takes outlines, holes and guides
// from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/notes.h"
#include "core/vec.h"
#include "scene/plans/outline.h"

namespace shatterpave::scene {

// What a plan may hold at the most, so that no file eats the machine.
inline constexpr std::size_t most_shapes = 100'000;

// What one is in a plan's coordinates.
struct PlanUnits {
  enum class Kind { angle, length };
  Kind kind = Kind::length;
  double size = 1.0;  // of one, in degrees or metres
  // The ellipsoid that angles are on; without another, that of WGS 84 (EPSG dataset, ellipsoid 7030).
  double semi_major_axis_m = 6378137.0;
  double flattening = 1.0 / 298.257223563;

  static const PlanUnits degrees;
  static const PlanUnits metres;
  static const PlanUnits millimetres;
  static const PlanUnits feet;            // international: 0.3048 m
  static const PlanUnits us_survey_feet;  // 1200/3937 m
};
inline constexpr PlanUnits PlanUnits::degrees{Kind::angle};
inline constexpr PlanUnits PlanUnits::metres{};
inline constexpr PlanUnits PlanUnits::millimetres{Kind::length, 0.001};
inline constexpr PlanUnits PlanUnits::feet{Kind::length, 0.3048};
inline constexpr PlanUnits PlanUnits::us_survey_feet{Kind::length, 1200.0 / 3937.0};

// How the axes of a plan's coordinates lie on the ground: x = east · p, y = north · p.
struct PlanAxes {
  vec2 east{1.0, 0.0};
  vec2 north{0.0, 1.0};

  vec2 operator()(vec2 p) const { return {east.x * p.x + east.y * p.y, north.x * p.x + north.y * p.y}; }
};

// Whether numbers of the one are numbers of the other, whatever the ellipsoid: datasets round units to 15 digits.
bool alike(const PlanUnits& a, const PlanUnits& b);

// What shapes are chosen by: a feature of GeoJSON, an element or a group of SVG.
struct PlanFeature {
  std::vector<std::string> ids;       // its id and other names of its own
  std::vector<std::string> more_ids;  // names that count where no shape has such an id: those in other languages
  std::vector<std::string> classes;   // in GeoJSON also `key=value` of each property
  std::optional<std::size_t> group;   // the feature that holds it
};

// `unread`: what is drawn but is none of the others, such as text.
enum class ShapeKind { area, line, point, unread };

// An open subpath of SVG is a line to whoever asks for lines, and part of an area to whoever asks for areas alone: so some
// shapes are there for one question only.
enum class AskedFor { anything, areas_alone, areas_beside_lines, lines_alone };

struct PlanShape {
  ShapeKind kind = ShapeKind::area;
  std::vector<Ring> rings{};          // in the plan's units. Area: its rings; line and point: one
  std::optional<FillRule> filling{};  // by which the rings of an area fill it; without: outline first, then its holes
  std::size_t feature = 0;
  std::optional<InputError> fault{};  // why the shape cannot be read; then it has no rings
  AskedFor asked_for = AskedFor::anything;
  bool open = false;                 // an area without any closed outline: counts where there is no other, or by name
  std::vector<std::size_t> parts{};  // shapes that a joined outline takes the place of
  std::vector<std::shared_ptr<const std::vector<geometry::Region>>> clips{};  // only what lies in all of these is drawn
  std::vector<Note> notes{};                                                  // told where the shape is taken
  std::optional<Note> unfollowed{};                                           // why it cannot be taken
};

struct Plan {
  std::string file;
  std::string sum;  // SHA-256 of its content, if it was read from a file
  bool svg = false;
  std::optional<PlanUnits> units;  // if the file says so
  std::optional<InputError>
      no_units;   // if it says something else: why its coordinates mean nothing unless the scene gives units
  PlanAxes axes;  // of the file; the shapes are east and north already
  std::vector<PlanFeature> features;
  std::vector<PlanShape> shapes;  // in their order in the file
  std::vector<Note> notes;        // about the file as a whole
};

// The plan of a file, which must end in .svg, .dxf or one of the endings of GeoJSON, unless it is a pipe: then its first
// character tells what it is. `place` is that of the file's name in the scene; `svg_scale` is the number of millimetres in the
// world for one on an SVG page. Throws InputError with the place in that file.
Plan plan_of_file(const std::filesystem::path& file, const Place& place, double svg_scale = 1.0);

// GeoJSON (RFC 7946; with the `crs` of 2008), one text or several: lines, or records (RFC 8142). Each polygon of a MultiPolygon
// is a shape, as is each line of a MultiLineString; they share a feature. A feature goes by its `id` and its properties `id`,
// `@id` and `name`, and by its names in other languages (`name:en`, `name: {"en": …}`, `names`); by the words of its property
// `class`; and by `key=value` of every property that is a text, a number or a boolean. A shape of a collection that cannot be
// read has a fault.
Plan plan_of_geojson(std::string_view text, const std::string& file);

// SVG 1.1 in millimetres, y up, the lower left corner of the page as the origin: path, polygon, polyline, rect, circle,
// ellipse, line, in groups, nested svg, switch and use, in any encoding of XML. Transforms, viewBox, units, style sheets, clip
// paths and overflow are followed. Curves become lines that are at most `svg_tolerance_mm` off (after scaling).
//
// The subpaths of an element are one area, as its fill rule says. Where it is filled, open ones are closed by a straight line
// if areas alone are asked for; else they are lines. One that misses its start by no more than `join_tolerance_mm` is closed.
// Open ones of one group that meet end to end within it are an outline, if they are not filled by themselves. An element or
// group goes by its `id`, `inkscape:label` and `data-name`, and by the words of its `class`.
inline constexpr double svg_tolerance_mm = 0.1;
Plan plan_of_svg(std::string_view bytes, const std::string& file, double scale = 1.0);

// DXF as text, R12 and later: lines, polylines with bulges, circles, arcs, ellipses, splines, hatches and points of the model
// that are seen (not on paper, nor in a layer that is off or frozen), blocks where they are inserted. Curves become lines: of
// an arc a side for each quarter of a degree, of a spline eight for each control point. What is closed is an area (and a line
// to whoever asks for lines alone); open lines of one layer that meet end to end are an outline. A shape goes by its handle;
// its layer is a group with the id and the class of its name. Units are those of $INSUNITS; words and 3D bodies are left out.
Plan plan_of_dxf(std::string_view text, const std::string& file);

// 0.02 mm on the page, but no less than 0.1 mm in the world.
double join_tolerance_mm(double scale);

// Which shapes of a plan the scene wants: those with the ids or indices, or those of the class.
struct ShapeChoice {
  std::vector<std::variant<std::size_t, std::string>> shapes;
  std::optional<std::string> class_name;
  Place place;  // of the choice in the scene
};

enum class ByDefault { the_only_feature, all };

// The indices of the shapes chosen among those of the given kinds, in the order of the plan, each once. An index counts shapes
// of these kinds; an id is that of one feature or else of a group, or else a name in another language; a class may stand at a
// shape or at any group about it. Without a choice: all, or those of the only feature. What is drawn within the choice but
// cannot be read (`unread`) comes with it, where areas are asked for. Throws InputError, which lists the shapes, if a choice
// fits none.
std::vector<std::size_t> chosen_shapes(const Plan& plan, const std::vector<ShapeKind>& kinds, const ShapeChoice& choice,
                                       ByDefault by_default);

}  // namespace shatterpave::scene
