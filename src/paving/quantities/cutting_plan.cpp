#include "paving/quantities/cutting_plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "core/error.h"

namespace shatterpave::paving {

namespace {

constexpr double size_rounding_mm = 0.01;

// A rectangle of a stock stone that is free.
struct Offcut {
  std::size_t stock = 0;
  vec2 low{0.0, 0.0};
  vec2 size{0.0, 0.0};
};

double shorter(vec2 size) { return std::min(size.x, size.y); }
double longer(vec2 size) { return std::max(size.x, size.y); }

class Offcuts {
 public:
  // Of rectangles none is narrower than this.
  explicit Offcuts(double narrowest_mm) : narrowest_(narrowest_mm) {}

  void keep(const Offcut& offcut) {
    if (shorter(offcut.size) + size_rounding_mm >= narrowest_) by_width_.emplace(shorter(offcut.size), offcut);
  }

  // The narrowest that holds a rectangle of that size; it is free no more.
  std::optional<Offcut> take(vec2 size) {
    for (auto at = by_width_.lower_bound(shorter(size) - size_rounding_mm); at != by_width_.end(); ++at) {
      if (longer(at->second.size) + size_rounding_mm < longer(size)) continue;
      const Offcut found = at->second;
      by_width_.erase(at);
      return found;
    }
    return std::nullopt;
  }

 private:
  double narrowest_;
  std::multimap<double, Offcut> by_width_;
};

// Two cuts part a rectangle from the rest: the first from side to side, beyond the rectangle's end where more is left over.
void keep_rest(const Offcut& whole, vec2 laid, Offcuts& offcuts) {
  const vec2 start = laid + vec2{saw_mm, saw_mm};
  const vec2 left = whole.size - start;
  const bool upright = left.x >= left.y;
  const vec2 beside{left.x, upright ? whole.size.y : laid.y};
  const vec2 above{upright ? laid.x : whole.size.x, left.y};
  if (left.x > 0.0) offcuts.keep({whole.stock, whole.low + vec2{start.x, 0.0}, beside});
  if (left.y > 0.0) offcuts.keep({whole.stock, whole.low + vec2{0.0, start.y}, above});
}

}  // namespace

std::vector<Cut> cutting_plan(const std::vector<vec2>& sizes_mm, vec2 stock_mm) {
  std::vector<std::size_t> order(sizes_mm.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return longer(sizes_mm[a]) != longer(sizes_mm[b]) ? longer(sizes_mm[a]) > longer(sizes_mm[b])
                                                      : shorter(sizes_mm[a]) > shorter(sizes_mm[b]);
  });
  double narrowest = longer(stock_mm);
  for (const vec2& size : sizes_mm) narrowest = std::min(narrowest, shorter(size));

  std::vector<Cut> cuts(sizes_mm.size());
  Offcuts offcuts(narrowest);
  std::size_t stock = 0;
  for (const std::size_t i : order) {
    const vec2 size = sizes_mm[i];
    ENSURE(shorter(size) > 0.0);
    std::optional<Offcut> from = offcuts.take(size);
    const bool is_new = !from;
    if (is_new) {
      ENSURE(size.x <= stock_mm.x + size_rounding_mm && size.y <= stock_mm.y + size_rounding_mm);
      from = Offcut{stock++, {0.0, 0.0}, stock_mm};
    }
    const bool fits = size.x <= from->size.x + size_rounding_mm && size.y <= from->size.y + size_rounding_mm;
    cuts[i] = {from->stock, from->low, !fits};
    keep_rest(*from, fits ? size : vec2{size.y, size.x}, offcuts);
  }
  return cuts;
}

}  // namespace shatterpave::paving
