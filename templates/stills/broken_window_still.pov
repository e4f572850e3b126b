// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A window of an old house, seen from the street: somebody has thrown a stone. Shards stand in the weathered sash, others
//       lie on the stone sill. Glass mirrors what is all around, the hole shows the dark of the room. Frame, sill and camera
//       follow the size of the panes and where their shards fell; several panes stand side by side.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: lights without extent; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
// 16 levels: two faces of a shard and its bevels, then what lies behind it on the sill.
global_settings { assumed_gamma 1.0 max_trace_level select(Quality - 1, 10, 16) adc_bailout select(Quality - 1, 1 / 40, 1 / 255) }

#include "functions.inc"
#include "shatterpave_shards.inc"
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

// Along x: grey boards, with what is left of their paint.
#declare Bare_Wood =
texture {
   pigment {
      wood
      turbulence 0.05 omega 0.55 octaves 5
      color_map {
         [0.00 rgb <0.150, 0.128, 0.105>]
         [0.55 rgb <0.205, 0.180, 0.150>]
         [0.85 rgb <0.160, 0.135, 0.110>]
         [1.00 rgb <0.075, 0.062, 0.050>]
      }
      scale <5, 5, 60>
      rotate <1.2, 90 + 0.8, 0>
      translate <0, -37, 13>
   }
   normal { granite 0.25 scale <140, 2.2, 4> }
   finish { ambient 0 diffuse 0.85 }
}
#declare Paint =
texture { Bare_Wood }
texture {
   pigment {
      wrinkles
      color_map {
         [0.00 rgb <0.30, 0.35, 0.33>]
         [0.40 rgb <0.35, 0.40, 0.38>]
         [0.70 rgb <0.37, 0.42, 0.40>]
         [0.73 rgb <0.12, 0.11, 0.10> transmit 0.3]
         [0.76 rgb <0.12, 0.11, 0.10> transmit 1]
      }
      scale <70, 9, 9>
   }
   normal {
      average
      normal_map {
         [1 wrinkles 0.35 scale <70, 9, 9>]
         [1 bumps 0.12 scale <26, 3, 3>]
      }
   }
   finish { ambient 0 diffuse 0.85 specular 0.10 roughness 0.06 }
}
#declare Plaster =
texture {
   pigment {
      bozo
      color_map {
         [0.2 rgb <0.300, 0.258, 0.200>]
         [0.5 rgb <0.335, 0.290, 0.226>]
         [0.8 rgb <0.350, 0.308, 0.246>]
      }
      turbulence 0.7 octaves 8 omega 0.7
      scale 260
   }
   normal {
      average
      normal_map {
         [1.2 granite 0.9 scale 30]
         [0.8 bumps 0.6 scale 5]
         [1.0 bumps 0.5 scale 60]
      }
   }
   finish { ambient 0 diffuse 0.85 }
}
#declare Stone =
texture {
   pigment {
      granite
      color_map {
         [0.10 rgb <0.200, 0.192, 0.174>]
         [0.40 rgb <0.265, 0.257, 0.236>]
         [0.60 rgb <0.300, 0.292, 0.270>]
         [0.80 rgb <0.250, 0.236, 0.210>]
      }
      scale 40
   }
   normal {
      average
      normal_map {
         [1 granite 0.5 scale 18]
         [1 bumps 0.25 scale 3]
      }
   }
   finish { ambient 0 diffuse 0.85 specular 0.06 roughness 0.1 }
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
      texture { Paint translate <From, 71 * Width, 13 * Length> }
   }
#end

#macro Sash(Low, High, Width, Depth)
   union {
      object { Bar(Low.x - Width, High.x + Width, Width + Lip, Depth) translate (Low.y - Width) * y }
      object { Bar(-High.x - Width, -Low.x + Width, Width + Lip, Depth) rotate 180 * z translate (High.y + Width) * y }
      object { Bar(-High.y, -Low.y, Width + Lip, Depth) rotate -90 * z translate (Low.x - Width) * x }
      object { Bar(Low.y, High.y, Width + Lip, Depth) rotate 90 * z translate (High.x + Width) * x }
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
#declare Wall = -Sill_Depth + 34;   // its face; the sill stands out
#declare Large = 10 * (Row_Width + Row_Height);
union {
   box { <-Half - Large, -Large, Wall>, <-Half, Large, 40> }
   box { <Half, -Large, Wall>, <Half + Large, Large, 40> }
   box { <-Half, Top, Wall>, <Half, Large, 40> }
   box { <-Half, -Large, Wall>, <Half, -Drop - 26, 40> }
   texture { Plaster }
}
// A stone, its edge worn; the joints of the wall hide its ends.
union {
   box { <-Half - 45, -Drop - 70, -Sill_Depth>, <Half + 45, -Drop - 6, Wall> }
   box { <-Half, -Drop - 26, -Sill_Depth + 6>, <Half, -Drop, 30> }
   box { <-Half - 45, -Drop - 26, -Sill_Depth + 6>, <Half + 45, -Drop, Wall> }
   cylinder { <-Half - 45, -Drop - 6, -Sill_Depth + 6>, <Half + 45, -Drop - 6, -Sill_Depth + 6>, 6 }
   texture { Stone }
}

// ---- within: a room as daylight through the window leaves it, and the little that its walls give back

#declare Room_Front = 40;
#declare Room_Back = Room_Front + max(3400, 1.5 * Row_Width);
#declare Room_Half = max(2600, 1.2 * Row_Width);
#declare Floor = min(-850, -Drop - 100);
#declare Ceiling = max(1750, Row_Height + 500);
#declare Room_Lot = seed(7);
// Its part of the light, by eye, is what walls and floor give back to one another.
#declare Matt = finish { ambient 0 diffuse 0.8 emission 0.085 }
#declare Wallpaper =
texture {
   pigment {
      gradient x
      color_map { [0.0 rgb <0.40, 0.36, 0.27>] [0.46 rgb <0.40, 0.36, 0.27>] [0.5 rgb <0.46, 0.42, 0.33>] [0.96 rgb <0.46, 0.42, 0.33>] [1.0 rgb <0.40, 0.36, 0.27>] }
      scale 130
   }
   finish { Matt }
}
#declare Brown_Wood =
texture {
   pigment {
      wood
      turbulence 0.06 omega 0.5
      color_map { [0 rgb <0.16, 0.085, 0.045>] [0.7 rgb <0.21, 0.118, 0.062>] [1 rgb <0.11, 0.056, 0.030>] }
      scale <26, 26, 500>
      rotate 90 * x
   }
   finish { Matt specular 0.12 roughness 0.06 }
}

#declare Book_Colours = array[4] { <1.0, 0.42, 0.30>, <0.42, 0.55, 0.80>, <0.45, 0.62, 0.40>, <1.2, 1.1, 0.9> }

// A board of books, from X to X + Width, standing at Y: of any height and colour, some leaning, with gaps.
#macro Books(X, Y, Z, Width, Height)
   #local At = X + 15;
   #while (At < X + Width - 50)
      #local Thick = 16 + 40 * pow(rand(Room_Lot), 2);
      #local Tall = Height * (0.55 + 0.38 * rand(Room_Lot));
      #local Deep = 130 + 60 * rand(Room_Lot);
      #local Tone = 0.06 + 0.40 * pow(rand(Room_Lot), 2);
      #local Hue = rand(Room_Lot);
      #local Cover = Tone * Book_Colours[int(3.999 * Hue)];
      box {
         <0, 0, 230 - Deep>, <Thick, Tall, 235>
         // Darker to the board above, and round its back.
         pigment {
            average
            pigment_map {
               [1 gradient y color_map { [0.0 rgb 1.05 * Cover] [0.5 rgb 0.8 * Cover] [1.0 rgb 0.1 * Cover] } scale Height]
               [0.6 gradient x color_map { [0.0 rgb 0.2 * Cover] [0.3 rgb 1.3 * Cover] [0.7 rgb Cover] [1.0 rgb 0.1 * Cover] } scale Thick + 0.1]
            }
         }
         finish { Matt }
         rotate select(rand(Room_Lot) - 0.93, 0, 9) * z
         translate <At, Y, Z>
      }
      #local At = At + Thick + select(rand(Room_Lot) - 0.9, 1, 60 * rand(Room_Lot));
   #end
#end

#macro Bookcase(X, Width, Height)
   #local Z = Room_Back - 260;
   union {
      box { <X - 25, Floor, Z>, <X, Floor + Height, Room_Back> }
      box { <X + Width, Floor, Z>, <X + Width + 25, Floor + Height, Room_Back> }
      box { <X, Floor, Room_Back - 15>, <X + Width, Floor + Height, Room_Back> }
      #for (Y, Floor + 80, Floor + Height, 320)
         box { <X, Y, Z>, <X + Width, Y + 22, Room_Back> }
      #end
      texture { Brown_Wood }
   }
   #for (Y, Floor + 80, Floor + Height - 200, 320) Books(X, Y + 22, Z, Width, 298) #end
#end

#declare Door_Left = -0.45 * Room_Half;
union {
   box { <-Room_Half, Floor, Room_Back>, <Room_Half, Ceiling, Room_Back + 10> texture { Wallpaper } }
   box { <-Room_Half - 10, Floor, Room_Front>, <-Room_Half, Ceiling, Room_Back> texture { Wallpaper rotate 90 * y } }
   box { <Room_Half, Floor, Room_Front>, <Room_Half + 10, Ceiling, Room_Back> texture { Wallpaper rotate 90 * y } }
   box { <-Room_Half, Ceiling, Room_Front>, <Room_Half, Ceiling + 10, Room_Back> pigment { rgb <0.62, 0.60, 0.56> } finish { Matt } }
   box { <-Room_Half, Floor - 10, Room_Front>, <Room_Half, Floor, Room_Back> texture { Brown_Wood } }
   box { <-Room_Half, Floor, Room_Back - 16>, <Room_Half, Floor + 110, Room_Back> pigment { rgb <0.55, 0.52, 0.46> } finish { Matt } }
   // A door with its frame and two panels.
   box { <Door_Left - 80, Floor, Room_Back - 24>, <Door_Left + 880, Floor + 2080, Room_Back> pigment { rgb <0.56, 0.53, 0.47> } finish { Matt } }
   difference {
      box { <Door_Left, Floor, Room_Back - 34>, <Door_Left + 800, Floor + 2000, Room_Back - 25> }
      box { <Door_Left + 110, Floor + 180, Room_Back - 40>, <Door_Left + 690, Floor + 880, Room_Back - 28> }
      box { <Door_Left + 110, Floor + 1060, Room_Back - 40>, <Door_Left + 690, Floor + 1860, Room_Back - 28> }
      pigment { rgb <0.60, 0.57, 0.50> } finish { Matt }
   }
   // A picture in its frame.
   union {
      box { <0, 0, -30>, <560, 430, 0> texture { Brown_Wood } }
      box { <30, 30, -32>, <530, 400, -30> pigment { rgb <0.62, 0.60, 0.52> } finish { Matt } }
      box {
         <90, 85, -34>, <470, 345, -32>
         pigment { bozo color_map { [0.2 rgb <0.10, 0.16, 0.12>] [0.5 rgb <0.24, 0.28, 0.20>] [0.7 rgb <0.40, 0.44, 0.48>] } turbulence 0.6 scale 120 }
         finish { Matt }
      }
      translate <0.12 * Room_Half, Floor + 1250, Room_Back>
   }
   Bookcase(0.45 * Room_Half, 0.48 * Room_Half, 2120)
}

// ---- outside: a garden, out of focus, and its light

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
//@light <0, 0, 0>
sky_sphere { pigment { Outside } }
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
// The morning sun from the left; the sky.
light_source {
   <-0.95, 0.55, -0.9> * 200 * Size, rgb <2.3, 1.95, 1.5>
   #if (Quality > 0)
      area_light x * 1.6 * Size, y * 1.6 * Size, 4, 4 adaptive 1 circular orient
   #end
}
Soft_Light(<-0.4, 2.6, -2.4> * Size, rgb <0.42, 0.50, 0.62>, 1.2 * Size)
Soft_Light(<1.6, 0.7, -2.4> * Size, rgb <0.24, 0.27, 0.30>, 0.8 * Size)
//@end

// ---- camera: at the height of somebody who looks at the damage, all of it in view

#declare Angle = 36;
#declare Aspect = image_width / image_height;
#declare View_Width = max(Row_Width + 30, (Row_Height + Drop + 60) * Aspect);
#declare Distance = View_Width / 2 / tan(radians(Angle / 2)) + Sill_Depth;
#declare Centre = <0, 0.5 * Row_Height - 0.75 * Drop, -0.25 * Sill_Depth>;
//@camera <-Row_Width / 2 + Still_Pane_Reveal[0] - Still_Pane_Min[0].x, -Still_Pane_Min[0].y, 0>, <0, 0, 0>
camera {
   location Centre + vnormalize(<-0.42, -0.10, -1>) * Distance
   right x * Aspect
   up y
   angle Angle
   look_at Centre
}
//@end
