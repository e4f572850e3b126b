// The state of growth: what grows from one impact.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/angle.h"
#include "core/random.h"
#include "geometry/point_index.h"
#include "glass/growth/steering.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Cells of the index of tips: about as far as they are from one another where most grow.
inline constexpr double wide_cell_mm = 16.0 * px_mm;

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
  double first_mm = 0.0;   // length of the first step
  double length_mm = 0.0;
  std::uint32_t steps = 0;
  bool straight = false;  // its next step goes straight on
  vec2 start_mm{0.0, 0.0};
  std::optional<Ring> ring;
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

}  // namespace shatterpave::glass
