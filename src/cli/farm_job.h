// The job of `farm`.
#pragma once

#include "cli/arguments.h"

namespace shatterpave::cli {

// Measures a frame and writes the job file.
void write_farm_job(const Farm& job);

}  // namespace shatterpave::cli
