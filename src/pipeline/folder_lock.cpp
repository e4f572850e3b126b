#include "pipeline/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "core/error.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throw_last_error(const std::string& what, const fs::path& file) {
  throw fs::filesystem_error(what, file, std::error_code(errno, std::generic_category()));
}

enum class Attempt { taken, busy, impossible };

// A write lock on the whole file.
Attempt attempted_lock(int descriptor, Locking locking) {
  if (locking == Locking::age) return Attempt::impossible;
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  while (::fcntl(descriptor, F_OFD_SETLK, &lock) != 0) {
    if (errno == EAGAIN || errno == EACCES) return Attempt::busy;
    if (errno != EINTR) return Attempt::impossible;
  }
  return Attempt::taken;
}

// Whether the open file is the one of that name: another run may have taken it away in between.
bool is_that_file(int descriptor, const fs::path& path) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && open.st_nlink > 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

// Whoever may write into the folder may write this file too. The first attempt is for a folder like /tmp, in which a file of
// another user is not opened if it might be made.
int opened_notes(const fs::path& path, const fs::path& folder) {
  int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor >= 0 || errno != ENOENT) return descriptor;
  descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  struct stat parent {};
  if (descriptor >= 0 && ::stat(folder.c_str(), &parent) == 0) static_cast<void>(::fchmod(descriptor, parent.st_mode & 0666U));
  return descriptor;
}

// How long ago a file was changed, by the clock of the host that keeps it: `now` is a file there that this program may touch.
// None where that cannot be told.
std::chrono::seconds age_of(const fs::path& file, int now) {
  struct stat then {};
  struct stat touched {};
  if (::futimens(now, nullptr) != 0 || ::fstat(now, &touched) != 0 || ::stat(file.c_str(), &then) != 0) return {};
  return std::chrono::seconds(touched.st_mtim.tv_sec - then.st_mtim.tv_sec);
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, const Cancelled& cancelled, Locking locking)
    : folder_(folder), locking_(locking) {
  constexpr std::chrono::milliseconds longest_pause{20};
  std::chrono::milliseconds pause{1};
  const auto begin = std::chrono::steady_clock::now();
  while (!tried()) {
    if (cancelled && cancelled()) throw Interrupted();
    if (std::chrono::steady_clock::now() - begin > longest_wait) {
      throw std::runtime_error(
          fmt::format("{}: another run has been writing into it for {} seconds, and was waited for in vain", folder.string(),
                      longest_wait.count()));
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, longest_pause);
  }
}

FolderLock::~FolderLock() {
  struct stat open {};
  if (::fstat(descriptor_, &open) == 0 && open.st_size == 0) ::unlink(notes_path().c_str());
  if (by_age_) ::rmdir(held_path().c_str());
  ::close(descriptor_);
}

fs::path FolderLock::held_path() const { return folder_ / fmt::format("{}-held", notes_file); }

bool FolderLock::tried() {
  descriptor_ = opened_notes(notes_path(), folder_);
  if (descriptor_ < 0) throw_last_error("cannot write to the output folder", folder_);
  const Attempt attempt = attempted_lock(descriptor_, locking_);
  by_age_ = attempt == Attempt::impossible;
  const bool taken = by_age_ ? tried_by_age() : attempt == Attempt::taken;
  if (taken && is_that_file(descriptor_, notes_path())) return true;
  if (taken && by_age_) ::rmdir(held_path().c_str());
  ::close(descriptor_);
  return false;
}

// Making a folder fails if it exists, on any file system, also between hosts.
bool FolderLock::tried_by_age() {
  if (::mkdir(held_path().c_str(), 0777) == 0) return true;
  if (errno != EEXIST) throw_last_error("cannot write to the output folder", folder_);
  if (age_of(held_path(), descriptor_) <= stale_lock) return false;
  // Moves the folder away first: of several runs that find it old, one succeeds. Puts it back if it is a newer one by now.
  std::string old = held_path().string() + "-XXXXXX";
  if (::mkdtemp(old.data()) == nullptr) return false;
  const bool moved = ::rename(held_path().c_str(), old.c_str()) == 0;
  const bool another = moved && age_of(old, descriptor_) <= stale_lock;
  if (!another || ::rename(old.c_str(), held_path().c_str()) != 0) ::rmdir(old.c_str());
  return false;
}

std::string FolderLock::notes() const {
  std::string text;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = ::pread(descriptor_, buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_last_error("cannot read", notes_path());
    if (count == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void FolderLock::write_notes(std::string_view text) const {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::pwrite(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      throw_last_error("cannot write", notes_path());
    }
  }
  if (::ftruncate(descriptor_, static_cast<off_t>(text.size())) != 0) throw_last_error("cannot write", notes_path());
}

bool FolderLock::is_alive(const fs::path& mark) const {
  const int descriptor = ::open(mark.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return errno != ENOENT;
  const Attempt attempt = attempted_lock(descriptor, locking_);
  ::close(descriptor);
  return attempt == Attempt::busy || (attempt == Attempt::impossible && age_of(mark, descriptor_) <= stale_mark);
}

LifeMark::LifeMark(const fs::path& file, Locking locking)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)),
      touched_(std::chrono::steady_clock::now().time_since_epoch()) {
  if (descriptor_ < 0) throw_last_error("cannot write", file);
  by_age_ = attempted_lock(descriptor_, locking) == Attempt::impossible;
}

void LifeMark::touch() {
  if (!by_age_) return;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  if (now - touched_.load() < stale_mark / 60) return;
  touched_ = now;
  static_cast<void>(::futimens(descriptor_, nullptr));
}

void LifeMark::drop() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace shatterpave::pipeline
