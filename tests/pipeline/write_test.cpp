#include "pipeline/write.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <sstream>

#include "core/error.h"

namespace shatterpave::pipeline {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test.
class Writing : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "write-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    root = pattern;
  }
  void TearDown() override { fs::remove_all(root); }

  // All files below the folder, with their content.
  std::map<std::string, std::string> content() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      std::ostringstream text;
      if (!entry.is_directory()) text << stream.rdbuf();
      files[fs::relative(entry.path(), root).string()] = entry.is_directory() ? "folder" : text.str();
    }
    return files;
  }

  fs::path root;
};

using Files = std::map<std::string, std::string>;

TEST_F(Writing, MakesFoldersAndReplacesFiles) {
  const std::vector<fs::path> paths = written({{"a.txt", "1"}, {"b.txt", "2"}}, root / "x/y");
  EXPECT_EQ(paths, (std::vector<fs::path>{root / "x/y/a.txt", root / "x/y/b.txt"}));
  EXPECT_EQ(content(), (Files{{"x", "folder"}, {"x/y", "folder"}, {"x/y/a.txt", "1"}, {"x/y/b.txt", "2"}}));
  written({{"b.txt", "3"}}, root / "x/y");
  EXPECT_EQ(content(), (Files{{"x", "folder"}, {"x/y", "folder"}, {"x/y/a.txt", "1"}, {"x/y/b.txt", "3"}}));
}

TEST_F(Writing, InterruptedLeavesEverythingAsItWas) {
  write_file(root / "a.txt", "old");
  const Files before = content();
  int asked = 0;
  EXPECT_THROW(written({{"a.txt", "new"}, {"b.txt", "new"}}, root, [&] { return ++asked == 2; }), Interrupted);
  EXPECT_EQ(content(), before);
  EXPECT_THROW(written({{"a.txt", "new"}}, root / "made/here", [] { return true; }), Interrupted);
  EXPECT_EQ(content(), before);
}

TEST_F(Writing, FailureInTheMiddlePutsBackWhatWasThere) {
  write_file(root / "a.txt", "old");
  fs::create_directory(root / "c.txt");  // in the way of the third file
  const Files before = content();
  EXPECT_THROW(written({{"a.txt", "new"}, {"b.txt", "new"}, {"c.txt", "new"}}, root), InputError);
  EXPECT_EQ(content(), before);
}

TEST_F(Writing, FileInPlaceOfTheFolderIsWrongInput) {
  write_file(root / "file", "x");
  const Files before = content();
  EXPECT_THROW(written({{"a.txt", "1"}}, root / "file"), InputError);
  EXPECT_THROW(written({{"a.txt", "1"}}, root / "file/below"), InputError);
  EXPECT_EQ(content(), before);
}

TEST_F(Writing, LinkToNothingInPlaceOfTheFolderIsWrongInput) {
  fs::create_symlink(root / "nowhere/at/all", root / "link");
  EXPECT_THROW(require_output_folder(root / "link"), InputError);
  EXPECT_THROW(require_output_folder(root / "link/below"), InputError);
  fs::create_directory(root / "there");
  fs::create_symlink(root / "there", root / "good");
  EXPECT_NO_THROW(require_output_folder(root / "good/below"));
}

TEST_F(Writing, FullDiskIsAnErrorOfTheSystem) {
  EXPECT_THROW(write_file("/dev/full", "x"), fs::filesystem_error);
  EXPECT_THROW(write_file(root / "no/such/folder.txt", "x"), fs::filesystem_error);
}

}  // namespace
}  // namespace shatterpave::pipeline
