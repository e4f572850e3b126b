// The keys of a [[pavement]], one row each.
#pragma once

#include "core/angle.h"
#include "paving/pavement.h"
#include "scene/schema/pavement_facts.h"
#include "scene/schema/row.h"

namespace shatterpave::scene {

// [pavement.direction] as it stands in the file, but for its guides.
struct DirectionAsked {
  enum class Kind { constant, boundary, radial, guides, grid };
  Kind kind = Kind::constant;
  Angle angle;
  vec2 centre_mm{0.0, 0.0};
};

// [pavement.size] as it stands in the file, but for its lines and its map.
struct SizeAsked {
  enum class Kind { edge, line, map };
  Kind kind = Kind::edge;
  paving::SizeRamp ramp;
  double dark = 1.0;
  double light = 1.0;
};

// One of the [[pavement.colour]].
struct ColourAsked {
  vec3 srgb{0.5, 0.5, 0.5};
  double share = 1.0;
};

extern const Section<paving::Pavement, PavementFacts> pavement_keys;
extern const Section<DirectionAsked, PavementFacts> direction_keys;
extern const Section<SizeAsked, PavementFacts> size_keys;
extern const Section<paving::Pavement, PavementFacts> surface_keys;
extern const Section<paving::CellShape, PavementFacts> cell_keys;
extern const Section<paving::Variation, PavementFacts> variation_keys;
extern const Section<paving::Pavement, PavementFacts> hand_keys;
extern const Section<ColourAsked, PavementFacts> colour_keys;
extern const Section<paving::Relief, PavementFacts> relief_keys;
extern const Section<paving::TextureSet, PavementFacts> textures_keys;
extern const Section<paving::Pavement, PavementFacts> ground_keys;
extern const Section<paving::Flight, PavementFacts> steps_keys;
extern const Section<paving::Detail, PavementFacts> detail_keys;

}  // namespace shatterpave::scene
