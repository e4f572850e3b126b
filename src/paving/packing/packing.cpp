// Particles start in rows along the field (rows.h), so that packing has little to mend: it evens out the distances, closes
// gaps and clears crowds. A random start freezes into many small patches of rows instead.
//
// The force of a square on its neighbour is a function of the neighbour's place in the frame between the two, in pitches. It
// is the sum of five, as in the square cell of Shimada and Itoh: of the centre, and of the four corners. Each follows their
// bubble-mesh law f(r) = 1.25 r³ − 2.375 r² + 1.125, which repels below r = 1 and attracts from there to r = 1.5. Of the
// corners r is the Euclidean distance over half a diagonal, so that a neighbour across a side rests between two corners:
// that lines up the columns. Of the centre r is the larger of the two components, whose iso-curves are squares (here they
// depart from a smooth near-square norm): then the plain lattice is exactly at rest, diagonal neighbours included, and
// straight rows are left as they are.
//
// Where sizes follow a field, a pitch is half of one neighbour's and half of the other's.
//
// Borders that run along or across the rows act as mirrors: a square rests half a pitch from its own image.
#include "paving/packing/packing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "geometry/lattice.h"
#include "paving/packing/near_index.h"
#include "paving/packing/rows.h"

namespace shatterpave::paving {

namespace {

// Beyond the border by pitches: a cell needs its neighbours and their neighbours to be whole.
constexpr double band_pitches = 2.6;

// The equation of motion m x″ + c x′ = f in units of the pitch, m = 1. The stiffness of the lattice is about 10 (from f′(1)
// = −1 of four sides and their corners), so that c = 4 is somewhat below critical, and steps of 0.25 are stable.
constexpr double damping = 4.0;
constexpr double time_step = 0.25;
// The start is so near to rest that more steps change nothing but the irregular spots, which they smear.
constexpr int steps_between_changes = 6;
constexpr int rounds = 3;

// A place where a neighbour is missing is a gap if nothing is nearer to it than this; of two particles nearer than that to
// one another one is too many. In pitches, by trial: with gaps from 0.6 the same place is filled and cleared in turn.
constexpr double gap = 0.72;
constexpr double crowd = 0.6;

// Neighbours within this distance, in pitches, are listed; forces end at 1.5, and particles move little between listings.
constexpr double listed = 1.7;
// A border mirrors particles within this distance of it, in pitches.
constexpr double mirrored = 0.8;

// The law of the bubble mesh; positive repels.
double law(double r) { return r >= 1.5 ? 0.0 : (1.25 * r - 2.375) * r * r + 1.125; }

// The force on a neighbour at q, in the frame between the two.
vec2 force_at(vec2 q) {
  vec2 force{0.0, 0.0};
  if (std::abs(q.x) >= std::abs(q.y)) {
    force.x = std::copysign(law(std::abs(q.x)), q.x);
  } else {
    force.y = std::copysign(law(std::abs(q.y)), q.y);
  }
  constexpr double half_diagonal = 0.70710678118654752;
  for (const vec2 corner : {vec2{0.5, 0.5}, vec2{-0.5, 0.5}, vec2{-0.5, -0.5}, vec2{0.5, -0.5}}) {
    const vec2 d = q - corner;
    const double distance = glm::length(d);
    if (distance > 0.0) force += law(distance / half_diagonal) / distance * d;
  }
  return force;
}

class Packing {
 public:
  Packing(std::vector<Particle> particles, vec2 pitch, const geometry::RegionIndex& area, const DirectionField& field,
          const SizeField& sizes)
      : particles_(std::move(particles)), pitch_(pitch), area_(area), field_(field), sizes_(sizes) {}

  void relax() {
    list_neighbours();
    list_walls();
    std::vector<vec2> velocity(particles_.size(), vec2{0.0, 0.0});
    std::vector<vec2> force(particles_.size());
    for (int step = 0; step < steps_between_changes; ++step) {
      parallel_for_chunks(particles_.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) force[i] = total_force(i);
      });
      // Implicit in the damping, so that any damping is stable. Velocities are in the frame of the particle.
      for (std::size_t i = 0; i < particles_.size(); ++i) {
        velocity[i] = (velocity[i] + time_step * force[i]) / (1.0 + time_step * damping);
        const double speed = largest(velocity[i]);
        constexpr double most = 0.2;  // pitches a step: no particle jumps over a neighbour
        const double scale = speed * time_step > most ? most / (speed * time_step) : 1.0;
        particles_[i].at += particles_[i].frame(pitch_).out_of(scale * time_step * velocity[i]);
      }
    }
    parallel_for_chunks(particles_.size(), 2048, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) particles_[i] = particle_at(particles_[i].at);
    });
  }

  // Removes one of each two that crowd, and fills gaps. Returns how many particles came and went.
  std::size_t change(double band_mm) {
    const std::size_t before = particles_.size();
    clear_crowds();
    const std::size_t cleared = before - particles_.size();
    return cleared + fill_gaps(band_mm);
  }

  std::vector<Particle> particles() && { return std::move(particles_); }

 private:
  struct Wall {
    vec2 point{0.0, 0.0};
    vec2 normal{0.0, 0.0};
    bool along = true;  // it runs along the rows, so it acts across them
  };

  Particle particle_at(vec2 at) const { return {at, field_.axis(at), sizes_.at(at)}; }

  Frame frame_of_both(std::size_t i, std::size_t j) const {
    return frame_between(particles_[i], particles_[j], field_.is_cross(), pitch_);
  }
  vec2 between(std::size_t i, std::size_t j) const { return frame_of_both(i, j).into(particles_[j].at - particles_[i].at); }

  double longer_mm() const { return std::max(pitch_.x, pitch_.y); }
  // How far neighbours may be that are listed, of one of this size.
  double reach_mm(double size) const {
    // A neighbour may be larger by so much. Where all are alike the squares of the index are as wide as this.
    const double larger = sizes_.is_even() ? 1.0 : 1.0 + most_growth;
    return listed * larger * size * longer_mm();
  }

  NearIndex index() const {
    NearIndex near(listed * sizes_.smallest() * longer_mm(), particles_.size());
    for (const Particle& p : particles_) near.add(p.at);
    return near;
  }

  void list_neighbours() {
    const NearIndex near = index();
    first_.assign(particles_.size() + 1, 0);
    listed_.clear();
    axes_.clear();
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      found.clear();
      near.for_each_near(particles_[i].at, reach_mm(particles_[i].size), [&](std::uint32_t j) {
        if (j != i && largest(between(i, j)) < listed) found.push_back(j);
      });
      std::ranges::sort(found);
      found.erase(std::unique(found.begin(), found.end()), found.end());
      listed_.insert(listed_.end(), found.begin(), found.end());
      for (const std::uint32_t j : found) axes_.push_back(frame_of_both(i, j).axis);
      first_[i + 1] = listed_.size();
    }
  }

  // For each particle the nearest border that runs along its row, and the nearest that runs across it.
  void list_walls() {
    walls_.assign(particles_.size(), {});
    const double reach = mirrored * longer_mm();
    parallel_for_chunks(particles_.size(), 2048, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> near;
      for (std::size_t i = begin; i < end; ++i) {
        near.clear();
        area_.near(particles_[i].at, particles_[i].size * reach, near);
        for (const bool along : {true, false}) add_wall(i, along, near);
      }
    });
  }

  void add_wall(std::size_t i, bool along, const std::vector<std::size_t>& near) {
    double best = 1e300;
    for (const std::size_t s : near) {
      const auto& segment = area_.segments()[s];
      const vec2 tangent = (segment.to - segment.from) / glm::length(segment.to - segment.from);
      const double sine = along ? cross(particles_[i].axis, tangent) : glm::dot(particles_[i].axis, tangent);
      const vec2 point = geometry::nearest_point(segment, particles_[i].at);
      const double distance = glm::length(point - particles_[i].at);
      if (std::abs(sine) >= along_sine || distance >= best) continue;
      best = distance;
      walls_[i][along ? 0 : 1] = {point, left_of(tangent), along};
    }
  }

  // In the particle's frame.
  vec2 total_force(std::size_t i) const {
    const Frame own = particles_[i].frame(pitch_);
    vec2 sum{0.0, 0.0};
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Frame frame{axes_[k], (0.5 * (particles_[i].size + particles_[listed_[k]].size)) * pitch_};
      sum += frame.out_of(force_at(frame.into(particles_[i].at - particles_[listed_[k]].at)));
    }
    for (const Wall& wall : walls_[i]) {
      if (wall.normal == vec2{0.0, 0.0}) continue;
      const double pitch = wall.along ? own.pitch.y : own.pitch.x;
      const double height = glm::dot(particles_[i].at - wall.point, wall.normal) / pitch;
      // The image is twice as far, and moves as the particle does; with its two corners it pushes three times.
      sum += std::copysign(3.0 * law(2.0 * std::abs(height)), height) * pitch * wall.normal;
    }
    return own.into(sum);
  }

  void clear_crowds() {
    list_neighbours();
    std::vector<bool> removed(particles_.size(), false);
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      for (std::size_t k = first_[i]; k < first_[i + 1] && !removed[i]; ++k) {
        const std::size_t j = listed_[k];
        if (!removed[j] && largest(between(i, j)) < crowd) removed[stress(i) > stress(j) ? i : j] = true;
      }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      if (!removed[i]) particles_[kept++] = particles_[i];
    }
    particles_.resize(kept);
  }

  // How much its neighbours press on a particle.
  double stress(std::size_t i) const {
    double sum = 0.0;
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) sum += std::max(0.0, law(largest(between(i, listed_[k]))));
    return sum;
  }

  std::size_t fill_gaps(double band_mm) {
    NearIndex near = index();
    const std::size_t before = particles_.size();
    for (std::size_t i = 0; i < before; ++i) {
      const Frame frame = particles_[i].frame(pitch_);
      for (const vec2 step : {vec2{1.0, 0.0}, vec2{0.0, 1.0}, vec2{-1.0, 0.0}, vec2{0.0, -1.0}}) {
        const vec2 at = particles_[i].at + frame.out_of(step);
        const Particle here{at, frame.axis, sizes_.at(at)};
        bool free = true;
        near.for_each_near(at, reach_mm(here.size), [&](std::uint32_t j) {
          free =
              free && largest(frame_between(here, particles_[j], field_.is_cross(), pitch_).into(particles_[j].at - at)) >= gap;
        });
        if (!free || !(area_.contains(at) || area_.border_within(at, band_mm))) continue;
        particles_.push_back(particle_at(at));
        near.add(at);
      }
    }
    return particles_.size() - before;
  }

  std::vector<Particle> particles_;
  vec2 pitch_;
  const geometry::RegionIndex& area_;
  const DirectionField& field_;
  const SizeField& sizes_;
  std::vector<std::size_t> first_;  // neighbours of particle i are listed_[first_[i] … first_[i + 1])
  std::vector<std::uint32_t> listed_;
  std::vector<vec2> axes_;  // of the frame between a particle and its neighbour, beside listed_
  std::vector<std::array<Wall, 2>> walls_;
};

}  // namespace

std::vector<Particle> packed_particles(const Pavement& pavement, const geometry::RegionIndex& area, const DirectionField& field,
                                       const SizeField& sizes, std::uint64_t seed) {
  const vec2 pitch = pitch_mm(pavement);
  const double band = band_pitches * sizes.largest_along(area) * std::max(pitch.x, pitch.y);
  if (std::holds_alternative<ConstantDirection>(pavement.direction) && sizes.is_even()) {
    return straight_rows(area, field.axis({0.0, 0.0}), pitch, band);
  }
  Packing packing(rows_along(field, sizes, area, pitch, band, seed), pitch, area, field, sizes);
  for (int round = 0; round < rounds; ++round) {
    packing.relax();
    if (round + 1 < rounds && packing.change(band) == 0) break;
  }
  auto particles = std::move(packing).particles();
  for (Particle& p : particles) p.at = geometry::on_lattice(p.at);
  return particles;
}

}  // namespace shatterpave::paving
