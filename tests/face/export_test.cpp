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
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~FaceExport() override { fs::remove_all(folder_); }

  // A folder of this test's own.
  fs::path folder_ = fs::path(testing::TempDir()) /
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
  const Written written = write_targets(model, {"svg", "json", "svg"}, folder_ / "deep" / "out");
  std::vector<File> files = export_files(model, "json");
  for (File& file : export_files(model, "svg")) files.push_back(file);
  ASSERT_EQ(written.files.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(written.files[i], folder_ / "deep" / "out" / files[i].name);
    EXPECT_EQ(content_of(written.files[i]), files[i].content);
  }
}

TEST_F(FaceExport, RefusesTargetsThatAreNoneOrHaveNothingToWrite) {
  const Model model = generate(small_pane());
  for (const char* name : {"", "pov", "JSON"}) EXPECT_THROW(export_files(model, name), InputError) << name;
  try {
    write_targets(model, {"json", "povry"}, folder_);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(error.message().find("did you mean povray"), std::string::npos) << error.what();
  }
  Scene gone = small_pane();
  gone.set("pane.window.shards.splinter_mm2", 1e6);
  const Model nothing = generate(gone);
  EXPECT_THROW(export_files(nothing, "obj"), InputError);
  EXPECT_THROW(write_targets(nothing, {"json", "obj"}, folder_), InputError);
  EXPECT_TRUE(names_in(folder_).empty());
}

TEST_F(FaceExport, WritesAllOrNothing) {
  const Model model = generate(small_yard());
  fs::create_directories(folder_ / "yard-court.svg");
  EXPECT_THROW(write_targets(model, {"json", "svg"}, folder_), InputError);
  EXPECT_EQ(names_in(folder_), std::set<std::string>{"yard-court.svg"});
  EXPECT_THROW(write_targets(model, {"json"}, folder_, {.cancelled = [] { return true; }}), Interrupted);
  EXPECT_EQ(names_in(folder_), std::set<std::string>{"yard-court.svg"});
  std::ofstream(folder_ / "file") << "in the way";
  EXPECT_THROW(write_targets(model, {"json"}, folder_ / "file"), InputError);
}

TEST_F(FaceExport, FilesOfOnesOwnAreASetBesideTheTargets) {
  Scene scene = small_yard();
  const Model model = generate(scene);
  write_targets(model, {"json"}, folder_);
  write_files(model, {{"a.csv", "1\n"}, {"b.csv", std::string("\0\n", 2)}}, folder_, "tables");
  write_files(model, {{"c.csv", "3\n"}}, folder_, "others");
  EXPECT_EQ(names_in(folder_), (std::set<std::string>{"a.csv", "b.csv", "c.csv", "yard.json"}));
  EXPECT_EQ(content_of(folder_ / "b.csv"), std::string("\0\n", 2));
  scene.set("seed", 6);
  const Written later = write_files(generate(scene), {{"a.csv", "2\n"}}, folder_, "tables");
  EXPECT_EQ(later.removed, std::vector<std::string>{"b.csv"});
  EXPECT_EQ(names_in(folder_), (std::set<std::string>{"a.csv", "c.csv", "yard.json"}));
  EXPECT_EQ(content_of(folder_ / "a.csv"), "2\n");
  // A file of another set is not replaced.
  EXPECT_THROW(write_files(model, {{"yard.json", "{}"}}, folder_, "tables"), InputError);
}

TEST_F(FaceExport, RefusesNamesThatAreNoneOfFiles) {
  const Model model = generate(small_yard());
  for (const std::string name : {"", ".", "..", ".hidden", "a/b", "/a", "../a", "a\nb"}) {
    EXPECT_THROW(write_files(model, {{name, ""}}, folder_, "tables"), InputError) << name;
  }
  EXPECT_THROW(write_files(model, {{std::string(300, 'a'), ""}}, folder_, "tables"), InputError);
  EXPECT_THROW(write_files(model, {{"a", ""}, {"a", "b"}}, folder_, "tables"), InputError);
  for (const std::string& maker : {std::string(), std::string("a\n"), std::string("\xff"), std::string(65, 'a')}) {
    EXPECT_THROW(write_files(model, {{"a", ""}}, folder_, maker), InputError) << maker;
  }
  EXPECT_TRUE(names_in(folder_).empty());
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
