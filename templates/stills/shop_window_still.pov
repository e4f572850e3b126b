// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: A shop window at night, seen from the street: the first pane, close up and sharp, before the lights of the shop, which the
//       lens leaves out of focus. The lights are discs without depth, so a change of the glass is seen at once.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: fewer reflections in the glass; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings {
   assumed_gamma 1.0
   // Two faces of the slab, and two walls of each of three gaps behind one another with their inner reflections.
   max_trace_level select(Quality - 1, 10, 16)
   adc_bailout select(Quality - 1, 1 / 40, 1 / 255)
}

//@model

#declare Low = Still_Pane_Min[0];
#declare High = Still_Pane_Max[0];
#declare Middle = (Low + High) / 2;
#declare Size = max(High.x - Low.x, High.y - Low.y);
#declare R = seed(7);

// ---- the pane, about the origin; the camera fills the picture with it

object {
   Still_Pane(0)
   translate -Middle
}

//@camera -Middle, <0, 0, 0>
camera {
   location <-0.20, 0.03, -1.30> * Size
   right x * image_width / image_height
   up y
   angle 35
   look_at <0.015, 0.0, 0> * Size
}
//@end

// ---- the frame of the window: dark metal, at the borders of the picture

#declare Half = (High - Low) / 2;
union {
   box { <-Half.x - 0.2 * Size, -Half.y - 0.2 * Size, -0.012 * Size>, <-Half.x + 0.006 * Size, Half.y + 0.2 * Size, 0.02 * Size> }
   box { <Half.x - 0.006 * Size, -Half.y - 0.2 * Size, -0.012 * Size>, <Half.x + 0.2 * Size, Half.y + 0.2 * Size, 0.02 * Size> }
   box { <-Half.x, Half.y - 0.006 * Size, -0.012 * Size>, <Half.x, Half.y + 0.2 * Size, 0.02 * Size> }
   box { <-Half.x, -Half.y - 0.2 * Size, -0.012 * Size>, <Half.x, -Half.y + 0.006 * Size, 0.02 * Size> }
   texture {
      pigment { rgb <0.030, 0.032, 0.035> }
      normal { bumps 0.02 scale 0.004 * Size }
      finish { ambient 0 diffuse 0.5 specular 0.4 roughness 0.03 reflection { 0.02, 0.3 fresnel on } conserve_energy }
   }
   interior { ior 1.5 }
}

// ---- lights out of focus: discs of even brightness with a slightly brighter rim, as a lens draws them

#macro Light_Disc(Place, Radius, Colour)
   disc {
      0, z, 1
      pigment {
         function { min(1, x * x + y * y) }
         color_map {
            [0.00 rgb Colour transmit 0.32]
            [0.72 rgb Colour * 1.06 transmit 0.28]
            [0.88 rgb Colour * 1.45 transmit 0.22]
            [0.97 rgb Colour * 1.25 transmit 0.35]
            [1.00 rgb Colour transmit 1]
         }
      }
      finish { ambient 0 diffuse 0 emission 1 }
      scale <Radius, Radius, 1> * Size
      translate Place * Size
      no_shadow
   }
#end

//@light <0, 0, 0>
// The room: warm wall, darker to the floor and the ceiling, with shelves as soft bands.
sphere {
   0, 30 * Size
   hollow
   no_shadow
   pigment {
      function { 0.5 + 0.5 * y / 30 / Size }
      color_map {
         [0.00 rgb <0.006, 0.004, 0.004>]
         [0.42 rgb <0.012, 0.007, 0.005>]
         [0.485 rgb <0.042, 0.020, 0.009>]
         [0.525 rgb <0.075, 0.036, 0.014>]
         [0.60 rgb <0.026, 0.013, 0.008>]
         [1.00 rgb <0.010, 0.008, 0.010>]
      }
   }
   finish { ambient 0 diffuse 0 emission 1 }
   clipped_by { plane { -z, 0 } }
}

// The street behind the camera: a blue night, lit windows above, a wet road below.
sphere {
   0, 30 * Size
   hollow
   no_shadow
   pigment {
      function { 0.5 + 0.5 * y / 30 / Size }
      color_map {
         [0.00 rgb <0.004, 0.005, 0.010>]
         [0.45 rgb <0.012, 0.016, 0.030>]
         [0.52 rgb <0.030, 0.040, 0.075>]
         [1.00 rgb <0.004, 0.006, 0.016>]
      }
   }
   finish { ambient 0 diffuse 0 emission 1 }
   clipped_by { plane { z, 0 } }
}
//@end

// A row of hanging lamps, shelves of small lights, one cold sign.
#declare Warm = <1.00, 0.56, 0.22>;
#for (I, 0, 8)
   Light_Disc(<-2.6 + 0.66 * I + 0.2 * rand(R), 0.90 - 0.15 * mod(I, 2), 3.2 + 0.25 * rand(R)>, 0.17, Warm * 1.1)
#end
#for (I, 0, 110)
   #declare Row = mod(I, 3);
   #declare Hue = rand(R);
   Light_Disc(<-3.4 + 6.8 * rand(R), 0.40 - 0.40 * Row + 0.16 * rand(R), 3.8 + 0.7 * rand(R)>, 0.085 + 0.06 * rand(R),
      (Hue * <1.0, 0.66, 0.34> + (1 - Hue) * <0.95, 0.36, 0.16>) * (0.05 + 0.75 * pow(rand(R), 3)))
#end
Light_Disc(<1.62, -0.42, 3.3>, 0.17, <0.10, 0.62, 0.85> * 0.85)
Light_Disc(<1.42, -0.60, 3.5>, 0.17, <0.10, 0.50, 0.80> * 0.6)
Light_Disc(<-1.35, -0.62, 3.4>, 0.16, <0.90, 0.10, 0.28> * 0.75)

// Far aside, where leaning walls of cracks look: tubes of light along the walls of the shop, and the street's lamps and signs.
#macro Lamp(A, B, Colour)
   box { A * Size, B * Size pigment { rgb Colour } finish { ambient 0 diffuse 0 emission 1 } no_shadow }
#end
Lamp(<-6.2, -1.0, 1.5>, <-6.0, 2.6, 2.6>, <1.0, 0.62, 0.30> * 5)
Lamp(<5.6, -0.6, 1.2>, <5.8, 2.9, 2.2>, <1.0, 0.70, 0.42> * 5)
Lamp(<-2.0, 4.2, 1.2>, <2.2, 4.3, 2.6>, <1.0, 0.80, 0.55> * 5)
Lamp(<-2.4, -3.0, 1.6>, <1.6, -2.95, 2.8>, <0.9, 0.50, 0.25> * 1.6)
Lamp(<-5.4, 0.6, -3.6>, <-4.4, 1.7, -3.5>, <0.16, 0.75, 1.0> * 3.2)
Lamp(<4.6, 1.6, -4.6>, <5.3, 4.2, -4.5>, <1.0, 0.22, 0.36> * 3.0)
Lamp(<0.8, 3.6, -5.4>, <1.8, 4.4, -5.3>, <0.8, 0.88, 1.0> * 4.5)

// ---- light that dust and frost catch: two lamps of the shop behind the pane, one of the street before it

//@light
light_source { <-0.9, 1.3, 1.6> * Size, rgb <1.00, 0.66, 0.36> * 1.25 }
light_source { <1.3, 0.5, 1.2> * Size, rgb <1.00, 0.72, 0.45> * 0.75 }
light_source { <-2.6, 2.0, -2.4> * Size, rgb <0.40, 0.55, 0.85> * 0.55 shadowless }
//@end

// The display's ledge, on which caustics fall.
box {
   <-3, -0.56, 0.03> * Size, <3, -0.53, 0.9> * Size
   texture {
      pigment { rgb <0.06, 0.035, 0.022> }
      finish { ambient 0 diffuse 0.7 specular 0.2 roughness 0.05 }
   }
}
