#include "core/words.h"

#include <gtest/gtest.h>

#include <string>

namespace shatterpave {
namespace {

const std::vector<std::string_view> commands = {"export", "check", "measure", "render"};

TEST(Nearest, FindsASlip) {
  EXPECT_EQ(nearest("exprot", commands), "export");  // letters that changed places
  EXPECT_EQ(nearest("chek", commands), "check");
  EXPECT_EQ(nearest("rendeer", commands), "render");
  EXPECT_EQ(nearest("meassure", commands), "measure");
  EXPECT_EQ(nearest("export", commands), "export");
}

TEST(Nearest, FindsABeginning) {
  EXPECT_EQ(nearest("thick", {"thickness_mm", "preset"}), "thickness_mm");
  EXPECT_EQ(nearest("out", {"outline_mm", "outline_file"}), "");  // two of them
  EXPECT_EQ(nearest("th", {"thickness_mm"}), "");
}

TEST(Nearest, LeavesOtherWordsAlone) {
  EXPECT_EQ(nearest("frobnicate", commands), "");
  EXPECT_EQ(nearest("", commands), "");
  EXPECT_EQ(nearest("xy", {"ab"}), "");  // two edits, but nothing is alike
  EXPECT_EQ(nearest(std::string(1000, 'e'), commands), "");
  EXPECT_EQ(nearest("export", {}), "");
}

TEST(Listed, PutsAWordBeforeTheLast) {
  EXPECT_EQ(listed({}, "or"), "");
  EXPECT_EQ(listed({"a"}, "or"), "a");
  EXPECT_EQ(listed({"a", "b"}, "or"), "a or b");
  EXPECT_EQ(listed({"a", "b", "c"}, "and"), "a, b and c");
}

TEST(Hint, NamesTheOneOrAll) {
  EXPECT_EQ(hint("sed", {"seed", "plan"}), "did you mean seed?");
  EXPECT_EQ(hint("zzz", {"seed", "plan"}), "there are seed and plan");
  EXPECT_EQ(hint("zzz", {"cone_deg"}), "there is cone_deg");
  EXPECT_EQ(hint("zzz", {}), "there are none");
}

}  // namespace
}  // namespace shatterpave
