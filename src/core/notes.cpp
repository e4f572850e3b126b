#include "core/notes.h"

#include <algorithm>
#include <utility>

namespace shatterpave {

std::string located(const Note& note) { return located(note.place, "note: " + note.what); }

void add_note(Note note, std::vector<Note>& notes) {
  if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
}

}  // namespace shatterpave
