// Pictures of a model, by POV-Ray.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/cancel.h"
#include "core/progress.h"
#include "export/model.h"
#include "pipeline/render_options.h"
#include "pipeline/write.h"

namespace shatterpave::pipeline {

// The renderer failed, is not there, or crashed: exit status 3. what() holds its own last message.
class RendererError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What POV-Ray reads of a model.
struct PovrayStill {
  std::string name;  // of the scene
  std::vector<exporting::OutputFile> files;
};
PovrayStill povray_still(const exporting::Model& model);

struct Picture {
  Published files;       // NAME.exr, linear half float; NAME.png, sRGB of 8 bits
  std::string messages;  // the renderer's warnings, lines ended by '\n'; mostly empty
};

// Renders the still and leaves the two files in `output`, as files of the edition. POV-Ray runs in a temporary folder with
// every option that shows in a picture given, so that no user's settings do. The files hold no time.
Picture rendered(const PovrayStill& still, const RenderOptions& options, const Edition& edition,
                 const std::filesystem::path& output, const Progress& progress = {}, const Cancelled& cancelled = {});

}  // namespace shatterpave::pipeline
