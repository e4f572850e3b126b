// How progress is told.
#pragma once

namespace shatterpave::cli {

enum class ProgressForm {
  bar,       // drawn on a terminal; elsewhere as lines
  lines,     // a line for each frame; of other long work one from time to time
  openjd,    // lines that a worker of Open Job Description reads
  none,      // not at all
  automatic  // a bar on a terminal, lines elsewhere
};

}  // namespace shatterpave::cli
