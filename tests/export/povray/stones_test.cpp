#include "export/povray/stones.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/embedded.h"
#include "core/parallel.h"
#include "export/povray/stone_text.h"
#include "export/shapes/tones.h"
#include "paving/catalogue/finishes.h"
#include "paving/surface/stone_surface.h"
#include "relief/raster.h"
#include "support/temporary_folder.h"

namespace shatterpave::exporting::povray {
namespace {

namespace fs = std::filesystem;

// `columns` by `rows` stones of 100 mm in a running bond; the first stone of every second row has five corners.
PavedArea hand_laid(int columns, int rows, double joint_mm = 8.0) {
  PavedArea paved;
  paved.pavement.name = "yard";
  paved.pavement.joint_mm = joint_mm;
  const double pitch = 108.0;
  paved.pavement.area.outline = {{0, 0}, {columns * pitch, 0}, {columns * pitch, rows * pitch}, {0, rows * pitch}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double half = 0.5 * joint_mm;
      const double left = column * pitch + half;
      const double right = (column + 1) * pitch - half;
      const double low = row * pitch + half;
      const double high = (row + 1) * pitch - half;
      paving::Stone stone;
      stone.id = static_cast<int>(paved.layout.stones.size());
      stone.outline_mm = {{left, low}, {right, low}, {right, high}, {left, high}};
      if (column == 0 && row % 2 == 1) {
        stone.kind = paving::StoneKind::cut;
        stone.outline_mm = {{left, low}, {right, low}, {right, high}, {left + 40, high}, {left, high - 40}};
      }
      paved.layout.stones.push_back(stone);
    }
  }
  return paved;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Stones, IncludeAndHeightImageAreNamedAfterThePavement) {
  const auto files = pavement_files(hand_laid(3, 2), "yard", 7);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "yard.inc");
  EXPECT_EQ(files[1].name, "yard_relief.png");
  // Five stones are one patch; one of five corners is a ring of 15 and a crown of 5.
  EXPECT_EQ(count(files[0].content, "bicubic_patch{"), 5U + 20U);
}

TEST(Stones, WithoutReliefThereIsNoImage) {
  PavedArea paved = hand_laid(1, 1);
  paved.pavement.relief.rms_mm = 0.0;
  const auto files = pavement_files(paved, "yard", 7);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].content.find(".png"), std::string::npos);
}

TEST(Stones, OneStoneIsThisText) {
  PavedArea paved = hand_laid(1, 1);
  paved.pavement.surface.height_spread = 0.0;
  paved.pavement.surface.inset_spread = 0.0;
  const std::string text = pavement_files(paved, "yard", 7)[0].content;
  const std::size_t begin = text.find("#local K");
  const std::size_t end = text.find("#declare yard_Pavement");
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  // A square of 100 mm within joints of 8: outer control points at height 0, D = 10 mm; the inner four tilt about 18 mm.
  // The texture coordinates span 100 of 512 mm.
  EXPECT_EQ(text.substr(begin, end - begin), R"(#local K = yard_Steps;
#declare yard_Stones =
object {
object {
bicubic_patch{type 0 flatness 0 u_steps K v_steps K uv_vectors<0.69189,-0.00734><0.69189,0.18797><0.8872,0.18797><0.8872,-0.00734><4,0,4><4,0,14><4,0,94><4,0,104><14,0,4><14,17.624,14><14,18.677,94><14,0,104><94,0,4><94,17.323,14><94,18.376,94><94,0,104><104,0,4><104,0,14><104,0,94><104,0,104>}
yard_Stone_Texture(0.6041666666666666) }
}

#declare yard_Bed =
prism {
   linear_sweep linear_spline -50, yard_Bed_Level, 5,
   <0,0>, <108,0>, <108,108>, <0,108>, <0,0>
   yard_Bed_Texture()
}

)");
}

TEST(Stones, HeaderNamesAllThatIsDeclared) {
  const std::string text = pavement_files(hand_laid(2, 2), "yard", 7)[0].content;
  const std::string header = text.substr(0, text.find("#ifndef"));
  for (const char* name : {"Pavement", "Stones", "Bed", "Bed_Level", "Top", "Stone_Size", "Min", "Max"}) {
    EXPECT_NE(header.find("yard_" + std::string(name)), std::string::npos) << name;
    EXPECT_EQ(count(text, "#declare yard_" + std::string(name) + " ="), 1U) << name;
  }
  EXPECT_EQ(count(text, "#ifndef(yard_Inc_Temp)"), 1U);
  EXPECT_EQ(count(text, "#version yard_Inc_Temp;"), 1U);
  for (const char* word : {"camera", "light_source", "global_settings"}) EXPECT_EQ(count(text, word), 0U) << word;
}

TEST(Stones, SameBytesForAnyNumberOfThreads) {
  const PavedArea paved = hand_laid(40, 20);
  std::vector<OutputFile> one;
  {
    const ThreadLimit limit(1);
    one = pavement_files(paved, "yard", 7);
  }
  const ThreadLimit limit(7);
  const auto many = pavement_files(paved, "yard", 7);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].content, many[i].content);
}

TEST(Stones, AnotherStoneChangesNoOther) {
  const auto patches = [](const PavedArea& paved) {
    std::vector<std::string> lines;
    std::istringstream text(pavement_files(paved, "yard", 7)[0].content);
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("bicubic_patch")) lines.push_back(line);
    }
    std::ranges::sort(lines);
    return lines;
  };
  PavedArea paved = hand_laid(4, 4);
  const auto all = patches(paved);
  paved.layout.stones.pop_back();
  const auto fewer = patches(paved);
  EXPECT_EQ(fewer.size() + 1, all.size());
  EXPECT_TRUE(std::ranges::includes(all, fewer));
}

TEST(Stones, FallAndLevelAreOneMatrixOnAll) {
  PavedArea paved = hand_laid(2, 2);
  paved.pavement.ground.fall_percent = 2.0;
  paved.pavement.ground.fall_direction = Angle::degrees(180.0);
  paved.pavement.ground.level_mm = 30.0;
  const std::string text = pavement_files(paved, "yard", 7)[0].content;
  // Downhill towards −x: a rise of 0.02 mm for each along x. The matrix stands on the stones and on the bed.
  EXPECT_EQ(count(text, "   matrix <1, 0.02, 0, 0, 1, 0, 0, -"), 2U);
  // 216 mm along x, so the highest is 4.32 higher; 30 and the height of stones above it.
  EXPECT_NE(text.find("#declare yard_Max = <216,46.976,216>;"), std::string::npos)
      << text.substr(text.find("#declare yard_Max"), 60);
}

TEST(Stones, WaterStandsOnlyWhereItIsVeryWet) {
  PavedArea paved = hand_laid(4, 4);
  paved.pavement.look.wetness = 0.5;
  EXPECT_EQ(count(pavement_files(paved, "yard", 7)[0].content, "yard_Water"), 0U);
  paved.pavement.look.wetness = 1.0;
  const std::string text = pavement_files(paved, "yard", 7)[0].content;
  EXPECT_EQ(count(text, "#declare yard_Water ="), 1U);
  EXPECT_EQ(count(text, "   object { yard_Water }"), 1U);
}

// `text` from the last `#declare yard_Stones` to the bed, by words.
TEST(Stones, FartherStonesAreCoarser) {
  PavedArea paved = hand_laid(120, 1);
  paved.pavement.detail = paving::Detail{{0.0, 50.0}, 150.0, 5.0};
  const std::string text = pavement_files(paved, "yard", 7)[0].content;
  // Stones of 100 mm at every 108: one within 150 mm, then to 12, 40 and 80 sizes; the first stone of the row has four corners.
  EXPECT_EQ(count(text, "normal_vectors"), 1U);
  EXPECT_EQ(count(text, "bicubic_patch{type 1 flatness 0 u_steps 4"), 10U);
  EXPECT_EQ(count(text, "bicubic_patch{type 0 flatness 0 u_steps 3"), 26U);
  EXPECT_EQ(count(text, "bicubic_patch{type 0 flatness 0 u_steps 2"), 37U);
  EXPECT_EQ(count(text, "bicubic_patch"), 73U);
  // The rest are prisms of 9 vertices and 12 triangles, in one mesh for each tone.
  EXPECT_LE(count(text, "mesh2"), 1U + shapes::stone_tones);
}

// ---- rendered

class RenderStones : public support::FolderTest {
 protected:
  RenderStones() {
    for (const EmbeddedFile& file : embedded_files()) std::ofstream(folder_ / file.name) << file.text;
  }

  // The picture of a pavement seen from above in slanting light. Fails the test on any status but 0 and on any warning.
  relief::Raster picture(const PavedArea& paved, const std::string& placed = "object { yard_Pavement }") {
    for (const OutputFile& file : pavement_files(paved, "yard", 7)) {
      std::ofstream(folder_ / file.name, std::ios::binary) << file.content;
    }
    std::ofstream(folder_ / "scene.pov") << R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "yard.inc"
camera { orthographic location <216, 500, 215.9> look_at <216, 0, 216> right x * 432 up y * 432 }
light_source { <-3, 2, 1> * 100000 rgb 2 parallel point_at 0 }
light_source { <1, 9, -2> * 100000 rgb 0.3 parallel point_at 0 }
)" << placed << '\n';
    const std::string command =
        "cd '" + folder_.string() + "' && povray +Iscene.pov +Oscene.exr +FE +W160 +H160 -A -D +WT1 >log.txt 2>&1";
    const int status = std::system(command.c_str());
    std::ostringstream log;
    log << std::ifstream(folder_ / "log.txt").rdbuf();
    const std::string said = log.str();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << said;
    EXPECT_EQ(said.find("Warning:"), std::string::npos) << said;
    return relief::read_raster((folder_ / "scene.exr").string());
  }
};

struct Statistics {
  double mean = 0.0;
  double deviation = 0.0;
  double gradient = 0.0;  // root mean square of differences of pixels side by side
};

Statistics statistics(const relief::Raster& raster) {
  const auto green = [&](std::size_t x, std::size_t y) {
    return static_cast<double>(raster.values[(y * raster.width + x) * raster.channels + 1]);
  };
  double sum = 0.0;
  double squares = 0.0;
  double differences = 0.0;
  for (std::size_t y = 0; y < raster.height; ++y) {
    for (std::size_t x = 0; x + 1 < raster.width; ++x) {
      sum += green(x, y);
      squares += green(x, y) * green(x, y);
      differences += (green(x + 1, y) - green(x, y)) * (green(x + 1, y) - green(x, y));
    }
  }
  const auto n = static_cast<double>(raster.height * (raster.width - 1));
  return {sum / n, std::sqrt(squares / n - sum / n * sum / n), std::sqrt(differences / n)};
}

TEST_F(RenderStones, RendersWithoutAWarning) {
  const Statistics all = statistics(picture(hand_laid(4, 4)));
  EXPECT_GT(all.mean, 0.02);
  EXPECT_GT(all.deviation, 0.3 * all.mean);
}

TEST_F(RenderStones, RendersEveryMaterialFinishAndFillingWithoutAWarning) {
  using paving::Material;
  int number = 0;
  for (const Material material :
       {Material::setts, Material::granite, Material::basalt, Material::sandstone, Material::limestone, Material::brick}) {
    PavedArea paved = hand_laid(4, 4);
    paved.pavement.look = {
        material, number % 2 == 0 ? paving::JointFill::sand : paving::JointFill::mortar, 0.1 * number, 0.2 * number, {}};
    const paving::FinishPreset& preset = paving::finish_presets.at(static_cast<std::size_t>(number % 4));
    paved.pavement.body = preset.body;
    paved.pavement.body.wear_mm = number % 3;
    paved.pavement.relief = preset.relief;
    paved.pavement.ground.settlement_mm = 4.0 * (number % 2);
    if (number % 2 == 1) paved.pavement.detail = paving::Detail{{216.0, 0.0}, 150.0, 4.0};
    const Statistics all = statistics(picture(paved));
    EXPECT_GT(all.mean, 0.01) << number;
    EXPECT_GT(all.deviation, 0.1 * all.mean) << number;
    ++number;
  }
}

TEST_F(RenderStones, RendersOneStoneAndNoneWithoutAWarning) {
  picture(hand_laid(1, 1));
  PavedArea empty = hand_laid(1, 1);
  empty.layout.stones.clear();
  picture(empty);
}

TEST_F(RenderStones, ReliefShows) {
  PavedArea paved = hand_laid(4, 4);
  const Statistics with = statistics(picture(paved));
  paved.pavement.relief.rms_mm = 0.0;
  const Statistics without = statistics(picture(paved));
  EXPECT_GT(with.gradient, 1.2 * without.gradient);
}

TEST_F(RenderStones, WiderJointsAreDarker) {
  const Statistics narrow = statistics(picture(hand_laid(4, 4, 8.0)));
  const Statistics wide = statistics(picture(hand_laid(4, 4, 16.0)));
  EXPECT_LT(wide.mean, 0.97 * narrow.mean);
}

TEST_F(RenderStones, CanBePlaced) {
  // Lifted out of sight of nothing: an orthographic picture of the pavement two metres up is the same.
  const relief::Raster here = picture(hand_laid(4, 4));
  const relief::Raster lifted = picture(hand_laid(4, 4), "object { yard_Pavement translate -200 * y }");
  EXPECT_NEAR(statistics(lifted).mean / statistics(here).mean, 1.0, 0.02);
  EXPECT_NEAR(statistics(lifted).gradient / statistics(here).gradient, 1.0, 0.05);
}

}  // namespace
}  // namespace shatterpave::exporting::povray
