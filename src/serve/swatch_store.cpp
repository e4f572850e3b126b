#include "serve/swatch_store.h"

#include <algorithm>

namespace shatterpave::serve {

namespace {

constexpr std::size_t most_kept = 12;  // of half a megabyte each, at the size that is shown here

}  // namespace

exporting::swatches::Files SwatchStore::files(const exporting::shapes::Swatch& swatch, std::uint64_t seed) {
  namespace swatches = exporting::swatches;
  const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.seed == seed && entry.swatch.name == swatch.name && exporting::shapes::are_alike(entry.swatch, swatch);
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.push_front({swatch, seed, swatches::files(swatches::drawn(swatch, seed), swatch.name)});
    if (entries_.size() > most_kept) entries_.pop_back();
  }
  return entries_.front().files;
}

}  // namespace shatterpave::serve
