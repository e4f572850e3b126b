// The one file with threads. One writer per slot; the number of threads must not show in any result.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace shatterpave {

// Limits the threads of every `parallel_for` while it lives; 0 takes all processors.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

// Does `work`, whose every `parallel_for` takes at most that many threads, and at most those that there are; 0 takes all
// processors. Unlike with a ThreadLimit, other threads of the program have their own. An exception of `work` is thrown here.
void with_threads(int threads, const std::function<void()>& work);

// Calls `body(i)` for every i in [0, count), in any order, on any thread. `body` may write only to slots of its own i.
// An exception of a call is thrown here. Throws Interrupted, between calls, where a CancelScope says so (core/cancel.h).
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

// As above for whole chunks [begin, end): for cheap bodies. Chunks are fixed, `chunk` long.
void parallel_for_chunks(std::size_t count, std::size_t chunk,
                         const std::function<void(std::size_t begin, std::size_t end)>& body);

// Calls `beat` on a thread of its own every `interval` while it lives. `beat` must not throw.
class Heartbeat {
 public:
  Heartbeat(std::chrono::milliseconds interval, std::function<void()> beat);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace shatterpave
