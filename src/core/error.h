// The two ways in which something can be wrong: the input, and the program.
//
// InputError, and Place, are part of the public face: shatterpave/error.h. A room that knows no file gives the thing's name and
// the member's path for a key, `window.impact[1].at_mm`; who has the scene file puts the place there (scene/toml/key_places.h).
#pragma once

#include <shatterpave/error.h>

#include <stdexcept>

namespace shatterpave {

// A promise of this program that does not hold: exit status 1 (bad input: 2). Never the user's fault.
class BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void throw_broken_invariant(const char* condition, const char* file, int line);

}  // namespace shatterpave

// Checked in every build. For what must hold if the code is right; never for input.
#define ENSURE(condition) \
  ((condition) ? static_cast<void>(0) : ::shatterpave::throw_broken_invariant(#condition, __FILE_NAME__, __LINE__))
