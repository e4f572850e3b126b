#include "cli/progress_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shatterpave::cli {

ProgressReport::ProgressReport(Clock clock, Tell tell)
    : clock_(std::move(clock)), tell_(std::move(tell)), begin_(clock_()), next_(begin_ + first) {}

void ProgressReport::take(std::string_view what, double part) {
  const std::scoped_lock lock(mutex_);
  what_ = what;
  part_ = std::clamp(part, 0.0, 1.0);
  tell_if_due();
}

void ProgressReport::tick() {
  const std::scoped_lock lock(mutex_);
  tell_if_due();
}

void ProgressReport::tell_if_due() {
  const auto now = clock_();
  if (now < next_ || what_.empty()) return;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  tell_(fmt::format("{}: {:.0f} %, {:.0f} s\n", what_, std::floor(100.0 * part_), std::floor(seconds)));
  next_ = now + interval;
}

}  // namespace shatterpave::cli
