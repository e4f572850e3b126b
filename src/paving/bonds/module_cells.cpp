#include "paving/bonds/module_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/clip.h"
#include "geometry/hull.h"
#include "geometry/inscribed_circle.h"
#include "geometry/lattice.h"
#include "geometry/segment_distance.h"
#include "paving/bonds/module_corners.h"
#include "paving/bonds/module_repeats.h"
#include "paving/limits.h"
#include "paving/tiles/cutting.h"
#include "paving/tiles/stock.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;

double border_length_mm(const Polygon& polygon) {
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) length += glm::length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return length;
}

// Two shapes that lie over one another, and how far.
struct Overlap {
  std::size_t one = 0;
  std::size_t other = 0;
  double width_mm = 0.0;
  vec2 middle_mm{0.0, 0.0};
};

// Calls act(one, other, shift) for all pairs of shapes that may meet, of which the other is repeated by that shift; each pair
// once.
template <typename Act>
void for_pairs(const std::vector<Polygon>& shapes, const Repeats& repeats, const Act& act) {
  std::vector<Box> boxes;
  boxes.reserve(shapes.size());
  for (const Polygon& shape : shapes) boxes.push_back(extent_in(repeats, shape));
  for (std::size_t one = 0; one < shapes.size(); ++one) {
    for (std::size_t other = 0; other <= one; ++other) {
      for_repeats(boxes[one], boxes[other], [&](vec2 times) {
        if (one == other && (times.y < 0.0 || (times.y == 0.0 && times.x <= 0.0))) return;
        act(one, other, repeats.at(times));
      });
    }
  }
}

bool is_wider(const Region& region, double mm) { return !geometry::offset(region, -0.5 * mm).empty(); }

// Takes from each shape what it overlaps of an earlier one, or of its own repeats. Returns the first overlap that is wider than
// the tolerance; then the shapes are worth nothing.
std::optional<Overlap> take_apart(std::vector<Polygon>& shapes, const Repeats& repeats) {
  constexpr double rounding_mm = 0.002;  // both shapes are rounded to the lattice
  std::optional<Overlap> found;
  for_pairs(shapes, repeats, [&](std::size_t one, std::size_t other, vec2 shift) {
    if (found) return;
    const Region repeated{moved(shapes[other], shift), {}};
    bool is_seam = true;
    for (const Region& common : geometry::intersection(moved(shapes[one], {0.0, 0.0}), repeated)) {
      if (is_wider(common, module_tolerance_mm))
        found = Overlap{one, other, 2.0 * geometry::inscribed_circle(common).radius, geometry::centroid(common.outline)};
      if (2.0 * geometry::area(common) > rounding_mm * border_length_mm(common.outline)) is_seam = false;
    }
    if (found || is_seam) return;
    std::vector<Region> left = geometry::difference(Region{moved(shapes[one], {0.0, 0.0}), {}}, std::vector<Region>{repeated});
    const auto largest = std::ranges::max_element(left, {}, [](const Region& region) { return geometry::area(region); });
    if (largest != left.end() && largest->holes.empty() && is_sound(largest->outline)) shapes[one] = largest->outline;
  });
  return found;
}

// The distance of a point from the border of a shape, if it is less than `most_mm`; else that.
double distance_below_mm(vec2 p, const Polygon& shape, double most_mm) {
  double least = most_mm;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const vec2 a = shape[i];
    const vec2 b = shape[(i + 1) % shape.size()];
    const Box near{glm::min(a, b) - least, glm::max(a, b) + least};
    if (geometry::boxes_meet(near, {p, p})) least = std::min(least, geometry::distance_to_segment(p, a, b));
  }
  return least;
}

// The least distance between two shapes, or of one from its repeats, if it is less than `most_mm`; else that. It is that of a
// corner of the one from the border of the other.
double least_gap_mm(const std::vector<Polygon>& shapes, const Repeats& repeats, double most_mm) {
  const vec2 room = repeats.extent_of(most_mm);
  std::vector<Box> boxes;
  boxes.reserve(shapes.size());
  for (const Polygon& shape : shapes) boxes.push_back(extent_in(repeats, shape));
  double least = most_mm;
  for (std::size_t one = 0; one < shapes.size(); ++one) {
    for (std::size_t other = 0; other < shapes.size(); ++other) {
      const Box near{boxes[other].low - room, boxes[other].high + room};
      for_repeats(boxes[one], near, [&](vec2 times) {
        if (one == other && times == vec2{0.0, 0.0}) return;
        for (const vec2& p : shapes[one]) {
          const vec2 at = repeats.parts_of(p) - times;
          if (geometry::boxes_meet(near, {at, at})) {
            least = std::min(least, distance_below_mm(p - repeats.at(times), shapes[other], least));
          }
        }
      });
    }
  }
  return least;
}

// A place that shapes leave bare.
struct BarePlace {
  geometry::Circle widest;
  bool is_spot = true;  // about as long as it is wide, as what rounded corners leave; else a strip, a joint of another width
};

// All that are wider than the tolerance, of two by two repeats: there every such place lies whole once, or reaches from one
// repeat to the next, of which it is enough.
std::vector<BarePlace> bare_places(const std::vector<Polygon>& shapes, const Repeats& repeats) {
  // Half the border over the width: 3.8 of what four rounded corners leave, 5.1 of two beside a straight side.
  constexpr double longest_spot = 8.0;
  const Region window{moved({{0.0, 0.0}, 2.0 * repeats.along(), repeats.at({2.0, 2.0}), 2.0 * repeats.across()}, {0.0, 0.0}),
                      {}};
  const Box whole{{0.0, 0.0}, {2.0, 2.0}};
  std::vector<Polygon> covered;
  for (const Polygon& shape : shapes) {
    for_repeats(whole, extent_in(repeats, shape), [&](vec2 times) { covered.push_back(moved(shape, repeats.at(times))); });
  }
  std::vector<BarePlace> places;
  for (const Region& bare : geometry::difference(window, covered)) {
    if (!is_wider(bare, module_tolerance_mm)) continue;
    double border_mm = border_length_mm(bare.outline);
    for (const Polygon& hole : bare.holes) border_mm += border_length_mm(hole);
    const geometry::Circle circle = geometry::inscribed_circle(bare);
    places.push_back({circle, 0.5 * border_mm <= longest_spot * 2.0 * circle.radius});
  }
  return places;
}

std::vector<Polygon> grown(const std::vector<Polygon>& shapes, double by_mm) {
  constexpr double miter_limit = 10.0;  // corners of 12° and more keep their tips
  std::vector<Polygon> result;
  result.reserve(shapes.size());
  for (const Polygon& shape : shapes) result.push_back(geometry::offset({shape, {}}, by_mm, miter_limit).front().outline);
  return result;
}

// The side of the smallest box about a stone that runs along it; of boxes alike, the one that is turned least.
vec2 axis_of(const Polygon& face) {
  const Polygon hull = geometry::convex_hull(face);
  std::vector<vec2> directions;
  directions.reserve(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    vec2 d = hull[(i + 1) % hull.size()] - hull[i];
    while (d.x <= 0.0 || d.y < 0.0) d = left_of(d);
    directions.push_back(d / glm::length(d));
  }
  std::ranges::stable_sort(directions, {}, [](vec2 d) { return d.y; });
  constexpr double nearly = 1e-4;  // sides are rounded to the lattice
  vec2 best = directions.front();
  double least = std::numeric_limits<double>::infinity();
  for (const vec2& d : directions) {
    const vec2 size = size_of(extent(face, d));
    if (size.x * size.y >= least * (1.0 - nearly)) continue;
    least = size.x * size.y;
    best = d;
  }
  const vec2 size = size_of(extent(face, best));
  return size.y > size.x * (1.0 + nearly) ? left_of(best) : best;
}

// Begins with the lower left corner: of the least x + y; of several, the lowest.
Polygon from_lower_left(Polygon polygon) {
  constexpr double nearly_mm = 0.001;
  const auto first = std::ranges::min_element(polygon, [](vec2 a, vec2 b) {
    const double difference = a.x + a.y - b.x - b.y;
    return std::abs(difference) > nearly_mm ? difference < 0.0 : a.y < b.y;
  });
  std::rotate(polygon.begin(), first, polygon.end());
  return polygon;
}

class Making {
 public:
  Making(const DrawnModule& drawn, double joint_mm)
      : drawn_(drawn), joint_mm_(joint_mm), repeats_(drawn.first_mm, drawn.second_mm) {
    require_bounds();
    shapes_.reserve(drawn.stones.size());
    for (const DrawnStone& stone : drawn.stones) shapes_.push_back(stone.shape_mm.outline);
    require_reach();
  }

  void make_cells() {
    const std::vector<Polygon> as_drawn = shapes_;
    shapes_ = welded(as_drawn, repeats_);
    if (const auto overlap = take_apart(shapes_, repeats_)) refuse_overlap(*overlap);
    const double most_mm = std::min(joint_mm_ + module_tolerance_mm, glm::length(repeats_.along()));
    const double gap = least_gap_mm(shapes_, repeats_, most_mm);
    if (gap <= module_tolerance_mm) return;
    const std::vector<BarePlace> bare = bare_places(shapes_, repeats_);
    if (gap >= most_mm) refuse_bare(widest_of(bare), 0.0);
    shapes_ = welded(grown(as_drawn, 0.5 * gap), repeats_);
    if (take_apart(shapes_, repeats_)) refuse_bare(widest_of(bare), 0.0);
    gap_mm_ = gap;
  }

  // The stones of the cells: those that are no stones are refused.
  void put_stones(Pavement& pavement) const {
    Module made;
    made.along_mm = repeats_.along();
    made.across_mm = repeats_.across();
    made.stones.reserve(shapes_.size());
    made.least_face_mm2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const Polygon face = face_of(i);
      const vec2 axis = axis_of(face);
      if (geometry::area(face) < made.least_face_mm2) {
        made.least_face_mm2 = geometry::area(face);
        pavement.stone_mm = size_of(extent(face, axis));
      }
      made.stones.push_back({from_lower_left(shapes_[i]), axis});
    }
    require_covered(std::max(pavement.stone_mm.x, pavement.stone_mm.y));
    move_together(made);
    pavement.bonding.module_drawn = std::move(made);
  }

 private:
  void require_bounds() const {
    const std::size_t count = drawn_.stones.size();
    if (count > most_module_stones) {
      throw InputError(drawn_.place_of_stones,
                       fmt::format("expected a drawing of at most {} closed shapes, got {}", most_module_stones, count));
    }
    std::size_t corners = 0;
    for (const DrawnStone& stone : drawn_.stones) {
      corners += stone.shape_mm.outline.size();
      if (stone.shape_mm.holes.empty()) continue;
      throw InputError(stone.place,
                       fmt::format("expected a stone, which has no hole, got a shape with {}", stone.shape_mm.holes.size()));
    }
    if (corners > most_module_corners) {
      throw InputError(drawn_.place_of_stones,
                       fmt::format("expected shapes of at most {} corners in all, got {}", most_module_corners, corners));
    }
  }

  // Once the vectors are sound, so that no shape meets more repeats than can be looked at.
  void require_reach() const {
    const double least = stone_bounds_mm.low;
    const double shorter = glm::length(repeats_.along());
    if (!(shorter >= least && repeats_.area() >= least * shorter)) {
      throw InputError(drawn_.place_of_vectors,
                       fmt::format("expected two vectors of {} mm or more that are not parallel, got [{}, {}] and [{}, {}]",
                                   least, drawn_.first_mm.x, drawn_.first_mm.y, drawn_.second_mm.x, drawn_.second_mm.y));
    }
    double drawn_mm2 = 0.0;
    for (const Polygon& shape : shapes_) drawn_mm2 += geometry::area(shape);
    constexpr double much = 1.5;  // less is told by where shapes overlap
    if (drawn_mm2 > much * repeats_.area()) {
      throw InputError(drawn_.place_of_vectors,
                       fmt::format("expected vectors that span the area of the shapes, {:.6g} m², got a span of {:.6g} m²",
                                   1e-6 * drawn_mm2, 1e-6 * repeats_.area()));
    }
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const vec2 size = size_of_box(extent_in(repeats_, shapes_[i]));
      if (std::max(size.x, size.y) <= longest_module_stone) continue;
      throw InputError(drawn_.stones[i].place, fmt::format("expected a stone that reaches over at most {} repeats, got {:.0f}",
                                                           longest_module_stone, std::max(size.x, size.y)));
    }
  }

  static vec2 size_of_box(const Box& box) { return box.high - box.low; }

  [[noreturn]] void refuse_overlap(const Overlap& overlap) const {
    const std::string what =
        overlap.one == overlap.other ? std::string("its own repeat") : fmt::format("shape {} or a repeat of it", overlap.other);
    throw InputError(drawn_.stones[overlap.one].place,
                     fmt::format("expected shapes that do not overlap, got one that lies over {}, by {:.2f} mm at ({:.1f}, "
                                 "{:.1f})",
                                 what, overlap.width_mm, overlap.middle_mm.x, overlap.middle_mm.y));
  }

  // Of all repeats of a place, that within the vectors from the origin of the drawing.
  vec2 in_drawing(vec2 place) const {
    const vec2 a = drawn_.first_mm;
    const vec2 b = drawn_.second_mm;
    return place - std::floor(cross(place, b) / cross(a, b)) * a - std::floor(cross(a, place) / cross(a, b)) * b;
  }

  [[noreturn]] void refuse_bare(const geometry::Circle& bare, double grown_mm) const {
    const vec2 place = in_drawing(bare.middle);
    throw InputError(
        drawn_.place_of_stones,
        fmt::format("expected shapes that touch, or gaps of one width between all of them up to joint_mm = {}, got "
                    "a bare place {:.2f} mm wide at ({:.1f}, {:.1f})",
                    joint_mm_, 2.0 * bare.radius + grown_mm, place.x, place.y));
  }

  void require_covered(double longer_mm) const {
    std::vector<BarePlace> bare = bare_places(shapes_, repeats_);
    std::erase_if(bare, [&](const BarePlace& place) {
      return place.is_spot && 2.0 * place.widest.radius <= std::max(module_tolerance_mm, widest_bare * longer_mm);
    });
    if (!bare.empty()) refuse_bare(widest_of(bare), gap_mm_);
  }

  static geometry::Circle widest_of(const std::vector<BarePlace>& places) {
    geometry::Circle result;
    for (const BarePlace& place : places) {
      if (place.widest.radius > result.radius) result = place.widest;
    }
    return result;
  }

  Polygon face_of(std::size_t stone) const {
    const auto faces = faces_of(moved(shapes_[stone], {0.0, 0.0}), joint_mm_);
    if (faces.size() > 1) {
      throw InputError(drawn_.stones[stone].place,
                       fmt::format("expected a stone that is wider than joint_mm = {} everywhere, got one that falls into {}",
                                   joint_mm_, faces.size()));
    }
    const vec2 size = faces.empty() ? vec2{0.0, 0.0} : size_of(extent(faces.front(), axis_of(faces.front())));
    if (!(std::min(size.x, size.y) >= stone_bounds_mm.low)) {
      throw InputError(drawn_.stones[stone].place,
                       fmt::format("expected a stone that is {} mm wide or more beside joint_mm = {}, got {:.2f} mm",
                                   stone_bounds_mm.low, joint_mm_, std::min(size.x, size.y)));
    }
    return faces.front();
  }

  // The first stone begins at the origin, and all begin within one repeat from there.
  void move_together(Module& made) const {
    constexpr double rounding = 1e-6;
    const vec2 origin = made.stones.front().cell_mm.front();
    for (Module::Stone& stone : made.stones) {
      const vec2 by = repeats_.at(glm::floor(repeats_.parts_of(stone.cell_mm.front() - origin) + rounding)) + origin;
      for (vec2& p : stone.cell_mm) p -= by;
    }
  }

  const DrawnModule& drawn_;
  double joint_mm_;
  Repeats repeats_;
  std::vector<Polygon> shapes_;  // at last the cells
  double gap_mm_ = 0.0;          // by which they grew together
};

}  // namespace

void lay_as_drawn(Pavement& pavement, const DrawnModule& drawn) {
  Making making(drawn, pavement.joint_mm);
  making.make_cells();
  making.put_stones(pavement);
}

}  // namespace shatterpave::paving
