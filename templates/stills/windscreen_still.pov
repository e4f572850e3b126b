// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: The windscreen of a car at dusk, seen from the driver's seat: the first pane, raked, before a road whose lights are out of
//       focus. They are discs and bands without depth, so a change of the glass is seen at once.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: fewer reflections in the glass; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings {
   assumed_gamma 1.0
   // Two faces of the slab, and those of three tubes behind one another with their inner reflections.
   max_trace_level select(Quality - 1, 10, 14)
   adc_bailout select(Quality - 1, 1 / 40, 1 / 255)
}

//@model

#declare Low = Still_Pane_Min[0];
#declare High = Still_Pane_Max[0];
#declare Middle = (Low + High) / 2;
#declare W = High.x - Low.x;
#declare H = High.y - Low.y;
#declare R = seed(11);

// ---- the pane leans towards the driver at the top; all that holds it leans along

#declare Raked = transform { rotate -26 * x };

#declare Lining =
texture {
   pigment { rgb <0.012, 0.012, 0.013> }
   normal { granite 0.03 scale 0.02 * W }
   finish { ambient 0 diffuse 0.5 specular 0.06 roughness 0.15 }
}

union {
   object { Still_Pane(0) no_shadow }   // dark as all is within, nobody sees it; and rays to lights need not pass thousands of gaps
   object { Still_Pane_Surround(0, 0.45 * W, 0.05 * W) translate -0.02 * W * z texture { Lining } }
   translate -Middle
   transform { Raked }
}

//@camera -Middle, <0, 0, 0>
camera {
   location <-0.21, 0.035, -0.68> * W
   right x * image_width / image_height
   up y
   angle 62
   look_at <0.045, -0.010, 0> * W
}
//@end

// ---- within the car: dashboard with its hood, wheel, mirror

#declare Plastic =
texture {
   pigment { rgb <0.010, 0.010, 0.011> }
   normal { granite 0.03 scale 0.02 * W }
   finish { ambient 0 diffuse 0.5 specular 0.10 roughness 0.09 }
}
union {
   superellipsoid { <0.16, 0.5> scale <0.75, 0.060, 0.22> * W translate <0, -0.315, -0.11> * W }
   superellipsoid { <0.6, 0.5> scale <0.17, 0.045, 0.13> * W translate <-0.27, -0.268, -0.20> * W }
   texture { Plastic }
}
union {
   torus { 0.128 * W, 0.0105 * W rotate -66 * x }
   sphere { 0, 0.034 * W scale <1, 1, 0.5> }
   cylinder { <-0.125, 0, 0> * W, <0.125, 0, 0> * W, 0.009 * W }
   translate <-0.27, -0.305, -0.37> * W
   texture { pigment { rgb 0.012 } finish { ambient 0 diffuse 0.5 specular 0.35 roughness 0.05 } }
}
union {
   superellipsoid { <0.4, 0.3> scale <0.085, 0.026, 0.010> * W rotate <4, -14, 0> translate <0.055, 0.205, -0.155> * W }
   cylinder { <0.055, 0.22, -0.15> * W, <0.045, 0.29, -0.10> * W, 0.006 * W }
   texture { Plastic }
}

// ---- the road at dusk, out of focus

//@light <0, 0, 0>
// Sky and ground as one sphere: afterglow at the horizon, wet asphalt that mirrors it below.
sphere {
   0, 60 * W
   hollow
   no_shadow
   pigment {
      function { 0.5 + 0.5 * y / 60 / W }
      color_map {
         [0.000 rgb <0.010, 0.011, 0.014>]
         [0.380 rgb <0.020, 0.021, 0.026>]
         [0.470 rgb <0.050, 0.045, 0.050>]
         [0.496 rgb <0.120, 0.078, 0.065>]
         [0.500 rgb <0.60, 0.30, 0.15>]
         [0.515 rgb <0.64, 0.37, 0.22>]
         [0.545 rgb <0.40, 0.30, 0.28>]
         [0.600 rgb <0.15, 0.175, 0.26>]
         [0.720 rgb <0.045, 0.070, 0.145>]
         [1.000 rgb <0.014, 0.024, 0.060>]
      }
   }
   finish { ambient 0 diffuse 0 emission 1 }
}

// Trees and houses on either side, soft at their upper edge, lower towards the vanishing point.
#declare Skyline_Length = 16;
#macro Skyline(Side, Near, Seed)
   box {
      0, <1, 1, 0.001>
      pigment {
         function {
            max(0, min(1, (y - 0.0985 - 0.075 * Skyline_Length * x * (0.35 + 0.9 * f_noise3d(1.9 * Skyline_Length * x, Seed, 0.3)
                                                                       + 0.35 * f_noise3d(8 * Skyline_Length * x, Seed, 4)))
                          / (0.004 + 0.012 * Skyline_Length * x)))
         }
         color_map { [0 rgb <0.014, 0.016, 0.020> transmit 0] [1 rgb <0.014, 0.016, 0.020> transmit 1] }
      }
      finish { ambient 0 diffuse 0 emission 1 }
      no_shadow
      scale <Skyline_Length, 3.4, 1> * W
      translate <0.06, -0.30, 0> * W
      scale <Side, 1, 1>
      translate <0.05, 0, Near> * W
   }
#end
#include "functions.inc"
Skyline(1, 8.2, 3)
Skyline(-1, 8.0, 17)

// The lines of the road, as soft bands that run to the vanishing point.
#macro Line(Left, Wide, From, To)
   polygon {
      5, <Left - Wide, From>, <Left + Wide, From>, <Left + Wide, To>, <Left - Wide, To>, <Left - Wide, From>
      pigment {
         function { min(1, pow((x - Left) / Wide, 2)) }
         color_map { [0 rgb 0.10 transmit 0.2] [1 rgb 0.10 transmit 1] }
      }
      finish { ambient 0 diffuse 0 emission 1 }
      no_shadow
      scale W
      rotate 90 * x
      translate -0.55 * W * y
   }
#end
#for (I, 0, 7)
   Line(0.05, 0.06, 1.2 + 1.6 * I, 2.0 + 1.6 * I)
#end
Line(1.35, 0.08, 0.6, 16)
Line(-1.35, 0.08, 0.6, 16)

// Discs of even brightness with a slightly brighter rim, as a lens draws points out of focus.
#macro Light_Disc(Place, Radius, Colour)
   disc {
      0, z, 1
      pigment {
         function { min(1, x * x + y * y) }
         color_map {
            [0.00 rgb Colour transmit 0.30]
            [0.72 rgb Colour * 1.06 transmit 0.26]
            [0.90 rgb Colour * 1.35 transmit 0.20]
            [0.97 rgb Colour * 1.15 transmit 0.40]
            [1.00 rgb Colour transmit 1]
         }
      }
      finish { ambient 0 diffuse 0 emission 1 }
      scale <Radius, Radius, 1> * W
      translate Place * W
      no_shadow
   }
#end

// Street lamps on both sides and their mirrors on the road, smaller towards the vanishing point at the height of the eye.
#declare Eye = 0.035;
#for (I, 0, 6)
   #declare Far = 1 / (1 + 0.62 * I);
   #for (J, -1, 1, 2)
      Light_Disc(<0.10 + J * 2.9 * Far, Eye + 1.55 * Far, 6.6 + 0.1 * I>, 0.155 * sqrt(Far), <1.0, 0.60, 0.24> * (0.85 + 0.25 * Far))
      Light_Disc(<0.10 + J * 2.5 * Far, Eye - 1.05 * Far, 6.5 + 0.1 * I>, 0.12 * sqrt(Far), <1.0, 0.55, 0.22> * 0.10)
   #end
#end
// Two cars that come and three that go, each a pair of lamps.
#macro Pair(X, Y, Wide, Radius, Colour)
   Light_Disc(<X - Wide / 2, Y, 6.0>, Radius, Colour)
   Light_Disc(<X + Wide / 2, Y, 6.02>, Radius, Colour)
   Light_Disc(<X - Wide / 2, 2 * (Eye - 0.22) - Y - 0.12, 6.04>, Radius * 0.9, Colour * 0.12)
   Light_Disc(<X + Wide / 2, 2 * (Eye - 0.22) - Y - 0.12, 6.06>, Radius * 0.9, Colour * 0.12)
#end
Pair(-0.78, Eye - 0.20, 0.46, 0.17, <1.0, 0.92, 0.76> * 1.7)
Pair(-0.34, Eye - 0.12, 0.20, 0.10, <1.0, 0.90, 0.74> * 1.5)
Pair(0.74, Eye - 0.21, 0.52, 0.13, <1.0, 0.05, 0.03> * 1.1)
Pair(0.40, Eye - 0.12, 0.20, 0.08, <1.0, 0.06, 0.03> * 0.9)
// Windows of houses.
#for (I, 0, 26)
   #declare X = 0.55 + 3.2 * rand(R);
   #declare Side = select(rand(R) - 0.5, -1, 1);
   #declare Up = rand(R);
   Light_Disc(<0.1 + Side * X, Eye + 0.02 + 0.30 * X * Up, 7.4>, 0.045 + 0.03 * rand(R), <1.0, 0.72, 0.40> * (0.10 + 0.45 * rand(R) * rand(R)))
#end

// ---- light that the walls of cracks scatter: the sky over the bonnet, the lamps of the cars that come, a little from within

light_source { <0.6, 2.4, 2.2> * W, rgb <0.42, 0.48, 0.66> * 1.15 }
light_source { <-0.7, -0.15, 3.0> * W, rgb <1.00, 0.88, 0.70> * 0.85 }
light_source { <1.8, 0.9, 2.4> * W, rgb <1.00, 0.58, 0.26> * 0.55 }
light_source { <-0.5, 0.6, -1.6> * W, rgb <0.40, 0.46, 0.60> * 0.12 shadowless }
//@end
