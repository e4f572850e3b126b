#include "glass/pane.h"

std::size_t length(const Pane& pane) { return pane.title.size(); }
