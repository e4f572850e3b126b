// The tips that grow from the impacts of a pane, and the map that they draw: what both laws of growth have in common. A law
// steers tips and says when they step; how they start, how far they get, and when they stop is decided here.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/segment_index.h"
#include "glass/growth/tip.h"
#include "glass/map/crack_map.h"

namespace shatterpave::glass {

class CrackFront {
 public:
  // The length of the first step of a tip, at least `least_mm`, mm.
  using FirstWay = std::function<double(const Tip& tip, double least_mm)>;

  // Cracks go into `map`. All arguments but the last two must outlive this.
  //   spares_rings  ring cracks that cracks enclose grow on, against the second stop rule
  CrackFront(const Pane& pane, std::uint64_t seed, CrackMap& map, bool spares_rings, FirstWay first_way);

  // All M radials, at equal angles from a random first one, N large ones spread evenly among them (eq. 9, 10, Fig. 11).
  void start_radials(ImpactState& state);
  // A radial that has not grown yet.
  Tip radial_tip(const ImpactState& state, CrackMap::Hub hub, int number, bool large);
  // Eq. 11, Fig. 12: two cracks, one each way round, at one speed.
  void start_arms(ImpactState& state, const RingStart& start);
  // Lets a tip grow that has its heading and the length of its first step.
  void add(ImpactState& state, Tip tip) const;

  // "Growth ends when all large and ring cracks have stopped" (§4.3). Where an impact has neither, and in real panes, its
  // radials grow until they have stopped.
  bool is_over(const ImpactState& state) const;

  // Leads the crack to where its tip came to be at `time`, if nothing is in the way. Where that closes a region, every tip
  // inside it stops (§4.2.3 (2)).
  void extend(const Tip& tip, vec2 to_mm, double time, const ImpactState& state);
  // Ends a crack that has got longer than a crack may. To be asked after every step.
  void stop_too_long(const Tip& tip);
  void forget_stopped(ImpactState& state) const;
  // Ends what still grows, and makes the cracks of this impact obstacles for the next, if there is one.
  void settle(const ImpactState& state);

  // On the pane's clock, of a time after the impact in units of the model.
  double time_us(int impact, double time) const {
    return pane_.impacts[static_cast<std::size_t>(impact)].time_us + unit_us(growth_) * time;
  }

  // Ring cracks, and all cracks of earlier impacts. It need not know of vertices that were inserted later.
  const geometry::SegmentIndex& obstacles() const { return obstacles_; }
  void add_obstacle(const geometry::Segment& segment) { obstacles_.add(segment); }

 private:
  // Points of the lattice; empty where nothing is bordered.
  using Border = std::vector<geometry::LatticePoint>;
  vec2 place(const Tip& tip, const ImpactState& state) const;
  Border piece(const Tip& tip, vec2 to_mm, double at_us);
  std::vector<const Tip*> growing_within(const Border& border, const ImpactState& state) const;

  const Pane& pane_;
  const Growth& growth_;
  std::uint64_t seed_;
  CrackMap& map_;
  bool spares_rings_;
  FirstWay first_way_;
  double longest_mm_;
  geometry::SegmentIndex obstacles_;
};

// The diagonal of the pane's box, mm.
double diagonal(const geometry::Polygon& outline);

// Cells of the indexes for F2, wider than those of the map.
double cell_of_walls(const Growth& growth);

}  // namespace shatterpave::glass
