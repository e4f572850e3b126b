// The keys of a module: a drawing beside the scene, and what is refused of it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "paving/pavement.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

using paving::Bond;

class ModuleSection : public support::FolderTest {
 protected:
  void SetUp() override {
    draw("tile.svg",
         R"(<rect class="stone" width="200" height="100"/><g id="dots"><rect x="200" width="100" height="100"/></g>)");
  }

  // Page units are centimetres where `viewBox` says 40 to 400 mm.
  void draw(const std::string& name, const std::string& shapes, const std::string& view_box = "0 0 400 300") const {
    std::ofstream(folder_ / name) << R"(<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="300mm" viewBox=")"
                                  << view_box << "\">\n"
                                  << shapes << "\n</svg>\n";
  }

  Scene read(const std::string& lines) const {
    return scene_of_text("[[pavement]]\nname = \"p\"\nsize_mm = [3000, 2000]\n" + lines, folder_ / "s.toml");
  }
  // Without the folder.
  std::string refusal(const std::string& lines) const {
    try {
      read(lines);
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string path = folder_.string() + "/";
      while (text.find(path) != std::string::npos) text.erase(text.find(path), path.size());
      return text;
    }
    return "none";
  }
  std::vector<std::string> told(const std::string& lines) const {
    std::vector<std::string> notes;
    for (const Note& note : read(lines).notes) notes.push_back(note.place.key + ": " + note.what);
    return notes;
  }
};

const std::string module_lines = "bond = \"module\"\nmodule_file = \"tile.svg\"\n";

TEST_F(ModuleSection, IsReadFromTheDrawing) {
  const paving::Pavement pavement = read(module_lines + "module_mm = [[300, 0], [50, 100]]\njoint_mm = 6\n").pavements.front();
  EXPECT_EQ(pavement.bonding.bond, Bond::drawn_module);
  const paving::Module& made = pavement.bonding.module_drawn;
  ASSERT_EQ(made.stones.size(), 2U);
  EXPECT_EQ(made.stones[0].cell_mm, (geometry::Polygon{{0, 0}, {200, 0}, {200, 100}, {0, 100}}));
  // Of the second shape, a repeat.
  EXPECT_EQ(made.stones[1].cell_mm, (geometry::Polygon{{-50, 100}, {50, 100}, {50, 200}, {-50, 200}}));
  EXPECT_NEAR(made.least_face_mm2, 94.0 * 94.0, 0.5);
  EXPECT_NEAR(pavement.stone_mm.x, 94.0, 0.003);
  EXPECT_EQ(cross(made.along_mm, made.across_mm), 30000.0);
}

TEST_F(ModuleSection, HasTheUnitsAndTheScaleOfItsOwnPage) {
  draw("centimetres.svg", R"(<rect width="20" height="10"/>)", "0 0 40 30");
  const std::string lines = "bond = \"module\"\nmodule_file = \"centimetres.svg\"\nmodule_mm = ";
  EXPECT_NEAR(read(lines + "[[200, 0], [0, 100]]\n").pavements.front().stone_mm.x, 192.0, 0.003);
  EXPECT_NEAR(read(lines + "[[500, 0], [0, 250]]\nmodule_scale = 2.5\n").pavements.front().stone_mm.x, 492.0, 0.003);
  // The scale of plans is another matter.
  const Scene beside = scene_of_text(
      "[plan]\nsvg_scale = 100\n[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n" + lines + "[[200, 0], [0, 100]]\n",
      folder_ / "s.toml");
  EXPECT_NEAR(beside.pavements.front().stone_mm.x, 192.0, 0.003);
  ASSERT_EQ(beside.notes.size(), 1U);
  EXPECT_EQ(beside.notes.front().what, "has no effect without a plan in SVG");
}

TEST_F(ModuleSection, TakesTheShapesThatAreAskedFor) {
  const std::string half = "module_mm = [[200, 0], [0, 100]]\n";
  EXPECT_EQ(read(module_lines + half + "module_class = \"stone\"\n").pavements.front().bonding.module_drawn.stones.size(), 1U);
  EXPECT_EQ(read(module_lines + half + "module_feature = 0\n").pavements.front().bonding.module_drawn.stones.size(), 1U);
  const std::string dot = "module_mm = [[100, 0], [0, 100]]\n";
  EXPECT_EQ(read(module_lines + dot + "module_feature = \"dots\"\n").pavements.front().bonding.module_drawn.stones.size(), 1U);
  EXPECT_EQ(refusal(module_lines + half + "module_class = \"stone\"\nmodule_feature = 0\n"),
            "s.toml:7:16: pavement[0].module_class: expected module_feature or module_class, got both");
}

TEST_F(ModuleSection, RefusesWhatIsNoModule) {
  const std::string vectors = "module_mm = [[300, 0], [0, 100]]\n";
  EXPECT_EQ(refusal("bond = \"module\"\n" + vectors),
            "s.toml:1:1: pavement[0].module_file: expected module_file = \"…\", a drawing of the stones, got none");
  EXPECT_EQ(refusal(module_lines),
            "s.toml:1:1: pavement[0].module_mm: expected module_mm = [[x, y], [x, y]], by which the stones repeat, got none");
  EXPECT_EQ(refusal(module_lines + "module_mm = [[300, 0]]\n"),
            "s.toml:6:13: pavement[0].module_mm: expected two vectors, [[x, y], [x, y]], got 1");
  EXPECT_NE(refusal("bond = \"module\"\nmodule_file = \"none.svg\"\n" + vectors).find("s.toml:5:15: pavement[0].module_file: "),
            std::string::npos);
  draw("empty.svg", R"(<path d="M0 0 L10 0" fill="none"/>)");
  EXPECT_EQ(refusal("bond = \"module\"\nmodule_file = \"empty.svg\"\n" + vectors).substr(0, 10), "empty.svg:");
  draw("lying.svg", "<rect width=\"200\" height=\"100\"/>\n<rect x=\"190\" width=\"110\" height=\"100\"/>");
  EXPECT_EQ(refusal("bond = \"module\"\nmodule_file = \"lying.svg\"\n" + vectors).substr(0, 56),
            "lying.svg:3:2: rect: expected shapes that do not overlap");
  draw("ring.svg", R"(<path fill-rule="evenodd" d="M0 0H300V100H0zM50 50H100V60H50z"/>)");
  EXPECT_EQ(refusal("bond = \"module\"\nmodule_file = \"ring.svg\"\n" + vectors),
            "ring.svg:2:2: path: expected a stone, which has no hole, got a shape with 1");
  std::ofstream(folder_ / "plan.geojson") << R"({"type":"Polygon","coordinates":[[[0,0],[0.001,0],[0.001,0.001],[0,0]]]})";
  EXPECT_EQ(refusal("bond = \"module\"\nmodule_file = \"plan.geojson\"\n" + vectors),
            "s.toml:5:15: pavement[0].module_file: expected an SVG file, got \"plan.geojson\"");
}

TEST_F(ModuleSection, TellsKeysWithoutEffect) {
  using Notes = std::vector<std::string>;
  const std::string vectors = "module_mm = [[300, 0], [0, 100]]\n";
  EXPECT_EQ(told(module_lines + vectors), Notes());
  EXPECT_EQ(told(module_lines + vectors + "stone_preset = \"brick\"\njoint_mm = 6\n"),
            (Notes{"pavement[0].stone_preset: has no effect beside joint_mm and bond = \"module\""}));
  EXPECT_EQ(told(module_lines + vectors + "stone_mm = [200, 100]\n"),
            (Notes{"pavement[0].stone_mm: has no effect beside bond = \"module\""}));
  EXPECT_EQ(told("bond = \"stack\"\nmodule_file = \"tile.svg\"\nmodule_scale = 1\n" + vectors).size(), 3U);
}

}  // namespace
}  // namespace shatterpave::scene
