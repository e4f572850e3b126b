// What the command line may say, for CLI11: commands and options with their sentences, which `--help` and the manual tell.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string_view>
#include <vector>

#include "cli/usage.h"

namespace shatterpave::cli {

inline constexpr std::size_t most_files = 1000;  // of commands that take several
inline constexpr int default_port = 8467;        // of `serve`: one that IANA has given to nobody

// All options as they were written. CLI11 only splits the words; their values are read here, so that messages are our own.
struct Requests {
  Texts scenes;
  Texts sets;
  Texts seeds;
  Texts outputs;
  Texts targets;
  Texts threads;
  Texts qualities;
  Texts sizes;
  Texts sheet_scales;
  Texts seed_counts;
  Texts radials;
  Texts files;  // of commands that take several
  Texts pane_sizes;
  Texts corners;
  Texts scales;
  Texts impacts;
  Texts thresholds;
  Texts polarities;
  Texts chains;
  Texts frames;
  Texts progress;
  Texts systems;
  Texts chunks;
  Texts ports;
  bool skip_existing = false;
  bool both_laws = false;
  bool keys_as_json = false;
  bool keys_as_markdown = false;
  Texts manual_forms;
};

// The names of all targets, in the order of their table.
std::vector<std::string_view> target_names();

// Adds all commands with their options, which fill the requests when the application parses: these must live as long.
void add_commands(CLI::App& app, Requests& requests);

}  // namespace shatterpave::cli
