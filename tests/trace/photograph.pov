// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A photograph of a broken pane "window" whose cracks are known, for tests of tracing. The pane fills the picture where it is
//       seen from straight ahead.
//
// Reads, where they are declared before (as by Declare=Ground=1 on the command line):
//    Ground    0 a black board in a bright room: bright cracks; 1 a white board in a dark room: dark cracks; 2 an evening out of
//              focus: both
//    Tilt      degrees by which the camera looks from the left, and half of it from above; then all of the pane and some of its
//              surroundings are in view
#version 3.7;
#ifndef(Ground) #declare Ground = 0; #end
#ifndef(Tilt) #declare Tilt = 0; #end
global_settings { assumed_gamma 1.0 max_trace_level 12 adc_bailout 1 / 255 }

#include "window.inc"
#include "shatterpave_evening.inc"

#declare Size = window_Max - window_Min;
#declare Middle = (window_Max + window_Min) / 2;
#declare Emitting = finish { ambient 0 diffuse 0 emission 1 }

// Light that comes straight through the glass is that of a board behind it; what cracks bend comes from all around.
#switch (Ground)
#case (0)
   sky_sphere { pigment { rgb 0.9 } }
   box { <-0.9, -0.9, 0> * Size.x, <0.9, 0.9, 0.01> * Size.x pigment { rgb 0 } finish { Emitting } translate Middle + z * Size.x }
#break
#case (1)
   sky_sphere { pigment { rgb 0.03 } }
   box { <-0.9, -0.9, 0> * Size.x, <0.9, 0.9, 0.01> * Size.x pigment { rgb 0.85 } finish { Emitting } translate Middle + z * Size.x }
#break
#else
   sky_sphere { Shatterpave_Evening }
   light_source { Shatterpave_Evening_Sun * 100000, rgb <1.9, 1.15, 0.62> }
#end

object { window_Pane }

// From straight ahead the pane's width is that of the picture; a tilted camera sees a tenth more.
#declare Away = 4 * Size.x;
#declare Wide = Size.x * (Tilt = 0 ? 1 : 1.16);
camera {
   location Middle + vrotate(<0, 0, -Away>, <Tilt / 2, Tilt, 0>)
   right x * image_width / image_height
   up y
   angle 2 * degrees(atan2(Wide / 2, Away))
   look_at Middle
}
