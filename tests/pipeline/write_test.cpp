#include "pipeline/write.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <map>
#include <sstream>

#include "core/cancel.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/sha256.h"
#include "support/temporary_folder.h"

namespace shatterpave::pipeline {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test.
class Writing : public support::FolderTest {
 protected:
  // All files below the folder, with their content.
  std::map<std::string, std::string> content() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      std::ostringstream text;
      if (!entry.is_directory()) text << stream.rdbuf();
      files[fs::relative(entry.path(), folder_).string()] = entry.is_directory() ? "folder" : text.str();
    }
    return files;
  }

  // Those but for the notes.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all = content();
    std::erase_if(all, [](const auto& file) { return file.first.ends_with(notes_file); });
    return all;
  }
};

using Files = std::map<std::string, std::string>;
const Edition first_edition{"s", "export", "1"};
const Edition second_edition{"s", "export", "2"};

TEST_F(Writing, MakesFoldersAndReplacesFiles) {
  const Published out = written({{"a.txt", "1"}, {"b.txt", "2"}}, first_edition, folder_ / "x/y");
  EXPECT_EQ(out.paths, (std::vector<fs::path>{folder_ / "x/y/a.txt", folder_ / "x/y/b.txt"}));
  EXPECT_EQ(files(), (Files{{"x", "folder"}, {"x/y", "folder"}, {"x/y/a.txt", "1"}, {"x/y/b.txt", "2"}}));
  written({{"b.txt", "3"}}, first_edition, folder_ / "x/y");
  EXPECT_EQ(files(), (Files{{"x", "folder"}, {"x/y", "folder"}, {"x/y/a.txt", "1"}, {"x/y/b.txt", "3"}}));
}

TEST_F(Writing, InterruptedLeavesEverythingAsItWas) {
  write_file(folder_ / "a.txt", "old");
  const Files before = content();
  int last = 0;
  for (int allowed = 0; last == 0; ++allowed) {
    int asked = 0;
    try {
      written({{"a.txt", "new"}, {"b.txt", "new"}}, first_edition, folder_, [&] { return asked++ >= allowed; });
      last = allowed;
    } catch (const Interrupted&) {
      ASSERT_EQ(content(), before) << "stopped at question " << allowed;
    }
  }
  EXPECT_GE(last, 3);
  EXPECT_EQ(files(), (Files{{"a.txt", "new"}, {"b.txt", "new"}}));
  EXPECT_THROW(written({{"a.txt", "new"}}, first_edition, folder_ / "made/here", [] { return true; }), Interrupted);
  EXPECT_EQ(files(), (Files{{"a.txt", "new"}, {"b.txt", "new"}}));
}

// Sets of large files are stopped in their loops.
TEST_F(Writing, SetsOfLargeFilesStopInTheMiddleInThreads) {
  std::atomic<int> begun = 0;
  const exporting::FileSet large{{"a.bin"}, [&](const std::string& folder) {
                                   parallel_for(100000, [&](std::size_t) { ++begun; });
                                   write_file(fs::path(folder) / "a.bin", "x");
                                 }};
  EXPECT_THROW(written_outputs({{}, {large}}, first_edition, folder_, [&] { return begun > 100; }), Interrupted);
  EXPECT_LT(begun, 1000);
  EXPECT_EQ(content(), Files());
}

TEST_F(Writing, FailureInTheMiddlePutsBackWhatWasThere) {
  write_file(folder_ / "a.txt", "old");
  fs::create_directory(folder_ / "c.txt");  // in the way of the third file
  const Files before = content();
  EXPECT_THROW(written({{"a.txt", "new"}, {"b.txt", "new"}, {"c.txt", "new"}}, first_edition, folder_), InputError);
  EXPECT_EQ(content(), before);
}

TEST_F(Writing, FileInPlaceOfTheFolderIsWrongInput) {
  write_file(folder_ / "file", "x");
  const Files before = content();
  EXPECT_THROW(written({{"a.txt", "1"}}, first_edition, folder_ / "file"), InputError);
  EXPECT_THROW(written({{"a.txt", "1"}}, first_edition, folder_ / "file/below"), InputError);
  EXPECT_EQ(content(), before);
}

TEST_F(Writing, LinkToNothingInPlaceOfTheFolderIsWrongInput) {
  fs::create_symlink(folder_ / "nowhere/at/all", folder_ / "link");
  EXPECT_THROW(require_output_folder(folder_ / "link"), InputError);
  EXPECT_THROW(require_output_folder(folder_ / "link/below"), InputError);
  fs::create_directory(folder_ / "there");
  fs::create_symlink(folder_ / "there", folder_ / "good");
  EXPECT_NO_THROW(require_output_folder(folder_ / "good/below"));
  // A way up from a linked folder is one from where the link leads.
  fs::create_directory(folder_ / "there/in");
  fs::create_symlink(folder_ / "there/in", folder_ / "deep");
  written({{"a.txt", "1"}}, first_edition, folder_ / "deep/../out");
  EXPECT_TRUE(fs::exists(folder_ / "there/out/a.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Writing, FolderThatCannotBeMadeIsWrongInput) {
  EXPECT_THROW(written({{"a.txt", "1"}}, first_edition, "/proc/foo"), InputError);
}

TEST_F(Writing, FullDiskIsAnErrorOfTheSystem) {
  EXPECT_THROW(write_file("/dev/full", "x"), fs::filesystem_error);
  EXPECT_THROW(write_file(folder_ / "no/such/folder.txt", "x"), fs::filesystem_error);
}

TEST_F(Writing, SumIsThatOfTheFile) {
  write_file(folder_ / "abc", "abc");
  EXPECT_EQ(sum_of(folder_ / "abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");  // FIPS 180-2, B.1
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

// --- Sets ---

TEST_F(Writing, FilesOfOneStateStandSideBySide) {
  written({{"s.json", "1"}}, first_edition, folder_);
  const Published out = written({{"s.svg", "1"}}, first_edition, folder_);
  EXPECT_TRUE(out.removed.empty());
  EXPECT_EQ(files(), (Files{{"s.json", "1"}, {"s.svg", "1"}}));
}

TEST_F(Writing, FilesOfAnEarlierStateGo) {
  written({{"s.json", "1"}, {"s.svg", "1"}, {"s.obj", "1"}}, first_edition, folder_);
  write_file(folder_ / "s.obj", "changed by hand");
  write_file(folder_ / "mine.svg", "x");
  const Published out = written({{"s.json", "2"}}, second_edition, folder_);
  EXPECT_EQ(out.removed, std::vector<std::string>{"s.svg"});
  EXPECT_EQ(out.left, std::vector<std::string>{"s.obj"});
  EXPECT_EQ(files(), (Files{{"s.json", "2"}, {"s.obj", "changed by hand"}, {"mine.svg", "x"}}));
  // Other sets of the scene stay.
  written({{"s.png", "1"}}, {"s", "picture", "1"}, folder_);
  EXPECT_EQ(written({{"s.svg", "3"}}, {"s", "export", "3"}, folder_).removed, std::vector<std::string>{"s.json"});
  EXPECT_TRUE(fs::exists(folder_ / "s.png"));
}

TEST_F(Writing, FilesOfAnotherSceneAreNotReplaced) {
  written({{"monday.pov", "m"}, {"plaza.inc", "m"}, {"glass.inc", "same"}}, {"monday", "export", "1"}, folder_);
  const Files before = content();
  const auto message = [&](const std::vector<exporting::OutputFile>& wanted) -> std::string {
    try {
      written(wanted, {"tuesday", "export", "1"}, folder_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(
      message({{"tuesday.pov", "t"}, {"plaza.inc", "t"}, {"glass.inc", "same"}}),
      (folder_ / "plaza.inc").string() +
          ": expected no file of that name or one of the export of the scene 'tuesday', got one of the export of the scene "
          "'monday' (write into another folder, give what the file is named after another name, or remove the file)");
  EXPECT_EQ(content(), before);
  // Before the work of large files is done.
  bool done = false;
  const exporting::FileSet large{{"plaza.inc"}, [&](const std::string& /*folder*/) { done = true; }};
  EXPECT_THROW(written_outputs({{}, {large}}, {"tuesday", "export", "1"}, folder_), InputError);
  EXPECT_FALSE(done);
  // Equal ones are nobody's alone; they stay as long as one scene has them.
  EXPECT_EQ(message({{"tuesday.pov", "t"}, {"glass.inc", "same"}}), "");
  EXPECT_TRUE(written({{"tuesday.pov", "t2"}}, {"tuesday", "export", "2"}, folder_).removed.empty());
  EXPECT_TRUE(fs::exists(folder_ / "glass.inc"));
  // Once it was taken away it is free.
  fs::remove(folder_ / "plaza.inc");
  EXPECT_EQ(message({{"plaza.inc", "t"}}), "");
}

// A scene of its name, wherever its file lies, replaces its own, as does one in a folder without notes.
TEST_F(Writing, FilesOfItsOwnAndOfNobodyAreReplaced) {
  write_file(folder_ / "s.json", "old");
  written({{"s.json", "1"}}, first_edition, folder_);
  written({{"s.json", "2"}}, second_edition, folder_);
  fs::remove(folder_ / notes_file);
  written({{"s.json", "3"}}, {"other", "export", "1"}, folder_);
  EXPECT_EQ(files(), (Files{{"s.json", "3"}}));
}

TEST_F(Writing, NotesAreTheSameForTheSameFiles) {
  written({{"s.json", "1"}}, first_edition, folder_ / "a");
  written({{"s.svg", "1"}}, first_edition, folder_ / "a");
  written({{"s.svg", "1"}, {"s.json", "1"}}, first_edition, folder_ / "b");
  EXPECT_EQ(content().at("a/.scenes.shatterpave"), content().at("b/.scenes.shatterpave"));
  EXPECT_EQ(content().at("a/.scenes.shatterpave").find(folder_.string()), std::string::npos);
}

TEST_F(Writing, NotesOfSomebodyElseAreWrongInput) {
  write_file(folder_ / notes_file, "{}");
  const Files before = content();
  EXPECT_THROW(written({{"s.json", "1"}}, first_edition, folder_), InputError);
  EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace shatterpave::pipeline
