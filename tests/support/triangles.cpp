#include "support/triangles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace shatterpave::support {

namespace {

// The way from a to b in lattice steps.
vec3 steps(vec3 a, vec3 b) {
  const auto whole = [](double from, double to) { return std::round(to * 1000.0) - std::round(from * 1000.0); };
  return {whole(a.x, b.x), whole(a.y, b.y), whole(a.z, b.z)};
}

// Six times the volume of a tetrahedron: positive where d sees a, b, c clockwise. Exact: whole numbers, for triangles that come
// near each other below 2^53.
double volume(vec3 a, vec3 b, vec3 c, vec3 d) { return glm::dot(glm::cross(steps(a, b), steps(a, c)), steps(a, d)); }

bool opposite(double a, double b) { return (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0); }

// Whether the segment p → q passes through the triangle: its ends lie on two sides of the plane, and it passes all sides of the
// triangle alike.
bool passes(vec3 p, vec3 q, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  if (!opposite(volume(a, b, c, p), volume(a, b, c, q))) return false;
  const double ab = volume(a, b, p, q);
  const double bc = volume(b, c, p, q);
  const double ca = volume(c, a, p, q);
  return !opposite(ab, bc) && !opposite(bc, ca) && !opposite(ca, ab);
}

struct Box {
  vec3 low;
  vec3 high;
  std::size_t triangle;
};

bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z &&
         b.low.z <= a.high.z;
}

std::vector<Box> boxes(const std::vector<Triangle>& triangles) {
  std::vector<Box> result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i].corners;
    result.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
  }
  return result;
}

// Halves the boxes by their middles, as long as that parts them, and visits the pairs of each small group. A box that reaches
// over the cut goes to both sides; a pair is visited where the lower corner of its common part lies.
void visit_pairs(std::vector<Box> group, vec3 low, vec3 high, int depth,
                 const std::function<void(const Box&, const Box&)>& visit) {
  const auto visit_all = [&] {
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!boxes_meet(group[i], group[j])) continue;
        const vec3 corner = glm::max(group[i].low, group[j].low);
        const bool here = corner.x >= low.x && corner.x < high.x && corner.y >= low.y && corner.y < high.y;
        if (here) visit(group[i], group[j]);
      }
    }
  };
  if (group.size() < 32 || depth > 40) return visit_all();
  const bool by_x = depth % 2 == 0;
  const auto middle_of = [&](const Box& box) { return by_x ? box.low.x + box.high.x : box.low.y + box.high.y; };
  std::vector<double> middles;
  std::ranges::transform(group, std::back_inserter(middles), middle_of);
  std::ranges::nth_element(middles, middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2));
  const double cut = 0.5 * middles[middles.size() / 2];
  std::vector<Box> below;
  std::vector<Box> above;
  for (const Box& box : group) {
    if ((by_x ? box.low.x : box.low.y) < cut) below.push_back(box);
    if ((by_x ? box.high.x : box.high.y) >= cut) above.push_back(box);
  }
  if (below.size() + above.size() > 2 * group.size() - 8) return visit_all();
  group.clear();
  vec3 high_below = high;
  vec3 low_above = low;
  // Boxes that reach out of the part may have their middles outside of it.
  double& below_ends = by_x ? high_below.x : high_below.y;
  double& above_begins = by_x ? low_above.x : low_above.y;
  below_ends = std::min(below_ends, cut);
  above_begins = std::max(above_begins, cut);
  visit_pairs(std::move(below), low, high_below, depth + 1, visit);
  visit_pairs(std::move(above), low_above, high, depth + 1, visit);
}

void visit_pairs(const std::vector<Triangle>& triangles, const std::function<void(const Box&, const Box&)>& visit) {
  constexpr double far = 1e9;
  visit_pairs(boxes(triangles), {-far, -far, -far}, {far, far, far}, 0, visit);
}

}  // namespace

bool meet(const Triangle& a, const Triangle& b) {
  for (const vec3 corner : a.corners) {
    if (std::ranges::find(b.corners, corner) != b.corners.end()) return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (passes(a.corners[i], a.corners[(i + 1) % 3], b) || passes(b.corners[i], b.corners[(i + 1) % 3], a)) return true;
  }
  return false;
}

void visit_meeting(const std::vector<Triangle>& triangles, const std::function<void(const Triangle&, const Triangle&)>& visit) {
  visit_pairs(triangles, [&](const Box& a, const Box& b) {
    if (meet(triangles[a.triangle], triangles[b.triangle])) visit(triangles[a.triangle], triangles[b.triangle]);
  });
}

std::size_t meeting_pairs(const std::vector<Triangle>& triangles) {
  std::size_t count = 0;
  visit_meeting(triangles, [&](const Triangle&, const Triangle&) { ++count; });
  return count;
}

BoxPairs box_pairs(const std::vector<Triangle>& triangles) {
  BoxPairs result;
  visit_pairs(triangles, [&](const Box&, const Box&) { ++result.found; });
  const std::vector<Box> all = boxes(triangles);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) result.all += boxes_meet(all[i], all[j]) ? 1U : 0U;
  }
  return result;
}

}  // namespace shatterpave::support
