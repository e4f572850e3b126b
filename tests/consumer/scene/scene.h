// The consumer's own.
#pragma once

#include "core/error.h"

static_assert(consumer_has_its_own_error);

// A scene of a play.
struct Scene {
  int acts = 3;
};
