#include "scene/plans/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/plans/plan_areas.h"
#include "scene/read_scene.h"
#include "support/shared_data.h"

namespace shatterpave::scene {
namespace {

using geometry::Polygon;
using geometry::Region;

// What a scene takes from a plan for an outline.
struct Wanted {
  ShapeChoice choice;
  std::optional<PlanUnits> units;
  double width_mm = 0.0;
  std::optional<vec2> origin;
};

std::vector<Region> areas_wanted(const Plan& plan, Wanted wanted) {
  wanted.choice.place = Place{"s.toml", 3, 1, "outline_feature"};
  std::vector<ShapeKind> kinds = {ShapeKind::area};
  if (wanted.width_mm > 0.0) kinds = {ShapeKind::area, ShapeKind::line, ShapeKind::point};
  const auto shapes = chosen_shapes(plan, kinds, wanted.choice, ByDefault::the_only_feature);
  return merged(regions_of(plan, shapes, frame_of(plan, shapes, wanted.units, wanted.origin), wanted.width_mm));
}

Region the_only(const std::vector<Region>& regions) {
  EXPECT_EQ(regions.size(), 1U);
  return regions.front();
}

std::vector<Region> geojson_areas(const std::string& text, const Wanted& wanted = {}) {
  return areas_wanted(plan_of_geojson(text, "a.geojson"), wanted);
}
Region geojson(const std::string& text, const Wanted& wanted = {}) { return the_only(geojson_areas(text, wanted)); }

std::string svg_text(const std::string& body, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">\n" + body + "\n</svg>";
}
std::vector<Region> svg_areas(const std::string& body, const std::string& attributes = "", const Wanted& wanted = {}) {
  return areas_wanted(plan_of_svg(svg_text(body, attributes), "a.svg"), wanted);
}
Region svg(const std::string& body, const std::string& attributes = "", const Wanted& wanted = {}) {
  return the_only(svg_areas(body, attributes, wanted));
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

Wanted by_id(const std::string& id) { return {{{id}, std::nullopt, {}}, std::nullopt, 0.0, std::nullopt}; }
Wanted by_class(const std::string& name) { return {{{}, name, {}}, std::nullopt, 0.0, std::nullopt}; }
Wanted in_units(PlanUnits units) { return {{}, units, 0.0, std::nullopt}; }

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
  const Polygon near = geojson(text("[[10,10],[20,10],[20,20]]"), in_units(PlanUnits::metres)).outline;
  EXPECT_EQ(near, (Polygon{{10'000, 10'000}, {20'000, 10'000}, {20'000, 20'000}}));
  const Polygon small = geojson(text("[[10,10],[20,10],[20,20]]"), in_units(PlanUnits::millimetres)).outline;
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
    const Region region = the_only(areas_of_file(folder / name));
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
  EXPECT_EQ(error("[]"), "a.geojson: expected a GeoJSON object, got []");
  EXPECT_EQ(error("{}"), "a.geojson: expected an object with a \"type\", got none");
  EXPECT_EQ(error(R"({"type":"Circle"})"), "a.geojson: type: expected a type of GeoJSON, got \"Circle\"");
  EXPECT_EQ(error(R"({"type":"Point","coordinates":[0,0]})"), "a.geojson: expected a polygon, got none");
  EXPECT_EQ(error(start + "null}]}"), "a.geojson: expected a polygon, got none");
  EXPECT_EQ(error(start + R"({"type":"Polygon"}}]})"),
            "a.geojson: features[0].geometry.coordinates: expected an array, got none");
  EXPECT_EQ(error(start + R"({"type":"Polygon","coordinates":[[[0,0],[300,0],[300,"x"]]]}}]})"),
            "a.geojson: features[0].geometry.coordinates[0][2]: expected a position [x, y], got [300, \"x\"]");
  EXPECT_EQ(error(start + R"({"type":"Polygon","coordinates":[[[0,0],[300,300],[0,0]]]}}]})"),
            "a.geojson: features[0].geometry.coordinates[0]: expected 3 or more distinct points, got 2");
  EXPECT_EQ(error(start + R"({"type":"Polygon","coordinates":[[[0,0],[300,0],[300,300]],[[0,200],[1]]]}}]})"),
            "a.geojson: features[0].geometry.coordinates[1][1]: expected a position [x, y], got [1]");
  EXPECT_EQ(error(R"({"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10]]]})"),
            "a.geojson: coordinates[0]: expected an area of at most 2 km, got 1109 km × 1106 km; if these are no degrees, set "
            "outline_units");
  const std::string two = R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[)" + ring + "]}}";
  EXPECT_EQ(
      error(R"({"type":"FeatureCollection","features":[)" + two + "," + two + "]}"),
      "s.toml:3:1: outline_feature: expected the id or the index of one of the 2 polygons of \"a.geojson\": 0, 1; got none");
  EXPECT_EQ(error(std::string(100'000, '[')), "a.geojson: expected at most 64 levels of nesting, got more");
  EXPECT_EQ(error("1e999"), "a.geojson:1:1: expected a number that a double can hold, got \"1e999\"");
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

// By the definitions of the specification (CSS Transforms 1, 12).
TEST(Svg, TransformsAreAsTheirMatrices) {
  const auto outline = [](const std::string& transform) {
    return svg("<g transform=\"" + transform + "\"><path d=\"M10 20H30V25H10z\"/></g>",
               R"(width="300mm" height="300mm" viewBox="0 0 300 300")")
        .outline;
  };
  const std::pair<const char*, const char*> same[] = {
      {"rotate(90 100 60)", "matrix(0 1 -1 0 160 -40)"},
      {"rotate(180, 100, 60)", "translate(100 60) rotate(180) translate(-100 -60)"},
      {"translate(7)", "matrix(1 0 0 1 7 0)"},
      {"translate(7 -3)", "matrix(1 0 0 1 7 -3)"},
      {"scale(3)", "matrix(3 0 0 3 0 0)"},
      {"scale(3 2)", "matrix(3 0 0 2 0 0)"},
      {"skewX(45)", "matrix(1 0 1 1 0 0)"},
      {"skewY(45)", "matrix(1 1 0 1 0 0)"},
  };
  for (const auto& [one, other] : same) EXPECT_EQ(outline(one), outline(other)) << one;
  EXPECT_NE(outline("rotate(90 100 60)"), outline("rotate(90 100 61)"));
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
  // Lines that hang together far beyond what whole numbers hold.
  EXPECT_EQ(error("<path d=\"M0 0L1e300 0\" fill=\"none\"/><path d=\"M1e300 0L5 5\" fill=\"none\"/>"),
            "a.svg:2:2: path: expected coordinates from -1000000 to 1000000 mm, got (2.6458333333333337e+299, 0)");
  EXPECT_EQ(error("<rect width=\"9\" height=\"9\"/>", "viewBox=\"0 0 0 9\""),
            "a.svg:1:2: svg: expected a viewBox of x y width height, got another");
  EXPECT_TRUE(message_of([] { plan_of_svg("<svg><", "a.svg"); }).starts_with("a.svg:1:6: expected XML, got an error: "));
  EXPECT_EQ(message_of([] { plan_of_svg("<html/>", "a.svg"); }), "a.svg: expected an <svg>, got \"html\"");
  std::string deep;
  for (int i = 0; i < 200; ++i) deep += "<g>";
  for (int i = 0; i < 200; ++i) deep += "</g>";
  EXPECT_EQ(error(deep), "a.svg:2:302: g: expected at most 100 groups in groups, got more");
}

std::string svg_with_entities(const std::string& declared, const std::string& body) {
  return "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.0//EN\" \"svg10.dtd\" [<!-- <!ENTITY st1 \"x\"> -->" + declared +
         "]>\n<svg xmlns=\"&ns_svg;\" width=\"9mm\" height=\"9mm\" viewBox=\"0 0 9 9\">" + body + "</svg>";
}

// As Illustrator writes its styles.
TEST(Svg, ReadsEntitiesOfItsOwn) {
  const std::string declared =
      R"(<!ENTITY ns_svg "http://www.w3.org/2000/svg"><!ENTITY st1 'fill-rule:evenodd;'><!ENTITY st1 "fill-rule:nonzero;">)";
  const std::string path = R"(<path style="&st1;fill:#999" d="M0 0h9v9h-9z M1 1h7v7h-7z"/>)";
  const Plan plan = plan_of_svg(svg_with_entities(declared, "<title>A &amp; &other;</title>" + path), "a.svg");
  const std::vector<Region> areas = areas_wanted(plan, {});
  ASSERT_EQ(areas.size(), 1U);
  ASSERT_EQ(areas[0].holes.size(), 1U);
  EXPECT_EQ(geometry::bounding_box(areas[0].holes[0]).low, (vec2{1, 1}));
}

TEST(Svg, DoesNotLoadEntitiesOrLetThemGrow) {
  const auto message = [](const std::string& declared, const std::string& body) {
    return message_of([&] { plan_of_svg(svg_with_entities(declared, body), "a.svg"); });
  };
  EXPECT_EQ(message(R"(<!ENTITY a SYSTEM "file:///etc/passwd">)", R"(<rect width="9" height="&a;"/>)"),
            "a.svg:2:67: rect: expected entities of plain text, got \"&a;\"");
  EXPECT_EQ(message(R"(<!ENTITY b "9"><!ENTITY a "&b;&b;">)", R"(<rect width="9" height="&a;"/>)"),
            "a.svg:2:67: rect: expected entities of plain text, got \"&a;\"");
  EXPECT_EQ(message(R"(<!ENTITY a "<rect/>">)", "<g>&a;</g>"), "a.svg:2:67: g: expected entities of plain text, got \"&a;\"");
  std::string many = "<rect id=\"";
  for (int i = 0; i < 200'000; ++i) many += "&a;";
  EXPECT_EQ(message("<!ENTITY a \"" + std::string(100'000, '9') + "\">", many + "\"/>"),
            "a.svg:2:67: rect: expected at most 32 MiB of text of entities, got more");
}

Polygon rectangle(vec2 low, vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

const std::string mm_page = R"(width="1000mm" height="1000mm" viewBox="0 0 1000 1000")";

TEST(Svg, SubpathsThatLieApartAreAreasOfTheirOwn) {
  const auto areas = svg_areas(
      R"(<path fill-rule="evenodd" d="M0 0h100v100h-100z M20 20h60v60h-60z M40 40h20v20h-20z M200 0h100v100h-100z"/>)",
      mm_page);
  ASSERT_EQ(areas.size(), 3U);
  EXPECT_EQ(areas[0].outline, rectangle({0, 900}, {100, 1000}));
  ASSERT_EQ(areas[0].holes.size(), 1U);
  EXPECT_EQ(areas[1].outline, rectangle({40, 940}, {60, 960}));  // an island in the hole
  EXPECT_EQ(areas[2].outline, rectangle({200, 900}, {300, 1000}));
}

TEST(Svg, ChoosesByGroupLabelAndClass) {
  const std::string body =
      "<g id=\"layer1\" inkscape:label=\"Paved\"><rect class=\"plaza big\" width=\"9\" height=\"9\"/>"
      "<rect id=\"b\" data-name=\"Yard, east\" x=\"20\" width=\"9\" height=\"9\"/></g>"
      "<g class=\"plaza\"><rect x=\"40\" width=\"9\" height=\"9\"/></g>";
  EXPECT_EQ(svg_areas(body, mm_page, by_id("Paved")).size(), 2U);
  EXPECT_EQ(svg_areas(body, mm_page, by_id("layer1")).size(), 2U);
  EXPECT_EQ(svg(body, mm_page, by_id("Yard, east")).outline, rectangle({20, 991}, {29, 1000}));
  EXPECT_EQ(svg_areas(body, mm_page, by_class("plaza")).size(), 2U);
  EXPECT_EQ(svg_areas(body, mm_page, by_class("big")).size(), 1U);
  EXPECT_EQ(message_of([&] { svg_areas(body, mm_page, by_class("plaz")); }),
            "s.toml:3:1: outline_feature: expected a class that a closed shape of \"a.svg\" has, got \"plaz\", which none has");
}

TEST(Svg, NestedViewportsAndPercentages) {
  // The inner page is 500 × 250 for 100 × 100 units: one unit is 2.5, in the middle.
  const std::string inner = R"(<svg x="100" y="200" width="50%" height="25%" viewBox="0 0 100 100">)";
  EXPECT_EQ(svg(inner + R"(<rect width="50%" height="100%"/></svg>)", mm_page).outline, rectangle({225, 550}, {350, 800}));
  const std::string stretched =
      R"(<svg width="500" height="250" preserveAspectRatio="none" viewBox="0 0 100 100"><rect width="9" height="9"/></svg>)";
  EXPECT_EQ(svg(stretched, mm_page).outline, rectangle({0, 977.5}, {45, 1000}));
  // Of the square that is drawn from y = -250 on, the viewport leaves what lies below 0.
  const std::string low =
      R"(<svg width="500" height="250" preserveAspectRatio="xMinYMax slice" viewBox="0 0 100 100"><rect width="9" height="60"/></svg>)";
  EXPECT_EQ(svg(low, mm_page).outline, rectangle({0, 950}, {45, 1000}));
  const geometry::Box circle = geometry::bounding_box(svg(R"(<circle cx="50%" cy="50%" r="10%"/>)", mm_page).outline);
  EXPECT_NEAR(circle.high.x, 600.0, 0.002);
}

TEST(Svg, PercentagesOfAPageWithoutASizeAreRefused) {
  EXPECT_EQ(message_of([] { svg(R"(<rect width="50%" height="9"/>)", R"(width="100%" height="100%")"); }),
            "a.svg:2:2: rect: expected a viewBox, or a size of the page, beside \"50%\", got none");
  EXPECT_EQ(svg(R"(<rect width="50" height="9"/>)", R"(width="100%" height="100%")").outline.size(), 4U);
}

TEST(Svg, UseDrawsTheOriginalElsewhere) {
  const std::string body =
      "<defs><g id=\"pair\"><rect id=\"r\" width=\"10\" height=\"10\"/><rect x=\"20\" width=\"10\" height=\"10\"/></g>"
      "<symbol id=\"s\" viewBox=\"0 0 1 1\"><rect width=\"1\" height=\"1\"/></symbol></defs>"
      "<use id=\"u\" href=\"#pair\" x=\"100\" y=\"50\"/><use id=\"v\" xlink:href=\"#s\" width=\"30\" height=\"30\"/>";
  const auto areas = svg_areas(body, mm_page, by_id("u"));
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_EQ(areas[1].outline, rectangle({120, 940}, {130, 950}));
  EXPECT_EQ(svg(body, mm_page, by_id("v")).outline, rectangle({0, 970}, {30, 1000}));
  EXPECT_EQ(message_of([&] { svg_areas("<use href=\"#none\"/>"); }),
            "a.svg:2:2: use: expected a reference to an id of this file, got \"#none\"");
}

// Each use draws the one before twice: 2^64 rectangles.
TEST(Svg, UseCannotBlowUp) {
  std::string body = "<rect id=\"a0\" width=\"9\" height=\"9\"/>";
  for (int i = 1; i <= 64; ++i) {
    body += "<g id=\"a" + std::to_string(i) + "\"><use href=\"#a" + std::to_string(i - 1) + "\"/><use href=\"#a" +
            std::to_string(i - 1) + "\"/></g>";
  }
  EXPECT_NE(message_of([&] { svg_areas(body); }).find("got more"), std::string::npos);
  EXPECT_NE(message_of([&] { svg_areas("<g id=\"a\"><use href=\"#a\"/></g>"); }).find("at most 100 groups in groups"),
            std::string::npos);
}

TEST(Svg, StyleMayTransformAndHide) {
  const std::string body =
      "<rect style=\"display : none\" width=\"9\" height=\"9\"/><g visibility=\"hidden\"><rect width=\"9\" height=\"9\"/></g>"
      "<rect style=\"fill: none; transform: translate(10px, 20px) rotate(0.25turn)\" transform=\"scale(9)\" width=\"30\" "
      "height=\"40\"/>";
  EXPECT_EQ(svg(body, mm_page).outline, rectangle({-30, 950}, {10, 980}));
  EXPECT_EQ(message_of([&] { svg_areas(R"x(<g transform="scale(2)" transform-origin="5 5"/>)x"); }),
            "a.svg:2:2: g: expected no transform-origin beside a transform, got \"5 5\"");
}

// Illustrator wraps its pages so.
TEST(Svg, SwitchDrawsWhatNeedsNoExtension) {
  const std::string body =
      "<switch><foreignObject requiredExtensions=\"&ns_ai;\"/><g><rect width=\"9\" height=\"9\"/></g>"
      "<rect width=\"5\" height=\"5\"/></switch>";
  EXPECT_EQ(svg(body, mm_page).outline, rectangle({0, 991}, {9, 1000}));
}

TEST(Svg, ScaleKeepsCurvesWithinTheTolerance) {
  const Plan plan = plan_of_svg(svg_text(R"(<circle cx="50" cy="50" r="40"/>)", mm_page), "a.svg", 100.0);
  const Region circle = the_only(areas_wanted(plan, {}));
  const double exact = std::acos(-1.0) * 4000.0 * 4000.0;
  EXPECT_NEAR(geometry::area(circle), exact, 2 * std::acos(-1.0) * 4000.0 * svg_tolerance_mm);
}

TEST(GeoJson, ChoosesByPropertiesAndPavesAllParts) {
  const std::string text =
      R"({"type":"FeatureCollection","features":[)"
      R"({"type":"Feature","properties":{"@id":"way/1","name":"Markt","class":"plaza paved","lit":true},"geometry":)"
      R"({"type":"MultiPolygon","coordinates":[[[[0,0],[300,0],[300,300]]],[[[400,0],[500,0],[500,100]]]]}},)"
      R"({"type":"Feature","id":2,"properties":{"highway":"footway","width":2.5},"geometry":)"
      R"({"type":"Polygon","coordinates":[[[600,0],[700,0],[700,100]]]}}]})";
  for (const char* id : {"way/1", "Markt"}) EXPECT_EQ(geojson_areas(text, by_id(id)).size(), 2U) << id;
  for (const char* name : {"plaza", "paved", "lit=true"}) EXPECT_EQ(geojson_areas(text, by_class(name)).size(), 2U) << name;
  for (const char* name : {"highway=footway", "width=2.5"}) EXPECT_EQ(geojson_areas(text, by_class(name)).size(), 1U) << name;
  Wanted wanted;
  wanted.choice.shapes = {std::size_t{1}, std::string("2")};
  EXPECT_EQ(geojson_areas(text, wanted).size(), 2U);
}

TEST(GeoJson, AcrossTheAntimeridian) {
  const auto text = [](const std::string& east, const std::string& west) {
    return R"({"type":"Polygon","coordinates":[[[)" + east + ",10],[" + west + ",10],[" + west + ",10.001]]]}";
  };
  EXPECT_EQ(geojson(text("179.999", "-179.999")).outline, geojson(text("0.999", "1.001")).outline);
  // As RFC 7946 wants it: cut in two, which are one again.
  const Region joined =
      geojson(R"({"type":"MultiPolygon","coordinates":[[[[179.999,10],[180,10],[180,10.001],[179.999,10.001]]],)"
              R"([[[-180,10],[-179.999,10],[-179.999,10.001],[-180,10.001]]]]})");
  EXPECT_EQ(joined.outline.size(), 4U);
  const geometry::Box box = geometry::bounding_box(joined.outline);
  EXPECT_NEAR(box.high.x - box.low.x, 219'258.0, 50.0);  // 0.002° of longitude at latitude 10°, as above
}

TEST(GeoJson, TakesReferenceSystemsAtTheirWord) {
  const auto text = [](const std::string& crs, const std::string& ring_text) {
    return R"({"type":"Polygon","crs":{"type":"name","properties":{"name":")" + crs + R"("}},"coordinates":[)" + ring_text +
           "]}";
  };
  const std::string small = "[[1,1],[2,1],[2,2]]";
  const std::string degrees = "[[13.44,52.473],[13.441,52.473],[13.441,52.474]]";
  EXPECT_EQ(geojson(text("urn:ogc:def:crs:EPSG::25833", small)).outline, (Polygon{{1000, 1000}, {2000, 1000}, {2000, 2000}}));
  for (const char* crs : {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326", "EPSG:4258"}) {
    EXPECT_NEAR(geometry::bounding_box(geojson(text(crs, degrees)).outline).high.x, 33'970, 10) << crs;
  }
  EXPECT_EQ(message_of([&] { geojson_areas(text("EPSG:3857", small)); }),
            "a.geojson: crs: expected a reference system that keeps lengths, such as EPSG:4326 or UTM, got \"WGS 84 / "
            "Pseudo-Mercator\", a Mercator projection, in which lengths grow with latitude: twice too long at 60°");
  EXPECT_EQ(message_of([&] {
              geojson_areas(R"({"type":"Polygon","coordinates":[[[400,10],[400.001,10],[400.001,10.001]]]})");
            }).substr(0, 70),
            "a.geojson: coordinates[0]: expected longitude and latitude or metres, ");
}

TEST(PlanAreas, LinesAreBandsAndPointsAreDiscs) {
  Wanted wide = in_units(PlanUnits::metres);
  wide.width_mm = 2000.0;
  const Region band = geojson(R"({"type":"LineString","coordinates":[[0,0],[10,0],[10,10]]})", wide);
  EXPECT_EQ(band.outline, (Polygon{{0, -1000}, {11'000, -1000}, {11'000, 10'000}, {9000, 10'000}, {9000, 1000}, {0, 1000}}));
  const Region loop = geojson(R"({"type":"LineString","coordinates":[[0,0],[10,0],[10,10],[0,10],[0,0]]})", wide);
  EXPECT_EQ(geometry::area(loop), 12'000.0 * 12'000.0 - 8000.0 * 8000.0);
  const Region tree = geojson(R"({"type":"Point","coordinates":[5,5]})", wide);
  EXPECT_NEAR(geometry::area(tree), std::acos(-1.0) * 1e6, 2 * std::acos(-1.0) * 1000.0 * svg_tolerance_mm);
}

TEST(PlanAreas, WhatOverlapsOrAdjoinsIsOneArea) {
  const auto areas = svg_areas(
      R"(<g id="g"><rect x="500" width="9" height="9"/><rect width="100" height="100"/><rect x="50" width="100" height="100"/>)"
      R"(<rect width="100" height="100"/><rect x="150" width="50" height="100"/><rect x="200" y="100" width="9" height="9"/></g>)",
      mm_page, by_id("g"));
  ASSERT_EQ(areas.size(), 3U);  // in the order of the file, and apart where they touch in a point
  EXPECT_EQ(areas[0].outline, rectangle({500, 991}, {509, 1000}));
  EXPECT_EQ(areas[1].outline, rectangle({0, 900}, {200, 1000}));
  EXPECT_EQ(areas[2].outline, rectangle({200, 891}, {209, 900}));
}

TEST(PlanAreas, AnIslandInAHoleStaysApart) {
  const auto areas = svg_areas(
      R"(<g id="g"><path fill-rule="evenodd" d="M0 0h90v90h-90z M20 20h50v50h-50z"/><rect x="40" y="40" width="9" height="9"/></g>)",
      mm_page, by_id("g"));
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_EQ(areas[0].holes.size(), 1U);
  EXPECT_EQ(geometry::area(areas[1]), 81.0);
}

TEST(PlanAreas, HolesMayLieAnyhow) {
  const auto region = [](vec2 low, vec2 high) { return Region{rectangle(low, high), {}}; };
  const std::vector<Region> area = {region({0, 0}, {100, 100})};
  // Inside: kept as it is.
  const auto inside = without(area, {region({10, 10}, {20, 20}), region({50, 50}, {60, 60})});
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_EQ(inside[0].holes.size(), 2U);
  // Overlapping each other; across the outline; along it; far away.
  const auto merged = without(area, {region({10, 10}, {20, 20}), region({15, 15}, {30, 30})});
  EXPECT_EQ(geometry::area(merged[0]), 10'000 - 100 - 225 + 25);
  EXPECT_EQ(geometry::area(without(area, {region({90, 40}, {120, 60})})[0]), 10'000 - 200);
  EXPECT_EQ(geometry::area(without(area, {region({90, 40}, {100, 60})})[0]), 10'000 - 200);
  EXPECT_EQ(without(area, {region({200, 200}, {300, 300})}), area);
  // In two.
  EXPECT_EQ(without(area, {region({40, -10}, {60, 110})}).size(), 2U);
  // A pond with an island.
  const Region pond{rectangle({20, 20}, {80, 80}), {{{40, 40}, {40, 60}, {60, 60}, {60, 40}}}};
  EXPECT_EQ(without(area, {pond}).size(), 2U);
}

}  // namespace
}  // namespace shatterpave::scene
