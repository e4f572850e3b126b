// Rows of the keys that [[pane]] and [[pavement]] have in common: a name and an outline. They stand first in the sections of
// both.
#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "scene/schema/ranges.h"
#include "scene/schema/row.h"
#include "studio/world.h"

namespace shatterpave::scene {

template <typename Thing, typename Facts>
std::vector<Row<Thing, Facts>> outline_rows() {
  using rows::in;
  using OutlineRow = Row<Thing, Facts>;
  return {
      OutlineRow::by_code("name", ValueType::text,
                          "names files and identifiers. Unique in the scene, also where capital and small letters, and `-` and "
                          "`_`, are taken for the same")
          .written("1 to 64 letters, digits, `_`, `-`; first a letter")
          .by_default("must be given"),
      OutlineRow::by_code("size_mm", ValueType::point, "a rectangle from (0, 0)")
          .within(size_range)
          .written("`[width, height]`, each {}"),
      OutlineRow::by_code("outline_mm", ValueType::points, "a simple polygon")
          .within(coordinate_range)
          .written("`[[x, y], …]`, 3 to 1,000,000 points"),
      OutlineRow::by_code(
          "outline_file", ValueType::text,
          "the outline is in a plan, a GeoJSON, SVG or DXF file; a relative name starts at the scene file's folder. "
          "Also a pipe, and `\"-\"`, the standard input: the first character tells which it is")
          .written("file name"),
      OutlineRow::by_code("outline_feature", ValueType::features,
                          "which of its features: their ids, or indices of shapes; see [Plans](#plans)")
          .by_default("the only one"),
      OutlineRow::by_code("outline_class", ValueType::text, "or all shapes of this class"),
      OutlineRow::by_code("outline_units", ValueType::choice,
                          "units of GeoJSON and DXF files; a foot is 0.3048 m, one of the US survey 1200/3937 m")
          .one_of(names_of(plan_unit_words))
          .by_default("the file's `crs` or `$INSUNITS`, or guessed, see below"),
      OutlineRow::place("place_mm", in(&Thing::placement, &studio::Placement::at_mm), coordinate_range,
                        "where its origin stands in the world, see [Camera and light](#camera-and-light)"),
      OutlineRow::angle("place_turn_deg", in(&Thing::placement, &studio::Placement::turn), {-360.0, 360.0},
                        "how far it is turned about the upright through its origin, counter-clockwise from above"),
  };
}

// The keys of `first`, then those of `rest`.
template <typename RowType>
std::vector<RowType> joined(std::vector<RowType> first, std::vector<RowType> rest) {
  first.insert(first.end(), std::make_move_iterator(rest.begin()), std::make_move_iterator(rest.end()));
  return first;
}

}  // namespace shatterpave::scene
