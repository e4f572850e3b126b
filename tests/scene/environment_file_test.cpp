#include "scene/environment_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

namespace fs = std::filesystem;

// Blender's data as Debian has it and as others have, where programs are told to look.
class EnvironmentFile : public support::FolderTest {
 protected:
  void SetUp() override {
    write(folder_ / "debian/blender/datafiles/studiolights/world/meadow.exr", exr + "debian");
    write(folder_ / "others/blender/3.4/datafiles/studiolights/world/harbour.exr", exr + "3.4");
    write(folder_ / "others/blender/4.2/datafiles/studiolights/world/harbour.exr", exr + "4.2");
    write(folder_ / "scenes/sky.hdr", "#?RADIANCE\n");
    write(folder_ / "scenes/sky.png", "\x89PNG\r\n\x1a\n");
    write(folder_ / "scenes/text.exr", "words");
    ::setenv("XDG_DATA_DIRS", ((folder_ / "debian").string() + ":relative:" + (folder_ / "others").string()).c_str(), 1);
  }
  void TearDown() override { ::unsetenv("XDG_DATA_DIRS"); }

  static void write(const fs::path& file, const std::string& content) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
  }
  studio::Environment named(const std::string& asked) const {
    return environment_named(asked, folder_ / "scenes/s.toml", Place{"s.toml", 7, 3, "light.environment"});
  }
  std::string refusal(const std::string& asked) const {
    try {
      named(asked);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  inline static const std::string exr = "\x76\x2f\x31\x01";
};

TEST_F(EnvironmentFile, NamesAreThoseInstalled) {
  EXPECT_EQ(*named("meadow").content, exr + "debian");
  EXPECT_EQ(named("meadow").ending, "exr");
  EXPECT_EQ(*named("harbour").content, exr + "4.2") << "the newest";
}

TEST_F(EnvironmentFile, FilesStandBesideTheScene) {
  EXPECT_EQ(named("sky.hdr").ending, "hdr");
  EXPECT_EQ(named("./sky.png").ending, "png");
  EXPECT_EQ(named((folder_ / "scenes/sky.png").string()).ending, "png");
}

TEST_F(EnvironmentFile, AnUnknownNameIsToldBesideTheNearestOne) {
  const std::string message = refusal("medow");
  EXPECT_EQ(message.find("s.toml:7:3: light.environment: expected the name of a lat-long picture (EXR, HDR or PNG), or "), 0U);
  EXPECT_NE(message.find("harbour"), std::string::npos);
  EXPECT_NE(message.find("got \"medow\"; did you mean meadow?"), std::string::npos) << message;
}

TEST_F(EnvironmentFile, FilesThatAreMissingOrNoPictureAreRefused) {
  EXPECT_EQ(refusal("none.exr"),
            "s.toml:7:3: light.environment: expected a file, got none of that name: " + (folder_ / "scenes/none.exr").string());
  EXPECT_EQ(refusal("text.exr"), "s.toml:7:3: light.environment: expected an EXR, HDR or PNG picture, got another file: " +
                                     (folder_ / "scenes/text.exr").string());
  EXPECT_NE(refusal("../scenes").find("got a folder"), std::string::npos);
}

TEST_F(EnvironmentFile, TooLargeAFileIsRefusedAndNotTakenIn) {
  const fs::path file = folder_ / "scenes/large.exr";
  write(file, exr);
  fs::resize_file(file, largest_environment_bytes + 1);
  EXPECT_NE(refusal("large.exr").find("expected a file of at most 256 MiB, got a larger one"), std::string::npos);
}

TEST_F(EnvironmentFile, WhatIsInThePictureIsPartOfTheScenesFingerprint) {
  const std::string text =
      "pane = [{name = \"w\", size_mm = [300, 300], impact = [{at_mm = [9, 9]}]}]\nlight.environment = \"sky.hdr\"\n";
  const fs::path file = folder_ / "scenes/s.toml";
  const Scene one = scene_of_text(text, file);
  write(folder_ / "scenes/sky.hdr", "#?RADIANCE\nother");
  const Scene other = scene_of_text(text, file);
  EXPECT_NE(one.fingerprint, other.fingerprint);
  EXPECT_FALSE(one == other);
  write(folder_ / "scenes/sky.hdr", "#?RADIANCE\n");
  EXPECT_EQ(scene_of_text(text, file).fingerprint, one.fingerprint);
}

}  // namespace
}  // namespace shatterpave::scene
