#include "export/povray/povray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "core/error.h"
#include "export/export_panes.h"
#include "render/povray.h"

namespace shatterpave::exporting::povray {
namespace {

using support::broken_pane;
using support::pane_with;

Model model_with(const std::vector<glass::Pane>& panes) {
  Model model;
  model.name = "scene";
  for (const glass::Pane& pane : panes) model.panes.push_back(broken_pane(pane));
  return model;
}

const OutputFile& file_named(const std::vector<OutputFile>& files, const std::string& name) {
  const auto found = std::ranges::find(files, name, &OutputFile::name);
  if (found == files.end()) throw std::runtime_error("no file " + name);
  return *found;
}

// A pane of cracks, and one of shards.
Model model_of_both() {
  Model model = model_with({pane_with(24)});
  model.panes.push_back(support::shattered_pane(20));
  model.panes.back().pane.name = "shards";
  return model;
}

// The same, not cleaned for long.
Model model_of_dirt() {
  Model model = model_of_both();
  for (BrokenPane& broken : model.panes) broken.pane.dirt = 0.5;
  return model;
}

TEST(PovrayFiles, FolderNeedsNothingButPovraysOwnIncludes) {
  const std::vector<OutputFile> files = povray_files(model_of_dirt());
  std::set<std::string> names;
  for (const OutputFile& file : files) EXPECT_TRUE(names.insert(file.name).second) << file.name;
  const std::regex include("#include \"([^\"]+)\"");
  int included = 0;
  for (const OutputFile& file : files) {
    for (std::sregex_iterator found(file.content.begin(), file.content.end(), include), end; found != end; ++found) {
      EXPECT_TRUE(names.contains((*found)[1]) || (*found)[1] == "functions.inc") << (*found)[1];
      ++included;
    }
  }
  EXPECT_GE(included, 5);
}

TEST(PovrayFiles, IncludesHoldDeclarationsOnly) {
  for (const OutputFile& file : povray_files(model_of_both())) {
    if (!file.name.ends_with(".inc")) continue;
    for (const char* word : {"camera", "light_source", "global_settings"}) {
      EXPECT_FALSE(std::regex_search(file.content, std::regex(std::string("(^|\\n)\\s*") + word + "\\s*\\{")))
          << file.name << " holds " << word;
    }
    EXPECT_NE(file.content.find("_Inc_Temp)\n"), std::string::npos) << file.name;
    EXPECT_TRUE(file.content.ends_with("_Inc_Temp;\n#end\n")) << file.name;
  }
}

TEST(PovrayFiles, HeaderNamesWhatTheFileDeclares) {
  const std::vector<OutputFile> files = povray_files(model_of_dirt());
  for (const std::string name : {"window", "shards"}) {
    const std::string& text = file_named(files, name + ".inc").content;
    const std::string header = text.substr(0, text.find("#ifndef"));
    const std::regex declaration("\\n#(?:declare|macro) (" + name + "_\\w+)");
    for (std::sregex_iterator found(text.begin(), text.end(), declaration), end; found != end; ++found) {
      if ((*found)[1] == name + "_Inc_Temp") continue;
      // Named by its first two.
      if (std::regex_match((*found)[1].str(), std::regex(name + "_Shard_[0-9]*[2-9]"))) continue;
      EXPECT_NE(header.find((*found)[1].str()), std::string::npos) << (*found)[1];
    }
  }
}

// POV-Ray reads a switch through to its case: with meshes in it n shards took n² time, two thousand dice nine minutes.
TEST(PovrayFiles, SwitchesHoldNoMeshes) {
  const std::string text = file_named(povray_files(model_of_both()), "shards.inc").content;
  std::size_t switches = 0;
  for (std::size_t at = text.find("#switch"); at != std::string::npos; at = text.find("#switch", at + 1)) {
    ++switches;
    EXPECT_EQ(text.substr(at, text.find("#end", at) - at).find("mesh2"), std::string::npos);
  }
  EXPECT_GT(switches, 0U);
  EXPECT_NE(text.find("mesh2"), std::string::npos);
}

TEST(PovrayFiles, UnknownSettingIsAnInputError) {
  Model model = model_with({});
  model.setting = "moon_still";
  EXPECT_THROW(povray_files(model), InputError);
}

// ---- by POV-Ray itself, which must end with 0 and without one warning

void expect_renders(const std::string& name, const Model& model) {
  const std::filesystem::path folder = render_tests::output_folder() / ("glass_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const OutputFile& file : povray_files(model)) std::ofstream(folder / file.name, std::ios::binary) << file.content;
  const relief::Raster picture = render_tests::rendered(folder, "scene.pov", 160, 120);
  EXPECT_EQ(picture.values.size(), 160U * 120U * 3U);
  EXPECT_TRUE(std::ranges::all_of(picture.values, [](float value) { return value >= 0.0F; }));
}

class RenderGlass : public testing::TestWithParam<int> {};

TEST_P(RenderGlass, WithoutWarning) { expect_renders(std::to_string(GetParam()), model_with({pane_with(GetParam())})); }

INSTANTIATE_TEST_SUITE_P(Radials, RenderGlass, testing::Values(1, 24, 113, 200, 1000));

// The same panes with cracks through the thickness: no warning, and above all no crash of POV-Ray where hundreds of them meet.
class RenderSheets : public testing::TestWithParam<int> {};

TEST_P(RenderSheets, WithoutWarning) {
  glass::Pane pane = pane_with(GetParam());
  pane.crack_body = glass::CrackBody::sheet;
  expect_renders("sheets_" + std::to_string(GetParam()), model_with({pane}));
}

INSTANTIATE_TEST_SUITE_P(Radials, RenderSheets, testing::Values(1, 24, 113, 200));

TEST(PovrayFiles, HeaderNamesWhatSheetsDeclare) {
  glass::Pane pane = pane_with(3);
  pane.crack_body = glass::CrackBody::sheet;
  const std::vector<OutputFile> files = povray_files(model_with({pane}));
  const std::string& text = file_named(files, "window.inc").content;
  EXPECT_NE(text.find("#declare window_Cracks_0 =\nunion {"), std::string::npos);
  EXPECT_NE(text.find("mesh2 {"), std::string::npos);
  EXPECT_NE(text.find("Shatterpave_Gap_Faces("), std::string::npos);
  EXPECT_EQ(text.find("face_indices"), std::string::npos);
  EXPECT_EQ(text.find("cylinder {"), std::string::npos);
  EXPECT_NE(text.substr(0, text.find("#ifndef")).find("window_Cracks_0"), std::string::npos);
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

// With clear air in the cracks, whatever they are made of, and without the crushed zone: so that only their shape tells.
relief::Raster lit_by_the_shop(const std::string& name, const BrokenPane& broken) {
  Model model;
  model.name = "scene";
  model.setting = "shop_window_still";
  model.panes = {broken};
  const std::filesystem::path folder = render_tests::output_folder() / ("flash_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (OutputFile file : povray_files(model)) {
    replace(file.content, "   object { window_Crushed double_illuminate }\n", "");
    replace(file.content, "object { window_Pane }",
            "#local Air = material { texture { pigment { rgbt 1 } finish { reflection { 0, 1 fresnel on } conserve_energy } } "
            "interior { ior 1 } } object { window_Broken(Shatterpave_Glass, Air) }");
    std::ofstream(folder / file.name, std::ios::binary) << file.content;
  }
  return render_tests::rendered(folder, "scene.pov", 160, 120);
}

// The light that cracks add to the picture of the bare slab, less what they take.
double light_added(const relief::Raster& cracked, const relief::Raster& bare) {
  double sum = 0.0;
  for (std::size_t i = 0; i < bare.values.size(); ++i) {
    sum += (static_cast<double>(cracked.values[i]) - static_cast<double>(bare.values[i])) / 3.0;
  }
  return sum;
}

// Whether a leaning wall mirrors a lamp at the viewer is chance: the cracks of one pane flash all over, those of the next
// hardly. So five panes are taken together. Walls that stand upright mirror nothing of what lies aside: the wrong twin.
TEST(RenderSheetsLook, FlashMoreThanCylinders) {
  glass::Pane pane = pane_with(24);
  pane.outline_mm = {{90, 105}, {210, 105}, {210, 195}, {90, 195}};
  pane.thickness_mm = 5.0;
  const relief::Raster bare = lit_by_the_shop("bare", {pane, {}});
  glass::Pane leaning = pane;
  leaning.crack_body = glass::CrackBody::sheet;
  glass::Pane upright = leaning;
  upright.crack_sheet.tilt = upright.crack_sheet.curve = Angle();
  double of_cylinders = 0.0;
  double of_leaning = 0.0;
  double of_upright = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const glass::CrackNetwork network = glass::broken(pane, seed);
    const auto light = [&](const char* name, const glass::Pane& of) {
      BrokenPane broken{of, network};
      if (of.crack_body == glass::CrackBody::sheet) broken.surfaces = glass::crack_surfaces(of, network, seed);
      return light_added(lit_by_the_shop(name, broken), bare);
    };
    of_cylinders += light("cylinders", pane);
    of_leaning += light("leaning", leaning);
    of_upright += light("upright", upright);
  }
  EXPECT_GT(of_leaning, 1.5 * of_cylinders);
  EXPECT_LT(of_upright, of_cylinders);
  RecordProperty("leaning", std::to_string(of_leaning));
  RecordProperty("upright", std::to_string(of_upright));
  RecordProperty("cylinders", std::to_string(of_cylinders));
}

TEST(RenderGlassCases, PanesOfManyShapesSideBySide) {
  glass::Pane corner = pane_with(40);
  corner.name = "corner-pane";
  corner.outline_mm = {{0, 0}, {300, 0}, {300, 120}, {130, 120}, {130, 300}, {0, 300}};
  corner.impacts[0].at_mm = {60, 60};
  glass::Pane tall = pane_with(24);
  tall.name = "corner_pane";
  tall.thickness_mm = 6.0;
  tall.outline_mm = {{-600, -1000}, {600, -1000}, {600, 1000}, {-600, 1000}};
  tall.impacts[0].at_mm = {0, 0};
  glass::Pane whole = pane_with(1);
  whole.name = "1st";
  whole.impacts.clear();
  expect_renders("shapes", model_with({corner, tall, whole}));
}

// Far lights stand for what is all around, which the glass mirrors itself. Cracks' shadows need a sun, shards lie in their own.
TEST(PovrayFiles, GlassLitFromAllAroundHasNoGlintsOfItsLights) {
  const auto still_of = [](Model model, std::optional<studio::Sun> sun) {
    model.setting = "own";
    model.light.emplace().sun = sun;
    return file_named(povray_files(model), model.name + ".pov").content;
  };
  const Model whole = model_with({pane_with(24)});
  const std::string around = still_of(whole, std::nullopt);
  EXPECT_LT(around.find("#declare Shatterpave_Glint = 0;"), around.find("#include \"window.inc\""));
  EXPECT_NE(around.find("object { window_Pane no_shadow }"), std::string::npos);
  const std::string sunny = still_of(whole, studio::Sun{});
  EXPECT_EQ(sunny.find("Shatterpave_Glint"), std::string::npos);
  EXPECT_NE(sunny.find("object { window_Pane }"), std::string::npos);
  Model shattered = whole;
  shattered.panes = {support::shattered_pane(24, true)};
  EXPECT_EQ(still_of(shattered, std::nullopt).find("no_shadow }"), std::string::npos);
  // Of shards, those that stand.
  const std::string shards = file_named(povray_files(shattered), "window.inc").content;
  const auto count = [&](const std::string& what) {
    std::ptrdiff_t found = 0;
    for (std::size_t at = shards.find(what); at != std::string::npos; at = shards.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("Shatterpave_Standing()"),
            std::ranges::count(shattered.panes[0].shards, glass::ShardState::standing, &glass::Shard::state));
  EXPECT_GT(count("Shatterpave_Standing()"), 0);
}

// Shards in both windows and in the studio, of a pane that no frame of its own holds, with and without fallen ones.
TEST(RenderGlassCases, DispersionAndCausticsOnRequest) {
  Model model = model_of_both();
  model.setting = "studio_glass_still";
  const std::string plain = file_named(povray_files(model), model.name + ".pov").content;
  EXPECT_EQ(plain.find("photons"), std::string::npos);
  EXPECT_EQ(plain.find("#declare Shatterpave_Dispersion"), std::string::npos);
  model.dispersion = true;
  model.caustics = true;
  const std::string asked = file_named(povray_files(model), model.name + ".pov").content;
  EXPECT_NE(asked.find("photons { target"), std::string::npos);
  EXPECT_LT(asked.find("#declare Shatterpave_Dispersion = 1.012;"), asked.find("#include \"window.inc\""));
  expect_renders("optics", model);
}

// Faces of cracked panes and of shards; each pane has dirt of its own, and a clean one none.
TEST(RenderGlassCases, Dirt) {
  Model model = model_of_dirt();
  model.setting = "studio_glass_still";
  expect_renders("dirt", model);
  const std::vector<OutputFile> files = povray_files(model);
  std::set<std::string> places;
  for (const std::string name : {"window", "shards"}) {
    const std::string& text = file_named(files, name + ".inc").content;
    std::smatch call;
    ASSERT_TRUE(std::regex_search(text, call, std::regex("Shatterpave_Dirt_On\\(.*, ([0-9.]+)\\)"))) << name;
    EXPECT_TRUE(places.insert(call[1]).second) << name;
  }
  for (const OutputFile& file : povray_files(model_of_both())) {
    EXPECT_EQ(file.content.find("_Dirt"), std::string::npos) << file.name;
  }
}

TEST(RenderGlassCases, Shards) {
  Model model = model_of_both();
  for (const std::string setting : {"window_still", "broken_window_still"}) {
    model.setting = setting;
    expect_renders("shards_" + setting, model);
  }
}

// Bodies of joined shards with the tubes of cracks within them, also where one body is all that is left.
class RenderJoinedShards : public testing::TestWithParam<int> {};

TEST_P(RenderJoinedShards, WithoutWarning) {
  Model model = model_of_both();
  model.panes = {support::shattered_pane(GetParam(), true)};
  model.setting = "broken_window_still";
  expect_renders("joined_" + std::to_string(GetParam()), model);
  std::erase_if(model.panes[0].shards, [](const glass::Shard& shard) { return shard.joined.empty(); });
  model.panes[0].shards.resize(1);
  expect_renders("joined_alone_" + std::to_string(GetParam()), model);
}

INSTANTIATE_TEST_SUITE_P(Radials, RenderJoinedShards, testing::Values(24, 200));

TEST(PovrayFiles, HeaderNamesTheCracksWithinJoinedShards) {
  Model model = model_of_both();
  model.panes = {support::shattered_pane(60)};
  const std::string apart = file_named(povray_files(model), "window.inc").content;
  EXPECT_EQ(apart.find("window_Cracks"), std::string::npos);
  model.panes = {support::shattered_pane(60, true)};
  const std::string joined = file_named(povray_files(model), "window.inc").content;
  EXPECT_NE(joined.find("#declare window_Cracks =\nunion {"), std::string::npos);
  EXPECT_NE(joined.find("object { window_Cracks material { Shatterpave_Crack } double_illuminate }"), std::string::npos);
  EXPECT_NE(joined.substr(0, joined.find("#ifndef")).find("window_Cracks"), std::string::npos);
}

}  // namespace
}  // namespace shatterpave::exporting::povray
