// Jobs that read or write raster images.
//
// OpenImageIO draws in some 260 shared libraries, which take longer to load than most jobs to do. So the command is two
// programs made of one source: `shatterpave` is linked without them and does all but these jobs, in place of which it runs
// `shatterpave-rasters`. That stands beside it and can do everything.
#pragma once

#include "cli/arguments.h"

namespace shatterpave::cli {

// Does the job, or replaces this program with the one that does it, with the arguments `argv`.
void run_with_rasters(const Export& job, char** argv);
void run_with_rasters(const Check& job, char** argv);
void run_with_rasters(const Render& job, char** argv);
void run_with_rasters(const Trace& job, char** argv);
void run_with_rasters(const Farm& job, char** argv);
void run_with_rasters(const Serve& job, char** argv);

}  // namespace shatterpave::cli
