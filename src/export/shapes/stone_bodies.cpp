#include "export/shapes/stone_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/parallel.h"
#include "core/random.h"
#include "export/names.h"
#include "export/shapes/mesh_parts.h"
#include "export/shapes/stone_mesh.h"
#include "export/shapes/stone_relief.h"
#include "export/shapes/swatch.h"
#include "export/shapes/tones.h"
#include "export/shapes/unrolling.h"
#include "geometry/clip.h"
#include "geometry/region_index.h"
#include "paving/surface/laid_surface.h"
#include "paving/surface/wear.h"

namespace shatterpave::exporting::shapes {

namespace {

constexpr std::size_t bodies_at_once = 1024;

// ---- places in textures

constexpr int place_count = places_aside * places_aside;

vec2 place_m(int place, double side_m) {
  const double step = side_m / places_aside;
  const int column = place % places_aside;
  const int row = place / places_aside;
  return {step * static_cast<double>(column), step * static_cast<double>(row)};
}

// By how much two stretches of a swatch have something in common, along one of its sides.
double common(double a, double a_length, double b, double b_length, double side_m) {
  const double ahead = b - a - side_m * std::floor((b - a) / side_m);
  return std::max({0.0, std::min(a_length - ahead, b_length), std::min(b_length - (side_m - ahead), a_length)});
}

// What a stone shows: about its place.
struct Window {
  vec2 size_m{0.0, 0.0};
  int place = 0;
};

double common(const Window& a, const Window& b, double side_m) {
  const vec2 p = place_m(a.place, side_m) - 0.5 * a.size_m;
  const vec2 q = place_m(b.place, side_m) - 0.5 * b.size_m;
  return common(p.x, a.size_m.x, q.x, b.size_m.x, side_m) * common(p.y, a.size_m.y, q.y, b.size_m.y, side_m);
}

namespace bg = boost::geometry;
using BoxPoint = bg::model::d2::point_xy<double>;
using StoneBox = std::pair<bg::model::box<BoxPoint>, std::uint32_t>;

bg::model::box<BoxPoint> box_of(const geometry::Box& box, double more_mm) {
  return {{box.low.x - more_mm, box.low.y - more_mm}, {box.high.x + more_mm, box.high.y + more_mm}};
}

// Whether two stones come within `near_mm` of one another, as far as the boxes along their axes tell.
bool are_near(const paving::Stone& a, const paving::Stone& b, double near_mm) {
  const auto overlap_along = [&](vec2 axis) {
    const auto range = [&](const geometry::Polygon& outline) {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const vec2& p : outline) {
        low = std::min(low, glm::dot(p, axis));
        high = std::max(high, glm::dot(p, axis));
      }
      return std::pair(low, high);
    };
    const auto [a_low, a_high] = range(a.outline_mm);
    const auto [b_low, b_high] = range(b.outline_mm);
    return a_low <= b_high + near_mm && b_low <= a_high + near_mm;
  };
  const vec2 d = a.angle.direction();
  const vec2 e = b.angle.direction();
  return overlap_along(d) && overlap_along(left_of(d)) && overlap_along(e) && overlap_along(left_of(e));
}

// For each stone where its texture begins: of the places in an order that it draws, the first whose part of the texture none of
// its neighbours before it shows, or else the one of which they show least.
std::vector<int> texture_places(const PavedArea& paved, double side_m, std::uint64_t seed) {
  const auto& stones = paved.layout.stones;
  std::vector<geometry::Box> boxes(stones.size());
  std::vector<Window> windows(stones.size());
  std::vector<StoneBox> entries(stones.size());
  const double near_mm = 1.5 * paved.pavement.joint_mm + 1.0;
  parallel_for_chunks(stones.size(), bodies_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      boxes[i] = geometry::bounding_box(stones[i].outline_mm);
      entries[i] = {box_of(boxes[i], 0.0), static_cast<std::uint32_t>(i)};
      const vec2 along = stones[i].angle.direction();
      vec2 most{0.0, 0.0};
      const vec2 centre = geometry::centroid(stones[i].outline_mm);
      for (const vec2& p : stones[i].outline_mm) {
        most = glm::max(most, vec2{std::abs(glm::dot(p - centre, along)), std::abs(cross(along, p - centre))});
      }
      const double more = folded_mm(paved.pavement);
      windows[i].size_m = {metres(2.0 * (most.x + more)), metres(2.0 * (most.y + more))};
    }
  });
  const bg::index::rtree<StoneBox, bg::index::rstar<16>> index(entries);
  std::vector<int> places(stones.size(), 0);
  std::vector<StoneBox> near;
  const Id id = Id(paved.pavement.name).child("texture");
  for (std::size_t i = 0; i < stones.size(); ++i) {
    near.clear();
    index.query(bg::index::intersects(box_of(boxes[i], near_mm)), std::back_inserter(near));
    std::erase_if(
        near, [&](const StoneBox& other) { return other.second >= i || !are_near(stones[i], stones[other.second], near_mm); });
    const Address address{Stream::stone_relief, id.child(static_cast<std::uint64_t>(stones[i].id))};
    const int first = static_cast<int>(uniform(seed, address) * place_count);
    double least = -1.0;
    for (int k = 0; k < place_count && least != 0.0; ++k) {
      // 29 and 64 have no divisor in common, so that all places come, and neighbours in the order lie apart.
      Window window{windows[i].size_m, (first + 29 * k) % place_count};
      double shown = 0.0;
      for (const StoneBox& other : near) shown += common(window, windows[other.second], side_m);
      if (least >= 0.0 && shown >= least) continue;
      least = shown;
      windows[i].place = window.place;
    }
    places[i] = windows[i].place;
  }
  return places;
}

// ---- stones

// Parts of a stone along a side; by eye: from a stone's length away no corner shows of a dome, or of a face, which is nearly
// flat.
constexpr double parts_of_a_dome = 5.0;
constexpr double parts_of_a_face = 3.0;
// Half of a right angle each: an arris of two facets with smooth normals looks round.
constexpr std::size_t least_parts = 2;

vec3 lying(vec3 p) { return {p.x, p.z, -p.y}; }

Placing lying_at(vec2 centre, double height_mm, Angle angle) {
  const vec2 d = angle.direction();
  return {{vec3{d.x, 0.0, d.y}, vec3{0.0, 1.0, 0.0}, vec3{-d.y, 0.0, d.x}}, lying({centre.x, centre.y, height_mm})};
}

// How many stones are alike is found by their corners: within this they are the same.
constexpr double alike_mm = 0.005;
// Shapes that are looked at; a bond has fewer, and where stones are all different none is found again.
constexpr std::size_t most_shapes = 64;

class StoneBodies {
 public:
  // Both must outlive this.
  StoneBodies(const PavedArea& paved, std::size_t first_material, std::uint64_t seed)
      : paved_(paved),
        first_material_(first_material),
        surface_(paved.pavement, paved.layout.stones, seed),
        side_m_(swatch_side_m(paved)),
        places_(texture_places(paved, side_m_, seed)),
        slope_(paving::fall(paved.pavement.ground)) {
    if (paved.pavement.detail && paved.pavement.detail->close_mm > 0.0 && paved.pavement.relief.rms_mm > 0.0) {
      relief_ = stone_relief_heights(paved.pavement, seed);
    }
    const relief::FractalSurface relief = stone_relief(paved.pavement);
    relief_side_mm_ = static_cast<double>(relief.size) * relief.spacing_mm;
    share();
  }

  std::size_t count() const { return paved_.layout.stones.size(); }
  // Whether another stone before it has the same meshes.
  bool is_again(std::size_t i) const { return !owner_.empty() && owner_[i] != i; }

  Body body(std::size_t i) const {
    const paving::Stone& stone = paved_.layout.stones[i];
    Body body;
    body.name = fmt::format("{}.{}", paved_.pavement.name, stone.id);
    body.kind = fmt::format("stone {}{}", name_of(stone.kind), stone.part == paving::StonePart::border ? " border" : "");
    const vec2 centre = geometry::centroid(stone.outline_mm);
    body.placing = lying_at(centre, level_mm(centre), stone.angle);
    if (!owner_.empty() && is_shared_[owner_[i]]) body.shared = owner_[i];
    if (!is_again(i)) body.pieces.push_back(piece(i, centre));
    return body;
  }

  // Heights of the middles of the faces, fall left out.
  std::vector<double> face_heights() const {
    std::vector<double> heights(count());
    parallel_for_chunks(count(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto patches = surface_.patches(i, surface_.draws(i));
        heights[i] = geometry::height_at(patches, geometry::centroid(paved_.layout.stones[i].outline_mm));
      }
    });
    return heights;
  }

 private:
  double level_mm(vec2 at) const { return paved_.pavement.ground.level_mm + glm::dot(slope_, at); }

  // With its relief near the viewer, else as it is seen from farther off.
  StoneMesh mesh(const std::vector<geometry::BezierPatch>& patches, const paving::StoneDraws& draws, vec2 centre,
                 double size_mm) const {
    const auto& detail = paved_.pavement.detail;
    if (!detail || glm::length(centre - detail->viewer_mm) > detail->close_mm) {
      const bool is_dome = paved_.pavement.body.finish == paving::Finish::none;
      return level_mesh(patches, size_mm / (is_dome ? parts_of_a_dome : parts_of_a_face), least_parts);
    }
    const ReliefWindow window{relief_ ? &*relief_ : nullptr, draws.relief_place, centre, relief_side_mm_, draws.relief};
    return displaced(patches, window, detail->mesh_mm);
  }

  // The mesh about the middle of the stone, its axis along x.
  Piece piece(std::size_t i, vec2 centre) const {
    const paving::Stone& stone = paved_.layout.stones[i];
    const paving::StoneDraws draws = surface_.draws(i);
    const auto patches = surface_.patches(i, draws);
    const StoneMesh made = mesh(patches, draws, centre, std::sqrt(geometry::area(stone.outline_mm)));
    Piece piece{first_material_ + material_of(stone, draws.colour), {}};
    const vec2 along = stone.angle.direction();
    const vec2 offset = place_m(places_[i], side_m_);
    const std::vector<vec2> sheet = unrolled(made);
    for (std::size_t v = 0; v < made.vertices.size(); ++v) {
      const vec3& p = made.vertices[v];
      const vec3& n = made.normals[v];
      const vec2 from = vec2{p.x, p.y} - centre;
      const vec3 own{glm::dot(from, along), cross(along, from), p.z + glm::dot(slope_, from)};
      const vec3 turned{glm::dot(vec2{n.x, n.y}, along), cross(along, vec2{n.x, n.y}), n.z};
      const vec2 rolled = sheet[v] - centre;
      append_point(piece.mesh, lying(own), lying(turned),
                   offset + vec2{metres(glm::dot(rolled, along)), metres(cross(along, rolled))});
    }
    piece.mesh.triangles = made.triangles;
    piece.mesh = welded(piece.mesh);
    return piece;
  }

  // Finds stones that are alike but for where they lie. What makes each different, wear and ground, is left out where there is
  // any; of what a stone draws, those with one texture place have it in common.
  void share() {
    const paving::Pavement& pavement = paved_.pavement;
    if (pavement.detail || pavement.body.wear_mm > 0.0 || !surface_.is_level() || slope_ != vec2{0.0, 0.0}) return;
    const auto& stones = paved_.layout.stones;
    const geometry::RegionIndex area(pavement.area);
    std::vector<Shape> shapes;
    std::map<std::pair<std::size_t, int>, std::size_t> first;
    owner_.resize(stones.size());
    is_shared_.assign(stones.size(), false);
    for (std::size_t i = 0; i < stones.size(); ++i) {
      owner_[i] = i;
      const auto number = number_in(shapes, shape_of(stones[i], paving::sawn_sides(stones[i], pavement, area)));
      if (!number) continue;
      owner_[i] = first.try_emplace({*number, places_[i]}, i).first->second;
      if (owner_[i] != i) is_shared_[owner_[i]] = true;
    }
  }

  // A stone about its middle, its axis along x.
  struct Shape {
    std::vector<vec2> corners;
    std::vector<bool> sawn;  // the side from each corner to the next

    bool is_like(const Shape& other) const {
      return sawn == other.sawn && std::ranges::equal(corners, other.corners, [](vec2 a, vec2 b) {
               return std::abs(a.x - b.x) <= alike_mm && std::abs(a.y - b.y) <= alike_mm;
             });
    }
  };

  static Shape shape_of(const paving::Stone& stone, const paving::IsSawn& is_sawn) {
    const vec2 centre = geometry::centroid(stone.outline_mm);
    const vec2 along = stone.angle.direction();
    const geometry::Polygon& outline = stone.outline_mm;
    Shape shape;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const vec2& p = outline[k];
      shape.corners.emplace_back(glm::dot(p - centre, along), cross(along, p - centre));
      shape.sawn.push_back(is_sawn && is_sawn(p, outline[(k + 1) % outline.size()]));
    }
    // From the lowest of the left ones, however the outline begins.
    const auto is_before = [](vec2 a, vec2 b) { return std::pair(a.x < 0.0, -a.y) > std::pair(b.x < 0.0, -b.y); };
    const auto least = std::ranges::min_element(shape.corners, is_before) - shape.corners.begin();
    std::rotate(shape.corners.begin(), shape.corners.begin() + least, shape.corners.end());
    std::rotate(shape.sawn.begin(), shape.sawn.begin() + least, shape.sawn.end());
    return shape;
  }

  // The number of the first shape that is like it, or of a new one; nothing where there are too many.
  static std::optional<std::size_t> number_in(std::vector<Shape>& shapes, Shape shape) {
    const auto found = std::ranges::find_if(shapes, [&](const Shape& other) { return other.is_like(shape); });
    if (found != shapes.end()) return static_cast<std::size_t>(found - shapes.begin());
    if (shapes.size() >= most_shapes) return std::nullopt;
    shapes.push_back(std::move(shape));
    return shapes.size() - 1;
  }

  const PavedArea& paved_;
  std::size_t first_material_;
  paving::LaidSurface surface_;
  double side_m_;  // of the swatch
  std::vector<int> places_;
  vec2 slope_;
  std::optional<relief::HeightField> relief_;
  double relief_side_mm_ = 1.0;
  std::vector<std::size_t> owner_;  // of each stone, the first with its meshes; empty where none are shared
  std::vector<bool> is_shared_;     // of those
};

// ---- filling and water

// Lies as the ground does: fall and level.
Mesh laid_down(Mesh mesh, const paving::Ground& ground) {
  const vec2 slope = paving::fall(ground);
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    vec3& p = mesh.points_mm[i];
    vec3& n = mesh.normals[i];
    p = lying({p.x, p.y, p.z + ground.level_mm + glm::dot(slope, vec2{p.x, p.y})});
    n = lying(glm::normalize(n - n.z * vec3{slope.x, slope.y, 0.0}));
  }
  return mesh;
}

// The filling as the sunken ground lies: its upper surface alone, in squares that are cut off at the border.
Mesh sunken_surface(const paving::Pavement& pavement, std::uint64_t seed) {
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  const vec2 size = box.high - box.low;
  const double step = paving::ground_square_mm(pavement);
  const auto columns = static_cast<std::size_t>(std::ceil(size.x / step));
  const auto rows = static_cast<std::size_t>(std::ceil(size.y / step));
  std::vector<Mesh> strips(rows);
  const double bed = paving::bed_level_mm(pavement);
  parallel_for(rows, [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const vec2 low = box.low + step * vec2{static_cast<double>(column), static_cast<double>(row)};
      const vec2 high = low + vec2{step, step};
      const geometry::Polygon square{geometry::on_lattice(low), geometry::on_lattice({high.x, low.y}),
                                     geometry::on_lattice(high), geometry::on_lattice({low.x, high.y})};
      for (const geometry::Region& part : geometry::intersection(square, pavement.area)) {
        Mesh top = upright_cap(part, bed);
        for (std::size_t i = 0; i < top.points_mm.size(); ++i) {
          vec3& p = top.points_mm[i];
          const paving::GroundPoint ground = paving::settlement(pavement.ground, seed, {p.x, p.y});
          p.z += ground.height_mm;
          top.normals[i] = glm::normalize(vec3{-ground.slope.x, -ground.slope.y, 1.0});
        }
        append(strips[row], top);
      }
    }
  });
  Mesh mesh;
  for (const Mesh& strip : strips) append(mesh, strip);
  return mesh;
}

Mesh filling(const paving::Pavement& pavement, std::uint64_t seed) {
  if (pavement.ground.settlement_mm > 0.0) return sunken_surface(pavement, seed);
  return upright_prism(pavement.area, -pavement.ground.depth_mm, paving::bed_level_mm(pavement));
}

}  // namespace

void append_stones(const PavedArea& paved, std::size_t first_material, std::uint64_t seed, const TakeBody& take) {
  const paving::Pavement& pavement = paved.pavement;
  const StoneBodies stones(paved, first_material, seed);
  std::vector<Body> bodies;
  for (std::size_t begin = 0; begin < stones.count(); begin += bodies_at_once) {
    bodies.assign(std::min(bodies_at_once, stones.count() - begin), {});
    parallel_for_chunks(bodies.size(), 16, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) bodies[i] = stones.body(begin + i);
    });
    for (Body& body : bodies) take(std::move(body));
  }
  const std::size_t joint = first_material + stone_materials(paved.pavement);
  take({pavement.name + ".joints", "joints", {{joint, laid_down(filling(pavement, seed), pavement.ground)}}});
  if (pavement.look.wetness <= 0.5) return;
  const auto water = paving::water_level_mm(pavement.look, stones.face_heights());
  if (!water) return;
  const double low = -pavement.ground.depth_mm - pavement.ground.settlement_mm;
  take({pavement.name + ".water",
        "water",
        {{joint + 1, laid_down(upright_prism(pavement.area, low, *water), pavement.ground)}}});
}

}  // namespace shatterpave::exporting::shapes
