// What is laid where a pavement is asked for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// A pavement that is laid as it stands: its `flight` is empty, and its `kerb`, if any, is a part of its own.
struct Part {
  Pavement pavement;
  StonePart stones = StonePart::field;  // what its stones are of; field: the bond, or the course along the border

  bool is_kerb() const { return stones == StonePart::kerb; }
};

// The name of the `number`-th part, from 1 on, of what is called `name`: NAME, NAME_2, NAME_3 …
std::string part_name(const std::string& name, std::size_t number);

// The parts of `pavement`: itself, or the steps of its flight from the first on; then its kerb, if it has one. They are named
// by `part_name` from `first_number` on, kerbs by `kerb_name`, without a number of their own.
//   REQUIRES a flight has no kerb; what `steps` requires
std::vector<Part> parts(const Pavement& pavement, std::size_t first_number = 1);

}  // namespace shatterpave::paving
