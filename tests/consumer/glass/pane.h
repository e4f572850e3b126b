// The consumer's own.
#pragma once

#include <cstddef>
#include <string>

// A pane of a window on a screen.
struct Pane {
  std::string title;
};

std::size_t length(const Pane& pane);
