// A draft picture of a scene, by this program's own command `render`, run beside it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/cancel.h"
#include "scene/override.h"

namespace shatterpave::serve {

struct DraftJob {
  std::filesystem::path program;  // that renders
  std::filesystem::path scene;
  std::vector<scene::Override> changes;
  int width = 640;  // px
  int height = 480;
};

// The picture as PNG. The renderer writes into a folder below the user's own folder for temporary files, which is taken away
// again; what an earlier run that was killed has left there is cleared.
//   progress  called with the part that is done, in [0, 1]
// Throws InputError or std::runtime_error with the command's own message where it fails, Interrupted where `cancelled` says so.
std::string draft_picture(const DraftJob& job, const std::function<void(double part)>& progress, const Cancelled& cancelled);

// The folder for temporary files of this user alone. Throws InputError where there is something else of its name.
std::filesystem::path own_temporary_folder();

// Clears what runs that were killed have left there.
void clear_temporary_folder();

}  // namespace shatterpave::serve
