// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A plaza at noon: an arcade across, a fountain in the hole of the pavement or in its middle, a tree that throws its shadow
//       into the foreground. The camera stands over the lower edge of the plan and looks along y.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: fewer leaves, light from fewer sides; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings { assumed_gamma 1.0 max_trace_level 6 }

#include "shatterpave_garden.inc"
#include "shatterpave_town.inc"
//@model

#declare Low = Still_Pavement_Min[0];
#declare High = Still_Pavement_Max[0];
#for (I, 0, Still_Pavement_Count - 1)
   object { Still_Pavement(I) }
   #declare Low = <min(Low.x, Still_Pavement_Min[I].x), min(Low.y, Still_Pavement_Min[I].y), min(Low.z, Still_Pavement_Min[I].z)>;
   #declare High = <max(High.x, Still_Pavement_Max[I].x), max(High.y, Still_Pavement_Max[I].y), max(High.z, Still_Pavement_Max[I].z)>;
#end
#declare Middle = (Low + High) / 2;
#declare Depth = High.z - Low.z;
#declare Wide = High.x - Low.x;

// ---- camera: standing height, the fountain on the right third

#declare Eye = <Middle.x - Wide * 0.10, 1560, Low.z + 350>;
//@camera <0, 0, 0>, <0, 0, 0>
camera {
   perspective
   location Eye
   right x * image_width / image_height
   up y
   angle 62
   look_at <Middle.x - Wide * 0.075, 830, Low.z + Depth * 0.48>
}
//@end

// ---- light: a high sun from the left behind the camera's shoulder, sky from all sides, and what the fronts throw back

#declare To_Sun = vnormalize(<-0.66, 0.98, -0.36>);
//@light <0, 0, 0>
light_source { To_Sun * 1e7 rgb <1.00, 0.93, 0.81> * 2.75 parallel point_at 0 }
//@end
#macro Sky_Light(Towards, Light)
   light_source { vnormalize(Towards) * 1e7 rgb Light parallel point_at 0 }
#end
//@light
#if (Quality > 0)
   Sky_Light(<0.2, 1, 0.2>, <0.30, 0.42, 0.62> * 0.42)
   Sky_Light(<0.9, 0.7, -0.6>, <0.30, 0.40, 0.56> * 0.34)
   Sky_Light(<-0.5, 0.6, -0.9>, <0.32, 0.40, 0.54> * 0.34)
#else
   Sky_Light(<0.2, 1, 0.2>, <0.30, 0.42, 0.62> * 0.95)
#end
light_source { <0.2, 0.3, -1> * 1e7 rgb <0.40, 0.37, 0.33> * 0.42 parallel point_at 0 shadowless }
light_source { <0.1, -1, -0.2> * 1e7 rgb <0.36, 0.31, 0.24> * 0.30 parallel point_at 0 shadowless }
//@end

//@light
sky_sphere {
   pigment { gradient y color_map { [0.0 rgb <0.66, 0.76, 0.86>] [0.12 rgb <0.42, 0.60, 0.85>] [0.45 rgb <0.16, 0.34, 0.70>] [1.0 rgb <0.06, 0.17, 0.48>] } }
   pigment {
      bozo turbulence 0.8 octaves 8 omega 0.55
      color_map { [0.56 rgbt <1, 1, 1, 1>] [0.68 rgbt <1.05, 1.03, 1.0, 0.45>] [0.86 rgbt <1.1, 1.08, 1.05, 0.05>] }
      scale <0.55, 0.13, 0.55>
      translate <0.7, 0.1, 0.2>
   }
}
//@end

// ---- ground beyond the pavement, and fronts on three sides

plane { y, Low.y + 45 texture { pigment { granite color_map { [0.2 rgb <0.30, 0.27, 0.22>] [0.9 rgb <0.42, 0.39, 0.33>] } scale 90 } finish { ambient 0 diffuse 0.88 } } }

#declare Front_Z = High.z + 1400;
object { Town_Arcade(8, 3900, <0.62, 0.46, 0.27>, 3) translate <Middle.x - 15900, 0, Front_Z> }
object { Town_House(9000, 3, <0.62, 0.34, 0.22>, 0, <0.13, 0.20, 0.18>, 31) translate <Middle.x + 15300, 0, Front_Z> }
object { Town_House(9500, 4, <0.64, 0.54, 0.38>, 0, <0.22, 0.12, 0.07>, 33) rotate y * -90 translate <Middle.x - Wide / 2 - 3400, 0, Front_Z - 10100> }
// A tower over the roofs, off the middle.
union {
   box { <-1700, 0, -1700>, <1700, 15500, 1700> }
   box { <-1900, 15500, -1900>, <1900, 15900, 1900> }
   difference { box { <-1550, 15900, -1550>, <1550, 19600, 1550> }
      box { <-600, 16500, -2000>, <600, 18200, 2000> } cylinder { <0, 18200, -2000>, <0, 18200, 2000>, 600 }
      box { <-2000, 16500, -600>, <2000, 18200, 600> } cylinder { <-2000, 18200, 0>, <2000, 18200, 0>, 600 } }
   box { <-1800, 19600, -1800>, <1800, 19950, 1800> }
   Town_Plaster(<0.55, 0.42, 0.27>)
   translate <Middle.x - 6600, 0, Front_Z + 9500>
}
intersection {
   cone { y * 19950, 2500, y * 23500, 0 } box { <-1750, 19900, -1750>, <1750, 24000, 1750> }
   pigment { rgb <0.26, 0.13, 0.085> } finish { ambient 0 diffuse 0.85 }
   translate <Middle.x - 6600, 0, Front_Z + 9500>
}

// ---- fountain, benches, pots

object { Town_Basin(1480) translate <Middle.x, 0, Middle.z> }
object { Town_Bench(1900) rotate y * 68 translate <Middle.x + 4200, 0, Middle.z + 300> }
object { Town_Bench(1900) rotate y * -62 translate <Middle.x - 4700, 0, Middle.z + 2600> }

#declare Clump = Garden_Leaves(1, select(Quality - 1, 60, 150), 0.34, 71)
#declare Leaf_Green = object { Clump Garden_Leaf_Texture(rgb <0.070, 0.125, 0.024>) }
#declare Leaf_Olive = object { Clump Garden_Leaf_Texture(rgb <0.115, 0.145, 0.060>) }

#declare R = seed(9);
#for (I, 0, 2)
   union {
      object { Town_Pot(420) }
      #for (K, 1, select(Quality - 1, 40, 90))
         #local P = vnormalize(<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>) * 430 * pow(rand(R), 0.4);
         object { Leaf_Olive rotate <rand(R), rand(R), rand(R)> * 360 scale 120 translate <0, 1130, 0> + P }
      #end
      cylinder { y * 500, y * 1000, 26 pigment { rgb <0.10, 0.075, 0.05> } finish { ambient 0 diffuse 0.8 } }
      translate <Middle.x + 2300 + 3900 * (I - 1) * 2, 0, Front_Z - 700>
   }
#end

// A plane tree out of the picture on the left, whose shadow breaks the foreground; and one that stands in it.
object { Garden_Tree(7600, 2600, select(Quality - 1, 150, 300), Leaf_Green, 21) translate <Eye.x - 5900, 0, Eye.z + 2300> }
object { Garden_Tree(8400, 2900, select(Quality - 1, 200, 420), Leaf_Green, 26) translate <Middle.x + Wide * 0.47, 0, Middle.z + Depth * 0.22> }
