#include "geometry/clip.h"

#include <clipper.hpp>

#include "geometry/predicates.h"

namespace shatterpave::geometry {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

Path path_of(const Polygon& polygon) {
  Path path;
  path.reserve(polygon.size());
  for (const vec2& vertex : polygon) {
    const LatticePoint p = to_lattice(vertex);
    path.emplace_back(p.x, p.y);
  }
  return path;
}

// Clipper's rule "non-zero" wants outlines and holes to wind against each other.
Path wound_path_of(const Polygon& polygon, bool counter_clockwise) {
  Path path = path_of(polygon);
  if (ClipperLib::Orientation(path) != counter_clockwise) ClipperLib::ReversePath(path);
  return path;
}

Paths paths_of(const Region& region) {
  Paths paths{wound_path_of(region.outline, true)};
  for (const Polygon& hole : region.holes) paths.push_back(wound_path_of(hole, false));
  return paths;
}

Paths paths_of(const std::vector<Region>& regions) {
  Paths paths;
  for (const Region& region : regions) {
    const Paths rings = paths_of(region);
    paths.insert(paths.end(), rings.begin(), rings.end());
  }
  return paths;
}

Polygon polygon_of(const Path& path) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path) polygon.push_back(to_mm(LatticePoint{p.X, p.Y}));
  return cleaned(polygon);
}

std::vector<Region> regions_of(const ClipperLib::PolyTree& tree) {
  std::vector<Region> regions;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole()) continue;
    Region region{polygon_of(node->Contour), {}};
    if (region.outline.empty()) continue;
    for (const ClipperLib::PolyNode* child : node->Childs) {
      Polygon hole = polygon_of(child->Contour);
      if (!hole.empty()) region.holes.push_back(std::move(hole));
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

std::vector<Region> combined(ClipperLib::ClipType operation, const Paths& subject, const Paths& clip) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(operation, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return regions_of(tree);
}

// Whether `b` adds nothing to the path a → b → c.
bool redundant(LatticePoint a, LatticePoint b, LatticePoint c) { return side(a, b, c) == Side::on; }

}  // namespace

std::vector<Region> intersection(const Polygon& subject, const Region& clip) {
  return combined(ClipperLib::ctIntersection, {wound_path_of(subject, true)}, paths_of(clip));
}

std::vector<Region> intersection(const Region& subject, const Region& clip) {
  return combined(ClipperLib::ctIntersection, paths_of(subject), paths_of(clip));
}

std::vector<Region> difference(const Region& subject, const std::vector<Polygon>& removed) {
  Paths clip;
  for (const Polygon& polygon : removed) clip.push_back(wound_path_of(polygon, true));
  return combined(ClipperLib::ctDifference, paths_of(subject), clip);
}

std::vector<Region> difference(const Region& subject, const std::vector<Region>& removed) {
  return combined(ClipperLib::ctDifference, paths_of(subject), paths_of(removed));
}

std::vector<Region> united(const std::vector<Polygon>& polygons) {
  Paths subject;
  for (const Polygon& polygon : polygons) subject.push_back(wound_path_of(polygon, true));
  return combined(ClipperLib::ctUnion, subject, {});
}

std::vector<Region> united(const std::vector<Region>& regions) { return combined(ClipperLib::ctUnion, paths_of(regions), {}); }

std::vector<Region> offset(const Region& region, double distance_mm, double miter_limit) {
  ClipperLib::ClipperOffset offsetter(miter_limit);
  offsetter.AddPaths(paths_of(region), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  Paths moved;
  offsetter.Execute(moved, distance_mm * lattice_per_mm);
  // A second pass makes the result strictly simple, and says which path is a hole of which.
  return combined(ClipperLib::ctUnion, moved, {});
}

std::vector<Region> thickened(const std::vector<std::vector<vec2>>& polylines, double distance_mm, double miter_limit) {
  ClipperLib::ClipperOffset offsetter(miter_limit);
  for (const auto& polyline : polylines) offsetter.AddPath(path_of(polyline), ClipperLib::jtMiter, ClipperLib::etOpenButt);
  Paths thick;
  offsetter.Execute(thick, distance_mm * lattice_per_mm);
  return combined(ClipperLib::ctUnion, thick, {});
}

Polygon cleaned(const Polygon& polygon) {
  std::vector<LatticePoint> kept;
  for (const vec2& vertex : polygon) {
    const LatticePoint p = to_lattice(vertex);
    while (!kept.empty() && (kept.back() == p || (kept.size() > 1 && redundant(kept[kept.size() - 2], kept.back(), p)))) {
      kept.pop_back();
    }
    kept.push_back(p);
  }
  // The same rule where the end of the ring meets its start.
  std::size_t begin = 0;
  bool changed = true;
  while (changed && kept.size() - begin >= 3) {
    changed = false;
    if (kept.back() == kept[begin] || redundant(kept[kept.size() - 2], kept.back(), kept[begin])) {
      kept.pop_back();
      changed = true;
    } else if (redundant(kept.back(), kept[begin], kept[begin + 1])) {
      ++begin;
      changed = true;
    }
  }
  if (kept.size() - begin < 3) return {};
  Polygon result;
  result.reserve(kept.size() - begin);
  for (std::size_t i = begin; i < kept.size(); ++i) result.push_back(to_mm(kept[i]));
  return result;
}

bool is_simple(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return false;
  std::vector<LatticePoint> p;
  p.reserve(n);
  for (const vec2& vertex : polygon) p.push_back(to_lattice(vertex));
  for (std::size_t i = 0; i < n; ++i) {
    const LatticePoint a = p[i];
    const LatticePoint b = p[(i + 1) % n];
    const LatticePoint c = p[(i + 2) % n];
    // Neighbours meet in b; they must not double back.
    if (a == b || on_segment(a, b, c) || on_segment(b, c, a)) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n == i) continue;
      if (segments_meet(a, b, p[j], p[(j + 1) % n])) return false;
    }
  }
  return true;
}

}  // namespace shatterpave::geometry
