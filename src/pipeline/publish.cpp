// Renaming is atomic for each file; for all of them together there is a journal. It is written to the workplace before the
// first file is touched, and says what to do to undo the whole; files that are to be replaced or removed are kept there. To
// remove it is what makes the publication valid. A journal that a killed run has left is followed by the next one, under the
// same lock: so there is never more than one.
#include "pipeline/publish.h"

#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <system_error>

#include "core/error.h"
#include "core/sha256.h"
#include "pipeline/write.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view journal_file = ".journal";
constexpr std::string_view kept_folder = ".kept";

struct Journal {
  std::vector<std::string> kept;   // names of files that were there, and go to the folder of those that are kept
  std::vector<std::string> fresh;  // names of files of the workplace that were not there
  std::string notes;               // on the folder, as they were
  bool above = false;              // all these are in the folder that the workplace's output folder lies in
};

bool is_there(const fs::path& file) { return fs::exists(fs::symlink_status(file)); }

// A line for each name, then a line without one, then the notes.
void write_journal(const Journal& journal, const fs::path& workplace) {
  std::string text = journal.above ? "above \n" : "";
  for (const std::string& name : journal.kept) text += fmt::format("kept {}\n", name);
  for (const std::string& name : journal.fresh) text += fmt::format("fresh {}\n", name);
  text += "\n" + journal.notes;
  const fs::path draft = workplace / fmt::format("{}-draft", journal_file);
  write_file(draft, text);
  fs::rename(draft, workplace / journal_file);
}

Journal journal_of(const fs::path& workplace) {
  std::ifstream stream(workplace / journal_file, std::ios::binary);
  Journal journal;
  for (std::string line; std::getline(stream, line) && !line.empty();) {
    const std::size_t space = line.find(' ');
    ENSURE(space != std::string::npos);
    if (line.starts_with("above ")) {
      journal.above = true;
      continue;
    }
    (line.starts_with("kept ") ? journal.kept : journal.fresh).push_back(line.substr(space + 1));
  }
  std::ostringstream rest;
  rest << stream.rdbuf();
  journal.notes = rest.str();
  if (stream.bad())
    throw fs::filesystem_error("cannot read", workplace / journal_file, std::make_error_code(std::errc::io_error));
  return journal;
}

fs::path folder_of(const Journal& journal, const FolderLock& lock) {
  return journal.above ? lock.folder().parent_path() : lock.folder();
}

// Under its name in the workplace, if there is one.
void keep(const fs::path& workplace, const std::string& name, const fs::path& target) {
  std::error_code error;
  fs::create_hard_link(target, workplace / kept_folder / name, error);
  // File systems without hard links: for a moment, there is no file of that name.
  if (error) fs::rename(target, workplace / kept_folder / name);
}

std::string sum_of_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(file, error)) ? sum_of(file) : std::string();
}

// As a message names it.
std::string description(const Edition& edition) { return fmt::format("the {} of the scene '{}'", edition.kind, edition.scene); }

void require_free(const std::vector<StagedFile>& files, const Edition& edition, const FolderNotes& notes,
                  const fs::path& output) {
  for (const StagedFile& file : files) {
    const fs::path target = output / file.name;
    if (fs::is_directory(fs::symlink_status(target))) {
      throw InputError(Place{target.string(), 0, 0, ""}, "expected a file to write, got a folder");
    }
    const NotedSet* const owner = owner_of(notes, edition, file.name, file.sum);
    if (owner == nullptr || !is_there(target)) continue;
    throw InputError(
        Place{target.string(), 0, 0, ""},
        fmt::format("expected no file of that name or one of {}, got one of {} (write into another folder, give what the "
                    "file is named after another name, or remove the file)",
                    description(edition), description(owner->edition)));
  }
}

FolderNotes notes_on(const FolderLock& lock, const fs::path& output) {
  return notes_of_text(lock.notes(), (output / notes_file).string());
}

// Moves and removes what the journal says.
void carry_out(const Journal& journal, const std::vector<StagedFile>& files, const std::vector<std::string>& removed,
               const fs::path& workplace, const fs::path& folder) {
  for (const std::string& name : journal.kept) keep(workplace, name, folder / name);
  for (const StagedFile& file : files) fs::rename(workplace / file.name, folder / file.name);
  for (const std::string& name : removed) fs::remove(folder / name);
}

// Does `publish`, which does what the journal says.
void all_or_none(const Journal& journal, Workplace& workplace, const FolderLock& lock, const std::function<void()>& publish) {
  const fs::path& place = workplace.folder();
  fs::create_directory(place / kept_folder);
  write_journal(journal, place);
  try {
    publish();
    fs::remove(place / journal_file);
  } catch (...) {
    try {
      take_back(place, lock);
    } catch (...) {
      workplace.leave();
    }
    throw;
  }
}

}  // namespace

void require_publishable(const std::vector<StagedFile>& files, const Edition& edition, const Workplace& workplace,
                         const fs::path& output, const Cancelled& cancelled) {
  const FolderLock lock(workplace.output(), cancelled);
  require_free(files, edition, notes_on(lock, output), output);
}

Published published(Workplace& workplace, const std::vector<StagedFile>& files, const Edition& edition, const fs::path& output,
                    const Cancelled& cancelled) {
  const FolderLock lock(workplace.output(), cancelled);
  clear_killed(lock);
  const fs::path& folder = lock.folder();
  const FolderNotes notes = notes_on(lock, output);
  require_free(files, edition, notes, output);

  Published result;
  Journal journal;
  journal.notes = lock.notes();
  FileSums sums;
  for (const StagedFile& file : files) {
    ENSURE(!file.sum.empty());
    sums.emplace(file.name, file.sum);
    (is_there(folder / file.name) ? journal.kept : journal.fresh).push_back(file.name);
    result.paths.push_back(output / file.name);
  }
  for (const auto& [name, sum] : outdated(notes, edition, sums)) {
    if (!is_there(folder / name)) continue;
    const bool unchanged = sum_of_file(folder / name) == sum;
    (unchanged ? result.removed : result.left).push_back(name);
    if (unchanged) journal.kept.push_back(name);
  }

  const auto publish = [&] {
    carry_out(journal, files, result.removed, workplace.folder(), folder);
    lock.write_notes(text_of_notes(with_files(notes, edition, sums)));
  };
  all_or_none(journal, workplace, lock, publish);
  workplace.keep();
  return result;
}

void publish_above(Workplace& workplace, const std::vector<StagedFile>& files, const Cancelled& cancelled) {
  const FolderLock lock(workplace.output(), cancelled);
  clear_killed(lock);
  Journal journal;
  journal.above = true;
  journal.notes = lock.notes();
  const fs::path folder = folder_of(journal, lock);
  for (const StagedFile& file : files) {
    (is_there(folder / file.name) ? journal.kept : journal.fresh).push_back(file.name);
  }
  all_or_none(journal, workplace, lock, [&] { carry_out(journal, files, {}, workplace.folder(), folder); });
  // The next frame's are others.
  fs::remove_all(workplace.folder() / kept_folder);
  workplace.keep();
}

// This may be killed in turn, and is then done again.
void take_back(const fs::path& workplace, const FolderLock& lock) {
  if (!is_there(workplace / journal_file)) return;
  const Journal journal = journal_of(workplace);
  for (const std::string& name : journal.kept) {
    const fs::path kept = workplace / kept_folder / name;
    if (is_there(kept)) fs::rename(kept, folder_of(journal, lock) / name);
  }
  for (const std::string& name : journal.fresh) {
    if (!is_there(workplace / name)) fs::remove(folder_of(journal, lock) / name);
  }
  lock.write_notes(journal.notes);
  fs::remove(workplace / journal_file);
}

}  // namespace shatterpave::pipeline
