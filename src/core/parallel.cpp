#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/background.h"
#include "core/cancel.h"
#include "core/error.h"

namespace shatterpave {

namespace {

#ifdef __SANITIZE_THREAD__

// ThreadSanitizer cannot see into Debian's oneTBB and would report the passing of tasks as races. Under it plain threads do
// the work instead, so that the bodies of loops are still checked.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::mutex failing;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::scoped_lock lock(failing);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

void within_arena(int /*threads*/, const std::function<void()>& work) { work(); }

#else

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body) {
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { body(i); });
}

void within_arena(int threads, const std::function<void()>& work) {
  // Asked for more threads than it has, oneTBB would write a warning to the terminal.
  const std::size_t most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(threads > 0 ? static_cast<int>(std::min(most, static_cast<std::size_t>(threads)))
                                    : tbb::task_arena::automatic);
  arena.execute(work);
}

#endif

}  // namespace

ThreadLimit::ThreadLimit(int threads)
    : control_(new tbb::global_control(
          tbb::global_control::max_allowed_parallelism,
          threads > 0 ? static_cast<std::size_t>(threads) : std::max<std::size_t>(1, std::thread::hardware_concurrency()))) {}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

void with_threads(int threads, const std::function<void()>& work) {
  within_arena(threads, [&, cancelled = current_cancelled()] {
    const CancelHandOver hand_over(cancelled);
    work();
  });
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  for_each_index(count, [&, cancelled = current_cancelled()](std::size_t i) {
    const CancelHandOver hand_over(cancelled);
    stop_if_cancelled();
    body(i);
  });
}

void parallel_for_chunks(std::size_t count, std::size_t chunk, const std::function<void(std::size_t, std::size_t)>& body) {
  ENSURE(chunk > 0);
  const std::size_t chunks = (count + chunk - 1) / chunk;
  parallel_for(chunks, [&](std::size_t i) { body(i * chunk, std::min(count, (i + 1) * chunk)); });
}

class Heartbeat::Thread {
 public:
  Thread(std::chrono::milliseconds interval, std::function<void()> beat)
      : thread_([this, interval, beat = std::move(beat)](const std::stop_token& stopped) {
          std::unique_lock lock(mutex_);
          while (!waiting_.wait_for(lock, stopped, interval, [&] { return stopped.stop_requested(); })) beat();
        }) {}

 private:
  std::mutex mutex_;
  std::condition_variable_any waiting_;
  std::jthread thread_;  // declared last, so that it ends before the members that it uses
};

Heartbeat::Heartbeat(std::chrono::milliseconds interval, std::function<void()> beat)
    : thread_(std::make_unique<Thread>(interval, std::move(beat))) {}

Heartbeat::~Heartbeat() = default;

class Background::Thread {
 public:
  explicit Thread(std::function<void(const std::stop_token&)> work)
      : thread_([work = std::move(work)](const std::stop_token& stopped) { work(stopped); }) {}

 private:
  std::jthread thread_;
};

Background::Background(std::function<void(const std::stop_token&)> work) : thread_(std::make_unique<Thread>(std::move(work))) {}
Background::~Background() = default;

}  // namespace shatterpave
