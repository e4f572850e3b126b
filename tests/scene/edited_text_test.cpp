// Values changed in a text: what is changed is the value alone, and the rest keeps its bytes.
#include "scene/toml/edited_text.h"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/toml/apply_override.h"

namespace shatterpave::scene {

namespace {

std::string text_with(std::string_view text, const std::string& key, const std::string& value) {
  return edited_text(text, "scene.toml", {{"test", key, value}});
}

struct EditCase {
  std::string_view what;
  std::string_view before;
  std::string_view key;
  std::string_view value;
  std::string_view after;
};

const std::vector<EditCase> edit_cases = {
    {"a value before a comment", "seed = 7   # lucky\n", "seed", "8", "seed = 8   # lucky\n"},
    {"in an array of tables, by name", "[[pane]]\nname = 'a'\nx = 1\n[[pane]]\nname = 'b'\nx = 2 # two\n", "pane.b.x", "3.5",
     "[[pane]]\nname = 'a'\nx = 1\n[[pane]]\nname = 'b'\nx = 3.5 # two\n"},
    {"a dotted key", "a.b.c = 1\na.b.d = 2\n", "a.b.c", "9", "a.b.c = 9\na.b.d = 2\n"},
    {"a new one beside dotted keys", "a.b.c = 1\na.b.d = 2 # d\n\n[e]\nf = 1\n", "a.b.g", "3",
     "a.b.c = 1\na.b.d = 2 # d\na.b.g = 3\n\n[e]\nf = 1\n"},
    {"a new table beside dotted keys", "a.b = 1\n[e]\n", "a.c.d", "3", "a.b = 1\na.c.d = 3\n[e]\n"},
    {"an inline table", "p = {x = 1, y = 2} # p\n", "p.y", "5", "p = {x = 1, y = 5} # p\n"},
    {"a new key of an inline table", "p = {x = 1 }\n", "p.y", "5", "p = {x = 1, y = 5 }\n"},
    {"of an empty one", "p = { }\n", "p.y", "5", "p = {y = 5}\n"},
    {"of one in an array", "p = [{at = [1, 2]}, {at = [3, 4]}]\n", "p[1].n", "5",
     "p = [{at = [1, 2]}, {at = [3, 4], n = 5}]\n"},
    {"a table within an inline table", "p = {x = 1}\n", "p.q.r", "5", "p = {x = 1, q.r = 5}\n"},
    {"an array over lines", "a = [1, # one\n     2,\n]  # end\nb = 3\n", "a", "[4, 5]", "a = [4, 5]  # end\nb = 3\n"},
    {"one number of it", "a = [1, # one\n     2,\n]\n", "a[1]", "7", "a = [1, # one\n     7,\n]\n"},
    {"line ends of Windows", "[a]\r\nx = 1\r\n\r\n[b]\r\ny = 2\r\n", "a.z", "3",
     "[a]\r\nx = 1\r\nz = 3\r\n\r\n[b]\r\ny = 2\r\n"},
    {"no final line end", "[a]\nx = 1", "a.z", "3", "[a]\nx = 1\nz = 3"},
    {"no final line end, a new table", "[a]\nx = 1", "b.z", "3", "[a]\nx = 1\n\n[b]\nz = 3"},
    {"columns and indents", "[a]\n  name   = 'n'\n  size_x = 2 # s\n\n[b]\n", "a.z", "3",
     "[a]\n  name   = 'n'\n  size_x = 2 # s\n  z      = 3\n\n[b]\n"},
    {"a table of an element", "[[pane]]\nx = 1 # one\n\n[[pane.impact]]\nat = 1\n\n[[pane]]\nx = 2\n", "pane[0].growth.apex",
     "5", "[[pane]]\nx = 1 # one\n\n[pane.growth]\napex = 5\n\n[[pane.impact]]\nat = 1\n\n[[pane]]\nx = 2\n"},
    {"of the last element", "[[pane]]\nx = 1\n[[pane]]\nx = 2\n", "pane[1].growth.apex", "5",
     "[[pane]]\nx = 1\n[[pane]]\nx = 2\n\n[pane.growth]\napex = 5\n"},
    {"a table that a header implies", "[[pane]]\nx = 1\n\n# deep\n[pane.a.b]\ny = 2\n", "pane[0].a.z", "5",
     "[[pane]]\nx = 1\n\n[pane.a]\nz = 5\n\n# deep\n[pane.a.b]\ny = 2\n"},
    {"a key of the root before all headers", "# A window.\n\n[[pane]]\nx = 1\n", "seed", "8",
     "# A window.\n\nseed = 8\n\n[[pane]]\nx = 1\n"},
    {"a key of an empty text", "", "seed", "8", "seed = 8\n"},
    {"a header without keys", "[a]  # empty\n[b]\nx = 1\n", "a.z", "3", "[a]  # empty\nz = 3\n[b]\nx = 1\n"},
    {"a text that is quoted", "a = 1\n", "a", "half \"open\"", "a = \"half \\\"open\\\"\"\n"},
    {"a value with a comment behind it", "p = {x = 1}\n", "p.x", "2 # two", "p = {x = 2}\n"},
    {"letters of more than a byte", "n = \"Größe\" # übergroß\nx = 1\n", "n", "'Maß'", "n = 'Maß' # übergroß\nx = 1\n"},
    {"behind letters of more than a byte", "p = {n = \"Größe\", x = 1} # ö\n", "p.x", "2", "p = {n = \"Größe\", x = 2} # ö\n"},
    {"a text over lines", "t = '''a\n[b]\n'''\nx = 1\n[c]\n", "y", "2", "t = '''a\n[b]\n'''\nx = 1\ny = 2\n[c]\n"},
    {"spaces in a header", "[ a . b ]\nx = 1\n", "a.b.y", "2", "[ a . b ]\nx = 1\ny = 2\n"},
    {"quoted keys", "\"a\".\"b\" = 1\n", "a.b", "2", "\"a\".\"b\" = 2\n"},
    {"lists of lists are values", "h = [[[1, 2], [3, 4]]]\n[t]\n", "k", "1", "h = [[[1, 2], [3, 4]]]\nk = 1\n[t]\n"},
};

}  // namespace

TEST(EditedText, ChangesTheValueAlone) {
  for (const EditCase& edit : edit_cases) {
    EXPECT_EQ(text_with(edit.before, std::string(edit.key), std::string(edit.value)), edit.after) << edit.what;
  }
}

TEST(EditedText, KeepsAByteOrderMark) { EXPECT_EQ(text_with("\xEF\xBB\xBFx = 1\n", "x", "2"), "\xEF\xBB\xBFx = 2\n"); }

TEST(EditedText, MakesSeveralChanges) {
  const std::string text = edited_text("a = 1\n", "f", {{"", "a", "2"}, {"", "b.c", "3"}, {"", "b.d", "4"}, {"", "a", "5"}});
  EXPECT_EQ(text, "a = 5\n\n[b]\nc = 3\nd = 4\n");
}

TEST(EditedText, RefusesWhatLeadsNowhere) {
  EXPECT_THROW(text_with("[[pane]]\n", "pane[1].x", "1"), InputError);
  EXPECT_THROW(text_with("[[pane]]\n", "pane", "1"), InputError);
  EXPECT_THROW(text_with("[a]\n", "a", "1"), InputError);
  EXPECT_THROW(text_with("a = 1\n", "a.b", "1"), InputError);
  EXPECT_THROW(text_with("a = \n", "a", "1"), InputError);
  EXPECT_THROW(text_with("a = 1\n", "b[0].c", "1"), InputError);
}

// Every value and every table of the text gets a new value, one at a time: parsed, it is what the override makes of it (which
// edited_text looks at itself), and no line but those of the value is another.
TEST(EditedText, TakesEveryPlaceOfAText) {
  const std::string text =
      "# top\nseed = 1\na.b = [ 1,\n 2 ] # ab\nq = {r = {s = 1}, t = []}\n\n[still] # still\nx = true\n\n"
      "[[pane]]\nname = \"w\"\n[pane.growth.deep]\ny = 1\n[[pane.impact]]\nat = [1, 2]\n[[pane.impact]]\n\n[[pane]]\nname = "
      "\"v\"\n";
  const std::vector<std::string> tables = {"",
                                           "a.",
                                           "q.",
                                           "q.r.",
                                           "still.",
                                           "new.",
                                           "pane[0].",
                                           "pane.v.",
                                           "pane.w.growth.",
                                           "pane[0].growth.deep.",
                                           "pane[1].growth.",
                                           "pane.w.impact[1].",
                                           "pane[0].impact[0].",
                                           "pane[0].new.more."};
  for (const std::string& table : tables) {
    const std::string once = text_with(text, table + "fresh", "1.25");
    EXPECT_NE(once.find("fresh = 1.25"), std::string::npos) << table;
    EXPECT_EQ(text_with(once, table + "fresh", "2").size(), once.size() - 3) << table;
  }
}

}  // namespace shatterpave::scene
