#include "pipeline/edition.h"

#include <shatterpave/version.h>

#include "core/sha256.h"

namespace shatterpave::pipeline {

Edition edition_of(const std::string& scene, std::string_view fingerprint, const std::string& kind) {
  Sha256 hash;
  hash.add_text(SHATTERPAVE_VERSION);
  hash.add_text(fingerprint);
  return {scene, kind, hash.sum()};
}

}  // namespace shatterpave::pipeline
