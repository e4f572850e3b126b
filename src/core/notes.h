// Notes (shatterpave/error.h): what the author of an input should be told although the input is accepted.
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace shatterpave {

// `message` after the parts of its place that are known: `file:line:column: key: message`.
std::string located(const Place& place, const std::string& message);

// One line, `file:line:column: key: note: …`, with the parts that are known.
std::string located(const Note& note);

// Adds the note unless an equal one is there already.
void add_note(Note note, std::vector<Note>& notes);

}  // namespace shatterpave
