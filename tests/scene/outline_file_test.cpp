#include "scene/outline_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/read_scene.h"
#include "support/shared_data.h"

namespace shatterpave::scene {
namespace {

using geometry::Polygon;
using geometry::Region;

geometry::Region geojson(const std::string& text, OutlineChoice choice = {}) {
  choice.choice_place = Place{"s.toml", 3, 1, "outline_feature"};
  return outline_of_geojson(text, "a.geojson", choice);
}

geometry::Region svg(const std::string& body, const std::string& attributes = "", OutlineChoice choice = {}) {
  choice.choice_place = Place{"s.toml", 3, 1, "outline_feature"};
  return outline_of_svg("<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">\n" + body + "\n</svg>", "a.svg", choice);
}

template <typename Read>
std::string message_of(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

OutlineChoice by_id(const std::string& id) {
  OutlineChoice choice;
  choice.id = id;
  return choice;
}

OutlineChoice in_units(OutlineUnits units) {
  OutlineChoice choice;
  choice.units = units;
  return choice;
}

const std::string ring = "[[0,0],[300,0],[300,200],[0,200],[0,0]]";

TEST(GeoJson, ReadsPolygonsHoweverTheyAreWrapped) {
  const Polygon expected = {{0, 0}, {300'000, 0}, {300'000, 200'000}, {0, 200'000}};
  const std::string polygon = R"({"type":"Polygon","coordinates":[)" + ring + "]}";
  const std::string feature = R"({"type":"Feature","id":7,"properties":null,"geometry":)" + polygon + "}";
  EXPECT_EQ(geojson(polygon).outline, expected);
  EXPECT_EQ(geojson(feature).outline, expected);
  EXPECT_EQ(geojson(R"({"type":"FeatureCollection","features":[)" + feature + "]}", by_id("7")).outline, expected);
  EXPECT_EQ(geojson(R"({"type":"MultiPolygon","coordinates":[[)" + ring + "]]}").outline, expected);
  EXPECT_EQ(
      geojson(R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]},)" + polygon + "]}").outline,
      expected);
}

TEST(GeoJson, MillimetresMetresAndFarPlaces) {
  const auto text = [](const std::string& coordinates) { return R"({"type":"Polygon","coordinates":[)" + coordinates + "]}"; };
  const Polygon near = geojson(text("[[10,10],[20,10],[20,20]]"), in_units(OutlineUnits::metres)).outline;
  EXPECT_EQ(near, (Polygon{{10'000, 10'000}, {20'000, 10'000}, {20'000, 20'000}}));
  const Polygon small = geojson(text("[[10,10],[20,10],[20,20]]"), in_units(OutlineUnits::millimetres)).outline;
  EXPECT_EQ(small, (Polygon{{10, 10}, {20, 10}, {20, 20}}));
  // UTM: the middle of the box, to whole metres, becomes the origin.
  const Polygon far = geojson(text("[[391000.5,5812000],[391010.5,5812000],[391010.5,5812020]]")).outline;
  EXPECT_EQ(far, (Polygon{{-5'500, -10'000}, {4'500, -10'000}, {4'500, 10'000}}));
}

// Lengths on the ellipsoid, by the standard series for a degree of latitude and longitude (NGA TR 8350.2): at 52.47367° a
// degree of latitude is 111,270 m and one of longitude 67,940 m, to some metres.
TEST(GeoJson, ProjectsDegreesToLocalMillimetres) {
  const Polygon p =
      geojson(R"({"type":"Polygon","coordinates":[[[13.44,52.473],[13.45,52.473],[13.45,52.474],[13.44,52.474]]]})").outline;
  ASSERT_EQ(p.size(), 4U);
  const double latitude = 52.4735 * std::acos(-1.0) / 180.0;
  const double degree_of_latitude = 111132.954 - 559.822 * std::cos(2 * latitude) + 1.175 * std::cos(4 * latitude);
  const double degree_of_longitude =
      111412.84 * std::cos(latitude) - 93.5 * std::cos(3 * latitude) + 0.118 * std::cos(5 * latitude);
  EXPECT_NEAR(p[1].x - p[0].x, 0.01 * degree_of_longitude * 1000, 5.0);
  EXPECT_NEAR(p[2].y - p[1].y, 0.001 * degree_of_latitude * 1000, 1.0);
  EXPECT_NEAR(p[0].x + p[1].x, 0.0, 0.01);  // about the middle of the box
  EXPECT_NEAR(p[0].y + p[2].y, 0.0, 0.01);
}

// The plazas' own description states their areas, to 2 % of what the ellipsoid gives.
TEST(GeoJson, ReadsTheRealPlazas) {
  SKIP_WITHOUT_SHARED_DATA();
  const std::filesystem::path folder = support::shared_data() / "plazas";
  const auto expect = [&](const char* name, double area_m2, std::size_t holes) {
    const Region region = outline_of_file(folder / name, {});
    EXPECT_NEAR(geometry::area(region) * 1e-6, area_m2, 0.02 * area_m2) << name;
    EXPECT_EQ(region.holes.size(), holes) << name;
    for (const Polygon& hole : region.holes) EXPECT_LT(geometry::area(hole), 0.0);
  };
  expect("karl-marx-platz-berlin.geojson", 1387.0, 4);
  expect("tabard-piazza-london.geojson", 816.0, 0);
  expect("footway-london.geojson", 114.0, 0);
}

TEST(GeoJson, ErrorsNameFileAndPath) {
  const auto error = [](const std::string& text) { return message_of([&] { geojson(text); }); };
  const std::string start = R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)";
  EXPECT_EQ(error("{\n\"type\":,"), "a.geojson:2:8: expected JSON, got a syntax error");
  EXPECT_EQ(error(""), "a.geojson:1:1: expected JSON, got a syntax error");
  EXPECT_EQ(error("[]"), "a.geojson: expected a GeoJSON object, got an array of 0 values");
  EXPECT_EQ(error("{}"), "a.geojson: expected an object with a \"type\", got none");
  EXPECT_EQ(error(R"({"type":"Circle"})"), "a.geojson: type: expected a type of GeoJSON, got \"Circle\"");
  EXPECT_EQ(error(R"({"type":"Point","coordinates":[0,0]})"), "a.geojson: expected a polygon, got none");
  EXPECT_EQ(error(start + "null}]}"), "a.geojson: expected a polygon, got none");
  EXPECT_EQ(error(start + R"({"type":"Polygon"}}]})"),
            "a.geojson: features[0].geometry.coordinates: expected an array, got none");
  EXPECT_EQ(error(start + R"({"type":"Polygon","coordinates":[[[0,0],[300,0],[300,"x"]]]}}]})"),
            "a.geojson: features[0].geometry.coordinates[0][2]: expected a position [x, y], got an array of 2 values");
  EXPECT_EQ(error(start + R"({"type":"Polygon","coordinates":[[[0,0],[300,300],[300,0],[0,300]]]}}]})"),
            "a.geojson: features[0].geometry.coordinates[0]: expected edges that do not cross, got edge 0 of the outline and "
            "edge 2 of the "
            "outline crossing at (150000, 150000)");
  EXPECT_EQ(
      error(start + R"({"type":"Polygon","coordinates":[[[0,0],[300,0],[300,300]],[[0,200],[1,200],[1,201]]]}}]})"),
      "a.geojson: features[0].geometry.coordinates[1]: expected holes inside the outline, got hole 0 outside at (0, 200000)");
  EXPECT_EQ(error(R"({"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10]]]})"),
            "a.geojson: coordinates[0]: expected an area of at most 2 km, got 1109 km × 1106 km; if these are no degrees, set "
            "outline_units");
  EXPECT_EQ(
      error(R"({"type":"MultiPolygon","coordinates":[[)" + ring + "],[" + ring + "]]}"),
      "s.toml:3:1: outline_feature: expected the id or the index of one of the 2 polygons of \"a.geojson\": 0, 1; got none");
  EXPECT_EQ(error(std::string(100'000, '[')), "a.geojson: expected at most 64 levels of nesting, got more");
  EXPECT_EQ(error("1e999"), "a.geojson: expected JSON, got \"[json.exception.out_of_range.406] number…\"");
}

TEST(Svg, UnitsAndViewBoxGiveMillimetresWithYUp) {
  const Polygon rect =
      svg(R"(<rect x="10" y="20" width="30" height="40"/>)", R"(width="200mm" height="100mm" viewBox="0 0 200 100")").outline;
  EXPECT_EQ(rect.size(), 4U);
  const geometry::Box box = geometry::bounding_box(rect);
  EXPECT_EQ(box.low, vec2(10, 40));
  EXPECT_EQ(box.high, vec2(40, 80));
  // px without any size: 1/96 inch.
  const geometry::Box px = geometry::bounding_box(svg(R"(<rect x="0" y="0" width="96" height="48"/>)").outline);
  EXPECT_EQ(px.high - px.low, vec2(25.4, 12.7));
  // A viewBox that is fitted into the page: the smaller scale, in the middle.
  const geometry::Box fitted = geometry::bounding_box(
      svg(R"(<rect width="10" height="10"/>)", R"(width="4cm" height="2cm" viewBox="0 0 10 10")").outline);
  EXPECT_EQ(fitted.low, vec2(10, 0));
  EXPECT_EQ(fitted.high, vec2(30, 20));
}

TEST(Svg, FollowsNestedTransforms) {
  const std::string body =
      "<g transform=\"translate(100, 50)\"><g transform=\"rotate(90) scale(2)\"><polygon points=\"0,0 10,0 10,5\"/></g></g>";
  const Polygon p = svg(body, R"(width="300mm" height="300mm" viewBox="0 0 300 300")").outline;
  // (10, 0) is scaled to (20, 0), turned to (0, 20), moved to (100, 70), and y is turned up.
  EXPECT_NE(std::ranges::find(p, vec2(100, 250)), p.end());
  EXPECT_NE(std::ranges::find(p, vec2(100, 230)), p.end());
  EXPECT_NE(std::ranges::find(p, vec2(90, 230)), p.end());
}

TEST(Svg, CurvesStayWithinTheTolerance) {
  const std::string page = R"(width="2000mm" height="2000mm" viewBox="0 0 2000 2000")";
  const auto largest_error = [](const Polygon& p, vec2 centre, double radius) {
    double worst = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const vec2 q = p[(i + 1) % p.size()];
      worst = std::max(
          {worst, std::abs(glm::length(p[i] - centre) - radius), std::abs(glm::length(0.5 * (p[i] + q) - centre) - radius)});
    }
    return worst;
  };
  const std::string circle = R"(<circle cx="1000" cy="1000" r="500"/>)";
  const std::string arcs = R"(<path d="M500 1000 A500 500 0 0 1 1500 1000 a500,500,0,1,1-1000,0z"/>)";
  const std::string rounded = R"(<rect x="500" y="500" width="1000" height="1000" rx="500"/>)";
  for (const std::string& body : {circle, arcs, rounded}) {
    const Polygon p = svg(body, page).outline;
    EXPECT_LT(largest_error(p, {1000, 1000}, 500), svg_tolerance_mm) << body;
    EXPECT_NEAR(geometry::area(p), std::acos(-1.0) * 250'000, 2 * std::acos(-1.0) * 500 * svg_tolerance_mm) << body;
    EXPECT_LT(p.size(), 1000U) << body;
  }
}

// Each command beside the same outline in lines or in another command.
TEST(Svg, UnderstandsEveryCommandOfPaths) {
  const auto path = [](const std::string& d) {
    return svg("<path d=\"" + d + "\"/>", R"(width="99mm" height="99mm" viewBox="0 0 99 99")").outline;
  };
  const Polygon square = path("M10 10 L20 10 L20 20 L10 20 Z");
  EXPECT_EQ(path("m10 10 l10 0 l0 10 l-10 0 z"), square);
  EXPECT_EQ(path("M10 10 20 10 20 20 10 20z"), square);
  EXPECT_EQ(path("m10,10,10,0,0,10-10,0z"), square);
  EXPECT_EQ(path("M10 10H20V20H10Z"), square);
  EXPECT_EQ(path("m10 10h10v10h-10z"), square);
  EXPECT_EQ(path("M1e1.1e2h10v1.0e+1h-10.z"), square);
}

TEST(Svg, SmoothCurvesReflectTheControlPoint) {
  const auto path = [](const std::string& d) {
    return svg("<path d=\"" + d + "\"/>", R"(width="99mm" height="99mm" viewBox="0 0 99 99")").outline;
  };
  EXPECT_EQ(path("M0 50 C10 20 20 20 30 50 S50 80 60 50 L60 90 L0 90z"),
            path("M0 50 C10 20 20 20 30 50 C40 80 50 80 60 50 L60 90 L0 90z"));
  EXPECT_EQ(path("M0 50 c10-30 20-30 30 0 s20 30 30 0 L60 90 L0 90z"),
            path("M0 50 C10 20 20 20 30 50 C40 80 50 80 60 50 L60 90 L0 90z"));
  EXPECT_EQ(path("M0 50 Q15 20 30 50 T60 50 L60 90 L0 90z"), path("M0 50 Q15 20 30 50 Q45 80 60 50 L60 90 L0 90z"));
  EXPECT_EQ(path("M0 50 q15-30 30 0 t30 0 L60 90 L0 90z"), path("M0 50 Q15 20 30 50 Q45 80 60 50 L60 90 L0 90z"));
}

TEST(Svg, InnerSubpathsAreHolesAsTheFillRuleSays) {
  const std::string outer = "M0 0H90V90H0Z";
  const std::string same = "M10 10H20V20H10Z";
  const std::string opposite = "M30 30V40H40V30Z";
  const auto holes = [&](const std::string& rule) {
    return svg("<path " + rule + " d=\"" + outer + same + opposite + "\"/>").holes.size();
  };
  EXPECT_EQ(holes(""), 1U);
  EXPECT_EQ(holes("fill-rule=\"evenodd\""), 2U);
  EXPECT_EQ(holes("style=\"fill:red; fill-rule: evenodd\""), 2U);
}

TEST(Svg, ChoosesByIdAndLooksAtShapesOnly) {
  const std::string body =
      "<defs><rect width=\"9\" height=\"9\"/></defs><line x1=\"0\" y1=\"0\" x2=\"9\" y2=\"9\"/>"
      "<rect id=\"hidden\" display=\"none\" width=\"9\" height=\"9\"/><polyline points=\"0 0 9 0 9 9\"/>"
      "<rect id=\"a\" width=\"96\" height=\"96\"/><ellipse id=\"b\" cx=\"500\" cy=\"500\" rx=\"96\" ry=\"48\"/>";
  const geometry::Box a = geometry::bounding_box(svg(body, "", by_id("a")).outline);
  EXPECT_EQ(a.high - a.low, vec2(25.4, 25.4));
  const geometry::Box b = geometry::bounding_box(svg(body, "", by_id("b")).outline);
  EXPECT_NEAR(b.high.x - b.low.x, 50.8, svg_tolerance_mm);
  EXPECT_EQ(message_of([&] { svg(body); }),
            "s.toml:3:1: outline_feature: expected the id or the index of one of the 2 closed shapes of \"a.svg\": 0 (id "
            "\"a\"), 1 (id "
            "\"b\"); got none");
}

TEST(Svg, ErrorsNameTheElement) {
  const auto error = [](const std::string& body, const std::string& attributes = "") {
    return message_of([&] { svg(body, attributes); });
  };
  EXPECT_EQ(error("<g/>"), "a.svg: expected a closed shape, got none");
  EXPECT_EQ(error("<path id=\"p\" d=\"M0 0 L9 x\"/>"), "a.svg:2:2: path#p: expected a number, got \"x\"");
  EXPECT_EQ(error("<path d=\"L0 0\"/>"), "a.svg:2:2: path: expected a path that begins with M, got another letter");
  EXPECT_EQ(error("<path d=\"M0 0 A 1 1 0 2 0 5 5z\"/>"),
            "a.svg:2:2: path: expected a flag 0 or 1 of an arc, got something else");
  EXPECT_EQ(error("<path d=\"M0 0 B 1 1z\"/>"), "a.svg:2:2: path: expected a command of a path, got \"B\"");
  EXPECT_EQ(error("<polygon points=\"0,0 9\"/>"), "a.svg:2:2: polygon: expected a number, got \"\"");
  EXPECT_EQ(error("<rect width=\"9em\" height=\"9\"/>"),
            "a.svg:2:2: rect: expected a length in mm, cm, in, px, pt, pc or Q, got \"9em\"");
  EXPECT_EQ(error("<rect width=\"nan\" height=\"9\"/>"), "a.svg:2:2: rect: expected a number, got \"nan\"");
  EXPECT_EQ(error("<g transform=\"turn(9)\"><rect/></g>"),
            "a.svg:2:2: g: expected a transform of SVG, got \"turn\" with 1 numbers");
  EXPECT_EQ(error("<rect width=\"1e9\" height=\"9\"/>"),
            "a.svg:2:2: rect: expected coordinates from -1000000 to 1000000 mm, got (264583333.33333334, 0)");
  EXPECT_EQ(error("<rect width=\"9\" height=\"9\"/>", "viewBox=\"0 0 0 9\""),
            "a.svg:1:2: svg: expected a viewBox of x y width height, got another");
  EXPECT_EQ(error("<polygon points=\"0 0 96 96 96 0 0 96\"/>"),
            "a.svg:2:2: polygon: expected edges that do not cross, got edge 0 of the outline and edge 2 of the outline "
            "crossing at (12.7, "
            "-12.7)");
  EXPECT_TRUE(message_of([] { outline_of_svg("<svg><", "a.svg", {}); }).starts_with("a.svg:1:6: expected XML, got an error: "));
  EXPECT_EQ(message_of([] { outline_of_svg("<html/>", "a.svg", {}); }), "a.svg: expected an <svg>, got \"html\"");
  std::string deep;
  for (int i = 0; i < 200; ++i) deep += "<g>";
  for (int i = 0; i < 200; ++i) deep += "</g>";
  EXPECT_EQ(error(deep), "a.svg:2:302: g: expected at most 100 groups in groups, got more");
}

TEST(Svg, DoesNotLoadOrExpandEntities) {
  const std::string text =
      "<!DOCTYPE svg [<!ENTITY a SYSTEM \"file:///etc/passwd\"><!ENTITY b \"10\">]>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect width=\"&b;\" height=\"&a;\"/></svg>";
  EXPECT_EQ(message_of([&] { outline_of_svg(text, "a.svg", {}); }), "a.svg:2:42: rect: expected a number, got \"&b;\"");
}

}  // namespace
}  // namespace shatterpave::scene
