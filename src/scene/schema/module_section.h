// The keys by which [[pavement]] takes the stones of a module from a drawing.
#pragma once

#include "paving/pavement.h"
#include "scene/schema/plan_section.h"

namespace shatterpave::scene {

// Gives `pavement`, whose other keys have been read, the stones that `module_file` and the keys beside it say
// (paving/bonds/module_cells.h), if its bond asks for them. Keys of another bond are checked, too.
//
// The drawing is an SVG, read as plans are, with its own scale, and closed shapes in it are stones: each subpath that is filled
// by itself is one. x runs to the right and y up; where on its page the drawing stands has no meaning.
void read_module(const TomlTable& table, Plans& plans, paving::Pavement& pavement);

}  // namespace shatterpave::scene
