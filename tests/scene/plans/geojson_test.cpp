// GeoJSON as it is found in practice: reference systems, longitudes, features that are broken, files of lines, names.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "scene/plans/plan_areas.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

// A file of its own beside a scene.
class GeoJsonFile : public support::FolderTest {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& text, const std::string& name = "a.geojson") const {
    std::ofstream(path(name), std::ios::binary) << text;
  }

  // The scene with one pavement that takes `lines` from what was written.
  Scene scene(const std::string& lines = "", const std::string& file = "a.geojson") const {
    return scene_of_text("[[pavement]]\nname = \"p\"\nstone_mm = [900, 900]\noutline_file = \"" + file + "\"\n" + lines,
                         folder_ / "s.toml");
  }
  vec2 size(const std::string& text, const std::string& lines = "") const {
    write(text);
    const Scene read = scene(lines);
    EXPECT_EQ(read.pavements.size(), 1U);
    const geometry::Box box = geometry::bounding_box(read.pavements.at(0).area.outline);
    return box.high - box.low;
  }
  double area(const std::string& text, const std::string& lines = "") const {
    write(text);
    double sum = 0.0;
    for (const paving::Pavement& pavement : scene(lines).pavements) sum += geometry::area(pavement.area);
    return sum * 1e-6;
  }
  // Without the folder's name.
  std::string plain(std::string message) const {
    const std::string folder = folder_.string() + "/";
    for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder))
      message.erase(at, folder.size());
    return message;
  }
  std::string error(const std::string& text, const std::string& lines = "") const {
    write(text);
    try {
      scene(lines);
    } catch (const InputError& found) {
      return plain(found.what());
    }
    return "no error";
  }
  std::vector<std::string> notes(const std::string& text, const std::string& lines = "") const {
    write(text);
    std::vector<std::string> found;
    for (const Note& note : scene(lines).notes) found.push_back(plain(located(note)));
    return found;
  }
};

std::string rectangle(double x, double y, double width, double height) {
  return fmt::format("[[{0},{1}],[{2},{1}],[{2},{3}],[{0},{3}],[{0},{1}]]", x, y, x + width, y + height);
}
std::string polygon_geometry(const std::string& ring, const std::string& members = "") {
  return fmt::format(R"({{"type":"Polygon",{}"coordinates":[{}]}})", members, ring);
}
std::string feature(const std::string& geometry, const std::string& properties = "{}", const std::string& members = "") {
  return fmt::format(R"({{"type":"Feature",{}"properties":{},"geometry":{}}})", members, properties, geometry);
}
std::string collection(const std::vector<std::string>& features, const std::string& members = "") {
  return fmt::format(R"({{"type":"FeatureCollection",{}"features":[{}]}})", members, fmt::join(features, ","));
}
std::string crs_name(const std::string& name) {
  return fmt::format(R"("crs":{{"type":"name","properties":{{"name":"{}"}}}},)", name);
}

// 20 × 12 m at 10° east, 50° north: lengths of a degree there as in NGA TR 8350.2.
constexpr double east_deg = 20.0 / 71696.0;
constexpr double north_deg = 12.0 / 111229.0;
const std::string in_degrees = "[[10,50],[10.00027895,50],[10.00027895,50.00010788],[10,50.00010788],[10,50]]";

void expect_size(vec2 size, double width_m, double height_m, const std::string& what) {
  EXPECT_NEAR(size.x, width_m * 1000.0, 5.0) << what;
  EXPECT_NEAR(size.y, height_m * 1000.0, 5.0) << what;
}

TEST_F(GeoJsonFile, CrsInEveryPlaceAndForm) {
  EXPECT_NEAR(east_deg, 0.00027895, 1e-7);
  EXPECT_NEAR(north_deg, 0.00010788, 1e-7);
  for (
      const std::string& crs :
      {crs_name("urn:ogc:def:crs:EPSG::7844"), crs_name("WGS 84"), crs_name("http://www.opengis.net/def/crs/EPSG/0/4326"),
       crs_name("urn:ogc:def:crs,crs:EPSG::4326,crs:EPSG::5773"),
       std::string(R"("crs":{"type":"EPSG","properties":{"code":4326}},)"),
       std::string(R"("crs":{"type":"EPSG","properties":{"code":"4326"}},)"),
       std::string(R"("crs":{"type":"OGC","properties":{"code":"CRS84"}},)"),
       std::string(R"("crs":{"type":"name","properties":{"name":4326}},)"),
       std::string(R"("crs":{"type":"name","properties":{"code":4326}},)"),
       std::string(
           R"("crs":{"type":"link","properties":{"href":"http://spatialreference.org/ref/epsg/4326/proj4/","type":"proj4"}},)"),
       std::string(R"("crs":"EPSG:4326",)"), std::string(R"("crs":4326,)"), std::string(R"("crs":{"wkid":4326},)"),
       std::string(R"("spatialReference":{"wkid":104199,"latestWkid":4326},)"), std::string(R"("crs":null,)"),
       std::string(
           R"("crs":{"type":"GeographicCRS","name":"x","datum":{"type":"GeodeticReferenceFrame","name":"x","ellipsoid":)"
           R"({"name":"e","semi_major_axis":6378137,"inverse_flattening":298.257223563}},"coordinate_system":{"subtype":)"
           R"("ellipsoidal","axis":[{"name":"Longitude","abbreviation":"lon","direction":"east","unit":"degree"},)"
           R"({"name":"Latitude","abbreviation":"lat","direction":"north","unit":"degree"}]}},)")}) {
    expect_size(size(polygon_geometry(in_degrees, crs)), 20.0, 12.0, crs);
    expect_size(size(collection({feature(polygon_geometry(in_degrees))}, crs)), 20.0, 12.0, crs);
    expect_size(size(collection({feature(polygon_geometry(in_degrees, crs))})), 20.0, 12.0, crs);
    expect_size(size(collection({feature(polygon_geometry(in_degrees), "{}", crs)})), 20.0, 12.0, crs);
  }
  const std::string feet = rectangle(6'000'000.0, 2'100'000.0, 65.616667, 39.37);
  expect_size(size(polygon_geometry(feet, crs_name("urn:ogc:def:crs:EPSG::2227"))), 20.0, 12.0, "US survey feet");
  expect_size(size(polygon_geometry(feet, crs_name("urn:ogc:def:crs:EPSG::2227")), "outline_units = \"us_survey_feet\"\n"),
              20.0, 12.0, "both");
  expect_size(size(polygon_geometry(feet), "outline_units = \"us_survey_feet\"\n"), 20.0, 12.0, "by the key");
  expect_size(size(polygon_geometry(rectangle(0, 0, 1000, 500)), "outline_units = \"feet\"\n"), 304.8, 152.4, "feet");
  expect_size(size(polygon_geometry(rectangle(5'000'000, 5'000'000, 1000, 500), crs_name("EPSG:6559"))), 304.8, 152.4,
              "Oregon");
  const std::string grads = "[[10,55.555555556],[10.000309944,55.555555556],[10.000309944,55.555675422],[10,55.555675422]]";
  const vec2 of_grads = size(polygon_geometry(grads, crs_name("EPSG:4807")));
  EXPECT_NEAR(of_grads.x, 20'000.0, 10.0);  // of Clarke's ellipsoid of 1880: 0.1 ‰ of another size
  EXPECT_NEAR(of_grads.y, 12'000.0, 10.0);
}

TEST_F(GeoJsonFile, FeetMoveToTheirMiddleInWholeFeet) {
  write(polygon_geometry(rectangle(6'000'000.0, 2'100'000.0, 10, 10), crs_name("EPSG:2227")));
  const geometry::Box box = geometry::bounding_box(scene().pavements[0].area.outline);
  EXPECT_NEAR(box.low.x, -5 * 304.8006, 0.01);
  EXPECT_NEAR(box.high.y, 5 * 304.8006, 0.01);
}

// A triangle with its right angle at the second point, in systems whose axes run south and west.
TEST_F(GeoJsonFile, NorthIsUpWhateverTheAxes) {
  const auto corners = [&](const std::string& ring, const std::string& crs) {
    write(polygon_geometry(ring, crs_name(crs)));
    geometry::Polygon p = scene().pavements.at(0).area.outline;
    const geometry::Box box = geometry::bounding_box(p);
    for (vec2& corner : p) corner = geometry::on_lattice(corner - box.low);
    return p;
  };
  const std::string ring = "[[500000,6000000],[500010,6000000],[500010,6000005]]";
  EXPECT_EQ(corners(ring, "EPSG:25833"), (geometry::Polygon{{0, 0}, {10'000, 0}, {10'000, 5'000}}));
  EXPECT_EQ(corners("[[3500000,5600000],[3500010,5600000],[3500010,5600005]]", "EPSG:31467"),
            (geometry::Polygon{{0, 0}, {10'000, 0}, {10'000, 5'000}}));  // north first by its definition, not in GeoJSON
  EXPECT_EQ(corners("[[20000,3700000],[20010,3700000],[20010,3700005]]", "EPSG:2053"),
            (geometry::Polygon{{0, 0}, {10'000, 5'000}, {0, 5'000}}));  // westing, southing
  EXPECT_EQ(corners("[[1043000,743000],[1043010,743000],[1043010,743005]]", "EPSG:5513"),
            (geometry::Polygon{{0, 0}, {5'000, 0}, {5'000, 10'000}}));  // southing, westing
}

TEST_F(GeoJsonFile, MapsThatAreOffAreToldOrRefused) {
  const std::string plate = polygon_geometry(rectangle(1'200'000.0, 6'679'169.0, 40, 24), crs_name("EPSG:4087"));
  EXPECT_EQ(
      error(plate),
      "a.geojson: crs: expected a reference system that keeps lengths, such as EPSG:4326 or UTM, got \"EPSG:4087\", a map on "
      "which lengths are 1.00 to 1.99 times those on the ground at this place; set outline_units to say what its numbers are");
  expect_size(size(plate, "outline_units = \"metres\"\n"), 40.0, 24.0, "stated");
  const std::string europe = polygon_geometry(rectangle(4'000'000.0, 2'800'000.0, 40, 24), crs_name("EPSG:3034"));
  expect_size(size(europe), 40.0, 24.0, "Lambert's map of Europe");
  ASSERT_EQ(notes(europe).size(), 1U);
  EXPECT_TRUE(
      notes(europe)[0].starts_with("a.geojson: crs: note: the file names \"EPSG:3034\", a map on which lengths are 0.9"));
  EXPECT_TRUE(notes(polygon_geometry(rectangle(391'000, 5'812'000, 40, 24), crs_name("EPSG:25833"))).empty());
}

TEST_F(GeoJsonFile, CrsThatKeepsNoLengthsIsRefused) {
  const std::string far = rectangle(1'200'000.0, 8'400'000.0, 40, 24);
  const std::string wanted = "a.geojson: crs: expected a reference system that keeps lengths, such as EPSG:4326 or UTM, got ";
  for (const std::string& crs :
       {crs_name("urn:ogc:def:crs:EPSG::3857"), crs_name("EPSG:900913"), crs_name("ESRI:102113"), crs_name("EPSG:3395"),
        std::string(R"("crs":{"type":"EPSG","properties":{"code":3857}},)"),
        std::string(R"("spatialReference":{"wkid":102100},)"), crs_name("http://www.opengis.net/def/crs/EPSG/0/3857")}) {
    for (const char* lines : {"", "outline_units = \"metres\"\n"}) {
      const std::string found = error(polygon_geometry(far, crs), lines);
      EXPECT_TRUE(found.starts_with(wanted)) << crs << ": " << found;
      EXPECT_TRUE(found.ends_with("a Mercator projection, in which lengths grow with latitude: twice too long at 60°"))
          << found;
    }
  }
  EXPECT_EQ(error(polygon_geometry(far, crs_name("urn:mine:42"))),
            wanted + "\"urn:mine:42\", which PROJ does not know; set outline_units to say what its numbers are");
  expect_size(size(polygon_geometry(far, crs_name("urn:mine:42")), "outline_units = \"metres\"\n"), 40.0, 24.0, "unknown");
  EXPECT_EQ(error(polygon_geometry(far, crs_name("EPSG:4978"))),
            wanted + "\"WGS 84\", which is geocentric: its x, y and z run from the middle of the Earth");
  EXPECT_EQ(error(polygon_geometry(far, R"("crs":{"type":"name"},)")),
            "a.geojson: crs: expected a reference system by name, code or link, got an object");
  EXPECT_EQ(error(collection({feature(polygon_geometry(far, crs_name("EPSG:25833"))), feature(polygon_geometry(in_degrees))}),
                  "outline_feature = 0\n"),
            "a.geojson: features[1].geometry.coordinates: expected one reference system for all shapes, got none beside "
            "\"EPSG:25833\"");
  EXPECT_EQ(error(collection({feature(polygon_geometry(far, crs_name("EPSG:25833"))),
                              feature(polygon_geometry(far, crs_name("EPSG:25832")))}),
                  "outline_feature = 0\n"),
            "a.geojson: features[0].geometry.coordinates: expected one reference system for all shapes, got \"EPSG:25833\" "
            "beside \"EPSG:25832\"");
  // Degrees are degrees.
  expect_size(
      size(collection({feature(polygon_geometry(in_degrees, crs_name("EPSG:4258"))), feature(polygon_geometry(in_degrees))},
                      crs_name("urn:ogc:def:crs:OGC:1.3:CRS84")),
           "outline_feature = 0\n"),
      20.0, 12.0, "two");
}

TEST_F(GeoJsonFile, LongitudesCountModulo360) {
  // 20 × 12 m at 18° south: a degree of longitude is 105,896 m, one of latitude 110,679 m.
  const double width = 20.0 / 105896.0;
  const double height = 12.0 / 110679.0;
  const auto across = [&](double from, double to) {
    return fmt::format("[[{0:.9f},-18],[{1:.9f},-18],[{1:.9f},{2:.9f}],[{0:.9f},{2:.9f}]]", from, to, -18 + height);
  };
  for (const double turn : {0.0, 360.0, -360.0, 720.0}) {
    for (const char* lines : {"", "outline_units = \"degrees\"\n"}) {
      if (std::abs(turn) > 100.0 && turn != 360.0 && *lines == '\0') continue;  // beyond 360 no one would guess degrees
      const vec2 found = size(polygon_geometry(across(-179.9 + turn, -179.9 + turn + width)), lines);
      EXPECT_NEAR(found.x, 20'000.0, 5.0) << turn;
      EXPECT_NEAR(found.y, 12'000.0, 5.0) << turn;
    }
  }
  // Across the antimeridian, counted on or not.
  for (const auto& [from, to] :
       std::vector<std::pair<double, double>>{{179.9995, 180.0005}, {179.9995, -179.9995}, {-180.0005, 179.9995 - 359.999}}) {
    const vec2 found = size(polygon_geometry(across(from, to)), "outline_units = \"degrees\"\n");
    EXPECT_NEAR(found.x, 105'896.0, 20.0) << from;
  }
  EXPECT_EQ(
      error(polygon_geometry("[[180.1,-91],[180.1001,-91],[180.1001,-90.9999]]"), "outline_units = \"degrees\"\n"),
      "a.geojson: coordinates[0]: expected longitudes, which count modulo 360, and latitudes from -90 to 90, got (180.1, -91)");
  EXPECT_EQ(error(polygon_geometry("[[1e9,0],[1e9,1],[1000000001,1]]"), "outline_units = \"degrees\"\n").substr(0, 62),
            "a.geojson: coordinates[0]: expected longitudes, which count mo");
  // A place of 300 × 80 m in metres of its own stays one, though its numbers could be degrees counted on.
  expect_size(size(polygon_geometry("[[20,5],[320,5],[320,85],[20,85]]")), 300.0, 80.0, "metres");
}

const std::string square = "[[0,0],[300,0],[300,300],[0,300],[0,0]]";
const std::string bow = "[[400,0],[500,100],[500,0],[400,100],[400,0]]";
const std::string lone = "[[600,0],[700,0]]";

TEST_F(GeoJsonFile, OneBadFeatureDoesNotTakeItsClassWithIt) {
  const std::string paved = R"({"class":"paved"})";
  const std::string text = collection(
      {feature(polygon_geometry(square), paved, R"("id":"good",)"), feature(polygon_geometry(lone), paved, R"("id":"bad",)"),
       feature(R"({"type":"Polygon","coordinates":[[[0,0],[1,"x"],[1,1]]]})", paved, R"("id":"torn",)"),
       feature(R"({"type":"Polygon"})", paved, R"("id":"bare",)"),
       R"({"type":"Feature","id":"none","properties":{"class":"paved"}})", "7", "null"});
  EXPECT_NEAR(area(text, "outline_class = \"paved\"\n"), 90'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"good\"\n"), 90'000.0, 1e-6);
  EXPECT_EQ(notes(text, "outline_class = \"paved\"\n"),
            (std::vector<std::string>{
                "a.geojson: features[2].geometry.coordinates[0][1]: note: left out: expected a position [x, y], got [1, \"x\"]",
                "a.geojson: features[3].geometry.coordinates: note: left out: expected an array, got none",
                "a.geojson: features[4].geometry: note: left out: expected a geometry, got none",
                "a.geojson: features[1].geometry.coordinates[0]: note: left out: expected 3 or more distinct points, got 2"}));
  EXPECT_TRUE(notes(text, "outline_feature = \"good\"\n").empty());
  // By its name, or its index, it must be sound.
  EXPECT_EQ(error(text, "outline_feature = \"bad\"\n"),
            "a.geojson: features[1].geometry.coordinates[0]: expected 3 or more distinct points, got 2");
  EXPECT_EQ(error(text, "outline_feature = [0, 1]\n"),
            "a.geojson: features[1].geometry.coordinates[0]: expected 3 or more distinct points, got 2");
  EXPECT_EQ(error(text, "outline_feature = \"torn\"\n"),
            "a.geojson: features[2].geometry.coordinates[0][1]: expected a position [x, y], got [1, \"x\"]");
  EXPECT_EQ(error(text, "outline_feature = \"none\"\n"), "a.geojson: features[4].geometry: expected a geometry, got none");
  // Nothing sound at all is an error.
  EXPECT_EQ(error(collection({feature(polygon_geometry(lone), paved), feature(polygon_geometry(lone), paved)}),
                  "outline_class = \"paved\"\n"),
            "a.geojson: features[0].geometry.coordinates[0]: expected 3 or more distinct points, got 2");
  // Of degrees, a latitude that there is not; as holes; as guides.
  const std::string beyond = collection(
      {feature(polygon_geometry(in_degrees), paved), feature(polygon_geometry("[[10,95],[10.1,95],[10,95.1]]"), paved)},
      crs_name("EPSG:4326"));
  EXPECT_NEAR(area(beyond, "outline_class = \"paved\"\n"), 240.0, 0.1);
  EXPECT_EQ(notes(beyond, "outline_class = \"paved\"\n").size(), 1U);
  const std::string holes = collection({feature(polygon_geometry(square), "{}", R"("id":"yard",)"),
                                        feature(polygon_geometry("[[10,10],[20,10],[20,20]]"), R"({"class":"bed"})"),
                                        feature(polygon_geometry(lone), R"({"class":"bed"})")});
  EXPECT_NEAR(area(holes, "outline_feature = \"yard\"\nholes_class = \"bed\"\n"), 89'950.0, 1e-6);
  EXPECT_EQ(notes(holes, "outline_feature = \"yard\"\nholes_class = \"bed\"\n").size(), 1U);
  const std::string guides =
      collection({feature(polygon_geometry(square)), feature(R"({"type":"LineString","coordinates":[[0,0],[300,10]]})"),
                  feature(R"({"type":"LineString","coordinates":[[5,5],[5,5]]})")});
  write(guides);
  const Scene guided = scene("direction = {kind = \"guides\", guides_file = \"a.geojson\"}\n");
  EXPECT_EQ(std::get<paving::GuidesDirection>(guided.pavements.at(0).direction).guides_mm.size(), 1U);
  EXPECT_EQ(guided.notes.size(), 1U);
}

TEST_F(GeoJsonFile, RingsAreWhatTheyEnclose) {
  const std::string in_metres = "outline_units = \"metres\"\n";
  const std::string box = "[[0,0],[10,0],[10,10],[0,10],[0,0]]";
  struct Case {
    std::string rings;
    double area_m2;
    std::size_t notes;
  };
  for (const Case& one :
       {Case{"[[0,0],[8,0],[8,6],[0,6],[0,3],[3,4],[3,2],[0,3],[0,0]]", 45.0, 1},                  // touches itself
        Case{"[[0,0],[8,0],[8,6],[4,6],[4,3],[6,4.5],[4,3],[4,6],[0,6],[0,0]]", 48.0, 1},          // a spike inwards
        Case{"[[0,0],[10,0],[10,10],[0,10],[0,0],[4,4],[4,6],[6,6],[6,4],[4,4],[0,0]]", 96.0, 1},  // a keyhole
        Case{box + ",[[8,4],[12,4],[12,6],[8,6]]", 96.0, 1},                                       // a hole beyond it
        Case{box + ",[[2,2],[6,2],[6,6],[2,6]],[[4,4],[8,4],[8,8],[4,8]]", 72.0, 1},               // holes that overlap
        Case{box + ",[[0,4],[2,4],[2,6],[0,6]]", 96.0, 1},                                         // a hole along it
        Case{box + ",[[2,2],[4,2],[4,4],[2,4]],[[4,2],[6,2],[6,4],[4,4]]", 92.0, 1},               // holes side by side
        Case{"[[0,0],[10,10],[10,0],[0,10],[0,0]]", 50.0, 1},                                      // crosses itself
        Case{box + ",[[2,2],[4,2],[4,4],[2,4]]", 96.0, 0}}) {
    EXPECT_NEAR(area(polygon_geometry(one.rings), in_metres), one.area_m2, 1e-4) << one.rings;
    EXPECT_EQ(notes(polygon_geometry(one.rings), in_metres).size(), one.notes) << one.rings;
  }
}

TEST_F(GeoJsonFile, LinesAndRecords) {
  const std::string a = feature(polygon_geometry(square), R"({"name":"a"})");
  const std::string b = feature(polygon_geometry("[[400,0],[500,0],[500,100]]"), R"({"name":"b"})");
  const std::string rs = "\x1E";
  for (const std::string& text :
       {fmt::format("{}\n{}\n", a, b), fmt::format("{}\r\n\r\n{}", a, b), fmt::format("{0}{1}\n{0}{2}\n", rs, a, b),
        fmt::format("{}{}", a, b), fmt::format("\xEF\xBB\xBF{}\n{}", a, b),
        fmt::format("{}\n{}", collection({a}), collection({b})), fmt::format("{0}{1}{0}{2}", rs, a, b)}) {
    EXPECT_NEAR(area(text, "outline_feature = \"a\"\n"), 90'000.0, 1e-6) << text;
    EXPECT_NEAR(area(text, "outline_feature = \"b\"\n"), 5'000.0, 1e-6) << text;
  }
  for (const char* name : {"a.geojsonl", "a.geojsons", "a.GeoJSONSeq", "a.ndjson", "a.jsonl", "a.ndgeojson"}) {
    write(fmt::format("{}\n{}\n", a, b), name);
    EXPECT_EQ(scene("outline_feature = \"b\"\n", name).pavements.size(), 1U) << name;
  }
  EXPECT_NEAR(area(rs + a + "\n"), 90'000.0, 1e-6);
  EXPECT_EQ(error(a + "\n" + feature(polygon_geometry(lone), R"({"name":"c"})"), "outline_feature = \"c\"\n"),
            "a.geojson:2:1: geometry.coordinates[0]: expected 3 or more distinct points, got 2");
  EXPECT_EQ(error(a + "\n{\"type\":,}\n" + b), "a.geojson:2:9: expected JSON, got a syntax error");
  EXPECT_EQ(error(a + "\nwords\n" + b), "a.geojson:2:1: expected JSON, got a syntax error");
}

TEST_F(GeoJsonFile, MarksLineEndsAndEmptyThings) {
  EXPECT_NEAR(area("\xEF\xBB\xBF" + polygon_geometry(square)), 90'000.0, 1e-6);
  EXPECT_NEAR(area("\r\n" + polygon_geometry(square) + "\r\n"), 90'000.0, 1e-6);
  EXPECT_NEAR(area(polygon_geometry("[[0,0,5],[300,0,5,1],[300,300,null],[0,300,5]]")), 90'000.0, 1e-6);
  const std::string nothing = R"({"type":"Polygon","coordinates":[]})";
  EXPECT_NEAR(
      area(collection(
          {feature(nothing), feature(R"({"type":"Polygon","coordinates":[[]]})"), feature("null"),
           feature(R"({"type":"MultiPolygon","coordinates":[]})"), feature(R"({"type":"MultiPolygon","coordinates":[[]]})"),
           feature(R"({"type":"GeometryCollection","geometries":[]})"), feature(R"({"type":"LineString","coordinates":[]})"),
           feature(R"({"type":"Point","coordinates":[]})"), feature(polygon_geometry(square), "null")})),
      90'000.0, 1e-6);
  const std::string nested = R"({"type":"GeometryCollection","geometries":[{"type":"GeometryCollection","geometries":[)" +
                             nothing + "," + polygon_geometry(square) + R"(]},{"type":"Point","coordinates":[1,2,3]}]})";
  EXPECT_NEAR(area(nested), 90'000.0, 1e-6);
  EXPECT_NEAR(area(collection({feature(nested)})), 90'000.0, 1e-6);
}

TEST_F(GeoJsonFile, NamesInSeveralLanguagesAndNumbers) {
  const std::string text = collection(
      {feature(polygon_geometry(square), R"({"name":{"en":"Market Square","de":"Marktplatz"},"levels":2.0})", R"("id":7,)"),
       feature(polygon_geometry("[[400,0],[500,0],[500,100]]"),
               R"({"name":"Place du Marché","name:en":"Market Place","name:de":"Marktplatz"})", R"("id":8.0,)"),
       feature(polygon_geometry("[[600,0],[700,0],[700,100]]"),
               R"({"names":{"primary":"Tori","common":{"sv":"Torget","en":"Market Place"}}})", R"("id":12345678901234567,)")});
  EXPECT_NEAR(area(text, "outline_feature = \"Market Square\"\n"), 90'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"7\"\n"), 90'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"8\"\n"), 5'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"8.0\"\n"), 5'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"12345678901234567\"\n"), 5'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"Torget\"\n"), 5'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_feature = \"Place du Marché\"\n"), 5'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_class = \"levels=2\"\n"), 90'000.0, 1e-6);
  EXPECT_NEAR(area(text, "outline_class = \"name:en=Market Square\"\n"), 90'000.0, 1e-6);
  EXPECT_NE(error(text, "outline_feature = \"Market Place\"\n").find("got \"Market Place\", the id of 2"), std::string::npos);
  // A name of its own goes before the same in another language.
  const std::string twice = collection({feature(polygon_geometry(square), R"({"name":"Torg","name:en":"Market"})"),
                                        feature(polygon_geometry("[[400,0],[500,0],[500,100]]"), R"({"name":"Market"})")});
  EXPECT_NEAR(area(twice, "outline_feature = \"Market\"\n"), 5'000.0, 1e-6);
}

// A pipe that another process fills, as a shell makes it for <(…).
TEST_F(GeoJsonFile, ReadsPipes) {
  const std::string pipe = path("pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto through = [&](const std::string& text, const auto& read) {
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << text; });
    auto result = read();
    writer.join();
    return result;
  };
  const std::string many =
      collection(std::vector<std::string>(3000, feature(polygon_geometry(square))));  // more than a pipe holds
  const Scene plan = through(many, [&] { return scene("outline_feature = [0, 1]\n", pipe); });
  EXPECT_EQ(plan.pavements.size(), 1U);
  const Scene svg = through(R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="96" height="96"/></svg>)",
                            [&] { return scene("", pipe); });
  EXPECT_NEAR(geometry::area(svg.pavements.at(0).area), 25.4 * 25.4, 1e-6);
  const Scene piped = through("[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n", [&] { return scene_of_file(pipe); });
  EXPECT_EQ(piped.name, "pipe");
}

}  // namespace
}  // namespace shatterpave::scene
