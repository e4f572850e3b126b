#include "pipeline/povray_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string_view>
#include <thread>

#include "core/error.h"
#include "core/sha256.h"
#include "pipeline/subprocess.h"
#include "pipeline/write.h"
#include "relief/raster.h"

namespace shatterpave::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view picture_file = "still-povray.exr";
constexpr int most_povray_threads = 512;

// What POV-Ray writes, sorted: progress, and messages.
class PovrayOutput {
 public:
  explicit PovrayOutput(const Progress& progress) : progress_(progress) {}

  void take(std::string_view text) {
    for (const char c : text) {
      if (c == '\n' || c == '\r') {
        take_line();
        line_.clear();
      } else if (line_.size() < 2000) {
        line_ += c;
      }
    }
  }

  // Without the banner, section heads and progress.
  const std::vector<std::string>& messages() const { return messages_; }
  const std::vector<std::string>& banner() const { return banner_; }

 private:
  void take_line() {
    if (line_.starts_with("==== [")) {
      started_ = true;
    } else if (!started_) {
      if (!line_.empty()) banner_.push_back(line_);
    } else if (line_.starts_with("Rendered ")) {
      show_progress();
    } else if (is_message()) {
      messages_.push_back(line_);
    }
  }

  // Not the frame of the output, nor "Parsing 1024K tokens" and "Photon count 1024", which are progress.
  bool is_message() const {
    const bool parsing = line_.starts_with("Parsing ") && line_.ends_with("K tokens");
    return !line_.empty() && !parsing && !line_.starts_with("Photon count ") && !line_.starts_with("----") &&
           line_ != "POV-Ray finished" && line_ != "Render failed";
  }

  // Rendered 1024 of 1080000 pixels (0%)
  void show_progress() {
    double done = 0.0;
    double all = 0.0;
    const std::string_view line = line_;
    const std::size_t of = line.find(" of ");
    if (!progress_ || of == std::string_view::npos) return;
    std::from_chars(line.data() + 9, line.data() + of, done);
    std::from_chars(line.data() + of + 4, line.data() + line.size(), all);
    if (all > 0.0) progress_("rendering", std::min(1.0, done / all));
  }

  const Progress& progress_;
  std::string line_;
  bool started_ = false;
  std::vector<std::string> messages_;
  std::vector<std::string> banner_;
};

// Every option that shows in the picture, so that no ini file of the user or the machine does: POV-Ray reads those first, and
// its command line wins.
std::vector<std::string> povray_arguments(const RenderOptions& options, const std::string& library) {
  const bool final = options.quality == Quality::final;
  const PictureSize size = size_of(options);
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = std::clamp(options.threads > 0 ? options.threads : processors, 1, most_povray_threads);
  std::vector<std::string> arguments = {
      "povray",
      fmt::format("+I{}", still_file),
      fmt::format("+O{}", picture_file),
      "+FE",  // OpenEXR
      "File_Gamma=1.0",
      "-UA",  // no alpha channel
      "Dither=off",
      fmt::format("+W{}", size.width),
      fmt::format("+H{}", size.height),
      "+SR1",
      "+SC1",
      fmt::format("+ER{}", size.height),
      fmt::format("+EC{}", size.width),
      fmt::format("+WT{}", threads),
      "+Q9",
      final ? "+A0.1" : "+A0.3",  // a draft leaves faint edges alone
      final ? "+AM2" : "+AM1",
      final ? "+R3" : "+R2",
      "Antialias_Gamma=2.5",
      "-J",  // jitter is random
      "+MB1",
      "+BM1",
      "-UR",
      "-SU",
      "+KFI1",
      "+KFF1",
      "-KC",
      "+K0.0",  // no animation
      "-C",
      "-D",
      "-P",
      "-UD",
      "+V",
      "-GD",
      "-GR",
      "-GS",
      "+GF",
      "+GW",
      "Create_Ini=off",
      "Version=3.7",
      fmt::format("Declare=Quality={}", final ? 1 : 0),
  };
  if (!library.empty()) arguments.insert(arguments.begin() + 1, "+L" + library);
  return arguments;
}

std::string joined(const std::vector<std::string>& lines, std::size_t last) {
  std::string text;
  for (std::size_t i = lines.size() - std::min(last, lines.size()); i < lines.size(); ++i) text += lines[i] + "\n";
  return text;
}

[[noreturn]] void throw_renderer_error(const Ending& ending, const PovrayOutput& output) {
  if (!ending.found) throw RendererError("POV-Ray was not found: expected the program povray (Debian package povray) in PATH");
  const std::string what = ending.signal != 0   ? fmt::format("POV-Ray was ended by signal {}", ending.signal)
                           : ending.status != 0 ? fmt::format("POV-Ray failed with status {}", ending.status)
                                                : std::string("POV-Ray left no picture");
  constexpr std::size_t last_lines = 12;
  std::string text = what + ":\n" + joined(output.messages().empty() ? output.banner() : output.messages(), last_lines);
  text.pop_back();
  throw RendererError(text);
}

relief::Raster read_picture(const fs::path& file) {
  try {
    return relief::read_raster(file.string());
  } catch (const InputError& error) {
    throw RendererError(fmt::format("POV-Ray left a picture that is not whole: {}", error.what()));
  }
}

}  // namespace

PovrayRun run_povray(const fs::path& folder, const RenderOptions& options, const std::string& library, const Progress& progress,
                     const Cancelled& cancelled) {
  const auto begin = std::chrono::steady_clock::now();
  fs::remove(folder / picture_file);  // of the frame before
  PovrayOutput messages(progress);
  if (progress) progress("rendering", 0.0);
  // HOME holds the user's povray.ini; POVINI would name another.
  const Subprocess povray{povray_arguments(options, library), folder, {"HOME=" + folder.string()}, {"POVINI"}};
  const Ending ending = run(
      povray, [&](std::string_view text) { messages.take(text); }, cancelled);
  if (!ending.found || ending.status != 0 || ending.signal != 0 || !fs::exists(folder / picture_file)) {
    throw_renderer_error(ending, messages);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return {joined(messages.messages(), messages.messages().size()), seconds.count(), ending.processor_seconds,
          ending.most_memory_kib};
}

std::vector<StagedFile> picture_files(const std::string& stem) { return {{stem + ".exr"}, {stem + ".png"}}; }

std::vector<StagedFile> staged_picture(const fs::path& folder, const std::string& stem) {
  const relief::Raster picture = read_picture(folder / picture_file);
  std::vector<StagedFile> files = picture_files(stem);
  for (StagedFile& file : files) {
    const bool exr = &file == files.data();
    const std::string content = exr ? relief::encoded(picture, relief::RasterFormat::exr_half)
                                    : relief::encoded(relief::display(picture), relief::RasterFormat::png8);
    write_file(folder / file.name, content);
    file.sum = sha256(content);
  }
  return files;
}

}  // namespace shatterpave::pipeline
