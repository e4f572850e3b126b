#include "cli/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "glass/counts.h"

namespace shatterpave::cli {

namespace {

const std::map<std::string, Target> target_names = {{"povray", Target::povray},
                                                    {"json", Target::json},
                                                    {"svg", Target::svg},
                                                    {"textures", Target::textures},
                                                    {"obj", Target::obj}};

const std::map<std::string, pipeline::Quality> quality_names = {{"draft", pipeline::Quality::draft},
                                                                {"final", pipeline::Quality::final}};

// Takes a name of `values` for the number of its value.
template <typename Value>
CLI::Validator one_of(const std::map<std::string, Value>& values) {
  return {[&values](std::string& text) {
            if (const auto at = values.find(text); at != values.end()) {
              text = std::to_string(static_cast<int>(at->second));
              return std::string();
            }
            std::string names;
            for (const auto& [name, value] : values) names += (names.empty() ? "" : " or ") + name;
            return fmt::format("expected {}, got {}", names, text);
          },
          ""};
}

constexpr int most_threads = 1024;
constexpr int most_pixels = 16384;  // a side; POV-Ray keeps the whole picture in memory

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

void add_output(CLI::App& command, std::string& output) {
  command.add_option("-o", output, "The output folder; made if it is missing")->type_name("DIR")->required();
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
  given.erase(std::unique(given.begin(), given.end()), given.end());
  return given;
}

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// WIDTHxHEIGHT in pixels.
void read_size(const std::string& text, pipeline::RenderOptions& options) {
  if (text.empty()) return;
  const char* end = text.data() + text.size();
  const auto [x, width_error] = std::from_chars(text.data(), end, options.width);
  const bool has_x = width_error == std::errc{} && x != end && *x == 'x';
  const auto [rest, height_error] = std::from_chars(has_x ? x + 1 : end, end, options.height);
  const auto in_range = [](int pixels) { return pixels >= 1 && pixels <= most_pixels; };
  if (!has_x || height_error != std::errc{} || rest != end || !in_range(options.width) || !in_range(options.height)) {
    throw InputError(fmt::format("shatterpave: --size: expected WxH with 1 to {} pixels each, got \"{}\"", most_pixels, text));
  }
}

// LOW..HIGH, numbers of radial cracks.
void read_sweep(const std::string& text, pipeline::MeasureOptions& options) {
  if (text.empty()) return;
  measure::Sweep sweep;
  const char* end = text.data() + text.size();
  const auto [dots, low_error] = std::from_chars(text.data(), end, sweep.low);
  const bool has_dots = low_error == std::errc{} && std::string_view(dots, end).starts_with("..");
  const auto [rest, high_error] = std::from_chars(has_dots ? dots + 2 : end, end, sweep.high);
  if (!has_dots || high_error != std::errc{} || rest != end || sweep.low < 1 || sweep.high < sweep.low ||
      sweep.high > glass::largest_radial_count) {
    throw InputError(fmt::format("shatterpave: --radials: expected LOW..HIGH, whole numbers from 1 to {}, got \"{}\"",
                                 glass::largest_radial_count, text));
  }
  options.sweep = sweep;
}

// All that may be asked for, as CLI11 fills it in.
struct Requests {
  SceneOptions scene;
  std::string output;
  std::vector<Target> targets;
  pipeline::RenderOptions render;
  std::string size;
  pipeline::MeasureOptions measure;
  std::string radials;
  int threads = 0;
};

void add_targets(CLI::App& command, Requests& requests) {
  command.add_option("--target", requests.targets, "povray (the default), json, svg, textures or obj; may be repeated")
      ->type_name("TARGET")
      ->allow_extra_args(false)
      ->transform(one_of(target_names));
}

CLI::App* add_export(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("export", "Write what renderers and other programs read");
  add_scene_options(*command, requests.scene);
  add_output(*command, requests.output);
  add_targets(*command, requests);
  add_threads(*command, requests.threads);
  return command;
}

CLI::App* add_check(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("check", "Validate a scene file; writes nothing");
  add_scene_options(*command, requests.scene);
  add_targets(*command, requests);
  return command;
}

CLI::App* add_render(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("render", "Render the scene's still by POV-Ray: DIR/SCENE.exr and DIR/SCENE.png");
  add_scene_options(*command, requests.scene);
  add_output(*command, requests.output);
  command->add_option("--quality", requests.render.quality, "draft (the default, 640x480) or final (1200x900)")
      ->type_name("QUALITY")
      ->transform(one_of(quality_names));
  command->add_option("--size", requests.size, "Size of the picture in pixels")->type_name("WxH");
  add_threads(*command, requests.threads);
  return command;
}

CLI::App* add_measure(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand(
      "measure", "Measure the scene's panes and pavements over many seeds, and hold them against their sources");
  add_scene_options(*command, requests.scene);
  add_output(*command, requests.output);
  command->add_option("--seeds", requests.measure.seeds, "Number of seeds, from the scene's (or --seed) on; default 1")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, pipeline::most_seeds));
  command
      ->add_option("--radials", requests.radials,
                   "Numbers of radial cracks, from LOW for the first seed to HIGH for the last, instead of what the scene says")
      ->type_name("LOW..HIGH");
  add_threads(*command, requests.threads);
  return command;
}

}  // namespace

Command command_of(int argc, const char* const* argv) {
  CLI::App app("Shattered window glass and stone paving for offline renderers.", "shatterpave");
  app.require_subcommand(1);
  app.set_version_flag("--version", "shatterpave " SHATTERPAVE_VERSION);
  Requests requests;
  const CLI::App* export_command = add_export(app, requests);
  const CLI::App* check_command = add_check(app, requests);
  const CLI::App* measure_command = add_measure(app, requests);
  add_render(app, requests);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Show{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return Show{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw InputError(fmt::format("shatterpave: {} (see shatterpave --help)", one_line(error.what())));
  }
  const std::filesystem::path scene = requests.scene.scene;
  std::vector<scene::Override> overrides = overrides_of(requests.scene);
  if (check_command->parsed()) return Check{scene, std::move(overrides), targets_of(std::move(requests.targets))};
  if (export_command->parsed()) {
    return Export{scene, std::move(overrides), requests.output, targets_of(std::move(requests.targets)), requests.threads};
  }
  if (measure_command->parsed()) {
    requests.measure.scene_file = scene.string();
    read_sweep(requests.radials, requests.measure);
    return Measure{scene, std::move(overrides), requests.output, requests.measure, requests.threads};
  }
  requests.render.threads = requests.threads;
  read_size(requests.size, requests.render);
  return Render{scene, std::move(overrides), requests.output, requests.render};
}

}  // namespace shatterpave::cli
