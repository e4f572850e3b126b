// The command: arguments, messages, exit status. The only catch-all.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <variant>

#include "cli/arguments.h"
#include "cli/export_job.h"
#include "cli/raster_jobs.h"
#include "cli/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "export/measures/measures.h"
#include "pipeline/generate.h"
#include "pipeline/measure.h"
#include "pipeline/render.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace {

using namespace shatterpave;

enum ExitStatus { done = 0, program_failed = 1, input_wrong = 2, renderer_failed = 3 };

void run(const cli::Export& job, char** argv) {
  const auto has_rasters = [](cli::Target target) { return target == cli::Target::povray || target == cli::Target::textures; };
  if (std::ranges::any_of(job.targets, has_rasters)) {
    cli::run_with_rasters(job, argv);
  } else {
    cli::export_scene(job, cli::append_without_rasters);
  }
}

void run(const cli::Check& job, char** /*argv*/) {
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  pipeline::require_possible(scene);
  cli::tell(scene.notes);
}

void run(const cli::Render& job, char** argv) { cli::run_with_rasters(job, argv); }

void run(const cli::Measure& job, char** /*argv*/) {
  const ThreadLimit limit(job.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  cli::tell(scene.notes);
  pipeline::require_output_folder(job.output);
  std::vector<exporting::OutputFile> files;
  {
    cli::ProgressBar bar;
    files = exporting::measures_files(pipeline::surveyed(scene, job.options, bar.progress()));
  }
  if (!exporting::has_plots()) {
    cli::tell("shatterpave: the report was left out, since this build has no plotting library (see docs/measure.md)\n");
  }
  const cli::SignalNotes notes;
  cli::print_paths(pipeline::written(files, job.output, cli::SignalNotes::received));
}

void run(const cli::Show& show, char** /*argv*/) { cli::print(show.text); }

int failed(ExitStatus status, std::string_view message) {
  cli::tell(fmt::format("{}\n", message));
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::visit([argv](const auto& job) { run(job, argv); }, cli::command_of(argc, argv));
    return done;
  } catch (const InputError& error) {
    return failed(input_wrong, error.what());
  } catch (const pipeline::RendererError& error) {
    return failed(renderer_failed, error.what());
  } catch (const pipeline::Interrupted&) {
    return cli::end_by_signal();
  } catch (const std::bad_alloc&) {
    std::fputs("shatterpave: out of memory\n", stderr);
    return program_failed;
  } catch (const std::exception& error) {
    return failed(program_failed, fmt::format("shatterpave: {}", error.what()));
  }
}
