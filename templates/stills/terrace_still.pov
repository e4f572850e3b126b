// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A flight of steps from a court up to a terrace, between walls, late in the day: a sun from the left, pots, a house above.
//       The camera stands over the lower edge of the plan and looks along y, up the steps. What is neither lowest nor highest of the
//       pavements is taken for the flight; where there is none, it looks along the middle of the plan.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: fewer leaves, light from fewer sides; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings { assumed_gamma 1.0 max_trace_level 5 }

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

// The ground below, the ground above, and the box of what leads from one to the other.
#declare Bottom = High.y;
#for (I, 0, Still_Pavement_Count - 1) #declare Bottom = min(Bottom, Still_Pavement_Max[I].y); #end
#declare Foot = <High.x, Bottom, High.z>;
#declare Head = <Low.x, High.y, Low.z>;
#for (I, 0, Still_Pavement_Count - 1)
   #if (Still_Pavement_Max[I].y > Bottom + 60 & Still_Pavement_Max[I].y < High.y - 2)
      #declare Foot = <min(Foot.x, Still_Pavement_Min[I].x), Bottom, min(Foot.z, Still_Pavement_Min[I].z)>;
      #declare Head = <max(Head.x, Still_Pavement_Max[I].x), High.y, max(Head.z, Still_Pavement_Max[I].z)>;
   #end
#end
#declare Has_Flight = (Head.x > Foot.x);
#if (!Has_Flight)
   #declare Foot = <Low.x * 0.7 + High.x * 0.3, Bottom, Middle.z>;
   #declare Head = <Low.x * 0.3 + High.x * 0.7, High.y, High.z>;
#end
#declare Across = (Foot.x + Head.x) / 2;
#declare Rise = High.y - Bottom;

// ---- camera: at a standing man's eyes, a little to the right of the flight

#declare Eye = <Across + 0.30 * (Head.x - Foot.x), Bottom + 1450, Low.z - 250>;
//@camera <0, 0, 0>, <0, 0, 0>
camera {
   perspective
   location Eye
   right x * image_width / image_height
   up y
   angle 50
   look_at <Across - 120, Bottom + 0.58 * Rise + 60, Foot.z + 700>
}
//@end

// ---- light: a sun from the left over the camera's shoulder, low enough to part treads and risers; blue from the sky

#declare To_Sun = vnormalize(<-0.80, 0.62, -0.30>);
//@light <0, 0, 0>
light_source { To_Sun * 1e6 rgb <1.00, 0.83, 0.58> * 3.3 parallel point_at 0 }
//@end
#macro Sky_Light(Towards, Light)
   light_source { vnormalize(Towards) * 1e6 rgb Light parallel point_at 0 }
#end
//@light
#if (Quality > 0)
   Sky_Light(<0.2, 1, 0.1>, <0.30, 0.41, 0.60> * 0.50)
   Sky_Light(<0.8, 0.8, -0.6>, <0.30, 0.40, 0.56> * 0.30)
   Sky_Light(<-0.2, 0.8, -0.9>, <0.30, 0.40, 0.56> * 0.30)
#else
   Sky_Light(<0.2, 1, -0.1>, <0.30, 0.41, 0.60> * 0.95)
#end
light_source { vnormalize(<0.3, 0.35, -1>) * 1e6 rgb <0.36, 0.34, 0.33> * 0.34 parallel point_at 0 shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.90, 0.82, 0.70>] [0.25 rgb <0.48, 0.62, 0.82>] [1 rgb <0.14, 0.27, 0.58>] } } }
//@end

plane { y, Low.y - 20 pigment { rgb <0.12, 0.10, 0.07> } finish { ambient 0 diffuse 0.8 } }

// ---- walls that hold the terrace and the beds beside the flight

#declare Wall_Deep = 300;
#declare R = seed(11);
#declare Coping_Stone = array[3];
#for (I, 0, 2) #declare Coping_Stone[I] = Garden_Sandstone(0.8 + 0.15 * I) #end
#macro Coping(From, To, Deep)
   #local Long = vlength(To - From);
   #local Count = max(1, floor(Long / 620));
   #for (K, 0, Count - 1)
      #local A = From + (To - From) * (K + 0.006) / Count;
      #local B = From + (To - From) * (K + 0.994) / Count;
      superellipsoid { <0.05, 0.05>
         scale <abs(B.x - A.x) / 2 + select(abs(To.x - From.x) - 1, Deep / 2, 0), 42, abs(B.z - A.z) / 2 + select(abs(To.z - From.z) - 1, Deep / 2, 0)>
         translate (A + B) / 2 + y * 42
         texture { Coping_Stone[floor(rand(R) * 2.999)] translate rand(R) * 3000 } }
   #end
#end
// A wall of rubble with a coping; From and To are at its foot.
#macro Held_Wall(From, To, Height, Seed)
   object { Garden_Wall(From, To, Height, Wall_Deep, Seed) }
   Coping(From + y * Height, To + y * Height, Wall_Deep + 90)
#end

#if (Has_Flight)
   #declare Left = Foot.x - Wall_Deep / 2 - 4;
   #declare Right = Head.x + Wall_Deep / 2 + 4;
   // Beside the steps, in two heights, as they rise.
   #declare Half_Z = (Foot.z + Head.z) / 2;
   #for (Side, 0, 1)
      #local X = select(Side - 1, Left, Right);
      Held_Wall(<X, Bottom - 60, Foot.z - 60>, <X, Bottom - 60, Half_Z>, Rise * 0.56 + 60, 3 + Side)
      Held_Wall(<X, Bottom - 60, Half_Z>, <X, Bottom - 60, Head.z + 150>, Rise + 180, 5 + Side)
   #end
   // The terrace's own, to both sides, and earth behind it up to the flight.
   Held_Wall(<Low.x - 6000, Bottom - 60, Head.z - 20>, <Left - Wall_Deep / 2, Bottom - 60, Head.z - 20>, Rise + 60, 7)
   Held_Wall(<Right + Wall_Deep / 2, Bottom - 60, Head.z - 20>, <High.x + 6000, Bottom - 60, Head.z - 20>, Rise + 60, 8)
   // Beds in the corners between those walls, behind a row of stones.
   #declare Clump = Garden_Leaves(1, select(Quality - 1, 60, 140), 0.34, 71)
   #declare Leaf_Green = object { Clump Garden_Leaf_Texture(rgb <0.085, 0.135, 0.030>) }
   #declare Leaf_Grey = object { Clump Garden_Leaf_Texture(rgb <0.165, 0.180, 0.120>) }
   #declare Leaf_Box = object { Clump Garden_Leaf_Texture(rgb <0.055, 0.105, 0.024>) }
   #declare Bloom = Garden_Leaves(1, 26, 0.16, 5)
   #declare Bloom_White = object { Bloom texture { pigment { rgb <0.80, 0.76, 0.66> } finish { ambient 0 diffuse 0.8 emission 0.04 } } }
   #declare Bloom_Violet = object { Bloom texture { pigment { rgb <0.30, 0.20, 0.52> } finish { ambient 0 diffuse 0.8 emission 0.06 } } }
   #for (Side, 0, 1)
      #local S = select(Side - 1, -1, 1);
      #local Inner = select(Side - 1, Left, Right) + S * Wall_Deep * 0.9;
      #for (K, 1, select(Quality - 1, 110, 170))
         #local X = Inner + S * (120 + 2500 * rand(R));
         #local Z = Head.z - 250 - 900 * pow(rand(R), 1.3);
         #local Size = 90 + 150 * rand(R);
         #local Kind = floor(rand(R) * 2.999);
         #local At = <X, Bottom + 230 + Size * (0.55 + 1.5 * rand(R) * (1 - (Head.z - Z) / 1500)), Z>;
         object {
            #switch (Kind) #case (0) Leaf_Green #break #case (1) Leaf_Grey #break #else Leaf_Box #end
            rotate <rand(R), rand(R), rand(R)> * 360 scale Size translate At }
         #if (rand(R) < 0.5) object { #if (rand(R) < 0.55) Bloom_Violet #else Bloom_White #end rotate rand(R) * 360 * y scale Size * 1.05 translate At + y * Size * 0.18 } #end
      #end
      Held_Wall(<Inner, Bottom - 60, Head.z - 1350>, <Inner + S * 4200, Bottom - 60, Head.z - 1350>, 330, 12 + Side)
      box { <Inner, Bottom - 60, Head.z - 1350>, <Inner + S * 4200, Bottom + 240, Head.z - 100>
         pigment { granite color_map { [0 rgb 0.012] [1 rgb <0.085, 0.060, 0.040>] } scale 60 } finish { ambient 0 diffuse 0.8 } }
      // Ivy hangs over the terrace's wall.
      #for (K, 1, 46)
         #local Out = rand(R);
         object { Leaf_Box rotate <rand(R), rand(R), rand(R)> * 360 scale 70 + 50 * rand(R)
            translate <Inner + S * (500 + 1500 * Out), High.y + 90 - 620 * pow(rand(R), 1.6) * (1 - 0.5 * Out), Head.z - 190 - 50 * rand(R)> }
      #end
   #end

   // Pots at the foot and at the head of the flight.
   #macro Planted(At, Radius, Bush, Flowers)
      union {
         object { Town_Pot(Radius) }
         #for (K, 1, 34)
            #local P = vnormalize(<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>) * Radius * 0.95 * pow(rand(R), 0.4);
            object { Bush rotate <rand(R), rand(R), rand(R)> * 360 scale Radius * 0.42 translate y * Radius * 2.35 + P }
            #if (Flowers & mod(K, 2) = 0) object { Bloom_White rotate y * 360 * rand(R) scale Radius * 0.42 translate y * Radius * 2.4 + P * 1.12 } #end
         #end
         translate At
      }
   #end
   Planted(<Left, Bottom + Rise * 0.56 + 84, Foot.z + 160>, 150, Leaf_Box, 0)
   Planted(<Right, Bottom + Rise * 0.56 + 84, Foot.z + 160>, 150, Leaf_Box, 0)
   Planted(<Left, High.y + 120 + 84, Head.z - 60>, 170, Leaf_Green, 1)
   Planted(<Right, High.y + 120 + 84, Head.z - 60>, 170, Leaf_Green, 1)
#end

// ---- what stands above: a house and a tree on the terrace, hedges beside; a tree behind the camera throws its shadow on the court

object { Town_House(15050, 2, <0.66, 0.58, 0.44>, 0, <0.16, 0.21, 0.17>, 31) translate <Across - 9100, High.y, High.z + 500> }
box { <Low.x - 20000, Bottom, Head.z + 160>, <High.x + 20000, High.y - 12, High.z + 30000>
   texture { pigment { granite color_map { [0.2 rgb <0.30, 0.27, 0.22>] [0.9 rgb <0.42, 0.39, 0.33>] } scale 90 } finish { ambient 0 diffuse 0.88 } }
   clipped_by { union { box { <-1e6, -1e6, -1e6>, <Low.x, 1e6, 1e6> } box { <High.x, -1e6, -1e6>, <1e6, 1e6, 1e6> } box { <-1e6, -1e6, High.z>, <1e6, 1e6, 1e6> } } } }
#declare Tree_Leaf = object { Garden_Leaves(1, select(Quality - 1, 60, 150), 0.22, 9) Garden_Leaf_Texture(rgb <0.095, 0.150, 0.032>) }
object { Garden_Tree(5200, 1700, select(Quality - 1, 90, 180), Tree_Leaf, 4) translate <High.x + 900, High.y, Head.z + 1500> }
object { Garden_Tree(5600, 1900, select(Quality - 1, 90, 180), Tree_Leaf, 6) translate <Low.x - 900, High.y, Head.z + 1300> }
object { Garden_Tree(6200, 2300, select(Quality - 1, 110, 220), Tree_Leaf, 12) translate <Across - 6300, Bottom, Low.z - 700> }
