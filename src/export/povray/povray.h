// Everything that POV-Ray reads of a model.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
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
// The template "own" shows the things where they stand in the world, and reads
//    Still_Pane_Place(I), Still_Pavement_Place(I)    macros: transformations
//    Still_Earth_Middle, Still_Earth_Radius          where there are pavements: the ground below them
// Other templates put the things where they need them. What of a template stands between lines that begin with `//@camera` or
// `//@light` and one that says `//@end` is its own camera or light: where the model has one, Still_Camera and Still_Light
// (still_stage.h) stand in its place, with the arguments behind the mark.
// Throws InputError where there is no such template.
std::vector<OutputFile> povray_files(const Model& model);

// The same for one of many frames, in two parts: what changes from frame to frame, first NAME.pov, and what does not, which
// NAME.pov includes all the same. The things of the model that `is_shared` says, by their number (panes first), do not change:
// what was made of them is not looked at for the first part. Pictures of the environment do not change, unless they are out of
// focus.
using IsShared = std::function<bool(std::size_t thing)>;
std::vector<OutputFile> frame_files(const Model& model, const IsShared& is_shared);
std::vector<OutputFile> shared_files(const Model& model, const IsShared& is_shared);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{
    .name = "povray",
    .sentence = "a still for POV-Ray (SCENE.pov), with an include file of each pane and pavement and all that they need"};

// The names that `model.setting` may have, sorted.
std::vector<std::string> settings();

}  // namespace shatterpave::exporting::povray
