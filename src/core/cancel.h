// Work that can be asked to stop: it then throws Interrupted (shatterpave/error.h).
#pragma once

#include <shatterpave/error.h>

#include <functional>

namespace shatterpave {

// Tells, when asked from time to time on any thread, whether work shall stop; may be empty. A yes must stay a yes.
using Cancelled = std::function<bool()>;

// While this object lives, each `parallel_for` asks `cancelled` before each of its calls, and so does `stop_if_cancelled`.
// That holds for the work of the thread that made it, on whichever threads a `parallel_for` runs that work. Of nested scopes
// the innermost counts; scopes of different threads are independent.
class CancelScope {
 public:
  explicit CancelScope(Cancelled cancelled);
  ~CancelScope();
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;

 private:
  Cancelled cancelled_;
  const Cancelled* outer_;
};

// Throws Interrupted if a CancelScope of this thread wants its work stopped. For long loops outside of `parallel_for`.
void stop_if_cancelled();

// The question that this thread's innermost scope asks; null without one. For code that hands work over to other threads.
const Cancelled* current_cancelled();

// While this object lives, this thread works on behalf of the thread whose innermost scope asks `cancelled`.
class CancelHandOver {
 public:
  explicit CancelHandOver(const Cancelled* cancelled);
  ~CancelHandOver();
  CancelHandOver(const CancelHandOver&) = delete;
  CancelHandOver& operator=(const CancelHandOver&) = delete;

 private:
  const Cancelled* own_;
};

}  // namespace shatterpave
