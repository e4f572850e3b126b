// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A studio for glass: the first pane stands before a chequered board in even light, so that the eye judges the cracks
//       and how the glass bends what lies behind it, and nothing else.
//
// Reads, where they are declared before:
//    Quality   makes no difference here

#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 16 adc_bailout 1/255 }

//@model

#local Low = Still_Pane_Min[0];
#local High = Still_Pane_Max[0];
#local Middle = (Low + High) / 2;
#local Size = max(High.x - Low.x, High.y - Low.y);

// A little from the left and from above, so that the thickness of the pane is seen.
camera {
   location Middle + Size * <-0.35, 0.25, -2.0>
   right x * image_width / image_height
   angle 2 * degrees(atan2(0.62, 2.0)) * max(1, image_width / image_height)
   look_at Middle
}

background { rgb <0.35, 0.38, 0.42> }
light_source { Middle + Size * <-3, 4, -5>, rgb 0.9 parallel point_at Middle }
light_source { Middle + Size * <4, 1, -4>, rgb 0.35 parallel point_at Middle shadowless }

// The board, and so what is refracted: dark and light fields a tenth of the pane wide, behind the pane.
plane {
   -z, -(High.z + Size * 0.25)
   pigment { checker rgb <0.62, 0.60, 0.55>, rgb <0.16, 0.20, 0.26> scale Size / 10 translate Middle }
   finish { ambient 0 diffuse 0.9 }
}

object { Still_Pane(0) }
