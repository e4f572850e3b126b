#include <gtest/gtest.h>
#include <shatterpave/export.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "face/scenes.h"

namespace shatterpave {

namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.front() != '.') names.insert(name);
  }
  return names;
}

class FaceExport : public testing::Test {
 protected:
  FaceExport() {
    fs::remove_all(own_folder);
    fs::create_directories(own_folder);
  }
  ~FaceExport() override { fs::remove_all(own_folder); }

  // A folder of this test's own.
  fs::path own_folder = fs::path(testing::TempDir()) /
                        ("face_export_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(FaceExport, TargetsHaveNamesAndSentences) {
  std::set<std::string_view> names;
  for (const Target& target : targets()) {
    names.insert(target.name);
    EXPECT_GT(target.sentence.size(), 10U) << target.name;
  }
  EXPECT_EQ(names.size(), targets().size());
  for (const char* name : {"povray", "json", "svg", "textures", "obj"}) EXPECT_TRUE(names.contains(name)) << name;
}

TEST_F(FaceExport, FilesInMemoryAreThoseInTheFolder) {
  const Model model = generate(small_yard());
  const Written written = write_targets(model, {"svg", "json", "svg"}, own_folder / "deep" / "out");
  std::vector<File> files = export_files(model, "json");
  for (File& file : export_files(model, "svg")) files.push_back(file);
  ASSERT_EQ(written.files.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(written.files[i], own_folder / "deep" / "out" / files[i].name);
    EXPECT_EQ(content_of(written.files[i]), files[i].content);
  }
}

TEST_F(FaceExport, RefusesTargetsThatAreNoneOrHaveNothingToWrite) {
  const Model model = generate(small_pane());
  for (const char* name : {"", "pov", "JSON"}) EXPECT_THROW(export_files(model, name), InputError) << name;
  try {
    write_targets(model, {"json", "povry"}, own_folder);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(error.message().find("did you mean povray"), std::string::npos) << error.what();
  }
  Scene gone = small_pane();
  gone.set("pane.window.shards.splinter_mm2", 1e6);
  const Model nothing = generate(gone);
  EXPECT_THROW(export_files(nothing, "obj"), InputError);
  EXPECT_THROW(write_targets(nothing, {"json", "obj"}, own_folder), InputError);
  EXPECT_TRUE(names_in(own_folder).empty());
}

TEST_F(FaceExport, WritesAllOrNothing) {
  const Model model = generate(small_yard());
  fs::create_directories(own_folder / "yard-court.svg");
  EXPECT_THROW(write_targets(model, {"json", "svg"}, own_folder), InputError);
  EXPECT_EQ(names_in(own_folder), std::set<std::string>{"yard-court.svg"});
  EXPECT_THROW(write_targets(model, {"json"}, own_folder, {.cancelled = [] { return true; }}), Interrupted);
  EXPECT_EQ(names_in(own_folder), std::set<std::string>{"yard-court.svg"});
  std::ofstream(own_folder / "file") << "in the way";
  EXPECT_THROW(write_targets(model, {"json"}, own_folder / "file"), InputError);
}

TEST_F(FaceExport, FilesOfOnesOwnAreASetBesideTheTargets) {
  Scene scene = small_yard();
  const Model model = generate(scene);
  write_targets(model, {"json"}, own_folder);
  write_files(model, {{"a.csv", "1\n"}, {"b.csv", std::string("\0\n", 2)}}, own_folder, "tables");
  write_files(model, {{"c.csv", "3\n"}}, own_folder, "others");
  EXPECT_EQ(names_in(own_folder), (std::set<std::string>{"a.csv", "b.csv", "c.csv", "yard.json"}));
  EXPECT_EQ(content_of(own_folder / "b.csv"), std::string("\0\n", 2));
  scene.set("seed", 6);
  const Written later = write_files(generate(scene), {{"a.csv", "2\n"}}, own_folder, "tables");
  EXPECT_EQ(later.removed, std::vector<std::string>{"b.csv"});
  EXPECT_EQ(names_in(own_folder), (std::set<std::string>{"a.csv", "c.csv", "yard.json"}));
  EXPECT_EQ(content_of(own_folder / "a.csv"), "2\n");
  // A file of another set is not replaced.
  EXPECT_THROW(write_files(model, {{"yard.json", "{}"}}, own_folder, "tables"), InputError);
}

TEST_F(FaceExport, RefusesNamesThatAreNoneOfFiles) {
  const Model model = generate(small_yard());
  for (const std::string name : {"", ".", "..", ".hidden", "a/b", "/a", "../a", "a\nb"}) {
    EXPECT_THROW(write_files(model, {{name, ""}}, own_folder, "tables"), InputError) << name;
  }
  EXPECT_THROW(write_files(model, {{std::string(300, 'a'), ""}}, own_folder, "tables"), InputError);
  EXPECT_THROW(write_files(model, {{"a", ""}, {"a", "b"}}, own_folder, "tables"), InputError);
  for (const std::string& maker : {std::string(), std::string("a\n"), std::string("\xff"), std::string(65, 'a')}) {
    EXPECT_THROW(write_files(model, {{"a", ""}}, own_folder, maker), InputError) << maker;
  }
  EXPECT_TRUE(names_in(own_folder).empty());
}

TEST_F(FaceExport, TextureSetsSlowComeThroughTheFolderOfTheSystem) {
  Scene scene = small_yard();
  scene.set("pavement.court.textures", Value::parsed("{size_px = 256}"));
  const std::vector<File> files = export_files(generate(scene), "textures");
  EXPECT_GE(files.size(), 5U);
  for (const File& file : files) EXPECT_GT(file.content.size(), 100U) << file.name;
}

}  // namespace

}  // namespace shatterpave
