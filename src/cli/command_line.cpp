#include "cli/command_line.h"

#include <fmt/format.h>

#include <string>

#include "core/words.h"
#include "export/targets.h"
#include "pipeline/farm.h"

namespace shatterpave::cli {

namespace {

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

void add_frames(CLI::App& command, Requests& requests, const std::string& sentence) {
  add(command, "--frames", requests.frames, "RANGE", sentence + ": 1-10, 1-10:2 or 1,5,9-12, of the scene's [frames]");
}

void add_picture(CLI::App& command, Requests& requests) {
  add(command, "--quality", requests.qualities, "QUALITY", "draft (the default, 640x480) or final (1200x900)");
  add(command, "--size", requests.sizes, "WxH", "Size of the picture in pixels");
}

void add_export(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("export", "Write what renderers and other programs read");
  add_scene_options(*command, requests);
  add_output(*command, requests);
  add_targets(*command, requests);
  add(*command, "--scale", requests.sheet_scales, "1:N",
      "With --target svg: all pavements on one sheet to scale, too, with quantities");
  add_frames(*command, requests, "Frames, in place of the still");
  add_threads(*command, requests);
}

void add_check(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("check", "Validate a scene file, and say in a line what it holds; writes nothing");
  add_scene_options(*command, requests);
  add_targets(*command, requests);
}

void add_render(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand(
      "render", "Render the scene's still by POV-Ray: DIR/SCENE.exr and DIR/SCENE.png, or frames: DIR/SCENE.0001.exr …");
  add_scene_options(*command, requests);
  add_output(*command, requests);
  add_picture(*command, requests);
  add_frames(*command, requests, "Frames, in place of the still");
  command->add_flag("--skip-existing", requests.skip_existing,
                    "Leave frames that are there, whole and of the same scene and settings");
  add(*command, "--progress", requests.progress, "FORM",
      "bar (on a terminal), lines (elsewhere), openjd (for workers of Open Job Description) or none");
  add_threads(*command, requests);
}

void add_farm(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("farm", "Write job files with which a render farm renders frames; starts nothing");
  add_scene_options(*command, requests);
  add_output(*command, requests);
  std::vector<std::string_view> names(pipeline::farm_systems.begin(), pipeline::farm_systems.end());
  add(*command, "--system", requests.systems, "SYSTEM", listed(names, "or"));
  add_picture(*command, requests);
  add_frames(*command, requests, "Frames, in place of all");
  add(*command, "--chunk", requests.chunks, "N", "Frames of a task; by default as many as take some minutes");
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
  command->add_flag("--both-laws", requests.both_laws,
                    "The other law of growth beside the scene's (as where a pane has law = \"printed\")");
  add_threads(*command, requests);
}

void add_files(CLI::App& command, Requests& requests, const char* name, const std::string& sentence) {
  command.add_option(name, requests.files, sentence)->type_name("")->expected(1, static_cast<int>(most_files));
}

void add_trace(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand(
      "trace", "Find the cracks of broken panes in photographs: geometry, measures, and a picture of what was found");
  add_files(*command, requests, "PHOTO", "Photographs: JPEG, PNG, TIFF, OpenEXR and others");
  add_output(*command, requests);
  add(*command, "--pane-mm", requests.pane_sizes, "W,H", "Width and height of the pane");
  command
      ->add_option("--corners", requests.corners,
                   "Corners of the pane in the photograph, px: upper left, upper right, lower right, lower left")
      ->type_name("X,Y")
      ->expected(4)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add(*command, "--mm-per-px", requests.scales, "S", "Millimetres of a pixel, instead of the pane's size");
  add(*command, "--impact", requests.impacts, "X,Y", "Where the pane was hit, px; else it is found");
  add(*command, "--threshold", requests.thresholds, "N",
      "Level 0 to 255 that parts cracks from glass, with --chain paper; else it is found");
  add(*command, "--chain", requests.chains, "CHAIN", "robust (the default), or paper: that of Agui et al. 1992 alone");
  add(*command, "--polarity", requests.polarities, "POLARITY",
      "Cracks that are bright or dark against the glass, or both (the default)");
  add_threads(*command, requests);
}

void add_fit(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("fit", "Write a scene whose panes could be those that were traced");
  add_files(*command, requests, "TRACE.json", "Traced panes of one kind");
  add(*command, "-o", requests.outputs, "SCENE.toml", "The scene file");
  add_threads(*command, requests);
}

void add_serve(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand(
      "serve",
      "Show the scene in a browser while it is being worked on: at an address of this machine alone, which is printed");
  add(*command, "SCENE.toml", requests.scenes, "", "The scene file, which is watched");
  add(*command, "--port", requests.ports, "N", fmt::format("The port; default {}; 0 takes any that is free", default_port));
}

void add_keys(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("keys", "List every key of scene files: type, range, default, and what it does");
  command->add_flag("--json", requests.keys_as_json, "As JSON");
  command->add_flag("--markdown", requests.keys_as_markdown, "As the tables of docs/scene-file.md");
}

void add_manual(CLI::App& app, Requests& requests) {
  CLI::App* command = app.add_subcommand("manual", "Print the manual page, or what a shell completes this command by");
  add(*command, "--form", requests.manual_forms, "FORM", "man (the default), bash or zsh");
}

}  // namespace

std::vector<std::string_view> target_names() {
  std::vector<std::string_view> names;
  for (const exporting::Target* target : exporting::targets()) names.push_back(target->name);
  return names;
}

void add_commands(CLI::App& app, Requests& requests) {
  add_export(app, requests);
  add_check(app, requests);
  add_farm(app, requests);
  add_fit(app, requests);
  add_keys(app, requests);
  add_manual(app, requests);
  add_measure(app, requests);
  add_render(app, requests);
  add_serve(app, requests);
  add_trace(app, requests);
}

}  // namespace shatterpave::cli
