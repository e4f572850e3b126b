#include "paving/bonds/border.h"

#include <algorithm>

#include "geometry/clip.h"
#include "paving/bonds/course_tiles.h"
#include "paving/tiles/filling.h"

namespace shatterpave::paving {

namespace {

using geometry::Region;

vec2 border_pitch_mm(const Pavement& pavement) {
  return border_stone_mm(pavement) + vec2{pavement.joint_mm, pavement.joint_mm};
}

}  // namespace

vec2 border_stone_mm(const Pavement& pavement) {
  if (pavement.border.stone_mm != vec2{0.0, 0.0}) return pavement.border.stone_mm;
  const double longer = std::max(pavement.stone_mm.x, pavement.stone_mm.y);
  const double shorter = std::min(pavement.stone_mm.x, pavement.stone_mm.y);
  return pavement.border.course == BorderCourse::soldier ? vec2{shorter, longer} : vec2{longer, shorter};
}

BorderedArea bordered_area(const Pavement& pavement) {
  BorderedArea parts;
  parts.within = geometry::offset(pavement.area, -border_pitch_mm(pavement).y);
  // About the outlines of what is within, and inside its holes.
  std::vector<geometry::Polygon> outlines;
  for (const Region& region : parts.within) outlines.push_back(region.outline);
  parts.course = geometry::difference(pavement.area, outlines);
  for (const Region& region : parts.within) {
    for (const geometry::Polygon& hole : region.holes) {
      for (Region& about_hole : geometry::intersection(hole, pavement.area)) parts.course.push_back(std::move(about_hole));
    }
  }
  return parts;
}

std::vector<Tile> border_tiles(const Pavement& pavement, const std::vector<Region>& course) {
  const vec2 pitch = border_pitch_mm(pavement);
  std::vector<Tile> tiles;
  for (const Region& middle : geometry::offset(pavement.area, -0.5 * pitch.y)) {
    for (Tile& tile : course_tiles(middle.outline, pitch, pavement.joint_mm, 0.0)) tiles.push_back(std::move(tile));
    for (const geometry::Polygon& hole : middle.holes) {
      for (Tile& tile : course_tiles(hole, pitch, pavement.joint_mm, 0.0)) tiles.push_back(std::move(tile));
    }
  }
  std::vector<Tile> all;
  for (const Region& region : course) {
    for (Tile& tile : filling_tiles(tiles, region)) all.push_back(std::move(tile));
  }
  return all;
}

}  // namespace shatterpave::paving
