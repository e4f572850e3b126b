// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A window of an old house, seen from within on a bright morning: somebody has thrown a stone. Shards stand in the white
//       sash, others lie on the oak sill, where the stone has come to lie. Frame, sill and camera follow the size of the panes and
//       where their shards fell; several panes stand side by side.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: lights without extent; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
// 16 levels: two faces of a shard and its bevels, then what lies behind it on the sill.
global_settings { assumed_gamma 1.0 max_trace_level 16 adc_bailout 1 / 255 }

#include "functions.inc"
#include "shatterpave_shards.inc"
#declare Shatterpave_Shard_Old = texture { Shatterpave_Shard_Dusty }
//@model

// ---- sizes; where nothing fell, as if it had

#ifndef(Still_Pane_Sill_Drop)
   #declare Still_Pane_Sill_Drop = array[Still_Pane_Count];
   #declare Still_Pane_Sill_Depth = array[Still_Pane_Count];
   #declare Still_Pane_Frame = array[Still_Pane_Count];
   #declare Still_Pane_Reveal = array[Still_Pane_Count];
   #for (I, 0, Still_Pane_Count - 1)
      #declare Still_Pane_Sill_Drop[I] = 25;
      #declare Still_Pane_Sill_Depth[I] = 150;
      #declare Still_Pane_Frame[I] = 18;
      #declare Still_Pane_Reveal[I] = 30;
   #end
#end
#declare Row_Width = 0;
#declare Row_Height = 0;
#declare Sill_Depth = 0;
#declare Drop = 0;
#for (I, 0, Still_Pane_Count - 1)
   #declare Row_Width = Row_Width + Still_Pane_Max[I].x - Still_Pane_Min[I].x + 2 * Still_Pane_Reveal[I];
   #declare Row_Height = max(Row_Height, Still_Pane_Max[I].y - Still_Pane_Min[I].y);
   #declare Sill_Depth = max(Sill_Depth, Still_Pane_Sill_Depth[I]);
   #declare Drop = max(Drop, Still_Pane_Sill_Drop[I]);
#end
#declare Lip = 7;   // of the sash over the edge of the glass

// ---- materials

#declare Paint =
texture {
   pigment { bozo color_map { [0 rgb <0.80, 0.79, 0.75>] [1 rgb <0.86, 0.85, 0.81>] } scale <60, 60, 60> }
   normal { bumps 0.05 scale <3, 26, 3> }
   finish { ambient 0 diffuse 0.82 specular 0.22 roughness 0.03 reflection { 0.01, 0.10 fresnel on } conserve_energy }
}
#declare Plaster =
texture {
   pigment { bozo color_map { [0 rgb <0.50, 0.45, 0.38>] [1 rgb <0.56, 0.51, 0.43>] } turbulence 0.4 scale 130 }
   normal { granite 0.12 scale 60 }
   finish { ambient 0 diffuse 0.85 }
}
#declare Oak =
texture {
   pigment {
      wood
      turbulence 0.05 omega 0.55 octaves 5
      color_map {
         [0.00 rgb <0.235, 0.135, 0.065>]
         [0.55 rgb <0.320, 0.190, 0.095>]
         [0.85 rgb <0.255, 0.145, 0.068>]
         [1.00 rgb <0.150, 0.080, 0.036>]
      }
      scale <9, 9, 60>
      rotate <1.2, 90 + 0.8, 0>
      translate <0, -37, 13>
   }
   normal { granite 0.16 scale <120, 2.2, 4> }
   finish { ambient 0 diffuse 0.80 specular 0.20 roughness 0.02 reflection { 0.0, 0.30 fresnel on } conserve_energy }
}

// ---- sashes: bars about each pane, their inner edges moulded

#macro Bar(From, To, Width, Depth)
   // From From to To along x, its edge towards +y moulded.
   #local Length = To - From;
   prism {
      linear_sweep linear_spline From, To, 9,
      <-Depth, 0>, <Depth, 0>, <Depth, Width>, <0.35 * Depth, Width>, <-0.35 * Depth, Width>, <-0.45 * Depth, Width - 0.14 * Depth>,
      <-0.62 * Depth, Width - 0.38 * Depth>, <-Depth, Width - 0.60 * Depth>, <-Depth, 0>
      matrix <0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0>
   }
#end

#macro Sash(Low, High, Width, Depth)
   union {
      object { Bar(Low.x - Width, High.x + Width, Width + Lip, Depth) translate (Low.y - Width) * y }
      object { Bar(-High.x - Width, -Low.x + Width, Width + Lip, Depth) rotate 180 * z translate (High.y + Width) * y }
      object { Bar(-High.y, -Low.y, Width + Lip, Depth) rotate -90 * z translate (Low.x - Width) * x }
      object { Bar(Low.y, High.y, Width + Lip, Depth) rotate 90 * z translate (High.x + Width) * x }
      texture { Paint }
   }
#end

#declare Left = -Row_Width / 2;
#for (I, 0, Still_Pane_Count - 1)
   #declare Low = Still_Pane_Min[I];
   #declare High = Still_Pane_Max[I];
   #declare Reveal = Still_Pane_Reveal[I];
   #declare Wide = High.x - Low.x;
   #declare Tall = High.y - Low.y;
   union {
      object { Still_Pane(I) translate <-Low.x, -Low.y, 0> }
      object { Sash(<0, 0, 0>, <Wide, Tall, 0>, Reveal, Still_Pane_Frame[I]) }
      // What is left between the lower bar and the sill, or above a lower sash.
      box { <-Reveal, -Still_Pane_Sill_Drop[I] - 1, -Still_Pane_Frame[I]>, <Wide + Reveal, 0, Still_Pane_Frame[I]> texture { Paint } }
      #if (Tall < Row_Height - 1)
         box { <-Reveal, Tall, -0.6 * Still_Pane_Frame[I]>, <Wide + Reveal, Row_Height + Reveal, Still_Pane_Frame[I]> texture { Paint } }
      #end
      #if (!Still_Pane_Rectangular[I])
         object { Still_Pane_Surround(I, Reveal, 1.4 * Still_Pane_Frame[I]) translate <-Low.x, -Low.y, 0> texture { Paint } }
      #end
      translate <Left + Reveal, 0, 0>
   }
   #declare Left = Left + Wide + 2 * Reveal;
#end

// ---- the opening in the wall, the sill

#declare Half = Row_Width / 2;
#declare Top = Row_Height + Still_Pane_Reveal[0];
#declare Wall = -Sill_Depth + 34;   // its inner face; the sill stands out
#declare Large = 10 * (Row_Width + Row_Height);
union {
   box { <-Half - Large, -Large, Wall>, <-Half, Large, 40> }
   box { <Half, -Large, Wall>, <Half + Large, Large, 40> }
   box { <-Half, Top, Wall>, <Half, Large, 40> }
   box { <-Half, -Large, Wall>, <Half, -Drop - 26, 40> }
   texture { Plaster }
}
union {
   box { <-Half, -Drop - 26, -Sill_Depth + 7>, <Half, -Drop, 30> }
   box { <-Half - 45, -Drop - 26, -Sill_Depth + 7>, <Half + 45, -Drop, Wall> }
   cylinder { <-Half - 45, -Drop - 7, -Sill_Depth + 7>, <Half + 45, -Drop - 7, -Sill_Depth + 7>, 7 }
   cylinder { <-Half - 45, -Drop - 19, -Sill_Depth + 7>, <Half + 45, -Drop - 19, -Sill_Depth + 7>, 7 }
   box { <-Half - 45, -Drop - 19, -Sill_Depth>, <Half + 45, -Drop - 7, -Sill_Depth + 7> }
   texture { Oak }
}

// ---- outside: a garden out of focus, its light; within: a room that glass reflects

#declare Azimuth = function(X, Z) { X / max(0.05, abs(Z)) }
#declare Crowns = function(X, Y, Z) {
   Y / max(0.05, sqrt(X * X + Z * Z)) - 0.10
   - 0.55 * (f_noise3d(1.3 * Azimuth(X, Z) + 4, 3.1, 0) - 0.35) - 0.16 * (f_noise3d(4.6 * Azimuth(X, Z), 1.7, 5) - 0.5)
}
#declare Leaves =
pigment {
   bozo
   color_map {
      [0.25 rgb <0.016, 0.034, 0.012>]
      [0.50 rgb <0.045, 0.085, 0.024>]
      [0.72 rgb <0.120, 0.190, 0.055>]
      [0.90 rgb <0.560, 0.640, 0.300>]
   }
   turbulence 0.25
   scale 0.035
}
#declare Sky = pigment { gradient y color_map { [0.00 rgb <1.05, 1.06, 1.02>] [0.30 rgb <0.82, 0.92, 1.04>] [0.80 rgb <0.42, 0.60, 0.92>] } }
#declare Lawn = pigment { bozo color_map { [0.3 rgb <0.06, 0.11, 0.025>] [0.8 rgb <0.26, 0.33, 0.10>] } scale <0.35, 0.02, 0.35> }
#declare Garden =
pigment {
   function { max(0, min(1, 0.5 + 5 * Crowns(x, y, z))) }
   pigment_map { [0.25 Leaves] [0.75 Sky] }
}
#declare Outside =
pigment {
   function { max(0, min(1, 0.5 + 9 * (y / max(0.05, sqrt(x * x + z * z)) + 0.17 + 0.05 * (f_noise3d(3 * Azimuth(x, z), 0, 9) - 0.5)))) }
   pigment_map { [0.3 Lawn] [0.7 Garden] }
}
#declare Room =
pigment {
   gradient y
   pigment_map {
      [0.40 rgb <0.06, 0.05, 0.04>]
      [0.60 bozo color_map { [0.4 rgb <0.10, 0.085, 0.07>] [0.75 rgb <0.34, 0.28, 0.22>] } scale 0.45]
   }
   translate -0.5 * y scale 2
}
//@light <0, 0, 0>
sky_sphere {
   pigment {
      function { select(z, 0, 1) }
      pigment_map { [0.5 Room] [0.5 Outside] }
   }
}
//@end

#declare Size = max(Row_Width, Row_Height);
#macro Soft_Light(Place, Colour, Extent)
   light_source {
      Place, Colour
      #if (Quality > 0)
         area_light x * Extent, y * Extent, 4, 4 adaptive 1 circular orient
      #end
   }
#end
//@light
// The morning sun from the upper left outside; the sky; what the room gives back.
light_source {
   <-0.62, 0.78, 1> * 200 * Size, rgb <2.7, 2.35, 1.85>
   #if (Quality > 0)
      area_light x * 1.6 * Size, y * 1.6 * Size, 4, 4 adaptive 1 circular orient
   #end
}
Soft_Light(<0.2, 1.1, 2.2> * Size, rgb <0.42, 0.50, 0.62>, 1.2 * Size)
Soft_Light(<-0.9, 0.9, -2.4> * Size, rgb <0.50, 0.45, 0.39>, 0.8 * Size)
light_source { <1.3, 0.5, -1.5> * Size, rgb <0.13, 0.13, 0.14> shadowless }
//@end

// ---- the stone, on the sill

#declare Pebble_Size = 0.05 * Size;
#declare Pebble =
isosurface {
   function {
      sqrt(x * x * 0.62 + y * y * 1.75 + z * z) - 1 + 0.30 * (f_noise3d(1.3 * x, 1.3 * y + 3, 1.3 * z) - 0.5)
      + 0.05 * (f_noise3d(5 * x, 5 * y, 5 * z) - 0.5)
   }
   contained_by { box { -1.5, 1.5 } }
   max_gradient 2.2
   texture {
      pigment {
         granite
         color_map { [0 rgb <0.24, 0.225, 0.20>] [0.5 rgb <0.36, 0.345, 0.31>] [0.8 rgb <0.30, 0.27, 0.23>] [1 rgb <0.50, 0.48, 0.44>] }
         scale 0.7
      }
      normal { granite 0.25 scale 0.25 }
      finish { ambient 0 diffuse 0.85 specular 0.06 roughness 0.12 }
   }
}
object {
   Pebble
   rotate 25 * y
   scale Pebble_Size
   translate <0.30 * Row_Width, -Drop + 0.66 * Pebble_Size, -0.62 * Sill_Depth>
}

// ---- camera: at the height of somebody who looks at the damage, all of it in view

#declare Angle = 36;
#declare Aspect = image_width / image_height;
#declare View_Width = max(Row_Width + 30, (Row_Height + Drop + 60) * Aspect);
#declare Distance = View_Width / 2 / tan(radians(Angle / 2)) + Sill_Depth;
#declare Centre = <0, 0.5 * Row_Height - 0.75 * Drop, -0.25 * Sill_Depth>;
//@camera <-Row_Width / 2 + Still_Pane_Reveal[0] - Still_Pane_Min[0].x, -Still_Pane_Min[0].y, 0>, <0, 0, 0>
camera {
   location Centre + vnormalize(<0.36, 0.24, -1>) * Distance
   right x * Aspect
   up y
   angle Angle
   look_at Centre
}
//@end
