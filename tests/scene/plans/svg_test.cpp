// SVG as drawing programs show it, by values that follow from the drawing; svg_rendering_test.cpp compares with a rasteriser.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/plans/plan_areas.h"

namespace shatterpave::scene {
namespace {

using geometry::Region;

const double half_turn = std::acos(-1.0);

std::string page(const std::string& body, const std::string& attributes = "") {
  return R"x(<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="120mm" viewBox="0 0 120 120" )x" + attributes + ">" +
         body + "</svg>";
}

struct Read {
  double area_m2 = 0.0;
  std::size_t holes = 0;
  std::size_t regions = 0;
  std::vector<Note> notes;
};

// What is read of a drawing in 1:100.
Read read(const std::string& bytes, const std::string& id = "") {
  const Plan plan = plan_of_svg(bytes, "a.svg", 100.0);
  ShapeChoice choice;
  if (!id.empty()) choice.shapes = {id};
  Read result;
  result.notes = plan.notes;
  const auto shapes = chosen_shapes(plan, {ShapeKind::area}, choice, id.empty() ? ByDefault::the_only_feature : ByDefault::all);
  for (const Region& region : merged(regions_of(plan, shapes, {}, 0.0, &result.notes))) {
    result.area_m2 += geometry::area(region) * 1e-6;
    result.holes += region.holes.size();
    ++result.regions;
  }
  return result;
}

std::string error(const std::string& bytes, const std::string& id = "") {
  try {
    read(bytes, id);
  } catch (const InputError& found) {
    return found.what();
  }
  return "no error";
}

void expect(const std::string& bytes, double area_m2, std::size_t holes, const std::string& id = "") {
  const Read found = read(bytes, id);
  EXPECT_NEAR(found.area_m2, area_m2, 1e-4 * area_m2) << bytes;
  EXPECT_EQ(found.holes, holes) << bytes;
}

const std::string frame = R"x(<path id="a" d="M10 10h80v80h-80z M30 30h40v40h-40z"/>)x";

TEST(SvgShown, TheRootHandsOnWhatItSays) {
  expect(page(frame, R"x(style="fill-rule:evenodd")x"), 48.0, 1);
  expect(page(frame, R"x(fill-rule="evenodd" transform="scale(0.5)")x"), 12.0, 1);
  expect(page(R"x(<g fill-rule="nonzero" style="fill-rule:evenodd !important">)x" + frame + "</g>"), 48.0, 1);
  EXPECT_EQ(error(page(frame, R"x(style="display:none")x")), "a.svg: expected a closed shape, got none");
}

TEST(SvgShown, StyleSheets) {
  const std::string bed = R"x(<rect class="off bed" x="95" width="9" height="9"/>)x";
  const std::string classed = R"x(<path id="a" class="eo" d="M10 10H110V110H10Z M20 20H50V50H20Z"/>)x";
  expect(page("<style>.off{display:none} .eo{fill-rule:evenodd}</style>" + classed + bed), 91.0, 1);
  expect(page("<style>.eo{fill-rule:nonzero} path.eo{fill-rule:evenodd} path{fill-rule:nonzero}</style>" + classed), 91.0, 1);
  expect(page("<style>#a{fill-rule:nonzero} .eo{fill-rule:evenodd !important}</style>" + classed), 91.0, 1);
  expect(page("<style>@media screen, print{path{fill-rule:evenodd}} @media print{path{display:none}}</style>" + classed), 91.0,
         1);
  expect(page("<style media=\"print\">path{display:none}</style><style type=\"text/x\">path{display:none}</style>" + classed),
         100.0, 0);
  expect(page("<style>/* } */ svg > .eo:first-child , x { FILL-RULE : evenodd ; ; x:y }</style><g>" + classed + "</g>"), 100.0,
         0);
  EXPECT_EQ(error(page("<style>path:nth-child(2){display:none}</style>" + classed)).substr(0, 22), "a.svg:1:94: style: exp");
  const Read imported = read(page("<style>@import url(a.css);</style>" + classed));
  ASSERT_EQ(imported.notes.size(), 1U);
}

TEST(SvgShown, ClipPathsAndViewportsCut) {
  const std::string circle = R"x(<clipPath id="c"><circle cx="60" cy="60" r="30"/></clipPath>)x";
  const std::string square = R"x(<rect id="a" x="10" y="10" width="100" height="100" clip-path="url(#c)"/>)x";
  expect(page(circle + square), half_turn * 9.0, 0);
  // Children of a clip path overlap without a hole, whichever way they wind.
  expect(page(R"x(<clipPath id="c"><rect x="10" y="10" width="20" height="20"/><path d="M10 20V50H25V20Z"/></clipPath>)x" +
              square),
         7.0, 0);
  expect(
      page(
          R"x(<clipPath id="d"><rect width="60" height="120"/></clipPath><clipPath id="c" clip-path="url(#d)"><circle cx="60" cy="60" r="30"/></clipPath>)x" +
          square),
      half_turn * 4.5, 0);
  expect(
      page(
          R"x(<clipPath id="d"><rect width="60" height="120"/></clipPath><clipPath id="c"><circle clip-path="url(#d)" cx="60" cy="60" r="30"/></clipPath>)x" +
          square),
      half_turn * 4.5, 0);
  expect(
      page(
          R"x(<clipPath id="c" clipPathUnits="objectBoundingBox"><rect width=".5" height=".5"/></clipPath><g transform="rotate(20)">)x" +
          square + "</g>"),
      25.0, 0);
  expect(
      page(
          R"x(<clipPath id="c" clipPathUnits="objectBoundingBox"><rect width=".5" height=".5"/></clipPath><g clip-path="url(#c)"><g clip-path="url(#c)">)x" +
          square + "</g></g>"),
      25.0, 0);
  expect(page(R"x(<svg x="10" y="10" width="50" height="40"><rect id="a" x="-5" y="-5" width="100" height="100"/></svg>)x"),
         20.0, 0);
  expect(page(R"x(<svg width="50" height="40" overflow="visible"><rect id="a" width="100" height="100"/></svg>)x"), 100.0, 0);
  expect(
      page(
          R"x(<symbol id="s" viewBox="0 0 10 10"><rect width="40" height="10"/></symbol><use id="a" href="#s" width="20" height="20"/>)x"),
      4.0, 0);
}

TEST(SvgShown, WhatCutsBeyondThisReaderIsRefusedWhereItIsTaken) {
  const std::string other = R"x(<rect id="b" width="10" height="10"/>)x";
  const std::string masked = page(R"x(<rect id="a" mask="url(#m)" width="10" height="10"/>)x" + other);
  EXPECT_EQ(error(masked, "a"), "a.svg:1:94: rect#a: expected no mask, got one");
  expect(masked, 1.0, 0, "b");
  const std::string by_shape = page(R"x(<rect id="a" style="clip-path:circle(5px)" width="10" height="10"/>)x");
  EXPECT_EQ(error(by_shape), "a.svg:1:94: rect#a: expected a clip path as url(#id), got \"circle(5px)\"");
  const std::string styled = page(R"x(<path id="a" d="M0 0h10v10z" style="d:path('M0 0h20v20z')"/>)x");
  EXPECT_NE(error(styled, "a").find("path#a: expected a path in the attribute d, got \"path("), std::string::npos);
  expect(page(R"x(<path id="a" d=" M0 0h10v10h-10z "/>)x"), 1.0, 0);
  const std::string lost = page(R"x(<rect id="a" clip-path="url(#none)" filter="url(#f)" width="10" height="10"/>)x");
  expect(lost, 1.0, 0);
  EXPECT_EQ(read(lost).notes.size(), 2U);
  const Read labelled = read(page(R"x(<g id="a"><text>Bed</text><rect width="10" height="10"/></g>)x"), "a");
  ASSERT_EQ(labelled.notes.size(), 1U);
  EXPECT_EQ(labelled.notes[0].what, "<text> is no shape and is not read");
}

TEST(SvgShown, FillClosesWhatIsOpen) {
  expect(page(R"x(<path id="a" d="M15 10H105V110H15Z M45 40V80H75V40"/>)x"), 78.0, 1);
  expect(page(R"x(<path d="M15 10H105V110H15"/>)x"), 90.0, 0);
  // Not filled, an open subpath is a line.
  expect(page(R"x(<path fill="none" d="M15 10H105V110H15Z M45 40V80H75V40"/>)x"), 90.0, 0);
  EXPECT_EQ(error(page(R"x(<path fill="none" d="M15 10H105V110H15"/>)x")), "a.svg: expected a closed shape, got none");
  // A closed one that nobody asked for by name goes before.
  expect(page(R"x(<rect width="10" height="10"/><path d="M15 10H105V110H15"/>)x"), 1.0, 0);
  // Missing its start by a thousandth.
  const std::string nearly = R"x(d="m 20.3,20.3 26.667,0 26.667,0 0,53.333 -53.333,0 0,-53.334 m 10,10 0,15 15,0 0,-15 z")x";
  expect(page("<path " + nearly + "/>"), 26.194, 1);
  expect(page("<path fill=\"none\" " + nearly + "/>"), 26.194, 1);
  // A gap that is seen is meant, however long the line is.
  EXPECT_EQ(error(page(R"x(<path fill="none" d="M15 10H105V110H15V11"/>)x")), "a.svg: expected a closed shape, got none");
}

TEST(SvgShown, SubpathsMayCrossAndAdjoin) {
  expect(page(R"x(<path d="M10 10H70V70H10Z M50 50H110V110H50Z M10 70H30V110H10Z"/>)x"), 76.0, 0);
  expect(page(R"x(<path fill-rule="evenodd" d="M10 10H70V70H10Z M50 50H110V110H50Z"/>)x"), 64.0, 0);
  expect(page(R"x(<polygon points="0,0 30,30 30,0 0,30"/>)x"), 4.5, 0);
  // A hole along the outline, and a keyhole.
  expect(page(R"x(<path d="M10 10H50V50H10Z M10 20V30H20V20Z"/>)x"), 15.0, 0);
  expect(page(R"x(<path d="M10 10H30V20H20V40H40V20H30V10H50V50H10Z"/>)x"), 12.0, 1);
  EXPECT_EQ(error(page(R"x(<path d="M10 10H50Z"/>)x")), "a.svg:1:94: path: expected 3 or more distinct points, got 2");
}

TEST(SvgShown, LinesOfAGroupThatMeetAreAnOutline) {
  const std::string sides =
      R"x(<path d="M15 15H90"/><path d="M90 15A30 30 0 0 1 90 75"/><path d="M90 75H15"/><path d="M15 75V15"/>)x";
  const double area = 45.0 + half_turn * 4.5;
  expect(page(R"x(<g id="a">)x" + sides + "</g>"), area, 0, "a");
  expect(page(sides), area, 0);
  // In any order and direction, drawn as lines, with a gap of 0.01 mm on the page and a line that ends nowhere.
  expect(page(R"x(<g id="a" fill="none"><line x1="10" y1="10" x2="60" y2="10"/><line x1="10" y1="60" x2="60.01" y2="60"/>)x"
              R"x(<polyline points="10 10 10 60"/><path d="M60 60V10"/><line x1="60" y1="60" x2="90" y2="90"/></g>)x"),
         25.0, 0, "a");
  // Two loops: one in the other.
  expect(page(R"x(<path fill="none" d="M10 10H60 M60 10V60 M60 60H10 M10 60V10 M20 20H30 M30 20V30 M30 30H20 M20 30V20"/>)x"),
         24.0, 1);
  EXPECT_EQ(error(page(R"x(<g id="a" fill="none"><path d="M10 10H60"/><path d="M60 11V60L10 10"/></g>)x"), "a"),
            "a.svg: expected a closed shape, got none");
}

TEST(SvgShown, UseSizesWhatItRefersTo) {
  const std::string unit =
      R"x(<defs><svg id="s" width="10" height="10" viewBox="0 0 10 10"><rect width="10" height="10"/></svg></defs>)x";
  expect(page(unit + R"x(<use id="a" href="#s" width="40" height="30"/>)x"), 9.0, 0);
  expect(page(unit + R"x(<use id="a" href="#s"/>)x"), 1.0, 0);
}

std::string utf16(const std::string& ascii, bool little, bool mark) {
  std::string bytes = !mark ? "" : little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) {
    if (!little) bytes += '\0';
    bytes += c;
    if (little) bytes += '\0';
  }
  return bytes;
}

TEST(SvgShown, AnyEncodingOfXml) {
  const std::string text = page(frame, R"x(style="fill-rule:evenodd")x");
  for (const bool little : {false, true}) {
    for (const bool mark : {false, true}) expect(utf16(text, little, mark), 48.0, 1);
  }
  expect("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><!-- \xE4 -->" + text, 48.0, 1);
  expect("<?xml version='1.0' encoding='utf-16'?>" + text, 48.0, 1);  // saved anew, its first line left
  EXPECT_EQ(error("<?xml version=\"1.0\" encoding=\"klingon\"?>" + text),
            "a.svg:1:1: expected an encoding that is known, such as UTF-8 or ISO-8859-1, got \"klingon\"");
  EXPECT_EQ(error("<!-- \xE4 -->" + text).substr(0, 21), "a.svg:1:6: expected U");
}

TEST(Outlines, PolygonsAreWhatTheyEnclose) {
  std::vector<Note> notes;
  const auto area = [&](const std::vector<vec2>& outline, const std::vector<Ring>& holes = {}) {
    notes.clear();
    double sum = 0.0;
    for (const Region& region : regions_of_polygon({outline, {}}, holes, &notes)) sum += geometry::area(region);
    return sum;
  };
  EXPECT_EQ(area({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 100.0);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(area({{0, 0}, {10, 10}, {10, 0}, {0, 10}}), 50.0);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(
      notes[0].what,
      "read as what the outline encloses (even-odd) and no hole does, 2 areas of 5e-05 m², since edge 0 of the outline and "
      "edge 2 of the outline crossing at (5, 5)");
  EXPECT_EQ(area({{0, 0}, {8, 0}, {8, 6}, {0, 6}, {0, 3}, {3, 4}, {3, 2}, {0, 3}}), 45.0);
  EXPECT_EQ(area({{0, 0}, {8, 0}, {8, 6}, {4, 6}, {4, 3}, {6, 4.5}, {4, 3}, {4, 6}, {0, 6}}), 48.0);
  EXPECT_EQ(notes.size(), 1U);
  const std::vector<vec2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(area(square, {{{{-1, 2}, {2, 2}, {2, 4}, {-1, 4}}, {}}, {{{1, 3}, {3, 3}, {3, 5}, {1, 5}}, {}}}),
            100.0 - 4.0 - 4.0 + 1.0);
  EXPECT_EQ(area(square, {{{{20, 2}, {22, 2}, {22, 4}}, {}}}), 100.0);
  EXPECT_THROW(area(square, {{{{-1, -1}, {11, -1}, {11, 11}, {-1, 11}}, {}}}), InputError);
}

// The corner of the hole lies on a slanting side but for what the lattice rounds.
TEST(Outlines, CrossingsByRoundingAreSnapped) {
  const std::vector<vec2> outline = {{0, 0}, {1000, 333}, {1000, 1000}, {0, 1000}};
  for (const double x : {100.0, 200.0, 301.0, 700.0}) {
    const vec2 corner{x, 0.333 * x - 0.0004};
    const Ring hole{{corner, corner + vec2{50, 100}, corner + vec2{-50, 100}}, {}};
    const Region region = region_of({outline, {}}, {hole});
    EXPECT_NEAR(geometry::area(region), geometry::area(outline) - 5000.0, 1.0) << x;
  }
  EXPECT_THROW(region_of({outline, {}}, {{{{100, 33}, {150, 133}, {50, 133}}, {}}}), InputError);
}

}  // namespace
}  // namespace shatterpave::scene
