#include "core/cancel.h"

#include <utility>

namespace shatterpave {

namespace {

thread_local const Cancelled* current = nullptr;

}  // namespace

CancelScope::CancelScope(Cancelled cancelled) : cancelled_(std::move(cancelled)), outer_(std::exchange(current, &cancelled_)) {}

CancelScope::~CancelScope() { current = outer_; }

void stop_if_cancelled() {
  if (current != nullptr && *current && (*current)()) throw Interrupted();
}

const Cancelled* current_cancelled() { return current; }

CancelHandOver::CancelHandOver(const Cancelled* cancelled) : own_(std::exchange(current, cancelled)) {}

CancelHandOver::~CancelHandOver() { current = own_; }

}  // namespace shatterpave
