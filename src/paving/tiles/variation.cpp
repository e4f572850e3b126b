// A stone's new place is an affine map of its outline. Under one no point moves farther than the corner that moves most, so it
// is enough to hold the corners back: where one would go too far, the whole movement is scaled down.
#include "paving/tiles/variation.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/tiles/hand_stones.h"

namespace shatterpave::paving {

namespace {

// Rounding of both faces to the lattice, and of the cells that they are of, with some room.
constexpr double rounding_mm = 0.01;

// How far a corner may move, where sides stray into the joint by `bulge` of it.
double own_room_mm(const Pavement& pavement, double bulge) {
  return std::max(0.0, (0.5 - bulge) * pavement.joint_mm - rounding_mm);
}

// Takes what it uses off `room_mm`.
geometry::Polygon moved(const geometry::Polygon& outline, const Pavement& pavement, double& room_mm, std::uint64_t seed,
                        Id id) {
  const Variation& variation = pavement.variation;
  const auto draw = [&](std::uint32_t index) { return 2.0 * uniform(seed, {Stream::stone_place, id, index}) - 1.0; };
  const double scale = 1.0 + variation.size * draw(0);
  const Angle turn = variation.rotation * draw(1);
  const vec2 offset = variation.offset_mm * vec2{draw(2), draw(3)};
  const vec2 middle = geometry::centroid(outline);
  std::vector<vec2> steps;
  steps.reserve(outline.size());
  double farthest = 0.0;
  for (const vec2& p : outline) {
    steps.push_back(middle + scale * rotated(p - middle, turn) + offset - p);
    farthest = std::max(farthest, std::sqrt(glm::dot(steps.back(), steps.back())));
  }
  const double part = farthest > room_mm ? room_mm / farthest : 1.0;
  geometry::Polygon result(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) result[i] = geometry::on_lattice(outline[i] + part * steps[i]);
  result = geometry::cleaned(result);
  if (!geometry::is_simple(result) || geometry::area(result) <= 0.0) return outline;
  room_mm = std::max(0.0, room_mm - part * farthest);
  return result;
}

// Without those that the seed leaves out; of stones laid by hand they are told.
void leave_out(StoneLayout& layout, const Pavement& pavement, std::uint64_t seed) {
  const auto is_missing = [&](const Stone& stone) {
    const Id id = Id(pavement.name).child(static_cast<std::uint64_t>(stone.id));
    return uniform(seed, {Stream::stone_missing, id}) < pavement.variation.missing;
  };
  if (pavement.hand.amount > 0.0) std::ranges::copy_if(layout.stones, std::back_inserter(layout.missing), is_missing);
  std::erase_if(layout.stones, is_missing);
}

}  // namespace

StoneLayout varied(StoneLayout layout, const std::vector<bool>& held, const Pavement& pavement, double bulge,
                   std::uint64_t seed) {
  const Variation& variation = pavement.variation;
  const auto id_of = [&](const Stone& stone) { return Id(pavement.name).child(static_cast<std::uint64_t>(stone.id)); };
  const bool by_hand = pavement.hand.amount > 0.0;
  const bool moves = variation.size > 0.0 || variation.rotation > Angle() || variation.offset_mm > 0.0;
  if (moves || by_hand) {
    parallel_for(layout.stones.size(), [&](std::size_t s) {
      Stone& stone = layout.stones[s];
      double room_mm = !held.empty() && held[s] ? 0.0 : own_room_mm(pavement, bulge);
      if (moves) stone.outline_mm = moved(stone.outline_mm, pavement, room_mm, seed, id_of(stone));
      if (!by_hand) return;
      stone.outline_mm = hand_face(stone.outline_mm, pavement, room_mm, seed, id_of(stone));
      stone.sunk_mm = sunk_mm(pavement, seed, id_of(stone));
    });
  }
  if (variation.missing > 0.0) leave_out(layout, pavement, seed);
  return layout;
}

}  // namespace shatterpave::paving
