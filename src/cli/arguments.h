// The command line, as values.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/measure.h"
#include "pipeline/render.h"
#include "scene/override.h"

namespace shatterpave::cli {

enum class Target { povray, json, svg, textures, obj };

struct Export {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::filesystem::path output;
  std::vector<Target> targets;  // each once, in the order of the enumeration
  int threads = 0;              // 0: all processors
};

struct Check {
  std::filesystem::path scene;
  std::vector<scene::Override> overrides;
  std::vector<Target> targets;  // as those of an export: what they would refuse is refused
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
