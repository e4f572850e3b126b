// What the reader of an input should be told although nothing is wrong enough to refuse it.
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace shatterpave {

// `what` is a sentence without a full stop, in lower case, about what stands at `place`.
struct Note {
  Place place;
  std::string what;

  bool operator==(const Note&) const = default;
};

// One line, `file:line:column: key: note: …`, with the parts that are known.
std::string located(const Note& note);

// Adds the note if the same is not there yet.
void add_note(Note note, std::vector<Note>& notes);

}  // namespace shatterpave
