#include "pipeline/render_frames.h"

#include <fmt/format.h>
#include <shatterpave/version.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/sha256.h"
#include "export/povray/povray.h"
#include "pipeline/folder_notes.h"
#include "pipeline/frame_folder.h"
#include "pipeline/frame_models.h"
#include "pipeline/povray_run.h"
#include "pipeline/shot_frames.h"
#include "pipeline/write.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view kind_of_frames = "frames";

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::int64_t own_memory_kib() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

// As large as is asked for, or else the camera's.
RenderOptions sized(RenderOptions options, const scene::Scene& scene) {
  if (options.width > 0 || !scene.camera || !scene.camera->size_px) return options;
  options.width = (*scene.camera->size_px)[0];
  options.height = (*scene.camera->size_px)[1];
  return options;
}

// Equal for runs that may write into one folder at once.
std::string state_of(const scene::Scene& still, const RenderOptions& options) {
  return fmt::format("{} {} {}x{}", shot_state(still), name_of(options.quality), options.width, options.height);
}

FrameOrigin origin_of(const scene::Scene& scene, int frame, const RenderOptions& options) {
  const PictureSize size = size_of(options);
  return {SHATTERPAVE_VERSION, scene.name, scene.fingerprint, scene.seed, frame, std::string(name_of(options.quality)),
          size.width,          size.height};
}

// Whether the frame is there, of that origin, with files of the sizes and sums that its sidecar names.
bool is_there(const FrameOrigin& origin, const fs::path& output) {
  std::ifstream stream(output / sidecar_name(origin.scene, origin.frame), std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  const std::optional<FrameRecord> record = record_of(text.str());
  if (!record || !(record->origin == origin)) return false;
  const std::vector<StagedFile> pictures = picture_files(frame_stem(origin.scene, origin.frame));
  if (record->files.size() != pictures.size()) return false;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const FrameFile& file = record->files[i];
    const fs::path path = output / pictures[i].name;
    std::error_code error;
    if (!fs::is_regular_file(path, error) || fs::file_size(path, error) != file.bytes || error) return false;
    if (sum_of(path) != file.sum) return false;
  }
  return true;
}

// Files of those names that another scene, or a still, has left are not written over.
void require_free(const scene::Scene& still, std::span<const int> frames, const fs::path& output) {
  std::error_code error;
  if (!fs::exists(output / notes_file, error)) return;
  const FolderLock lock(output);
  const FolderNotes notes = notes_of_text(lock.notes(), (output / notes_file).string());
  const Edition edition{still.name, std::string(kind_of_frames), {}};
  for (const int frame : frames) {
    for (const StagedFile& file : picture_files(frame_stem(still.name, frame))) {
      const NotedSet* const owner = owner_of(notes, edition, file.name, "");
      if (owner == nullptr || !fs::exists(output / file.name)) continue;
      throw InputError(
          Place{(output / file.name).string(), 0, 0, ""},
          fmt::format("expected no file of that name or a frame of the scene '{}', got one of the {} of the scene '{}' "
                      "(write into another folder, or remove the file)",
                      still.name, owner->edition.kind, owner->edition.scene));
    }
  }
}

// Renders frame after frame.
class FrameRenderer {
 public:
  FrameRenderer(scene::Shot& shot, const FramesOptions& options, const fs::path& output, const Progress& progress,
                const Cancelled& cancelled)
      : shot_(shot),
        options_(options),
        output_(output),
        progress_(progress),
        cancelled_(cancelled),
        folder_(output, {shot.still().name, shot.still().frames->range, state_of(shot.still(), options.render)}, cancelled) {}

  FrameOutcome frame(int frame) {
    const Clock::time_point begin = Clock::now();
    FrameOutcome outcome;
    outcome.frame = frame;
    const scene::Scene scene = shot_.at(frame);
    const RenderOptions options = sized(options_.render, scene);
    FrameRecord record{origin_of(scene, frame, options), {}, {}};
    const CancelScope scope([this] { return asked(); });
    outcome.is_skipped = options_.skip_existing && is_there(record.origin, output_);
    if (outcome.is_skipped) return outcome;

    const fs::path& place = folder_.workplace().folder();
    const std::string library = write_still(scene);
    const PovrayRun run = run_povray(place, options, library, progress_, [this] { return asked(); });
    const std::string stem = frame_stem(scene.name, frame);
    std::vector<StagedFile> files = staged_picture(place, stem);
    for (const StagedFile& file : files) record.files.push_back({file.name, fs::file_size(place / file.name), file.sum});
    record.cost = {seconds_since(begin), run.seconds, run.processor_seconds, std::max(run.most_memory_kib, own_memory_kib())};
    files.push_back({sidecar_name(scene.name, frame)});
    write_file(place / files.back().name, sidecar_text(record));
    folder_.publish(files, cancelled_);
    for (const StagedFile& file : files) outcome.paths.push_back(output_ / file.name);
    outcome.cost = record.cost;
    outcome.messages = run.messages;
    return outcome;
  }

 private:
  bool asked() {
    folder_.workplace().touch();
    return cancelled_ && cancelled_();
  }

  // What POV-Ray reads, into the workplace; returns where it finds the rest.
  std::string write_still(const scene::Scene& scene) {
    if (!changing_) changing_.emplace(shot_);
    const std::vector<std::string> sums = thing_sums(scene, pavement_parts(scene));
    const auto is_fixed = [&](std::size_t thing) { return changing_->is_fixed(sums, thing); };
    // First, since it is what takes long, and may be there.
    std::string library = folder_.shared(key_of(scene, sums, is_fixed), [&] {
      return exporting::povray::shared_files(models_.model(
                                                 scene, [](std::size_t) { return true; }, progress_),
                                             is_fixed);
    });
    const exporting::Model& model = models_.model(
        scene, [&](std::size_t thing) { return !is_fixed(thing); }, progress_);
    const fs::path& place = folder_.workplace().folder();
    std::vector<exporting::OutputFile> files = exporting::povray::frame_files(model, is_fixed);
    files.front().name = still_file;
    for (const exporting::OutputFile& file : files) write_file(place / file.name, file.content);
    return library;
  }

  // Of the files that this frame shares with others.
  static std::string key_of(const scene::Scene& scene, const std::vector<std::string>& sums,
                            const exporting::povray::IsShared& is_fixed) {
    constexpr std::size_t digits = 16;
    Sha256 hash;
    hash.add_text(SHATTERPAVE_VERSION);
    for (std::size_t i = 0; i < sums.size(); ++i) hash.add_text(is_fixed(i) ? sums[i] : "");
    for (const glass::Pane& pane : scene.panes) hash.add_text(pane.name);
    for (const PavementPart& part : pavement_parts(scene)) hash.add_text(part.pavement.name);
    hash.add_text(scene.still.setting + (scene.light ? " lit" : ""));
    if (scene.environment) hash.add_text(*scene.environment->content);
    return hash.sum().substr(0, digits);
  }

  scene::Shot& shot_;
  const FramesOptions& options_;
  const fs::path& output_;
  const Progress& progress_;
  const Cancelled& cancelled_;
  FrameFolder folder_;
  std::optional<ChangingThings> changing_;
  FrameModels models_;
};

}  // namespace

void render_frames(scene::Shot& shot, std::span<const int> frames, const FramesOptions& options, const fs::path& output,
                   const FrameDone& done, const Progress& progress, const Cancelled& cancelled) {
  require_output_folder(output);
  {
    const CancelScope scope(cancelled);
    require_frames(shot, frames);
  }
  require_free(shot.still(), frames, output);
  std::size_t count = 0;
  const auto all = static_cast<double>(frames.size());
  const Progress share = [&](std::string_view what, double part) {
    if (!progress || count == frames.size()) return;
    progress(fmt::format("frame {}: {}", frames[count], what), (static_cast<double>(count) + part) / all);
  };
  FrameRenderer renderer(shot, options, output, share, cancelled);
  for (const int frame : frames) {
    if (cancelled && cancelled()) throw Interrupted();
    FrameOutcome outcome = renderer.frame(frame);
    outcome.done = ++count;
    outcome.count = frames.size();
    done(outcome);
  }
}

}  // namespace shatterpave::pipeline
