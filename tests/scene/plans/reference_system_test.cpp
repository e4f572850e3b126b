#include "scene/plans/reference_system.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shatterpave::scene {
namespace {

bool is_degrees(const ReferenceSystem& system) { return system.units && alike(*system.units, PlanUnits::degrees); }
bool is_metres(const ReferenceSystem& system) {
  return system.projected && system.units && alike(*system.units, PlanUnits::metres);
}

TEST(ReferenceSystem, DegreesInEverySpelling) {
  for (
      const char* name :
      {"EPSG:4326", "epsg:4326", "EPSG::4326", "4326", "urn:ogc:def:crs:EPSG::4326", "urn:ogc:def:crs:EPSG:9.8.15:4326",
       "urn:ogc:def:crs:EPSG:8.5:4326", "URN:OGC:DEF:CRS:EPSG::4326", "urn:x-ogc:def:crs:EPSG:4326",
       "urn:x-ogc:def:crs:EPSG:6.11:4326", "urn:opengis:def:crs:EPSG::4326", "http://www.opengis.net/def/crs/EPSG/0/4326",
       "https://www.opengis.net/def/crs/EPSG/0/4326", "http://opengis.net/def/crs/EPSG/9.9.1/4326",
       "http://www.opengis.net/def/crs/EPSG/0/4326/", "http://www.opengis.net/gml/srs/epsg.xml#4326",
       "http://spatialreference.org/ref/epsg/4326/", "https://spatialreference.org/ref/epsg/4326/ogcwkt/",
       "https://epsg.io/4326", "https://epsg.io/4326.json", "+init=epsg:4326", " EPSG:4326\n",
       // Degrees that the numbers of EPSG's dataset do not tell.
       "EPSG:7844", "EPSG:6697", "EPSG:6318", "EPSG:9057", "EPSG:4979", "EPSG:8685", "ESRI:104145", "EPSG:104145",
       // OGC's own.
       "OGC:CRS84", "CRS84", "crs84", "CRS:84", "CRS:83", "OGC:CRS27", "OGC:CRS84h", "CRS84h", "urn:ogc:def:crs:OGC:1.3:CRS84",
       "urn:ogc:def:crs:OGC::CRS84", "urn:ogc:def:crs:OGC:2:84", "http://www.opengis.net/def/crs/OGC/1.3/CRS84",
       "https://www.opengis.net/def/crs/OGC/0/CRS84h",
       // With heights.
       "EPSG:4326+5773", "EPSG:4326+EPSG:5773", "urn:ogc:def:crs,crs:EPSG::4326,crs:EPSG::5773",
       "urn:ogc:def:crs,crs:EPSG:9.8:4326,crs:EPSG:9.8:5773",
       R"(http://www.opengis.net/def/crs-compound?1=http://www.opengis.net/def/crs/EPSG/0/4326&2=http://www.opengis.net/def/crs/EPSG/0/5773)",
       "WGS 84 + EGM96 height",
       // By name.
       "WGS 84", "WGS84", "wgs84", "WGS_84", "GCS_WGS_1984", "GDA2020", "GDA94", "JGD2011", "NAD83", "NAD27", "NAD83(2011)",
       "ETRS89", "WGS 84 (CRS84)", "RGF93 v1",
       // Definitions.
       "+proj=longlat +datum=WGS84 +no_defs", "+proj=longlat +datum=WGS84 +no_defs +type=crs",
       R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])"}) {
    EXPECT_TRUE(is_degrees(reference_system(name))) << name << ": " << reference_system(name).is;
  }
}

TEST(ReferenceSystem, Lengths) {
  for (const char* name : {"EPSG:25833",
                           "urn:ogc:def:crs:EPSG::2056",
                           "http://www.opengis.net/def/crs/EPSG/0/27700",
                           "EPSG:2154",
                           "EPSG:28992",
                           "EPSG:31468",
                           "EPSG:7856",
                           "EPSG:6677",
                           "ESRI:102003",
                           "EPSG:102003",
                           "EPSG:25833+7837",
                           "EPSG:5555",
                           "EPSG:7415",
                           "IGNF:LAMB93",
                           "WGS 84 / UTM zone 33N",
                           "WGS84 / UTM zone 33N",
                           "ETRS89 / UTM zone 32N + DHHN2016 height",
                           "Amersfoort / RD New",
                           "British National Grid",
                           "+proj=utm +zone=33 +datum=WGS84",
                           "+proj=tmerc +lon_0=9 +ellps=bessel +towgs84=598,74,418"}) {
    EXPECT_TRUE(is_metres(reference_system(name))) << name << ": " << reference_system(name).is;
  }
  const std::vector<std::pair<const char*, double>> others = {
      {"EPSG:2227", 1200.0 / 3937.0},      // US survey feet
      {"EPSG:2263", 1200.0 / 3937.0},      // New York
      {"ESRI:102643", 1200.0 / 3937.0},    // California III, by Esri's code
      {"EPSG:6559", 0.3048},               // Oregon, international feet
      {"EPSG:2222", 0.3048},               // Arizona, international feet
      {"EPSG:29702", 1.0},                 // Tananarive, but in metres
      {"EPSG:2155", 1200.0 / 3937.0},      // American Samoa
      {"EPSG:24571", 20.116765121552632},  // Kertau, chains
      {"EPSG:27291", 0.91439841463667},    // New Zealand's yards of Sears: 1 in axes
      {"NAD83 / California zone 3 (ftUS)", 1200.0 / 3937.0},
      {"+proj=lcc +lat_1=30 +lat_2=50 +units=us-ft", 1200.0 / 3937.0},
      {"+proj=utm +zone=33 +units=km", 1000.0}};
  for (const auto& [name, metres] : others) {
    const ReferenceSystem system = reference_system(name);
    ASSERT_TRUE(system.units) << name << ": " << system.is;
    EXPECT_EQ(system.units->kind, PlanUnits::Kind::length) << name;
    EXPECT_NEAR(system.units->size, metres, 1e-6 * metres) << name;
  }
  // Grads, from Paris.
  const ReferenceSystem grads = reference_system("EPSG:4807");
  ASSERT_TRUE(grads.units);
  EXPECT_EQ(grads.units->kind, PlanUnits::Kind::angle);
  EXPECT_NEAR(grads.units->size, 0.9, 1e-9);
  // Of another body.
  const ReferenceSystem moon = reference_system("IAU_2015:30100");
  ASSERT_TRUE(moon.units) << moon.is;
  EXPECT_NEAR(moon.units->semi_major_axis_m, 1'737'400.0, 1.0);
  EXPECT_TRUE(reference_system("urn:ogc:def:crs:IAU:2015:30100").units);
}

TEST(ReferenceSystem, RefusesMercatorsInEverySpelling) {
  for (const char* name :
       {"EPSG:3857",
        "epsg:3857",
        "3857",
        "urn:ogc:def:crs:EPSG::3857",
        "urn:x-ogc:def:crs:EPSG:3857",
        "http://www.opengis.net/def/crs/EPSG/0/3857",
        "https://www.opengis.net/def/crs/EPSG/9.9/3857",
        "EPSG:900913",
        "urn:ogc:def:crs:EPSG::900913",
        "GOOGLE:900913",
        "EPSG:3785",
        "EPSG:102100",
        "ESRI:102100",
        "urn:ogc:def:crs:ESRI::102100",
        "EPSG:102113",
        "ESRI:102113",
        "EPSG:3395",
        "EPSG:3832",
        "EPSG:3994",
        "ESRI:54004",
        "EPSG:3857+5773",
        "WGS 84 / Pseudo-Mercator",
        "WGS_1984_Web_Mercator_Auxiliary_Sphere",
        "WGS_1984_Web_Mercator",
        "Web Mercator",
        "WGS 84 / World Mercator",
        "+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +lon_0=0 +x_0=0 +y_0=0 +k=1 +units=m +nadgrids=@null +wktext +no_defs",
        "+proj=webmerc +datum=WGS84",
        "+proj=merc +lat_ts=41",
        "http://spatialreference.org/ref/epsg/3857/proj4/",
        "https://epsg.io/3857"}) {
    const ReferenceSystem system = reference_system(name);
    EXPECT_FALSE(system.units) << name;
    EXPECT_FALSE(system.can_be_stated) << name;
    EXPECT_NE(system.is.find("Mercator projection"), std::string::npos) << name << ": " << system.is;
  }
  // Those that lie across or aslant keep lengths where they are used.
  for (const char* name : {"EPSG:31467", "EPSG:3168", "EPSG:26931", "EPSG:29700", "EPSG:2056", "EPSG:3079"}) {
    EXPECT_TRUE(is_metres(reference_system(name))) << name << ": " << reference_system(name).is;
  }
}

TEST(ReferenceSystem, RefusesWhatHasNoPlane) {
  const auto is = [](const char* name) { return reference_system(name).is; };
  EXPECT_EQ(is("EPSG:4978"), "\"WGS 84\", which is geocentric: its x, y and z run from the middle of the Earth");
  EXPECT_EQ(is("EPSG:5773"), "\"EGM96 height\", which is of heights alone");
  EXPECT_EQ(is("foo"), "\"foo\", which PROJ does not know");
  EXPECT_EQ(is("EPSG:1"), "\"EPSG:1\", which PROJ does not know");
  EXPECT_EQ(is("SR-ORG:6864"), "\"SR-ORG:6864\", which PROJ does not know");
  EXPECT_TRUE(reference_system("foo").can_be_stated);
  EXPECT_FALSE(reference_system("EPSG:4978").can_be_stated);
  EXPECT_FALSE(reference_system("EPSG:5773").can_be_stated);
  const ReferenceSystem site = reference_system(
      R"(ENGCRS["site",EDATUM["corner"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1]])");
  EXPECT_EQ(site.is, "\"site\", which is of no place on Earth");
  EXPECT_TRUE(site.can_be_stated);
  for (const char* name :
       {"", " ", "EPSG", "EPSG:", ":", "EPSG:99999", "UTM", "Mercator",
        "urn:ogc:def:crs:", "urn:ogc:def:crs,crs:", "+proj=nonsense", "+proj=pipeline +step +proj=utm +zone=3", "GEOGCS[",
        "{\"type\":\"GeographicCRS\"}", "+init=", "urn:ogc:def:crs:OGC:1.3:AUTO42001:-117:33", "%", "'; drop table", "+"}) {
    EXPECT_FALSE(reference_system(name).units) << name;
    EXPECT_FALSE(reference_system(name).is.empty()) << name;
  }
}

// Settings of the user, and the network, have no effect.
TEST(ReferenceSystem, IsTheSameOnEveryMachine) {
  const std::array<std::pair<const char*, const char*>, 7> settings = {{{"PROJ_DATA", "/nonexistent"},
                                                                        {"PROJ_LIB", "/nonexistent"},
                                                                        {"PROJ_AUX_DB", "/nonexistent.db"},
                                                                        {"PROJ_NETWORK", "ON"},
                                                                        {"PROJ_NETWORK_ENDPOINT", "http://127.0.0.1:9"},
                                                                        {"PROJ_USER_WRITABLE_DIRECTORY", "/nonexistent"},
                                                                        {"PROJ_DEBUG", "3"}}};
  for (const auto& [name, value] : settings) ::setenv(name, value, 1);
  testing::internal::CaptureStderr();
  EXPECT_TRUE(is_metres(reference_system("EPSG:25833")));
  EXPECT_TRUE(is_degrees(reference_system("GDA2020")));
  EXPECT_FALSE(reference_system("EPSG:3857").units);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  for (const auto& [name, value] : settings) ::unsetenv(name);
}

// Scales of EPSG's guidance note 7-2: Mercator's is 1 / cos(latitude), UTM's 0.9996 on its middle meridian.
TEST(ReferenceSystem, ScaleOfMaps) {
  const auto utm = map_scale("EPSG:25833", {500'000.0, 5'800'000.0});
  ASSERT_TRUE(utm);
  EXPECT_NEAR(utm->least, 0.9996, 2e-6);
  EXPECT_NEAR(utm->most, 0.9996, 2e-6);
  // Equirectangular, 60° north: lengths from west to east are doubled.
  const auto plate = map_scale("EPSG:4087", {1'200'000.0, 6'679'169.45});
  ASSERT_TRUE(plate);
  EXPECT_NEAR(plate->least, 1.0, 0.01);
  EXPECT_NEAR(plate->most, 2.0, 0.01);
  EXPECT_FALSE(map_scale("EPSG:4326", {10.0, 50.0}));
  EXPECT_FALSE(map_scale("foo", {10.0, 50.0}));
}

std::string output_of(const std::string& command) {
  std::string text;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::array<char, 4096> piece{};
  for (std::size_t size = 1; pipe && size > 0;) {
    size = std::fread(piece.data(), 1, piece.size(), pipe.get());
    text.append(piece.data(), size);
  }
  return text;
}

// The codes of a kind, as PROJ's program projinfo lists them: lines `EPSG:2000 "Anguilla 1957 / British West Indies Grid"`.
std::vector<std::string> codes_listed(const std::string& kind) {
  const std::string list = output_of("projinfo --list-crs " + kind + " 2>/dev/null");
  std::vector<std::string> codes;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find('\n', at), list.size());
    codes.push_back(list.substr(at, list.find(' ', at) - at));
    at = end + 1;
  }
  return codes;
}

// What projinfo's WKT says: the method of the projection, and the number behind the first unit of the axes.
struct Wkt {
  std::string method;
  std::string axes;
  double unit = 0.0;
};
Wkt wkt_of(const std::string& code) {
  const std::string text = output_of("projinfo -q --single-line -o WKT2:2019 " + code + " 2>/dev/null");
  const auto quoted_behind = [&](const std::string& word, std::size_t from) {
    const std::size_t at = text.find(word, from);
    return at == std::string::npos ? std::string()
                                   : text.substr(at + word.size(), text.find('"', at + word.size()) - at - word.size());
  };
  Wkt wkt;
  wkt.method = quoted_behind("METHOD[\"", 0);
  const std::size_t axes = std::min(text.find(",CS["), text.size() - std::min<std::size_t>(text.size(), 4));
  wkt.axes = text.substr(axes + 4, text.find(',', axes + 4) - axes - 4);
  const std::size_t unit = text.find("UNIT[\"", axes);
  if (unit != std::string::npos) wkt.unit = std::strtod(text.c_str() + text.find(',', unit) + 1, nullptr);
  return wkt;
}

// For every n-th code of the dataset the answer is what another program says of it.
TEST(ReferenceSystem, AgreesWithProjinfo) {
  const std::map<std::string, std::size_t> steps = {{"geographic_2d", 40}, {"geographic_3d", 25}, {"projected", 90},
                                                    {"compound", 40},      {"vertical", 40},      {"geocentric", 30}};
  std::map<std::string, int> met;
  for (const auto& [kind, step] : steps) {
    const std::vector<std::string> codes = codes_listed(kind);
    ASSERT_GT(codes.size(), 200U) << "projinfo of Debian's proj-bin";
    for (std::size_t i = step / 2; i < codes.size(); i += step) {
      const Wkt wkt = wkt_of(codes[i]);
      const ReferenceSystem system = reference_system(codes[i]);
      const auto has = [&](const char* word) { return wkt.method.find(word) != std::string::npos; };
      const bool mercator = has("Mercator") && !has("Transverse") && !has("Oblique");
      const bool usable = kind != "vertical" && kind != "geocentric" && !mercator && wkt.axes != "spherical";
      EXPECT_EQ(system.units.has_value(), usable) << codes[i] << " " << wkt.method << ": " << system.is;
      met[usable ? wkt.axes : mercator ? "Mercator" : kind] += 1;
      if (!system.units) continue;
      const bool length = wkt.axes == "Cartesian";
      EXPECT_EQ(system.units->kind == PlanUnits::Kind::length, length) << codes[i];
      const double unit = length ? wkt.unit : wkt.unit * 57.295779513082323;
      EXPECT_NEAR(system.units->size, unit, 1e-9 * unit) << codes[i];
    }
  }
  EXPECT_GT(met["ellipsoidal"], 30);
  EXPECT_GT(met["Cartesian"], 80);
  EXPECT_GT(met["vertical"], 8);
  EXPECT_GT(met["geocentric"], 8);
}

}  // namespace
}  // namespace shatterpave::scene
