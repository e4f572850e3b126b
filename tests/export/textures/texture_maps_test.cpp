#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/parallel.h"
#include "export/textures/texture_scenes.h"
#include "export/textures/textures.h"
#include "pipeline/write.h"
#include "relief/raster.h"
#include "support/temporary_folder.h"

namespace shatterpave::exporting::textures {
namespace {

namespace fs = std::filesystem;

const PixelGrid small_grid{{0.0, 0.0}, {4.0, 4.0}, 128, 128};

Drawn small_yard(double joint_mm = 8.0) {
  paving::Pavement pavement = square_pavement(512.0);
  pavement.joint_mm = joint_mm;
  auto stones = paving::laid_stones(pavement, 7).stones;
  return Drawn(std::move(pavement), std::move(stones), small_grid, 2, false,
               occlusion_reach(square_pavement(512.0), small_grid));
}

// Mean angle, in radians, between the normals of the map and those that follow from its heights, y up in the picture times
// `up`.
double angle_to_height_map(const Drawn& drawn, float up) {
  const std::vector<float> heights = drawn.values(Map::height);
  const std::vector<float> normals = drawn.values(Map::normal);
  const auto range = static_cast<float>(drawn.maps.height_range().range_mm);
  const std::size_t width = drawn.map.grid.width;
  double sum = 0.0;
  for (std::size_t row = 1; row + 1 < drawn.map.grid.height; ++row) {
    for (std::size_t column = 1; column + 1 < width; ++column) {
      const auto height = [&](std::size_t x, std::size_t y) { return static_cast<double>(heights[y * width + x] * range); };
      const vec3 expected = glm::normalize(vec3{(height(column - 1, row) - height(column + 1, row)) / 8.0,
                                                (height(column, row + 1) - height(column, row - 1)) / 8.0, 1.0});
      const float* n = &normals[3 * (row * width + column)];
      const vec3 found{2.0 * static_cast<double>(n[0]) - 1.0, static_cast<double>(up * (2.0F * n[1] - 1.0F)),
                       2.0 * static_cast<double>(n[2]) - 1.0};
      EXPECT_NEAR(glm::length(found), 1.0, 1e-5);
      sum += glm::length(found - expected);
    }
  }
  return sum / static_cast<double>((width - 2) * (drawn.map.grid.height - 2));
}

TEST(TextureMaps, NormalsAreTheSlopesOfTheHeightMapWithGreenUp) {
  const Drawn drawn = small_yard();
  EXPECT_LT(angle_to_height_map(drawn, 1.0F), 1e-4);
  EXPECT_GT(angle_to_height_map(drawn, -1.0F), 0.1);  // the twin: DirectX
}

TEST(TextureMaps, MapsOnRequestAreMadeOfTheOthers) {
  const Drawn drawn = small_yard();
  const std::vector<float> up = drawn.values(Map::normal);
  const std::vector<float> down = drawn.values(Map::normal_directx);
  const std::vector<float> packed = drawn.values(Map::occlusion_roughness_metal);
  const std::vector<float> occlusion = drawn.values(Map::ambient_occlusion);
  const std::vector<float> roughness = drawn.values(Map::roughness);
  ASSERT_EQ(packed.size(), 3 * occlusion.size());
  float lowest = 1.0F;
  for (std::size_t i = 0; i < occlusion.size(); ++i) {
    EXPECT_EQ(down[3 * i], up[3 * i]);
    EXPECT_NEAR(down[3 * i + 1] + up[3 * i + 1], 1.0F, 1e-6F);
    EXPECT_EQ(down[3 * i + 2], up[3 * i + 2]);
    EXPECT_EQ(packed[3 * i], occlusion[i]);
    EXPECT_EQ(packed[3 * i + 1], roughness[i]);
    EXPECT_EQ(packed[3 * i + 2], 0.0F);
    lowest = std::min(lowest, down[3 * i + 1]);
  }
  EXPECT_LT(lowest, 0.4F);
}

TEST(TextureMaps, StoneIdsAreColoursOfTheirOwnAndBlackIsTheJoint) {
  std::map<std::uint32_t, int> seen;
  for (std::uint32_t id = 0; id < 100'000; ++id) ++seen[id_colour(id)];
  EXPECT_EQ(seen.size(), 100'000U);
  EXPECT_EQ(seen.count(0), 0U);
  const Drawn drawn = small_yard();
  const std::vector<float> ids = drawn.values(Map::stone_id);
  std::vector<float> plain(drawn.map.grid.width);
  std::size_t joints = 0;
  for (std::size_t row = 0; row < drawn.map.grid.height; ++row) {
    drawn.maps.id_row(row, plain);
    for (std::size_t column = 0; column < plain.size(); ++column) {
      std::uint32_t colour = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        colour = colour << 8U | static_cast<std::uint32_t>(std::lround(255.0F * ids[3 * (row * plain.size() + column) + c]));
      }
      if (plain[column] == 0.0F) {
        ++joints;
        EXPECT_EQ(colour, 0U);
      } else {
        EXPECT_EQ(colour, id_colour(static_cast<std::uint32_t>(plain[column]) - 1));
      }
    }
  }
  // Joints of 8 mm, and what the filling hides of the stones' edges.
  EXPECT_NEAR(static_cast<double>(joints) / (128.0 * 128.0), 1.0 - 98.0 * 98.0 / (108.0 * 108.0), 0.03);
}

// A map of two walls of height 1 either side of a trench, `width` pixels of 1 mm wide.
SurfaceMap trench(double depth_mm, std::size_t width) {
  SurfaceMap map;
  map.grid = {{0.0, 0.0}, {1.0, 1.0}, 128, 4};
  map.halo = 89;
  const std::size_t length = map.row_length();
  for (std::size_t row = 0; row < map.rows(); ++row) {
    for (std::size_t column = 0; column < length; ++column) {
      const std::size_t from_middle = column > length / 2 ? column - length / 2 : length / 2 - column;
      map.height_mm.push_back(static_cast<float>(2 * from_middle < width ? 0.0 : depth_mm));
    }
  }
  map.stone.assign(map.height_mm.size(), 0);
  map.cover.assign(map.height_mm.size(), 0);
  return map;
}

// Of the middle of the floor. Over all directions the mean of cos² of the horizon of an endless trench is (w/2) / √((w/2)² +
// d²).
double open_in_trench(double depth_mm, std::size_t width) {
  const SurfaceMap map = trench(depth_mm, width);
  std::vector<float> open(map.grid.width);
  occlusion_row(map, 2, open);
  return static_cast<double>(open[map.row_length() / 2 - map.halo]);
}

TEST(Occlusion, OfATrenchIsThatOfTheFormula) {
  // 2 · 21 − 1 pixels, so that the walls stand at 21, one of the distances looked at. Eight directions, on
  // pixels, stand for all.
  for (const double depth_mm : {10.0, 20.0, 40.0}) {
    const double half = 21.0;
    const double expected = half / std::sqrt(half * half + depth_mm * depth_mm);
    EXPECT_NEAR(open_in_trench(depth_mm, 42), expected, 0.055) << depth_mm;
    EXPECT_GT(std::abs(open_in_trench(1.6 * depth_mm, 42) - expected), 0.055) << depth_mm;
  }
}

TEST(Occlusion, LevelGroundIsOpen) { EXPECT_EQ(open_in_trench(0.0, 42), 1.0); }

struct Statistics {
  double mean = 0.0;
  double deviation = 0.0;
};
Statistics statistics(const std::vector<float>& values) {
  double sum = 0.0;
  double squares = 0.0;
  for (const float value : values) {
    sum += static_cast<double>(value);
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  const double mean = sum / static_cast<double>(values.size());
  return {mean, std::sqrt(squares / static_cast<double>(values.size()) - mean * mean)};
}

using Row = std::map<Map, Statistics>;

bool agree(const Row& golden, const Drawn& drawn) {
  return std::ranges::all_of(golden, [&](const auto& one) {
    const Statistics found = statistics(drawn.values(one.first));
    return std::abs(found.mean - one.second.mean) < 0.001 && std::abs(found.deviation - one.second.deviation) < 0.001;
  });
}

// What the small yard had when its maps were last looked at. Ids, which are no measure, are left out.
const Row golden = {{Map::base_color, {0.1926, 0.0702}},
                    {Map::roughness, {0.7019, 0.1383}},
                    {Map::normal, {0.6618, 0.2391}},
                    {Map::height, {0.4202, 0.2482}},
                    {Map::ambient_occlusion, {0.9799, 0.0212}}};

TEST(TextureMaps, StatisticsAreThoseOfTheGoldenYard) {
  ASSERT_EQ(golden.size(), 5U);
  const Drawn drawn = small_yard();
  for (const auto& [which, expected] : golden) {
    const Statistics found = statistics(drawn.values(which));
    EXPECT_NEAR(found.mean, expected.mean, 0.001) << name_of(which);
    EXPECT_NEAR(found.deviation, expected.deviation, 0.001) << name_of(which);
  }
  EXPECT_FALSE(agree(golden, small_yard(9.0)));  // a near miss: joints a millimetre wider
}

// ---- materials

struct Mean {
  double red = 0.0, green = 0.0, blue = 0.0;
  double light() const { return 0.2126 * red + 0.7152 * green + 0.0722 * blue; }
};

// Of the pixels that are all stone, or all joint.
Mean mean_colour(const paving::Look& look, bool of_stones) {
  paving::Pavement pavement = square_pavement(512.0);
  pavement.look = look;
  pavement.relief.rms_mm = 0.0;
  const Drawn drawn(pavement, paving::laid_stones(pavement, 7).stones, small_grid, 2);
  const std::vector<float> colours = drawn.values(Map::base_color);
  Mean mean;
  double count = 0.0;
  for (std::size_t row = 0; row < small_grid.height; ++row) {
    for (std::size_t column = 0; column < small_grid.width; ++column) {
      if (drawn.map.cover[drawn.map.index(column, row)] != (of_stones ? 255 : 0)) continue;
      const float* colour = &colours[3 * (row * small_grid.width + column)];
      mean.red += static_cast<double>(colour[0]);
      mean.green += static_cast<double>(colour[1]);
      mean.blue += static_cast<double>(colour[2]);
      ++count;
    }
  }
  return {mean.red / count, mean.green / count, mean.blue / count};
}

// Luminance, and red over blue, within which each material is to lie, by eye; the others lie out of at least one of the two.
TEST(TextureMaps, ColoursAreThoseOfTheMaterial) {
  struct Expected {
    paving::Material material;
    double darkest, lightest, least_red, most_red;
    bool holds(const Mean& mean) const {
      const double red = mean.red / mean.blue;
      return mean.light() > darkest && mean.light() < lightest && red > least_red && red < most_red;
    }
  };
  const std::vector<Expected> all = {
      {paving::Material::setts, 0.14, 0.24, 0.95, 1.30},     {paving::Material::granite, 0.26, 0.45, 1.0, 1.20},
      {paving::Material::basalt, 0.05, 0.13, 0.8, 1.15},     {paving::Material::sandstone, 0.20, 0.36, 1.4, 2.2},
      {paving::Material::limestone, 0.30, 0.50, 1.20, 1.39}, {paving::Material::brick, 0.08, 0.20, 2.2, 5.0}};
  for (const Expected& drawn : all) {
    const Mean mean = mean_colour({drawn.material, {}, {}, 0.0, {}}, true);
    for (const Expected& expected : all) {
      EXPECT_EQ(expected.holds(mean), expected.material == drawn.material)
          << static_cast<int>(drawn.material) << " as " << static_cast<int>(expected.material) << ": " << mean.light() << ' '
          << mean.red / mean.blue;
    }
  }
}

TEST(TextureMaps, MossIsGreenMortarPaleAndWetIsDark) {
  const auto joints = [](std::optional<paving::JointFill> fill, std::optional<double> moss, double wetness) {
    return mean_colour({paving::Material::setts, fill, moss, wetness, {}}, false);
  };
  const Mean sand = joints(paving::JointFill::sand, 0.0, 0.0);
  const Mean mossy = joints(paving::JointFill::sand, 0.9, 0.0);
  EXPECT_LT(sand.green, sand.red);
  EXPECT_GT(mossy.green, 1.1 * mossy.red);
  EXPECT_GT(joints(paving::JointFill::mortar, {}, 0.0).light(), 1.8 * sand.light());
  EXPECT_LT(joints(paving::JointFill::sand, 0.0, 0.5).light(), 0.6 * sand.light());
  EXPECT_NEAR(joints({}, {}, 0.0).light(), sand.light(), 1e-9);
  const auto stones = [](double wetness) {
    return mean_colour({paving::Material::granite, {}, {}, wetness, {}}, true).light();
  };
  EXPECT_LT(stones(0.5), 0.6 * stones(0.0));
  EXPECT_LT(stones(0.2), 0.9 * stones(0.0));
}

// Water fills what lies below its level, flat and smooth, over about as many stones as the wetness says.
TEST(TextureMaps, WaterStandsInTheLowSpots) {
  paving::Pavement pavement = square_pavement(3000.0);
  pavement.surface.height_mm = 6.0;
  pavement.ground.settlement_mm = 25.0;
  pavement.ground.settlement_length_mm = 1500.0;
  pavement.relief.rms_mm = 0.0;
  const std::vector<paving::Stone> stones = paving::laid_stones(pavement, 7).stones;
  const PixelGrid grid{{0.0, 0.0}, {10.0, 10.0}, 300, 300};
  pavement.look.wetness = 0.5;
  const Drawn damp(pavement, stones, grid, 2);
  ASSERT_FALSE(damp.map.water_mm.has_value());
  pavement.look.wetness = 0.8;
  const Drawn wet(pavement, stones, grid, 2);
  ASSERT_TRUE(wet.map.water_mm.has_value());
  const std::vector<float> normals = wet.values(Map::normal);
  const std::vector<float> roughness = wet.values(Map::roughness);
  const std::vector<float> colours = wet.values(Map::base_color);
  const std::vector<float> damp_colours = damp.values(Map::base_color);
  std::size_t flooded = 0;
  std::size_t level = 0;
  double light = 0.0;
  double damp_light = 0.0;
  for (std::size_t row = 0; row < 300; ++row) {
    for (std::size_t column = 0; column < 300; ++column) {
      const std::size_t pixel = 300 * row + column;
      const std::size_t at = wet.map.index(column, row);
      const float ground = damp.map.height_mm[at];
      EXPECT_EQ(wet.map.height_mm[at], std::max(ground, *wet.map.water_mm));
      EXPECT_EQ(wet.map.is_flooded(at), ground <= *wet.map.water_mm);
      if (!wet.map.is_flooded(at)) {
        EXPECT_EQ(colours[3 * pixel], damp_colours[3 * pixel]);
        continue;
      }
      ++flooded;
      EXPECT_LT(roughness[pixel], 0.05F);
      light += static_cast<double>(colours[3 * pixel]);
      damp_light += static_cast<double>(damp_colours[3 * pixel]);
      if (normals[3 * pixel] == 0.5F && normals[3 * pixel + 1] == 0.5F) ++level;
    }
  }
  // A fifth of the middles of faces, and the joints between them and a little beyond.
  EXPECT_GT(flooded, 300U * 300U / 5U);
  EXPECT_LT(flooded, 300U * 300U / 2U);
  EXPECT_GT(level, flooded / 2U);
  EXPECT_LT(light, 0.85 * damp_light);
}

// ---- the files

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Without relief, whose making is most of the work, where it is none of the matter.
Model small_model(paving::TextureFormat format, double relief_rms_mm = 0.0) {
  Model model;
  model.name = "s";
  model.seed = 7;
  paving::Pavement pavement = square_pavement(300.0);
  pavement.textures.size_px = 96;
  pavement.textures.format = format;
  pavement.relief.rms_mm = relief_rms_mm;
  paving::StoneLayout layout = paving::laid_stones(pavement, 7);
  model.pavements.push_back({std::move(pavement), std::move(layout)});
  return model;
}

std::map<std::string, std::string> files_of(const Model& model, int threads) {
  const ThreadLimit limit(threads);
  const support::TemporaryFolder folder;
  std::map<std::string, std::string> files;
  for (const fs::path& path : pipeline::written_outputs({{}, texture_files(model)}, {"s", "export", ""}, folder.path()).paths) {
    files[path.filename().string()] = bytes_of(path);
  }
  return files;
}

TEST(TextureFiles, HaveNamesThatOtherProgramsKnow) {
  for (const auto& [format, ending] :
       {std::pair(paving::TextureFormat::png, ".png"), std::pair(paving::TextureFormat::exr, ".exr"),
        std::pair(paving::TextureFormat::tiled_exr, ".exr")}) {
    const auto files = files_of(small_model(format), 0);
    EXPECT_EQ(files.size(), 7U);
    for (const char* name : {"BaseColor", "Roughness", "Normal", "Height", "AmbientOcclusion", "ID"}) {
      EXPECT_EQ(files.count(std::string("yard_") + name + ending), 1U) << name << ending;
    }
    const auto told = nlohmann::json::parse(files.at("yard_textures.json"));
    EXPECT_EQ(told["size_px"], nlohmann::json({96, 96}));
    EXPECT_EQ(told["maps"]["Height"], "yard_Height" + std::string(ending));
  }
}

TEST(TextureFiles, AreTheSameForAnyNumberOfThreads) {
  for (const auto format : {paving::TextureFormat::png, paving::TextureFormat::tiled_exr}) {
    const Model model = small_model(format, format == paving::TextureFormat::png ? 0.6 : 0.0);
    const auto files = files_of(model, 1);
    EXPECT_EQ(files, files_of(model, 2));
    EXPECT_EQ(files, files_of(model, 7));
  }
}

TEST(TextureFiles, BaseColourIsSrgbInPngAndLinearInExr) {
  const auto read = [](const std::string& bytes, const std::string& name) {
    const support::TemporaryFolder folder;
    const fs::path path = folder.path() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return relief::read_raster(path.string());
  };
  const relief::Raster png = read(files_of(small_model(paving::TextureFormat::png), 0).at("yard_BaseColor.png"), "c.png");
  const relief::Raster exr = read(files_of(small_model(paving::TextureFormat::exr), 0).at("yard_BaseColor.exr"), "c.exr");
  const relief::Raster shown = relief::display(exr);
  ASSERT_EQ(shown.values.size(), png.values.size());
  // Steps of 8 bits, and of half floats.
  for (std::size_t i = 0; i < png.values.size(); ++i) ASSERT_NEAR(png.values[i], shown.values[i], 0.6F / 255.0F);
}

}  // namespace
}  // namespace shatterpave::exporting::textures
