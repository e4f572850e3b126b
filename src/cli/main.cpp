// The command: arguments, messages, exit status. The only catch-all.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>

#include "cli/arguments.h"
#include "cli/export_job.h"
#include "cli/raster_jobs.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/cancel.h"
#include "core/error.h"
#include "core/parallel.h"
#include "pipeline/fit.h"
#include "pipeline/generate.h"
#include "pipeline/lines.h"
#include "pipeline/measure.h"
#include "pipeline/outlook.h"
#include "pipeline/render.h"
#include "pipeline/write.h"
#include "report/measures.h"
#include "report/trace_files.h"
#include "scene/read_scene.h"

namespace {

using namespace shatterpave;

enum ExitStatus { done = 0, program_failed = 1, input_wrong = 2, renderer_failed = 3 };

void run(const cli::Export& job, char** argv) {
  using exporting::Target;
  if (std::ranges::any_of(job.targets, &Target::has_rasters) || cli::may_have_environment(job.scene, job.overrides)) {
    cli::run_with_rasters(job, argv);
    return;
  }
  const auto append = [](const Target& target, const exporting::Model& model, exporting::Outputs& outputs) {
    target.append(model, outputs);
  };
  cli::export_scene(job, append, nullptr);
}

void run(const cli::Check& job, char** argv) {
  if (cli::may_have_environment(job.scene, job.overrides)) {
    cli::run_with_rasters(job, argv);
  } else {
    cli::check_scene(job, nullptr);
  }
}

void run(const cli::Render& job, char** argv) { cli::run_with_rasters(job, argv); }
void run(const cli::Farm& job, char** argv) { cli::run_with_rasters(job, argv); }
void run(const cli::Serve& job, char** argv) { cli::run_with_rasters(job, argv); }

void run(const cli::Trace& job, char** argv) { cli::run_with_rasters(job, argv); }

void run(const cli::Fit& job, char** /*argv*/) {
  const ThreadLimit limit(job.threads);
  cli::ProgressBar bar;
  pipeline::write_fitted_scene(job.traces, job.output, bar.progress());
  cli::print_paths({job.output});
}

void run(const cli::Measure& job, char** /*argv*/) {
  const ThreadLimit limit(job.threads);
  const bool of_lines = pipeline::is_file_of_lines(job.scene);
  if (of_lines && !job.overrides.empty()) {
    throw InputError(Place{job.scene.string(), 0, 0, ""}, "expected no --set and no --seed beside lines from a file, got one");
  }
  pipeline::MeasureOptions options = job.options;
  if (of_lines && (options.seeds != 1 || options.sweep)) {
    // Its panes are what they are: broken anew they would count as others, each the same.
    cli::tell(fmt::format("note: {}: --seeds and --radials have no effect on lines from a file\n", job.scene.string()));
    options.seeds = 1;
    options.sweep.reset();
  }
  const scene::Scene scene = of_lines ? pipeline::scene_of_lines(job.scene) : scene::scene_of_file(job.scene, job.overrides);
  pipeline::require_possible(scene);
  cli::tell(scene.notes);
  cli::tell(pipeline::emptiness(scene));
  pipeline::require_output_folder(job.output);
  std::vector<exporting::OutputFile> files;
  {
    cli::ProgressBar bar;
    files = reporting::measures_files(pipeline::surveyed(scene, options, bar.progress()));
  }
  if (of_lines) {
    files.push_back(reporting::figures_csv(scene.name, scene.panes));
    files.push_back(reporting::experiment_csv());
  }
  if (!reporting::has_plots()) {
    cli::tell("shatterpave: the report was left out, since this build has no plotting library (see docs/measure.md)\n");
  }
  const cli::SignalNotes notes;
  const pipeline::Edition edition = cli::edition_of(scene, "measures");
  cli::report(pipeline::written(files, edition, job.output, cli::SignalNotes::received), edition, job.output);
}

void run(const cli::Show& show, char** /*argv*/) { cli::print(show.text); }

// Whether the error is due to the folder or file that was named, so that the input is wrong. A full disk is none of these.
bool is_of_the_path(const std::error_code& code) {
  constexpr std::array reasons = {
      std::errc::permission_denied,      std::errc::operation_not_permitted, std::errc::read_only_file_system,
      std::errc::not_a_directory,        std::errc::is_a_directory,          std::errc::no_such_file_or_directory,
      std::errc::filename_too_long,      std::errc::invalid_argument,        std::errc::too_many_symbolic_link_levels,
      std::errc::operation_not_supported};
  return std::ranges::any_of(reasons, [&](std::errc reason) { return code == reason; });
}

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
  } catch (const Interrupted&) {
    return cli::end_by_signal();
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string path = error.path1().string();
    if (!is_of_the_path(error.code())) return failed(program_failed, fmt::format("{}: {}", path, error.code().message()));
    return failed(input_wrong, fmt::format("{}: expected a folder that can be made and written to, got an error: {}", path,
                                           error.code().message()));
  } catch (const std::bad_alloc&) {
    std::fputs("shatterpave: out of memory\n", stderr);
    return program_failed;
  } catch (const std::exception& error) {
    return failed(program_failed, fmt::format("shatterpave: {}", error.what()));
  }
}
