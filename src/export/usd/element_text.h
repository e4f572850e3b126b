// The elements of a pane or a pavement as prims.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "export/shapes/body.h"
#include "export/usd/prim_text.h"

namespace shatterpave::exporting::usd {

// Where the elements of a thing stand in the layer.
struct ThingPlace {
  std::string path;                                // of its prim, such as "/scene/geometry/window"
  std::size_t depth = 0;                           // of its children
  const std::vector<shapes::Material>* materials;  // of the model; not null
  int first_frame = 1;                             // of paths
};

// The operations that place a prim: first turned, then moved.
void put_placing(PrimText& text, const shapes::Placing& placing);

// The placing at each frame from the first on, as time samples: nothing where the prim is not seen. `is_seen` is of the still.
void put_path(PrimText& text, const std::vector<std::optional<shapes::Placing>>& path, int first_frame, bool is_seen);

// What a body is called below its thing: "slab", "shard_c12l3", "crack_4", "stone_17", "joints" …
std::string element_name(const shapes::Body& body);

// A prim for the body: a mesh with a GeomSubset for each of its pieces where they are several, or, where bodies share a mesh,
// an instance of its prototype. Nothing where the body has no facet.
std::string element_text(const shapes::Body& body, const ThingPlace& place);

// What instances of the body's mesh refer to, below `PLACE/prototypes`.
//   REQUIRES body.shared, with its pieces
std::string prototype_text(const shapes::Body& body, const ThingPlace& place);

}  // namespace shatterpave::exporting::usd
