#include "export/usd/welded_mesh.h"

#include <limits>
#include <unordered_map>

#include "export/usd/prim_text.h"

namespace shatterpave::exporting::usd {

namespace {

template <std::size_t width>
using Key = std::array<std::int64_t, width>;

// The mixing of SplitMix64 (Steele, Lea and Flood 2014), over the parts one after the other.
template <std::size_t width>
struct KeyHash {
  std::size_t operator()(const Key<width>& key) const {
    std::uint64_t hash = 0;
    for (const std::int64_t part : key) {
      hash += static_cast<std::uint64_t>(part) + 0x9e3779b97f4a7c15U;
      hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
      hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
      hash ^= hash >> 31U;
    }
    return hash;
  }
};

// Distinct values, in the order in which they came.
template <std::size_t width>
class Distinct {
 public:
  explicit Distinct(std::size_t expected) { numbers_.reserve(expected); }
  std::uint32_t number(const Key<width>& key) {
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(values_.size()));
    if (is_new) values_.push_back(key);
    return found->second;
  }
  std::vector<Key<width>> values() && { return std::move(values_); }

 private:
  std::vector<Key<width>> values_;
  std::unordered_map<Key<width>, std::uint32_t, KeyHash<width>> numbers_;
};

Key<3> key_of(vec3 value, double parts) {
  return {in_parts(value.x, parts), in_parts(value.y, parts), in_parts(value.z, parts)};
}
Key<2> key_of(vec2 value, double parts) { return {in_parts(value.x, parts), in_parts(value.y, parts)}; }

// What is common to all corners of a point is of the point.
template <std::size_t width>
CornerValues<width> of_points_if_so(std::vector<Key<width>> values, std::vector<std::uint32_t> of_corner,
                                    const std::vector<std::uint32_t>& corners, std::size_t point_count) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> of_point(point_count, none);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::uint32_t& own = of_point[corners[i]];
    if (own == none) own = of_corner[i];
    if (own != of_corner[i]) return {std::move(values), std::move(of_corner)};
  }
  CornerValues<width> result;
  // A point that no facet has any more has the first value.
  for (const std::uint32_t number : of_point) result.values.push_back(values[number == none ? 0 : number]);
  return result;
}

}  // namespace

WeldedMesh welded(const std::vector<shapes::Piece>& pieces) {
  std::size_t most = 0;
  for (const shapes::Piece& piece : pieces) most += piece.mesh.points_mm.size();
  Distinct<3> points(most);
  Distinct<3> normals(most);
  Distinct<2> places(most);
  std::vector<std::uint32_t> normal_of;
  std::vector<std::uint32_t> place_of;
  WeldedMesh result;
  for (const shapes::Piece& piece : pieces) {
    const shapes::Mesh& mesh = piece.mesh;
    std::vector<std::array<std::uint32_t, 3>> numbers(mesh.points_mm.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = {points.number(key_of(mesh.points_mm[i], parts_of_m / 1000.0)),
                    normals.number(key_of(mesh.normals[i], parts_of_one)), places.number(key_of(mesh.uv_m[i], parts_of_uv))};
    }
    const std::size_t before = result.corners.size();
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const std::array<std::uint32_t, 3> corner{numbers[mesh.triangles[i]][0], numbers[mesh.triangles[i + 1]][0],
                                                numbers[mesh.triangles[i + 2]][0]};
      if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& number = numbers[mesh.triangles[i + k]];
        result.corners.push_back(number[0]);
        normal_of.push_back(number[1]);
        place_of.push_back(number[2]);
      }
    }
    result.facets_of_piece.push_back((result.corners.size() - before) / 3);
  }
  result.points = std::move(points).values();
  result.normals = of_points_if_so(std::move(normals).values(), std::move(normal_of), result.corners, result.points.size());
  result.places = of_points_if_so(std::move(places).values(), std::move(place_of), result.corners, result.points.size());
  return result;
}

}  // namespace shatterpave::exporting::usd
