/// \file
/// Which version of shatterpave this is. The build reads its own version from here.
#pragma once

/// Changes when scenes, files or programs that were right before may no longer be (see CONTRIBUTING.md, Versions).
#define SHATTERPAVE_VERSION_MAJOR 0
/// Changes when something is added; while the major number is 0, also when something is taken away.
#define SHATTERPAVE_VERSION_MINOR 3
/// Changes when faults are mended and nothing else.
#define SHATTERPAVE_VERSION_PATCH 0
/// "MAJOR.MINOR.PATCH"
#define SHATTERPAVE_VERSION "0.3.0"

namespace shatterpave {

/// The version of the library that the program runs with, "MAJOR.MINOR.PATCH": that of the header above unless the program was
/// compiled with another one.
const char* version();

}  // namespace shatterpave
