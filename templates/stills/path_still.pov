// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A pavement on an early morning: lawn on both sides, a gate in an old wall at its end, and a low sun behind trees.
//       The camera stands at one end of the pavement and looks along its longer side, whatever its size.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: less grass, fewer leaves, light from fewer sides; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings { assumed_gamma 1.0 max_trace_level 8 }

#include "shatterpave_garden.inc"
//@model

// ---- the pavements, laid along +z from the origin

#declare Low = Still_Pavement_Min[0];
#declare High = Still_Pavement_Max[0];
#for (I, 1, Still_Pavement_Count - 1)
   #declare Low = <min(Low.x, Still_Pavement_Min[I].x), 0, min(Low.z, Still_Pavement_Min[I].z)>;
   #declare High = <max(High.x, Still_Pavement_Max[I].x), 0, max(High.z, Still_Pavement_Max[I].z)>;
#end
#declare Length = max(High.x - Low.x, High.z - Low.z);
#declare Width = min(High.x - Low.x, High.z - Low.z);
#declare Place = transform {
   translate -<(Low.x + High.x) / 2, 0, (Low.z + High.z) / 2>
   #if (High.x - Low.x > High.z - Low.z) rotate -90 * y #end
   translate z * Length / 2
}
#for (I, 0, Still_Pavement_Count - 1)
   object { Still_Pavement(I) transform { Place } }
#end

// All beds together, for asking what is paved.
#declare Paved = object { Still_Pavement_Bed(0) transform { Place } }
#for (I, 1, Still_Pavement_Count - 1)
   #declare Paved = union { object { Paved } object { Still_Pavement_Bed(I) transform { Place } } }
#end

#macro Is_Paved(X, Z) (inside(Paved, <X, -10, Z>)) #end

// The middle of the pavement across z = Z; 0 where there is none.
#macro Middle_At(Z)
   #local Sum = 0;
   #local Count = 0;
   #for (I, 0, 80)
      #local X = Width * (I / 80 - 0.5);
      #if (Is_Paved(X, Z)) #local Sum = Sum + X; #local Count = Count + 1; #end
   #end
   (Sum / max(1, Count))
#end

// ---- camera: at the height of a child's eye on a path, on a plaza at that of somebody on a bench

#declare Is_Plaza = (Width > 6000);
#declare Eye_Height = min(2300, 600 + Width * 0.12);
#declare Near = select(Is_Plaza - 1, min(250, Length * 0.03), Length * 0.12);
#declare Ahead = select(Is_Plaza - 1, min(Length * 0.55, 6200), Length * 0.45);
#declare Eye = <Middle_At(Near + 400), Eye_Height, Near>;
//@camera z * Length / 2 - vrotate(<Low.x + High.x, 0, Low.z + High.z> / 2, -90 * y * (High.x - Low.x > High.z - Low.z)), -90 * y * (High.x - Low.x > High.z - Low.z)
camera {
   perspective
   location Eye
   right x * image_width / image_height
   up y
   angle 50
   look_at <(Middle_At(Ahead) * 0.6 + Eye.x * 0.4), select(Is_Plaza - 1, 230, -Length * 0.03), Ahead>
}
//@end

// ---- light: a low sun on the left, a little behind the camera, and the sky from all sides

#declare To_Sun = vnormalize(<-0.88, 0.33, -0.26>);
//@light -90 * y * (High.x - Low.x > High.z - Low.z)
light_source { To_Sun * 1e7 rgb <1.00, 0.78, 0.50> * 4.6 parallel point_at 0 }
//@end

#macro Sky_Light(Towards, Light)
   light_source { vnormalize(Towards) * 1e7 rgb Light parallel point_at 0 }
#end
//@light
#if (Quality > 0)
   Sky_Light(<0.15, 1, 0.1>, <0.30, 0.40, 0.58> * 0.62)
   Sky_Light(<0.9, 0.75, -0.5>, <0.30, 0.38, 0.52> * 0.42)
   Sky_Light(<-0.4, 0.7, -0.9>, <0.30, 0.38, 0.52> * 0.42)
   Sky_Light(<-0.3, 0.6, 0.9>, <0.50, 0.44, 0.40> * 0.42)
#else
   Sky_Light(<0.15, 1, 0.1>, <0.30, 0.40, 0.58> * 1.3)
#end
light_source { <0.3, 0.5, -1> * 1e7 rgb <0.30, 0.36, 0.46> * 0.28 parallel point_at 0 shadowless }
//@end

//@light
sky_sphere {
   pigment {
      gradient y
      color_map {
         [0.000 rgb <1.05, 0.80, 0.55>]
         [0.060 rgb <0.98, 0.82, 0.64>]
         [0.180 rgb <0.66, 0.72, 0.78>]
         [0.400 rgb <0.30, 0.45, 0.68>]
         [1.000 rgb <0.10, 0.20, 0.46>]
      }
   }
   pigment {
      bozo
      turbulence 0.75
      octaves 8
      omega 0.55
      color_map {
         [0.46 rgbt <1.0, 0.95, 0.9, 1>]
         [0.60 rgbt <1.12, 0.98, 0.84, 0.40>]
         [0.80 rgbt <1.02, 0.90, 0.82, 0.05>]
      }
      scale <0.42, 0.075, 0.42>
      translate <0.3, 0.02, 0.8>
   }
}
//@end

// ---- ground

plane {
   y, -6
   texture {
      pigment {
         bozo
         turbulence 0.6
         color_map { [0.2 rgb <0.040, 0.062, 0.014>] [0.6 rgb <0.062, 0.092, 0.020>] [1.0 rgb <0.085, 0.085, 0.030>] }
         scale 700
      }
      normal { granite 0.5 scale 90 }
      finish { ambient 0 diffuse 0.85 }
   }
}

// Beyond the wall a hay meadow, with the lane that the gate opens to.
box {
   <-400000, -7, Length + 400>, <400000, -5, 400000>
   texture {
      pigment {
         bozo
         turbulence 0.5
         color_map { [0.2 rgb <0.150, 0.165, 0.045>] [0.6 rgb <0.215, 0.205, 0.070>] [1.0 rgb <0.120, 0.150, 0.040>] }
         scale <2600, 1, 900>
      }
      normal { granite 0.6 scale 300 }
      finish { ambient 0 diffuse 0.85 }
   }
}

#declare R = seed(5);

// ---- lawn: squares of turf near the camera, coarser ones farther away, tufts where a square would lie on the pavement

#declare Turf_Side = 170;
#declare Turf_Blades = select(Quality - 1, 170, 520);
#declare Turfs = array[3];
#declare Coarse_Turfs = array[3];
#declare Tufts = array[4];
#for (I, 0, 2)
   #declare Turfs[I] = Garden_Turf(Turf_Side, Turf_Blades, 58, 11 + I)
   #declare Coarse_Turfs[I] = Garden_Turf(2 * Turf_Side, Turf_Blades, 66, 31 + I)
#end
#for (I, 0, 3)
   #declare Tufts[I] = Garden_Tuft(34, 46, 62, 51 + I)
#end

#macro Lay_Turf(Kind, X, Z)
   object { Kind rotate y * 90 * floor(rand(R) * 4) scale <1, 0.8 + 0.45 * rand(R), 1> translate <X, -6, Z> }
#end

#macro Touches_Pavement(X, Z, Half)
   (Is_Paved(X - Half, Z - Half) | Is_Paved(X + Half, Z - Half) | Is_Paved(X - Half, Z + Half) | Is_Paved(X + Half, Z + Half)
    | Is_Paved(X, Z))
#end

// A square that touches the pavement becomes tufts on the part of it that is not paved.
#macro Lay_Edge(X, Z, Half, Step)
   #local A = X - Half + Step / 2;
   #while (A < X + Half)
      #local B = Z - Half + Step / 2;
      #while (B < Z + Half)
         #local TX = A + (rand(R) - 0.5) * Step;
         #local TZ = B + (rand(R) - 0.5) * Step;
         #if (!Is_Paved(TX, TZ))
            object { Tufts[floor(rand(R) * 3.999)] rotate y * 360 * rand(R) scale <1, 0.75 + 0.7 * rand(R), 1> translate <TX, -6, TZ> }
         #end
         #local B = B + Step;
      #end
      #local A = A + Step;
   #end
#end

#macro Lay_Lawn(From_Z, To_Z, Reach, Side, Kinds, Tuft_Step)
   #local Z = From_Z + Side / 2;
   #while (Z < To_Z)
      #local X = Eye.x - Reach;
      #while (X < Eye.x + Reach)
         // Only what the camera can see, and what stands just beside.
         #if (abs(X - Eye.x) < 900 + 0.75 * (Z - Eye.z))
            #if (Touches_Pavement(X, Z, Side / 2)) Lay_Edge(X, Z, Side / 2, Tuft_Step) #else Lay_Turf(Kinds[floor(rand(R) * 2.999)], X, Z) #end
         #end
         #local X = X + Side;
      #end
      #local Z = Z + Side;
   #end
#end

#declare Lawn_Near = 5200;
#declare Lawn_End = Length + 1500;
Lay_Lawn(Eye.z, min(Lawn_End, Eye.z + Lawn_Near), 4300, Turf_Side, Turfs, 42)
#if (Lawn_End > Eye.z + Lawn_Near & !Is_Plaza)
   Lay_Lawn(Eye.z + Lawn_Near, min(Lawn_End, 16000), 5200, 2 * Turf_Side, Coarse_Turfs, 70)
#end

// Daisies, where the camera can tell them from blades.
#declare Daisy = Garden_Daisy(52)
#for (I, 1, 260)
   #declare Out = pow(rand(R), 0.6) * 4500;
   #declare X = Eye.x + (rand(R) - 0.5) * (1800 + Out * 1.3);
   #declare Z = Eye.z + Out;
   // In swarms, as they grow.
   #if (sin(X / 310) * cos(Z / 420 + X / 900) > 0.15 & !Touches_Pavement(X, Z, 60))
      object { Daisy rotate <rand(R) * 30 - 15, rand(R) * 360, rand(R) * 30 - 15> scale 0.85 + 0.35 * rand(R) translate <X, -6, Z> }
   #end
#end

// ---- gateway at the end

#declare End_X = Middle_At(Length - 150);
#declare Gate_Z = Length + 350;
#declare Opening = max(1500, min(Width, 2600));
#declare Pillar = Garden_Pillar(420, 1750)
object { Pillar translate <End_X - Opening / 2 - 210, -6, Gate_Z> }
object { Pillar rotate y * 90 translate <End_X + Opening / 2 + 210, -6, Gate_Z> }
object { Garden_Gate(Opening / 2, 1250) rotate y * 62 translate <End_X - Opening / 2, 30, Gate_Z + 120> }
object { Garden_Gate(Opening / 2, 1250) rotate y * 48 scale <-1, 1, 1> translate <End_X + Opening / 2, 30, Gate_Z + 120> }

#declare Side_Length = max(9000, Width);
object { Garden_Wall(<End_X - Opening / 2 - 400 - Side_Length, -6, Gate_Z>, <End_X - Opening / 2 - 400, -6, Gate_Z>, 1050, 380, 3) }
object { Garden_Wall(<End_X + Opening / 2 + 400, -6, Gate_Z>, <End_X + Opening / 2 + 400 + Side_Length, -6, Gate_Z>, 1050, 380, 4) }

// Grass that the mower does not reach.
#declare Rank = Garden_Tuft(55, 40, 190, 61)
#for (I, 1, select(Quality - 1, 90, 260))
   #declare X = End_X + (rand(R) * 2 - 1) * 6500;
   #if (abs(X - End_X) > Opening / 2)
      object { Rank rotate y * 360 * rand(R) scale <1, 0.5 + 0.8 * rand(R), 1> translate <X, -6, Gate_Z - 240 - 60 * rand(R)> }
   #end
#end

// ---- trees: behind the wall, and one out of sight that throws its shadow over the path

#declare Clump = Garden_Leaves(1, select(Quality - 1, 60, 150), 0.34, 71)
#declare Leaf_Green = object { Clump Garden_Leaf_Texture(rgb <0.075, 0.135, 0.022>) }
#declare Leaf_Light = object { Clump Garden_Leaf_Texture(rgb <0.130, 0.180, 0.030>) }
#declare Leaf_Far = object { Clump Garden_Leaf_Texture(rgb <0.150, 0.185, 0.110>) }

object { Garden_Tree(6800, 2600, 420, Leaf_Green, 21) translate <End_X - 5200, -6, Gate_Z + 6500> }
object { Garden_Tree(5200, 2100, 360, Leaf_Light, 22) translate <End_X + 4300, -6, Gate_Z + 5200> }
object { Garden_Tree(8200, 3400, 380, Leaf_Far, 23) translate <End_X + 2500, -6, Gate_Z + 26000> }
object { Garden_Tree(9000, 3600, 380, Leaf_Far, 24) translate <End_X - 13500, -6, Gate_Z + 29000> }
object { Garden_Tree(7000, 3300, 380, Leaf_Far, 25) translate <End_X + 13500, -6, Gate_Z + 26000> }
object { Garden_Tree(8200, 1000, 170, Leaf_Green, 26) translate <Eye.x - 15200, -6, Eye.z + 1700> }

// A plaza is lined with trees on both sides.
#if (Is_Plaza)
   #for (I, 0, 7)
      #for (Side, -1, 1, 2)
         object { Garden_Tree(7000 + 2500 * rand(R), 3000, 240, Leaf_Green, 40 + 2 * I + Side)
            translate <Side * (Width / 2 + 2500 + 3000 * rand(R)), -6, Length * (0.22 + 0.78 * I / 7)> }
      #end
   #end
#end

// Hills, paler the farther they are.
#macro Hill(X, Z, Radius, Height, Colour)
   sphere { 0, 1 scale <Radius, Height, Radius * 0.4> translate <X, -6, Z>
      pigment { bozo color_map { [0.3 rgb Colour] [0.7 rgb Colour * 0.86] } scale 9000 } finish { ambient 0 diffuse 0.8 emission 0.25 } }
#end
Hill(-160000, 330000, 390000, 19000, <0.20, 0.26, 0.27>)
Hill(240000, 360000, 420000, 28000, <0.24, 0.30, 0.34>)
Hill(60000, 250000, 330000, 9000, <0.15, 0.20, 0.12>)
