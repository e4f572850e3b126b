// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A glass door that has broken and still stands in its frame, seen from the pavement: the first pane, before a hall with a lamp,
//       a window and a tiled floor. Frame and camera follow the size of the pane; the picture is as wide as the door and its frame.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: lights without extent, fewer reflections in the glass; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings {
   assumed_gamma 1.0
   // Two faces of the slab, and those of three tubes behind one another with their inner reflections.
   max_trace_level select(Quality - 1, 8, 16)
   adc_bailout select(Quality - 1, 1 / 40, 1 / 255)
}

#include "functions.inc"
//@model

#declare Low = Still_Pane_Min[0];
#declare High = Still_Pane_Max[0];
#declare W = High.x - Low.x;
#declare H = High.y - Low.y;
#declare Centre = (Low.x + High.x) / 2;

// The pane stands with its lower edge at y = 0, its middle at x = 0.
// Its dice throw no shadows: rays to lights need not pass thousands of gaps.
object { Still_Pane(0) no_shadow translate <-Centre, -Low.y, 0> }

//@camera <-Centre, -Low.y, 0>, <0, 0, 0>
camera {
   location <-0.42, 0.62 * H / W, -1.62> * W
   right x * image_width / image_height
   up y
   angle 44
   look_at <0.015, 0.56 * H / W, 0> * W
}
//@end

// ---- frame: brushed steel, with a bar to pull

#declare Steel =
texture {
   pigment { rgb <0.32, 0.33, 0.34> }
   normal { bozo 0.08 scale <0.004, 0.4, 0.004> * W }
   finish { ambient 0 diffuse 0.35 specular 0.5 roughness 0.03 reflection { 0.18 metallic } metallic conserve_energy }
}
#declare Stile = 0.065 * W;
#declare Deep = 0.028 * W;
union {
   box { <-W / 2 - Stile, -0.2 * W, -Deep>, <-W / 2 + 0.012 * W, H + Stile, Deep> }
   box { <W / 2 - 0.012 * W, -0.2 * W, -Deep>, <W / 2 + Stile, H + Stile, Deep> }
   box { <-W / 2, H - 0.012 * W, -Deep>, <W / 2, H + Stile, Deep> }
   box { <-W / 2, -0.2 * W, -Deep>, <W / 2, 0.012 * W, Deep> }
   texture { Steel }
}
// The bar, on two stand-offs that the left stile holds.
union {
   cylinder { <0, 0.36 * H, 0>, <0, 0.70 * H, 0>, 0.017 * W }
   sphere { <0, 0.36 * H, 0>, 0.017 * W }
   sphere { <0, 0.70 * H, 0>, 0.017 * W }
   cylinder { <0, 0.41 * H, 0>, <0, 0.41 * H, 0.09 * W>, 0.011 * W }
   cylinder { <0, 0.65 * H, 0>, <0, 0.65 * H, 0.09 * W>, 0.011 * W }
   translate <-W / 2 - 0.40 * Stile, 0, -0.09 * W - Deep>
   texture { Steel }
}

// ---- the wall about the door: limestone, with a band of dark basalt at its foot

#declare Wall_Texture =
texture {
   pigment {
      granite turbulence 0.3
      color_map { [0 rgb <0.50, 0.44, 0.34>] [0.5 rgb <0.58, 0.52, 0.41>] [1 rgb <0.42, 0.37, 0.29>] }
      scale 0.6 * W
   }
   normal { granite 0.06 scale 0.4 * W }
   finish { ambient 0 diffuse 0.75 }
}
#declare Outside = W / 2 + Stile;
union {
   box { <-6 * W, -0.3 * W, -0.05 * W>, <-Outside, 6 * W, 0.20 * W> }
   box { <Outside, -0.3 * W, -0.05 * W>, <6 * W, 6 * W, 0.20 * W> }
   box { <-Outside, H + Stile, -0.05 * W>, <Outside, 6 * W, 0.20 * W> }
   texture { Wall_Texture }
}

//@light <0, 0, 0>
// ---- where the scene has no light of its own: flags before the door

box {
   <-8 * W, -0.5 * W, -9 * W>, <8 * W, -0.02 * W, 0.0>
   texture {
      pigment { granite color_map { [0 rgb 0.30] [1 rgb 0.44] } scale W }
      normal { granite 0.2 scale 0.3 * W }
      finish { ambient 0 diffuse 0.7 }
   }
}
// ---- the hall behind: tiles, walls, a window at the end, a lamp, a plant in a pot

#declare Long = 4.6 * W;
#declare Side = 1.35 * W;
#declare Tall = H + 0.35 * W;
box {
   <-Side, -0.02 * W, 0>, <Side, 0, Long>
   texture {
      pigment { checker rgb <0.50, 0.47, 0.42> rgb <0.10, 0.10, 0.11> scale 0.34 * W translate 0.1 * W }
      finish { ambient 0 diffuse 0.7 specular 0.3 roughness 0.02 reflection 0.06 }
   }
}
#declare Plaster =
texture { pigment { rgb <0.62, 0.50, 0.36> } normal { granite 0.05 scale W } finish { ambient 0 diffuse 0.8 } }
union {
   box { <-Side - 0.1 * W, 0, 0.2 * W>, <-Side, Tall, Long> }
   box { <Side, 0, 0.2 * W>, <Side + 0.1 * W, Tall, Long> }
   box { <-Side, Tall, 0>, <Side, Tall + 0.1 * W, Long> }
   difference {
      box { <-Side, 0, Long>, <Side, Tall, Long + 0.2 * W> }
      box { <-0.55 * W, 0.35 * H, Long - W>, <0.75 * W, 0.86 * H, Long + W> }
   }
   texture { Plaster }
}
union {
   box { <-0.57 * W, 0.60 * H, Long>, <0.77 * W, 0.615 * H, Long + 0.1 * W> }
   box { <0.09 * W, 0.35 * H, Long>, <0.12 * W, 0.86 * H, Long + 0.1 * W> }
   texture { pigment { rgb <0.12, 0.09, 0.07> } finish { ambient 0 diffuse 0.7 } }
}
// What the window shows: a bright garden.
box {
   <-3 * W, -W, Long + 1.2 * W>, <3 * W, 4 * W, Long + 1.21 * W>
   pigment {
      function { max(0, min(1, 0.5 + (y / W - 1.15 + 0.5 * (f_noise3d(1.6 * x / W, 1.6 * y / W, 3) - 0.5)) / 1.2)) }
      color_map {
         [0.0 rgb <0.10, 0.20, 0.04>]
         [0.4 rgb <0.28, 0.42, 0.10>]
         [0.6 rgb <0.60, 0.74, 0.60>]
         [1.0 rgb <0.92, 0.98, 1.05>]
      }
   }
   finish { ambient 0 diffuse 0 emission 1.25 }
}
// A globe of light on the left wall.
sphere { <-Side + 0.22 * W, 0.80 * H, 1.9 * W>, 0.11 * W pigment { rgb <1.0, 0.80, 0.52> } finish { ambient 0 diffuse 0 emission 2.6 } no_shadow }
// A pot with long leaves.
union {
   cone { 0, 0.13 * W, 0.34 * W * y, 0.18 * W texture { pigment { rgb <0.36, 0.15, 0.08> } finish { ambient 0 diffuse 0.75 } } }
   #declare R = seed(4);
   #for (I, 0, 34)
      sphere {
         0, 1
         scale <0.030, 0.40, 0.012> * W
         translate 0.40 * W * y
         rotate <0, 0, 10 + 52 * rand(R)>
         rotate 360 * rand(R) * y
         translate 0.30 * W * y
         texture { pigment { rgb <0.07, 0.19, 0.05> * (0.7 + 0.7 * rand(R)) } finish { ambient 0 diffuse 0.7 specular 0.2 roughness 0.05 } }
      }
   #end
   translate <0.80, 0, 2.2> * W
}

// ---- the sky that the glass mirrors

sphere {
   0, 60 * W
   hollow
   no_shadow
   pigment {
      gradient y
      color_map { [0.50 rgb <0.32, 0.30, 0.28>] [0.53 rgb <0.50, 0.55, 0.62>] [0.75 rgb <0.22, 0.34, 0.56>] [1 rgb <0.10, 0.20, 0.44>] }
      scale 120 * W
      translate -60 * W * y
   }
   finish { ambient 0 diffuse 0 emission 1 }
}

#macro Lamp(Place, Colour, Extent)
   light_source {
      Place * W, rgb Colour
      #if (Quality > 0) area_light Extent * W * x, Extent * W * z, 4, 4 adaptive 1 jitter circular orient #end
   }
#end
// The sun high on the left, the globe in the hall, the window at its end: the light from behind is what cracks are seen by.
Lamp(<-4.0, 5.5, -8.0>, <1.00, 0.90, 0.74> * 1.9, 0.5)
Lamp(<-1.0, 1.75, 1.9>, <1.00, 0.78, 0.50> * 0.55, 0.15)
Lamp(<0.1, 1.5, 4.4>, <0.80, 0.92, 1.00> * 0.75, 0.6)
light_source { <4, 5, -7> * W, rgb <0.45, 0.55, 0.75> * 0.35 shadowless }
//@end
