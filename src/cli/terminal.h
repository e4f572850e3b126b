// The one stream to the terminal: what the command says, its progress, and signals that end it.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/progress_form.h"
#include "cli/progress_report.h"
#include "core/notes.h"
#include "core/parallel.h"
#include "core/progress.h"

namespace shatterpave::cli {

// To standard output; throws std::system_error where it cannot.
void print(std::string_view text);
// A line for each path, to standard output.
void print_paths(const std::vector<std::filesystem::path>& paths);
// To standard error, as far as that works.
void tell(std::string_view text);
// A line for each note, to standard error; of many the first ones and how many more there are.
void tell(const std::vector<Note>& notes);

// Whether that form is a bar here.
bool draws_bar(ProgressForm form);

// A bar on a terminal, which is taken away when it dies; elsewhere a line from time to time (progress_report.h).
class ProgressBar {
 public:
  // In place of a bar, none of it where the form says so; without a terminal `lines` and `automatic` are the same.
  explicit ProgressBar(ProgressForm form = ProgressForm::automatic);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Valid while the bar lives.
  Progress progress();

 private:
  void show(std::string_view what, double part);

  bool terminal_;
  bool silent_;
  bool shown_ = false;
  ProgressReport report_;
  std::optional<Heartbeat> heartbeat_;  // long work may have nothing to say for minutes
};

// While it lives, signals that end the program only leave a note, so that what is being written can be taken back.
class SignalNotes {
 public:
  SignalNotes();
  static bool received();
};

// Ends as the signal that was noted would have ended it, so that a shell sees what happened.
int end_by_signal();

}  // namespace shatterpave::cli
