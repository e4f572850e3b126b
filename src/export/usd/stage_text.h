// Camera and light as prims.
#pragma once

#include "export/shapes/stage.h"
#include "export/usd/prim_text.h"

namespace shatterpave::exporting::usd {

// A Camera "camera" with lens and focus, and a Scope "lights" with a DomeLight "environment", whose picture lies beside the
// layer, and a DistantLight "sun" where there is one. Where the camera moves, that is in time samples, from the first frame on.
void put_stage(PrimText& text, const shapes::Stage& stage, int first_frame = 1);

// Where the scene says how large the picture is: a RenderSettings "settings" with that and the camera at the path.
void put_render_settings(PrimText& text, const shapes::Stage& stage, const std::string& camera_path);

}  // namespace shatterpave::exporting::usd
