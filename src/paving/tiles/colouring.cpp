// Along a gradient, or away from attractors, stones are put in order by their place, blurred by a draw; the first of them take
// the first colour, as many as its share asks for, the next the second. Without, stones are taken along Hilbert's curve, so
// that each is near those before it, and each draws from the colours that are behind their shares so far: errors are handed on,
// as in error diffusion of pictures.
#include "paving/tiles/colouring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "core/random.h"

namespace shatterpave::paving {

namespace {

// How finely Hilbert's curve tells places apart: far below a stone of the largest pavements.
constexpr std::uint32_t curve_bits = 16;

// How far along Hilbert's curve a cell of a square of 2^bits cells a side lies.
std::uint64_t along_curve(std::uint32_t x, std::uint32_t y) {
  std::uint64_t result = 0;
  for (std::uint32_t side = 1U << (curve_bits - 1); side > 0; side /= 2) {
    const bool right = (x & side) != 0;
    const bool upper = (y & side) != 0;
    result += static_cast<std::uint64_t>(side) * side * ((3U * (right ? 1U : 0U)) ^ (upper ? 1U : 0U));
    if (upper) continue;
    if (right) {
      x = (2 * side - 1) - (x & (2 * side - 1));
      y = (2 * side - 1) - (y & (2 * side - 1));
    }
    std::swap(x, y);
  }
  return result;
}

geometry::Box box_of(const std::vector<vec2>& places) {
  geometry::Box box{places.front(), places.front()};
  for (const vec2& p : places) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}

double draw(const Pavement& pavement, std::uint64_t seed, const Stone& stone, std::uint32_t index) {
  return uniform(seed, {Stream::colour_blur, Id(pavement.name).child(static_cast<std::uint64_t>(stone.id)), index});
}

std::vector<std::size_t> in_order(std::size_t count, const auto& key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(key(i), i); });
  return order;
}

void mix_evenly(StoneLayout& layout, const Pavement& pavement, const std::vector<vec2>& places, std::uint64_t seed) {
  const geometry::Box box = box_of(places);
  const double side = std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1.0});
  constexpr double cells = (1U << curve_bits) - 1;
  const auto cell = [&](double from_low) { return static_cast<std::uint32_t>(from_low / side * cells); };
  const auto order = in_order(
      places.size(), [&](std::size_t i) { return along_curve(cell(places[i].x - box.low.x), cell(places[i].y - box.low.y)); });
  const auto& shares = pavement.look.colours.shares;
  std::vector<double> behind(shares.size(), 0.0);
  for (const std::size_t i : order) {
    double total = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      behind[k] += shares[k];
      total += std::max(0.0, behind[k]);
    }
    double left = total * draw(pavement, seed, layout.stones[i], 0);
    std::size_t chosen = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      if (behind[k] <= 0.0) continue;
      chosen = k;
      left -= behind[k];
      if (left < 0.0) break;
    }
    behind[chosen] -= 1.0;
    layout.stones[i].colour = static_cast<int>(chosen);
  }
}

// Where a place lies in the order of the colours: any number that grows with it.
double rank_at(const ColourMix& mix, vec2 place) {
  if (mix.gradient_mm) {
    const vec2 way = mix.gradient_mm->second - mix.gradient_mm->first;
    return glm::dot(place - mix.gradient_mm->first, way) / glm::length(way);
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const vec2& attractor : mix.attractors_mm) nearest = std::min(nearest, glm::length(place - attractor));
  return nearest;
}

void follow(StoneLayout& layout, const Pavement& pavement, const std::vector<vec2>& places, std::uint64_t seed) {
  const ColourMix& mix = pavement.look.colours;
  std::vector<double> ranks(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) ranks[i] = rank_at(mix, places[i]);
  const auto [low, high] = std::ranges::minmax(ranks);
  const double reach = mix.blur * (high - low);
  for (std::size_t i = 0; i < places.size(); ++i) ranks[i] += reach * (draw(pavement, seed, layout.stones[i], 1) - 0.5);
  const auto order = in_order(places.size(), [&](std::size_t i) { return ranks[i]; });
  double end = 0.0;
  std::size_t next = 0;
  for (std::size_t k = 0; k < mix.shares.size(); ++k) {
    end += mix.shares[k] * static_cast<double>(places.size());
    const bool last = k + 1 == mix.shares.size();
    const std::size_t stop = last ? places.size() : std::min(places.size(), static_cast<std::size_t>(std::lround(end)));
    for (; next < stop; ++next) layout.stones[order[next]].colour = static_cast<int>(k);
  }
}

}  // namespace

void colour(StoneLayout& layout, const Pavement& pavement, std::uint64_t seed) {
  const ColourMix& mix = pavement.look.colours;
  if (mix.colours.empty() || layout.stones.empty()) return;
  std::vector<vec2> places;
  places.reserve(layout.stones.size());
  for (const Stone& stone : layout.stones) places.push_back(geometry::centroid(stone.outline_mm));
  if (mix.gradient_mm || !mix.attractors_mm.empty()) {
    follow(layout, pavement, places, seed);
  } else {
    mix_evenly(layout, pavement, places, seed);
  }
}

}  // namespace shatterpave::paving
