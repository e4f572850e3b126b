// A plan drawn carelessly gives the same stones as the same plan drawn with care, or is refused at its place.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "paving/laying.h"
#include "scene/plans/outline.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

using geometry::Polygon;
using geometry::Region;

// A terrace with slanting sides and two beds; its sides have points of the lattice on them, so that a point can be inserted
// exactly.
const std::vector<Polygon> clean_rings = {{{0, 0}, {2400, 400}, {2400, 1600}, {1400, 1200}, {1000, 2000}, {0, 1800}},
                                          {{400, 400}, {800, 400}, {800, 800}, {400, 800}},
                                          {{1600, 500}, {2000, 900}, {1800, 1100}, {1400, 700}}};

Region region_of_rings(const std::vector<Polygon>& rings) {
  std::vector<Ring> holes;
  for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back({rings[i], {}});
  return region_of({rings.front(), {}}, holes);
}

// One careless stroke.
enum class Stroke { repeat, on_side, spike, turn, rotate, close };

Polygon with_stroke(Polygon ring, Stroke stroke, std::size_t at, int part) {
  const std::size_t i = at % ring.size();
  if (stroke == Stroke::turn) std::ranges::reverse(ring);
  if (stroke == Stroke::rotate) std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i), ring.end());
  if (stroke == Stroke::close) ring.push_back(ring.front());
  Polygon result;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const vec2 p = ring[k];
    result.push_back(p);
    if (k != i) continue;
    if (stroke == Stroke::repeat) result.push_back(p);
    if (stroke == Stroke::on_side) result.push_back(p + (ring[(k + 1) % ring.size()] - p) * (part / 4.0));
    if (stroke != Stroke::spike) continue;
    result.push_back(p + vec2{90.0 * part, -70.0});  // out and back along one line
    result.push_back(p);
  }
  return result;
}

// On the lattice the region is the same to the byte, and so is all that follows from it.
RC_GTEST_PROP(DirtyPlan, GivesTheSameRegion, ()) {
  std::vector<Polygon> rings = clean_rings;
  const int count = *rc::gen::inRange(1, 12);
  for (int i = 0; i < count; ++i) {
    const auto stroke = static_cast<Stroke>(*rc::gen::inRange(0, 6));
    Polygon& ring = rings[*rc::gen::inRange<std::size_t>(0, rings.size())];
    ring = with_stroke(std::move(ring), stroke, *rc::gen::inRange<std::size_t>(0, 100), *rc::gen::inRange(1, 4));
    RC_CLASSIFY(stroke == Stroke::spike, "spike");
  }
  RC_ASSERT(region_of_rings(rings) == region_of_rings(clean_rings));
}

paving::Pavement pavement_on(Region area) {
  paving::Pavement pavement;
  pavement.name = "terrace";
  pavement.area = std::move(area);
  pavement.bonding.bond = paving::Bond::running;
  pavement.direction = paving::BoundaryDirection{};
  pavement.border.course = paving::BorderCourse::stretcher;
  return pavement;
}

TEST(DirtyPlan, GivesTheSameStones) {
  std::vector<Polygon> rings = clean_rings;
  for (const Stroke stroke : {Stroke::rotate, Stroke::turn, Stroke::repeat, Stroke::on_side, Stroke::spike, Stroke::close}) {
    for (Polygon& ring : rings) ring = with_stroke(std::move(ring), stroke, 2, 1);
  }
  const auto clean = paving::laid_stones(pavement_on(region_of_rings(clean_rings)), 7);
  const auto dirty = paving::laid_stones(pavement_on(region_of_rings(rings)), 7);
  ASSERT_GT(clean.stones.size(), 100U);
  EXPECT_TRUE(dirty == clean);
  // A point 1 mm off its side is another plan.
  rings = clean_rings;
  rings[0].insert(rings[0].begin() + 1, vec2{1200, 199});
  EXPECT_NE(region_of_rings(rings), region_of_rings(clean_rings));
}

// Scenes that take from plans in a folder of their own.
class PlanFiles : public support::FolderTest {
 protected:
  void SetUp() override {
    write("plan.svg",
          R"(<svg xmlns="http://www.w3.org/2000/svg" width="9000mm" height="9000mm" viewBox="0 0 9000 9000">
<path id="yard" class="paved" d="M0 0h4000v3000h-4000z"/>
<path id="twins" d="M5000 0h1000v1000h-1000z M7000 0h1000v1000h-1000z"/>
<g id="free"><circle class="tree" cx="1000" cy="1000" r="300"/><circle class="tree" cx="8500" cy="8500" r="300"/></g>
<path id="bow" d="M0 5000l900 900v-900l-900 900z"/>
<path id="walk" d="M0 1500C1000 500 3000 2500 4000 1500"/><line id="cut" x1="2000" x2="2000" y1="-500" y2="3500"/></svg>)");
    write("far.geojson",
          R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"a","properties":{},"geometry":{"type":"Polygon",)"
          R"("coordinates":[[[13.44,52.473],[13.4401,52.473],[13.4401,52.4731],[13.44,52.4731]]]}},{"type":"Feature","id":"b",)"
          R"("properties":{"class":"tree"},"geometry":{"type":"Point","coordinates":[13.44005,52.47305]}}]})");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  Scene scene(const std::string& lines) const { return scene_of_text(lines, folder_ / "s.toml"); }
  std::vector<paving::Pavement> pavements(const std::string& lines) const {
    return scene("[[pavement]]\nname = \"p\"\n" + lines).pavements;
  }
  // Without the folder's name.
  std::string error(const std::string& lines) const {
    try {
      pavements(lines);
    } catch (const InputError& found) {
      std::string message = found.what();
      const std::string folder = folder_.string() + "/";
      for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
        message.erase(at, folder.size());
      }
      return message;
    }
    return "no error";
  }
};

const std::string yard = "outline_file = \"plan.svg\"\noutline_feature = \"yard\"\n";

TEST_F(PlanFiles, GiveOutlineHolesAndGuides) {
  const auto found = pavements(yard + "holes_class = \"tree\"\ndirection = {kind = \"guides\", guides_feature = \"walk\"}\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].area.outline, (Polygon{{0, 6000}, {4000, 6000}, {4000, 9000}, {0, 9000}}));
  EXPECT_EQ(found[0].area.holes.size(), 1U);  // the other tree is elsewhere
  const auto& guides = std::get<paving::GuidesDirection>(found[0].direction).guides_mm;
  ASSERT_EQ(guides.size(), 1U);
  EXPECT_EQ(guides[0].front(), vec2(0, 7500));
  EXPECT_EQ(guides[0].back(), vec2(4000, 7500));
}

TEST_F(PlanFiles, SeveralAreasBecomeSeveralPavements) {
  const auto twins = pavements("outline_file = \"plan.svg\"\noutline_feature = \"twins\"\n");
  ASSERT_EQ(twins.size(), 2U);
  EXPECT_EQ(twins[0].name, "p");
  EXPECT_EQ(twins[1].name, "p");
  EXPECT_EQ(twins[1].area.outline[0], vec2(7000, 8000));
  const auto bow = pavements("outline_file = \"plan.svg\"\noutline_feature = \"bow\"\n");
  ASSERT_EQ(bow.size(), 2U);
  EXPECT_EQ(geometry::area(bow[0].area), 450.0 * 450.0);
  const auto halves = pavements(yard + "holes_feature = \"cut\"\nholes_width_mm = 200\n");
  ASSERT_EQ(halves.size(), 2U);
  EXPECT_EQ(geometry::area(halves[0].area), 1900.0 * 3000.0);
  const auto strip = pavements(
      "outline_file = \"plan.svg\"\noutline_feature = \"cut\"\noutline_width_mm = 200\n"
      "within_feature = \"yard\"\n");
  ASSERT_EQ(strip.size(), 1U);
  EXPECT_EQ(geometry::area(strip[0].area), 200.0 * 3000.0);
}

TEST_F(PlanFiles, ShareAFrame) {
  const std::string file = "outline_file = \"far.geojson\"\n";
  const auto holed = pavements(file + "outline_feature = \"a\"\nholes_class = \"tree\"\nholes_width_mm = 1000\n");
  ASSERT_EQ(holed[0].area.holes.size(), 1U);
  EXPECT_NEAR(geometry::bounding_box(holed[0].area.holes[0]).high.x, 500.0, 0.01);  // the tree is in the middle
  const Scene pinned = scene("[plan]\norigin = [13.44, 52.473]\n[[pavement]]\nname = \"p\"\n" + file + "outline_feature = 0\n");
  EXPECT_EQ(pinned.pavements[0].area.outline[0], vec2(0, 0));
  const Scene scaled = scene("plan.svg_scale = 100\n[[pavement]]\nname = \"p\"\nstone_mm = [900, 900]\n" + yard);
  EXPECT_EQ(geometry::area(scaled.pavements[0].area), 400'000.0 * 300'000.0);
}

TEST_F(PlanFiles, RefusalsNameThePlace) {
  EXPECT_EQ(error(yard + "outline_class = \"paved\"\n"),
            "s.toml:5:17: pavement[0].outline_class: expected outline_feature or outline_class, got both");
  EXPECT_EQ(error(yard + "holes_class = \"trees\"\n"),
            "s.toml:5:15: pavement[0].holes_class: expected a class that a closed shape of \"plan.svg\" has, got \"trees\", "
            "which none has");
  EXPECT_EQ(error(yard + "holes_feature = \"twins\"\n"),
            "s.toml:5:17: pavement[0].holes_feature: expected a hole in the area, got none that meets it");
  EXPECT_EQ(error(yard + "holes_feature = \"yard\"\n"),
            "s.toml:5:17: pavement[0].holes_feature: expected holes that leave something of the area, got none left");
  EXPECT_EQ(error(yard + "holes_width_mm = 9\n"),
            "s.toml:5:18: pavement[0].holes_width_mm: expected holes_feature, holes_class or holes_file, got none");
  EXPECT_EQ(error(yard + "within_feature = \"twins\"\n"),
            "s.toml:5:18: pavement[0].within_feature: expected areas that the outline lies in, got none that it meets");
  EXPECT_EQ(error(yard + "outline_units = \"metres\"\n"),
            "s.toml:5:17: pavement[0].outline_units: expected no such key for SVG, which has its own units, got it");
  EXPECT_EQ(error(yard + "holes_feature = []\n"),
            "s.toml:5:17: pavement[0].holes_feature: expected one or more ids or indices, got an empty list");
  EXPECT_EQ(error(yard + "holes_feature = [true]\n"),
            "s.toml:5:18: pavement[0].holes_feature[0]: expected an id in quotes or an index from 0, got true");
  EXPECT_EQ(error("size_mm = [900, 900]\nwithin_class = \"x\"\n"),
            "s.toml:4:16: pavement[0].within_class: expected outline_file beside it, got none");
  EXPECT_EQ(error("size_mm = [900, 900]\nholes_class = \"x\"\n"),
            "s.toml:1:1: pavement[0].holes_file: expected holes_file or an outline_file, got neither");
  EXPECT_EQ(error(yard + "direction = {kind = \"guides\", guides_feature = 7}\n"),
            "s.toml:5:48: pavement[0].direction.guides_feature: expected an index below 2, the number of the 2 lines of "
            "\"plan.svg\"; got 7");
  EXPECT_EQ(error("outline_file = \"far.geojson\"\noutline_feature = \"b\"\n"),
            "s.toml:4:19: pavement[0].outline_feature: expected the id or the index of one of the 1 polygons of "
            "\"far.geojson\": 0 (id \"a\"); got \"b\", the id of 0");
}

}  // namespace
}  // namespace shatterpave::scene
