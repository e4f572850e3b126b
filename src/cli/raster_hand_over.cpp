// In `shatterpave`: replaces itself with `shatterpave-rasters`, which lies in the same folder.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "cli/raster_jobs.h"

namespace shatterpave::cli {

namespace {

// With less than this much memory (`ulimit -v`), the 260 libraries cannot be loaded, or end the program by a signal as they
// begin, where nothing can be caught. Measured on Debian 12: 460 MiB do on two cores.
constexpr rlim_t least_memory_mib = 512;

void require_memory() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const rlim_t mib = limit.rlim_cur >> 20;
  if (mib >= least_memory_mib) return;
  throw std::runtime_error(fmt::format(
      "expected a limit on memory (ulimit -v) of at least {} MiB for work on pictures, got {} MiB", least_memory_mib, mib));
}

void hand_over(char** argv) {
  require_memory();
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
