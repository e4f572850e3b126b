// What the command says of the files that it has written, and whose they are.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/publish.h"
#include "scene/scene.h"

namespace shatterpave::cli {

// What this version of the program makes of the scene.
pipeline::Edition edition_of(const scene::Scene& scene, const std::string& kind);

// A line for each file that was written, to standard output; and one to standard error where files of an earlier state of the
// scene were removed or left.
void report(const pipeline::Published& published, const pipeline::Edition& edition, const std::filesystem::path& output);

}  // namespace shatterpave::cli
