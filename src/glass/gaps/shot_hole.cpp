#include "glass/gaps/shot_hole.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "geometry/lattice.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

namespace {

constexpr std::size_t ring_count = 17;
constexpr std::size_t point_count = 160;
// Over this share of the thickness the hole is straight, then the cone opens, steeper at first. By eye, from photographs.
constexpr double straight = 0.12;
constexpr double opening_power = 1.25;
// Flakes: how many, and by which share of the cone's width they reach beyond it.
constexpr int flakes = 13;
constexpr double flake_reach = 0.33;
// Ripples of the conchoidal wall, as a share of the cone's width.
constexpr double ripple = 0.012;
constexpr double rim_roughness = 0.06;

double cone_share(double t) { return t <= straight ? 0.0 : power((t - straight) / (1.0 - straight), opening_power); }

double depth_of(const ShotHoleShape& shape, double z) {
  const double half = 0.5 * shape.thickness_mm - crack_skin_mm;
  return std::clamp(0.5 - 0.5 * z / half, 0.0, 1.0);
}

struct Flake {
  double angle = 0.0;
  double half_width = 0.0;
  double reach = 0.0;  // 0 … 1
  double from = 0.0;   // share of the thickness from which on it has broken off
};

std::vector<Flake> flakes_of(std::uint64_t seed, const Id& element) {
  std::vector<Flake> result;
  for (int k = 0; k < flakes; ++k) {
    const auto draw = [&](std::uint32_t n) {
      return uniform(seed, {Stream::shot_hole, element, static_cast<std::uint32_t>(8 * k) + n});
    };
    result.push_back(
        {2.0 * pi * (k + 0.8 * draw(0)) / flakes, 0.16 + 0.34 * draw(1), 0.25 + 0.75 * draw(2), 0.1 + 0.6 * draw(3)});
  }
  return result;
}

// How far flakes reach at an angle: scallops that meet in cusps, 0 … 1.
double flaked(const std::vector<Flake>& all, double angle, double t) {
  double reach = 0.0;
  for (const Flake& flake : all) {
    double aside = std::abs(angle - flake.angle);
    aside = std::min(aside, std::abs(2.0 * pi - aside)) / flake.half_width;
    const double grown = std::clamp((t - flake.from) / (1.0 - flake.from), 0.0, 1.0);
    reach = std::max(reach, flake.reach * grown * (1.0 - aside * aside));
  }
  return reach;
}

}  // namespace

double widest_mm(const ShotHoleShape& shape, double z_mm) {
  const double cone = (shape.spall_radius_mm - shape.hole_radius_mm) * cone_share(depth_of(shape, z_mm));
  return shape.hole_radius_mm * (1.0 + rim_roughness) + cone * (1.0 + flake_reach + ripple);
}

ShotHole shot_hole(const ShotHoleShape& shape, std::uint64_t seed, const Id& element) {
  ShotHole result{shape, ring_count, point_count, {}, {}};
  const double half = 0.5 * shape.thickness_mm - crack_skin_mm;
  const std::vector<Flake> all = flakes_of(seed, element);
  for (std::size_t i = 0; i < ring_count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(ring_count - 1);
    for (std::size_t k = 0; k < point_count; ++k) {
      const double angle = 2.0 * pi * static_cast<double>(k) / static_cast<double>(point_count);
      const double cone = (shape.spall_radius_mm - shape.hole_radius_mm) * cone_share(t);
      const double waves = ripple * sine(22.0 * t + 3.0 * sine(2.0 * angle) + 2.0 * sine(5.0 * angle));
      const double chips = uniform(seed, {Stream::shot_hole, element.child("rim"), static_cast<std::uint32_t>(k / 3)});
      const double radius = shape.hole_radius_mm * (1.0 + rim_roughness * (2.0 * chips - 1.0)) +
                            cone * (1.0 + flake_reach * flaked(all, angle, t) + waves);
      const SineAndCosine turn = sine_and_cosine(angle);
      const vec2 plan = geometry::on_lattice(shape.centre_mm + radius * vec2{turn.cosine, turn.sine});
      const double z = half * (1.0 - 2.0 * t);
      result.wall_mm.push_back({plan, geometry::to_mm(std::llround(z * geometry::lattice_per_mm))});
    }
  }
  for (std::size_t i = 0; i < ring_count; ++i) {
    for (std::size_t k = 0; k < point_count; ++k) {
      const auto at = [&](std::size_t ring, std::size_t point) {
        return result.wall_mm[ring * point_count + point % point_count];
      };
      const vec3 round = at(i, k + 1) - at(i, k + point_count - 1);
      const vec3 down = at(std::min(i + 1, ring_count - 1), k) - at(i == 0 ? 0 : i - 1, k);
      result.normals.push_back(glm::normalize(glm::cross(down, round)));
    }
  }
  return result;
}

std::vector<vec3> middles_mm(const ShotHole& shot_hole) {
  return {{shot_hole.shape.centre_mm, shot_hole.wall_mm.front().z}, {shot_hole.shape.centre_mm, shot_hole.wall_mm.back().z}};
}

std::vector<std::size_t> closed_triangles(const ShotHole& shot_hole) {
  std::vector<std::size_t> triangles;
  const std::size_t front = shot_hole.wall_mm.size();
  const auto at = [&](std::size_t ring, std::size_t point) { return ring * shot_hole.points + point % shot_hole.points; };
  for (std::size_t k = 0; k < shot_hole.points; ++k) {
    triangles.insert(triangles.end(), {front, at(0, k), at(0, k + 1)});
    for (std::size_t i = 0; i + 1 < shot_hole.rings; ++i) {
      triangles.insert(triangles.end(), {at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
    triangles.insert(triangles.end(), {front + 1, at(shot_hole.rings - 1, k + 1), at(shot_hole.rings - 1, k)});
  }
  return triangles;
}

}  // namespace shatterpave::glass
