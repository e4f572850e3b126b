// Frames of a shot as files for other programs.
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "core/cancel.h"
#include "core/progress.h"
#include "export/model.h"
#include "pipeline/publish.h"
#include "scene/shot.h"

namespace shatterpave::pipeline {

// What all targets that are asked for make of a model.
using MakeOutputs = std::function<exporting::Outputs(const exporting::Model& model)>;

// What was made of the frames, as one edition of the shot.
Edition frames_edition(const scene::Scene& still);

// Makes the files of each frame and leaves those of all in `output`: all or none. Files that are named after the scene begin
// with NAME.####; of those that are named after a pane or pavement, such as its include, its images and its textures, there is
// one for all frames where it stays as it is, else one for each, WINDOW.####. What does not change is generated once.
Published exported_frames(scene::Shot& shot, std::span<const int> frames, const MakeOutputs& make,
                          const std::filesystem::path& output, const Progress& progress = {}, const Cancelled& cancelled = {});

}  // namespace shatterpave::pipeline
