// The notes on an output folder: which files in it belong together. docs/output.md tells users what follows from them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shatterpave::pipeline {

// What a run makes of a scene: files that belong together, all of one state of it.
struct Edition {
  std::string scene;        // its name
  std::string kind;         // what was made of it: "export", "picture", "measures"
  std::string fingerprint;  // equal where all that the files follow from is: files of equal ones may stand side by side

  bool operator==(const Edition&) const = default;
};

// Sums (SHA-256) by the name of the file.
using FileSums = std::map<std::string, std::string>;

struct NotedSet {
  Edition edition;
  FileSums files;

  bool operator==(const NotedSet&) const = default;
};

// At most one set of a scene and kind.
using FolderNotes = std::vector<NotedSet>;

// Throws InputError, at the file that `place` names, if the text holds no notes of this form. An empty text holds none.
FolderNotes notes_of_text(std::string_view text, const std::string& place);
// JSON, a file a line, sorted: the same for the same notes.
std::string text_of_notes(const FolderNotes& notes);

// The set of the edition's scene and kind, or null.
const NotedSet* set_of(const FolderNotes& notes, const Edition& edition);
// The set of another scene or kind that has a file of that name and another sum, or null. An empty sum differs from all others.
const NotedSet* owner_of(const FolderNotes& notes, const Edition& edition, const std::string& name, const std::string& sum);
// Files of an earlier state of the edition that are in no other set nor in `files`, with their sums.
FileSums outdated(const FolderNotes& notes, const Edition& edition, const FileSums& files);
// The notes once `files` are there: beside those of the same edition, in place of those of an earlier state.
FolderNotes with_files(const FolderNotes& notes, const Edition& edition, const FileSums& files);

}  // namespace shatterpave::pipeline
