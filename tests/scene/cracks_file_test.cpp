// Cracks from a geometry file and from a drawing, and what is said of those that are none.
#include "scene/cracks_file.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace shatterpave::scene {
namespace {

namespace fs = std::filesystem;
using glass::CrackKind;

class CracksFiles : public support::FolderTest {
 protected:
  CracksFile read(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return cracks_of_file(folder_ / name, Place{"s.toml", 7, 3, "cracks_file"});
  }
  std::string refusal(const std::string& content) const {
    try {
      static_cast<void>(read("a.json", content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
};

std::string pane_with(const std::string& cracks) {
  return R"({"format": "shatterpave-geometry", "version": 1, "panes": [{"name": "w", "thickness_mm": 3.5,
    "outline_mm": [[0, 0], [300, 0], [300, 200], [0, 200]],
    "impacts": [{"at_mm": [150, 100], "radial_count": 4, "large_count": 2, "circular_count": 1}, {"at_mm": [20, 30]}],
    "cracks": [)" +
         cracks + "]}]}";
}

TEST_F(CracksFiles, GeometryIsReadAsItIsWritten) {
  const CracksFile file = read("a.json", pane_with(R"({"kind": "large", "points_mm": [[150, 100], [300, 120.5]]},
                                                      {"kind": "circular", "impact": 1, "points_mm": [[1, 2], [3, 4], [5, 6]]})"));
  ASSERT_EQ(file.panes.size(), 1U);
  const FilePane& pane = file.panes.front();
  EXPECT_EQ(pane.name, "w");
  EXPECT_EQ(pane.thickness_mm, 3.5);
  EXPECT_EQ(*pane.outline, (geometry::Polygon{{0, 0}, {300, 0}, {300, 200}, {0, 200}}));
  ASSERT_EQ(pane.impacts.size(), 2U);
  EXPECT_EQ(pane.impacts[0].at_mm, (vec2{150, 100}));
  EXPECT_EQ(pane.impacts[0].radial_count, 4);
  EXPECT_EQ(pane.impacts[0].large_count, 2);
  EXPECT_EQ(pane.impacts[0].circular_count, 1);
  ASSERT_EQ(pane.cracks.size(), 2U);
  EXPECT_EQ(pane.cracks[0].line, (glass::DrawnCrack{CrackKind::large, 0, true, {{150, 100}, {300, 120.5}}}));
  EXPECT_EQ(pane.cracks[1].line, (glass::DrawnCrack{CrackKind::circular, 1, true, {{1, 2}, {3, 4}, {5, 6}}}));
  EXPECT_TRUE(pane.cracks[0].has_kind && pane.cracks[1].has_kind);
}

TEST_F(CracksFiles, RefusesWhatIsNoCrack) {
  const auto says = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  EXPECT_TRUE(says(refusal(pane_with(R"({"kind": "dent", "points_mm": [[1, 2], [3, 4]]})")),
                   "panes[0].cracks[0].kind: expected large, radial, circular, branch, dice, rung or chip, got \"dent\""));
  EXPECT_TRUE(says(refusal(pane_with(R"({"kind": "large", "points_mm": [[1, 2]]})")),
                   "cracks[0].points_mm: expected two points or more"));
  EXPECT_TRUE(says(refusal(pane_with(R"({"kind": "large", "impact": 2, "points_mm": [[1, 2], [3, 4]]})")),
                   "cracks[0].impact: expected a number from 0 to 1"));
  EXPECT_TRUE(says(refusal(pane_with("")), "cracks: expected one crack or more"));
  EXPECT_TRUE(says(refusal("{}"), "format: expected a text"));
}

// Lines are of the kind that their class names; y is up, from the lower left corner of the outline.
TEST_F(CracksFiles, DrawingsAreReadByTheirClasses) {
  std::string lines;
  for (const char* kind : {"large", "radial", "circular", "branch", "dice", "rung", "chip", "other"}) {
    lines += std::string("<path class=\"") + kind + "\" d=\"M20 30L50 60\"/>";
  }
  const CracksFile file = read(
      "a.SVG",
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="80mm" viewBox="0 0 100 80" fill="none" stroke="#000">
<rect class="outline" x="10" y="10" width="80" height="60"/>)" +
          lines + "</svg>");
  ASSERT_EQ(file.panes.size(), 1U);
  const FilePane& pane = file.panes.front();
  EXPECT_EQ(*pane.outline, (geometry::Polygon{{0, 0}, {80, 0}, {80, 60}, {0, 60}}));
  ASSERT_EQ(pane.cracks.size(), 8U);
  for (int i = 0; i < 8; ++i) {
    const FileCrack& crack = pane.cracks[static_cast<std::size_t>(i)];
    EXPECT_EQ(crack.has_kind, i < 7);
    if (crack.has_kind) {
      EXPECT_EQ(static_cast<int>(crack.line.kind), i);
    }
    EXPECT_EQ(crack.line.points_mm, (std::vector<vec2>{{10, 40}, {40, 10}}));
  }
}

}  // namespace
}  // namespace shatterpave::scene
