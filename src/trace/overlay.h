// Traced lines over the photograph they were traced on.
#pragma once

#include "relief/photograph.h"
#include "trace/trace.h"

namespace shatterpave::trace {

// The photograph, paler, with its cracks: radials that reach the edge red, others amber, branches magenta, rings blue.
relief::Photograph overlay(const relief::Photograph& photograph, const Trace& trace);

}  // namespace shatterpave::trace
