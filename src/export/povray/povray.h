// Everything that POV-Ray reads of a model.
#pragma once

#include <vector>

#include "export/target.h"

namespace shatterpave::exporting::povray {

// The scene `NAME.pov`, one include file for each pane and pavement with the images that it reads, and the material includes
// that they need, so that the folder they are written to needs nothing else.
//
// The scene is the template `model.setting` (where that is empty: "window_still" if there is a pane, else "path_still"), in
// which the line `//@model` is replaced by declarations of what there is to see:
//    Still_Pane_Count, Still_Pavement_Count
//    Still_Pane(I), Still_Pane_Surround(I, Width, Depth), Still_Pavement(I), Still_Pavement_Bed(I)    macros, I from 0
// and, where there are any, the arrays
//    Still_Pane_Min, Still_Pane_Max, Still_Pane_Rectangular, Still_Pavement_Min, Still_Pavement_Max
// and, where a pane has shards, for each pane
//    Still_Pane_Sill_Drop, Still_Pane_Sill_Depth, Still_Pane_Frame, Still_Pane_Reveal, Still_Pane_Floor_Drop
// Throws InputError where there is no such template.
std::vector<OutputFile> povray_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{
    .name = "povray",
    .sentence = "a still for POV-Ray (SCENE.pov), with an include file of each pane and pavement and all that they need"};

// The names that `model.setting` may have, sorted.
std::vector<std::string> settings();

}  // namespace shatterpave::exporting::povray
