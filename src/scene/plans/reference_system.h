// What a coordinate reference system says of the coordinates of a plan: whether they are degrees or lengths, and how large.
// PROJ and its dataset of EPSG, ESRI, OGC, IAU and IGN know the systems (proj.org; Debian's libproj).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/vec.h"
#include "scene/plans/plan.h"

namespace shatterpave::scene {

struct ReferenceSystem {
  std::optional<PlanUnits> units;  // of a geographic system, or of a projected one that keeps lengths
  bool projected = false;
  // How x and y of GeoJSON lie: that of a system with north and east as east and north, as all programs write them; others in
  // the order and the sense of the system (westing and southing in South Africa, southing and westing of Krovak's).
  PlanAxes axes;
  // Where there are no units:
  std::string is;              // what it is, for a message: "a Mercator projection, …"
  bool can_be_stated = false;  // whether a scene may state units for it: it is unknown, or of no place
};

// The system of that name, in any of the spellings that are in use:
// - an authority and its code, EPSG without one: EPSG:25833, ESRI:102100, IAU_2015:30100, CRS:84, OGC:CRS84h, 25833;
// - URNs of RFC 5165 and what came before it: urn:ogc:def:crs:EPSG::25833, with a version, urn:x-ogc:…;
// - addresses: http(s)://www.opengis.net/def/crs/EPSG/0/25833, …/gml/srs/epsg.xml#25833, spatialreference.org, epsg.io;
// - with heights, which are ignored: EPSG:25833+7837, urn:ogc:def:crs,crs:EPSG::25833,crs:EPSG::7837, …/def/crs-compound?…;
// - a name, whatever its case, spaces and signs: WGS 84 / UTM zone 33N;
// - WKT, PROJJSON, strings of PROJ.
// Of systems with a name of their own in several ways (geographic, geocentric) the one with two axes is taken. Nothing but
// PROJ's own dataset is read: no settings of the user, nothing of the network. Throws std::runtime_error where PROJ is not
// there.
ReferenceSystem reference_system(std::string_view name);

// How much longer lengths are on the map of a projected system than on the ground, about the point `at` of its coordinates.
struct MapScale {
  double least = 1.0;
  double most = 1.0;
};
// Nothing where the system cannot tell, as for points beyond it.
std::optional<MapScale> map_scale(std::string_view name, vec2 at);

}  // namespace shatterpave::scene
