// The command: arguments, messages, exit status. The only catch-all, and the only stream to the terminal.
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "cli/arguments.h"
#include "core/error.h"
#include "core/parallel.h"
#include "export/json/geometry_json.h"
#include "export/measures/measures.h"
#include "export/povray/povray.h"
#include "export/svg/drawing_svg.h"
#include "pipeline/generate.h"
#include "pipeline/measure.h"
#include "pipeline/render.h"
#include "pipeline/write.h"
#include "scene/read_scene.h"

namespace {

using namespace shatterpave;

enum ExitStatus { done = 0, program_failed = 1, input_wrong = 2, renderer_failed = 3 };

volatile std::sig_atomic_t signal_received = 0;

extern "C" void note_signal(int signal) { signal_received = signal; }

// While it lives, signals that end the program only leave a note, so that what is being written can be taken back.
class SignalNotes {
 public:
  SignalNotes() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      // A signal that is ignored, as under nohup, stays ignored.
      if (std::signal(signal, note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
  }
  static bool received() { return signal_received != 0; }
};

void print(std::FILE* stream, std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream) != text.size() || std::fflush(stream) != 0) {
    if (stream == stdout) throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
  }
}

// A bar on a terminal; nothing elsewhere.
class ProgressBar {
 public:
  ~ProgressBar() {
    if (shown_) print(stderr, "\r\x1b[K");
  }
  void show(std::string_view what, double part) {
    if (!terminal_) return;
    constexpr int width = 30;
    const int full = static_cast<int>(part * width);
    print(stderr, fmt::format("\r\x1b[K[{:#>{}}{:.>{}}] {:3.0f}% {}", "", full, "", width - full, 100.0 * part, what));
    shown_ = true;
  }
  Progress progress() {
    return [this](std::string_view what, double part) { show(what, part); };
  }

 private:
  bool terminal_ = ::isatty(STDERR_FILENO) == 1;
  bool shown_ = false;
};

std::vector<exporting::OutputFile> files_of(const exporting::Model& model, const std::vector<cli::Target>& targets) {
  std::vector<exporting::OutputFile> files;
  const auto add = [&](std::vector<exporting::OutputFile> more) {
    for (exporting::OutputFile& file : more) files.push_back(std::move(file));
  };
  for (const cli::Target target : targets) {
    if (target == cli::Target::povray) add(exporting::povray::povray_files(model));
    if (target == cli::Target::json) add({exporting::json_file(model)});
    if (target == cli::Target::svg) add(exporting::svg_files(model));
  }
  return files;
}

void print_paths(const std::vector<std::filesystem::path>& paths) {
  std::string lines;
  for (const std::filesystem::path& path : paths) lines += path.string() + "\n";
  print(stdout, lines);
}

void run(const cli::Export& job) {
  const ThreadLimit limit(job.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  pipeline::require_output_folder(job.output);
  std::vector<exporting::OutputFile> files;
  {
    ProgressBar bar;
    files = files_of(pipeline::generated(scene, bar.progress()), job.targets);
  }
  const SignalNotes notes;
  print_paths(pipeline::written(files, job.output, SignalNotes::received));
}

void run(const cli::Check& job) { static_cast<void>(scene::scene_of_file(job.scene, job.overrides)); }

void run(const cli::Render& job) {
  const ThreadLimit limit(job.options.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  pipeline::require_output_folder(job.output);
  pipeline::Picture picture;
  {
    ProgressBar bar;
    const exporting::Model model = pipeline::generated(scene, bar.progress());
    const SignalNotes notes;
    picture = pipeline::rendered(model, job.options, job.output, bar.progress(), SignalNotes::received);
  }
  print(stderr, picture.messages);
  print_paths(picture.files);
}

void run(const cli::Measure& job) {
  const ThreadLimit limit(job.threads);
  const scene::Scene scene = scene::scene_of_file(job.scene, job.overrides);
  pipeline::require_output_folder(job.output);
  std::vector<exporting::OutputFile> files;
  {
    ProgressBar bar;
    files = exporting::measures_files(pipeline::surveyed(scene, job.options, bar.progress()));
  }
  if (!exporting::has_plots()) {
    print(stderr, "shatterpave: the report was left out, since this build has no plotting library (see docs/measure.md)\n");
  }
  const SignalNotes notes;
  print_paths(pipeline::written(files, job.output, SignalNotes::received));
}

void run(const cli::Show& show) { print(stdout, show.text); }

// Ends as the signal would have ended it, so that a shell sees what happened.
int end_by_signal() {
  std::signal(signal_received, SIG_DFL);
  std::raise(signal_received);
  return 128 + signal_received;
}

int failed(ExitStatus status, std::string_view message) {
  std::fwrite(message.data(), 1, message.size(), stderr);
  std::fputc('\n', stderr);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::visit([](const auto& job) { run(job); }, cli::command_of(argc, argv));
    return done;
  } catch (const InputError& error) {
    return failed(input_wrong, error.what());
  } catch (const pipeline::RendererError& error) {
    return failed(renderer_failed, error.what());
  } catch (const pipeline::Interrupted&) {
    return end_by_signal();
  } catch (const std::bad_alloc&) {
    return failed(program_failed, "shatterpave: out of memory");
  } catch (const std::exception& error) {
    return failed(program_failed, fmt::format("shatterpave: {}", error.what()));
  }
}
