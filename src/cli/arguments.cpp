#include "cli/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "cli/built_with.h"
#include "cli/command_line.h"
#include "cli/manual.h"
#include "cli/usage.h"
#include "core/error.h"
#include "export/svg/sheet_svg.h"
#include "export/targets.h"
#include "glass/growth/counts.h"
#include "pipeline/farm.h"
#include "scene/frame_range.h"
#include "scene/schema/key_tables.h"

namespace shatterpave::cli {

namespace {

// In the order of their enumeration.
constexpr std::array<std::string_view, 2> quality_names = {"draft", "final"};
constexpr std::array<std::string_view, 4> progress_names = {"bar", "lines", "openjd", "none"};

constexpr std::array<std::string_view, 3> polarity_names = {"bright", "dark", "both"};
constexpr std::array<std::string_view, 2> chain_names = {"robust", "paper"};

constexpr int most_threads = 1024;
constexpr int largest_port = 65535;
constexpr int most_pixels = 16384;  // a side; POV-Ray keeps the whole picture in memory

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

// 1:N, by which the target svg draws a sheet.
std::optional<double> scale_of(const Requests& requests, const Targets& targets) {
  const auto text = the_only(requests.sheet_scales, "--scale");
  if (!text) return std::nullopt;
  const std::string expected =
      fmt::format("1:N, N a number from {} to {}, such as 1:50", exporting::svg::largest_scale, exporting::svg::smallest_scale);
  double scale = 0.0;
  if (!text->starts_with("1:")) refuse_usage("--scale", expected, in_quotes(*text));
  const char* const end = text->data() + text->size();
  const auto [stop, error] = std::from_chars(text->data() + 2, end, scale);
  if (error != std::errc{} || stop != end ||
      !(scale >= exporting::svg::largest_scale && scale <= exporting::svg::smallest_scale)) {
    refuse_usage("--scale", expected, in_quotes(*text));
  }
  const bool draws = std::ranges::any_of(targets, [](const exporting::Target* target) { return target->name == "svg"; });
  if (!draws) refuse_usage("--scale", "--target svg, which draws the sheet", "it without");
  return scale;
}

std::optional<std::vector<int>> frames_of(const Requests& requests) {
  const auto text = the_only(requests.frames, "--frames");
  if (!text) return std::nullopt;
  return scene::frames_of_range(*text, Place{"shatterpave: --frames", 0, 0, ""});
}

pipeline::RenderOptions render_options_of(const Requests& requests) {
  pipeline::RenderOptions options;
  options.threads = threads_of(requests);
  if (const auto quality = the_only(requests.qualities, "--quality")) {
    options.quality = static_cast<pipeline::Quality>(choice_of(*quality, "--quality", quality_names));
  }
  read_size(requests, options);
  return options;
}

Command export_of(const Requests& requests) {
  const Targets targets = targets_of(requests.targets);
  return Export{scene_of(requests, "export"), overrides_of(requests), output_of(requests, "export"), targets,
                frames_of(requests),          threads_of(requests),   scale_of(requests, targets)};
}

Command render_of(const Requests& requests) {
  Render job{scene_of(requests, "render"), overrides_of(requests), output_of(requests, "render"), render_options_of(requests)};
  job.frames = frames_of(requests);
  job.skip_existing = requests.skip_existing;
  if (job.skip_existing && !job.frames) refuse_usage("--skip-existing", "--frames beside it", "none");
  if (const auto form = the_only(requests.progress, "--progress")) {
    job.progress = static_cast<ProgressForm>(choice_of(*form, "--progress", progress_names));
  }
  return job;
}

Command farm_of(const Requests& requests) {
  Farm job{scene_of(requests, "farm"), overrides_of(requests), output_of(requests, "farm"), render_options_of(requests)};
  job.frames = frames_of(requests);
  const auto system = the_only(requests.systems, "--system");
  if (!system) refuse_usage("farm", "--system SYSTEM, the render farm", "none");
  job.system = choice_of(*system, "--system", pipeline::farm_systems);
  if (const auto chunk = the_only(requests.chunks, "--chunk")) {
    job.chunk = static_cast<int>(whole_number_of(*chunk, "--chunk", {1, pipeline::most_chunk}));
  }
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
  options.both_laws = requests.both_laws;
  const std::filesystem::path output = output_of(requests, "measure");
  return Measure{scene, overrides_of(requests), output, options, threads_of(requests)};
}

std::vector<std::filesystem::path> files_of(const Requests& requests, const std::string& command, std::string_view expected) {
  if (requests.files.empty()) refuse_usage(command, expected, "none");
  std::vector<std::filesystem::path> files;
  for (const std::string& file : requests.files) {
    if (file.empty()) refuse_usage(command, expected, "an empty name");
    files.emplace_back(file);
  }
  return files;
}

// Two numbers with a comma between them.
vec2 pair_of(const std::string& text, std::string_view option, double low, double high) {
  const std::size_t comma = text.find(',');
  const auto x = real_number(std::string_view(text).substr(0, comma), low, high);
  const auto y = comma == std::string::npos ? std::nullopt : real_number(std::string_view(text).substr(comma + 1), low, high);
  if (!x || !y)
    refuse_usage(option, fmt::format("two numbers from {} to {} with a comma between them", low, high), in_quotes(text));
  return {*x, *y};
}

void read_pane_size(const Requests& requests, trace::Options& options) {
  constexpr double least = 1.0;
  constexpr double most = 100'000.0;
  if (const auto size = the_only(requests.pane_sizes, "--pane-mm")) options.pane_mm = pair_of(*size, "--pane-mm", least, most);
  const auto scale = the_only(requests.scales, "--mm-per-px");
  if (!scale) return;
  if (options.pane_mm) refuse_usage("--mm-per-px", "it or --pane-mm", "both");
  options.mm_per_px = real_number(*scale, 1e-4, 1000.0);
  if (!options.mm_per_px) refuse_usage("--mm-per-px", "a number from 0.0001 to 1000", in_quotes(*scale));
}

void read_corners(const Requests& requests, trace::Options& options) {
  if (requests.corners.empty()) return;
  if (requests.corners.size() != 4) {
    refuse_usage("--corners", "four corners X,Y", fmt::format("{}", requests.corners.size()));
  }
  trace::Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = pair_of(requests.corners[i], "--corners", -1e5, 1e5);
  options.corners_px = corners;
}

Command trace_of(const Requests& requests) {
  Trace job{files_of(requests, "trace", "a photograph"), output_of(requests, "trace"), {}, {}, threads_of(requests)};
  read_pane_size(requests, job.options);
  read_corners(requests, job.options);
  if (const auto at = the_only(requests.impacts, "--impact")) job.options.impact_px = pair_of(*at, "--impact", -1e5, 1e5);
  if (const auto chain = the_only(requests.chains, "--chain")) {
    job.options.chain = static_cast<trace::Chain>(choice_of(*chain, "--chain", chain_names));
  }
  if (const auto polarity = the_only(requests.polarities, "--polarity")) {
    job.options.polarity = static_cast<trace::Polarity>(choice_of(*polarity, "--polarity", polarity_names));
  }
  if (const auto level = the_only(requests.thresholds, "--threshold")) {
    job.options.threshold = static_cast<int>(whole_number_of(*level, "--threshold", {0, 255}));
    if (requests.chains.empty()) job.options.chain = trace::Chain::paper;  // only there is a threshold
    if (job.options.chain != trace::Chain::paper) refuse_usage("--threshold", "--chain paper beside it", "--chain robust");
  }
  for (const Texts* texts : {&requests.pane_sizes, &requests.corners, &requests.scales, &requests.impacts, &requests.thresholds,
                             &requests.polarities, &requests.chains}) {
    for (const std::string& text : *texts) job.words += text + " ";
    job.words += "\n";
  }
  return job;
}

Command fit_of(const Requests& requests) {
  const auto file = the_only(requests.outputs, "-o");
  if (!file || file->empty()) refuse_usage("fit", "-o SCENE.toml, the scene file", "none");
  return Fit{files_of(requests, "fit", "a traced pane, TRACE.json"), *file, threads_of(requests)};
}

Command serve_of(const Requests& requests) {
  Serve job{scene_of(requests, "serve"), default_port};
  if (const auto port = the_only(requests.ports, "--port")) {
    job.port = static_cast<int>(whole_number_of(*port, "--port", {0, largest_port}));
  }
  return job;
}

Command keys_of(const Requests& requests) {
  if (requests.keys_as_json && requests.keys_as_markdown) refuse_usage("keys", "--json or --markdown", "both");
  if (requests.keys_as_json) return Show{scene::keys_json()};
  return Show{requests.keys_as_markdown ? scene::keys_markdown() : scene::keys_text()};
}

Command manual_of(const CLI::App& app, const Requests& requests) {
  const auto form = the_only(requests.manual_forms, "--form");
  return Show{manual(app, form ? choice_of(*form, "--form", manual_forms) : 0)};
}

}  // namespace

Command command_of(int argc, const char* const* argv) {
  CLI::App app("Shattered window glass and stone paving for offline renderers.", "shatterpave");
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", version_text());
  Requests requests;
  add_commands(app, requests);
  const Texts words(argv + 1, argv + argc);
  require_known_words(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Show{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return Show{version.what()};
  } catch (const CLI::ParseError& error) {
    refuse_parsed(error);
  }
  const std::string command = app.get_subcommands().front()->get_name();
  if (command == "check") {
    return Check{scene_of(requests, command), overrides_of(requests), targets_of(requests.targets)};
  }
  if (command == "export") return export_of(requests);
  if (command == "farm") return farm_of(requests);
  if (command == "keys") return keys_of(requests);
  if (command == "manual") return manual_of(app, requests);
  if (command == "serve") return serve_of(requests);
  if (command == "trace") return trace_of(requests);
  if (command == "fit") return fit_of(requests);
  return command == "measure" ? measure_of(requests) : render_of(requests);
}

}  // namespace shatterpave::cli
