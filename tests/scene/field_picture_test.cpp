#include "scene/field_picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "paving/bonds/bond.h"
#include "scene/direction_file.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

namespace fs = std::filesystem;

constexpr int columns = 4;
constexpr int rows = 3;
using Value = std::function<float(int column, int row)>;

class VectorPictures : public support::FolderTest {
 protected:
  // Rows from the top. The data window begins away from (0, 0), as that of a crop does.
  void write(const std::vector<std::pair<std::string, Value>>& channels) const {
    const Imath::Box2i window({5, -2}, {5 + columns - 1, -2 + rows - 1});
    Imf::Header header(window, window);
    Imf::FrameBuffer buffer;
    std::vector<std::vector<float>> values;
    for (const auto& [name, value] : channels) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      values.emplace_back();
      for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) values.back().push_back(value(column, row));
      }
    }
    for (std::size_t i = 0; i < channels.size(); ++i) {
      buffer.insert(channels[i].first,
                    Imf::Slice::Make(Imf::FLOAT, values[i].data(), window, sizeof(float), sizeof(float) * columns));
    }
    Imf::OutputFile output(file_.c_str(), header, 0);
    output.setFrameBuffer(buffer);
    output.writePixels(rows);
  }
  std::string content() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string refusal(const geometry::Box& area) const {
    try {
      static_cast<void>(direction_of_file(file_, Place{"s.toml", 7, 3, "grid_file"}, area));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  const fs::path file_ = folder_ / "field.exr";
};

constexpr geometry::Box whole{{1000.0, 2000.0}, {1400.0, 2300.0}};

Value same(float value) {
  return [value](int /*column*/, int /*row*/) { return value; };
}

TEST_F(VectorPictures, LieOverTheAreaWithTheirTopAtItsTop) {
  write({{"u", [](int column, int /*row*/) { return static_cast<float>(column); }},
         {"v", [](int /*column*/, int row) { return static_cast<float>(10 * row + 1); }}});
  const paving::GridDirection grid = direction_of_file(file_, Place{}, whole).grid;
  EXPECT_EQ(grid.columns, 4U);
  EXPECT_NEAR(grid.pitch_mm, 100.0, 1e-12);
  EXPECT_EQ(grid.origin_mm, (vec2{1050.0, 2050.0}));  // the middle of the lower left pixel
  ASSERT_EQ(grid.vectors.size(), 12U);
  EXPECT_EQ(grid.vectors.front(), (vec2{0.0, 21.0}));
  EXPECT_EQ(grid.vectors[3], (vec2{3.0, 21.0}));
  EXPECT_EQ(grid.vectors.back(), (vec2{3.0, 1.0}));
}

TEST_F(VectorPictures, AreFoundAmongTheChannels) {
  write({{"A", same(9.0F)}, {"R", same(1.0F)}, {"G", same(2.0F)}, {"B", same(3.0F)}});
  EXPECT_EQ(direction_of_file(file_, Place{}, whole).grid.vectors.front(), (vec2{1.0, 2.0}));
  write({{"R", same(1.0F)}, {"G", same(2.0F)}, {"x", same(4.0F)}, {"y", same(5.0F)}});
  EXPECT_EQ(direction_of_file(file_, Place{}, whole).grid.vectors.front(), (vec2{4.0, 5.0}));
}

TEST_F(VectorPictures, AreRefusedWithTheReason) {
  const auto says = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  write({{"R", same(1.0F)}, {"Z", same(2.0F)}});
  EXPECT_TRUE(says(refusal(whole), "expected channels u and v, or x and y, or X and Y, or R and G, got \"R, Z\""));
  const float endless = std::numeric_limits<float>::infinity();
  write({{"u", [&](int column, int row) { return column == 2 && row == 1 ? endless : 1.0F; }}, {"v", same(1.0F)}});
  EXPECT_TRUE(says(refusal(whole), "at pixel (2, 1)"));
  write({{"u", same(0.0F)}, {"v", same(0.0F)}});
  EXPECT_TRUE(says(refusal(whole), "a vector other than [0, 0]"));
  write({{"u", same(1.0F)}, {"v", same(1.0F)}});
  EXPECT_TRUE(says(refusal({{0.0, 0.0}, {400.0, 310.0}}), "pixels that are square"));
  EXPECT_TRUE(says(refusal({{0.0, 0.0}, {0.2, 0.15}}), "pixels of 0.1 mm or more"));
  EXPECT_EQ(refusal(whole), "none");
}

// Cut short or with other bytes: a picture, or a refusal.
TEST_F(VectorPictures, BrokenOnesAreRefused) {
  write({{"u", same(1.0F)}, {"v", same(1.0F)}});
  const std::string sound = content();
  const auto tried = [&](const std::string& changed) {
    std::ofstream(file_, std::ios::binary) << changed;
    return refusal(whole);
  };
  for (std::size_t size = 0; size < sound.size(); size += 3) {
    EXPECT_NE(tried(sound.substr(0, size)), "none") << size;
  }
  std::mt19937 draw(7);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string changed = sound;
    for (int k = 0; k < 3; ++k) changed[draw() % changed.size()] = static_cast<char>(draw() % 256);
    refused += tried(changed) != "none" ? 1 : 0;
  }
  EXPECT_GT(refused, 100);
  EXPECT_NE(tried("no picture").find("expected an OpenEXR picture"), std::string::npos);
}

TEST_F(VectorPictures, PackedStonesFollowThem) {
  write({{"u", same(1.0F)}, {"v", same(-1.0F)}});
  const std::string text =
      "[[pavement]]\nname = \"p\"\nsize_mm = [800, 600]\nstone_mm = [200, 100]\n[pavement.direction]\nkind = \"grid\"\n"
      "grid_file = \"field.exr\"\n";
  const std::string scene_file = (folder_ / "s.toml").string();
  // The bounding box, unless told.
  const auto grid_of = [&](const std::string& more) {
    return std::get<paving::GridDirection>(scene_of_text(text + more, scene_file).pavements.front().direction);
  };
  EXPECT_NEAR(grid_of("").pitch_mm, 200.0, 1e-9);
  EXPECT_EQ(grid_of("grid_area_mm = [[-100, 0], [700, 600]]\n").origin_mm, (vec2{0.0, 100.0}));
  EXPECT_NEAR(paving::main_direction(scene_of_text(text, scene_file).pavements.front()).degrees(), -45.0, 1e-4);
  EXPECT_THROW(grid_of("grid_area_mm = [[0, 0], [0, 600]]\n"), InputError);
  std::ofstream(folder_ / "f.csv") << "x_mm,y_mm,u,v\n0,0,1,1\n1000,0,1,1\n0,1000,-2,-2\n1000,1000,0,0\n";
  std::string by_table = text + "grid_area_mm = [[0, 0], [800, 600]]\n";
  by_table.replace(by_table.find("field.exr"), 9, "f.csv");
  try {
    static_cast<void>(scene_of_text(by_table, scene_file));
    FAIL() << "expected a refusal";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().key, "pavement[0].direction.grid_area_mm");
  }
}

}  // namespace
}  // namespace shatterpave::scene
