#include "core/cancel.h"

#include <atomic>
#include <utility>

namespace shatterpave {

namespace {

std::atomic<const Cancelled*> current{nullptr};

}  // namespace

CancelScope::CancelScope(Cancelled cancelled) : cancelled_(std::move(cancelled)), outer_(current.exchange(&cancelled_)) {}

CancelScope::~CancelScope() { current = outer_; }

void stop_if_cancelled() {
  const Cancelled* const cancelled = current;
  if (cancelled != nullptr && *cancelled && (*cancelled)()) throw Interrupted();
}

}  // namespace shatterpave
