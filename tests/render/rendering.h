// From a case, or one of its near misses, to its picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "relief/raster.h"
#include "render/case.h"

namespace shatterpave::render_tests {

// Exports the scene of the case with the library, changed as `miss` says if there is one, into the empty folder `folder`,
// and renders it. `seed` replaces the scene's.
relief::Raster picture(const Case& of, const NearMiss* miss, std::optional<std::uint64_t> seed,
                       const std::filesystem::path& folder);

}  // namespace shatterpave::render_tests
