// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: Broken panes in wooden sashes, seen from a dim room, before an evening over a lake. The sun behind lights the cracks.
//       Frame and camera follow the size of the panes, whatever their outlines; several stand side by side.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: lights without extent; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
// 14 levels: two faces of the slab, and those of three tubes behind one another with their inner reflections.
global_settings { assumed_gamma 1.0 max_trace_level 14 adc_bailout 1 / 255 }

#include "shatterpave_evening.inc"
//@model

// ---- sizes, from those of the panes

#declare Panes_Width = 0;
#declare Panes_Height = 0;
#for (I, 0, Still_Pane_Count - 1)
   #declare Panes_Width = Panes_Width + Still_Pane_Max[I].x - Still_Pane_Min[I].x;
   #declare Panes_Height = max(Panes_Height, Still_Pane_Max[I].y - Still_Pane_Min[I].y);
#end
#declare Bar = 0.085 * min(Panes_Height, Panes_Width / Still_Pane_Count);   // width of a sash's wood
#declare Lip = 0.10 * Bar;                                               // of it, what overlaps the glass
#declare Step = 0.35 * Bar;                                              // between two sashes
#declare Row_Width = Panes_Width + Still_Pane_Count * 2 * Bar + (Still_Pane_Count - 1) * Step;
#declare Row_Height = Panes_Height + 2 * Bar;

// ---- wood

#macro Wood(Shift)
   texture {
      pigment {
         wood
         turbulence 0.06
         omega 0.6
         octaves 4
         color_map {
            [0.0 rgb <0.150, 0.070, 0.032>]
            [0.5 rgb <0.235, 0.118, 0.056>]
            [0.8 rgb <0.180, 0.085, 0.040>]
            [1.0 rgb <0.090, 0.040, 0.018>]
         }
         scale <0.16, 0.16, 1> * Bar
         rotate <1.6, 90 + 1.1, 0>
         translate Shift * Bar
      }
      normal { granite 0.12 scale <6, 0.25, 0.5> * Bar }
      finish { ambient 0 diffuse 0.85 specular 0.35 roughness 0.03 reflection { 0.0, 0.12 fresnel on } conserve_energy }
   }
   interior { ior 1.45 }
#end

// A bar from -Length / 2 to Length / 2 along x, its outer side at y = 0 and its lip below; both ends mitred.
#macro Mitred_Bar(Length, Shift)
   intersection {
      prism {
         linear_sweep linear_spline -Length, Length, 15,
         <0, -0.50>, <-0.95, -0.50>, <-1.00, -0.44>, <-1.00, -0.30>, <-1.30, -0.10>, <-1.34, -0.10>, <-1.34, 0.10>,
         <-1.30, 0.12>, <-1.14, 0.20>, <-1.03, 0.31>, <-0.99, 0.42>, <-0.95, 0.42>, <-0.86, 0.50>, <0, 0.50>, <0, -0.50>
         scale <(1 + Lip / Bar) / 1.34, 1 / Bar, 0.75>
         matrix <0, 1, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0>
         scale Bar
      }
      plane { vnormalize(<1, -1, 0>), 0 translate x * Length / 2 }
      plane { vnormalize(<-1, -1, 0>), 0 translate -x * Length / 2 }
      Wood(Shift)
   }
#end

// A sash about the opening from Low to High.
#macro Sash(Low, High)
   #local Wide = High.x - Low.x + 2 * Bar;
   #local Tall = High.y - Low.y + 2 * Bar;
   union {
      object { Mitred_Bar(Wide, <3.1, 0.23, 0.4>) translate y * Tall / 2 }
      object { Mitred_Bar(Wide, <7.7, 0.61, 0.1>) rotate 180 * z translate -y * Tall / 2 }
      object { Mitred_Bar(Tall, <1.9, 0.37, 0.7>) rotate 90 * z translate -x * Wide / 2 }
      object { Mitred_Bar(Tall, <5.3, 0.83, 0.2>) rotate -90 * z translate x * Wide / 2 }
      translate (Low + High) / 2 * <1, 1, 0>
   }
#end

// ---- panes in their sashes, from left to right, about the origin

#declare Left = -Row_Width / 2;
#for (I, 0, Still_Pane_Count - 1)
   #declare Low = Still_Pane_Min[I];
   #declare High = Still_Pane_Max[I];
   union {
      object { Still_Pane(I) }
      object { Sash(Low, High) }
      #if (!Still_Pane_Rectangular[I])
         object { Still_Pane_Surround(I, Bar / 2, High.z - Low.z + Bar / 4) Wood(<2.3, 0.5, 0.9>) }
      #end
      translate <Left + Bar - Low.x, -(Low.y + High.y) / 2, 0>
   }
   // A lower sash stands between two boards.
   #declare Top = (High.y - Low.y) / 2 + Bar;
   #if (Top < 0.999 * Row_Height / 2)
      #for (J, 0, 1)
         box {
            <Left, Top, -0.25 * Bar>, <Left + High.x - Low.x + 2 * Bar, Row_Height / 2, 0.25 * Bar>
            scale <1, 1 - 2 * J, 1>
            Wood(<3.3, 0.2 + 0.4 * J, 0.6>)
         }
      #end
   #end
   #declare Left = Left + High.x - Low.x + 2 * Bar + Step;
#end

// ---- the opening in the wall: casing, posts between sashes, sill, plaster

#declare Wall =
texture {
   pigment { bozo color_map { [0 rgb <0.36, 0.40, 0.40>] [1 rgb <0.42, 0.46, 0.45>] } scale Bar * 3 }
   normal { granite 0.08 scale Bar * 1.5 }
   finish { ambient 0 diffuse 0.8 }
}
#declare Reveal = 1.1 * Bar;
#declare Half = <Row_Width, Row_Height, 0> / 2;
union {
   #for (I, 0, 1)
      box { <Half.x, -Half.y - Bar, -Reveal>, <Half.x + 40 * Bar, Half.y + 40 * Bar, 0.2 * Bar> rotate 180 * I * y translate -z * 0.9 * Bar * I }
   #end
   box { <-Half.x - 40 * Bar, Half.y, -Reveal>, <Half.x + 40 * Bar, Half.y + 40 * Bar, 0.2 * Bar> }
   box { <-Half.x - 40 * Bar, -Half.y - 40 * Bar, -Reveal>, <Half.x + 40 * Bar, -Half.y - 0.34 * Bar, 0.2 * Bar> }
   texture { Wall }
}
box {
   <-Half.x - 0.5 * Bar, -Half.y - 0.34 * Bar, -2.0 * Bar>, <Half.x + 0.5 * Bar, -Half.y, 0.4 * Bar>
   Wood(<4.1, 0.44, 0.3>)
}
#for (I, 1, Still_Pane_Count - 1)
   #declare Post = -Row_Width / 2;
   #for (J, 0, I - 1)
      #declare Post = Post + Still_Pane_Max[J].x - Still_Pane_Min[J].x + 2 * Bar + (J > 0) * Step;
   #end
   box { <Post, -Half.y, -0.3 * Bar>, <Post + Step, Half.y, 0.3 * Bar> Wood(<6.1, 0.3, 0.1>) }
#end

// ---- pavements lie outside, below the window

#declare Far = 3 * Row_Height;
#for (I, 0, Still_Pavement_Count - 1)
   #declare Low = Still_Pavement_Min[I];
   #declare High = Still_Pavement_Max[I];
   object {
      Still_Pavement(I)
      translate <-(Low.x + High.x) / 2, -Row_Height, Far - Low.z>
   }
   #declare Far = Far + High.z - Low.z + Bar;
#end

// ---- light: the sun, warm and low; the evening sky; a lamp in the room

//@light <0, 0, 0>
sky_sphere { Shatterpave_Evening }
//@end

#declare Size = max(Row_Width, Row_Height);

#macro Soft_Light(Place, Colour, Extent)
   light_source {
      Place, Colour
      #if (Quality > 0)
         area_light x * Extent, y * Extent, 3, 3 adaptive 0 circular orient
      #end
   }
#end

//@light
light_source { Shatterpave_Evening_Sun * 1000 * Size, rgb <1.9, 1.15, 0.62> }
Soft_Light(<-1.6, 0.9, -1.7> * Size, rgb <0.55, 0.42, 0.30>, 0.4 * Size)
light_source { <0.9, 0.6, -2.5> * Size, rgb <0.17, 0.18, 0.22> shadowless }
light_source { <-0.3, 1.2, 1.5> * Size, rgb <0.28, 0.34, 0.44> shadowless }
//@end

// ---- camera: a little to the left, all sashes and the sill in view

#declare Angle = 34;
#declare Aspect = image_width / image_height;
#declare View_Width = max(Row_Width + 1.1 * Bar, (Row_Height + 1.3 * Bar) * Aspect);
#declare Distance = View_Width / 2 / tan(radians(Angle / 2));
#declare Centre = <0, -0.12 * Bar, 0>;
//@camera <-Row_Width / 2 + Bar - Still_Pane_Min[0].x, -(Still_Pane_Min[0].y + Still_Pane_Max[0].y) / 2, 0>, <0, 0, 0>
camera {
   location Centre + vnormalize(<-0.20, 0.055, -1>) * Distance
   right x * Aspect
   up y
   angle Angle
   look_at Centre
}
//@end
