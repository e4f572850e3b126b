// What an impact does to the glass about it, besides cracks.
#pragma once

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Whether impacts on the pane leave craters: in laminated glass, and in the real pattern.
bool makes_crater(const Pane& pane);

// The crushed zone is the circle of contact of a steel ball and the glass, by Hertz's law: its radius is R (5 π ρ V² / (4
// E))^(1/5), where all of the ball's energy is in the contact. Spall runs from there to the far side as a cone that opens by
// pane.crater_cone; in laminated glass the film stops it, and the glass about it is white.
Crater crater_of(const Impact& impact, const Pane& pane);

}  // namespace shatterpave::glass
