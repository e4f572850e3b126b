#include "scene/plans/plan_areas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/functions.h"
#include "geometry/clip.h"
#include "geometry/fill.h"
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
  return geometry::without_faults(geometry::thickened({line}, 0.5 * width_mm));
}

std::vector<Region> unclipped_regions(const PlanShape& shape, const PlanFrame& frame, double width_mm,
                                      std::vector<Note>* notes) {
  std::vector<Ring> rings;
  for (const Ring& ring : shape.rings) rings.push_back(frame(ring));
  if (shape.kind == ShapeKind::line) return band(rings.front(), width_mm);
  if (shape.kind == ShapeKind::point) return {disc(rings.front().points_mm.front(), width_mm, rings.front().place)};
  if (shape.filling) return filled_regions(rings, *shape.filling);
  const Ring outline = std::move(rings.front());
  rings.erase(rings.begin());
  return regions_of_polygon(outline, rings, notes);
}

std::vector<Region> regions_of_shape(const PlanShape& shape, const PlanFrame& frame, double width_mm,
                                     std::vector<Note>* notes) {
  if (notes != nullptr) {
    for (const Note& note : shape.notes) add_note(note, *notes);
  }
  if (shape.kind == ShapeKind::unread) return {};
  if (shape.unfollowed) throw InputError(shape.unfollowed->place, shape.unfollowed->what);
  std::vector<Region> regions = unclipped_regions(shape, frame, width_mm, notes);
  for (const auto& clip : shape.clips) regions = within(regions, *clip);
  return regions;
}

std::vector<geometry::Box> boxes_of(const std::vector<Region>& regions) {
  std::vector<geometry::Box> boxes;
  boxes.reserve(regions.size());
  for (const Region& region : regions) boxes.push_back(geometry::bounding_box(region.outline));
  return boxes;
}

// Those of `others` whose boxes meet that of the region.
std::vector<Region> near_ones(const Region& region, const std::vector<Region>& others,
                              const std::vector<geometry::Box>& boxes) {
  const geometry::Box box = geometry::bounding_box(region.outline);
  std::vector<Region> near;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (geometry::boxes_meet(box, boxes[i])) near.push_back(others[i]);
  }
  return near;
}

// Whether no two regions have more than single points in common.
bool are_apart(const std::vector<Region>& regions) {
  if (regions.size() < 2) return true;
  // As the holes of a region about all of them; what lies in a hole of one is taken for an overlap.
  const double far = geometry::largest_coordinate_mm + 1000.0;
  std::vector<Polygon> outlines;
  outlines.reserve(regions.size());
  for (const Region& region : regions) outlines.push_back(region.outline);
  return !geometry::region_fault({{-far, -far}, {far, -far}, {far, far}, {-far, far}}, outlines);
}

// The union. Parts that are near each other are united first: what lies inside a union no longer counts, so many regions piled
// on each other take no longer than as many side by side.
std::vector<Region> united_by_halves(std::vector<Region> regions) {
  constexpr std::size_t few = 32;
  if (regions.size() <= few) return geometry::united(regions);
  const auto half = regions.begin() + static_cast<std::ptrdiff_t>(regions.size() / 2);
  std::vector<Region> left = united_by_halves({regions.begin(), half});
  std::vector<Region> right = united_by_halves({half, regions.end()});
  std::ranges::move(right, std::back_inserter(left));
  return geometry::united(left);
}

// Holes that make a region as they are keep all vertices; others are cut out.
std::vector<Region> without_near(const Region& area, const std::vector<Region>& near) {
  if (near.empty()) return {area};
  if (std::ranges::all_of(near, [](const Region& hole) { return hole.holes.empty(); })) {
    std::vector<Polygon> holes = area.holes;
    for (const Region& hole : near) holes.push_back(hole.outline);
    if (!geometry::region_fault(area.outline, holes)) return {canonical({area.outline, std::move(holes)})};
  }
  return geometry::without_faults(geometry::difference(area, merged(near)));
}

// The order of the region that holds a point of a part, part after part.
std::vector<std::size_t> by_first_part(const std::vector<Region>& regions, const std::vector<Region>& parts) {
  const std::vector<geometry::Box> boxes = boxes_of(regions);
  std::vector<std::size_t> order;
  std::vector<bool> listed(regions.size(), false);
  for (const Region& part : parts) {
    const vec2 vertex = part.outline.front();
    for (std::size_t i = 0; i < regions.size(); ++i) {
      if (listed[i] || !geometry::boxes_meet(boxes[i], {vertex, vertex})) continue;
      if (!geometry::contains(regions[i].outline, vertex)) continue;
      listed[i] = true;
      order.push_back(i);
    }
  }
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (!listed[i]) order.push_back(i);
  }
  return order;
}

}  // namespace

std::vector<Region> regions_of(const Plan& plan, const std::vector<std::size_t>& shapes, const PlanFrame& frame,
                               double width_mm, std::vector<Note>* notes, std::vector<InputError>* left_out) {
  std::vector<Region> regions;
  for (const std::size_t shape : shapes) {
    try {
      for (Region& region : regions_of_shape(plan.shapes[shape], frame, width_mm, notes))
        regions.push_back(canonical(std::move(region)));
    } catch (const InputError& error) {
      if (left_out == nullptr) throw;
      left_out->push_back(error);
    }
  }
  return regions;
}

std::vector<Region> merged(const std::vector<Region>& regions) {
  if (are_apart(regions)) return regions;
  std::vector<std::size_t> from_left(regions.size());
  std::iota(from_left.begin(), from_left.end(), std::size_t{0});
  std::ranges::stable_sort(from_left, {}, [&](std::size_t i) { return regions[i].outline.front().x; });
  std::vector<Region> sorted;
  sorted.reserve(regions.size());
  for (const std::size_t i : from_left) sorted.push_back(regions[i]);
  std::vector<Region> all = geometry::without_faults(united_by_halves(std::move(sorted)));
  for (Region& region : all) region = canonical(std::move(region));
  std::vector<Region> result;
  for (const std::size_t i : by_first_part(all, regions)) result.push_back(std::move(all[i]));
  return result;
}

std::vector<Region> areas_of_file(const std::filesystem::path& file) {
  const Plan plan = plan_of_file(file, Place{file.string(), 0, 0, ""});
  const auto shapes = chosen_shapes(plan, {ShapeKind::area}, {}, ByDefault::the_only_feature);
  return merged(regions_of(plan, shapes, frame_of(plan, shapes, std::nullopt, std::nullopt), 0.0));
}

std::vector<Region> within(const std::vector<Region>& areas, const std::vector<Region>& limits) {
  const std::vector<geometry::Box> boxes = boxes_of(limits);
  std::vector<Region> parts;
  for (const Region& area : areas) {
    for (const Region& limit : near_ones(area, limits, boxes)) {
      for (const Region& part : geometry::without_faults(geometry::intersection(area, limit))) parts.push_back(canonical(part));
    }
  }
  return parts;
}

std::vector<Region> without(const std::vector<Region>& areas, const std::vector<Region>& holes) {
  const std::vector<geometry::Box> boxes = boxes_of(holes);
  std::vector<Region> left;
  for (const Region& area : areas) {
    for (const Region& part : without_near(area, near_ones(area, holes, boxes))) left.push_back(canonical(part));
  }
  return left;
}

}  // namespace shatterpave::scene
