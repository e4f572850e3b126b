// Another program, run without a shell.
#pragma once

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
};

// Runs the program to its end. `output` is called with what it writes to either stream, piece by piece. If `cancelled` says so,
// the program and those that it has started are ended (SIGTERM, a moment later SIGKILL) and Interrupted thrown.
Ending run(const Subprocess& subprocess, const std::function<void(std::string_view)>& output, const Cancelled& cancelled);

}  // namespace shatterpave::pipeline
