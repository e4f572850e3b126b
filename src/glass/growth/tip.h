// The state of growth: what grows from one impact.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/angle.h"
#include "core/random.h"
#include "geometry/point_index.h"
#include "glass/growth/radial_course.h"
#include "glass/growth/steering.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Cells of the index of tips: about as far as they are from one another where most grow.
inline constexpr double wide_cell_mm = 16.0 * px_mm;

// Pieces of a step shorter than this are not worth a vertex.
inline constexpr double least_piece_mm = 0.02;

// Speeds on the pane's clock: of the mean large crack, and of ring cracks.
inline double crack_speed_mm_us(const Growth& growth) { return growth.crack_speed_m_s / 1000.0; }
inline double ring_speed_mm_us(const Growth& growth) {
  return crack_speed_mm_us(growth) * growth.circular_speed / growth.large_speed;
}
// On that clock, one unit of time of the model: in it the mean large crack runs large_speed px.
inline double unit_us(const Growth& growth) { return growth.large_speed * px_mm / crack_speed_mm_us(growth); }

struct Tip {
  int crack = 0;
  CrackKind kind = CrackKind::radial;
  Id id;
  vec2 at_mm{0.0, 0.0};
  vec2 heading{1.0, 0.0};  // of unit length
  double speed_mm = 0.0;   // per unit of time
  double onset = 0.0;      // how long it waits before it starts
  double due = 0.0;        // when its next step is done
  double inertia = 1.0;    // see inertia()
  double decay = 1.0;      // by which a step of this tip multiplies it
  double way_mm = 0.0;     // length of the step that it is about to end
  double length_mm = 0.0;
  std::uint32_t steps = 0;
  bool straight = false;  // its next step goes straight on
  vec2 start_mm{0.0, 0.0};
  std::optional<Ring> ring;
  // Of a radial of Pattern::real.
  std::optional<RadialCourse> course;
  std::size_t kinks_gone = 0;
  bool veered = false;  // it has given up and goes straight to a neighbour
};

// A starting point of a ring crack whose time has not come.
struct RingStart {
  int index = 0;
  Angle direction;
  double radius_mm = 0.0;
};

struct ImpactState {
  int index = 0;
  Id id;
  vec2 at_mm{0.0, 0.0};
  ImpactCounts counts;
  double now = 0.0;
  std::vector<RingStart> waiting;
  std::vector<Tip> tips;
  std::vector<Tip> branches;                  // new ones, not among them yet
  std::vector<int> growing;                   // those of them that grow
  geometry::PointIndex places{wide_cell_mm};  // where those are
};

// What the impact with that index has before anything grows: its counts, and the starting points of its ring cracks (eq. 4, 7,
// 8).
ImpactState initial_state(const Pane& pane, int impact, std::uint64_t seed);

}  // namespace shatterpave::glass
