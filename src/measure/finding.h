// A measured figure, held against the range in which it is wanted.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace shatterpave::measure {

// A range without a limit on one side ends here.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

enum class Verdict {
  holds,
  fails,
  open,  // nothing was measured, or the standard error is more than half of the tolerance
};

// One figure and the range in which it is wanted.
struct Finding {
  std::string_view id;        // fixed: scripts may look for it
  std::string_view quantity;  // what it is, in words
  std::string_view unit;      // "mm", "°", "%", or empty
  double low = -unlimited;
  double high = unlimited;
  double figure = 0.0;
  double error = 0.0;        // standard error; 0 where it is not told
  std::size_t count = 0;     // of what the figure was made
  std::string_view counted;  // what they are: "panes", "turns" …
  Verdict verdict = Verdict::open;

  bool operator==(const Finding&) const = default;
};

// The finding with its verdict.
Finding judged(Finding finding);

// The finding with that id, which must be one of them.
const Finding& finding_of(std::span<const Finding> findings, std::string_view id);

}  // namespace shatterpave::measure
