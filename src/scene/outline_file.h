// Outlines that stand in files of their own: GeoJSON and SVG.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "geometry/polygon.h"

namespace shatterpave::scene {

enum class OutlineUnits { degrees, metres, millimetres };

// What the scene says about the file.
struct OutlineChoice {
  std::optional<std::string> id;      // which shape of the file: the one with this id,
  std::optional<std::size_t> index;   // or the index-th, from 0
  std::optional<OutlineUnits> units;  // of GeoJSON's coordinates, where they are not to be guessed
  Place file_place;                   // of outline_file in the scene
  Place choice_place;                 // of outline_feature
  Place units_place;                  // of outline_units
};

// The region of a file, which must end in .geojson, .json or .svg. Throws InputError with the place in that file, or, where the
// scene chose what is not there, in the scene.
geometry::Region outline_of_file(const std::filesystem::path& file, const OutlineChoice& choice);

// GeoJSON (RFC 7946): the polygon that is chosen, or the only one.
//   Degrees become local millimetres, x east and y north, by an equirectangular projection about the middle of the polygon's
//   bounding box, which is the origin, with the radii of curvature of WGS 84 there; at 1 km from it, it is 0.1 m off at
//   latitude 50°. Metres and millimetres stay where they are, unless a coordinate is beyond ±1 km: then the middle of the
//   bounding box, to whole metres, becomes the origin.
//   Units that are not given are degrees if the file's "crs" says so or, without one, if all positions could be degrees;
//   else metres.
geometry::Region outline_of_geojson(std::string_view text, const std::string& file, const OutlineChoice& choice);

// SVG 1.1: the closed shape that is chosen, or the only one: path, polygon, polyline that returns to its start, rect, circle,
// ellipse. Transforms, viewBox and units are followed; y is turned to point up, with the lower left corner of the page as the
// origin. Curves become lines that are at most `svg_tolerance_mm` off. The largest subpath is the outline, those inside it are
// holes as the fill rule says. What `use` and style sheets do is not followed.
inline constexpr double svg_tolerance_mm = 0.1;
geometry::Region outline_of_svg(std::string_view text, const std::string& file, const OutlineChoice& choice);

}  // namespace shatterpave::scene
