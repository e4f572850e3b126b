// The sheet to print; what is drawn on it is measured by tests/scripts/quantities_test.sh.
#include "export/svg/sheet_svg.h"

#include <gtest/gtest.h>

#include <string>

#include "core/error.h"
#include "paving/laying.h"

namespace shatterpave::exporting::svg {
namespace {

Model paved(vec2 size_mm, int pavements) {
  Model model;
  model.name = "scene";
  for (int i = 0; i < pavements; ++i) {
    paving::Pavement pavement;
    pavement.name = "p" + std::to_string(i);
    pavement.area.outline = {{0, 0}, {size_mm.x, 0}, size_mm, {0, size_mm.y}};
    pavement.stone_mm = {200, 100};
    pavement.bonding.bond = paving::Bond::running;
    model.pavements.push_back({pavement, paving::laid_stones(pavement, 5)});
  }
  return model;
}

std::string paper_of(const std::string& svg) {
  const std::size_t at = svg.find(" on A") + 4;
  return svg.substr(at, svg.find(';', at) - at);
}

// Of A4, lying, 297 x 210 mm: margins of 10 mm, and a column of 92 mm for the words with 6 mm beside it. What is just as large
// as what is left fits.
TEST(SheetSvg, IsTheSmallestPaperThatHoldsThePlan) {
  EXPECT_EQ(paper_of(sheet(paved({1790, 1900}, 1), 10.0).content), "A4");
  EXPECT_EQ(paper_of(sheet(paved({1791, 1900}, 1), 10.0).content), "A3");
  EXPECT_EQ(paper_of(sheet(paved({1790, 1901}, 1), 10.0).content), "A3");
  EXPECT_EQ(paper_of(sheet(paved({1790, 1900}, 1), 20.0).content), "A4");
  EXPECT_THROW(static_cast<void>(sheet(paved({1790, 1900}, 1), 1.0)), InputError);
}

// Two rows for each pavement, as many as there is room for; the others are told by their number.
TEST(SheetSvg, TellsHowManyRowsAreLeftOut) {
  for (const int count : {1, 3, 12, 15, 16, 17, 18, 40}) {
    const std::string svg = sheet(paved({400, 300}, count), 10.0).content;
    ASSERT_EQ(paper_of(svg), "A4");
    int shown = 0;
    for (int i = 0; i < count; ++i) {
      const std::string name = ">p" + std::to_string(i);
      shown += svg.find(name + " field<") != std::string::npos ? 1 : 0;
      shown += svg.find(name + " joints<") != std::string::npos ? 1 : 0;
    }
    const std::size_t more = svg.find(">and ");
    const int left_out = more == std::string::npos ? 0 : std::stoi(svg.substr(more + 5));
    EXPECT_EQ(shown + left_out, 2 * count);
    EXPECT_EQ(left_out > 0, count > 16) << "33 rows fit";
    // The last line stands on the paper.
    const std::size_t last = svg.rfind(" y=\"");
    EXPECT_LE(std::stod(svg.substr(last + 4)), 200.0);
  }
}

}  // namespace
}  // namespace shatterpave::exporting::svg
