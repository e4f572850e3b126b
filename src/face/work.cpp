#include "face/work.h"

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <string_view>

#include "core/error.h"
#include "core/parallel.h"

namespace shatterpave::face {

namespace {

constexpr int most_threads = 1024;

// Calls the user's callbacks where no exception may pass: keeps the first exception, and asks the work to stop.
class Callbacks {
 public:
  explicit Callbacks(const WorkOptions& options) : options_(options) {}

  void report(std::string_view what, double done) {
    guarded([&] { options_.progress(what, done); });
  }
  bool is_cancelled() {
    if (!failed_ && options_.cancelled) {
      guarded([&] {
        if (options_.cancelled()) asked_ = true;
      });
    }
    return failed_ || asked_;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void guarded(const std::function<void()>& call) {
    if (failed_) return;
    try {
      call();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failed_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  const WorkOptions& options_;
  std::atomic<bool> asked_{false};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void work_with(const WorkOptions& options, const std::function<void(const Progress&, const Cancelled&)>& work) {
  if (options.threads < 0 || options.threads > most_threads) {
    throw InputError(Place{{}, 0, 0, "threads"}, fmt::format("expected 0 to {}, got {}", most_threads, options.threads));
  }
  Callbacks callbacks(options);
  const Cancelled cancelled = [&] { return callbacks.is_cancelled(); };
  const Progress progress =
      options.progress ? Progress([&](std::string_view what, double done) { callbacks.report(what, done); }) : Progress();
  try {
    with_threads(options.threads, [&] {
      const CancelScope scope(cancelled);
      work(progress, cancelled);
    });
  } catch (const Interrupted&) {
    callbacks.rethrow();
    throw;
  }
  callbacks.rethrow();
}

}  // namespace shatterpave::face
