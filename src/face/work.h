// Callbacks and threads of the public functions.
#pragma once

#include <shatterpave/generate.h>

#include <functional>

#include "core/cancel.h"
#include "core/progress.h"

namespace shatterpave::face {

// Does `work` with the options' threads, within a CancelScope of its `cancelled`. An exception of either callback stops the
// work and leaves this. Throws InputError for options out of their range.
void work_with(const WorkOptions& options, const std::function<void(const Progress&, const Cancelled&)>& work);

}  // namespace shatterpave::face
