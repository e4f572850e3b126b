// The two kinds of failure: wrong input, and a fault of the program.
//
// InputError and Place are in the public header shatterpave/error.h. A room that knows no file gives the thing's name and the
// member's path as the key, `window.impact[1].at_mm`; code that has the scene file adds the place (pipeline/placed.h).
#pragma once

#include <shatterpave/error.h>

#include <stdexcept>

namespace shatterpave {

// Thrown where a promise of this program does not hold: its own fault, never the user's. Exit status 1 (bad input: 2).
class BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void throw_broken_invariant(const char* condition, const char* file, int line);

}  // namespace shatterpave

// Checks, in every build, a condition that holds if the code is right. Never for input.
#define ENSURE(condition) \
  ((condition) ? static_cast<void>(0) : ::shatterpave::throw_broken_invariant(#condition, __FILE_NAME__, __LINE__))
