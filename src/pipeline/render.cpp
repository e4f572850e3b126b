#include "pipeline/render.h"

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "export/povray/povray.h"
#include "pipeline/povray_run.h"
#include "pipeline/write.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

PovrayStill povray_still(const exporting::Model& model) {
  PovrayStill still{model.name, exporting::povray::povray_files(model)};
  const auto is_still = [&](const exporting::OutputFile& file) { return file.name == model.name + ".pov"; };
  const auto found = std::ranges::find_if(still.files, is_still);
  ENSURE(found != still.files.end());
  found->name = still_file;
  return still;
}

Picture rendered(const PovrayStill& still, const RenderOptions& options, const Edition& edition, const fs::path& output,
                 const Progress& progress, const Cancelled& cancelled) {
  require_output_folder(output);
  Workplace workplace(output, cancelled);
  const fs::path& folder = workplace.folder();
  require_publishable(picture_files(still.name), edition, workplace, output, cancelled);
  const auto asked = [&] {
    workplace.touch();
    return cancelled && cancelled();
  };
  std::optional<CancelScope> scope(asked);
  for (const exporting::OutputFile& file : still.files) write_file(folder / file.name, file.content);

  const PovrayRun run = run_povray(folder, options, "", progress, asked);
  const std::vector<StagedFile> files = staged_picture(folder, still.name);
  stop_if_cancelled();
  scope.reset();
  return {published(workplace, files, edition, output, cancelled), run.messages};
}

}  // namespace shatterpave::pipeline
