// Progress of long work, as the library reports it; the command decides what to show.
#pragma once

#include <functional>
#include <string_view>

namespace shatterpave {

// Called with the name of the work in progress and the fraction done, in [0, 1]; by one thread at a time. May be empty.
using Progress = std::function<void(std::string_view what, double done)>;

}  // namespace shatterpave
