// Cracks that run side by side shield one another: the one with the narrower strips about it has the less stress to drive it,
// falls behind and is drawn into a neighbour. So deaths are drawn one after another, from the impact outwards, and each time
// the more shielded of two radials dies. It veers towards a neighbour that goes on far enough to be met.
#include "glass/growth/radial_course.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"

namespace shatterpave::glass {

namespace {

// By how much directions are off those of equal angles, at most, as a share of the angle between two. By eye: real ones look
// drawn, but two never start as one.
constexpr double direction_jitter = 0.42;

// Counts of radials at 1.2, 4 and 8 radii of the crushed zone, in photographs: 23, 16 to 17, 12 to 14.
constexpr double counted_from = 1.2;
constexpr double count_power = 0.3;

// A radial that the law of counts would let out of the pane dies within this part of the way to the edge. By eye.
constexpr double nearest_late_death = 0.6;
constexpr double farthest_late_death = 0.97;

// Of so many the most shielded dies, while more than that part of the radials are left, and after. By eye.
constexpr double crowded = 0.65;
constexpr std::uint32_t few_candidates = 2;
constexpr std::uint32_t many_candidates = 6;

// How far a radial veers where it gives up. By eye.
constexpr Angle least_veer = Angle::degrees(18.0);
constexpr Angle greatest_veer = Angle::degrees(42.0);

// Within the first ring most only arrest, as the needles about the impact of photographs do; farther out most meet a neighbour.
// By eye.
constexpr double needles = 0.9;
constexpr double late_arrests = 0.25;

// It meets the neighbour at this angle or more. By eye.
constexpr Angle least_approach = Angle::degrees(8.0);
constexpr Angle greatest_approach = Angle::degrees(20.0);

// Radials are deflected where pieces of rings meet them, and less where no piece does. By eye.
constexpr Angle least_kink = Angle::degrees(3.0);
constexpr Angle greatest_kink = Angle::degrees(11.0);

// "Now and then one sweeps through 40 to 60 degrees": one in so many, on its way to the edge.
constexpr double sweeping = 0.08;
constexpr Angle least_sweep = Angle::degrees(40.0);
constexpr Angle greatest_sweep = Angle::degrees(60.0);

// At about half of the radials, pieces of a ring end in two places.
constexpr double staggered = 0.46;

Angle between(Angle low, Angle high, double share) { return low + share * (high - low); }

double first_ring_mm(const Pane& pane) {
  return pane.rings.first_radius_mm.value_or(first_ring_share * std::sqrt(std::abs(geometry::area(pane.outline_mm))));
}

class Courses {
 public:
  Courses(const Pane& pane, const ImpactCounts& counts, std::uint64_t seed, Id impact)
      : pane_(pane),
        seed_(seed),
        impact_(impact),
        count_(counts.radial_count),
        large_(counts.large_count),
        first_ring_mm_(first_ring_mm(pane)) {}

  std::vector<RadialCourse> drawn(double crushed_mm, double first_mm, double room_mm, double farthest_mm) {
    courses_.resize(static_cast<std::size_t>(count_));
    const Id radials = impact_.child("radial");
    const double first = uniform(seed_, {Stream::first_direction, radials});
    for (int i = 0; i < count_; ++i) {
      const double off = direction_jitter * (2.0 * draw(i, 0) - 1.0);
      course(i).direction = Angle::radians(2.0 * pi * (first + i + off) / count_);
      alive_.push_back(i);
    }
    for (int left = count_; left > large_; --left) {
      die(next_to_die(left), meeting_of(left, counted_from * crushed_mm, room_mm), first_mm);
    }
    for (const int i : alive_) course(i).large = true;
    for (int i = 0; i < count_; ++i) {
      RadialCourse& one = course(i);
      if (one.large && draw(i, 6) < sweeping) {
        const Angle sweep = between(least_sweep, greatest_sweep, draw(i, 7));
        one.sweep_per_mm = (draw(i, 8) < 0.5 ? 1.0 : -1.0) * sweep.radians() / farthest_mm;
      }
    }
    kink(farthest_mm);
    return std::move(courses_);
  }

 private:
  RadialCourse& course(int i) { return courses_[static_cast<std::size_t>(i)]; }
  double draw(int radial, std::uint32_t number) const {
    return uniform(seed_, {Stream::radial_course, impact_.child("radial").child(static_cast<std::uint64_t>(radial)), number});
  }

  // Where the one of `left` radials meets a neighbour that leaves one fewer.
  double meeting_of(int left, double from_mm, double room_mm) const {
    const double share =
        (left - 1 + uniform(seed_, {Stream::radial_course, impact_.child("death"), static_cast<std::uint32_t>(left)})) / count_;
    const double by_law = from_mm * power(std::max(share, 1e-6), -1.0 / count_power);
    const double late = nearest_late_death + (farthest_late_death - nearest_late_death) *
                                                 uniform(seed_, {Stream::radial_course, impact_.child("late death"),
                                                                 static_cast<std::uint32_t>(left)});
    return std::min(by_law, std::max(late * room_mm, from_mm));
  }

  double gap(int from, int to) {
    const double width = (course(to).direction - course(from).direction).radians();
    return width > 0.0 ? width : width + 2.0 * pi;
  }
  // The narrower of the strips beside the `at`-th that is alive.
  double room_about(std::size_t at) {
    const std::size_t n = alive_.size();
    return std::min(gap(alive_[at], alive_[(at + 1) % n]), gap(alive_[(at + n - 1) % n], alive_[at]));
  }

  // The most shielded of some. Near the impact there are many, and chance has its say; farther out the few left are far apart,
  // and who is near another one dies.
  std::size_t next_to_die(int left) {
    const std::uint32_t candidates = left > crowded * count_ ? few_candidates : many_candidates;
    std::size_t chosen = 0;
    for (std::uint32_t k = 0; k < candidates; ++k) {
      const Address address{Stream::radial_course, impact_.child("candidate"),
                            many_candidates * static_cast<std::uint32_t>(left) + k};
      const std::size_t at =
          std::min(static_cast<std::size_t>(uniform(seed_, address) * static_cast<double>(alive_.size())), alive_.size() - 1);
      if (k == 0 || room_about(at) < room_about(chosen)) chosen = at;
    }
    return chosen;
  }

  // The nearer neighbour is the likelier to be met; which are left when this one dies go on farther than it does.
  void die(std::size_t at, double meeting_mm, double first_mm) {
    const int radial = alive_[at];
    const std::size_t n = alive_.size();
    RadialCourse& one = course(radial);
    const double right = gap(alive_[(at + n - 1) % n], radial);
    const double left = gap(radial, alive_[(at + 1) % n]);
    const double side = draw(radial, 1) * (left + right) < right ? 1.0 : -1.0;
    const double gap_width = side > 0.0 ? left : right;
    // Whoever veers by more than the angle between the two meets the neighbour, at reach × sin(veer) / sin(veer − angle).
    alive_.erase(alive_.begin() + static_cast<std::ptrdiff_t>(at));
    const double veer = std::min(std::max(between(least_veer, greatest_veer, draw(radial, 2)).radians(),
                                          gap_width + between(least_approach, greatest_approach, draw(radial, 3)).radians()),
                                 0.5 * pi);
    one.veer = Angle::radians(side * veer);
    if (draw(radial, 4) < (meeting_mm < first_ring_mm_ ? needles : late_arrests)) {
      one.arrests = true;
      one.reach_mm = meeting_mm;
      return;
    }
    one.reach_mm = std::max(first_mm, meeting_mm * sine(std::max(veer - gap_width, 0.0)) / sine(veer));
  }

  // Where pieces of a ring will meet the radials that come so far.
  void kink(double farthest_mm) {
    const std::vector<double> rings = ring_radii(pane_, farthest_mm);
    for (std::size_t k = 0; k < rings.size(); ++k) {
      std::vector<int> crossing;
      for (int i = 0; i < count_; ++i) {
        if (course(i).reach_mm > rings[k]) crossing.push_back(i);
      }
      for (std::size_t j = 0; j < crossing.size(); ++j) {
        const int radial = crossing[j];
        const int before = crossing[(j + crossing.size() - 1) % crossing.size()];
        const int ring = static_cast<int>(k);
        const double off = is_staggered(seed_, impact_, ring, radial)
                               ? piece_offset(pane_.rings, seed_, impact_, ring, radial)
                               : joint_offset(pane_.rings, seed_, impact_, ring, radial, before);
        const auto draws = static_cast<std::uint32_t>(16 + 2 * k);
        const Angle turn = between(least_kink, greatest_kink, draw(radial, draws));
        const double side = draw(radial, draws + 1) < 0.5 ? 1.0 : -1.0;
        course(radial).kinks.push_back({rings[k] * (1.0 + off), side * turn});
      }
    }
    for (RadialCourse& one : courses_) std::ranges::sort(one.kinks, {}, &Kink::radius_mm);
  }

  const Pane& pane_;
  std::uint64_t seed_;
  Id impact_;
  int count_;
  int large_;
  double first_ring_mm_;
  std::vector<RadialCourse> courses_;
  std::vector<int> alive_;  // by direction
};

Id piece_id(Id impact, int ring, int radial) {
  return impact.child("ring piece").child(static_cast<std::uint64_t>(ring)).child(static_cast<std::uint64_t>(radial));
}

}  // namespace

std::vector<double> ring_radii(const Pane& pane, double farthest_mm) {
  const Rings& rings = pane.rings;
  std::vector<double> radii;
  double radius = first_ring_mm(pane);
  for (int k = 0; k < rings.count && radius < farthest_mm; ++k, radius *= rings.ratio) radii.push_back(radius);
  return radii;
}

double piece_offset(const Rings& rings, std::uint64_t seed, Id impact, int ring, int radial) {
  const double off = 2.0 * uniform(seed, {Stream::ring_piece, piece_id(impact, ring, radial), 2}) - 1.0;
  return rings.spread * (rings.ratio - 1.0) * off;
}

bool is_staggered(std::uint64_t seed, Id impact, int ring, int radial) {
  return uniform(seed, {Stream::ring_piece, piece_id(impact, ring, radial), 3}) < staggered;
}

double joint_offset(const Rings& rings, std::uint64_t seed, Id impact, int ring, int radial, int radial_before) {
  return 0.5 * (piece_offset(rings, seed, impact, ring, radial) + piece_offset(rings, seed, impact, ring, radial_before));
}

std::vector<RadialCourse> radial_courses(const Pane& pane, const ImpactCounts& counts, std::uint64_t seed, Id impact,
                                         double crushed_mm, double first_mm, double room_mm, double farthest_mm) {
  return Courses(pane, counts, seed, impact).drawn(crushed_mm, first_mm, room_mm, farthest_mm);
}

}  // namespace shatterpave::glass
