// What the reader of an input should be told although nothing is wrong enough to refuse it: Note, of shatterpave/error.h.
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace shatterpave {

// `message` after the parts of its place that are known: `file:line:column: key: message`.
std::string located(const Place& place, const std::string& message);

// One line, `file:line:column: key: note: …`, with the parts that are known.
std::string located(const Note& note);

// Adds the note if the same is not there yet.
void add_note(Note note, std::vector<Note>& notes);

}  // namespace shatterpave
