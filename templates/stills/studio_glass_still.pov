// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A studio for glass: the first pane stands before a dark board with a pale grid, in light that grazes it from behind,
//       so that the cracks stand out and one sees how the glass bends what lies behind it, and nothing else.
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

// A little from the left and from above, so that the thickness of the pane is seen. The whole pane fits the height.
//@camera <0, 0, 0>, <0, 0, 0>
camera {
   location Middle + Size * <-0.35, 0.25, -2.0>
   right x * image_width / image_height
   up y
   direction z * 1.75
   look_at Middle
}
//@end

//@light <0, 0, 0>
background { rgb <0.02, 0.022, 0.025> }
light_source { Middle + Size * <-4, 3, -1.2>, rgb <2.6, 2.5, 2.3> parallel point_at Middle }
light_source { Middle + Size * <5, 2, 3>, rgb <1.6, 1.8, 2.1> parallel point_at Middle }
light_source { Middle + Size * <0, 6, 1>, rgb 1.2 parallel point_at Middle }
//@end

// Lines a fiftieth of the spacing wide would fall between pixels; a tenth shows at any size.
plane {
   -z, -(High.z + Size * 0.3)
   pigment {
      gradient x
      pigment_map {
         [0.9 gradient y color_map { [0.9 rgb 0.012] [0.9 rgb 0.10] }]
         [0.9 rgb 0.10]
      }
      scale Size / 8
   }
   finish { ambient 0 diffuse 0.9 }
}

object { Still_Pane(0) }
