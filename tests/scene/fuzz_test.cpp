// Any bytes become a Scene or an InputError of one line: never another exception, a crash or a hang. The cases are mutations of
// valid files, drawn by address, so that a failure can be repeated.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/random.h"
#include "scene/plans/plan_areas.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

class Draws {
 public:
  explicit Draws(Id element) : element_(element) {}
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform(11, {Stream::turn, element_, next_++}) * static_cast<double>(count));
  }

 private:
  Id element_;
  std::uint32_t next_ = 0;
};

// Pieces of text that are likely to cause trouble.
const std::vector<std::string> hostile = {"nan",
                                          "-inf",
                                          "1e999",
                                          "-0",
                                          "9223372036854775808",
                                          "1e-320",
                                          "[",
                                          "]",
                                          "{",
                                          "}",
                                          "\"",
                                          "'",
                                          "\"\"\"",
                                          "\\",
                                          "\n",
                                          "\r",
                                          "\t",
                                          std::string(1, '\0'),
                                          "\xff",
                                          "\xc3",
                                          "\xf0\x9f\x98\x80",
                                          "=",
                                          ".",
                                          ",",
                                          "#",
                                          "[[",
                                          "]]",
                                          "[[[",
                                          "null",
                                          "true",
                                          "<",
                                          ">",
                                          "&#0;",
                                          "/>",
                                          "0x",
                                          "1979-05-27",
                                          "a.b.c",
                                          "[[pane]]",
                                          "pane",
                                          "size_mm",
                                          "outline_mm",
                                          "1e6",
                                          "-1e6",
                                          "0.0000001",
                                          "Z",
                                          "A",
                                          "a1 1 0 01",
                                          "M",
                                          "C",
                                          "scale(0)",
                                          "rotate(1e300)",
                                          "%",
                                          "viewBox",
                                          "coordinates",
                                          "MultiPolygon"};

// Another digit in the place of one: such files mostly stay well-formed and reach what comes after parsing.
void change_digit(std::string& text, std::size_t from, char digit) {
  const std::size_t at = text.find_first_of("0123456789", from);
  if (at != std::string::npos) text[at] = digit;
}

std::string mutated(std::string text, Draws& draws) {
  const std::size_t changes = 1 + draws.below(3);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = draws.below(text.size());
    const std::size_t length = std::min(text.size() - at, 1 + draws.below(12));
    switch (draws.below(16)) {
      case 0:
        text[at] = static_cast<char>(draws.below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(draws.below(text.size()), length));
        break;
      case 3:
        text.insert(at, hostile[draws.below(hostile.size())]);
        break;
      case 4:
        text.replace(at, length, hostile[draws.below(hostile.size())]);
        break;
      case 5:
        text.resize(at);
        break;
      default:
        change_digit(text, at, static_cast<char>('0' + draws.below(10)));
        break;
    }
  }
  return text;
}

// How the cases ended; both ends must be met often, or the mutations test nothing.
struct Ends {
  int values = 0;
  int errors = 0;
};

template <typename Read>
Ends fuzzed(const std::vector<std::string>& seeds, const char* name, std::uint64_t rounds, const Read& read) {
  Ends ends;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Draws draws(Id(name).child(round));
    const std::string text = mutated(seeds[draws.below(seeds.size())], draws);
    try {
      read(text);
      ++ends.values;
    } catch (const InputError& error) {
      ++ends.errors;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << name << " round " << round << ": " << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << name << " round " << round << ": " << error.what() << "\n" << text;
    }
  }
  return ends;
}

const std::string pane_scene =
    "seed = 7\n[still]\nsetting = \"window_still\"\n[[pane]]\nname = \"window\"\nsize_mm = [300, 300]\nthickness_mm = "
    "2.0\npreset = "
    "\"agui1992-fig15a\"\n[[pane.impact]]\nat_mm = [150, 150]\nmean_radial_count = 105\nspeed_m_s = 6.26\n[pane.growth]\n"
    "spread = \"uniform\"\nlarge_speed_px = 40\nsector_angle_deg = 100\n[pane.shards]\ngap_mm = 0.1\nfallen = 0.5\n";
const std::string pavement_scene =
    "[[pavement]]\nname = \"path\"\noutline_mm = [[0, 0], [4000, 0], [4000, 1200], [0, 1200]]\nholes_mm = [[[500, 500], [700, "
    "500], "
    "[700, 700]]]\nstone_mm = [100, 100]\njoint_mm = 8\n[pavement.direction]\nkind = \"guides\"\nangle_deg = 0\ncentre_mm = "
    "[0, 0]\n"
    "guides_mm = [[[0, 0], [4000, 600]], [[0, 1200], [4000, 1200]]]\n[pavement.relief]\nhurst = 0.5\n";
const std::string polygon =
    R"({"type":"Polygon","coordinates":[[[13.44,52.473],[13.441,52.473],[13.441,52.474],[13.44,52.474],[13.44,52.473]],)"
    R"([[13.4404,52.4734],[13.4406,52.4734],[13.4406,52.4736]]]})";

// The areas of the only feature, with lines and points widened.
void first_areas(const Plan& plan) {
  const auto shapes =
      chosen_shapes(plan, {ShapeKind::area, ShapeKind::line, ShapeKind::point}, {}, ByDefault::the_only_feature);
  merged(regions_of(plan, shapes, frame_of(plan, shapes, std::nullopt, std::nullopt), 100.0));
}

TEST(Fuzz, ScenesOrInputErrors) {
  const Ends ends = fuzzed({pane_scene, pavement_scene, pane_scene + pavement_scene}, "scene", 6000,
                           [](const std::string& text) { scene_of_text(text, "s.toml"); });
  EXPECT_GT(ends.values, 300);
  EXPECT_GT(ends.errors, 1000);
}

TEST(Fuzz, GeoJsonRegionsOrInputErrors) {
  const std::string feature = R"({"type":"Feature","id":"way/1","properties":{},"geometry":)" + polygon + "}";
  // Reference systems, which take PROJ most of the time, are fuzzed by themselves below.
  const std::string parts = R"({"type":"MultiPolygon","coordinates":[[[[13.44,52.473],[13.441,52.473],[13.441,52.474]]],[]]})";
  const std::string records =
      "\x1E" + feature + "\n\x1E" + R"({"type":"Feature","properties":{"name":{"en":"a"}},"geometry":null})" + "\n";
  const Ends ends = fuzzed({polygon, R"({"type":"FeatureCollection","features":[)" + feature + "]}", parts, records}, "geojson",
                           6000, [](const std::string& text) { first_areas(plan_of_geojson(text, "a.geojson")); });
  EXPECT_GT(ends.values, 300);
  EXPECT_GT(ends.errors, 1000);
}

TEST(Fuzz, ReferenceSystemsOrInputErrors) {
  const std::vector<std::string> names = {
      "urn:ogc:def:crs:EPSG::25833",
      "http://www.opengis.net/def/crs/EPSG/0/4326",
      "EPSG:4326+5773",
      "WGS 84 / UTM zone 33N",
      "+proj=utm +zone=33 +datum=WGS84 +units=us-ft",
      R"(GEOGCS[\"x\",DATUM[\"x\",SPHEROID[\"x\",6378137,298.25]],PRIMEM[\"x\",0],UNIT[\"degree\",0.0174532925199433]])"};
  std::vector<std::string> seeds;
  seeds.reserve(names.size());
  for (const std::string& name : names) {
    seeds.push_back(R"({"type":"Polygon","crs":{"properties":{"name":")" + name +
                    R"("}},"coordinates":[[[1,1],[1.001,1],[1.001,1.001]]]})");
  }
  const Ends ends = fuzzed(seeds, "crs", 600, [](const std::string& text) { first_areas(plan_of_geojson(text, "a.geojson")); });
  EXPECT_GT(ends.values, 50);
  EXPECT_GT(ends.errors, 100);
}

TEST(Fuzz, ScenesWithPlansOrInputErrors) {
  const support::TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  const auto feature = [](const std::string& id, const std::string& geometry) {
    return R"({"type":"Feature","id":")" + id + R"(","properties":{"class":"a"},"geometry":)" + geometry + "}";
  };
  const std::string seed =
      R"({"type":"FeatureCollection","features":[)" + feature("p", polygon) + "," +
      feature("q", R"({"type":"LineString","coordinates":[[13.44,52.473],[13.441,52.474]]})") + "," +
      feature("r", R"({"type":"Polygon","coordinates":[[[13.45,52.473],[13.451,52.474],[13.451,52.473],[13.45,52.474]]]})") +
      "]}";
  const Ends ends = fuzzed({seed}, "plans", 2000, [&](const std::string& text) {
    std::ofstream(folder / "a.geojson", std::ios::binary) << text;
    scene_of_text(
        "[[pavement]]\nname = \"p\"\nstone_mm = [900, 900]\noutline_file = \"a.geojson\"\noutline_class = \"a\"\n"
        "direction = {kind = \"guides\", guides_class = \"a\"}\n",
        folder / "s.toml");
  });
  EXPECT_GT(ends.values, 50);  // most changes of a digit move a corner by kilometres
  EXPECT_GT(ends.errors, 300);
}

TEST(Fuzz, SvgRegionsOrInputErrors) {
  const std::string open = R"x(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 2000 1000">)x";
  const std::vector<std::string> seeds = {
      open +
          R"x(<g transform="translate(100 100) scale(0.5)"><path d="M0 0h1000c300 0 300 500 0 500s-200 300-500 300q-200 0-300-100t-200-100z)x"
          R"x(M200 200v100h100v-100z"/></g></svg>)x",
      open + R"x(<path fill-rule="evenodd" d="M 500 500 a 200 100 30 1 0 300 100 l 0 400 L 100 100 z"/></svg>)x",
      open + R"x(<rect x="15" y="10" width="40mm" height="30" rx="5"/></svg>)x",
      open + R"x(<ellipse cx="500" cy="500" rx="300" ry="200" transform="rotate(30 500 500) skewX(10)"/></svg>)x",
      open + R"x(<polygon points="0,0 100,0 100,50 20 70"/></svg>)x"};
  const Ends ends = fuzzed(seeds, "svg", 6000, [](const std::string& text) { first_areas(plan_of_svg(text, "a.svg")); });
  EXPECT_GT(ends.values, 300);
  EXPECT_GT(ends.errors, 1000);
}

TEST(Fuzz, ScenesWithModulesOrInputErrors) {
  const support::TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  const std::string open = R"x(<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="300mm" viewBox="0 0 400 300">)x";
  const std::vector<std::string> seeds = {
      open + R"x(<rect width="200" height="100"/><rect x="200" width="100" height="100"/></svg>)x",
      open + R"x(<path d="M0 0h300c20 30 -20 60 0 100h-300c-20 -40 20 -70 0 -100z"/></svg>)x",
      open + R"x(<polygon points="0,0 295,0 295,95 0,95"/></svg>)x"};
  const Ends ends = fuzzed(seeds, "modules", 3000, [&](const std::string& text) {
    std::ofstream(folder / "tile.svg", std::ios::binary) << text;
    scene_of_text(
        "[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\nbond = \"module\"\nmodule_file = \"tile.svg\"\n"
        "module_mm = [[300, 0], [0, 100]]\n",
        folder / "s.toml");
  });
  EXPECT_GT(ends.values, 300);
  EXPECT_GT(ends.errors, 1000);
}

TEST(Fuzz, OverridesOrInputErrors) {
  const std::vector<std::string> seeds = {"pane[0].size_mm[1]=300", "pavement.path.joint_mm=4", "seed=7",
                                          "pane[0].impact[0].at_mm=[20, 30]"};
  const Ends ends = fuzzed(seeds, "override", 6000, [](const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw InputError("no '='");
    // The command line shows control characters in a message as they were given.
    const Override change{"--set", text.substr(0, equals), text.substr(equals + 1)};
    scene_of_text(pane_scene + pavement_scene, "s.toml", {change});
  });
  EXPECT_GT(ends.values, 300);
  EXPECT_GT(ends.errors, 1000);
}

}  // namespace
}  // namespace shatterpave::scene
