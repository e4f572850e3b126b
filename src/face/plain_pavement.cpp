#include "face/plain_pavement.h"

#include <cmath>

#include "core/error.h"
#include "face/plain.h"

namespace shatterpave::face {

namespace {

// As the files give it: the bits below that are not the same on every processor.
double plain_degrees(Angle angle) { return std::round(angle.degrees() * 1e6) / 1e6 + 0.0; }

}  // namespace

StoneKind plain(paving::StoneKind kind) {
  switch (kind) {
    case paving::StoneKind::whole:
      return StoneKind::whole;
    case paving::StoneKind::cut:
      return StoneKind::cut;
  }
  throw_broken_invariant("a kind of stone", __FILE_NAME__, __LINE__);
}

StonePart plain(paving::StonePart part) {
  switch (part) {
    case paving::StonePart::field:
      return StonePart::field;
    case paving::StonePart::border:
      return StonePart::border;
    case paving::StonePart::kerb:
      return StonePart::kerb;
    case paving::StonePart::step:
      return StonePart::step;
  }
  throw_broken_invariant("a part of a pavement", __FILE_NAME__, __LINE__);
}

Pavement plain(const exporting::PavedArea& paved) {
  Pavement pavement{paved.pavement.name, plain(paved.pavement.area), {}};
  pavement.stones.reserve(paved.layout.stones.size());
  for (const paving::Stone& stone : paved.layout.stones) {
    pavement.stones.push_back(
        {stone.id, plain(stone.kind), plain(stone.part), plain(stone.outline_mm), plain_degrees(stone.angle)});
  }
  return pavement;
}

}  // namespace shatterpave::face
