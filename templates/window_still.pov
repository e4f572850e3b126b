#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings { assumed_gamma 1.0 max_trace_level 16 adc_bailout 1 / 255 }
//@model
#declare Low = Still_Pane_Min[0];
#declare High = Still_Pane_Max[0];
camera { location (Low + High) / 2 - z * 1.3 * (High.y - Low.y) look_at (Low + High) / 2 angle 50 }
sky_sphere { pigment { gradient y color_map { [0 rgb 0.1] [0.5 rgb <0.1, 0.1, 0.15>] [0.5 rgb <1, 0.8, 0.6>] [1 rgb <0.3, 0.5, 0.8>] } scale 2 translate -1 } }
light_source { <-3000, 4000, 8000>, rgb 1.5 }
light_source { <-3000, 4000, -8000>, rgb 0.5 }
#local I = 0;
#while (I < Still_Pane_Count) object { Still_Pane(I) } #local I = I + 1; #end
