#include "glass/map/growth_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "geometry/segment_distance.h"
#include "geometry/segment_index.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::Segment;

// A tip is rounded by up to 0.71 µm, and so is another one that comes towards it.
constexpr double tip_clearance_mm = 0.002;

// Cells of the index of segments: about the length of one.
constexpr double clock_cell_mm = 4.0;

constexpr int edge_of_pane = -1;

// ---- order

// Where a crack has a point.
std::size_t vertex_at(const Crack& crack, vec2 point) {
  const auto found = std::ranges::find(crack.points_mm, point);
  ENSURE(found != crack.points_mm.end());
  return static_cast<std::size_t>(found - crack.points_mm.begin());
}

// A crack that starts or ends in a vertex of another.
struct MeetingOnCrack {
  std::size_t crack = 0;
  bool at_end = true;
  std::size_t on = 0;
  std::size_t vertex = 0;
};

std::vector<MeetingOnCrack> meetings_of(const CrackNetwork& network) {
  std::vector<MeetingOnCrack> result;
  for (std::size_t i = 0; i < network.cracks.size(); ++i) {
    const Crack& crack = network.cracks[i];
    const auto note = [&](const CrackEnd& end, bool at_end) {
      if (!end.crack) return;
      const std::size_t on = network.index_of(*end.crack);
      const vec2 point = at_end ? crack.points_mm.back() : crack.points_mm.front();
      result.push_back({i, at_end, on, vertex_at(network.cracks[on], point)});
    };
    note(crack.start, false);
    note(crack.end, true);
  }
  return result;
}

// ---- tips

// All segments of a network and the pane's edge, by place.
class ClearOf {
 public:
  ClearOf(const Pane& pane, const CrackNetwork& network) : index_(clock_cell_mm) {
    for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
      const vec2 next = pane.outline_mm[(i + 1) % pane.outline_mm.size()];
      index_.add({geometry::to_lattice(pane.outline_mm[i]), geometry::to_lattice(next), edge_of_pane});
    }
    for (const Crack& crack : network.cracks) {
      for (std::size_t k = 0; k + 1 < crack.points_mm.size(); ++k) {
        index_.add({geometry::to_lattice(crack.points_mm[k]), geometry::to_lattice(crack.points_mm[k + 1]), crack.id});
      }
    }
  }

  // Whether a crack whose next segment goes from `from` to `to` can have its tip at `tip` beside it.
  bool is_clear(LatticePoint from, LatticePoint tip, const Segment& own) const {
    const geometry::LatticePoint low{std::min(from.x, tip.x) - margin, std::min(from.y, tip.y) - margin};
    const geometry::LatticePoint high{std::max(from.x, tip.x) + margin, std::max(from.y, tip.y) + margin};
    return std::ranges::none_of(index_.near(low, high), [&](int number) {
      const Segment other = index_.segment(number);
      return other != own && is_near(from, tip, other);
    });
  }

 private:
  static constexpr std::int64_t margin = 4;

  static bool is_near(LatticePoint from, LatticePoint tip, const Segment& other) {
    const vec2 p = geometry::to_mm(from);
    const vec2 q = geometry::to_mm(tip);
    const vec2 a = geometry::to_mm(other.a);
    const vec2 b = geometry::to_mm(other.b);
    // Those that start where the tip's own way does lie apart from it by their angle, most at the tip.
    if (other.a == from || other.b == from) {
      const vec2 far = other.a == from ? b : a;
      return geometry::distance_to_segment(q, a, b) < tip_clearance_mm ||
             (glm::length(far - p) < glm::length(q - p) && geometry::distance_to_segment(far, p, q) < tip_clearance_mm);
    }
    if (geometry::segments_meet(from, tip, other.a, other.b)) return true;
    const std::array<double, 4> distances{geometry::distance_to_segment(q, a, b), geometry::distance_to_segment(p, a, b),
                                          geometry::distance_to_segment(a, p, q), geometry::distance_to_segment(b, p, q)};
    return *std::ranges::min_element(distances) < tip_clearance_mm;
  }

  geometry::SegmentIndex index_;
};

double length_from(const Crack& crack, std::size_t vertex) {
  double length = 0.0;
  for (std::size_t k = vertex; k + 1 < crack.points_mm.size(); ++k) {
    length += glm::length(crack.points_mm[k + 1] - crack.points_mm[k]);
  }
  return length;
}

// The tip on the segment after the vertex: the last place that it may show at by then, if there is one.
std::optional<vec2> tip_at(const Crack& crack, std::size_t vertex, double time_us, const ClearOf& all) {
  const double from_us = crack.times_us[vertex];
  const double to_us = crack.times_us[vertex + 1];
  const vec2 a = crack.points_mm[vertex];
  const vec2 b = crack.points_mm[vertex + 1];
  const double places = std::ceil(glm::length(b - a) / tip_step_mm);
  const LatticePoint from = geometry::to_lattice(a);
  const LatticePoint to = geometry::to_lattice(b);
  for (double place = std::floor((time_us - from_us) / (to_us - from_us) * places); place > 0.0; --place) {
    const LatticePoint tip = geometry::to_lattice(glm::mix(a, b, place / places));
    if (tip != from && tip != to && all.is_clear(from, tip, {from, to, crack.id})) return geometry::to_mm(tip);
  }
  return std::nullopt;
}

// What has grown of a crack; nothing that shows: without points.
Crack crack_at(const Crack& crack, double time_us, const ClearOf& all) {
  Crack result = crack;
  result.times_us.clear();
  if (crack.times_us.back() < time_us) return result;
  result.points_mm.clear();
  const auto gone = std::ranges::lower_bound(crack.times_us, time_us) - crack.times_us.begin();
  if (gone == 0) return result;
  const auto count = static_cast<std::size_t>(gone);
  result.points_mm.assign(crack.points_mm.begin(), crack.points_mm.begin() + gone);
  double left_mm = length_from(crack, count - 1);
  if (const auto tip = tip_at(crack, count - 1, time_us, all)) {
    left_mm -= glm::length(*tip - result.points_mm.back());
    result.points_mm.push_back(*tip);
  }
  if (result.points_mm.size() < 2) result.points_mm.clear();
  result.end = {CrackEnd::At::open, std::nullopt};
  result.rest = CrackRest{crack.end.at, left_mm};
  return result;
}

}  // namespace

void settle_times(CrackNetwork& network) {
  const std::vector<MeetingOnCrack> meetings = meetings_of(network);
  // Times only rise, and only to times that there are, so this ends.
  for (bool changed = true; changed;) {
    changed = false;
    for (const MeetingOnCrack& meeting : meetings) {
      // A crack is there once it has two points.
      const double there_us = network.cracks[meeting.on].times_us[std::max<std::size_t>(meeting.vertex, 1)];
      std::vector<double>& own = network.cracks[meeting.crack].times_us;
      if ((meeting.at_end ? own.back() : own.front()) >= there_us) continue;
      changed = true;
      if (meeting.at_end) {
        own.back() = there_us;
      } else {
        for (double& time : own) time = std::max(time, there_us);
      }
    }
  }
}

namespace {

// An impact that the pane does not name comes at once.
double impact_us(const Pane& pane, std::size_t impact) {
  return impact < pane.impacts.size() ? pane.impacts[impact].time_us : 0.0;
}

}  // namespace

void time_by_front(const Pane& pane, CrackNetwork& network) {
  const double speed_mm_us = pane.growth.crack_speed_m_s / 1000.0;
  for (Crack& crack : network.cracks) {
    const auto impact = static_cast<std::size_t>(crack.impact);
    const vec2 from = impact < network.impacts.size() ? network.impacts[impact].at_mm : crack.points_mm.front();
    crack.times_us.clear();
    for (const vec2 p : crack.points_mm) {
      const double front_us = impact_us(pane, impact) + glm::length(p - from) / speed_mm_us;
      crack.times_us.push_back(crack.times_us.empty() ? front_us : std::max(front_us, crack.times_us.back()));
    }
  }
  settle_times(network);
}

CrackNetwork network_at(const Pane& pane, const CrackNetwork& network, double time_us) {
  CrackNetwork result;
  for (std::size_t i = 0; i < network.impacts.size(); ++i) {
    if (impact_us(pane, i) < time_us) result.impacts.push_back(network.impacts[i]);
  }
  const ClearOf all(pane, network);
  for (const Crack& crack : network.cracks) {
    ENSURE(crack.times_us.size() == crack.points_mm.size());
    Crack grown = crack_at(crack, time_us, all);
    if (!grown.points_mm.empty()) result.cracks.push_back(std::move(grown));
  }
  return result;
}

}  // namespace shatterpave::glass
