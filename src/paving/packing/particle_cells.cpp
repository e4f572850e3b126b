// The Delaunay triangulation of a square packing has the sides of the squares as links, and one diagonal of each square.
// Without the diagonals it is a mesh of quadrilaterals with a particle at each vertex. A stone is the dual: the ring of the
// centroids of the faces about its particle. In the regular part the faces have four corners, as has each stone, and the
// corners of stones are the middles between four particles; where a row ends a triangle remains.
//
// Beside the end of a row the stones of one row lie shifted against those of the next. To draw their perpends together would
// shear them, and their neighbours. So two triangles make a quadrilateral only if that is nearly upright: where the shift is
// more, both remain, and each perpend ends at a T on the straight side of a stone. A paviour does the same, who lets perpends
// run through where they meet and lets them be where they do not. Only where the bend is so sharp that the straight sides of
// shifted stones could not keep the joint (`largest_bulge`) are all perpends drawn together that can be.
#include "paving/packing/particle_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/delaunay.h"
#include "geometry/lattice.h"

namespace shatterpave::paving {

namespace {

using geometry::Delaunay;

// A link is a diagonal if of its components along the rows and across them, in pitches, the lesser is at least this part of
// the other. So perpends of two rows that are 0.15 of a stone apart still meet. By trial on all plans of
// benchmarks/packing_quality: with less stones are sheared more, and differ more in size; with more, longer runs of Ts bend
// about sharp bends, where not all stones can keep four sides.
constexpr double least_diagonal = 0.85;
// The same where the bend is sharp: nearer to the diagonal than to the axes by angle (tan 22.5°).
constexpr double least_sharp_diagonal = 0.41421356;

struct Diagonal {
  double score = 0.0;  // 1 at 45°
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t left_face = 0;
  std::uint32_t right_face = 0;
};

// What tells whether a link between two particles is a diagonal.
struct DiagonalRule {
  vec2 pitch{1.0, 1.0};
  double sharp_sine = 0.0;  // rows that turn by more from stone to stone bend sharply

  double score(const Particle& a, const Particle& b) const;
  double least(const Particle& a, const Particle& b) const {
    const double turn = std::abs(cross(a.axis, turned_like(b.axis, a.axis, pitch.x == pitch.y)));
    return turn > sharp_sine ? least_sharp_diagonal : least_diagonal;
  }
};

double DiagonalRule::score(const Particle& a, const Particle& b) const {
  const vec2 q = frame_between(a, b, pitch.x == pitch.y, pitch).into(b.at - a.at);
  const double u = std::abs(q.x);
  const double v = std::abs(q.y);
  return std::min(u, v) / std::max(u, v);
}

struct Faces {
  std::vector<std::array<std::uint32_t, 4>> corners;  // particles of a face, counter-clockwise from any
  std::vector<std::uint8_t> size;                     // how many it has; 5 stands for more than four
};

Faces faces_of(const Delaunay& mesh) {
  Faces faces{std::vector<std::array<std::uint32_t, 4>>(mesh.face_count), std::vector<std::uint8_t>(mesh.face_count, 0)};
  for (std::size_t p = 0; p < mesh.point_count(); ++p) {
    for (const Delaunay::Spoke& spoke : mesh.around(p)) {
      if (spoke.face == Delaunay::none) continue;
      std::uint8_t& size = faces.size[spoke.face];
      if (size < 4) faces.corners[spoke.face][size] = static_cast<std::uint32_t>(p);
      if (size < 5) ++size;
    }
  }
  return faces;
}

// Whether the two triangles beside the link make a convex quadrilateral: the link's ends lie on either side of the line
// between the opposite corners.
bool convex(const Diagonal& d, const Faces& faces, std::span<const Particle> particles) {
  const auto opposite = [&](std::uint32_t face) {
    const auto& c = faces.corners[face];
    return particles[*std::find_if(c.begin(), c.begin() + 2, [&](std::uint32_t p) { return p != d.from && p != d.to; })].at;
  };
  const vec2 a = opposite(d.left_face);
  const vec2 b = opposite(d.right_face);
  const double s = cross(b - a, particles[d.from].at - a);
  const double t = cross(b - a, particles[d.to].at - a);
  return (s > 0.0 && t < 0.0) || (s < 0.0 && t > 0.0);
}

std::vector<Diagonal> diagonals(const Delaunay& mesh, const Faces& faces, std::span<const Particle> particles,
                                const DiagonalRule& rule) {
  std::vector<Diagonal> found;
  for (std::size_t p = 0; p < mesh.point_count(); ++p) {
    const auto around = mesh.around(p);
    for (std::size_t k = 0; k < around.size(); ++k) {
      const std::uint32_t left = around[k].face;
      const std::uint32_t right = around[(k + around.size() - 1) % around.size()].face;
      if (around[k].neighbour < p || left == Delaunay::none || right == Delaunay::none) continue;
      if (faces.size[left] != 3 || faces.size[right] != 3) continue;
      const Particle& other = particles[around[k].neighbour];
      const double score = rule.score(particles[p], other);
      if (score < rule.least(particles[p], other)) continue;
      found.push_back({score, static_cast<std::uint32_t>(p), around[k].neighbour, left, right});
      if (!convex(found.back(), faces, particles)) found.pop_back();
    }
  }
  std::ranges::sort(found, [](const Diagonal& a, const Diagonal& b) {
    return a.score != b.score ? a.score > b.score : std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  return found;
}

// For each face the face that stands for it and its partner, once the best diagonals are removed. A stone has a corner for each
// of its particle's links that stay: it keeps four.
std::vector<std::uint32_t> merged_faces(const std::vector<Diagonal>& candidates, const Delaunay& mesh) {
  std::vector<std::uint32_t> stands(mesh.face_count);
  for (std::size_t f = 0; f < mesh.face_count; ++f) stands[f] = static_cast<std::uint32_t>(f);
  std::vector<std::size_t> links(mesh.point_count());
  for (std::size_t p = 0; p < mesh.point_count(); ++p) links[p] = mesh.around(p).size();
  std::vector<bool> taken(mesh.face_count, false);
  for (const Diagonal& d : candidates) {
    if (taken[d.left_face] || taken[d.right_face] || links[d.from] <= 4 || links[d.to] <= 4) continue;
    --links[d.from];
    --links[d.to];
    taken[d.left_face] = taken[d.right_face] = true;
    stands[std::max(d.left_face, d.right_face)] = std::min(d.left_face, d.right_face);
  }
  return stands;
}

std::vector<vec2> face_centroids(const Delaunay& mesh, const std::vector<std::uint32_t>& stands,
                                 std::span<const Particle> particles) {
  std::vector<vec2> sum(mesh.face_count, vec2{0.0, 0.0});
  std::vector<int> count(mesh.face_count, 0);
  for (std::size_t p = 0; p < mesh.point_count(); ++p) {
    const auto around = mesh.around(p);
    for (std::size_t k = 0; k < around.size(); ++k) {
      if (around[k].face == Delaunay::none) continue;
      const std::uint32_t previous = around[(k + around.size() - 1) % around.size()].face;
      const std::uint32_t face = stands[around[k].face];
      // Both triangles of a quadrilateral follow one another about the ends of the diagonal: count those once.
      if (previous != Delaunay::none && stands[previous] == face) continue;
      sum[face] += particles[p].at;
      ++count[face];
    }
  }
  for (std::size_t f = 0; f < mesh.face_count; ++f) {
    if (count[f] > 0) sum[f] = geometry::on_lattice(sum[f] / static_cast<double>(count[f]));
  }
  return sum;
}

}  // namespace

Cells cells_of(std::span<const Particle> particles, const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  // A bend is sharp where the sagitta of a stone's side, pitch · turn / 8, is more than the largest bulge.
  const DiagonalRule rule{pitch, 8.0 * largest_bulge * pavement.joint_mm / std::max(pitch.x, pitch.y)};
  std::vector<vec2> points(particles.size());
  std::ranges::transform(particles, points.begin(), &Particle::at);
  const Delaunay mesh = geometry::delaunay(points);
  const auto stands = merged_faces(diagonals(mesh, faces_of(mesh), particles, rule), mesh);

  Cells cells;
  cells.corners = face_centroids(mesh, stands, particles);
  cells.first.push_back(0);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    cells.axis.push_back(particles[p].axis);
    cells.size.push_back(particles[p].size);
    const auto around = mesh.around(p);
    const bool open = std::ranges::any_of(around, [](const Delaunay::Spoke& s) { return s.face == Delaunay::none; });
    for (std::size_t k = 0; k < around.size() && !open; ++k) {
      const std::uint32_t before = stands[around[(k + around.size() - 1) % around.size()].face];
      if (before == stands[around[k].face]) continue;
      cells.corner.push_back(before);
      cells.neighbour.push_back(around[k].neighbour);
    }
    cells.first.push_back(cells.corner.size());
  }
  return cells;
}

}  // namespace shatterpave::paving
