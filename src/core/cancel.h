// Work that can be asked to stop: it then throws Interrupted (shatterpave/error.h).
#pragma once

#include <shatterpave/error.h>

#include <functional>

namespace shatterpave {

// Asked from time to time, on any thread, whether work shall stop; may be empty. Once it says yes it must go on saying so.
using Cancelled = std::function<bool()>;

// While it lives, `cancelled` is asked before each call that a `parallel_for` makes, and by `stop_if_cancelled`, for the work
// of the thread that made it, on whichever threads a `parallel_for` does that. The innermost counts. Scopes of several threads
// know nothing of one another.
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

// Throws Interrupted if a CancelScope lives and its work shall stop. For loops that take long and are no `parallel_for`.
void stop_if_cancelled();

// What the innermost scope of this thread asks; null where there is none. For who hands work over to other threads.
const Cancelled* current_cancelled();

// While it lives, this thread works for the thread that `cancelled` is the current one of.
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
