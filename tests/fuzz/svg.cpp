// Plans as SVG, with the areas, lines and points that a scene takes of them.
#include "tests/fuzz/plan_areas_of.h"

SHATTERPAVE_FUZZ(text) { shatterpave::fuzz::take_areas(shatterpave::scene::plan_of_svg(text, "a.svg")); }
