// Progress of long work, as the library reports it; the command decides what to show.
#pragma once

#include <functional>
#include <string_view>

namespace shatterpave {

// Called with what is being done and how much of it is, in [0, 1]. May be empty. Called from one thread at a time.
using Progress = std::function<void(std::string_view what, double done)>;

}  // namespace shatterpave
