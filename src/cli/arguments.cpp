#include "cli/arguments.h"

#include <fmt/format.h>
#include <shatterpave/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "cli/usage.h"
#include "core/error.h"
#include "core/words.h"
#include "export/targets.h"
#include "glass/growth/counts.h"
#include "scene/schema/key_tables.h"

namespace shatterpave::cli {

namespace {

// In the order of their enumeration.
constexpr std::array<std::string_view, 2> quality_names = {"draft", "final"};

constexpr int most_threads = 1024;
constexpr int most_pixels = 16384;  // a side; POV-Ray keeps the whole picture in memory

// All that may be asked for, as it was written: CLI11 only takes the words apart, so that messages are ours.
struct Requests {
  Texts scenes;
  Texts sets;
  Texts seeds;
  Texts outputs;
  Texts targets;
  Texts threads;
  Texts qualities;
  Texts sizes;
  Texts seed_counts;
  Texts radials;
  bool keys_as_json = false;
  bool keys_as_markdown = false;
};

void add(CLI::App& command, const char* name, Texts& texts, const char* value, const std::string& sentence) {
  command.add_option(name, texts, sentence)
      ->type_name(value)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_scene_options(CLI::App& command, Requests& requests) {
  add(command, "SCENE.toml", requests.scenes, "", "The scene file");
  add(command, "--set", requests.sets, "KEY=VALUE",
      "Set a value of the scene: KEY=VALUE, such as pane[0].thickness_mm=3; may be repeated");
  add(command, "--seed", requests.seeds, "N", "The seed, instead of the scene's");
}

void add_threads(CLI::App& command, Requests& requests) {
  add(command, "--threads", requests.threads, "N", "Number of threads; 0, the default, takes all processors");
}

void add_output(CLI::App& command, Requests& requests) {
  add(command, "-o", requests.outputs, "DIR", "The output folder; made if it is missing");
}

// The names of all targets, in the order of their table.
std::vector<std::string_view> target_names() {
  std::vector<std::string_view> names;
  for (const exporting::Target* target : exporting::targets()) names.push_back(target->name);
  return names;
}

void add_targets(CLI::App& command, Requests& requests) {
  std::vector<std::string_view> names = target_names();
  const std::string first = fmt::format("{} (the default)", names.front());
  names.front() = first;
  add(command, "--target", requests.targets, "TARGET", fmt::format("{}; may be repeated", listed(names, "or")));
  std::string sentences = "Targets:\n";
  for (const exporting::Target* target : exporting::targets()) {
    sentences += fmt::format("  {:<28}{}\n", target->name, target->sentence);
  }
  command.footer(sentences);
}

void add_export(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("export", "Write what renderers and other programs read");
  add_scene_options(*command, requests);
  add_output(*command, requests);
  add_targets(*command, requests);
  add_threads(*command, requests);
}

void add_check(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("check", "Validate a scene file, and say in a line what it holds; writes nothing");
  add_scene_options(*command, requests);
  add_targets(*command, requests);
}

void add_render(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("render", "Render the scene's still by POV-Ray: DIR/SCENE.exr and DIR/SCENE.png");
  add_scene_options(*command, requests);
  add_output(*command, requests);
  add(*command, "--quality", requests.qualities, "QUALITY", "draft (the default, 640x480) or final (1200x900)");
  add(*command, "--size", requests.sizes, "WxH", "Size of the picture in pixels");
  add_threads(*command, requests);
}

void add_measure(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand(
      "measure", "Measure the scene's panes and pavements over many seeds, and hold them against their sources");
  add_scene_options(*command, requests);
  add_output(*command, requests);
  add(*command, "--seeds", requests.seed_counts, "N", "Number of seeds, from the scene's (or --seed) on; default 1");
  add(*command, "--radials", requests.radials, "LOW..HIGH",
      "Numbers of radial cracks, from LOW for the first seed to HIGH for the last, instead of what the scene says");
  add_threads(*command, requests);
}

void add_keys(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("keys", "List every key of scene files: type, range, default, and what it does");
  command->add_flag("--json", requests.keys_as_json, "As JSON");
  command->add_flag("--markdown", requests.keys_as_markdown, "As the tables of docs/scene-file.md");
}

std::vector<scene::Override> overrides_of(const Requests& requests) {
  std::vector<scene::Override> overrides;
  for (const std::string& set : requests.sets) {
    const std::size_t equals = set.find('=');
    const std::string origin = "--set " + set;
    if (equals == std::string::npos || equals == 0) {
      throw InputError(Place{origin, 0, 0, ""}, "expected KEY=VALUE, got no '=' after a key");
    }
    overrides.push_back({origin, set.substr(0, equals), set.substr(equals + 1)});
  }
  const auto seed = the_only(requests.seeds, "--seed");
  if (seed) overrides.push_back({"--seed " + *seed, "seed", *seed});
  return overrides;
}

Targets targets_of(const Texts& given) {
  const auto table = exporting::targets();
  if (given.empty()) return {table.front()};
  const std::vector<std::string_view> names = target_names();
  std::vector<std::size_t> chosen;
  for (const std::string& name : given) chosen.push_back(choice_of(name, "--target", names));
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Targets targets;
  for (const std::size_t i : chosen) targets.push_back(table[i]);
  return targets;
}

int threads_of(const Requests& requests) {
  const auto text = the_only(requests.threads, "--threads");
  return text ? static_cast<int>(whole_number_of(*text, "--threads", {0, most_threads})) : 0;
}

std::filesystem::path scene_of(const Requests& requests, const std::string& command) {
  if (requests.scenes.empty()) refuse_usage(command, "a scene file, SCENE.toml", "none");
  if (requests.scenes.front().empty()) refuse_usage(command, "a scene file, SCENE.toml", "an empty name");
  return requests.scenes.front();
}

std::filesystem::path output_of(const Requests& requests, const std::string& command) {
  const auto folder = the_only(requests.outputs, "-o");
  if (!folder) refuse_usage(command, "-o DIR, the output folder", "none");
  return *folder;
}

// WIDTHxHEIGHT in pixels.
void read_size(const Requests& requests, pipeline::RenderOptions& options) {
  const auto text = the_only(requests.sizes, "--size");
  if (!text) return;
  const std::size_t x = text->find('x');
  const auto side = [&](std::string_view digits) { return whole_number(digits, {1, most_pixels}); };
  const auto width = side(text->substr(0, x));
  const auto height = x == std::string::npos ? std::nullopt : side(text->substr(x + 1));
  if (!width || !height) {
    refuse_usage("--size", fmt::format("WIDTHxHEIGHT in pixels, each from 1 to {}, such as 640x480", most_pixels),
                 in_quotes(*text));
  }
  options.width = static_cast<int>(*width);
  options.height = static_cast<int>(*height);
}

// LOW..HIGH, numbers of radial cracks.
void read_sweep(const Requests& requests, pipeline::MeasureOptions& options) {
  const auto text = the_only(requests.radials, "--radials");
  if (!text) return;
  constexpr std::string_view dots = "..";
  const std::size_t at = text->find(dots);
  const WholeRange range{1, glass::largest_radial_count};
  const auto low = whole_number(text->substr(0, at), range);
  const auto high = at == std::string::npos ? std::nullopt : whole_number(text->substr(at + dots.size()), range);
  const std::string expected = fmt::format("LOW..HIGH, whole numbers from 1 to {}", glass::largest_radial_count);
  if (!low || !high) refuse_usage("--radials", expected, in_quotes(*text));
  if (*low > *high) {
    refuse_usage("--radials", expected + ", the lower one first",
                 fmt::format("{}; did you mean {}..{}?", in_quotes(*text), *high, *low));
  }
  options.sweep = measure::Sweep{static_cast<int>(*low), static_cast<int>(*high)};
}

Command export_of(const Requests& requests) {
  return Export{scene_of(requests, "export"), overrides_of(requests), output_of(requests, "export"),
                targets_of(requests.targets), threads_of(requests)};
}

Command render_of(const Requests& requests) {
  Render job{scene_of(requests, "render"), overrides_of(requests), output_of(requests, "render"), {}};
  job.options.threads = threads_of(requests);
  if (const auto quality = the_only(requests.qualities, "--quality")) {
    job.options.quality = static_cast<pipeline::Quality>(choice_of(*quality, "--quality", quality_names));
  }
  read_size(requests, job.options);
  return job;
}

Command measure_of(const Requests& requests) {
  pipeline::MeasureOptions options;
  const std::filesystem::path scene = scene_of(requests, "measure");
  options.scene_file = scene.string();
  if (const auto seeds = the_only(requests.seed_counts, "--seeds")) {
    const WholeRange range{1, static_cast<std::int64_t>(pipeline::most_seeds)};
    options.seeds = static_cast<std::size_t>(whole_number_of(*seeds, "--seeds", range));
  }
  read_sweep(requests, options);
  const std::filesystem::path output = output_of(requests, "measure");
  return Measure{scene, overrides_of(requests), output, options, threads_of(requests)};
}

Command keys_of(const Requests& requests) {
  if (requests.keys_as_json && requests.keys_as_markdown) refuse_usage("keys", "--json or --markdown", "both");
  if (requests.keys_as_json) return Show{scene::keys_json()};
  return Show{requests.keys_as_markdown ? scene::keys_markdown() : scene::keys_text()};
}

}  // namespace

Command command_of(int argc, const char* const* argv) {
  CLI::App app("Shattered window glass and stone paving for offline renderers.", "shatterpave");
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", "shatterpave " SHATTERPAVE_VERSION);
  Requests requests;
  add_export(app, requests);
  add_check(app, requests);
  add_keys(app, requests);
  add_measure(app, requests);
  add_render(app, requests);
  const Texts words(argv + 1, argv + argc);
  require_known_words(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Show{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return Show{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    refuse_parsed(error);
  }
  const std::string command = app.get_subcommands().front()->get_name();
  if (command == "check") {
    return Check{scene_of(requests, command), overrides_of(requests), targets_of(requests.targets)};
  }
  if (command == "export") return export_of(requests);
  if (command == "keys") return keys_of(requests);
  return command == "measure" ? measure_of(requests) : render_of(requests);
}

}  // namespace shatterpave::cli
