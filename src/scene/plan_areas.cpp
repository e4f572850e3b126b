#include "scene/plan_areas.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/functions.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/simple.h"

namespace shatterpave::scene {

namespace {

using geometry::Polygon;
using geometry::Region;

// A circle as a polygon that is nowhere farther from it than the curves of SVG are.
Region disc(vec2 centre, double diameter_mm, const Place& place) {
  const double radius = 0.5 * diameter_mm;
  // The middle of a side of n is off by r (1 − cos(π / n)) <= r (π / n)² / 2.
  const int quarter = std::max(2, static_cast<int>(std::ceil(0.25 * pi * std::sqrt(0.5 * radius / svg_tolerance_mm))));
  Ring ring{{}, place};
  for (int i = 0; i < 4 * quarter; ++i) {
    const double angle = 0.5 * pi * i / quarter;
    ring.points_mm.push_back(centre + radius * vec2{cosine(angle), sine(angle)});
  }
  return region_of(ring, {});
}

std::vector<Region> band(const Ring& ring, double width_mm) {
  std::vector<vec2> line = line_of(ring);
  // A line that returns to its start has no ends: once more over its first edge closes the band.
  if (line.size() > 3 && line.front() == line.back()) line.push_back(line[1]);
  return geometry::thickened({line}, 0.5 * width_mm);
}

std::vector<Region> regions_of(const PlanShape& shape, const PlanFrame& frame, double width_mm) {
  std::vector<Ring> rings;
  for (const Ring& ring : shape.rings) rings.push_back(frame(ring));
  if (shape.kind == ShapeKind::line) return band(rings.front(), width_mm);
  if (shape.kind == ShapeKind::point) return {disc(rings.front().points_mm.front(), width_mm, rings.front().place)};
  if (shape.filling) return filled_regions(rings, *shape.filling);
  const Ring outline = std::move(rings.front());
  rings.erase(rings.begin());
  return {region_of(outline, rings)};
}

bool boxes_meet(const Region& a, const Region& b) {
  return geometry::boxes_meet(geometry::bounding_box(a.outline), geometry::bounding_box(b.outline));
}

std::vector<Region> of_others_near(const Region& region, const std::vector<Region>& others) {
  std::vector<Region> near;
  std::ranges::copy_if(others, std::back_inserter(near), [&](const Region& other) { return boxes_meet(region, other); });
  return near;
}

// Holes that make a region as they are keep all vertices; others are cut out.
std::vector<Region> without_near(const Region& area, const std::vector<Region>& near) {
  if (near.empty()) return {area};
  if (std::ranges::all_of(near, [](const Region& hole) { return hole.holes.empty(); })) {
    std::vector<Polygon> holes = area.holes;
    for (const Region& hole : near) holes.push_back(hole.outline);
    if (!geometry::region_fault(area.outline, holes)) return {canonical({area.outline, std::move(holes)})};
  }
  return geometry::difference(area, near);
}

}  // namespace

std::vector<Region> areas_of(const Plan& plan, const std::vector<std::size_t>& shapes, const PlanFrame& frame,
                             double width_mm) {
  std::vector<Region> areas;
  for (const std::size_t shape : shapes) {
    for (const Region& region : regions_of(plan.shapes[shape], frame, width_mm)) {
      std::vector<Region> before = of_others_near(region, areas);
      std::erase_if(before, [&](const Region& other) { return geometry::intersection(other.outline, region).empty(); });
      const std::vector<Region> added = before.empty() ? std::vector{region} : geometry::difference(region, before);
      for (const Region& part : added) areas.push_back(canonical(part));
    }
  }
  return areas;
}

std::vector<Region> areas_of_file(const std::filesystem::path& file) {
  const Plan plan = plan_of_file(file, Place{file.string(), 0, 0, ""});
  const auto shapes = chosen_shapes(plan, {ShapeKind::area}, {}, ByDefault::the_only_feature);
  return areas_of(plan, shapes, frame_of(plan, shapes, std::nullopt, std::nullopt), 0.0);
}

std::vector<Region> within(const std::vector<Region>& areas, const std::vector<Region>& limits) {
  std::vector<Region> parts;
  for (const Region& area : areas) {
    for (const Region& limit : of_others_near(area, limits)) {
      for (const Region& part : geometry::intersection(area, limit)) parts.push_back(canonical(part));
    }
  }
  return parts;
}

std::vector<Region> without(const std::vector<Region>& areas, const std::vector<Region>& holes) {
  std::vector<Region> left;
  for (const Region& area : areas) {
    for (const Region& part : without_near(area, of_others_near(area, holes))) left.push_back(canonical(part));
  }
  return left;
}

}  // namespace shatterpave::scene
