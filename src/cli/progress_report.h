// What is told of long work in a log, where there is no terminal to draw a bar on.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace shatterpave::cli {

// A line from time to time: the first after ten seconds of work, so that short work leaves logs as they are, then one every
// twenty. May be called from several threads.
class ProgressReport {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  using Tell = std::function<void(const std::string& line)>;

  static constexpr std::chrono::seconds first{10};
  static constexpr std::chrono::seconds interval{20};

  // Work begins now.
  ProgressReport(Clock clock, Tell tell);

  // What is being done, and how much of it is, in [0, 1].
  void take(std::string_view what, double part);
  // Tells a line if it is time for one: "generating window: 40 %, 30 s".
  void tick();

 private:
  void tell_if_due();

  Clock clock_;
  Tell tell_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point next_;
  std::mutex mutex_;
  std::string what_;
  double part_ = 0.0;
};

}  // namespace shatterpave::cli
