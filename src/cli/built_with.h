// What the program was built with.
#pragma once

#include <string>

namespace shatterpave::cli {

// Lines: the version of the program, the compiler and its target, the libraries whose work shows in files.
std::string version_text();

}  // namespace shatterpave::cli
