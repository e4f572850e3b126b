// The two ways in which something can be wrong: the input, and the program.
#pragma once

#include <stdexcept>
#include <string>

namespace shatterpave {

// A place in an input file. `line` and `column` count from 1; 0 where the file has no such thing. `key` is the path of the
// value, such as `pane[0].impact[1].at_mm`.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string key;

  bool operator==(const Place&) const = default;
};

// Bad input or usage: exit status 2. `what()` is one line, `file:line:column: key: expected …, got …`, with the parts that
// are known. A room that knows no file gives the thing's name and the member's path for a key, `window.impact[1].at_mm`; who
// has the scene file puts the place there (scene/toml/key_places.h).
class InputError : public std::runtime_error {
 public:
  InputError(const Place& place, const std::string& message);
  explicit InputError(const std::string& message) : InputError(Place{}, message) {}

  const Place& place() const { return place_; }
  // `what()` without the place.
  const std::string& message() const { return message_; }

 private:
  Place place_;
  std::string message_;
};

// A promise of this program that does not hold: exit status 1. Never the user's fault.
class BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void throw_broken_invariant(const char* condition, const char* file, int line);

}  // namespace shatterpave

// Checked in every build. For what must hold if the code is right; never for input.
#define ENSURE(condition) \
  ((condition) ? static_cast<void>(0) : ::shatterpave::throw_broken_invariant(#condition, __FILE_NAME__, __LINE__))
