// At each station of a crack's corridor stands a column of points through the thickness. How far each lies aside of the crack's
// polyline follows from the lean there, which is a smooth noise along the crack, and from the bow; where that is more than the
// corridor has room for, the whole column is brought nearer. Then the ends are cut off before what the crack ends on.

#include "glass/gaps/crack_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/functions.h"
#include "core/parallel.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "glass/gaps/crack_corridor.h"
#include "glass/gaps/crack_walls.h"
#include "glass/gaps/crack_wave.h"
#include "glass/gaps/gap_meetings.h"
#include "glass/gaps/impact_zones.h"
#include "glass/map/growth_clock.h"
#include "glass/sheets.h"

namespace shatterpave::glass {

namespace {

using At = CrackEnd::At;

// Points from face to face of the pane: more do not show in walls that bow by a few degrees.
constexpr std::size_t rows_through = 5;
// No gap is made where there is less room than this to either side: it would be a tenth of a hair.
constexpr double least_room_mm = 0.012;
// Of the room, the most that half the gap takes; and its least width, which is some steps of the lattice.
constexpr double gap_share = 0.4;
constexpr double least_half_gap_mm = 0.003;
// The gap at its far side, by what it is where it opens, in cracks that run through. By eye.
constexpr double far_opening = 0.35;
// The same at the bottom of cracks that do not, and at tips within the glass.
constexpr double closed = 0.1;
// Over this share of a crack its gap narrows to a tip within the glass, and over this many thicknesses it gets shallower.
constexpr double tip_share = 0.25;
constexpr double tip_thicknesses = 3.0;
// Shallowest share of the depth, at a tip; and how far, in thicknesses, a tip runs ahead on the side where the crack opens.
constexpr double tip_depth = 0.45;
constexpr double tip_lead = 0.5;
// Longest step along a crack, in thicknesses and in lengths of twist.
constexpr double step_thicknesses = 0.75;
constexpr double step_twists = 0.12;
// How often cracks that end near the ends of others are cut off anew.
constexpr int most_rounds = 12;

// ---- a crack before it is cut off

struct Shape {
  double half_mm = 0.0;      // of the sheet's thickness, less the skin
  double tilt_slope = 0.0;   // tangents of the largest lean
  double curve_slope = 0.0;  // and of its change
  double reach_mm = 0.0;     // of the walls to either side
  double joint_clearance_mm = 0.0;
  CorridorShape corridor;
};

double tangent(Angle angle) { return sine(angle.radians()) / cosine(angle.radians()); }

Shape shape_of(const Pane& pane, const Sheet& glass) {
  const CrackSheet& sheet = pane.crack_sheet;
  Shape shape;
  shape.half_mm = 0.5 * glass.thickness_mm - crack_skin_mm;
  shape.tilt_slope = tangent(sheet.tilt);
  shape.curve_slope = tangent(sheet.curve);
  const double opening = sheet.opening_mm * (1.0 + sheet.opening_variation);
  shape.reach_mm = shape.half_mm * (shape.tilt_slope + 0.5 * shape.curve_slope) + 0.5 * opening + crack_clearance_mm;
  const double step = std::min(step_thicknesses * glass.thickness_mm, step_twists * sheet.twist_mm);
  shape.corridor.longest_step_mm = std::max(step, 0.1);
  shape.corridor.reach_mm = shape.reach_mm;
  shape.corridor.joint_mm = 2.5 * shape.reach_mm + shape.corridor.longest_step_mm;
  // Between two rows a wall may lie nearer than at them: by its bow (a parabola's height over a quarter of the thickness), and
  // by its twist (what four points of a face of the grid are off a plane).
  const double row = 2.0 * shape.half_mm / static_cast<double>(rows_through - 1);
  shape.joint_clearance_mm = crack_clearance_mm + row * shape.curve_slope / 8.0 +
                             row * shape.tilt_slope * std::min(1.0, shape.corridor.longest_step_mm / sheet.twist_mm);
  return shape;
}

class Builder {
 public:
  Builder(const Pane& pane, const Sheet& sheet, const CrackNetwork& network, const CrackSurfaces& impacts, std::uint64_t seed)
      : pane_(pane),
        sheet_(sheet),
        network_(network),
        impacts_(impacts),
        seed_(seed),
        shape_(shape_of(pane, sheet)),
        corridors_(pane, network, impacts.zones, shape_.corridor) {}

  // The walls of all paths, cut off where they end.
  std::vector<std::vector<Walls>> all_walls() const;
  CrackSurface surface(std::size_t path, const Walls& walls) const;
  // Takes off walls what has not grown yet; `now` is the network at the time.
  void cut_to(std::size_t path, const CrackNetwork& now, std::vector<Walls>& own) const;

 private:
  std::size_t count() const { return corridors_.paths().size(); }
  struct Profile {       // of a whole crack
    double side = 1.0;   // of z: where it opens
    double depth = 1.0;  // share of the thickness
    double length_mm = 0.0;
    bool open_start = false;  // ends within the glass
    bool open_end = false;
  };
  const Crack& crack(std::size_t path) const { return network_.crack(corridors_.paths()[path].crack); }
  const ImpactZone& zone_of(std::size_t path) const { return impacts_.zones[static_cast<std::size_t>(crack(path).impact)]; }
  Id id(std::size_t path) const { return Id(pane_.name).child("crack").child(static_cast<std::uint64_t>(crack(path).id)); }
  // The walls of a path, as many pieces as there is room for, and nothing cut off.
  std::vector<Walls> walls(std::size_t path) const;
  // Cuts them off where they end; `all` are those of all paths.
  std::vector<Walls> cut(std::size_t path, std::vector<Walls> own, const std::vector<std::vector<Walls>>& all) const;
  std::vector<std::size_t> near_ends() const;
  Profile profile(std::size_t path) const;
  void append_column(Walls& walls, const Station& station, const Profile& profile, const Id& id) const;
  void cut_tip(std::size_t path, bool at_end, bool is_last, Walls& walls, const std::vector<std::vector<Walls>>& all) const;
  double cut_zone(std::size_t path, bool at_end) const;
  std::vector<double> lags_of_tip(const Walls& walls) const;
  void cut_at_tip(double along_mm, Walls& walls) const;
  double tip_along_mm(std::size_t path, int crack, const CrackNetwork& now) const;
  std::optional<Barrier> barrier(std::size_t path, bool at_end, const Walls& own,
                                 const std::vector<std::vector<Walls>>& all) const;

  const Pane& pane_;
  Sheet sheet_;  // that the cracks run through
  const CrackNetwork& network_;
  const CrackSurfaces& impacts_;  // their zones and holes
  std::uint64_t seed_;
  Shape shape_;
  Corridors corridors_;
};

bool within_glass(const CrackEnd& end) { return end.at == At::open || end.at == At::enclosed; }

Builder::Profile Builder::profile(std::size_t path) const {
  const CrackPath& of = corridors_.paths()[path];
  Profile result;
  // The 3R rule: radial cracks open on the side away from the impact, ring cracks on that of the impact, which is the viewer's.
  result.side = crack(path).kind == CrackKind::circular ? 1.0 : -1.0;
  result.length_mm = corridors_.length_mm(path);
  result.open_start = within_glass(of.start);
  result.open_end = within_glass(of.end);
  if (result.open_start || result.open_end) {
    const CrackSheet& sheet = pane_.crack_sheet;
    result.depth =
        sheet.least_depth + (sheet.greatest_depth - sheet.least_depth) * uniform(seed_, {Stream::crack_depth, id(path)});
  }
  return result;
}

// 0 at a tip within the glass, 1 from `reach` on; 1 where there is no such tip.
double from_tip(bool open_start, bool open_end, double along, double length, double reach) {
  double nearest = 1.0;
  if (open_start) nearest = std::min(nearest, along / reach);
  if (open_end) nearest = std::min(nearest, (length - along) / reach);
  return std::clamp(nearest, 0.0, 1.0);
}

void Builder::append_column(Walls& walls, const Station& station, const Profile& profile, const Id& id) const {
  const CrackSheet& sheet = pane_.crack_sheet;
  const double x = station.along_mm / sheet.twist_mm;
  const auto tip = [&](double reach) {
    return from_tip(profile.open_start, profile.open_end, station.along_mm, profile.length_mm, reach);
  };
  const double tilt = shape_.tilt_slope * crack_wave(seed_, Stream::crack_tilt, id, x);
  const double curve = shape_.curve_slope * crack_wave(seed_, Stream::crack_curve, id, x);
  const double narrow = closed + (1.0 - closed) * tip(tip_share * profile.length_mm);
  const double opening =
      sheet.opening_mm * narrow * (1.0 + sheet.opening_variation * crack_wave(seed_, Stream::crack_opening, id, x));
  const double depth = profile.depth * (tip_depth + (1.0 - tip_depth) * tip(tip_thicknesses * sheet_.thickness_mm));
  const double far = profile.depth < 1.0 ? closed : far_opening;
  const double half_gap = std::min(0.5 * opening, gap_share * station.room_mm);

  std::vector<double> heights;
  std::vector<double> aside;
  double farthest = 0.0;
  for (std::size_t r = 0; r < walls.rows; ++r) {
    const double t = static_cast<double>(r) / static_cast<double>(walls.rows - 1);
    const double z = profile.side * shape_.half_mm * (1.0 - 2.0 * depth * t);
    heights.push_back(sheet_.middle_mm + z);
    aside.push_back(tilt * z + curve * (0.5 * z * z / shape_.half_mm - shape_.half_mm / 6.0));
    farthest = std::max(farthest, std::abs(aside.back()));
  }
  const double room = station.room_mm - half_gap;
  const double scale = farthest > room ? room / farthest : 1.0;
  for (std::size_t r = 0; r < walls.rows; ++r) {
    const double t = static_cast<double>(r) / static_cast<double>(walls.rows - 1);
    const double gap = std::max(least_half_gap_mm, half_gap * (1.0 - (1.0 - far) * t));
    const auto point = [&](double d) { return vec3{station.point_mm + d * station.across, heights[r]}; };
    walls.left.push_back(point(scale * aside[r] + gap));
    walls.right.push_back(point(scale * aside[r] - gap));
  }
  walls.along_mm.push_back(station.along_mm);
}

std::vector<Walls> Builder::walls(std::size_t path) const {
  const std::vector<Station> stations = corridors_.stations(path);
  const Profile shape = profile(path);
  const Id element = id(path);
  std::vector<Walls> result;
  bool goes_on = false;
  for (const Station& station : stations) {
    if (station.room_mm < least_room_mm) {
      goes_on = false;
      continue;
    }
    if (!goes_on) result.push_back({rows_through, {}, {}, {}});
    goes_on = true;
    append_column(result.back(), station, shape, element);
  }
  std::erase_if(result, [](const Walls& walls) { return walls.columns() < 2; });
  return result;
}

// What the start or the end of a path lies on; nothing where it is within the glass. `own` are walls that run towards it.
std::optional<Barrier> Builder::barrier(std::size_t path, bool at_end, const Walls& own,
                                        const std::vector<std::vector<Walls>>& all) const {
  const CrackPath& of = corridors_.paths()[path];
  const double zone = 2.0 * shape_.corridor.joint_mm + 2.0 * shape_.corridor.longest_step_mm;
  if ((at_end ? of.end : of.start).at == At::edge) {
    const vec3 tip = own.left.back();
    const vec2 middle{tip.x, tip.y};
    return Barrier{
        [sides = corridors_.sides_near(middle - vec2{zone, zone}, middle + vec2{zone, zone})](double) { return sides; }};
  }
  if (!at_end && of.start.at == At::impact) return rim_of(impacts_, zone_of(path));
  const CrackJoint* joint = corridors_.joint(path, at_end);
  if (joint == nullptr) return std::nullopt;
  const auto slice = [&all, zone, on = joint->on, along = joint->along_mm](double z) {
    Pieces pieces;
    for (const Walls& walls : all[on]) append_slice(walls, z, along - zone, along + zone, pieces);
    return pieces;
  };
  return Barrier{slice, profile(joint->on).depth < 1.0};
}

// How far the front of a tip within the glass lags behind, by row.
std::vector<double> Builder::lags_of_tip(const Walls& walls) const {
  std::vector<double> lags;
  const double longest = std::min(tip_lead * sheet_.thickness_mm, 0.3 * (walls.along_mm.back() - walls.along_mm.front()));
  for (std::size_t r = 0; r < walls.rows; ++r) {
    const double t = static_cast<double>(r) / static_cast<double>(walls.rows - 1);
    lags.push_back(longest * t * t);
  }
  return lags;
}

// Cuts off the end of walls that run towards the end, or the start, of the path; `is_last`: they reach it.
void Builder::cut_tip(std::size_t path, bool at_end, bool is_last, Walls& walls,
                      const std::vector<std::vector<Walls>>& all) const {
  const CrackEnd& end = at_end ? corridors_.paths()[path].end : corridors_.paths()[path].start;
  if (const auto before = barrier(path, at_end, walls, all)) {
    cut_end(walls, *before, cut_zone(path, at_end), shape_.joint_clearance_mm, is_last);
  } else if (is_last && within_glass(end)) {
    cut_back(walls, lags_of_tip(walls));
  }
}

// How far from the end of a path its walls may meet what it ends on.
double Builder::cut_zone(std::size_t path, bool at_end) const {
  const bool at_rim = !at_end && corridors_.paths()[path].start.at == At::impact;
  const double rim = at_rim ? zone_of(path).radius_mm - zone_of(path).start_mm : 0.0;
  return shape_.corridor.joint_mm + shape_.corridor.longest_step_mm + rim;
}

std::vector<Walls> Builder::cut(std::size_t path, std::vector<Walls> own, const std::vector<std::vector<Walls>>& all) const {
  const double length = corridors_.length_mm(path);
  for (Walls& walls : own) {
    const double from = walls.along_mm.front();
    const double left = length - walls.along_mm.back();
    if (left <= cut_zone(path, true)) cut_tip(path, true, left < 1e-9, walls, all);
    if (from > cut_zone(path, false) || walls.columns() < 2) continue;
    reverse(walls, length);
    cut_tip(path, false, from == 0.0, walls, all);
    reverse(walls, length);
  }
  std::erase_if(own, [](const Walls& walls) { return walls.columns() < 2; });
  return own;
}

// The paths that end on others near an end of these.
std::vector<std::size_t> Builder::near_ends() const {
  const double cut_mm = shape_.corridor.joint_mm + shape_.corridor.longest_step_mm;
  double widest_mm = 0.0;
  for (const ImpactZone& zone : impacts_.zones) widest_mm = std::max(widest_mm, zone.radius_mm - zone.start_mm);
  std::vector<std::size_t> found;
  for (std::size_t path = 0; path < count(); ++path) {
    if (corridors_.joins_near_end(path, 3.0 * cut_mm + widest_mm)) found.push_back(path);
  }
  return found;
}

// Where a path is cut off its columns are shared out anew, so that its walls no longer bend quite where they did. What ends on
// it there is cut off before all that its walls have been, whole and cut, again and again until nothing changes: then it is
// clear of what they are. Each time, ends can only come to lie farther back. The few rounds that there may be are enough for
// one path on the end of the next, several in succession; what would go on is left out, which leaves room to all others.
std::vector<std::vector<Walls>> Builder::all_walls() const {
  std::vector<std::vector<Walls>> whole(count());
  parallel_for(count(), [&](std::size_t i) { whole[i] = walls(i); });
  std::vector<std::vector<Walls>> result(count());
  parallel_for(count(), [&](std::size_t i) { result[i] = cut(i, whole[i], whole); });
  std::vector<std::vector<Walls>> been = whole;
  for (std::size_t i = 0; i < count(); ++i) been[i].insert(been[i].end(), result[i].begin(), result[i].end());
  const std::vector<std::size_t> at_ends = near_ends();
  std::vector<std::size_t> again = at_ends;
  for (int round = 0; !again.empty(); ++round) {
    std::vector<std::vector<Walls>> fresh(again.size());
    parallel_for(again.size(), [&](std::size_t k) {
      if (round < most_rounds) fresh[k] = cut(again[k], whole[again[k]], been);
    });
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < again.size(); ++k) {
      const std::size_t path = again[k];
      if (fresh[k] != result[path] && round < most_rounds) changed.push_back(path);
      result[path] = std::move(fresh[k]);
    }
    for (const std::size_t i : changed) been[i].insert(been[i].end(), result[i].begin(), result[i].end());
    again.clear();
    for (const std::size_t path : at_ends) {
      if (std::ranges::any_of(changed, [&](std::size_t on) { return corridors_.joins(path, on); })) again.push_back(path);
    }
  }
  return result;
}

// How far along the path the tip of a crack of it is; where it has not started, that is its start.
double Builder::tip_along_mm(std::size_t path, int crack, const CrackNetwork& now) const {
  const auto grown = std::ranges::lower_bound(now.cracks, crack, {}, &Crack::id);
  const bool is_there = grown != now.cracks.end() && grown->id == crack;
  return corridors_.along_mm(path, is_there ? grown->points_mm.back() : network_.crack(crack).points_mm.front());
}

// Ends walls at a tip, or leaves none of them. Columns are dropped first, so that those that are left stay where they are.
void Builder::cut_at_tip(double along_mm, Walls& walls) const {
  const auto beyond = std::ranges::lower_bound(walls.along_mm, along_mm);
  if (beyond == walls.along_mm.end()) return;
  const auto kept = static_cast<std::size_t>(beyond - walls.along_mm.begin()) + 1;
  walls.along_mm.resize(kept);
  walls.left.resize(kept * walls.rows);
  walls.right.resize(kept * walls.rows);
  if (kept < 2) return;
  std::vector<double> lags = lags_of_tip(walls);
  for (double& lag : lags) lag += walls.along_mm.back() - along_mm;
  cut_back(walls, lags);
}

void Builder::cut_to(std::size_t path, const CrackNetwork& now, std::vector<Walls>& own) const {
  const auto is_whole = [&](int crack) {
    const auto grown = std::ranges::lower_bound(now.cracks, crack, {}, &Crack::id);
    return grown != now.cracks.end() && grown->id == crack && !grown->rest;
  };
  const CrackPath& of = corridors_.paths()[path];
  const double length = corridors_.length_mm(path);
  for (Walls& walls : own) {
    if (!is_whole(of.crack)) cut_at_tip(tip_along_mm(path, of.crack, now), walls);
    if (!of.other_arm || is_whole(*of.other_arm) || walls.columns() < 2) continue;
    reverse(walls, length);
    cut_at_tip(length - tip_along_mm(path, *of.other_arm, now), walls);
    if (walls.columns() > 1) reverse(walls, length);
  }
  std::erase_if(own, [](const Walls& walls) { return walls.columns() < 2; });
}

vec3 on_lattice(vec3 point) {
  return {geometry::on_lattice(vec2{point.x, point.y}), geometry::to_mm(std::llround(point.z * geometry::lattice_per_mm))};
}

// Normals are those of the middle between the walls, by its neighbours in the grid.
CrackSurface Builder::surface(std::size_t path, const Walls& walls) const {
  CrackSurface result{crack(path).id, crack(path).impact, walls.rows, {}, {}, {}};
  std::ranges::transform(walls.left, std::back_inserter(result.left_mm), on_lattice);
  std::ranges::transform(walls.right, std::back_inserter(result.right_mm), on_lattice);
  const auto middle = [&](std::size_t column, std::size_t row) {
    const std::size_t i = column * walls.rows + row;
    return 0.5 * (walls.left[i] + walls.right[i]);
  };
  for (std::size_t c = 0; c < walls.columns(); ++c) {
    for (std::size_t r = 0; r < walls.rows; ++r) {
      const std::size_t c0 = c == 0 ? 0 : c - 1;
      const std::size_t c1 = std::min(c + 1, walls.columns() - 1);
      const vec3 along = middle(c1, r) - middle(c0, r);
      const vec3 up = middle(c, std::min(r + 1, walls.rows - 1)) - middle(c, r == 0 ? 0 : r - 1);
      const vec3 normal = glm::normalize(glm::cross(up.z >= 0.0 ? up : -up, along));
      result.normals.push_back(normal);
    }
  }
  return result;
}

// The gaps of a network through a sheet, clear of the zones and holes of `impacts`.
std::vector<CrackSurface> gaps_through(const Pane& pane, const Sheet& sheet, const CrackNetwork& network,
                                       const CrackSurfaces& impacts, std::uint64_t seed) {
  const auto now = pane.time_us ? std::optional(network_at(pane, network, *pane.time_us)) : std::nullopt;
  const Builder builder(pane, sheet, network, impacts, seed);
  // Of all that come to be, so that nothing is left out at one time and there at another.
  const std::vector<std::vector<Walls>> all =
      without_meetings(builder.all_walls(), [&](std::size_t path, const Walls& walls) { return builder.surface(path, walls); });
  std::vector<std::vector<CrackSurface>> of_paths(all.size());
  parallel_for(all.size(), [&](std::size_t i) {
    std::vector<Walls> own = all[i];
    if (now) builder.cut_to(i, *now, own);
    for (const Walls& walls : own) of_paths[i].push_back(builder.surface(i, walls));
  });
  std::vector<CrackSurface> surfaces;
  for (std::vector<CrackSurface>& of_path : of_paths) std::ranges::move(of_path, std::back_inserter(surfaces));
  return surfaces;
}

}  // namespace

CrackSurfaces crack_surfaces(const Pane& pane, const CrackNetwork& network, std::uint64_t seed) {
  CrackSurfaces result;
  add_zones(pane, network, seed, result);
  result.surfaces = gaps_through(pane, sheet_of(pane, Ply::near), network, result, seed);
  if (pane.time_us) leave_out_later(network_at(pane, network, *pane.time_us).impacts.size(), result);
  return result;
}

std::vector<CrackSurface> far_surfaces(const Pane& pane, const CrackNetwork& near, const CrackNetwork& far,
                                       std::uint64_t seed) {
  if (far.cracks.empty()) return {};
  CrackSurfaces impacts;
  add_zones(pane, near, seed, impacts);
  return gaps_through(pane, sheet_of(pane, Ply::far), far, impacts, seed);
}

std::vector<std::size_t> closed_triangles(const CrackSurface& surface) {
  // About each column runs a ring of points: down the left wall, up the right one.
  const std::size_t rows = surface.rows;
  const std::size_t half = surface.left_mm.size();
  const auto ring = [&](std::size_t column, std::size_t k) {
    k %= 2 * rows;
    return k < rows ? column * rows + k : half + column * rows + (2 * rows - 1 - k);
  };
  // Rows that go down, from a face towards the viewer, turn the ring round.
  const bool down = surface.left_mm[0].z > surface.left_mm[1].z;
  std::vector<std::size_t> triangles;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.insert(triangles.end(), {a, down ? c : b, down ? b : c});
  };
  for (std::size_t c = 0; c + 1 < surface.columns(); ++c) {
    for (std::size_t k = 0; k < 2 * rows; ++k) {
      // One diagonal for both walls, so that they are alike and do not meet.
      const std::size_t a = ring(c, k);
      const std::size_t b = ring(c, k + 1);
      const std::size_t d = ring(c + 1, k);
      const std::size_t e = ring(c + 1, k + 1);
      if (k < rows) {
        add(a, b, e);
        add(a, e, d);
      } else {
        add(a, b, d);
        add(b, e, d);
      }
    }
  }
  for (std::size_t r = 0; r + 1 < rows; ++r) {
    const std::size_t last = surface.columns() - 1;
    add(ring(0, r), ring(0, 2 * rows - 1 - r), ring(0, r + 1));
    add(ring(0, r + 1), ring(0, 2 * rows - 1 - r), ring(0, 2 * rows - 2 - r));
    add(ring(last, r), ring(last, r + 1), ring(last, 2 * rows - 1 - r));
    add(ring(last, r + 1), ring(last, 2 * rows - 2 - r), ring(last, 2 * rows - 1 - r));
  }
  return triangles;
}

}  // namespace shatterpave::glass
