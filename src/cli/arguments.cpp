#include "cli/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "core/error.h"

namespace shatterpave::cli {

namespace {

const std::map<std::string, Target> target_names = {{"povray", Target::povray}, {"json", Target::json}, {"svg", Target::svg}};

constexpr int most_threads = 1024;

// What is given as text and turned into values after CLI11 is done with it.
struct SceneOptions {
  std::string scene;
  std::string seed;
  std::vector<std::string> sets;
};

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("SCENE.toml", options.scene, "The scene file")->required();
  command
      .add_option("--set", options.sets, "Set a value of the scene: KEY=VALUE, such as pane[0].thickness_mm=3; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", options.seed, "The seed, instead of the scene's")->type_name("N");
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads; 0, the default, takes all processors")
      ->type_name("N")
      ->check(CLI::Range(0, most_threads));
}

std::vector<scene::Override> overrides_of(const SceneOptions& options) {
  std::vector<scene::Override> overrides;
  for (const std::string& set : options.sets) {
    const std::size_t equals = set.find('=');
    const std::string origin = "--set " + set;
    if (equals == std::string::npos || equals == 0) {
      throw InputError(Place{origin, 0, 0, ""}, "expected KEY=VALUE, got no '=' after a key");
    }
    overrides.push_back({origin, set.substr(0, equals), set.substr(equals + 1)});
  }
  if (!options.seed.empty()) overrides.push_back({"--seed " + options.seed, "seed", options.seed});
  return overrides;
}

std::vector<Target> targets_of(std::vector<Target> given) {
  if (given.empty()) given.push_back(Target::povray);
  std::ranges::sort(given);
  const auto repeated = std::ranges::unique(given);
  given.erase(repeated.begin(), repeated.end());
  return given;
}

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

Command command_of(int argc, const char* const* argv) {
  CLI::App app("Shattered window glass and stone paving for offline renderers.", "shatterpave");
  app.require_subcommand(1);
  app.set_version_flag("--version", "shatterpave " SHATTERPAVE_VERSION);
  SceneOptions scene;
  Export job;
  std::string output;

  CLI::App& export_command = *app.add_subcommand("export", "Write what renderers and other programs read");
  add_scene_options(export_command, scene);
  export_command.add_option("-o", output, "The output folder; made if it is missing")->type_name("DIR")->required();
  export_command.add_option("--target", job.targets, "povray (the default), json or svg; may be repeated")
      ->type_name("TARGET")
      ->allow_extra_args(false)
      ->transform(CLI::CheckedTransformer(target_names));
  add_threads(export_command, job.threads);

  CLI::App& check_command = *app.add_subcommand("check", "Validate a scene file; writes nothing");
  add_scene_options(check_command, scene);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Show{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return Show{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw InputError(fmt::format("shatterpave: {} (see shatterpave --help)", one_line(error.what())));
  }
  if (check_command.parsed()) return Check{scene.scene, overrides_of(scene)};
  job.scene = scene.scene;
  job.overrides = overrides_of(scene);
  job.output = output;
  job.targets = targets_of(std::move(job.targets));
  return job;
}

}  // namespace shatterpave::cli
