// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A wet street at dusk: houses on both sides of the pavements, windows with light behind them, lanterns, and their
//       reflections. The street runs along y of the plan; the camera stands over its lower end and looks along it.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: fewer houses, no soft shadows; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings { assumed_gamma 1.0 max_trace_level 6 }

#include "shatterpave_town.inc"
//@model

#declare Low = Still_Pavement_Min[0];
#declare High = Still_Pavement_Max[0];
#for (I, 0, Still_Pavement_Count - 1)
   object { Still_Pavement(I) }
   #declare Low = <min(Low.x, Still_Pavement_Min[I].x), 0, min(Low.z, Still_Pavement_Min[I].z)>;
   #declare High = <max(High.x, Still_Pavement_Max[I].x), 0, max(High.z, Still_Pavement_Max[I].z)>;
#end
#declare Length = High.z - Low.z;
#declare Middle = (Low.x + High.x) / 2;

// ---- camera: at the height of somebody who has crouched for the reflections

#declare Eye = <Middle - (High.x - Low.x) * 0.10, 980, Low.z + 500>;
//@camera <0, 0, 0>, <0, 0, 0>
camera {
   perspective
   location Eye
   right x * image_width / image_height
   up y
   angle 54
   look_at <Middle + (High.x - Low.x) * 0.035, 620, Low.z + 9000>
}
//@end

// ---- light: what is left of the day, from all of the sky; lanterns; windows

//@light <0, 0, 0>
sky_sphere {
   pigment {
      gradient y
      color_map {
         [0.00 rgb <0.62, 0.36, 0.24>]
         [0.05 rgb <0.50, 0.36, 0.33>]
         [0.14 rgb <0.25, 0.29, 0.42>]
         [0.40 rgb <0.090, 0.145, 0.290>]
         [1.00 rgb <0.030, 0.060, 0.150>]
      }
   }
   pigment {
      bozo
      turbulence 0.7
      octaves 7
      color_map { [0.48 rgbt <0.4, 0.3, 0.3, 1>] [0.62 rgbt <0.34, 0.25, 0.28, 0.5>] [0.85 rgbt <0.16, 0.17, 0.24, 0.1>] }
      scale <0.5, 0.10, 0.5>
      translate <0.1, 0.3, 0.4>
   }
}
//@end

#macro Sky_Light(Towards, Light)
   light_source { vnormalize(Towards) * 1e6 rgb Light parallel point_at 0 }
#end
//@light
Sky_Light(<0.25, 1, 0.35>, <0.10, 0.145, 0.26> * 0.95)
Sky_Light(<-0.05, 0.5, 1>, <0.40, 0.30, 0.27> * 0.26)
#if (Quality > 0)
   Sky_Light(<-0.55, 1, 0.1>, <0.10, 0.145, 0.26> * 0.45)
   Sky_Light(<0.1, 1, -0.7>, <0.10, 0.145, 0.26> * 0.40)
#end
light_source { <0, 0.6, -1> * 1e6 rgb <0.09, 0.12, 0.20> * 0.35 parallel point_at 0 shadowless }
//@end

#declare Glow = rgb <1.0, 0.60, 0.26>;
#macro Lamp_Light(Place, Power)
   light_source {
      Place
      Glow * Power
      #if (Quality > 0) area_light x * 220, y * 260, 3, 3 adaptive 0 #end
      fade_distance 1900
      fade_power 2
   }
#end

#for (I, 0, 2)
   #declare Left = (mod(I, 2) = 0);
   #declare Z = Low.z + 5600 + 5200 * I;
   object {
      Town_Lantern(Glow)
      rotate y * select(-Left, -90, 90, 90)
      translate <select(-Left, Low.x, High.x, High.x), 3150, Z>
   }
//@light
   Lamp_Light(<select(-Left, Low.x + 620, High.x - 620, High.x), 3130, Z>, 3.4)
//@end
#end

// ---- houses: the left row seen from +x, the right one from -x

#declare R = seed(11);
#declare Plasters = array[6] {
   <0.40, 0.30, 0.20>, <0.36, 0.33, 0.28>, <0.42, 0.25, 0.17>, <0.30, 0.31, 0.29>, <0.43, 0.36, 0.24>, <0.34, 0.23, 0.19>
}
#declare Shutters = array[4] { <0.06, 0.10, 0.09>, <-1, -1, -1>, <0.12, 0.06, 0.05>, <0.05, 0.07, 0.11> }
#declare Houses = select(Quality - 1, 5, 6);
#macro Row(X, Turn, First)
   #local Z = Low.z - 2500 * First;
   #for (I, 0, Houses - 1)
      #local Width = 5400 + 2300 * rand(R);
      #local Set_Back = 60 * rand(R);
      object {
         Town_House(Width, 3 + floor(rand(R) * 1.7), Plasters[mod(I * 5 + 3 * First, 6)] * (0.85 + 0.25 * rand(R)), 0.34, Shutters[mod(I + 2 * First, 4)], 100 + 17 * I + First)
         // Turned to the street: the left row is laid from far to near.
         #if (Turn < 0) translate -x * Width #end
         rotate y * Turn
         translate <X + select(Turn, -Set_Back, Set_Back, Set_Back), 60, Z>
      }
      #local Z = Z + Width;
   #end
#end
// A front faces -z: turned by -90° it faces +x, by 90° it faces -x.
Row(Low.x, -90, 0)
Row(High.x, 90, 1)

// The street ends at a house across, and goes on behind it into haze.
object { Town_House(8600, 2, <0.34, 0.28, 0.22>, 0.5, <-1, -1, -1>, 77) rotate y * -12 translate <Middle - 3300, 60, Low.z + Length + 17000> }
plane { y, -40 pigment { granite color_map { [0.2 rgb 0.025] [0.9 rgb 0.055] } scale 300 } finish { ambient 0 diffuse 0.8 specular 0.3 roughness 0.02 reflection { 0.02, 0.3 falloff 4 } } }


// ---- bollards along the kerbs
#for (I, 0, 5)
   #for (S, -1, 1, 2)
      object { Town_Bollard(880) translate <Middle + S * ((High.x - Low.x) / 2 - 1300), 95, Low.z + 3600 + 2600 * I> }
   #end
#end
