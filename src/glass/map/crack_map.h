// The cracks of a pane while they grow, with exact topology: no two cross, and where one ends on another, that one has a
// vertex there. All vertices lie on the lattice, and every decision is exact.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "geometry/growing_store.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "geometry/segment_index.h"
#include "glass/map/contact_graph.h"
#include "glass/network.h"

namespace shatterpave::glass {

// How a crack ended.
struct Arrest {
  CrackEnd end;
  // The border of the region that it closed by ending (§4.2.3 (2)), along cracks; empty if it closed none. It may touch itself.
  std::vector<geometry::LatticePoint> closed_region;
};

class CrackMap {
 public:
  // A place from which cracks start: an impact, or the starting point of a ring crack.
  using Hub = int;
  static constexpr int edge_owner = -1;

  //   outline  as in Pane
  //   cell_mm  > 0, cell of the index: about the length of a step of growth
  //   tells_regions  whether arrests tell the regions that they close, which costs more than all else
  CrackMap(geometry::Polygon outline, double cell_mm, bool tells_regions = true);

  // A place for cracks to start at, not on the edge. Where it lies on a crack, that crack gets a vertex there.
  Hub add_hub(geometry::LatticePoint at);
  // Whether the point lies on a crack or on the edge, or is a place at which cracks start.
  bool is_taken(geometry::LatticePoint at) const;
  // Whether the straight way meets the edge, or a crack of an impact before `impact`.
  bool is_barred(geometry::LatticePoint from, geometry::LatticePoint to, int impact) const;

  // A new crack that starts at the hub, which for At::crack lay on one when it was added. Cracks are numbered from 0.
  //   at_us  when it starts; zeros where nobody asks for times
  int start(Hub hub, CrackKind kind, int impact, CrackEnd::At start, double at_us = 0.0);

  // Lets a growing crack go straight on to `to`. If nothing is in the way, adds that vertex and returns nothing; else ends the
  // crack where it first meets a crack or the edge: on the edge, within 1 µm of it and not outside. A growing crack whose tip
  // is met ends there as well.
  //   at_us  when it comes to `to`, at one speed all the way; not before it came to its tip
  std::optional<Arrest> extend(int crack, geometry::LatticePoint to, double at_us = 0.0);
  // The same at a speed, > 0.
  std::optional<Arrest> run(int crack, geometry::LatticePoint to, double speed_mm_us);
  // Ends a growing crack that has met nothing.
  void stop(int crack, CrackEnd::At at);

  // The nearest crack within the sector of those for which accept(crack) holds.
  template <typename Accept>
  std::optional<geometry::SegmentIndex::Nearest> nearest_in(const geometry::Sector& sector, Accept accept) const {
    return index_.nearest_in(
        sector, [&](const geometry::Segment& segment) { return segment.owner != edge_owner && accept(segment.owner); });
  }
  // Calls visit(number) for every segment, of cracks and of the edge, that may have a point in the box: for some more than
  // once.
  template <typename Visit>
  void visit_in(const geometry::Box& box, Visit visit) const {
    index_.visit_in(box, visit);
  }
  // Its owner is the number of a crack, or edge_owner.
  geometry::Segment segment(int number) const { return index_.segment(number); }

  bool is_growing(int crack) const { return record(crack).growing; }
  CrackKind kind(int crack) const { return record(crack).kind; }
  int impact(int crack) const { return record(crack).impact; }
  geometry::LatticePoint tip(int crack) const {
    const Record& asked = record(crack);
    return asked.pieces.empty() ? origin(asked) : segment(asked.pieces.back()).b;
  }
  // The numbers of its segments, from its start to its tip: each begins where the one before ends.
  std::span<const int> pieces(int crack) const { return record(crack).pieces; }
  // When the crack came to its tip; and to the place on it that is nearest to `p`.
  double tip_us(int crack) const { return record(crack).times_us.back(); }
  double time_us(int crack, geometry::LatticePoint p) const;
  // Its start, and the end of each of its pieces.
  std::vector<geometry::LatticePoint> points(int crack) const;

  // All cracks, in the order in which they started, but those that had no room for a second point.
  //   with_times  with the times that tips came to their points
  std::vector<Crack> cracks(bool with_times = false) const;

 private:
  struct Record {
    CrackKind kind = CrackKind::radial;
    int impact = 0;
    Hub hub = 0;   // where it starts
    int node = 0;  // in the graph of contacts
    bool growing = true;
    std::vector<int> pieces;
    std::vector<double> times_us;  // of its start, and of the end of each piece
    CrackEnd::At start = CrackEnd::At::impact;
    CrackEnd end;
  };
  struct HubRecord {
    geometry::LatticePoint at;
    int node = 0;
    int crack = -1;  // on which it lies
  };
  struct Hit {
    int segment = 0;
    double share = 0.0;  // of the way, in [0, 1]
  };

  const Record& record(int crack) const { return cracks_[static_cast<std::size_t>(crack)]; }
  Record& record(int crack) { return cracks_[static_cast<std::size_t>(crack)]; }
  geometry::LatticePoint origin(const Record& record) const { return hubs_[static_cast<std::size_t>(record.hub)].at; }
  bool is_edge(int segment) const;
  bool is_taken(geometry::LatticePoint at, int except) const;

  std::vector<Hit> hits(geometry::LatticePoint from, geometry::LatticePoint to) const;
  bool is_free(geometry::LatticePoint from, geometry::LatticePoint to, int except) const;
  bool can_join(geometry::LatticePoint from, geometry::LatticePoint joint, int met) const;
  int ended_at(geometry::LatticePoint at, int but) const;
  Arrest join(int crack, geometry::LatticePoint joint, int met, double at_us);
  void append(int crack, geometry::LatticePoint to, double at_us);
  void insert_vertex(int segment, geometry::LatticePoint point);
  std::vector<geometry::LatticePoint> closed_region(int crack, int met);
  void walk(int node, geometry::LatticePoint from, geometry::LatticePoint to,
            std::vector<geometry::LatticePoint>& border) const;

  geometry::Polygon outline_;
  bool tells_regions_;
  geometry::SegmentIndex index_;
  ContactGraph graph_;
  geometry::GrowingStore<Record> cracks_;
  std::vector<HubRecord> hubs_;
  std::set<geometry::LatticePoint> hub_places_;
  std::vector<int> crack_of_node_;  // −1 for a hub
};

}  // namespace shatterpave::glass
