// Work that can be asked to stop.
#pragma once

#include <functional>
#include <stdexcept>

namespace shatterpave {

// Asked from time to time, on any thread, whether work shall stop; may be empty. Once it says yes it must go on saying so.
using Cancelled = std::function<bool()>;

// Thrown where work stopped because it was asked to. Whatever it had written is gone.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// While it lives, `cancelled` is asked before each call that a `parallel_for` makes, and by `stop_if_cancelled`. The innermost
// counts.
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

}  // namespace shatterpave
