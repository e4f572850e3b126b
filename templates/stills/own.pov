// Persistence of Vision Ray Tracer Scene Description File
// Vers: 3.7
// Desc: The things of a scene where they stand in the world, its camera and its light, and nothing else: panes hang in the air;
//       below pavements lies a patch of bare earth that ends where the picture of all around goes on.
//       1 unit = 1 mm, y is up: the world's (x, y, z) is <x, z, y>.
//
// Reads, where they are declared before (as by Declare=Quality=0 on the command line):
//    Quality   0 for a draft: light from fewer sides; 1 for the picture itself

#version 3.7;
#ifndef(Quality) #declare Quality = 1; #end
global_settings {
   assumed_gamma 1.0
   // Two faces of the slab, and two walls of each of three gaps behind one another with their inner reflections.
   max_trace_level select(Quality - 1, 12, 16)
   adc_bailout select(Quality - 1, 1 / 40, 1 / 255)
}

//@model

Still_Camera(<0, 0, 0>, <0, 0, 0>)
Still_Light(<0, 0, 0>)

#for (I, 0, Still_Pane_Count - 1)
   object { Still_Pane(I) Still_Pane_Place(I) }
#end

#for (I, 0, Still_Pavement_Count - 1)
   object { Still_Pavement(I) Still_Pavement_Place(I) }
#end

// Bare earth: it fades out between one and two radii from the middle of the pavements.
#if (Still_Pavement_Count > 0)
   #declare Earth =
   pigment {
      granite
      color_map { [0.2 rgb <0.085, 0.072, 0.056>] [0.6 rgb <0.120, 0.104, 0.083>] [0.9 rgb <0.160, 0.143, 0.118>] }
      scale 180 / Still_Earth_Radius
   }
   disc {
      0, y, 2
      texture {
         pigment {
            function { pow(max(0, min(1, 2 - sqrt(x * x + z * z))), 2) }
            pigment_map { [0 rgb <0.120, 0.104, 0.083> transmit 1] [1 Earth] }
         }
         normal { granite 0.15 scale 60 / Still_Earth_Radius }
         finish { ambient 0 diffuse 0.9 }
      }
      scale Still_Earth_Radius
      translate Still_Earth_Middle
   }
#end
