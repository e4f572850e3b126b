#include "export/povray/sdl.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <limits>
#include <set>

#include "core/error.h"

namespace shatterpave::exporting::povray {
namespace {

TEST(Sdl, NumbersAreTheShortestThatReadBack) {
  EXPECT_EQ(number(0.1), "0.1");
  EXPECT_EQ(number(150.0), "150");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(-12.345), "-12.345");
  EXPECT_THROW(number(std::numeric_limits<double>::quiet_NaN()), BrokenInvariant);
  EXPECT_THROW(number(std::numeric_limits<double>::infinity()), BrokenInvariant);
}

RC_GTEST_PROP(Sdl, NumbersReadBackExactly, (double value)) {
  RC_PRE(std::abs(value) < 1e300);
  RC_ASSERT(std::strtod(number(value).c_str(), nullptr) == value);
}

// A right-handed triple must become a left-handed one: the determinant of the images of the axes is -1.
TEST(Sdl, PointsChangeHandedness) {
  EXPECT_EQ(lying_point({1.0, 2.0, 3.0}), "<1, 3, 2>");
  EXPECT_EQ(standing_point({1.0, 2.0, 3.0}), "<1, 2, -3>");
}

TEST(Sdl, IdentifiersAreValidAndDiffer) {
  const std::vector<std::string> result = identifiers({"a-b", "a_b", "a-b", "a_b_2", "1st", "N1st", "sphere", "-"});
  EXPECT_EQ(result[0], "a_b");
  EXPECT_EQ(std::set<std::string>(result.begin(), result.end()).size(), result.size());
  for (const std::string& identifier : result) {
    EXPECT_TRUE(std::isalpha(static_cast<unsigned char>(identifier.front())) || identifier.front() == '_') << identifier;
    EXPECT_EQ(identifier.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"),
              std::string::npos);
  }
}

TEST(Sdl, IncludeHasHeaderGuardAndVersion) {
  const IncludeHeader header{"pane.inc", {"First.", "Second."}, {"Declares:", "   pane_Slab  the slab"}, "pane"};
  EXPECT_EQ(include_text(header, "#declare pane_Slab = 1;\n"),
            "// Persistence of Vision Ray Tracer Include File\n"
            "// File: pane.inc\n"
            "// Vers: 3.7\n"
            "// Desc: First.\n"
            "//       Second.\n"
            "//\n"
            "// Declares:\n"
            "//    pane_Slab  the slab\n"
            "\n"
            "#ifndef(pane_Inc_Temp)\n"
            "#declare pane_Inc_Temp = version;\n"
            "#version 3.7;\n"
            "\n"
            "#declare pane_Slab = 1;\n"
            "\n"
            "#version pane_Inc_Temp;\n"
            "#end\n");
}

}  // namespace
}  // namespace shatterpave::exporting::povray
