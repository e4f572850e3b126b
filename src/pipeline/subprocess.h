// Another program, run without a shell.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cancel.h"

namespace shatterpave::pipeline {

struct Subprocess {
  std::vector<std::string> arguments;    // the program first; it is sought in PATH
  std::filesystem::path folder;          // its current folder
  std::vector<std::string> environment;  // NAME=VALUE, set beside what this program has
  std::vector<std::string> without;      // names of variables that it does not get
};

// How a program ended.
struct Ending {
  bool found = true;  // false: there is no such program
  int status = 0;     // of exit
  int signal = 0;     // that ended it, or 0
  // Of the program and of those that it has waited for: time on processors, and the most memory that one of them had.
  double processor_seconds = 0.0;
  std::int64_t most_memory_kib = 0;
};

// Runs the program to its end. `output` is called with what it writes to either stream, piece by piece. If `cancelled` says so,
// the program and those that it has started are ended (SIGTERM, a moment later SIGKILL) and Interrupted thrown.
Ending run(const Subprocess& subprocess, const std::function<void(std::string_view)>& output, const Cancelled& cancelled);

}  // namespace shatterpave::pipeline
