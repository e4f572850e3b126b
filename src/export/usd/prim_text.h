// The text of OpenUSD's layers (.usda), as far as it does not know what it speaks of: prims in one another, attributes,
// numbers.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace shatterpave::exporting::usd {

using Buffer = fmt::memory_buffer;

// Lengths are metres in whole parts of this: a tenth of a µm, which is all that a `float` of a metre holds. What lies on the
// lattice of 1 µm is exact.
inline constexpr double parts_of_m = 1e7;
// Places in textures, metres.
inline constexpr double parts_of_uv = 1e6;
// Parts of unit vectors, 0.006°, and of colours.
inline constexpr double parts_of_one = 1e4;
// Parts of quaternions: what a `float` holds of them.
inline constexpr double parts_of_turn = 1e7;

std::int64_t in_parts(double value, double parts);
// The shortest number that reads back.
void put_number(Buffer& out, double value);
void put_in_parts(Buffer& out, std::int64_t value, double parts);

// "(x, y, z)"
std::string vector_text(vec3 value, double parts);

// A string in quotes.
std::string in_usd_quotes(std::string_view text);
// `@file@`, a file beside the layer.
std::string asset(std::string_view file);

// The name as an identifier: letters, digits and '_', the first no digit.
std::string identifier(std::string_view name);

// Prims and their properties, indented by what they stand in.
class PrimText {
 public:
  // In `depth` prims, which others have begun.
  PrimText(Buffer& out, std::size_t depth) : out_(out), depth_(depth) {}

  // "def Mesh" "name" and, in parentheses, what is said of the prim.
  void begin(std::string_view what, std::string_view name, const std::vector<std::string>& metadata = {});
  void end();

  template <typename... Parts>
  void line(fmt::format_string<Parts...> format, Parts&&... parts) {
    indent();
    fmt::format_to(std::back_inserter(out_), format, std::forward<Parts>(parts)...);
    out_.push_back('\n');
  }

  // TYPE NAME = [a, b, …], with what is said of it; `put` writes the element with that number.
  template <typename Put>
  void list(std::string_view declaration, std::size_t count, const Put& put, std::string_view metadata = {}) {
    indent();
    fmt::format_to(std::back_inserter(out_), "{} = [", declaration);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) separate();
      put(out_, i);
    }
    out_.push_back(']');
    if (!metadata.empty()) fmt::format_to(std::back_inserter(out_), " ({})", metadata);
    out_.push_back('\n');
  }
  void list(std::string_view declaration, const std::vector<std::uint32_t>& numbers);

 private:
  void indent();
  void separate();

  Buffer& out_;
  std::size_t depth_;
};

}  // namespace shatterpave::exporting::usd
