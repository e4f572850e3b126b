#include "export/json/geometry_json.h"

#include <gtest/gtest.h>

#include "export/svg/drawing_svg.h"

namespace shatterpave::exporting::json {
namespace {

Model tiny_model() {
  BrokenPane broken;
  broken.pane.name = "window";
  broken.pane.outline_mm = {{0, 0}, {300, 0}, {300, 300}, {0, 300}};
  broken.pane.thickness_mm = 2;
  broken.network.impacts = {{{150, 150}, 113, 11, 6}};
  using At = glass::CrackEnd::At;
  broken.network.cracks = {
      {0, 0, glass::CrackKind::large, {{150, 150}, {151, 150.125}, {300, 150.001}}, {At::impact, {}}, {At::edge, {}}},
      {1, 0, glass::CrackKind::circular, {{150, 180}, {-0.0, 1e-3}}, {At::ring, {}}, {At::crack, 0}},
      {2, 0, glass::CrackKind::radial, {{150, 150}, {140, 149}}, {At::impact, {}}, {At::enclosed, {}}},
  };
  PavedArea paved;
  paved.pavement.name = "path";
  paved.pavement.area = {{{0, 0}, {400, 0}, {400, 200}, {0, 200}}, {{{10, 10}, {10, 20}, {20, 20}}}};
  paved.layout.stones = {{0, paving::StoneKind::whole, {{4, 4}, {104, 4}, {104, 104}}, Angle::degrees(30)},
                         {1, paving::StoneKind::cut, {{112, 4}, {150.5, 4}, {112, 104}}, Angle::degrees(0)}};
  return {"tiny", "", "", 7, {broken}, {paved}};
}

TEST(GeometryJson, GoldenText) {
  const OutputFile file = json_file(tiny_model());
  EXPECT_EQ(file.name, "tiny.json");
  EXPECT_EQ(file.content,
            R"({"format":"shatterpave-geometry","version":1,"seed":7,
 "panes":[
  {"name":"window","outline_mm":[[0,0],[300,0],[300,300],[0,300]],"thickness_mm":2,
  "impacts":[
   {"at_mm":[150,150],"radial_count":113,"large_count":11,"circular_count":6}],
  "cracks":[
   {"id":0,"impact":0,"kind":"large","points_mm":[[150,150],[151,150.125],[300,150.001]],"start":{"at":"impact"},"end":{"at":"edge"}},
   {"id":1,"impact":0,"kind":"circular","points_mm":[[150,180],[0,0.001]],"start":{"at":"ring"},"end":{"at":"crack","crack":0}},
   {"id":2,"impact":0,"kind":"radial","points_mm":[[150,150],[140,149]],"start":{"at":"impact"},"end":{"at":"enclosed"}}]}],
 "pavements":[
  {"name":"path","outline_mm":[[0,0],[400,0],[400,200],[0,200]],"holes_mm":[[[10,10],[10,20],[20,20]]],
  "stones":[
   {"id":0,"part":"field","kind":"whole","outline_mm":[[4,4],[104,4],[104,104]],"angle_deg":30},
   {"id":1,"part":"field","kind":"cut","outline_mm":[[112,4],[150.5,4],[112,104]],"angle_deg":0}]}]}
)");
}

TEST(GeometryJson, NothingIsEmptyListsNotMissingKeys) {
  EXPECT_EQ(json_file({"none", "", "", 1, {}, {}}).content,
            "{\"format\":\"shatterpave-geometry\",\"version\":1,\"seed\":1,\n \"panes\":[],\n \"pavements\":[]}\n");
}

TEST(GeometryJson, CameraLightAndPlacesStandWhereTheSceneHasThem) {
  Model model = tiny_model();
  model.panes[0].network = {};
  model.pavements.clear();
  model.panes[0].pane.placement = {{1.0, -2.5, 0.0}, Angle::degrees(90.0)};
  model.camera = studio::Camera{};
  model.camera->focus_mm = 3000.0;
  model.camera->f_number = 4.0;
  model.camera->size_px = {1920, 1080};
  model.light = studio::Light{};
  model.light->environment = "/home/somebody/skies/sky.hdr";
  model.light->sun = studio::Sun{Angle::degrees(220.0), Angle::degrees(20.0), 1.5};
  model.light->exposure_ev = -1.0;
  EXPECT_EQ(json_file(model).content,
            R"({"format":"shatterpave-geometry","version":1,"seed":7,
 "camera":{"at_mm":[0,-3000,1600],"look_at_mm":[0,0,0],"field_of_view_deg":40,"focus_mm":3000,"f_number":4,"size_px":[1920,1080]},
 "light":{"environment":"sky.hdr","environment_turn_deg":0,"environment_gain":1,"sun_azimuth_deg":220,"sun_elevation_deg":20,"sun_gain":1.5,"exposure_ev":-1},
 "panes":[
  {"name":"window","outline_mm":[[0,0],[300,0],[300,300],[0,300]],"thickness_mm":2,"place_mm":[1,-2.5,0],"place_turn_deg":90,
  "impacts":[],
  "cracks":[]}],
 "pavements":[]}
)");
}

TEST(DrawingSvg, OneDrawingEachInMillimetresWithYDown) {
  const std::vector<OutputFile> files = svg::svg_files(tiny_model());
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "tiny-window.svg");
  EXPECT_EQ(files[1].name, "tiny-path.svg");
  EXPECT_NE(files[0].content.find(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"301mm\" height=\"301mm\" viewBox=\"-0.5 -300.5 301 301\">"),
            std::string::npos);
  EXPECT_NE(
      files[0].content.find("<polyline class=\"crack large\" id=\"crack-0\" points=\"150,-150 151,-150.125 300,-150.001\"/>"),
      std::string::npos);
  EXPECT_NE(files[1].content.find("d=\"M0,0 400,0 400,-200 0,-200ZM10,-10 10,-20 20,-20Z\""), std::string::npos);
  EXPECT_NE(files[1].content.find("<polygon class=\"stone field cut\" id=\"stone-1\" points=\"112,-4 150.5,-4 112,-104\"/>"),
            std::string::npos);
}

}  // namespace
}  // namespace shatterpave::exporting::json
