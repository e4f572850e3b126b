// The room in the plane that a crack has for itself: see crack_surface.h.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/vec.h"
#include "geometry/segment_index.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

// A place along a crack.
struct Station {
  vec2 point_mm{0.0, 0.0};
  vec2 across{0.0, 0.0};  // unit, to the left
  double along_mm = 0.0;  // from the start of the path
  double room_mm = 0.0;   // how far to either side along `across` the crack has room; below 0 where it has none
};

struct CorridorShape {
  double reach_mm = 0.0;         // the most room that is asked for
  double longest_step_mm = 0.0;  // between stations
  double joint_mm = 0.0;         // see below
};

// Where the start or the end of a path lies on another path.
struct CrackJoint {
  std::size_t path = 0;   // the one that ends
  bool at_end = true;     // by its end or by its start
  std::size_t on = 0;     // the one it ends on
  double along_mm = 0.0;  // how far along that one
  double sine = 1.0;      // of the angle between the two; less where they run close beside each other before they meet
};

// What is left free about cracks, but where more is needed: see CorridorShape.
inline constexpr double crack_clearance_mm = 0.02;

// The paths of a pane, and the room of each. Between two stations, take the point P(u) and the room r(u), both linear in u.
// Then two points P(u) + q across, |q| <= r(u), of two paths are farther apart than 2 crack_clearance_mm; unless one path ends
// on the other, and the points lie within joint_mm and a step of its end, and within 2 joint_mm and a step of the joint on the
// other. Near a joint the free width shrinks by the sine of its angle. The outline counts as a path, and a zone as one for all
// cracks but those that start in it. Chips, which hug the crack that they are beside, are left out.
class Corridors {
 public:
  Corridors(const Pane& pane, const CrackNetwork& network, const std::vector<ImpactZone>& zones, const CorridorShape& shape);

  const std::vector<CrackPath>& paths() const { return paths_; }
  double length_mm(std::size_t path) const { return lengths_[path]; }
  // How far along the path its place nearest to the point lies.
  double along_mm(std::size_t path, vec2 point) const;
  // The stations of a path, from where it leaves the zone that it starts in; none where it does not leave it.
  std::vector<Station> stations(std::size_t path) const;
  // Of the start or the end of the path; null where it does not lie on another one.
  const CrackJoint* joint(std::size_t path, bool at_end) const;
  // Whether the path ends on another one within `reach_mm` of an end of that one.
  bool joins_near_end(std::size_t path, double reach_mm) const;
  // Whether the path ends on that one.
  bool joins(std::size_t path, std::size_t on) const;
  // The sides of the outline that come near to the box about `low` and `high`.
  std::vector<std::pair<vec2, vec2>> sides_near(vec2 low, vec2 high) const;

  struct Interval {  // along a path
    double low = 0.0;
    double high = 0.0;
  };

 private:
  struct Piece {
    std::size_t path = 0;  // or `outline`
    double from_mm = 0.0;  // along its path
    vec2 a{0.0, 0.0};
    vec2 b{0.0, 0.0};
  };
  static constexpr std::size_t outline = static_cast<std::size_t>(-1);

  void add_piece(const Piece& piece);
  void add_joint(std::size_t path, bool at_end, std::size_t on);
  void add_joints(const CrackNetwork& network);
  void leave_hooks();
  double edge_sine(std::size_t path, bool at_end) const;
  void cut_out_exempt(std::size_t path, double along, std::size_t other, std::vector<Interval>& parts) const;
  double distance_to_side(std::size_t path, double along, vec2 point, const Piece& side) const;
  double free_distance(std::size_t path, double along, vec2 point) const;
  double distance_to_piece(std::size_t path, double along, vec2 point, const Piece& piece) const;
  double approach_sine(std::size_t path, bool at_end, const std::vector<std::pair<vec2, vec2>>& to) const;
  double joint_room(std::size_t path, double along) const;
  void limit_rooms(std::size_t path, std::vector<Station>& stations) const;

  CorridorShape shape_;
  std::vector<ImpactZone> zones_;
  std::vector<CrackPath> paths_;
  std::vector<int> own_zones_;  // of each path: the zone it starts in, or -1
  std::vector<double> lengths_;
  std::vector<Piece> pieces_;  // by number of the index
  std::vector<CrackJoint> joints_;
  std::vector<std::pair<double, double>> edge_sines_;  // of each path: as that of a joint, where it starts or ends at the edge
  std::vector<std::vector<std::size_t>> joints_of_;    // of each path, numbers of joints: its own ones and those on it
  geometry::SegmentIndex index_;
};

}  // namespace shatterpave::glass
