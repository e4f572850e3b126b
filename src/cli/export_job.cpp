#include "cli/export_job.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/report.h"
#include "cli/terminal.h"
#include "core/notes.h"
#include "core/parallel.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace shatterpave::cli {

void require_for_targets(const scene::Scene& scene, const Targets& targets) {
  for (const exporting::Target* target : targets) pipeline::require_possible_for(*target, scene);
}

void export_scene(const Export& job, const AppendTarget& append) {
  const ThreadLimit limit(job.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  tell(scene.notes);
  require_for_targets(scene, job.targets);
  pipeline::require_output_folder(job.output);
  const pipeline::Edition edition = edition_of(scene, "export");
  pipeline::Published published;
  std::vector<Note> empty;
  {
    ProgressBar bar;
    const Progress progress = bar.progress();
    const exporting::Model model = pipeline::generated(scene, progress);
    exporting::Outputs outputs;
    for (const exporting::Target* target : job.targets) append(*target, model, outputs);
    pipeline::report_sets(outputs, progress);
    const SignalNotes notes;
    published = pipeline::written_outputs(outputs, edition, job.output, SignalNotes::received);
    empty = pipeline::emptiness(scene, model);
  }
  tell(empty);
  report(published, edition, job.output);
}

}  // namespace shatterpave::cli
