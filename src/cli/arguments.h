// The command line, as values.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/progress_form.h"
#include "export/target.h"
#include "pipeline/measure.h"
#include "pipeline/render.h"
#include "scene/override.h"
#include "trace/trace.h"

namespace shatterpave::cli {

// Each once, in the order of their table.
using Targets = std::vector<const exporting::Target*>;

struct Export {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  Targets targets;
  std::optional<std::vector<int>> frames{};  // none: the scene as it is without its keys
  int threads = 0;                           // 0: all processors
  std::optional<double> sheet_scale{};       // of a sheet beside the drawings: 1 to this
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
  std::optional<std::vector<int>> frames{};  // none: the still
  bool skip_existing = false;
  ProgressForm progress = ProgressForm::automatic;
};

// Job files for a render farm.
struct Farm {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  pipeline::RenderOptions options;
  std::optional<std::vector<int>> frames{};  // none: all of the scene's range
  std::size_t system = 0;                    // index in pipeline::farm_systems
  std::optional<int> chunk{};                // frames of a task; none: by what a frame takes
};

struct Measure {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  pipeline::MeasureOptions options;
  int threads = 0;  // 0: all processors
};

struct Trace {
  std::vector<std::filesystem::path> photographs;  // one or more
  std::filesystem::path output;
  trace::Options options;
  std::string words;  // all that the options say, as it was written
  int threads = 0;    // 0: all processors
};

struct Fit {
  std::vector<std::filesystem::path> traces;  // one or more
  std::filesystem::path output;               // the scene file
  int threads = 0;                            // 0: all processors
};

// The live view.
struct Serve {
  std::filesystem::path scene;
  int port = 0;  // 0: any that is free
};

// Only a text is asked for: help, version, or the keys of scene files.
struct Show {
  std::string text;
};

using Command = std::variant<Export, Check, Render, Farm, Measure, Trace, Fit, Serve, Show>;

// Throws InputError, with a message of one line, where the usage is wrong.
Command command_of(int argc, const char* const* argv);

}  // namespace shatterpave::cli
