// Surfaces of single stones of a pavement, as they lie there.
#pragma once

#include <shatterpave/pavement.h>

#include <cstddef>
#include <cstdint>

#include "export/model.h"
#include "paving/surface/laid_surface.h"
#include "relief/height_field.h"

namespace shatterpave::face {

class StoneMaker {
 public:
  // The pavement must outlive this.
  StoneMaker(const exporting::PavedArea& paved, std::uint64_t seed);

  // The mesh of a stone by its index, without relief where `relief` says so. Any thread may call it.
  StoneMesh mesh(std::size_t stone, const StoneMeshOptions& options) const;

 private:
  const exporting::PavedArea& paved_;
  paving::LaidSurface surface_;
  relief::HeightField relief_;  // empty where there is none
  double relief_side_mm_ = 1.0;
};

}  // namespace shatterpave::face
