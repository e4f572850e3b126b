// Several runs, on several hosts, that write into one folder: what only one of them may do at a time, and which of them live.
//
// Both rest on locks on files ("open file description locks" of fcntl), which the kernel drops with the program that holds
// them, however it ends, also over NFS. So no lock is left by a killed run, and no process id, which another host could not
// judge, is needed. Where a file system has no such locks, age takes their place: a run that lives touches its files.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/cancel.h"

namespace shatterpave::pipeline {

// The file in an output folder that is locked, and that holds the notes on it (pipeline/folder_notes.h). Hidden.
inline constexpr std::string_view notes_file = ".scenes.shatterpave";

enum class Locking {
  kernel,  // by locks of the kernel, by age where there are none
  age      // by age in any case
};

// Another run that holds the lock for longer is given up on: no publication takes as long.
inline constexpr std::chrono::seconds longest_wait{120};
// If only age tells: a folder's lock that is older, and a mark not touched for longer, were left by a killed run.
inline constexpr std::chrono::seconds stale_lock{60};
inline constexpr std::chrono::seconds stale_mark{3600};

// The lock of a folder. It is held for moments only: while files are moved, never while they are made.
class FolderLock {
 public:
  // Waits for it. Throws Interrupted if `cancelled` says so meanwhile, std::runtime_error after `longest_wait`, and
  // std::filesystem::filesystem_error where the folder cannot be written to.
  explicit FolderLock(const std::filesystem::path& folder, const Cancelled& cancelled = {}, Locking locking = Locking::kernel);
  // If the notes are empty, no file is left.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  // The text of the notes; empty where there are none.
  std::string notes() const;
  void write_notes(std::string_view text) const;
  // Whether the maker of a LifeMark in the folder lives. A mark that is missing says that nobody does; one that cannot be read,
  // that somebody may.
  bool is_alive(const std::filesystem::path& mark) const;

 private:
  bool tried();
  bool tried_by_age();
  std::filesystem::path notes_path() const { return folder_ / notes_file; }
  std::filesystem::path held_path() const;

  std::filesystem::path folder_;
  Locking locking_;
  int descriptor_ = -1;
  bool by_age_ = false;
};

// A file that shows, while this object lives, that its maker is alive.
class LifeMark {
 public:
  explicit LifeMark(const std::filesystem::path& file, Locking locking = Locking::kernel);
  ~LifeMark() { drop(); }
  LifeMark(const LifeMark&) = delete;
  LifeMark& operator=(const LifeMark&) = delete;

  // To be called often: keeps the file's age low where only that tells. On any thread.
  void touch();
  void drop();

 private:
  int descriptor_ = -1;
  bool by_age_ = false;
  std::atomic<std::chrono::steady_clock::duration> touched_;  // when, since the clock's start
};

}  // namespace shatterpave::pipeline
