// The file of a scene that is shown: what a page may set, and how it is written.
#include "serve/scene_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace shatterpave::serve {

namespace {

namespace fs = std::filesystem;

const std::string shown_scene =
    "# A window.\nseed = 7  # lucky\n\n[[pane]]\nname         = \"window\"\nsize_mm      = [400, 300]\nthickness_mm = 2.0 # "
    "mm\n"
    "[[pane.impact]]\nat_mm = [168, 165]\n";

class ShownFile : public support::FolderTest {
 protected:
  ShownFile() { write(shown_scene); }

  void write(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }
  std::string content() const {
    std::ostringstream text;
    text << std::ifstream(file_, std::ios::binary).rdbuf();
    return std::move(text).str();
  }
  // As many editors write: another file takes the name.
  void replace(const std::string& text) const {
    const fs::path other = folder_ / "other";
    std::ofstream(other, std::ios::binary) << text;
    fs::rename(other, file_);
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const fs::path file_ = folder_ / "scene.toml";
};

// Looks twice: what changes is read when it has come to rest.
bool reloaded(SceneFile& file) {
  const bool at_once = file.reload();
  return file.reload() || at_once;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(ShownFile, WritesTheChangedValuesAlone) {
  ::chmod(file_.c_str(), 0640);
  SceneFile file(file_);
  file.set("pane[0].thickness_mm", "3.5");
  file.set("seed", "8");
  file.set("seed", "9");
  EXPECT_EQ(content(), shown_scene);
  file.save();
  EXPECT_EQ(content(), with(with(shown_scene, "2.0 # mm", "3.5 # mm"), "7  # lucky", "9  # lucky"));
  EXPECT_TRUE(file.changes().empty());
  EXPECT_FALSE(reloaded(file));
  EXPECT_EQ(file_count(), 1U);
  struct stat found {};
  ASSERT_EQ(::stat(file_.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 07777U, 0640U);
}

TEST_F(ShownFile, WritesWhatALinkLeadsTo) {
  const fs::path link = folder_ / "link.toml";
  fs::create_symlink("scene.toml", link);
  SceneFile file(link);
  file.set("seed", "9");
  file.save();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(), with(shown_scene, "7  # lucky", "9  # lucky"));
}

TEST_F(ShownFile, RefusesToWriteOverWhatItHasNotRead) {
  SceneFile file(file_);
  file.set("seed", "9");
  const std::string other = with(shown_scene, "# A window.", "# Another window.");
  replace(other);
  EXPECT_THROW(file.save(), InputError);
  EXPECT_EQ(content(), other);
  EXPECT_EQ(file_count(), 1U);
  EXPECT_TRUE(reloaded(file));
  file.save();
  EXPECT_EQ(content(), with(other, "7  # lucky", "9  # lucky"));
}

TEST_F(ShownFile, ReadsFilesThatTakeItsName) {
  SceneFile file(file_);
  EXPECT_FALSE(reloaded(file));
  replace(with(shown_scene, "2.0", "2.5"));
  EXPECT_TRUE(reloaded(file));
  EXPECT_NE(file.text().find("2.5"), std::string::npos);
  fs::remove(file_);
  EXPECT_THROW(reloaded(file), InputError);
  EXPECT_NE(file.text().find("2.5"), std::string::npos);
  write(shown_scene);
  EXPECT_TRUE(reloaded(file));
}

// An editor that writes over the file empties it first.
TEST_F(ShownFile, WaitsUntilTheFileIsWhole) {
  SceneFile file(file_);
  write("");
  EXPECT_FALSE(file.reload());
  write(with(shown_scene, "2.0", "2.5"));
  EXPECT_FALSE(file.reload());
  EXPECT_FALSE(file.text().empty());
  EXPECT_TRUE(file.reload());
  EXPECT_NE(file.text().find("2.5"), std::string::npos);
}

// Of two that change a value the later one wins.
TEST_F(ShownFile, DropsWhatTheFileSaysAnew) {
  SceneFile file(file_);
  file.set("seed", "9");
  file.set("pane[0].thickness_mm", "3");
  replace(with(shown_scene, "2.0 # mm", "2.5 # mm"));
  ASSERT_TRUE(reloaded(file));
  ASSERT_EQ(file.changes().size(), 1U);
  EXPECT_EQ(file.changes().front().key, "seed");
  replace("seed = [broken");
  ASSERT_TRUE(reloaded(file));
  EXPECT_EQ(file.changes().size(), 1U);
  replace(with(shown_scene, "seed = 7", "seed = 10"));
  ASSERT_TRUE(reloaded(file));
  EXPECT_TRUE(file.changes().empty());
}

TEST_F(ShownFile, LetsNoPageNameFilesOrThings) {
  SceneFile file(file_);
  for (const char* key :
       {"light.environment", "pavement[0].outline_file", "pane[0].cracks_file", "pane[0].name", "pane[0].outline_mm", "pane",
        "pane[0].impact", "frames.key", "no_such_key", "", "pane[0].", "seed; import os"}) {
    EXPECT_THROW(file.set(key, "\"/etc/passwd\""), InputError) << key;
  }
  EXPECT_TRUE(file.changes().empty());
}

TEST_F(ShownFile, ClearsWhatAKilledSaveHasLeft) {
  const fs::path left = folder_ / ".scene.toml.shatterpave-save";
  std::ofstream(left) << "half";
  const SceneFile file(file_);
  EXPECT_FALSE(fs::exists(left));
}

TEST_F(ShownFile, RefusesWhatIsNoFile) {
  for (const fs::path& path : {folder_, folder_ / "none.toml", fs::path("-")}) {
    EXPECT_THROW(static_cast<void>(SceneFile{path}), InputError) << path;
  }
}

}  // namespace

}  // namespace shatterpave::serve
