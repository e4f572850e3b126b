// Camera, film, sampler and lights of a scene for Mitsuba.
#pragma once

#include "export/mitsuba/xml.h"
#include "export/shapes/stage.h"

namespace shatterpave::exporting::mitsuba {

// Values that may be set when a scene is rendered: mitsuba -Dspp=256 SCENE.xml.
void write_defaults(Xml& xml, const shapes::Stage& stage);
void write_camera(Xml& xml, const shapes::Stage& stage);
//   extent_mm  how far the things of the scene reach from the origin: the sun stands well beyond
void write_lights(Xml& xml, const shapes::Stage& stage, double extent_mm);

}  // namespace shatterpave::exporting::mitsuba
