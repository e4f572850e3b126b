// Packing works on centres; what is seen are the sides. For each side the wish is a vector: its direction the field's, its
// length the pitch. The corners take the places that fulfil all wishes best, in the sense of least squares, a misdirected side
// counted more than one of another length: a row that bends is seen before a stone 2% wider. One more wish is of each stone as
// a whole, to be as large as the others, which evens out the lengths along a row of which each ends where it may; the area is
// linear in the place of one corner, so it is one more square in the sum. Each corner in turn takes the best place for where
// its neighbours are (Gauss and Seidel); a few sweeps suffice, since packing leaves nothing to do over long distances.
//
// At a T three cells meet. Which of them has its straight side there is told by the particles: the two that lie one after the
// other along a row (or both along a column) have the joint that ends, the third has the side. Where two rows lie shifted,
// Ts follow one another, up and down by turns; on a bend no line is straight for both rows, but each side need depart from
// the line of all Ts by no more than its own sagitta, pitch² / (8 radius).
#include "paving/packing/settling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "paving/packing/particle_cells.h"
#include "paving/packing/rows.h"

namespace shatterpave::paving {

namespace {

// By trial on all plans of benchmarks/packing_quality: 20 change nothing that can be seen.
constexpr int corner_sweeps = 10;
// How much more a misdirected side counts than one too long or too short, and a stone too large or too small. By trial on all
// plans of benchmarks/packing_quality: with areas unheeded they spread half as much again; with more for them, or for
// directions, runs of Ts are drawn off their lines, so that more stones have five corners.
constexpr double direction_weight = 4.0;
constexpr double area_weight = 0.7;
// How much a corner heeds the place where packing put it; by trial: with less, faults of the rim creep in, with 1 all stay.
constexpr double hold_weight = 0.5;
constexpr double border_weight = 50.0;
// Corners nearer to a border than this, in pitches, are taken to it.
constexpr double border_reach = 0.25;
// The corners of a cell that looks like a stone lie within this of its middle, in pitches; half is the plain case.
constexpr double regular_reach = 1.0;
// Shorter ones, in pitches, are no sides.
constexpr double least_side = 0.5;
// To move one T bends another's line. By trial: with 10, 3% of oblong stones at a hole keep a fifth corner, with 40 under 1%.
constexpr int straightenings = 40;

// A corner this near to a line lies on it but for rounding to the lattice.
constexpr double rounding_mm = 0.002;

constexpr std::uint32_t nothing = UINT32_MAX;

// What a corner wishes for: a neighbour corner at `offset`, where `length_weight` may be 0.
struct Wish {
  std::uint32_t neighbour = 0;
  vec2 direction{1.0, 0.0};  // unit
  double length_mm = 0.0;
  double length_weight = 1.0;
};

// A corner of a regular cell, and those before and after it there.
struct Vertex {
  std::uint32_t cell = 0;
  std::uint32_t before = 0;
  std::uint32_t after = 0;
};

struct CornerWall {
  std::uint32_t corner = 0;
  vec2 point{0.0, 0.0};
  vec2 normal{0.0, 0.0};
};

// A corner at which a joint ends on the straight side of `cell`.
struct Tee {
  std::uint32_t corner = nothing;
  std::uint32_t cell = nothing;
  std::uint32_t last = nothing;  // the corners of the cell next to it
  std::uint32_t next = nothing;
  std::uint32_t before = nothing;  // the ends of the side: the nearest corners that are no Ts on it
  std::uint32_t after = nothing;
};

class Settling {
 public:
  Settling(Cells& cells, std::span<const Particle> particles, const Pavement& pavement, const geometry::RegionIndex& area)
      : cells_(cells),
        particles_(particles),
        pitch_(pitch_mm(pavement)),
        bulge_mm_(std::max(rounding_mm, largest_bulge * pavement.joint_mm)),
        area_(area) {}

  void settle() {
    find_regular();
    find_tees();
    collect_wishes();
    find_sizes();
    find_walls();
    original_ = cells_.corners;
    collect_vertices();
    for (int sweep = 0; sweep < corner_sweeps; ++sweep) move_corners(sweep % 2 == 1);
    for (int pass = 0; pass < straightenings; ++pass) {
      for (const Tee& tee : tees_) straighten(tee);
    }
    snap_to_walls();
    for (vec2& corner : cells_.corners) corner = geometry::on_lattice(corner);
    keep_valid();
    leave_out_tees();
  }

 private:
  std::uint32_t side_after(std::uint32_t cell, std::size_t side) const {
    return cells_.corner[side + 1 < cells_.first[cell + 1] ? side + 1 : cells_.first[cell]];
  }
  std::uint32_t side_before(std::uint32_t cell, std::size_t side) const {
    return cells_.corner[side > cells_.first[cell] ? side - 1 : cells_.first[cell + 1] - 1];
  }

  template <typename Visit>
  void for_each_side(Visit visit) const {
    for (std::uint32_t cell = 0; cell < cells_.count(); ++cell) {
      for (std::size_t side = cells_.first[cell]; side < cells_.first[cell + 1]; ++side) visit(cell, side);
    }
  }

  // Cells that look like stones. At the rim of the packing cells are long and odd, and say nothing about their corners.
  void find_regular() {
    regular_.assign(cells_.count(), 0);
    for (std::uint32_t cell = 0; cell < cells_.count(); ++cell) {
      regular_[cell] = cells_.first[cell] < cells_.first[cell + 1] ? 1 : 0;
      const Frame frame = particles_[cell].frame(pitch_);
      for (std::size_t side = cells_.first[cell]; side < cells_.first[cell + 1]; ++side) {
        const vec2 q = frame.into(cells_.corners[cells_.corner[side]] - particles_[cell].at);
        if (std::max(std::abs(q.x), std::abs(q.y)) > regular_reach) regular_[cell] = 0;
      }
    }
  }

  // Whether two cells lie one after the other along a row.
  bool is_along(std::uint32_t a, std::uint32_t b) const {
    const vec2 q = frame_of_both(a, b).into(particles_[b].at - particles_[a].at);
    return std::abs(q.x) >= std::abs(q.y);
  }

  Frame frame_of_both(std::uint32_t a, std::uint32_t b) const {
    return frame_between(particles_[a], particles_[b], pitch_.x == pitch_.y, pitch_);
  }

  // Whether the cell has its straight side where it begins `side`, a corner of three cells.
  bool is_straight_at(std::uint32_t cell, std::size_t side) const {
    const std::uint32_t last = cells_.neighbour[side > cells_.first[cell] ? side - 1 : cells_.first[cell + 1] - 1];
    const std::uint32_t next = cells_.neighbour[side];
    const bool along = is_along(cell, next);
    return along == is_along(cell, last) && along != is_along(last, next);
  }

  // Cosine of the cell's angle at the corner where it begins `side`.
  double cosine_at(std::uint32_t cell, std::size_t side) const {
    const vec2 corner = cells_.corners[cells_.corner[side]];
    const vec2 a = cells_.corners[side_before(cell, side)] - corner;
    const vec2 b = cells_.corners[side_after(cell, side)] - corner;
    return glm::dot(a, b) / (glm::length(a) * glm::length(b));
  }

  // The Ts, the flattest first; each cell keeps four corners.
  void find_tees() {
    std::vector<std::uint8_t> degree(cells_.corners.size(), 0);
    for_each_side([&](std::uint32_t, std::size_t side) { ++degree[cells_.corner[side]]; });
    std::vector<std::pair<double, Tee>> found;
    for_each_side([&](std::uint32_t cell, std::size_t side) {
      const std::uint32_t corner = cells_.corner[side];
      if (degree[corner] != 3 || corners_of(cell) < 5 || !is_straight_at(cell, side)) return;
      const std::uint32_t before = side_before(cell, side);
      const std::uint32_t after = side_after(cell, side);
      found.push_back({cosine_at(cell, side), {corner, cell, before, after, before, after}});
    });
    std::ranges::stable_sort(found, {}, &std::pair<double, Tee>::first);
    tee_at_.assign(cells_.corners.size(), nothing);
    std::vector<std::uint32_t> tees_of(cells_.count(), 0);
    for (const auto& [cosine, tee] : found) {
      if (tee_at_[tee.corner] != nothing || corners_of(tee.cell) - tees_of[tee.cell] < 5) continue;
      ++tees_of[tee.cell];
      tee_at_[tee.corner] = static_cast<std::uint32_t>(tees_.size());
      tees_.push_back(tee);
    }
    for (Tee& tee : tees_) {
      while (is_tee_of(tee.cell, tee.before)) tee.before = tees_[tee_at_[tee.before]].last;
      while (is_tee_of(tee.cell, tee.after)) tee.after = tees_[tee_at_[tee.after]].next;
    }
  }

  bool is_tee_of(std::uint32_t cell, std::uint32_t corner) const {
    return tee_at_[corner] != nothing && tees_[tee_at_[corner]].cell == cell;
  }

  std::size_t corners_of(std::uint32_t cell) const { return cells_.first[cell + 1] - cells_.first[cell]; }

  // The wish for the way from one corner to another, along the rows or across them, whichever is nearer.
  Wish wish(std::uint32_t from, std::uint32_t to, const Frame& frame) const {
    const vec2 d = cells_.corners[to] - cells_.corners[from];
    const vec2 axis = frame.axis;
    const vec2 q = frame.into(d);
    if (std::abs(q.x) >= std::abs(q.y)) return {to, q.x < 0.0 ? -axis : axis, frame.pitch.x, 1.0};
    return {to, q.y < 0.0 ? -left_of(axis) : left_of(axis), frame.pitch.y, 1.0};
  }

  // The T on whose side these two corners follow one another, if any; only the whole of that side has a length to be.
  const Tee* tee_between(std::uint32_t from, std::uint32_t to) const {
    const auto follow = [this](std::uint32_t end, std::uint32_t other) {
      return tee_at_[end] != nothing && (other == tees_[tee_at_[end]].last || other == tees_[tee_at_[end]].next);
    };
    if (follow(from, to)) return &tees_[tee_at_[from]];
    return follow(to, from) ? &tees_[tee_at_[to]] : nullptr;
  }

  // The wish for a part of a straight side: its direction only.
  Wish wish_for_part(const Tee& tee, std::uint32_t from, std::uint32_t to, const Frame& frame) const {
    const bool forward = to == tee.corner ? from == tee.last : to == tee.next;
    Wish w = forward ? wish(tee.before, tee.after, frame) : wish(tee.after, tee.before, frame);
    w.neighbour = to;
    w.length_weight = 0.0;
    return w;
  }

  void collect_wishes() {
    std::vector<std::pair<std::uint32_t, Wish>> all;
    all.reserve(cells_.corner.size() + 2 * tees_.size());
    for_each_side([&](std::uint32_t cell, std::size_t side) {
      if (!regular_[cell]) return;
      const std::uint32_t from = cells_.corner[side];
      const std::uint32_t to = side_after(cell, side);
      // The side turns as both cells do; each wishes it to be as long as its own stone.
      const Frame frame{frame_of_both(cell, cells_.neighbour[side]).axis, particles_[cell].size * pitch_};
      const Tee* tee = tee_between(from, to);
      // The short side between two cells that meet corner to corner is no side of a stone.
      const vec2 q = frame.into(cells_.corners[to] - cells_.corners[from]);
      if (tee == nullptr && std::max(std::abs(q.x), std::abs(q.y)) < least_side) return;
      Wish w = tee == nullptr ? wish(from, to, frame) : wish_for_part(*tee, from, to, frame);
      all.emplace_back(from, w);
      // At the rim no cell beyond the side says where its other end should be.
      const std::uint32_t beyond = cells_.neighbour[side];
      if (!regular_[beyond]) {
        w.neighbour = from;
        w.direction = -w.direction;
        all.emplace_back(to, w);
      }
    });
    for (const Tee& tee : tees_) {
      const Frame frame = particles_[tee.cell].frame(pitch_);
      all.emplace_back(tee.before, wish(tee.before, tee.after, frame));
      all.emplace_back(tee.after, wish(tee.after, tee.before, frame));
    }
    std::tie(first_, wishes_) = by_corner(all);
  }

  // Of each corner the size of the smallest stone there.
  void find_sizes() {
    constexpr double none_there = 1e300;
    sizes_at_.assign(cells_.corners.size(), none_there);
    for_each_side([&](std::uint32_t cell, std::size_t side) {
      double& size = sizes_at_[cells_.corner[side]];
      size = std::min(size, particles_[cell].size);
    });
  }

  // The vertices of regular cells, by corner, and their areas.
  void collect_vertices() {
    std::vector<std::pair<std::uint32_t, Vertex>> all;
    all.reserve(cells_.corner.size());
    area_mm2_.assign(cells_.count(), 0.0);
    for_each_side([&](std::uint32_t cell, std::size_t side) {
      if (!regular_[cell]) return;
      const std::uint32_t corner = cells_.corner[side];
      all.push_back({corner, {cell, side_before(cell, side), side_after(cell, side)}});
      area_mm2_[cell] += 0.5 * cross(cells_.corners[corner], cells_.corners[side_after(cell, side)]);
    });
    std::tie(first_vertex_, vertices_) = by_corner(all);
  }

  // What belongs to each corner together, in the order given: of corner c [first[c], first[c + 1]).
  template <typename Item>
  std::pair<std::vector<std::size_t>, std::vector<Item>> by_corner(
      const std::vector<std::pair<std::uint32_t, Item>>& all) const {
    std::vector<std::size_t> first(cells_.corners.size() + 1, 0);
    for (const auto& one : all) ++first[one.first + 1];
    for (std::size_t c = 0; c < cells_.corners.size(); ++c) first[c + 1] += first[c];
    std::vector<Item> items(all.size());
    std::vector<std::size_t> at(first.begin(), first.end() - 1);
    for (const auto& one : all) items[at[one.first]++] = one.second;
    return {std::move(first), std::move(items)};
  }

  // For each corner near the border the nearest border along its row, and the nearest across it.
  void find_walls() {
    std::vector<std::size_t> near;
    for (std::uint32_t corner = 0; corner < cells_.corners.size(); ++corner) {
      if (first_[corner] == first_[corner + 1]) continue;
      near.clear();
      const double reach = border_reach * sizes_at_[corner] * std::min(pitch_.x, pitch_.y);
      area_.near(cells_.corners[corner], reach, near);
      if (near.empty()) continue;
      const vec2 axis = wishes_[first_[corner]].direction;
      for (const bool along : {true, false}) add_wall(corner, along ? axis : left_of(axis), near);
    }
  }

  void add_wall(std::uint32_t corner, vec2 axis, const std::vector<std::size_t>& near) {
    double best = 1e300;
    CornerWall wall;
    for (const std::size_t s : near) {
      const auto& segment = area_.segments()[s];
      const vec2 tangent = (segment.to - segment.from) / glm::length(segment.to - segment.from);
      const vec2 point = geometry::nearest_point(segment, cells_.corners[corner]);
      const double distance = glm::length(point - cells_.corners[corner]);
      if (std::abs(cross(axis, tangent)) >= along_sine || distance >= best) continue;
      best = distance;
      wall = {corner, point, left_of(tangent)};
    }
    if (best < 1e300) walls_.push_back(wall);
  }

  void move_corners(bool backwards) {
    const std::size_t count = cells_.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t corner = backwards ? count - 1 - k : k;
      if (first_[corner + 1] - first_[corner] >= 3) move(corner, best_place(static_cast<std::uint32_t>(corner)));
    }
  }

  void move(std::size_t corner, vec2 place) {
    const vec2 by = place - cells_.corners[corner];
    for (std::size_t v = first_vertex_[corner]; v < first_vertex_[corner + 1]; ++v) {
      area_mm2_[vertices_[v].cell] += glm::dot(by, growth_of(vertices_[v]));
    }
    cells_.corners[corner] = place;
  }

  // How the area of the cell grows with the place of its corner, mm² a mm.
  vec2 growth_of(const Vertex& v) const { return -0.5 * left_of(cells_.corners[v.after] - cells_.corners[v.before]); }

  double area_asked_mm2(std::uint32_t cell) const {
    const double size = particles_[cell].size;
    return size * size * (pitch_.x * pitch_.y);
  }

  // Where the wishes of the corner are fulfilled best: a symmetric system of two equations.
  vec2 best_place(std::uint32_t corner) const {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    vec2 right{0.0, 0.0};
    const auto demand = [&](vec2 n, double value, double weight) {
      xx += weight * n.x * n.x;
      xy += weight * n.x * n.y;
      yy += weight * n.y * n.y;
      right += weight * value * n;
    };
    const vec2 origin = cells_.corners[corner];
    for (std::size_t w = first_[corner]; w < first_[corner + 1]; ++w) {
      const Wish& wish = wishes_[w];
      const vec2 d = cells_.corners[wish.neighbour] - origin;
      const vec2 normal = left_of(wish.direction);
      demand(normal, glm::dot(normal, d), direction_weight);
      if (wish.length_weight > 0.0) demand(wish.direction, glm::dot(wish.direction, d) - wish.length_mm, wish.length_weight);
    }
    for (std::size_t v = first_vertex_[corner]; v < first_vertex_[corner + 1]; ++v) {
      const vec2 growth = growth_of(vertices_[v]);
      const double rate = glm::length(growth);
      if (rate < 1e-3) continue;
      demand(growth / rate, (area_asked_mm2(vertices_[v].cell) - area_mm2_[vertices_[v].cell]) / rate, area_weight);
    }
    const auto wall = std::ranges::lower_bound(walls_, corner, {}, &CornerWall::corner);
    for (auto w = wall; w != walls_.end() && w->corner == corner; ++w) {
      demand(w->normal, glm::dot(w->normal, w->point - origin), border_weight);
    }
    // A light hold on where packing put the corner: what is wrong at the rim of the packing stays there.
    demand({1.0, 0.0}, original_[corner].x - origin.x, hold_weight);
    demand({0.0, 1.0}, original_[corner].y - origin.y, hold_weight);
    const double determinant = xx * yy - xy * xy;
    if (determinant < 1e-6) return origin;
    return origin + vec2{(yy * right.x - xy * right.y) / determinant, (xx * right.y - xy * right.x) / determinant};
  }

  // How far the corner of a T lies out of its cell from the straight side, mm.
  double bulge_mm(const Tee& tee) const {
    const vec2 a = cells_.corners[tee.before];
    const vec2 d = cells_.corners[tee.after] - a;
    return -cross(d, cells_.corners[tee.corner] - a) / glm::length(d);
  }

  // Whether the corner of a T is beside the straight side, not beyond its ends.
  bool is_beside(const Tee& tee) const {
    const vec2 a = cells_.corners[tee.before];
    const vec2 d = cells_.corners[tee.after] - a;
    const double along = glm::dot(cells_.corners[tee.corner] - a, d);
    return along > 0.0 && along < glm::dot(d, d);
  }

  // Takes the corner of a T to the straight side, or, where that ends in Ts itself, as near to it as it must be.
  void straighten(const Tee& tee) {
    if (!is_beside(tee)) return;
    const vec2 d = cells_.corners[tee.after] - cells_.corners[tee.before];
    const bool alone = tee_at_[tee.before] == nothing && tee_at_[tee.after] == nothing;
    const double most = alone ? 0.0 : bulge_mm_ - rounding_mm;
    const double bulge = bulge_mm(tee);
    cells_.corners[tee.corner] += (bulge - std::clamp(bulge, -most, most)) / glm::length(d) * left_of(d);
  }

  void snap_to_walls() {
    // Twice, so that a corner between two borders that are not quite at right angles reaches both.
    for (int pass = 0; pass < 2; ++pass) {
      for (const CornerWall& wall : walls_) {
        vec2& corner = cells_.corners[wall.corner];
        corner -= glm::dot(corner - wall.point, wall.normal) * wall.normal;
      }
    }
  }

  bool is_valid(std::uint32_t cell) const {
    const geometry::Polygon outline = geometry::cleaned(cells_.outline(cell));
    return geometry::area(outline) > 0.0 && geometry::is_simple(outline);
  }

  // Takes the corners of cells that have become invalid back to where they were, and those of their neighbours while that
  // makes others invalid.
  void keep_valid() {
    std::vector<std::uint8_t> bad(cells_.count(), 0);
    for (bool changed = true; changed;) {
      parallel_for_chunks(cells_.count(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
          const bool is_cell = cells_.first[c] < cells_.first[c + 1];
          bad[c] = is_cell && !is_valid(static_cast<std::uint32_t>(c)) ? 1 : 0;
        }
      });
      changed = false;
      for_each_side([&](std::uint32_t cell, std::size_t side) {
        vec2& corner = cells_.corners[cells_.corner[side]];
        if (bad[cell] == 0 || corner == original_[cells_.corner[side]]) return;
        corner = original_[cells_.corner[side]];
        changed = true;
      });
    }
  }

  // Whether all Ts on the side of this one are near to the line between its ends, and in their order.
  bool is_straight_side(const Tee& one) const {
    const vec2 a = cells_.corners[one.before];
    const vec2 d = cells_.corners[one.after] - a;
    double along = 0.0;
    std::uint32_t corner = one.corner;
    while (is_tee_of(one.cell, tees_[tee_at_[corner]].last)) corner = tees_[tee_at_[corner]].last;
    for (; is_tee_of(one.cell, corner); corner = tees_[tee_at_[corner]].next) {
      const double here = glm::dot(cells_.corners[corner] - a, d);
      if (std::abs(bulge_mm(tees_[tee_at_[corner]])) > bulge_mm_ || here <= along) return false;
      along = here;
    }
    return along < glm::dot(d, d);
  }

  // A T that lies on the side it meets is no corner of that cell, and one that lies near to it none of its stone.
  void leave_out_tees() {
    cells_.left_out.assign(cells_.corner.size(), false);
    cells_.bulging.assign(cells_.corner.size(), false);
    for (const Tee& tee : tees_) {
      if (!is_straight_side(tee)) continue;
      const double bulge = std::abs(bulge_mm(tee));
      for (std::size_t side = cells_.first[tee.cell]; side < cells_.first[tee.cell + 1]; ++side) {
        if (cells_.corner[side] == tee.corner) (bulge <= rounding_mm ? cells_.left_out : cells_.bulging)[side] = true;
      }
    }
  }

  Cells& cells_;
  std::span<const Particle> particles_;
  vec2 pitch_;
  double bulge_mm_;
  const geometry::RegionIndex& area_;
  std::vector<std::uint8_t> regular_;  // of a cell
  std::vector<Tee> tees_;
  std::vector<std::uint32_t> tee_at_;  // of a corner
  std::vector<std::size_t> first_;     // wishes of corner c are wishes_[first_[c] … first_[c + 1])
  std::vector<Wish> wishes_;
  std::vector<double> sizes_at_;           // of a corner
  std::vector<std::size_t> first_vertex_;  // the same of vertices
  std::vector<Vertex> vertices_;
  std::vector<double> area_mm2_;   // of a regular cell
  std::vector<vec2> original_;     // corners as packing left them
  std::vector<CornerWall> walls_;  // by corner, ascending
};

}  // namespace

Cells settled_cells(Cells cells, std::span<const Particle> particles, const Pavement& pavement,
                    const geometry::RegionIndex& area) {
  Settling(cells, particles, pavement, area).settle();
  return cells;
}

}  // namespace shatterpave::paving
