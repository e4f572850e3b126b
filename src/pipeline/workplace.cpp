// Workplaces are made and judged under the lock of the output folder: so one without a mark of life is not one whose mark is
// about to come.
#include "pipeline/workplace.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "core/error.h"
#include "pipeline/publish.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view workplace_prefix = ".shatterpave-";
constexpr std::size_t drawn_letters = 6;  // of mkdtemp
constexpr std::string_view mark_file = ".alive";

// The missing folders on the way to `folder`, the outermost first.
std::vector<fs::path> missing_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path p = folder; !p.empty() && !fs::exists(p); p = p.parent_path()) {
    missing.push_back(p);
    if (p == p.parent_path()) break;
  }
  std::ranges::reverse(missing);
  return missing;
}

bool is_workplace(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return name.starts_with(workplace_prefix) && name.size() == workplace_prefix.size() + drawn_letters &&
         fs::is_directory(entry.symlink_status());
}

// Not for the user to mend by another folder name.
bool is_of_the_machine(const std::error_code& error) {
  return error == std::errc::no_space_on_device || error == std::errc::io_error || error == std::errc::too_many_files_open ||
         error == std::errc::too_many_files_open_in_system || error == std::errc::not_enough_memory ||
         error == std::error_code(EDQUOT, std::generic_category());
}

void clear_killed_in(const fs::path& shot) {
  try {
    clear_killed(FolderLock(shot));
  } catch (const fs::filesystem_error& error) {
    if (error.code() != std::errc::no_such_file_or_directory) throw;
  }
}

// Another run may be clearing the same.
void remove_folder(const fs::path& folder) {
  constexpr int attempts = 3;
  std::error_code ignored;
  for (int i = 0; i < attempts && fs::exists(fs::symlink_status(folder, ignored)); ++i) fs::remove_all(folder, ignored);
}

}  // namespace

void require_output_folder(const fs::path& folder) {
  if (folder.empty()) throw InputError("expected an output folder, got an empty name");
  for (fs::path p = folder; !p.empty(); p = p.parent_path()) {
    std::error_code error;
    const fs::file_status status = fs::status(p, error);
    if (fs::exists(status)) {
      if (fs::is_directory(status)) return;
      throw InputError(Place{folder.string(), 0, 0, ""}, fmt::format("expected an output folder, got a file: {}", p.string()));
    }
    if (fs::is_symlink(fs::symlink_status(p, error))) {
      throw InputError(Place{folder.string(), 0, 0, ""},
                       fmt::format("expected an output folder, got a link to nothing: {}", p.string()));
    }
    if (p == p.parent_path()) return;
  }
}

Workplace::Workplace(const fs::path& output, const Cancelled& cancelled, const Admission& admission)
    : output_(fs::weakly_canonical(fs::absolute(output))) {
  constexpr int attempts = 100;
  try {
    for (int attempt = 1; !mark_; ++attempt) {
      try {
        for (const fs::path& p : missing_folders(output_)) {
          if (fs::create_directory(p)) made_.push_back(p);
        }
        const FolderLock lock(output_, cancelled);
        clear_killed(lock);
        std::string pattern = (output_ / fmt::format("{}{:X>{}}", workplace_prefix, "", drawn_letters)).string();
        if (::mkdtemp(pattern.data()) == nullptr) {
          throw fs::filesystem_error("cannot write to the output folder", output,
                                     std::error_code(errno, std::generic_category()));
        }
        temporary_ = pattern;
        mark_.emplace(temporary_ / mark_file);
        if (admission) admission(lock, temporary_);
      } catch (const fs::filesystem_error& error) {
        // Another run that had made the folder has taken it away again.
        if (error.code() == std::errc::no_such_file_or_directory && attempt < attempts) continue;
        if (is_of_the_machine(error.code())) throw;
        throw InputError(Place{output.string(), 0, 0, ""},
                         fmt::format("expected an output folder that can be written to, got: {}", error.code().message()));
      }
    }
  } catch (...) {
    take_away();
    throw;
  }
}

Workplace::~Workplace() { take_away(); }

void Workplace::take_away() {
  if (mark_) mark_->drop();  // first, since over NFS an open file cannot be removed
  if (!temporary_.empty()) remove_folder(temporary_);
  std::error_code ignored;
  // Only if empty: someone else may have put files there.
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
}

std::vector<fs::path> living_workplaces(const FolderLock& lock, const fs::path& own) {
  std::vector<fs::path> living;
  for (const fs::directory_entry& entry : fs::directory_iterator(lock.folder())) {
    if (is_workplace(entry) && entry.path() != own && lock.is_alive(entry.path() / mark_file)) living.push_back(entry.path());
  }
  return living;
}

void clear_killed(const FolderLock& lock) {
  std::vector<fs::path> dead;
  std::vector<fs::path> shots;
  for (const fs::directory_entry& entry : fs::directory_iterator(lock.folder())) {
    if (is_workplace(entry) && !lock.is_alive(entry.path() / mark_file)) dead.push_back(entry.path());
    if (entry.path().filename().string().starts_with(shot_folder_prefix)) shots.push_back(entry.path());
  }
  for (const fs::path& workplace : dead) {
    take_back(workplace, lock);
    remove_folder(workplace);
  }
  for (const fs::path& shot : shots) {
    // One that ends takes its folder away, perhaps at this moment.
    if (std::error_code error; fs::is_directory(shot, error)) clear_killed_in(shot);
  }
}

}  // namespace shatterpave::pipeline
