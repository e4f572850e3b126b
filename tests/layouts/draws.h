// Draws by name: each is a pure function of the number of a layout, of what it is for and of its place, so that a new one
// changes no other.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/functions.h"
#include "core/random.h"

namespace shatterpave::layouts {

class Draws {
 public:
  explicit Draws(std::uint64_t number) : number_(number) {}

  // Those of a part: a hole, a guide, another attempt.
  Draws of(std::string_view name, std::uint64_t index = 0) const {
    Draws part = *this;
    part.id_ = id_.child(name).child(index);
    return part;
  }

  // [0, 1)
  double unit(std::string_view name, std::uint64_t index = 0) const {
    return uniform(number_, {Stream::packing, id_.child(name).child(index)});
  }
  double between(std::string_view name, double low, double high, std::uint64_t index = 0) const {
    return low + (high - low) * unit(name, index);
  }
  // Evenly over the logarithm; 0 < low <= high.
  double spread(std::string_view name, double low, double high, std::uint64_t index = 0) const {
    return low * power(high / low, unit(name, index));
  }
  // low … high, both of them too.
  std::size_t count(std::string_view name, std::size_t low, std::size_t high, std::uint64_t index = 0) const {
    return low + static_cast<std::size_t>(unit(name, index) * static_cast<double>(high - low + 1));
  }
  bool chance(std::string_view name, double share, std::uint64_t index = 0) const { return unit(name, index) < share; }

 private:
  std::uint64_t number_;
  Id id_{"random layout"};
};

}  // namespace shatterpave::layouts
