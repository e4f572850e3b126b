#include "cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <system_error>

namespace shatterpave::cli {

namespace {

// Read by any thread.
std::atomic<int> signal_received{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) { signal_received = signal; }

bool written(std::FILE* stream, std::string_view text) {
  return std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
}

}  // namespace

void print(std::string_view text) {
  if (!written(stdout, text)) throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
}

void print_paths(const std::vector<std::filesystem::path>& paths) {
  std::string lines;
  for (const std::filesystem::path& path : paths) lines += path.string() + "\n";
  print(lines);
}

void tell(std::string_view text) { static_cast<void>(written(stderr, text)); }

void tell(const std::vector<Note>& notes) {
  constexpr std::size_t most_lines = 20;
  std::string lines;
  for (std::size_t i = 0; i < std::min(notes.size(), most_lines); ++i) lines += located(notes[i]) + "\n";
  if (notes.size() > most_lines) lines += fmt::format("note: and {} more of the kind\n", notes.size() - most_lines);
  if (!lines.empty()) tell(lines);
}

bool draws_bar(ProgressForm form) {
  return (form == ProgressForm::bar || form == ProgressForm::automatic) && ::isatty(STDERR_FILENO) == 1;
}

ProgressBar::ProgressBar(ProgressForm form)
    : terminal_(draws_bar(form)),
      silent_(form == ProgressForm::none),
      report_([] { return std::chrono::steady_clock::now(); }, [](const std::string& line) { tell(line); }) {
  if (!terminal_ && !silent_) heartbeat_.emplace(std::chrono::seconds(1), [this] { report_.tick(); });
}

ProgressBar::~ProgressBar() {
  if (shown_) tell("\r\x1b[K");
}

void ProgressBar::show(std::string_view what, double part) {
  if (silent_) return;
  if (!terminal_) {
    report_.take(what, part);
    return;
  }
  constexpr int width = 30;
  const int full = static_cast<int>(part * width);
  tell(fmt::format("\r\x1b[K[{:#>{}}{:.>{}}] {:3.0f}% {}", "", full, "", width - full, 100.0 * part, what));
  shown_ = true;
}

Progress ProgressBar::progress() {
  return [this](std::string_view what, double part) { show(what, part); };
}

SignalNotes::SignalNotes() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // A signal that is ignored, as under nohup, stays ignored.
    if (std::signal(signal, note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

bool SignalNotes::received() { return signal_received != 0; }

int end_by_signal() {
  std::signal(signal_received, SIG_DFL);
  std::raise(signal_received);
  return 128 + signal_received;
}

}  // namespace shatterpave::cli
