// What is asked of a shot before any of its frames is made.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/shot.h"

namespace shatterpave::pipeline {

// A sum of all that a shot's frames follow from but for its range, of this version of the program: who adds frames at its end
// has the same shot. `still` must have frames.
std::string shot_state(const scene::Scene& still);

// Those of the frames that lie in the shot's range. Throws InputError, at `place`, where the scene has no [frames], or none of
// them does.
std::vector<int> frames_within(const scene::Scene& still, const std::vector<int>& frames, const Place& place);

// Throws InputError for what any of the frames would be refused for, as far as that can be told without making anything.
void require_frames(scene::Shot& shot, std::span<const int> frames);

}  // namespace shatterpave::pipeline
