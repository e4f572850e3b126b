// The pavements that a scene asks for, as they are laid. Check, export, measure and the summary take them from here.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/error.h"
#include "paving/pavement.h"
#include "paving/stones.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

struct PavementPart {
  paving::Pavement pavement;                            // of a name that nothing else in the scene has
  std::size_t asked = 0;                                // index of the scene's pavement that it is a part of
  paving::StonePart stones = paving::StonePart::field;  // as in paving::Part

  bool is_kerb() const { return stones == paving::StonePart::kerb; }
};

// The parts (paving/derived/parts.h) of all pavements of the scene, in order. Those of one name, which are the areas of one
// table, are numbered in succession.
// Throws InputError if two things of the scene get the same name, or if there are more than `paving::most_pavements` parts,
// kerbs aside.
std::vector<PavementPart> pavement_parts(const scene::Scene& scene);

// Where the key of a member of the part stands; what is wrong with a kerb is wrong with the key that asks for it. Without a
// file the place is NAME.MEMBER alone.
Place place_of(const scene::Scene& scene, const PavementPart& part, std::string_view member);

// Does `work` on the part. An InputError of a room that knows no file leaves as one at its place in the scene file.
void with_places(const scene::Scene& scene, const PavementPart& part, const std::function<void()>& work);

}  // namespace shatterpave::pipeline
