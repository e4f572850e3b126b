// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A corner of a courtyard, close: stones at the feet of somebody who kneels, raking light of an afternoon, fallen leaves,
//       pots before a wall. The camera stands over the lower edge of the plan and looks along y, down at the stones.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: no blur of depth; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings { assumed_gamma 1.0 max_trace_level 6 }

#include "functions.inc"
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
#declare Top = High.y;

#declare Eye = <Middle.x - 90, 400, Low.z + 30>;
#declare Focus = <Middle.x + 40, Top, Low.z + 620>;
//@camera <0, 0, 0>, <0, 0, 0>
camera {
   perspective
   location Eye
   right x * image_width / image_height
   up y
   angle 50
   look_at <Middle.x + 70, Top, Low.z + 790>
   #if (Quality > 0) focal_point Focus aperture 8 blur_samples 16 confidence 0.9 variance 1/128 #end
}
//@end

// ---- light: a low sun from the right, through leaves; a bright sky; the wall throws some back

#declare To_Sun = vnormalize(<0.86, 0.42, 0.42>);
//@light <0, 0, 0>
light_source { To_Sun * 1e6 rgb <1.00, 0.80, 0.54> * 4.3 parallel point_at 0 }
light_source { vnormalize(<-0.3, 1, 0.2>) * 1e6 rgb <0.30, 0.41, 0.60> * 0.62 parallel point_at 0 }
#if (Quality > 0)
   light_source { vnormalize(<-0.9, 0.8, -0.3>) * 1e6 rgb <0.30, 0.40, 0.56> * 0.38 parallel point_at 0 }
   light_source { vnormalize(<0.2, 0.9, -0.9>) * 1e6 rgb <0.30, 0.40, 0.56> * 0.34 parallel point_at 0 }
#end
light_source { vnormalize(<-0.2, 0.5, -1>) * 1e6 rgb <0.30, 0.34, 0.40> * 0.26 parallel point_at 0 shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.85, 0.80, 0.72>] [0.3 rgb <0.50, 0.62, 0.80>] [1 rgb <0.16, 0.28, 0.56>] } } }
//@end

plane { y, Low.y pigment { rgb <0.10, 0.085, 0.06> } finish { ambient 0 diffuse 0.8 } }

// ---- wall and pots at the far edge

object { Garden_Wall(<Low.x - 900, 0, High.z + 180>, <High.x + 900, 0, High.z + 180>, 900, 300, 5) }
#declare R = seed(4);
#declare Clump = Garden_Leaves(1, select(Quality - 1, 70, 160), 0.34, 71)
#declare Leaf_Box = object { Clump Garden_Leaf_Texture(rgb <0.060, 0.115, 0.022>) }
#declare Leaf_Sage = object { Clump Garden_Leaf_Texture(rgb <0.150, 0.170, 0.105>) }
union {
   object { Town_Pot(150) }
   #for (K, 1, 60)
      #local P = vnormalize(<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>) * 165 * pow(rand(R), 0.4);
      object { Leaf_Box rotate <rand(R), rand(R), rand(R)> * 360 scale 52 translate <0, 370, 0> + P }
   #end
   translate <Middle.x + 330, Top - 2, Low.z + 1330>
}
union {
   object { Town_Pot(95) }
   #for (K, 1, 36)
      object { Leaf_Sage rotate <rand(R), rand(R), rand(R)> * 360 scale 44 translate <(rand(R) - 0.5) * 190, 175 + 90 * rand(R), (rand(R) - 0.5) * 190> }
   #end
   translate <Middle.x + 90, Top - 2, Low.z + 1480>
}

// Twigs out of the picture on the right dapple the light.
#for (K, 1, 16)
   object { Leaf_Box rotate <rand(R), rand(R), rand(R)> * 360 scale 62
      translate Focus + To_Sun * (1300 + 300 * rand(R)) + <-420 + (rand(R) - 0.5) * 520, (rand(R) - 0.5) * 300, (rand(R) - 0.2) * 1100> }
#end

// ---- what lies in the joints near the eye: cushions of moss, and grit. Where a ray from above meets the bed, there is a joint.

#declare Yard_Stones = union { #for (I, 0, Still_Pavement_Count - 1) object { Still_Pavement(I) } #end sphere { <0, -1e4, 0>, 1 } }
#declare Yard_Beds = union { #for (I, 0, Still_Pavement_Count - 1) object { Still_Pavement_Bed(I) } #end sphere { <0, -1e4, 0>, 1 } }
#declare Yard_Moss = array[3];
#for (I, 0, 2)
   #declare Yard_Moss[I] = texture {
      pigment { granite color_map { [0.2 rgb <0.022, 0.036, 0.008> * (1 + 0.4 * I)] [0.55 rgb <0.070, 0.108, 0.020> * (1 + 0.3 * I)] [0.85 rgb <0.17, 0.21, 0.05>] } scale 3 }
      normal { granite 1.4 scale 1.6 }
      finish { ambient 0 diffuse 0.9 }
   }
#end
#declare Yard_Grit = array[4];
#declare Yard_Grit[0] = texture { pigment { rgb <0.34, 0.30, 0.23> } finish { ambient 0 diffuse 0.9 } }
#declare Yard_Grit[1] = texture { pigment { rgb <0.20, 0.165, 0.12> } finish { ambient 0 diffuse 0.9 } }
#declare Yard_Grit[2] = texture { pigment { rgb <0.46, 0.43, 0.38> } finish { ambient 0 diffuse 0.9 specular 0.1 } }
#declare Yard_Grit[3] = texture { pigment { rgb <0.13, 0.115, 0.10> } finish { ambient 0 diffuse 0.9 } }
#for (K, 1, select(Quality - 1, 6000, 12000))
   #local Out = pow(rand(R), 0.8);
   #local X = Eye.x + (rand(R) - 0.45) * (420 + 1500 * Out);
   #local Z = Eye.z + 130 + 1150 * Out;
   #local N = <0, 0, 0>;
   #local Hit = trace(Yard_Stones, <X, 600, Z>, -y, N);
   #local Is_Moss = (f_noise3d(X / 150, 3, Z / 150) > 0.46 + 0.16 * rand(R));
   #if (N.y > 0.5 & Hit.y < trace(Yard_Beds, <X, 600, Z>, -y).y + select(-Is_Moss, 1.2, 0.3, 0.3))
      #if (Is_Moss)
         sphere { 0, 1 scale <1, 0.75 + 0.3 * rand(R), 1> * (1.3 + 3.0 * rand(R)) translate Hit texture { Yard_Moss[floor(rand(R) * 2.999)] } }
      #else
         sphere { 0, 1 scale <1, 0.7, 0.8> * (0.5 + 1.5 * pow(rand(R), 4)) rotate y * 360 * rand(R) translate Hit texture { Yard_Grit[floor(rand(R) * 3.999)] } }
      #end
   #end
#end

// ---- fallen leaves: a blade of two halves bent along its rib, on a stalk

#macro Fallen_Leaf(Size, Curl, Colour)
   union {
      mesh {
         #local N = 10;
         #macro Edge(T) (Size * 0.30 * sin(pi * pow(T, 0.75)) * (1 - 0.25 * T)) #end
         #macro Rib(T) (Size * Curl * (T - 0.45) * (T - 0.45)) #end
         #for (I, 0, N - 1)
            #local A = I / N;
            #local B = (I + 1) / N;
            #for (S, -1, 1, 2)
               #local P0 = <0, Rib(A), Size * A>;
               #local P1 = <0, Rib(B), Size * B>;
               #local Q0 = <S * Edge(A), Rib(A) + Edge(A) * 0.42 * (1 + 0.4 * S), Size * A>;
               #local Q1 = <S * Edge(B), Rib(B) + Edge(B) * 0.42 * (1 + 0.4 * S), Size * B>;
               triangle { P0, P1, Q1 }
               triangle { P0, Q1, Q0 }
            #end
         #end
         texture {
            pigment { bozo turbulence 0.5 color_map { [0.25 Colour] [0.55 Colour * <1.15, 1.1, 0.9>] [0.8 Colour * <0.6, 0.5, 0.5>] } scale Size / 5 }
            finish { ambient 0 diffuse 0.8 specular 0.12 roughness 0.05 emission 0.02 }
         }
      }
      cone { <0, Rib(0), 0>, Size * 0.012, <Size * 0.05, Rib(0) + Size * 0.05, -Size * 0.35>, Size * 0.009
         pigment { Colour * 0.6 } finish { ambient 0 diffuse 0.8 } }
   }
#end
#macro Lay_Leaf(X, Z, Size, Turn, Curl, Colour)
   object { Fallen_Leaf(Size, Curl, Colour) rotate x * (4 * Curl) rotate y * Turn translate <Middle.x + X, Top + 1.5, Low.z + Z> }
#end
Lay_Leaf(150, 560, 78, 62, 0.42, rgb <0.42, 0.20, 0.035>)
Lay_Leaf(-190, 760, 66, -118, 0.50, rgb <0.36, 0.12, 0.03>)
Lay_Leaf(235, 905, 72, 200, 0.36, rgb <0.46, 0.30, 0.05>)
Lay_Leaf(-60, 1080, 62, 20, 0.55, rgb <0.30, 0.14, 0.04>)
Lay_Leaf(-330, 980, 70, 150, 0.40, rgb <0.44, 0.24, 0.04>)
Lay_Leaf(-20, 380, 50, 250, 0.60, rgb <0.34, 0.22, 0.05>)
