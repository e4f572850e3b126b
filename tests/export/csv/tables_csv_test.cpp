#include "export/csv/tables_csv.h"

#include <gtest/gtest.h>

#include <string>

namespace shatterpave::exporting::csv {
namespace {

Model small_model() {
  Model model;
  model.name = "yard";
  BrokenPane& broken = model.panes.emplace_back();
  broken.pane.name = "window";
  broken.network.cracks.push_back({.id = 4,
                                   .impact = 1,
                                   .kind = glass::CrackKind::circular,
                                   .points_mm = {{1.5, 2.0}, {-0.0001, 3.25}},
                                   .start = {},
                                   .end = {}});
  PavedArea& paved = model.pavements.emplace_back();
  paved.pavement.name = "path";
  paved.pavement.area.outline = {{0, 0}, {110, 0}, {110, 60}, {0, 60}};
  paved.pavement.stone_mm = {100, 50};
  paved.pavement.joint_mm = 10;
  paved.pavement.bonding.bond = paving::Bond::stack;
  paved.layout.stones.push_back({7, paving::StoneKind::whole, {{5, 5}, {105, 5}, {105, 55}, {5, 55}}, Angle::degrees(0.0)});
  return model;
}

std::string content(const std::vector<OutputFile>& files, const std::string& name) {
  for (const OutputFile& file : files) {
    if (file.name == name) return file.content;
  }
  return "no file " + name;
}

TEST(TablesCsv, HoldStonesQuantitiesAndCracks) {
  const std::vector<OutputFile> files = csv_files(small_model());
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(content(files, "yard-stones.csv"),
            "pavement,id,part,kind,length_mm,width_mm,area_mm2,x_mm,y_mm,angle_deg,stock\n"
            "path,7,field,whole,100.000,50.000,5000.000,55.000,30.000,0.000000,0\n");
  EXPECT_EQ(content(files, "yard-quantities.csv"),
            "pavement,item,count,area_m2,length_m\n"
            "path,paved,,0.006600,\n"
            "path,field_whole,1,0.005000,\n"
            "path,field_cut,0,0.000000,\n"
            "path,field_to_order,1,0.005000,\n"
            "path,field_to_order_reusing_offcuts,1,0.005000,\n"
            "path,joints,,0.001600,0.000\n");
  EXPECT_EQ(content(files, "yard-cracks.csv"),
            "pane,crack,kind,impact,index,x_mm,y_mm\n"
            "window,4,circular,1,0,1.500,2.000\n"
            "window,4,circular,1,1,0.000,3.250\n");
}

TEST(TablesCsv, KerbsHaveALength) {
  Model model = small_model();
  PavedArea& kerb = model.pavements.front();
  kerb.pavement.stone_mm = {100, 50};
  kerb.layout.stones.front().part = paving::StonePart::kerb;
  EXPECT_NE(content(csv_files(model), "yard-quantities.csv").find("path,kerb,1,0.006600,0.110\n"), std::string::npos);
  EXPECT_NE(content(csv_files(model), "yard-stones.csv").find("path,7,kerb,whole,"), std::string::npos);
}

}  // namespace
}  // namespace shatterpave::exporting::csv
