/// \file
/// What can be wrong with an input, and what is worth telling although nothing is wrong.
///
/// Every function of the library that fails throws, and leaves its arguments as they were:
///
/// - InputError where a scene, a key, a value or the name of a file is wrong: for the user to correct;
/// - Interrupted where work was asked to stop;
/// - std::filesystem::filesystem_error where a folder cannot be written to;
/// - other std::exception, such as std::bad_alloc, or std::logic_error for a fault of the library itself.
///
/// The library prints nothing and never ends the program.
///
///     try {
///       const shatterpave::Model model = shatterpave::generate(shatterpave::Scene::from_file("yard.toml"));
///     } catch (const shatterpave::InputError& error) {
///       std::cerr << error.what() << '\n';  // "yard.toml:14:12: pavement[0].joint_mm: expected …, got 4000"
///       highlight(error.place().line, error.place().column);
///     }
#pragma once

#include <stdexcept>
#include <string>

namespace shatterpave {

/// A place in an input.
struct Place {
  std::string file;  ///< A file, or the call that gave the value: `set("pane.window.thickness_mm")`. Empty if neither is known.
  int line = 0;      ///< From 1; 0 where the input has no lines.
  int column = 0;    ///< From 1, in characters, not bytes; 0 where the input has no lines.
  std::string key;   ///< Path of the value, such as `pane[0].impact[1].at_mm`; empty where it is not about one.

  /// Member by member.
  bool operator==(const Place&) const = default;
};

/// Bad input or usage. `what()` is one line, `file:line:column: key: expected …, got …`, with the parts that are known.
class InputError : public std::runtime_error {
 public:
  /// What is wrong at a place, in a line: "expected …, got …".
  InputError(const Place& place, const std::string& message);
  /// The same where no place is known.
  explicit InputError(const std::string& message) : InputError(Place{}, message) {}

  /// Where it is wrong.
  const Place& place() const { return place_; }
  /// `what()` without the place.
  const std::string& message() const { return message_; }

 private:
  Place place_;
  std::string message_;
};

/// Thrown where work stopped because it was asked to. Whatever it had written is gone.
class Interrupted : public std::runtime_error {
 public:
  /// `what()` is "interrupted".
  Interrupted() : std::runtime_error("interrupted") {}
};

/// What the author of an input should be told although nothing is wrong enough to refuse it: a key without effect, a pavement
/// in which no stone fits.
struct Note {
  Place place;       ///< What it is about.
  std::string what;  ///< A sentence in lower case, without a full stop.

  /// Member by member.
  bool operator==(const Note&) const = default;
};

}  // namespace shatterpave
