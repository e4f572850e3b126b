// Pictures of materials that were drawn before: they take longer than all else of a pavement, and stay the same while its
// stones change.
#pragma once

#include <cstdint>
#include <list>

#include "export/shapes/swatch.h"
#include "export/swatches/swatches.h"

namespace shatterpave::serve {

class SwatchStore {
 public:
  // As swatches::files of swatches::drawn; of one thread at a time.
  exporting::swatches::Files files(const exporting::shapes::Swatch& swatch, std::uint64_t seed);

 private:
  struct Entry {
    exporting::shapes::Swatch swatch;
    std::uint64_t seed = 0;
    exporting::swatches::Files files;
  };
  std::list<Entry> entries_;  // the one that was used last first
};

}  // namespace shatterpave::serve
