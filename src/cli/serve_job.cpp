// In `shatterpave-rasters`: the live view.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "cli/raster_jobs.h"
#include "cli/terminal.h"
#include "core/error.h"
#include "serve/draft_render.h"
#include "serve/live_view.h"
#include "serve/page.h"
#include "serve/server.h"

namespace shatterpave::cli {

void run_with_rasters(const Serve& job, char** /*argv*/) {
  if (!serve::has_page()) {
    throw std::runtime_error(
        "shatterpave: this build has no page to show, since three.js could not be had (see docs/serve.md)");
  }
  try {
    serve::clear_temporary_folder();
  } catch (const InputError&) {
    // Told when a draft is asked for.
  }
  const SignalNotes notes;
  serve::LiveView view(job.scene, std::filesystem::read_symlink("/proc/self/exe"));
  serve::Server server(view, job.port);
  print(fmt::format("http://127.0.0.1:{}/\n", server.port()));
  server.run(SignalNotes::received);
  // A renderer that runs is ended, and its folder taken away. Then all is done: nothing is waited for, neither slow clients nor
  // what is being made.
  constexpr std::chrono::milliseconds longest{2000};
  view.wait_for_draft(longest);
  std::_Exit(EXIT_SUCCESS);
}

}  // namespace shatterpave::cli
