// All that there is to see of a model, as bodies.
#pragma once

#include <functional>
#include <vector>

#include "export/model.h"
#include "export/shapes/body.h"

namespace shatterpave::exporting::shapes {

// Those of glass, which all panes have in common, and for each pavement those of its stones by tone, of its joints and of
// water.
struct Materials {
  std::vector<Material> all;
  static constexpr std::size_t of_glass = 0;  // where there are panes: glass, broken_glass, crushed_glass
  std::vector<std::size_t> of_pavement;       // the first of each pavement: stone_materials, then joint, water
  std::vector<Swatch> swatches;               // that they use; pavements which look alike share theirs
};
Materials materials_of(const Model& model);

// Meshes take some 8 KB a stone: of so many 4 GB.
inline constexpr double most_stones = 500'000.0;
// Throws InputError where a scene has more, as far as its areas tell.
void require_few_stones(const Things& things);

// Told before the bodies of each pane and pavement; may be null.
using BeginThing = std::function<void(const std::string& name, bool is_pane)>;
using TakeBody = std::function<void(Body&& body)>;

// Hands over the bodies of all things, in the order of the model, and within a thing in the order of its elements: never all at
// once, since a pavement may have many. Bodies are made in parallel, and are the same for any number of threads. Throws
// InputError where the stones are more than `most_stones`.
void for_each_body(const Model& model, const Materials& materials, const BeginThing& begin, const TakeBody& take);

}  // namespace shatterpave::exporting::shapes
