// Loops in parallel; no other file uses threads. Each slot has one writer, and no result depends on the number of threads.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace shatterpave {

// While it lives, every `parallel_for` uses at most that many threads; 0: as many as there are processors.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

// Runs `work`, in which every `parallel_for` uses at most that many threads, and no more than there are; 0: one a processor.
// Unlike a ThreadLimit this has no effect on other threads of the program. Rethrows an exception of `work`.
void with_threads(int threads, const std::function<void()>& work);

// Calls `body(i)` for every i in [0, count), in any order, on any thread. `body` may write only to slots of its own i.
// Rethrows an exception of a call. Throws Interrupted, between calls, if a CancelScope asks for it (core/cancel.h).
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
