// The command line, as values.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "export/target.h"
#include "pipeline/measure.h"
#include "pipeline/render.h"
#include "scene/override.h"

namespace shatterpave::cli {

// Each once, in the order of their table.
using Targets = std::vector<const exporting::Target*>;

struct Export {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  Targets targets;
  int threads = 0;  // 0: all processors
};

struct Check {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  Targets targets;  // what they would refuse is refused
};

struct Render {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  pipeline::RenderOptions options;
};

struct Measure {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  pipeline::MeasureOptions options;
  int threads = 0;  // 0: all processors
};

// Only a text is asked for: help, version, or the keys of scene files.
struct Show {
  std::string text;
};

using Command = std::variant<Export, Check, Render, Measure, Show>;

// Throws InputError, with a message of one line, where the usage is wrong.
Command command_of(int argc, const char* const* argv);

}  // namespace shatterpave::cli
