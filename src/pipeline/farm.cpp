// Each task is safe to be done again: frames that are there are skipped, so a job that is requeued, resumed or sent twice
// renders what is missing. What is booked follows from one small frame in draft quality, with factors that are stated here.
#include "pipeline/farm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "scene/frame_range.h"

namespace shatterpave::pipeline {

namespace {

// What a frame of final quality takes of a draft of the same size, in processor time. Measured: 8.2 (scenes/stone_path.toml,
// 320 × 240); more where glass lies behind glass.
constexpr double final_factor = 10.0;
// Other nodes are slower, and other frames show more: by eye.
constexpr double time_margin = 2.0;
constexpr double memory_margin = 1.5;
constexpr double pixel_bytes = 128.0;  // POV-Ray's and our picture, and the files made of it
constexpr int measured_width = 320;
constexpr std::int64_t least_task_seconds = 300;
constexpr double usual_task_seconds = 300.0;
constexpr int most_usual_chunk = 20;
constexpr std::int64_t memory_step_mib = 256;
constexpr int notify_seconds = 60;      // between TERM and KILL: the program ends within one
constexpr int slurm_array_size = 1001;  // its MaxArraySize, where a site has not set it: indices are below

std::int64_t rounded_up(double value, std::int64_t step) {
  return static_cast<std::int64_t>(std::ceil(value / static_cast<double>(step))) * step;
}

double pixels_of(const PictureSize& size) { return static_cast<double>(size.width) * static_cast<double>(size.height); }

// For a shell.
std::string shell_word(std::string_view word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

// What follows `render SCENE -o DIR --frames RANGE`, but for threads and progress.
std::vector<std::string> settings_of(const FarmJob& job) {
  std::vector<std::string> words = {"--quality", std::string(name_of(job.options.quality))};
  if (job.options.width > 0) {
    words.insert(words.end(), {"--size", fmt::format("{}x{}", job.options.width, job.options.height)});
  }
  for (const scene::Override& change : job.overrides) words.insert(words.end(), {"--set", change.key + "=" + change.value});
  words.emplace_back("--skip-existing");
  return words;
}

std::string shell_settings(const FarmJob& job) {
  std::string text;
  for (const std::string& word : settings_of(job)) text += " " + (word.starts_with("--") ? word : shell_word(word));
  return text;
}

void require_plain(const std::string& name, const std::string& text, std::string_view without) {
  const auto is_plain = [&](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && without.find(c) == std::string_view::npos;
  };
  if (std::ranges::all_of(text, is_plain)) return;
  throw InputError(fmt::format("shatterpave: farm: expected a {} without control characters{}, got one with", name,
                               without.empty() ? std::string() : fmt::format(" and {}", without)));
}

std::string clock_text(std::int64_t seconds) {
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string slurm_text(const FarmJob& job, const FarmNeeds& needs) {
  require_plain("name of the scene and output folder", job.scene + job.output, "\"\\");
  const std::vector<std::string> chunks = farm_chunks(job.frames, needs.chunk);
  // A task's number is its frame's, where that can be.
  const bool by_frame = needs.chunk == 1 && job.frames.back() < slurm_array_size;
  std::string log = fmt::format("{}/{}", job.output, job.scene);
  for (std::size_t at = log.find('%'); at != std::string::npos; at = log.find('%', at + 2)) log.insert(at, 1, '%');
  std::string text = fmt::format(
      R"(#!/bin/bash
# Frames {range} of the scene {scene}, as a job array of Slurm: run `sbatch` on this file from the folder that the paths start at.
# A task that is requeued, or sent again, renders what is missing. SHATTERPAVE names the program where it is not in PATH.
#SBATCH --job-name="{scene}"
#SBATCH --array={array}
#SBATCH --cpus-per-task={threads}
#SBATCH --mem={memory}M
#SBATCH --time={time}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@{notify}
#SBATCH --output="{log}.%A_%a.log"
)",
      fmt::arg("range", scene::range_text(job.frames)), fmt::arg("scene", job.scene),
      fmt::arg("array", by_frame ? scene::range_text(job.frames) : fmt::format("0-{}", chunks.size() - 1)),
      fmt::arg("threads", needs.threads), fmt::arg("memory", needs.memory_mib),
      fmt::arg("time", clock_text(needs.task_seconds)), fmt::arg("notify", notify_seconds), fmt::arg("log", log));
  if (by_frame) {
    text += "frames=$SLURM_ARRAY_TASK_ID\n";
  } else {
    text += fmt::format("chunks=({})\nframes=${{chunks[SLURM_ARRAY_TASK_ID]}}\n", fmt::join(chunks, " "));
  }
  return text + fmt::format(
                    "exec \"${{SHATTERPAVE:-shatterpave}}\" render {} -o {} --frames \"$frames\"{} --threads "
                    "\"${{SLURM_CPUS_PER_TASK:-{}}}\" --progress lines\n",
                    shell_word(job.scene_file), shell_word(job.output), shell_settings(job), needs.threads);
}

std::string parallel_text(const FarmJob& job, const FarmNeeds& needs) {
  return fmt::format(
      R"(#!/bin/bash
# Frames {range} of the scene {scene}, by GNU parallel: run this file by `bash` from the folder that the paths start at, also to go on
# where it was stopped. SHATTERPAVE names the program where it is not in PATH, JOBS how many run at once.
exec parallel --quote --joblog {joblog} --resume-failed --jobs "${{JOBS:-$((($(nproc) + {threads} - 1) / {threads}))}}" \
  --memfree {memory}M --termseq TERM,5000,KILL \
  "${{SHATTERPAVE:-shatterpave}}" render {file} -o {output} --frames {{}}{settings} --threads {threads} --progress lines \
  ::: {chunks}
)",
      fmt::arg("range", scene::range_text(job.frames)), fmt::arg("scene", job.scene),
      fmt::arg("joblog", shell_word(fmt::format("{}/{}.joblog", job.output, job.scene))), fmt::arg("memory", needs.memory_mib),
      fmt::arg("threads", needs.threads), fmt::arg("file", shell_word(job.scene_file)),
      fmt::arg("output", shell_word(job.output)), fmt::arg("settings", shell_settings(job)),
      fmt::arg("chunks", fmt::join(farm_chunks(job.frames, needs.chunk), " ")));
}

// For YAML, of which JSON's texts are a part; `{{` would begin an expression of the template.
std::string template_text(const std::string& text) {
  if (text.find("{{") != std::string::npos) {
    throw InputError(
        "shatterpave: farm: expected a job without {{, which Open Job Description takes for its own, got one with");
  }
  return nlohmann::json(text).dump(-1, ' ', true);
}

// The same within a text.
std::string inner_text(const std::string& text) {
  const std::string whole = template_text(text);
  return whole.substr(1, whole.size() - 2);
}

std::string openjd_text(const FarmJob& job, const FarmNeeds& needs) {
  std::string settings;
  for (const std::string& word : settings_of(job)) settings += fmt::format("            - {}\n", template_text(word));
  return fmt::format(
      R"(# Frames of the scene {plain}, for Open Job Description with task chunking: openjd check, openjd run, Deadline Cloud.
# The paths of scene and output are the job's parameters; a task that is done again renders what is missing.
specificationVersion: "jobtemplate-2023-09"
extensions: ["TASK_CHUNKING"]
name: {name}
parameterDefinitions:
  - {{name: Scene, type: PATH, objectType: FILE, dataFlow: IN, description: "The scene file, {file}"}}
  - {{name: Output, type: PATH, objectType: DIRECTORY, dataFlow: OUT, description: "Where frames go to, {output}"}}
  - {{name: Frames, type: STRING, default: {range}}}
  - {{name: Program, type: STRING, default: "shatterpave", description: "The program, where it is not in PATH"}}
steps:
  - name: Render
    hostRequirements:
      amounts:
        - {{name: amount.worker.vcpu, min: {threads}}}
        - {{name: amount.worker.memory, min: {memory}}}
    parameterSpace:
      taskParameterDefinitions:
        - name: Frame
          type: "CHUNK[INT]"
          range: "{{{{Param.Frames}}}}"
          chunks: {{defaultTaskCount: {chunk}, rangeConstraint: CONTIGUOUS}}
    script:
      actions:
        onRun:
          command: "{{{{Param.Program}}}}"
          args:
            - render
            - "{{{{Param.Scene}}}}"
            - -o
            - "{{{{Param.Output}}}}"
            - --frames
            - "{{{{Task.Param.Frame}}}}"
{settings}            - --threads
            - "{threads}"
            - --progress
            - openjd
          timeout: {time}
          cancelation: {{mode: NOTIFY_THEN_TERMINATE, notifyPeriodInSeconds: {notify}}}
)",
      fmt::arg("plain", job.scene), fmt::arg("name", template_text(job.scene)), fmt::arg("file", inner_text(job.scene_file)),
      fmt::arg("output", inner_text(job.output)), fmt::arg("range", template_text(scene::range_text(job.frames))),
      fmt::arg("threads", needs.threads), fmt::arg("memory", needs.memory_mib), fmt::arg("chunk", needs.chunk),
      fmt::arg("settings", settings), fmt::arg("time", needs.task_seconds), fmt::arg("notify", notify_seconds));
}

}  // namespace

RenderOptions measured_options(const RenderOptions& options) {
  RenderOptions measured = options;
  measured.quality = Quality::draft;
  const PictureSize size = size_of(options);
  measured.width = std::min(size.width, measured_width);
  measured.height = std::max(1, static_cast<int>(std::lround(static_cast<double>(size.height) * measured.width / size.width)));
  return measured;
}

FarmNeeds farm_needs(const FarmJob& job, const MeasuredFrame& measured, int chunk) {
  constexpr double bytes_of_mib = 1024.0 * 1024.0;
  const PictureSize size = size_of(job.options);
  const double pixels = pixels_of(size) / pixels_of(measured.size);
  const double quality = job.options.quality == Quality::final ? final_factor : 1.0;
  FarmNeeds needs;
  needs.threads = job.options.threads > 0 ? job.options.threads : usual_threads;
  // All beside the renderer's run is taken for what a task does once, which it is but for the files of the picture.
  needs.start_seconds = measured.cost.seconds - measured.cost.renderer_seconds;
  needs.frame_seconds = measured.cost.renderer_cpu_seconds * std::max(1.0, pixels) * quality / needs.threads;
  const double fitting = usual_task_seconds / std::max(needs.frame_seconds, 1e-3);
  const int usual = static_cast<int>(std::clamp(fitting, 1.0, static_cast<double>(most_usual_chunk)));
  needs.chunk = std::min(chunk > 0 ? chunk : usual, static_cast<int>(job.frames.size()));
  const double task = time_margin * (needs.start_seconds + needs.chunk * needs.frame_seconds);
  needs.task_seconds = std::max(least_task_seconds, rounded_up(task, 60));
  const double memory = static_cast<double>(measured.cost.most_memory_kib) / 1024.0 +
                        pixel_bytes * std::max(0.0, pixels_of(size) - pixels_of(measured.size)) / bytes_of_mib;
  needs.memory_mib = rounded_up(memory_margin * memory, memory_step_mib);
  return needs;
}

std::vector<std::string> farm_chunks(const std::vector<int>& frames, int chunk) {
  std::vector<std::string> chunks;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t end = i + 1;
    while (end < frames.size() && end - i < static_cast<std::size_t>(chunk) && frames[end] == frames[end - 1] + 1) ++end;
    chunks.push_back(scene::range_text(std::span(frames).subspan(i, end - i)));
    i = end;
  }
  return chunks;
}

exporting::OutputFile farm_file(FarmSystem system, const FarmJob& job, const FarmNeeds& needs) {
  require_plain("name of the scene", job.scene, "");
  switch (system) {
    case FarmSystem::slurm:
      return {job.scene + ".slurm.sh", slurm_text(job, needs)};
    case FarmSystem::openjd:
      return {job.scene + ".openjd.yaml", openjd_text(job, needs)};
    case FarmSystem::parallel:
      break;
  }
  return {job.scene + ".parallel.sh", parallel_text(job, needs)};
}

}  // namespace shatterpave::pipeline
