#include "core/error.h"

#include <gtest/gtest.h>

#include "core/embedded.h"

namespace shatterpave {
namespace {

std::string text_of(const Place& place) { return InputError(place, "expected 1, got 2").what(); }

TEST(InputError, NamesThePlaceAsFarAsItIsKnown) {
  EXPECT_EQ(text_of({"a.toml", 14, 3, "pane[0].size_mm"}), "a.toml:14:3: pane[0].size_mm: expected 1, got 2");
  EXPECT_EQ(text_of({"a.toml", 0, 0, ""}), "a.toml: expected 1, got 2");
  EXPECT_EQ(text_of({"", 0, 0, "--size"}), "--size: expected 1, got 2");
  EXPECT_EQ(text_of({}), "expected 1, got 2");
}

TEST(Ensure, ThrowsInEveryBuild) {
  EXPECT_NO_THROW(ENSURE(1 + 1 == 2));
  try {
    ENSURE(1 + 1 == 3);
    FAIL() << "nothing was thrown";
  } catch (const BrokenInvariant& error) {
    EXPECT_NE(std::string(error.what()).find("1 + 1 == 3"), std::string::npos);
  }
}

TEST(EmbeddedFiles, AreThoseOfTheTemplates) {
  EXPECT_FALSE(embedded_files().empty());
  for (const EmbeddedFile& file : embedded_files()) EXPECT_EQ(embedded_text(file.name), file.text);
  EXPECT_THROW(static_cast<void>(embedded_text("no such file")), BrokenInvariant);
}

}  // namespace
}  // namespace shatterpave
