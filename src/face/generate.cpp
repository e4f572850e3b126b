#include <shatterpave/generate.h>

#include <optional>
#include <utility>
#include <vector>

#include "face/model_access.h"
#include "face/scene_access.h"
#include "face/work.h"
#include "pipeline/environment.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"

namespace shatterpave {

Model generate(const Scene& scene, const WorkOptions& options) {
  std::optional<Model> made;
  face::work_with(options, [&](const Progress& progress, const Cancelled& /*cancelled*/) {
    const std::shared_ptr<const scene::Scene> read = SceneAccess::read(scene);
    pipeline::require_environment(*read);
    exporting::Model model = pipeline::generated(*read, progress);
    std::vector<Note> notes = pipeline::emptiness(*read, model);
    made = ModelAccess::made(std::move(model), std::move(notes));
  });
  return *std::move(made);
}

}  // namespace shatterpave
