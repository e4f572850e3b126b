// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A studio for stone: the whole of the first pavement from above, in low light from one side, so that the eye judges
//       joints, edges, crowns and grain, and nothing else.
//
// Reads, where they are declared before:
//    Quality   makes no difference here

#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }

//@model

#local Low = Still_Pavement_Min[0];
#local High = Still_Pavement_Max[0];
#local Middle = (Low + High) / 2;
#local Size = max(High.x - Low.x, (High.z - Low.z) * image_width / image_height);

// From straight above, and far off, so that all stones are seen alike.
//@camera <0, 0, 0>, <0, 0, 0>
camera {
   orthographic
   location <Middle.x, Size * 2, Middle.z>
   direction -y
   up z * Size * 1.06 * image_height / image_width
   right x * Size * 1.06
}
//@end

//@light <0, 0, 0>
background { rgb <0.35, 0.38, 0.42> }
light_source { <Middle.x, 0, Middle.z> + Size * <-5, 3.2, 4>, rgb <1.9, 1.75, 1.5> parallel point_at <Middle.x, 0, Middle.z> }
light_source { <Middle.x, 0, Middle.z> + Size * <2, 6, -3>, rgb <0.5, 0.55, 0.65> parallel point_at <Middle.x, 0, Middle.z> shadowless }
//@end

plane { y, Low.y - 1 pigment { rgb <0.10, 0.11, 0.10> } finish { ambient 0 diffuse 0.9 } }

object { Still_Pavement(0) }
object { Still_Pavement_Bed(0) }
