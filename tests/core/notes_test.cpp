#include "core/notes.h"

#include <gtest/gtest.h>

namespace shatterpave {
namespace {

TEST(Notes, AreALineWithTheirPlaceAndStandOnce) {
  const Note note{Place{"a.toml", 3, 1, "pane[0].x_mm"}, "has no effect"};
  EXPECT_EQ(located(note), "a.toml:3:1: pane[0].x_mm: note: has no effect");
  EXPECT_EQ(located(Note{{}, "nothing was laid"}), "note: nothing was laid");
  std::vector<Note> notes;
  add_note(note, notes);
  add_note({Place{"a.toml", 4, 1, "pane[0].x_mm"}, "has no effect"}, notes);
  add_note(note, notes);
  EXPECT_EQ(notes.size(), 2U);
}

}  // namespace
}  // namespace shatterpave
