// In `shatterpave`: replaces itself with `shatterpave-rasters`, which lies in the same folder.
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "cli/raster_jobs.h"

namespace shatterpave::cli {

namespace {

void hand_over(char** argv) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "shatterpave-rasters";
  ::execv(program.c_str(), argv);
  throw std::system_error(errno, std::generic_category(), "cannot run " + program.string());
}

}  // namespace

void run_with_rasters(const Export& /*job*/, char** argv) { hand_over(argv); }
void run_with_rasters(const Check& /*job*/, char** argv) { hand_over(argv); }
void run_with_rasters(const Render& /*job*/, char** argv) { hand_over(argv); }
void run_with_rasters(const Trace& /*job*/, char** argv) { hand_over(argv); }
void run_with_rasters(const Farm& /*job*/, char** argv) { hand_over(argv); }
void run_with_rasters(const Serve& /*job*/, char** argv) { hand_over(argv); }

}  // namespace shatterpave::cli
