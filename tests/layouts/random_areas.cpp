#include "layouts/random_areas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/functions.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"

namespace shatterpave::layouts {

namespace {

using geometry::Polygon;
using geometry::Region;

constexpr double turn = 2.0 * pi;

vec2 on_circle(double angle, double radius) { return radius * vec2{cosine(angle), sine(angle)}; }

// Corners on a circle, the angles between them anything.
Polygon round_polygon(const Draws& draws, std::size_t corners) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < corners; ++i) angles.push_back(draws.between("angle", 0.0, turn, i));
  std::ranges::sort(angles);
  Polygon polygon;
  for (const double angle : angles) polygon.push_back(on_circle(angle, 1.0));
  return polygon;
}

// Corners about a middle that sees them all.
Polygon star_shaped(const Draws& draws, std::size_t corners, double least) {
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = turn * (static_cast<double>(i) + draws.between("lean", -0.4, 0.4, i)) / static_cast<double>(corners);
    polygon.push_back(on_circle(angle, draws.between("radius", least, 1.0, i)));
  }
  return polygon;
}

Polygon spiky_star(const Draws& draws) {
  const std::size_t tips = draws.count("tips", 3, 12);
  const double inner = draws.between("inner", 0.1, 0.7);
  Polygon polygon;
  for (std::size_t i = 0; i < 2 * tips; ++i) {
    polygon.push_back(on_circle(turn * static_cast<double>(i) / static_cast<double>(2 * tips), i % 2 == 0 ? 1.0 : inner));
  }
  return polygon;
}

Polygon comb(const Draws& draws) {
  const std::size_t teeth = draws.count("teeth", 2, 8);
  const double gap = draws.between("gap", 0.1, 0.8);
  const double back = draws.between("back", 0.1, 1.0);
  Polygon polygon{{0.0, -back}, {static_cast<double>(teeth) - gap, -back}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double left = static_cast<double>(i);
    const double right = left + 1.0 - gap;
    const double high = draws.between("tooth", 0.3, 4.0, i);
    const double lean = draws.between("lean", -0.4, 0.4, i) * gap;
    polygon.insert(polygon.end(), {{right, i + 1 == teeth ? -0.5 * back : 0.0}, {right + lean, high}, {left + lean, high}});
    if (i > 0) polygon.push_back({left, 0.0});
  }
  return polygon;
}

// Long and thin, with three to six corners.
Polygon sliver(const Draws& draws) {
  Polygon polygon = round_polygon(draws, draws.count("corners", 3, 6));
  const double thin = draws.spread("thin", 0.02, 0.2);
  for (vec2& p : polygon) p.y *= thin;
  return polygon;
}

// Steps up one side and down the other: L, T, U and the like.
Polygon rectangles(const Draws& draws) {
  const std::size_t columns = draws.count("columns", 1, 5);
  Polygon low;
  Polygon high;
  double x = 0.0;
  for (std::size_t i = 0; i < columns; ++i) {
    const double right = x + draws.between("width", 0.2, 1.0, i);
    const double bottom = draws.between("bottom", -1.0, 0.0, i);
    const double top = draws.between("top", 0.2, 1.0, i);
    low.insert(low.end(), {{x, bottom}, {right, bottom}});
    high.insert(high.end(), {{x, top}, {right, top}});
    x = right;
  }
  std::ranges::reverse(high);
  low.insert(low.end(), high.begin(), high.end());
  return low;
}

bool cross(vec2 a, vec2 b, vec2 c, vec2 d) {
  const auto side = [](vec2 p, vec2 q, vec2 r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) > 0.0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

// Random points in random order, with crossings undone two sides at a time: each makes the polygon shorter.
Polygon uncrossed(const Draws& draws) {
  const std::size_t n = draws.count("corners", 4, 16);
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) polygon.push_back({draws.unit("x", i), draws.unit("y", i)});
  bool crossing = true;
  for (int round = 0; crossing && round < 1000; ++round) {
    crossing = false;
    for (std::size_t i = 0; i < n && !crossing; ++i) {
      for (std::size_t j = i + 2; j < n && !crossing; ++j) {
        if ((j + 1) % n == i || !cross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) continue;
        std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     polygon.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        crossing = true;
      }
    }
  }
  return polygon;
}

// Between two arcs: a lens where they bulge either way, a crescent where both bulge one way.
Polygon arcs(const Draws& draws) {
  const std::size_t steps = draws.count("steps", 4, 19);
  const double up = draws.between("up", 0.1, 1.0);
  const double down = draws.chance("crescent", 0.5) ? up * draws.between("share", 0.1, 0.9) : -draws.between("down", 0.1, 1.0);
  const auto point = [&](std::size_t i, double bulge) {
    const double angle = pi * static_cast<double>(i) / static_cast<double>(steps);
    return vec2{-cosine(angle), bulge * sine(angle)};
  };
  Polygon polygon;
  for (std::size_t i = 0; i < steps; ++i) polygon.push_back(point(i, down));
  for (std::size_t i = steps; i > 0; --i) polygon.push_back(point(i, up));
  return polygon;
}

// A band along a polyline, as plans with a line width give it.
Region band(const Draws& draws) {
  const std::size_t points = draws.count("points", 2, 6);
  std::vector<vec2> line{{0.0, 0.0}};
  double angle = 0.0;
  for (std::size_t i = 1; i < points; ++i) {
    line.push_back(line.back() + on_circle(angle, 1000.0 * draws.between("length", 0.5, 2.0, i)));
    angle += draws.between("bend", -2.2, 2.2, i);
  }
  std::vector<Region> parts = geometry::thickened({line}, 1000.0 * draws.between("width", 0.05, 0.4));
  return std::move(parts.front());
}

Region ring(const Draws& draws) {
  const auto regular = [&](std::string_view name, double radius) {
    const std::size_t corners = draws.count(name, 3, 40);
    Polygon polygon;
    for (std::size_t i = 0; i < corners; ++i) {
      polygon.push_back(
          on_circle(turn * (static_cast<double>(i) + draws.unit(name, 1)) / static_cast<double>(corners), radius));
    }
    return polygon;
  };
  // Of a polygon with few corners the sides come nearer to the middle.
  const Polygon outline = regular("outline", 1.0);
  const double inner = cosine(pi / static_cast<double>(outline.size()));
  return {outline, {regular("hole", draws.between("share", 0.2, 0.97) * inner)}};
}

Polygon concave(const Draws& draws) {
  const std::size_t most = draws.chance("many", 0.3) ? 40 : 9;
  return star_shaped(draws, draws.count("corners", 4, most), draws.between("least", 0.15, 0.95));
}

double distance(vec2 p, vec2 a, vec2 b) {
  const vec2 d = b - a;
  const double along = std::clamp(glm::dot(p - a, d) / std::max(1e-300, glm::dot(d, d)), 0.0, 1.0);
  return glm::length(p - a - along * d);
}

double distance(vec2 p, const Polygon& ring) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) least = std::min(least, distance(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

bool inside(vec2 p, const Polygon& ring) {
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const vec2 a = ring[i];
    const vec2 b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}

// Up to three holes, each as large as it may be or smaller, about the best of some places.
void add_holes(const Draws& draws, Region& region) {
  if (!draws.chance("holes", 0.35)) return;
  const geometry::Box box = geometry::bounding_box(region.outline);
  for (std::size_t h = draws.count("holes", 1, 3); h > 0; --h) {
    const Draws its = draws.of("hole", h);
    vec2 middle{0.0, 0.0};
    double room = 0.0;
    for (std::size_t attempt = 0; attempt < 12; ++attempt) {
      const vec2 p{its.between("x", box.low.x, box.high.x, attempt), its.between("y", box.low.y, box.high.y, attempt)};
      double free = inside(p, region.outline) ? distance(p, region.outline) : 0.0;
      for (const Polygon& hole : region.holes) free = inside(p, hole) ? 0.0 : std::min(free, distance(p, hole));
      if (free > room) middle = p;
      room = std::max(room, free);
    }
    if (room == 0.0) continue;
    Polygon hole = its.chance("round", 0.5) ? round_polygon(its, its.count("corners", 3, 6))
                                            : star_shaped(its, its.count("corners", 4, 12), its.between("least", 0.2, 1.0));
    const double radius = room * its.between("size", 0.15, 0.98);
    for (vec2& p : hole) p = middle + radius * p;
    region.holes.push_back(std::move(hole));
  }
}

}  // namespace

DrawnArea random_area(const Draws& draws, const std::vector<Region>& places) {
  using Shape = DrawnArea;
  const auto plain = [&](std::string name, Polygon outline) {
    Shape shape{std::move(name), {std::move(outline), {}}};
    add_holes(draws, shape.region);
    return shape;
  };
  switch (draws.count("shape", 0, 15)) {
    case 0:
    case 1:
      return plain("triangle", round_polygon(draws, 3));
    case 2:
    case 3:
      return plain("convex", round_polygon(draws, draws.count("corners", 4, 12)));
    case 4:
    case 5:
    case 6:
      return plain("concave", concave(draws));
    case 7:
      return plain("star", spiky_star(draws));
    case 8:
      return plain("comb", comb(draws));
    case 9:
      return plain("sliver", sliver(draws));
    case 10:
      return plain("rectangles", rectangles(draws));
    case 11:
      return plain("uncrossed", uncrossed(draws));
    case 12:
      return plain("arcs", arcs(draws));
    case 13:
      return {"band", band(draws)};
    case 14:
      return {"ring", ring(draws)};
    default:
      break;
  }
  if (places.empty()) return plain("concave", concave(draws));
  return {"place", places[draws.count("place", 0, places.size() - 1)]};
}

Region placed(const Region& region, double area_mm2, const Draws& draws) {
  const double angle = draws.chance("straight", 0.3) ? 0.0 : draws.between("turn", 0.0, turn);
  const double stretch = draws.chance("stretched", 0.5) ? draws.spread("stretch", 0.2, 1.0) : 1.0;
  const double scale = std::sqrt(area_mm2 / (stretch * std::max(1e-9, std::abs(geometry::area(region.outline)))));
  const vec2 along = on_circle(angle, 1.0);
  const vec2 shift{draws.between("shift", -20'000.0, 20'000.0, 0), draws.between("shift", -20'000.0, 20'000.0, 1)};
  const vec2 origin = region.outline.front();
  const auto place = [&](Polygon& ring) {
    for (vec2& p : ring) {
      const vec2 q = scale * (p - origin);
      p = geometry::on_lattice(shift + q.x * along + stretch * q.y * left_of(along));
    }
  };
  Region result = region;
  place(result.outline);
  for (Polygon& hole : result.holes) place(hole);
  return result;
}

}  // namespace shatterpave::layouts
