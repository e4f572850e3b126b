// In `shatterpave-rasters`: photographs into cracks.
#include <fmt/format.h>
#include <shatterpave/version.h>

#include <set>
#include <string>
#include <vector>

#include "cli/raster_jobs.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/sha256.h"
#include "pipeline/outlook.h"
#include "pipeline/write.h"
#include "relief/photograph.h"
#include "report/trace_files.h"
#include "trace/overlay.h"

namespace shatterpave::cli {

namespace {

// The stem of the photograph's file, which names what is written of it.
std::string name_of(const std::filesystem::path& photograph, std::set<std::string>& names) {
  std::string name = photograph.stem().string();
  const auto refuse = [&](const std::string& expected, const std::string& got) {
    throw InputError(Place{photograph.string(), 0, 0, ""}, fmt::format("expected {}, got {}", expected, got));
  };
  const bool plain =
      !name.empty() && name.find_first_of("\"\\<>&") == std::string::npos && name.find_first_not_of(' ') != std::string::npos;
  if (!plain) refuse("a file name without quotes, backslashes, '<', '>' and '&'", "another one");
  if (!names.insert(name).second)
    refuse("photographs of different names", "two that would both be written to " + name + ".json");
  return name;
}

trace::Trace traced_at(const std::filesystem::path& file, const trace::Grey& grey, const trace::Options& options) {
  try {
    return trace::traced(grey, options);
  } catch (const InputError& error) {
    throw InputError(Place{file.string(), 0, 0, ""}, error.message());
  }
}

// What may be a slip of the user's, and would change figures without a word.
void tell_doubts(const std::filesystem::path& file, const relief::Photograph& photograph, const trace::Options& options) {
  const vec2 size_px{photograph.width, photograph.height};
  constexpr double stretched = 1.05;  // by eye: panes are cropped so far off
  if (options.pane_mm && !options.corners_px) {
    const vec2 pixel_mm = *options.pane_mm / size_px;
    const double ratio = std::max(pixel_mm.x / pixel_mm.y, pixel_mm.y / pixel_mm.x);
    if (ratio > stretched) {
      tell(
          fmt::format("note: {}: {} x {} px are taken for a pane of {} x {} mm, drawn out by {:.2f} to 1 (give --corners where "
                      "the pane is a part of the picture)\n",
                      file.string(), photograph.width, photograph.height, options.pane_mm->x, options.pane_mm->y, ratio));
    }
  }
  if (!options.corners_px) return;
  for (const vec2& corner : *options.corners_px) {
    if (corner.x >= 0.0 && corner.y >= 0.0 && corner.x <= size_px.x && corner.y <= size_px.y) continue;
    tell(fmt::format("note: {}: the corner {},{} lies outside of the picture of {} x {} px: no crack is seen there\n",
                     file.string(), corner.x, corner.y, photograph.width, photograph.height));
  }
}

}  // namespace

void run_with_rasters(const Trace& job, char** /*argv*/) {
  const ThreadLimit limit(job.threads);
  pipeline::require_output_folder(job.output);
  std::set<std::string> names;
  for (const std::filesystem::path& file : job.photographs) name_of(file, names);
  names.clear();
  Sha256 hash;
  hash.add_text(SHATTERPAVE_VERSION);
  hash.add_text(job.words);
  std::vector<reporting::TracedPane> panes;
  std::vector<exporting::OutputFile> files;
  {
    ProgressBar bar;
    const Progress progress = bar.progress();
    for (std::size_t i = 0; i < job.photographs.size(); ++i) {
      const std::filesystem::path& file = job.photographs[i];
      progress("tracing " + file.filename().string(), static_cast<double>(i) / static_cast<double>(job.photographs.size()));
      const relief::Photograph photograph = relief::read_photograph(file.string());
      hash.add_text({reinterpret_cast<const char*>(photograph.rgb.data()), photograph.rgb.size()});
      trace::Grey grey(photograph.width, photograph.height);
      grey.values = relief::grey_levels(photograph);
      panes.push_back({name_of(file, names), traced_at(file, grey, job.options), photograph.width, photograph.height});
      tell_doubts(file, photograph, job.options);
      const reporting::TracedPane& pane = panes.back();
      if (pane.trace.size_was_assumed) {
        tell(fmt::format("note: {}: the pane's longer side is taken for 300 mm (give --pane-mm or --mm-per-px)\n",
                         file.string()));
      }
      files.push_back(reporting::trace_json(pane));
      files.push_back({pane.name + "-traced.png", relief::encoded_png(trace::overlay(photograph, pane.trace))});
      files.push_back(reporting::trace_csv(pane));
    }
    files.push_back(reporting::trace_report(panes));
  }
  const SignalNotes notes;
  const pipeline::Edition edition{panes.front().name, "trace", hash.sum()};
  report(pipeline::written(files, edition, job.output, SignalNotes::received), edition, job.output);
}

}  // namespace shatterpave::cli
